#!/usr/bin/env python3
"""Runs rfm-solve on problems that are read but cannot be solved, and compares what it says.

    check_failures.py RFM_SOLVE

The first line of each file of this folder is `# failure: text`: the error stream must be one line
that contains the text, the exit status 3, and no result may be written.
"""
import subprocess
import sys
import tempfile
from pathlib import Path


def complaint(program, path):
    """What is wrong with the program's answer, or None."""
    expected = path.read_text().splitlines()[0].removeprefix("# failure: ")
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results"
        run = subprocess.run([program, path.name, "--output", str(results)], cwd=path.parent,
                             capture_output=True, text=True, timeout=60)
        written = [entry.name for entry in results.iterdir()] if results.exists() else []
    if run.returncode != 3:
        return f"exit status {run.returncode}"
    if expected not in run.stderr or len(run.stderr.splitlines()) != 1:
        return f"expected {expected!r} in one line, got {run.stderr!r}"
    return f"files were written: {written}" if written else None


def main():
    program = str(Path(sys.argv[1]).resolve())
    files = sorted(Path(__file__).parent.glob("*.yaml"))
    wrong = 0
    for path in files:
        if found := complaint(program, path):
            print(f"{path.name}: {found}")
            wrong += 1
    print(f"{len(files)} failing problems, {wrong} unexpected answers")
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
