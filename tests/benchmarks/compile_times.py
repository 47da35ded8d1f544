#!/usr/bin/env python3
"""Prints the CPU seconds that compiling each unit of the libraries takes, the longest first.

    tests/benchmarks/compile_times.py BUILD_FOLDER [PATTERN]

Units whose path contains PATTERN (all by default) are compiled one after the other by the commands
of the build, without a compiler cache; what is built stays as it is. No unit may take 20 s.
"""

import json
import os
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile

LIBRARIES = ("basis", "core", "problems", "quadrature", "solution_structures", "solvers")


def cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seconds_to_compile(entry, output):
    words = shlex.split(entry["command"])
    if os.path.basename(words[0]) in ("ccache", "sccache"):
        words = words[1:]
    words[words.index("-o") + 1] = output
    before = cpu_seconds()
    subprocess.run(words, cwd=entry["directory"], check=True)
    return cpu_seconds() - before


def main():
    build = pathlib.Path(sys.argv[1])
    pattern = sys.argv[2] if len(sys.argv) > 2 else ""
    entries = json.loads(subprocess.check_output(["ninja", "-C", build, "-t", "compdb"]))
    entries = [entry for entry in entries if entry["file"].endswith(".cpp")]
    root = pathlib.Path(__file__).resolve().parents[2]
    times = []
    with tempfile.TemporaryDirectory() as folder:
        for entry in entries:
            unit = pathlib.Path(entry["directory"], entry["file"]).resolve().relative_to(root)
            if unit.parts[0] in LIBRARIES and pattern in str(unit):
                output = os.path.join(folder, "unit.o")
                times.append((seconds_to_compile(entry, output), unit))
    for seconds, unit in sorted(times, reverse=True):
        print(f"{seconds:6.1f} s  {unit}")


if __name__ == "__main__":
    main()
