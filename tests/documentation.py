#!/usr/bin/env python3
"""Solves every complete problem that README.md and docs/ show, so that what is printed there works.

    documentation.py RFM_SOLVE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
SNIPPET = re.compile(r"^```yaml\n(.*?)^```", re.MULTILINE | re.DOTALL)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    solved = failed = 0
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        for snippet in SNIPPET.findall(page.read_text(encoding="utf-8")):
            if "geometry:" not in snippet or "conditions:" not in snippet:
                continue
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "snippet.yaml"
                path.write_text(snippet, encoding="utf-8")
                run = subprocess.run([program, "snippet.yaml"], cwd=folder, capture_output=True,
                                     text=True, timeout=300)
            solved += run.returncode == 0
            failed += run.returncode != 0
            if run.returncode != 0:
                print(f"{page.name}: exit status {run.returncode}\n{run.stdout}{run.stderr}")
    print(f"{solved} snippets solved, {failed} failed")
    return 1 if failed or not solved else 0


if __name__ == "__main__":
    sys.exit(main())
