"""Places of the benchmarks: particles at their start, walls of both codes. SI units."""

import math
from dataclasses import dataclass
from pathlib import Path

from packing import Box, Cylinder, pack
from parameters import RADII, counts, length_scale
from particles import Particle

LOOSE = 0.35  # [1] solid fraction of the random packings
HEADROOM = 0.3  # [m] above the packing for what bounces
CLEARANCE = 1.0e-5  # [m] between walls and the grains of a loose packing


@dataclass(frozen=True)
class Plane:
    """x, y or z = at, infinite; grains are on the side of `sign` (1 or -1)."""

    axis: int  # 0, 1, 2: x, y, z
    at: float  # [m]
    sign: int


@dataclass(frozen=True)
class Tube:
    """Upright cylinder round the z axis; grains are inside."""

    radius: float  # [m]


@dataclass(frozen=True)
class Mesh:
    """Triangles of an ASCII STL file in metres."""

    triangles: tuple

    def write(self, path: Path) -> None:
        with path.open("w") as out:
            out.write("solid mesh\n")
            for triangle in self.triangles:
                out.write("facet normal 0 0 0\nouter loop\n")
                out.writelines(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in triangle)
                out.write("endloop\nendfacet\n")
            out.write("endsolid mesh\n")


@dataclass(frozen=True)
class Scene:
    box: tuple  # ((low, high) of x, y, z) [m]; no grain may leave it
    walls: dict  # by name


def grains(centres, velocity) -> list[Particle]:
    return [Particle(type, RADII[type - 1], place, velocity)
            for type, places in enumerate(centres, 1) for place in places]


def solid_volume(number) -> float:
    """[m3]"""
    return sum(n * 4 / 3 * math.pi * r**3 for n, r in zip(number, RADII))


def loose_height(particles: int, radius: float) -> float:
    """[m] of a loose column of them in a cylinder."""
    return solid_volume(counts(particles)) / LOOSE / (math.pi * (radius - CLEARANCE)**2)


def cylinder(particles: int, radius: float) -> Scene:
    """A cylinder high enough for their loose column."""
    reach = 1.1 * radius
    return Scene(((-reach, reach), (-reach, reach),
                  (-0.1 * radius, loose_height(particles, radius) + HEADROOM)),
                 {"floor": Plane(2, 0.0, 1), "side": Tube(radius)})


def loose_column(particles: int, radius: float, speed: float, seed: int,
                 tilt: float = 0.0) -> list[Particle]:
    """A loose column just above the floor of a cylinder, falling with one speed [m/s].

    tilt: of the beads towards the top (packing.Cylinder).
    """
    height = loose_height(particles, radius)
    regions = [Cylinder(radius - CLEARANCE, CLEARANCE, height, t) for t in (tilt, 0.0)]
    centres = pack(regions, RADII, counts(particles), seed)
    return grains(centres, (0.0, 0.0, -speed))


RAMP_ANGLE = math.radians(43)
LIP_ANGLES = tuple(math.radians(a) for a in (33, 23, 13))  # of three plates below the ramp
PLATE = 0.04  # [m] edge of the plates that the mesh is made of, at full size
RAMP_PLATES = 12  # plates along the straight ramp, the lip's come below
WIDTH_PLATES = 4
LIP_HEIGHT = 0.08  # [m] of the lip above the floor, at full size
START_SPEED = 1.0  # [m/s] down the ramp


def chute_profile(scale: float) -> list[tuple[float, float]]:
    """(x, z) of the mesh's edges from the lip to the ramp's top [m]."""
    points = [(0.0, LIP_HEIGHT * scale)]
    for angle in LIP_ANGLES[::-1] + (RAMP_ANGLE,) * RAMP_PLATES:
        x, z = points[-1]
        points.append((x + PLATE * scale * math.cos(angle), z + PLATE * scale * math.sin(angle)))
    return points


def chute_mesh(scale: float) -> Mesh:
    profile = chute_profile(scale)
    edge = PLATE * scale
    ys = [(k - WIDTH_PLATES / 2) * edge for k in range(WIDTH_PLATES + 1)]
    triangles = []
    for (xa, za), (xb, zb) in zip(profile, profile[1:]):
        for ya, yb in zip(ys, ys[1:]):
            a, b, c, d = (xa, ya, za), (xb, ya, zb), (xb, yb, zb), (xa, yb, za)
            triangles += [(a, b, c), (a, c, d)]
    return Mesh(tuple(triangles))


def layer_on_chute(particles: int) -> Box:
    """A loose layer of them on the straight ramp: along it from its foot, across, off it [m]."""
    scale = length_scale(particles)
    length = RAMP_PLATES * PLATE * scale
    half = WIDTH_PLATES / 2 * PLATE * scale - CLEARANCE
    thickness = solid_volume(counts(particles)) / LOOSE / (2 * half * length)
    return Box((0.0, -half, CLEARANCE), (length, half, CLEARANCE + thickness))


def chute(particles: int) -> Scene:
    """A ramp (STL) with a bent lip above a box."""
    scale = length_scale(particles)
    half = WIDTH_PLATES / 2 * PLATE * scale
    low, margin = -0.25 * scale, 0.02 * scale
    back, ramp_top = chute_profile(scale)[-1]
    top = ramp_top + layer_on_chute(particles).high[2] + HEADROOM
    return Scene(((low - margin, back + margin), (-half - margin, half + margin), (-margin, top)),
                 {"floor": Plane(2, 0.0, 1), "left": Plane(1, -half, 1),
                  "right": Plane(1, half, -1), "front": Plane(0, low, 1),
                  "back": Plane(0, back, -1), "chute": chute_mesh(scale)})


def sliding_layer(particles: int, seed: int) -> list[Particle]:
    """The loose layer on the chute, moving down the ramp."""
    layer = layer_on_chute(particles)
    foot_x, foot_z = chute_profile(length_scale(particles))[len(LIP_ANGLES)]
    cos, sin = math.cos(RAMP_ANGLE), math.sin(RAMP_ANGLE)
    centres = [[(foot_x + u * cos - n * sin, y, foot_z + u * sin + n * cos) for u, y, n in group]
               for group in pack([layer, layer], RADII, counts(particles), seed)]
    return grains(centres, (-START_SPEED * cos, 0.0, -START_SPEED * sin))
