#!/usr/bin/env python3
"""Runs rfm-solve on every wrong problem file of this folder and compares what it says.

    check_errors.py RFM_SOLVE [FILE...]

The comment at the head of a file tells what is expected: `# error: line:column: message` for each
mistake, in order, or after `# output:` everything that the program prints to its error stream.
`# set: path=value` is passed on as --set. Whatever the mistake, the exit status must be 2 and no
result may be written.
"""
import subprocess
import sys
import tempfile
from pathlib import Path


def expectation(path):
    """Overrides, expected mistakes, and the expected output as a whole (or None)."""
    overrides, errors, output = [], [], None
    for line in path.read_text().splitlines():
        if not line.startswith("#"):
            break
        text = line[2:]
        if output is not None:
            output.append(text)
        elif text.startswith("set: "):
            overrides.append(text[len("set: "):])
        elif text.startswith("error: "):
            errors.append(text[len("error: "):])
        elif text == "output:":
            output = []
    return overrides, errors, output


def reported(lines, name):
    """The first line of each mistake, without the name of the file: all that is not indented."""
    return [line.removeprefix(name + ":") for line in lines if line and not line.startswith(" ")]


def complaints(program, path):
    """What is wrong with the program's answer to one file."""
    overrides, errors, output = expectation(path)
    if not errors and not output:
        return ["the file has no '# error:' or '# output:' at its head"]
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results"
        command = [program, path.name, "--output", str(results)]
        for override in overrides:
            command += ["--set", override]
        run = subprocess.run(command, cwd=path.parent, capture_output=True, text=True, timeout=60)
        written = results.exists()
    lines = run.stderr.splitlines()
    wrong = []
    if run.returncode != 2:
        wrong.append(f"exit status {run.returncode} instead of 2")
    if written:
        wrong.append("results were written")
    if output is not None and lines != output:
        wrong.append("expected:\n" + "\n".join(output) + "\nbut the output is:\n" + run.stderr)
    if output is None and reported(lines, path.name) != errors:
        wrong.append("expected:\n" + "\n".join(errors) + "\nbut the output is:\n" + run.stderr)
    return wrong


def main():
    program = str(Path(sys.argv[1]).resolve())
    folder = Path(__file__).resolve().parent
    paths = [Path(name).resolve() for name in sys.argv[2:]] or sorted(folder.glob("*.yaml"))
    failures = 0
    for path in paths:
        for complaint in complaints(program, path):
            failures += 1
            print(f"{path.name}: {complaint}\n")
    print(f"{len(paths)} wrong files, {failures} unexpected answers")
    return 1 if failures or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
