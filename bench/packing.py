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


class _Cells:
    """Centres of spheres of one size, in cubes of an edge that no sought distance exceeds."""

    def __init__(self, edge: float):
        self.edge = edge
        self.cells: dict[tuple[int, int, int], list[Point]] = {}

    def cell(self, p: Point) -> tuple[int, int, int]:
        return int(p[0] // self.edge), int(p[1] // self.edge), int(p[2] // self.edge)

    def add(self, p: Point) -> None:
        self.cells.setdefault(self.cell(p), []).append(p)

    def is_free(self, p: Point, distance: float) -> bool:
        x, y, z = p
        i, j, k = self.cell(p)
        squared = distance * distance
        for a in (i, i - 1, i + 1):
            for b in (j, j - 1, j + 1):
                for c in (k, k - 1, k + 1):
                    for q in self.cells.get((a, b, c), ()):
                        if (x - q[0])**2 + (y - q[1])**2 + (z - q[2])**2 < squared:
                            return False
        return True


def pack(regions: list[Region], radii: list[float], counts: list[int], seed: int) -> list[list[Point]]:
    """Centres [m] of counts[k] spheres of radii[k] in regions[k], for each k; largest radius first."""
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
