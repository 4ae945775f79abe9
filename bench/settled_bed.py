#!/usr/bin/env python3
"""A bed in a 10 cm cylinder, settled by pmr and by LIGGGHTS from the same initial states.

Three seeds; height, solid fraction, coordination number and mass ratio per layer of both beds come
from one script. Their mean difference is held against the scatter over the seeds.
"""

import math
import statistics
import sys
from pathlib import Path
from typing import Callable, NamedTuple

import arguments
import bed_figures
import liggghts
import machine
import pmr
import table
from particles import read_dump
from scenarios import write_particles
from scenes import cylinder, loose_column

RADIUS = 0.05  # [m]
SPEED = 1.0  # [m/s] of the loose column
TILT = 0.5  # [1] of the beads towards the top, so that the layers differ
SEEDS = (1, 2, 3)
STEPS = 12500  # 0.25 s
REST = 0.002  # [m/s] rms speed at most
# Standard errors of a difference of means: Student's t at 1 %, two-sided, 4 degrees of freedom of
# 3 + 3 beds; eight figures are looked at together.
SIGNIFICANT = 4.604
SKIN = 4.0e-4  # [m]
FIGURES = (["height", "solid_fraction", "coordination_number"]
           + [f"mass_ratio_{k}" for k in range(1, bed_figures.LAYERS + 1)])
RESULTS = Path(__file__).resolve().parent / "results" / "settled_bed.csv"


def settle_by_pmr(folder: Path, options) -> tuple[list, str]:
    run = pmr.run(folder / "case.toml", folder / "particles.dump", options.cores, folder / "run")
    return pmr.final_particles(run.folder), run.state_hash


def settle_by_liggghts(folder: Path, options) -> tuple[list, str]:
    layouts = {1: "1 1 1", 2: "2 1 1"}
    deck = (liggghts.opening(cylinder(options.particles, RADIUS), "data",
                             liggghts.Settings(SKIN, layouts), options.cores)
            + f"run {STEPS}\n" + liggghts.dump_now("rest.dump"))
    liggghts.run(folder, deck, options.cores)
    return read_dump(folder / "rest.dump"), ""


class Code(NamedTuple):
    settle: Callable  # particles at rest and hash of their state
    version: Callable


CODES = {"pmr": Code(settle_by_pmr, pmr.version),
         "liggghts": Code(settle_by_liggghts, liggghts.version)}


def prepare(folder: Path, particles: int, seed: int) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    scene = cylinder(particles, RADIUS)
    write_particles(folder, scene, loose_column(particles, RADIUS, SPEED, seed, TILT))
    (folder / "case.toml").write_text(pmr.case_text(f"bed of seed {seed}", scene, STEPS))


def measure(code: str, seed: int, folder: Path, options) -> dict:
    bed, state_hash = CODES[code].settle(folder, options)
    if len(bed) != options.particles:
        raise RuntimeError(f"{code}, seed {seed}: {len(bed)} particles, wanted {options.particles}")
    found = bed_figures.measure(bed, RADIUS)
    if found.rms_speed > REST:
        raise RuntimeError(f"{code}, seed {seed}: rms speed {found.rms_speed} m/s, not at rest")
    values = [found.height, found.solid_fraction, found.coordination_number, *found.mass_ratio]
    return {"date": machine.now(), "machine": machine.processor(),
            "version": CODES[code].version(), "particles": options.particles,
            "steps": STEPS, "seed": seed, "code": code, "state_hash": state_hash,
            **{n: f"{v:.7g}" for n, v in zip(FIGURES, values)},
            "rms_speed": f"{found.rms_speed:.3g}"}


class Comparison(NamedTuple):
    figure: str
    pmr: float  # means over seeds
    liggghts: float
    scatter: float  # standard deviation over seeds, of both codes together

    def standard_errors(self) -> float:
        """Difference of the means in units of its standard error."""
        return abs(self.pmr - self.liggghts) / (self.scatter * math.sqrt(2 / len(SEEDS)))

    def is_within_scatter(self) -> bool:
        return self.standard_errors() <= SIGNIFICANT


def compare(rows: list[dict]) -> list[Comparison]:
    found = []
    for name in FIGURES:
        ours, theirs = ([float(r[name]) for r in rows if r["code"] == code] for code in CODES)
        scatter = math.sqrt((statistics.variance(ours) + statistics.variance(theirs)) / 2)
        found.append(Comparison(name, statistics.mean(ours), statistics.mean(theirs), scatter))
    return found


def show(comparisons: list[Comparison]) -> None:
    print(f"{'figure':22}{'pmr':>10}{'LIGGGHTS':>10}{'difference':>12}{'scatter':>10}{'t':>7}")
    for c in comparisons:
        print(f"{c.figure:22}{c.pmr:10.5g}{c.liggghts:10.5g}{c.pmr - c.liggghts:12.3g}"
              f"{c.scatter:10.3g}{c.standard_errors():7.2f}")


def main() -> int:
    parser = arguments.parser(__doc__)
    parser.add_argument("--particles", type=int, default=38626, help="[%(default)s]")
    parser.add_argument("--cores", type=int, choices=(1, 2), default=2, help="[%(default)s]")
    parser.add_argument("--output", type=Path, default=RESULTS, help="CSV [%(default)s]")
    options = parser.parse_args()
    arguments.require(pmr.missing() + liggghts.missing())
    versions = [code.version() for code in CODES.values()]
    rows = [row for row in table.read_current(options.output, versions, machine.processor())
            if row["particles"] == str(options.particles) and row["steps"] == str(STEPS)]
    done = {(row["code"], row["seed"]) for row in rows}
    for seed in SEEDS:
        folder = options.work / f"bed-{options.particles}-{seed}"
        prepare(folder, options.particles, seed)
        for code in CODES:
            if (code, str(seed)) not in done:
                rows.append(measure(code, seed, folder, options))
                table.write(options.output, rows)
                print(*rows[-1].values(), flush=True)
    comparisons = compare(rows)
    show(comparisons)
    return 0 if all(c.is_within_scatter() for c in comparisons) else 1


if __name__ == "__main__":
    sys.exit(main())
