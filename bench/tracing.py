#!/usr/bin/env python3
"""Speed of the ray tracer in the settled bed of 193,132 spheres, against plain Embree.

Three samples of each number of rays; bench_tracing (C++) measures, this keeps its lines.
"""

import csv
import subprocess
import sys
from pathlib import Path

import arguments
import machine
import pmr
import scenarios
import table

BINARY = pmr.ROOT / "build/release/bench/bench_tracing"
RESULTS = Path(__file__).resolve().parent / "results" / "tracing.csv"
SIZE = 193132


def measure(dump: Path, rays: int) -> dict:
    lines = subprocess.run([BINARY, dump, str(rays)], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    (row,) = csv.DictReader(lines)
    return row


def main() -> int:
    parser = arguments.parser(__doc__)
    parser.add_argument("--rays", type=arguments.whole_numbers, default=[200, 1000],
                        help="per granule [200,1000]")
    parser.add_argument("--samples", type=int, default=3, help="of each [%(default)s]")
    options = parser.parse_args()
    missing = f"{BINARY} (ninja -C build/release bench_tracing)"
    arguments.require([] if BINARY.exists() else [missing])
    dump = scenarios.prepare(options.work, "settled", SIZE).dump
    rows = []
    for rays in options.rays * options.samples:
        rows.append({"date": machine.now(), "machine": machine.processor(),
                     "version": pmr.version(), **measure(dump, rays)})
        print(*rows[-1].values(), flush=True)
        table.write(RESULTS, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
