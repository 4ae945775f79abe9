"""Loose random packings without overlaps: random sequential addition, the largest grains first."""

import math
import random
from typing import NamedTuple, Protocol

Point = tuple[float, float, float]


class Region(Protocol):
    volume: float  # [m3]

    def sample(self, rng: random.Random, radius: float) -> Point:
        """A random place of a centre, so that a sphere of that radius [m] lies inside."""


class Cylinder(NamedTuple):
    """Upright, its base round the origin."""

    radius: float  # [m]
    base: float  # [m] its z
    height: float  # [m]
    tilt: float = 0.0  # [1] of the probability density: 1 + tilt (2 h/height - 1) at height h

    @property
    def volume(self) -> float:
        return math.pi * self.radius**2 * self.height

    def sample(self, rng: random.Random, radius: float) -> Point:
        reach = self.radius - radius
        while True:
            x, y = rng.uniform(-reach, reach), rng.uniform(-reach, reach)
            if x * x + y * y <= reach * reach:
                break
        while True:
            h = rng.random()
            if rng.random() * (1 + abs(self.tilt)) <= 1 + self.tilt * (2 * h - 1):
                break
        return x, y, self.base + radius + h * (self.height - 2 * radius)


class Box(NamedTuple):
    low: Point  # [m]
    high: Point  # [m]

    @property
    def volume(self) -> float:
        return math.prod(b - a for a, b in zip(self.low, self.high))

    def sample(self, rng: random.Random, radius: float) -> Point:
        return tuple(rng.uniform(a + radius, b - radius) for a, b in zip(self.low, self.high))


_ROW = 1 << 20  # cells in a row at most


class _Cells:
    """Centres of spheres of one size, in cubes of an edge that no sought distance exceeds."""

    def __init__(self, edge: float):
        self.edge = edge
        self.cells: dict[int, list[Point]] = {}
        near = (0, -1, 1)
        self.around = [(a * _ROW + b) * _ROW + c for a in near for b in near for c in near]

    def cell(self, p: Point) -> int:
        x, y, z = p
        return int((x // self.edge * _ROW + y // self.edge) * _ROW + z // self.edge)

    def add(self, p: Point) -> None:
        self.cells.setdefault(self.cell(p), []).append(p)

    def is_free(self, p: Point, distance: float) -> bool:
        x, y, z = p
        cell, found = self.cell(p), self.cells.get
        squared = distance * distance
        for step in self.around:
            for u, v, w in found(cell + step, ()):
                if (x - u) * (x - u) + (y - v) * (y - v) + (z - w) * (z - w) < squared:
                    return False
        return True


def pack(regions: list[Region], radii, counts, seed: int) -> list[list[Point]]:
    """Centres [m] of counts[k] spheres of radii[k] [m] in regions[k], for each k; largest first."""
    rng = random.Random(seed)
    placed: list[tuple[float, _Cells]] = []
    centres = []
    for region, radius, count in zip(regions, radii, counts):
        placed.append((radius, _Cells(2 * radius)))
        mine = []
        tries = 0
        while len(mine) < count:
            tries += 1
            if tries > 2000 * (count + 1):
                raise ValueError(f"{count} spheres of {radius} m do not fit by random addition")
            p = region.sample(rng, radius)
            if all(cells.is_free(p, radius + other) for other, cells in placed):
                placed[-1][1].add(p)
                mine.append(p)
        centres.append(mine)
    return centres
