"""LIGGGHTS (Debian package `liggghts`): input decks and runs."""

import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

from parameters import (GRAINS, GRAVITY, MATERIALS, POISSON, TIME_STEP, WALL, YOUNG, contact)
from particles import COLUMNS
from scenes import Mesh, Plane, Scene, Tube

MODEL = "model hertz tangential history rolling_friction epsd2"
WALL_TYPE = MATERIALS.index(WALL) + 1


class Settings(NamedTuple):
    skin: float  # [m] of the neighbour lists
    layouts: dict  # ranks: "x y z" of the processor grid


def _matrix(name: str, field: str) -> str:
    values = " ".join(str(getattr(contact(a, b), field)) for a in MATERIALS for b in MATERIALS)
    return f"fix {name} all property/global {name} peratomtypepair {len(MATERIALS)} {values}\n"


def _wall(name: str, wall) -> str:
    gran = f"fix {name} all wall/gran {MODEL}"
    if isinstance(wall, Plane):
        return f"{gran} primitive type {WALL_TYPE} {'xyz'[wall.axis]}plane {wall.at!r}\n"
    if isinstance(wall, Tube):
        return f"{gran} primitive type {WALL_TYPE} zcylinder {wall.radius!r} 0. 0.\n"
    assert isinstance(wall, Mesh)
    return (f"fix {name}_mesh all mesh/surface file {name}.stl type {WALL_TYPE}\n"
            f"{gran} mesh n_meshes 1 meshes {name}_mesh\n")


def opening(scene: Scene, data: str, settings: Settings, ranks: int) -> str:
    """All of a deck but its runs."""
    per_type = " ".join(["{}"] * len(MATERIALS))
    young = per_type.format(*[YOUNG] * len(MATERIALS))
    poisson = per_type.format(*[POISSON] * len(MATERIALS))
    return (
        "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
        "communicate single vel yes\nunits si\n"
        f"processors {settings.layouts[ranks]}\n"
        f"read_data {data}\n"
        f"neighbor {settings.skin!r} bin\nneigh_modify delay 0\n"
        f"fix youngsModulus all property/global youngsModulus peratomtype {young}\n"
        f"fix poissonsRatio all property/global poissonsRatio peratomtype {poisson}\n"
        + _matrix("coefficientRestitution", "restitution")
        + _matrix("coefficientFriction", "friction")
        + _matrix("coefficientRollingFriction", "rolling_friction")
        + f"pair_style gran {MODEL}\npair_coeff * *\ntimestep {TIME_STEP!r}\n"
        + weight(1)
        + "".join(_wall(name, wall) for name, wall in scene.walls.items())
        + "fix motion all nve/sphere\nthermo_style custom step atoms ke\nthermo 1000000\n"
        "thermo_modify lost error norm no\n")


def weight(times: float) -> str:
    """Gravity, so many times as strong as on Earth."""
    return f"fix weight all gravity {times * GRAVITY!r} vector 0 0 -1\n"


def drag(relaxation: float) -> str:
    """Drag that slows every grain down with that time constant [s]."""
    scales = " ".join(f"scale {k} {g.mass / GRAINS[0].mass!r}" for k, g in enumerate(GRAINS, 1))
    return f"fix drag all viscous {GRAINS[0].mass / relaxation!r} {scales}\n"


def dump_now(file: str) -> str:
    formats = " ".join(["%d %d"] + ["%.17g"] * (len(COLUMNS) - 2))
    return (f"dump last all custom 1 {file} {' '.join(COLUMNS)}\n"
            f'dump_modify last sort id format "{formats}"\nrun 0\nundump last\n')


def version() -> str:
    asked = ["liggghts", "-log", "none", "-h"]
    shown = subprocess.run(asked, capture_output=True, text=True, check=False).stdout
    found = re.search(r"Version LIGGGHTS-\w+ ([\d.]+)", shown)
    return f"LIGGGHTS {found[1]}" if found else "LIGGGHTS"


def missing() -> list[str]:
    """Debian packages that are not there."""
    return [p for p, program in (("liggghts", "liggghts"), ("openmpi-bin", "mpirun"))
            if shutil.which(program) is None]


def run(folder: Path, deck: str, ranks: int) -> list[float]:
    """Runs a deck in its folder; seconds of each run's loop, without set-up and files."""
    (folder / "in.liggghts").write_text(deck)
    program = ["liggghts", "-in", "in.liggghts"]  # "-screen none" crashes with meshes
    if ranks > 1:
        program = ["mpirun", "-n", str(ranks)] + program
    as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    done = subprocess.run(program, cwd=folder, env={**os.environ, **as_root}, capture_output=True,
                          text=True, check=False)
    log = (folder / "log.liggghts").read_text()
    if done.returncode != 0 or "ERROR" in log:
        raise RuntimeError(f"LIGGGHTS failed in {folder}:\n{log[-1500:]}{done.stderr[-500:]}")
    return [float(seconds) for seconds in re.findall(r"Loop time of (\S+) on", log)]
