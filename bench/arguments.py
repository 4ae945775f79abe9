"""Command lines of the benchmarks."""

import argparse
import sys
import tempfile
from pathlib import Path

from scenarios import SCENARIOS, SIZES


def whole_numbers(text: str) -> list[int]:
    return [int(part) for part in text.split(",")]


def parser(description: str) -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(description=description)
    made.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "pmr-bench",
                      help="folder of large files, kept for the next time [%(default)s]")
    return made


def add_choice(made: argparse.ArgumentParser) -> None:
    made.add_argument("--scenarios", type=lambda text: text.split(","), default=list(SCENARIOS),
                      help="of " + ",".join(SCENARIOS) + " [all]")
    made.add_argument("--sizes", type=whole_numbers, default=list(SIZES),
                      help="of " + ",".join(map(str, SIZES)) + " [all]")


def check_choice(made: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    for given, known in ((options.scenarios, SCENARIOS), (options.sizes, SIZES)):
        for one in given:
            if one not in known:
                made.error(f"{one!r} is none of {', '.join(map(str, known))}")


def chosen(options: argparse.Namespace) -> list[tuple[str, int]]:
    """Scenarios and sizes, the small ones first."""
    return [(name, size) for size in sorted(options.sizes) for name in options.scenarios]


def require(missing: list[str]) -> None:
    """Ends the program if something is missing."""
    if missing:
        sys.exit("missing: " + ", ".join(missing) + "; Debian packages come with "
                 "apt-get install --no-install-recommends NAME")
