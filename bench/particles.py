"""Particles and their files: LAMMPS text dumps, data files of LIGGGHTS. SI units."""

import math
from pathlib import Path
from typing import NamedTuple

from parameters import GRAINS

COLUMNS = "id type radius x y z vx vy vz omegax omegay omegaz".split()


class Particle(NamedTuple):
    type: int  # 1, 2: GRAINS[type - 1]
    radius: float  # [m]
    position: tuple[float, float, float]  # [m]
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)  # [m/s]
    spin: tuple[float, float, float] = (0.0, 0.0, 0.0)  # [rad/s]

    @property
    def mass(self) -> float:
        """[kg]"""
        return GRAINS[self.type - 1].density * 4 / 3 * math.pi * self.radius**3


def _triple(values) -> str:
    return " ".join(repr(v) for v in values)


def write_dump(path: Path, particles: list[Particle], box) -> None:
    """box: ((low, high) for x, y, z) [m]; ids count from 1."""
    with path.open("w") as out:
        out.write(f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{len(particles)}\n")
        out.write("ITEM: BOX BOUNDS ff ff ff\n")
        out.writelines(f"{low!r} {high!r}\n" for low, high in box)
        out.write("ITEM: ATOMS " + " ".join(COLUMNS) + "\n")
        for k, p in enumerate(particles, 1):
            out.write(f"{k} {p.type} {p.radius!r} {_triple(p.position)} {_triple(p.velocity)} "
                      f"{_triple(p.spin)}\n")


def read_dump(path: Path) -> list[Particle]:
    """The last frame, by id."""
    lines = path.read_text().splitlines()
    last = max(k for k, line in enumerate(lines) if line.startswith("ITEM: ATOMS"))
    names = lines[last].split()[2:]
    place = [names.index(name) for name in COLUMNS]
    rows = []
    for line in lines[last + 1:]:
        fields = line.split()
        number = [float(fields[k]) for k in place]
        rows.append((int(number[0]), Particle(int(number[1]), number[2], tuple(number[3:6]),
                                              tuple(number[6:9]), tuple(number[9:12]))))
    return [particle for _, particle in sorted(rows)]


def write_data(path: Path, particles: list[Particle], box) -> None:
    """The same particles for read_data of LIGGGHTS, atom style granular."""
    with path.open("w") as out:
        out.write(f"grains\n\n{len(particles)} atoms\n{len(GRAINS) + 1} atom types\n\n")
        for (low, high), axis in zip(box, "xyz"):
            out.write(f"{low!r} {high!r} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for k, p in enumerate(particles, 1):
            density = GRAINS[p.type - 1].density
            out.write(f"{k} {p.type} {2 * p.radius!r} {density!r} {_triple(p.position)}\n")
        out.write("\nVelocities\n\n")
        for k, p in enumerate(particles, 1):
            out.write(f"{k} {_triple(p.velocity)} {_triple(p.spin)}\n")
