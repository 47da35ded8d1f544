#!/usr/bin/env python3
"""Checks that the table of operations in docs/fields.md is the one of the program.

    fields_page.py RFM_SOLVE [--write]

With --write the page is brought up to date.
"""
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs" / "fields.md"
BEGIN, END = "<!-- operations: begin -->\n", "<!-- operations: end -->\n"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    table = subprocess.run([program, "explain", "operations"], capture_output=True, text=True,
                           check=True).stdout.strip() + "\n"
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    written, after = rest.split(END)
    if "--write" in sys.argv:
        PAGE.write_text(before + BEGIN + table + END + after, encoding="utf-8")
        return 0
    if written != table:
        print(f"docs/fields.md is not up to date: run tests/fields_page.py {sys.argv[1]} --write")
        return 1
    print(f"{len(table.splitlines()) - 2} operations")
    return 0


if __name__ == "__main__":
    sys.exit(main())
