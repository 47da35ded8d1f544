#!/usr/bin/env python3
"""Checks that every number of the catalogue of cases is asked for, to its tolerance, by a file that the
tests solve, and stands on the page docs/cases.md.

    cases_page.py
"""
import csv
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
EXPECTATION = re.compile(r"- \{quantity: \"?([^,]*?)\"?, value: ([^,]*), (relative_)?tolerance: ([^}]*)\}")
ALLOWED = 1e-9  # how closely a file repeats a value of the catalogue


def number(text):
    """A value of a file; formulas are written with pi at most."""
    try:
        return eval(text.strip('"').replace("^", "**"), {"__builtins__": {}, "pi": 3.141592653589793})
    except (NameError, SyntaxError):
        return float("nan")


def is_asked(entry, text):
    value, tolerance = float(entry["value"]), float(entry["tolerance"])
    for path, expected, relative, allowed in EXPECTATION.findall(text):
        if path == entry["path"] and abs(number(expected) - value) <= ALLOWED * abs(value):
            if float(allowed) <= tolerance * (1 if relative else abs(value)) * (1 + 1e-12):
                return True
    return False


def main():
    page = (ROOT / "docs/cases.md").read_text(encoding="utf-8")
    failures, count = [], 0
    with open(ROOT / "tests/verification/cases/catalogue.csv", encoding="utf-8") as file:
        for entry in csv.DictReader(file):
            count += 1
            text = (ROOT / f"tests/verification/{entry['file']}.yaml").read_text(encoding="utf-8")
            what = f"{entry['case']}: {entry['quantity']}"
            if not is_asked(entry, text):
                failures.append(f"{what}: {entry['file']}.yaml does not ask for it to its tolerance")
            if f"`{entry['quantity']}` | {float(entry['value']):.9g} |" not in page or entry["case"] not in page:
                failures.append(f"{what} is not in docs/cases.md: run scripts/cases")
    if "(missed)" in page:
        failures.append("docs/cases.md holds a number that misses its tolerance")
    print("\n".join(failures) or f"{count} numbers")
    return 1 if failures or not count else 0


if __name__ == "__main__":
    sys.exit(main())
