"""Scenario by size: the same particles, walls, parameters and steps for both codes, as files."""

import hashlib
from pathlib import Path
from typing import Callable, NamedTuple

import liggghts
import pmr
from parameters import length_scale
from particles import Particle, read_dump, write_data, write_dump
from scenes import Mesh, Scene, chute, cylinder, loose_column, sliding_layer

SIZES = (3862, 19313, 193132)
CHAMBER_RADIUS = 0.05  # [m] at full size
FALL_SPEED = 1.5  # [m/s] of a column that lands
SEED = 1


class Scenario(NamedTuple):
    title: str
    steps: dict  # of a timed run, by number of particles
    settings: liggghts.Settings
    scene: Callable  # of a number of particles
    particles: Callable  # of a number of particles and a folder to work in: where they start


class Inputs(NamedTuple):
    """Files of a scenario at a size."""

    folder: Path
    scenario: str
    particles: int
    steps: int

    @property
    def dump(self) -> Path:
        return self.folder / "particles.dump"

    @property
    def case(self) -> Path:
        return self.folder / "case.toml"

    def deck(self, ranks: int) -> str:
        """For LIGGGHTS, to be run in the folder."""
        scenario = SCENARIOS[self.scenario]
        return (liggghts.opening(scenario.scene(self.particles), "data", scenario.settings, ranks)
                + f"run {self.steps}\n")


def vessel(particles: int) -> Scene:
    return cylinder(particles, CHAMBER_RADIUS * length_scale(particles))


def falling(particles: int, _folder: Path) -> list[Particle]:
    return loose_column(particles, CHAMBER_RADIUS * length_scale(particles), FALL_SPEED, SEED)


def settled(particles: int, folder: Path) -> list[Particle]:
    """At rest, by LIGGGHTS on one rank.

    To be quick and not to splash, the column falls through thick air at ten times the weight,
    1 m/s; then it rests at its own weight, and the air is taken away last.
    """
    scene = vessel(particles)
    radius = CHAMBER_RADIUS * length_scale(particles)
    write_particles(folder, scene, loose_column(particles, radius, 1.0, SEED))
    landing = 700 + round(5000 * length_scale(particles))  # [steps]
    deck = (liggghts.opening(scene, "data", SCENARIOS["falling"].settings, 1)
            + "unfix weight\n" + liggghts.weight(10) + liggghts.drag(0.01) + f"run {landing}\n"
            + "unfix weight\n" + liggghts.weight(1) + "run 1500\nunfix drag\nrun 1500\n"
            + liggghts.dump_now("rest.dump"))
    liggghts.run(folder, deck, 1)
    return read_dump(folder / "rest.dump")


def sliding(particles: int, _folder: Path) -> list[Particle]:
    return sliding_layer(particles, SEED)


# Skins: the fastest of those tried at 19,313 particles (docs/benchmarks.md).
SCENARIOS = {
    "settled": Scenario("settled bed in a cylinder", {3862: 10000, 19313: 3000, 193132: 600},
                        liggghts.Settings(2.0e-4, {1: "1 1 1", 2: "2 1 1"}), vessel, settled),
    "falling": Scenario("falling and settling", {3862: 4000, 19313: 2500, 193132: 1500},
                        liggghts.Settings(7.0e-4, {1: "1 1 1", 2: "2 1 1"}), vessel, falling),
    "chute": Scenario("flow over an STL ramp", {3862: 8000, 19313: 2500, 193132: 1000},
                      liggghts.Settings(7.0e-4, {1: "1 1 1", 2: "1 2 1"}), chute, sliding),
}


def write_particles(folder: Path, scene: Scene, particles: list[Particle]) -> None:
    """For both codes."""
    write_data(folder / "data", particles, scene.box)
    write_dump(folder / "particles.dump", particles, scene.box)


def write_walls(folder: Path, scene: Scene) -> None:
    for name, wall in scene.walls.items():
        if isinstance(wall, Mesh):
            wall.write(folder / f"{name}.stl")


def _sources() -> str:
    """Digest of what makes particles; another one means other folders."""
    here = Path(__file__).resolve().parent
    names = ("parameters", "packing", "scenes")
    text = "".join((here / f"{name}.py").read_text() for name in names)
    return hashlib.sha256(text.encode()).hexdigest()[:8]


def prepare(work: Path, name: str, particles: int) -> Inputs:
    """Writes all files; particles that are there from an earlier time are kept."""
    scenario = SCENARIOS[name]
    inputs = Inputs(work / _sources() / f"{name}-{particles}", name, particles,
                    scenario.steps[particles])
    inputs.folder.mkdir(parents=True, exist_ok=True)
    scene = scenario.scene(particles)
    write_walls(inputs.folder, scene)
    inputs.case.write_text(pmr.case_text(f"{scenario.title}, {particles} particles", scene,
                                         inputs.steps))
    ready = inputs.folder / "ready"
    if not ready.exists():
        write_particles(inputs.folder, scene, scenario.particles(particles, inputs.folder))
        ready.touch()
    return inputs
