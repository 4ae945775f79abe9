"""Figures of a settled bed on the floor z = 0 of an upright cylinder. SI units."""

import math
from typing import NamedTuple

from parameters import RADII
from particles import Particle

HEIGHT_SHARE = 0.99  # [1] of the mass whose tops lie below the bed's height
LAYERS = 5  # of equal mass


class Bed(NamedTuple):
    height: float  # [m]
    solid_fraction: float  # [1]
    coordination_number: float  # [1]
    mass_ratio: tuple  # [1] beads to granules, layer by layer, the top one first
    rms_speed: float  # [m/s] of centres


def height(bed: list[Particle]) -> float:
    """[m] that the tops of 99 % of the mass do not pass."""
    below, total = 0.0, sum(p.mass for p in bed)
    for top, mass in sorted((p.position[2] + p.radius, p.mass) for p in bed):
        below += mass
        if below >= HEIGHT_SHARE * total:
            return top
    raise ValueError("an empty bed")


def _volume_below(p: Particle, z: float) -> float:
    """[m3] of the sphere below the plane: pi (2 r^3/3 + r^2 h - h^3/3), h = z - centre."""
    r = p.radius
    h = max(-r, min(r, z - p.position[2]))
    return math.pi * (2 / 3 * r**3 + r * r * h - h**3 / 3)


def solid_fraction(bed: list[Particle], radius: float) -> float:
    """Between one bead above the floor and 90 % of the height, one bead below it at most."""
    top, bead = height(bed), 2 * max(RADII)
    low, high = bead, min(0.9 * top, top - bead)
    solid = sum(_volume_below(p, high) - _volume_below(p, low) for p in bed)
    return solid / (math.pi * radius**2 * (high - low))


def contacts(bed: list[Particle]) -> int:
    """Pairs whose centres are nearer than the sum of their radii."""
    edge = 2 * max(RADII)
    cells: dict[tuple, list[Particle]] = {}
    for p in bed:
        cells.setdefault(tuple(int(x // edge) for x in p.position), []).append(p)
    near = (-1, 0, 1)
    ahead = [(a, b, c) for a in near for b in near for c in near if (a, b, c) > (0, 0, 0)]
    found = 0
    for (i, j, k), mine in cells.items():
        found += sum(_touch(p, q) for n, p in enumerate(mine) for q in mine[:n])
        others = [q for a, b, c in ahead for q in cells.get((i + a, j + b, k + c), ())]
        found += sum(_touch(p, q) for p in mine for q in others)
    return found


def _touch(p: Particle, q: Particle) -> bool:
    (x, y, z), (u, v, w) = p.position, q.position
    return (x - u)**2 + (y - v)**2 + (z - w)**2 < (p.radius + q.radius)**2


def mass_ratios(bed: list[Particle]) -> tuple:
    """Of layers of equal mass, from the top, by the places of centres."""
    share = sum(p.mass for p in bed) / LAYERS
    by_type = [[0.0] * len(RADII) for _ in range(LAYERS)]
    above = 0.0
    for p in sorted(bed, key=lambda p: -p.position[2]):
        by_type[min(LAYERS - 1, int(above / share))][p.type - 1] += p.mass
        above += p.mass
    return tuple(beads / granules for beads, granules in by_type)


def rms_speed(bed: list[Particle]) -> float:
    energy = sum(p.mass * sum(v * v for v in p.velocity) for p in bed)
    return math.sqrt(energy / sum(p.mass for p in bed))


def measure(bed: list[Particle], radius: float) -> Bed:
    return Bed(height(bed), solid_fraction(bed, radius), 2 * contacts(bed) / len(bed),
               mass_ratios(bed), rms_speed(bed))
