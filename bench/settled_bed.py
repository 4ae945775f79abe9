#!/usr/bin/env python3
"""A bed in a 10 cm cylinder, settled by pmr and by LIGGGHTS from the same initial states.

Three seeds; height, solid fraction, coordination number and mass ratio per layer of both beds come
from one script. Their mean difference is held against the scatter over the seeds.
"""

import csv
import datetime
import math
import statistics
import sys
from pathlib import Path

import arguments
import bed_figures
import liggghts
import machine
import pmr
from particles import read_dump, write_data, write_dump
from scenes import cylinder, loose_column

RADIUS = 0.05  # [m]
SPEED = 1.0  # [m/s] of the loose column
TILT = 0.5  # [1] of the beads towards the top, so that the layers differ
STEPS = 20000  # 0.4 s
REST = 0.002  # [m/s] rms speed at most
SIGNIFICANT = 2.0  # standard errors of a difference of means
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


CODES = {"pmr": settle_by_pmr, "liggghts": settle_by_liggghts}


def prepare(folder: Path, particles: int, seed: int) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    scene = cylinder(particles, RADIUS)
    loose = loose_column(particles, RADIUS, SPEED, seed, TILT)
    write_data(folder / "data", loose, scene.box)
    write_dump(folder / "particles.dump", loose, scene.box)
    (folder / "case.toml").write_text(pmr.case_text(f"bed of seed {seed}", scene, STEPS))


def measure(code: str, seed: int, folder: Path, options) -> dict:
    bed, state_hash = CODES[code](folder, options)
    if len(bed) != options.particles:
        raise RuntimeError(f"{code}, seed {seed}: {len(bed)} particles, wanted {options.particles}")
    found = bed_figures.measure(bed, RADIUS)
    if found.rms_speed > REST:
        raise RuntimeError(f"{code}, seed {seed}: rms speed {found.rms_speed} m/s, not at rest")
    values = [found.height, found.solid_fraction, found.coordination_number, *found.mass_ratio]
    now = datetime.datetime.now(datetime.timezone.utc)
    return {"date": now.strftime("%Y-%m-%dT%H:%M:%SZ"), "machine": machine.processor(),
            "version": pmr.version() if code == "pmr" else liggghts.version(),
            "particles": options.particles, "steps": STEPS, "seed": seed, "code": code,
            "state_hash": state_hash, **{n: f"{v:.7g}" for n, v in zip(FIGURES, values)},
            "rms_speed": f"{found.rms_speed:.3g}"}


def is_within_scatter(rows: list[dict]) -> bool:
    """Prints the comparison; a difference of means counts beyond two standard errors."""
    print(f"{'figure':22}{'pmr':>10}{'LIGGGHTS':>10}{'difference':>12}{'scatter':>10}{'errors':>8}")
    agree = True
    for name in FIGURES:
        ours, theirs = ([float(r[name]) for r in rows if r["code"] == code] for code in CODES)
        difference = statistics.mean(ours) - statistics.mean(theirs)
        scatter = math.sqrt((statistics.variance(ours) + statistics.variance(theirs)) / 2)
        errors = abs(difference) / (scatter * math.sqrt(2 / len(ours)))
        agree = agree and errors <= SIGNIFICANT
        print(f"{name:22}{statistics.mean(ours):10.5g}{statistics.mean(theirs):10.5g}"
              f"{difference:12.3g}{scatter:10.3g}{errors:8.2f}")
    return agree
