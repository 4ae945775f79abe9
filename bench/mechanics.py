#!/usr/bin/env python3
"""Speed of pmr and LIGGGHTS on the same particles, walls, parameters and steps.

Alternates between the codes on 1 and 2 cores, three times. Goes on where an interrupted run of the
same pmr on the same machine has stopped.
"""

import os
import statistics
import sys
from pathlib import Path

import arguments
import liggghts
import machine
import pmr
import scenarios
import table

BUSY = 0.5  # load average of a machine that does something else
CODES = ("pmr", "liggghts")
RESULTS = Path(__file__).resolve().parent / "results" / "mechanics.csv"


def measure(code: str, cores: int, inputs: scenarios.Inputs) -> dict:
    """One sample: seconds of the steps alone, and what identifies the result."""
    if code == "pmr":
        out = inputs.folder / "run"
        run = pmr.run(inputs.case, inputs.dump, cores, out)
        if run.steps != inputs.steps:
            raise RuntimeError(f"{out}: {run.steps} steps, wanted {inputs.steps}")
        seconds, name, state_hash = run.seconds, pmr.compiler(out), run.state_hash
    else:
        (seconds,) = liggghts.run(inputs.folder, inputs.deck(cores), cores)
        name, state_hash = "Debian package", ""
    return {"compiler": name, "seconds": f"{seconds:.4f}", "state_hash": state_hash,
            "particle_steps_per_second": f"{inputs.particles * inputs.steps / seconds:.4g}"}


def sample_key(row: dict) -> tuple:
    return tuple(str(row[c]) for c in ("scenario", "particles", "code", "cores", "sample", "steps"))


def wanted_samples(options) -> list[dict]:
    return [{"scenario": name, "particles": particles, "code": code, "cores": cores,
             "sample": sample, "steps": scenarios.SCENARIOS[name].steps[particles]}
            for name, particles in arguments.chosen(options)
            for sample in range(1, options.samples + 1)
            for cores in options.cores for code in CODES]


def speeds_by_code(rows: list[dict]) -> str:
    """Medians, million particle-steps/s, and their ratios."""
    speeds: dict[tuple, list[float]] = {}
    for row in rows:
        key = row["scenario"], int(row["particles"]), int(row["cores"]), row["code"]
        speeds.setdefault(key, []).append(float(row["particle_steps_per_second"]) / 1e6)
    lines = [f"{'scenario':10}{'particles':>10}{'cores':>6}{'pmr':>8}{'LIGGGHTS':>10}{'ratio':>7}"
             "   million particle-steps/s, medians"]
    for name, particles, cores in dict.fromkeys(key[:3] for key in sorted(speeds)):
        medians = [statistics.median(speeds.get((name, particles, cores, code), [float("nan")]))
                   for code in CODES]
        lines.append(f"{name:10}{particles:10}{cores:6}{medians[0]:8.2f}{medians[1]:10.2f}"
                     f"{medians[0] / medians[1]:7.2f}")
    return "\n".join(lines)


def differing_hashes(rows: list[dict]) -> list[tuple]:
    """Scenarios and sizes at which pmr ended in more than one state, whatever its threads."""
    found: dict[tuple, set] = {}
    for row in rows:
        if row["code"] == "pmr":
            found.setdefault((row["scenario"], row["particles"]), set()).add(row["state_hash"])
    return [key for key, hashes in found.items() if len(hashes) > 1]


def parse():
    parser = arguments.parser(__doc__)
    arguments.add_choice(parser)
    parser.add_argument("--samples", type=int, default=3, help="of each [%(default)s]")
    parser.add_argument("--cores", type=arguments.whole_numbers, default=[1, 2], help="[1,2]")
    parser.add_argument("--output", type=Path, default=RESULTS, help="CSV [%(default)s]")
    options = parser.parse_args()
    arguments.check_choice(parser, options)
    arguments.require(pmr.missing() + liggghts.missing())
    return options


def main() -> int:
    options = parse()
    versions = {"pmr": pmr.version(), "liggghts": liggghts.version()}
    processor = machine.processor()
    if os.getloadavg()[0] > BUSY:
        print("the machine is busy: these times will not be worth much", file=sys.stderr)
    rows = table.read_current(options.output, versions.values(), processor)
    done = {sample_key(row) for row in rows}
    for sample in wanted_samples(options):
        if sample_key(sample) in done:
            continue
        inputs = scenarios.prepare(options.work, sample["scenario"], sample["particles"])
        row = {"date": machine.now(), "machine": processor, "version": versions[sample["code"]],
               **sample, **measure(sample["code"], sample["cores"], inputs)}
        rows.append(row)
        table.write(options.output, rows)
        print(*row.values(), flush=True)
    print(speeds_by_code(rows))
    for name, particles in differing_hashes(rows):
        print(f"state hashes of pmr differ: {name}, {particles} particles", file=sys.stderr)
    return 1 if differing_hashes(rows) else 0


if __name__ == "__main__":
    sys.exit(main())
