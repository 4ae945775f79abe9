"""Parameters of the demonstrator study, the same numbers for both codes. SI units.

Source: Richter, Grobbel, Brendelberger, Roeb, Sattler, Particle mechanics and mixture homogeneity
in a demonstration reactor system for the indirect reduction of redox particles, tables 1, 2, A.4.
"""

import math
from typing import NamedTuple


class Grain(NamedTuple):
    name: str
    diameter: float  # [m] Sauter diameter, used for all grains of the type
    density: float  # [kg/m3]

    @property
    def mass(self) -> float:
        """[kg]"""
        return self.density * math.pi / 6 * self.diameter**3


class Contact(NamedTuple):
    friction: float
    rolling_friction: float
    restitution: float


# In the order of their types in a dump: 1, 2; type 3 is the coated wall.
GRAINS = (Grain("Al2O3", 2.99e-3, 3690.0), Grain("SrFeO3", 1.47e-3, 3460.0))
WALL = "coated-wall"
MATERIALS = tuple(grain.name for grain in GRAINS) + (WALL,)
RADII = tuple(grain.diameter / 2 for grain in GRAINS)

YOUNG = 5.0e6  # [Pa] softened; the contact parameters were calibrated with it
POISSON = 0.3
GRAVITY = 9.80665  # [m/s2]
TIME_STEP = 2.0e-5  # [s] 18.9 % of the critical Rayleigh step

_CONTACTS = {
    ("SrFeO3", "SrFeO3"): Contact(0.28, 0.38, 0.24),
    ("Al2O3", "Al2O3"): Contact(0.31, 0.10, 0.75),
    ("SrFeO3", WALL): Contact(0.39, 0.14, 0.48),
    ("Al2O3", WALL): Contact(0.36, 0.14, 0.50),
    ("Al2O3", "SrFeO3"): Contact(0.30, 0.13, 0.53),
}
# Walls never meet walls; LIGGGHTS wants the entry of its matrix all the same.
_NEVER = Contact(0.5, 0.1, 0.5)

FULL_SIZE = 193132  # grains: 1 kg of each kind
BEAD_SHARE = 19363 / FULL_SIZE  # [1] of the number of grains


def contact(one: str, other: str) -> Contact:
    return _CONTACTS.get((one, other)) or _CONTACTS.get((other, one)) or _NEVER


def pairs():
    """The pairs that can meet, as ((name, name), Contact)."""
    return _CONTACTS.items()


def counts(particles: int) -> tuple[int, int]:
    """Beads and granules among so many grains, in the ratio of 1 kg to 1 kg."""
    beads = round(BEAD_SHARE * particles)
    return beads, particles - beads


def length_scale(particles: int) -> float:
    """[1] of lengths against the full size, so that beds of all sizes have one shape."""
    return (particles / FULL_SIZE) ** (1 / 3)
