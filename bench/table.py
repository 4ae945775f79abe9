"""Results as CSV."""

import csv
from pathlib import Path


def read(file: Path) -> list[dict]:
    if not file.exists():
        return []
    with file.open(newline="") as lines:
        return list(csv.DictReader(lines))


def read_current(file: Path, versions, processor: str) -> list[dict]:
    """Rows of these versions of the codes on this machine; others make way, which is said."""
    known = read(file)
    rows = [r for r in known if r["machine"] == processor and r["version"] in versions]
    if len(rows) < len(known):
        print(f"{len(known) - len(rows)} rows of another version or machine make way")
    return rows


def write(file: Path, rows: list[dict]) -> None:
    """All rows have the columns of the first."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", newline="") as out:
        writer = csv.DictWriter(out, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
