"""Where and when a measurement was made."""

import datetime
from pathlib import Path


def processor() -> str:
    """Model and number of cores, as the kernel tells them."""
    names = [line.split(": ", 1)[1] for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return f"{names[0]}, {len(names)} cores" if names else "unknown processor"


def now() -> str:
    """UTC."""
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
