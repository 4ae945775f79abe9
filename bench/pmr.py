"""pmr: cases and runs."""

import json
import shutil
import struct
import subprocess
from pathlib import Path
from typing import NamedTuple

from parameters import GRAINS, GRAVITY, POISSON, TIME_STEP, WALL, YOUNG, pairs
from particles import Particle
from scenes import Mesh, Plane, Scene, Tube

ROOT = Path(__file__).resolve().parent.parent
BINARY = ROOT / "build/release/src/cli/pmr"


class Run(NamedTuple):
    folder: Path
    seconds: float  # [s] wall time of the mechanics, without set-up and files
    steps: int
    state_hash: str


def _lengths(values) -> str:
    return '"' + " ".join(repr(v) for v in values) + ' m"'


def _wall(name: str, wall, box) -> str:
    head = f'[walls.{name}]\nmaterial = "{WALL}"\n'
    if isinstance(wall, Plane):
        unit = [wall.sign if axis == wall.axis else 0 for axis in range(3)]
        point = [wall.at if axis == wall.axis else 0.0 for axis in range(3)]
        return f'{head}kind = "plane"\npoint = {_lengths(point)}\nnormal = {unit}\n'
    if isinstance(wall, Tube):
        low, high = box[2]
        return (f'{head}kind = "cylinder"\nbase = {_lengths((0.0, 0.0, low))}\naxis = [0, 0, 1]\n'
                f'radius = "{wall.radius!r} m"\nheight = "{high - low!r} m"\nfacing = "in"\n')
    assert isinstance(wall, Mesh)
    return f'{head}kind = "stl"\nfile = "{name}.stl"\nscale = "1 m"\n'


STATED_DELTA = 0.25  # granules have the density of parameters.py at this delta, and this delta


def _species(grain) -> str:
    delta = f"delta = {STATED_DELTA}\n" if grain.name == "SrFeO3" else ""
    return (f'[species.{grain.name}]\nmaterial = "{grain.name}"\n'
            f'diameter = "{grain.diameter!r} m"\ntemperature = "20 degC"\n{delta}')


def _materials() -> str:
    soft = f'young_soft = "{YOUNG!r} Pa"\npoisson_soft = {POISSON}\n'
    text = f"[materials.{WALL}]\n{soft}"
    for grain in GRAINS:
        text += f'[materials.{grain.name}]\ndensity = "{grain.density!r} kg/m3"\n{soft}'
        if grain.name == "SrFeO3":
            text += f"redox.density_delta = {STATED_DELTA}\n"
    return text


def case_text(title: str, scene: Scene, steps: int) -> str:
    """A case of the mechanics alone: so many steps from the particles given by --bed."""
    duration = steps * TIME_STEP
    contacts = "".join(
        f'[contacts."{a}|{b}"]\nfriction = {c.friction}\nrolling_friction = {c.rolling_friction}\n'
        f"restitution = {c.restitution}\n" for (a, b), c in pairs())
    low, high = zip(*scene.box)
    return (f'title = "{title}"\ngravity = "0 0 {-GRAVITY!r} m/s2"\n'
            f"[domain]\nlow = {_lengths(low)}\nhigh = {_lengths(high)}\n"
            + "".join(_species(grain) for grain in GRAINS)
            + "".join(_wall(name, wall, scene.box) for name, wall in scene.walls.items())
            + _materials() + contacts
            + f'[mix]\nduration = "{duration!r} s"\n'
            f'not_before = "{duration!r} s"\nrest_speed = "1 mm/s"\nrest_hold = "1 ms"\n'
            f'[models.mechanics]\ntime_step = "{TIME_STEP!r} s"\n'
            '[output]\nsnapshot_interval = "1 h"\ncheckpoint_wall_time = "1 h"\n')


def missing() -> list[str]:
    """What is not there: the program, and Debian packages."""
    absent = [] if BINARY.exists() else [f"{BINARY} (make)"]
    return absent + ([] if shutil.which("h5dump") else ["hdf5-tools"])


def version() -> str:
    """The binary's own: 'pmr 0.1.0 (0824482)'."""
    return subprocess.run([BINARY, "--version"], capture_output=True, text=True,
                          check=True).stdout.strip()


def run(case: Path, bed: Path, threads: int, out: Path) -> Run:
    """Runs a case from a dump; raises if a particle is lost."""
    command = [BINARY, "run", case, "--bed", bed, "-o", out, "--threads", str(threads)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"pmr failed: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    summary = json.loads((out / "summary.json").read_text())
    mechanics = summary["mechanics"]
    if mechanics["lost"]:
        raise RuntimeError(f"{out}: pmr lost {mechanics['lost']} particles")
    return Run(out, mechanics["wall"], mechanics["steps"], summary["provenance"]["state_hash"])


def compiler(out: Path) -> str:
    """The one that built the program, as a run tells it."""
    return json.loads((out / "summary.json").read_text())["provenance"]["compiler"]


def _dataset(file: Path, name: str, kind: str, binary: Path) -> list:
    """All numbers of a dataset; kind: their struct letter in the file's own (native) type."""
    subprocess.run(["h5dump", "-d", name, "-b", "NATIVE", "-o", binary, file], check=True,
                   stdout=subprocess.DEVNULL)
    return [value for value, in struct.iter_unpack("=" + kind, binary.read_bytes())]


def final_particles(out: Path) -> list[Particle]:
    """Of the last snapshot of run.h5, by id."""
    file, binary = out / "run.h5", out / "dataset.bin"
    listing = subprocess.run(["h5dump", "-n", file], check=True, capture_output=True, text=True)
    last = max(line.split()[1] for line in listing.stdout.splitlines() if "/snapshots/" in line
               and line.split()[1].count("/") == 2)

    def triples(name, kind):
        flat = _dataset(file, f"{last}/{name}", kind, binary)
        return list(zip(flat[::3], flat[1::3], flat[2::3]))

    columns = [_dataset(file, f"{last}/{name}", kind, binary)
               for name, kind in (("id", "I"), ("species", "B"), ("radius", "d"))]
    columns += [triples("position", "d"), triples("velocity", "f"), triples("spin", "f")]
    binary.unlink()
    by_id = sorted(zip(*columns))
    return [Particle(species + 1, *rest) for _, species, *rest in by_id]
