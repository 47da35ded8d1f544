#!/usr/bin/env python3
"""Checks that the pages of docs/structures/ are what the verification files make of them.

    structure_pages.py RFM_SOLVE [--write]

A verification file whose comments hold `# page: NAME` makes the page NAME.md: its title and other
comments, what stands after `# formula:`, `# source:` and `# use:`, the structure as the program
prints it, the file, and a picture of its solution. With --write the pages and pictures are made
anew.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILES = ROOT / "tests" / "verification"
PAGES = ROOT / "docs" / "structures"
KEYS = ("page", "formula", "source", "use")
LONGEST_LINE = 600


def described_files():
    """Files with a page: the values of their keys, other comments, and what is no comment."""
    for path in sorted(FILES.rglob("*.yaml")):
        keys, comments, text = {}, [], []
        for line in path.read_text(encoding="utf-8").splitlines():
            if not line.startswith("#"):
                text.append(line)
                continue
            key, _, value = line[1:].strip().partition(": ")
            if key in KEYS:
                keys[key] = value
                last = key
            elif line.startswith("#   ") and keys:
                keys[last] += " " + line[1:].strip()
            else:
                comments.append(line[1:].strip())
        if "page" in keys:
            yield path, keys, comments, text


def structure(program, path):
    """The line for `discretization.structure`, from the file or as the program finds it."""
    run = subprocess.run([program, "check", str(path)], capture_output=True, text=True, check=True)
    found = re.search(r"^  discretization\.structure: (.*)$", run.stdout, re.MULTILINE)
    own = re.search(r"^structure: \w+ = (.*)$", run.stdout, re.MULTILINE)
    line = found.group(1) if found else own.group(1)
    return line if len(line) <= LONGEST_LINE else line[:LONGEST_LINE] + " ..."


def page(program, path, keys, comments, text):
    title = next(line for line in text if line.startswith("title: "))[len("title: "):]
    parts = [f"# {title}", ""]
    if comments:
        parts += [" ".join(comments), ""]
    parts += ["    " + keys["formula"], "", f"**Source.** {keys['source']}", "",
              f"**When to use it.** {keys['use'][0].upper() + keys['use'][1:]}", "",
              f"![The solution]({keys['page']}.png)", "",
              "The structure, as `rfm-solve check` prints it:", "",
              "    " + structure(program, path), "",
              f"The problem, `{path.relative_to(ROOT)}`, with what it is verified against:", "",
              "```yaml", *text, "```", ""]
    return "\n".join(parts)


def index(pages):
    lines = ["# Builders of solution structures", "",
             "Each page is made from a verification file by `tests/structure_pages.py`. The algebra is",
             "told of in [structures.md](../structures.md).", "", "| structure | problem |", "|---|---|"]
    for keys, title in pages:
        formula = keys["formula"].replace("|", "\\|")
        lines.append(f"| `{formula}` | [{title}]({keys['page']}.md) |")
    return "\n".join(lines) + "\n"


def draw(program, path, name):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, str(path), "--output", folder, "--picture", "--quiet", "--no-verify",
                        "--set", "outputs.picture.width=600"], check=True)
        shutil.copy(pathlib.Path(folder) / f"{path.stem}.png", PAGES / f"{name}.png")


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    wanted, listed, names = {}, [], {}
    for path, keys, comments, text in described_files():
        wanted[keys["page"] + ".md"] = page(program, path, keys, comments, text)
        names[keys["page"]] = path
        listed.append((keys, next(x for x in text if x.startswith("title: "))[len("title: "):]))
    wanted["README.md"] = index(listed)
    if "--write" in sys.argv:
        PAGES.mkdir(exist_ok=True)
        for name, content in wanted.items():
            (PAGES / name).write_text(content, encoding="utf-8")
        for name, path in names.items():
            draw(program, path, name)
        return 0
    present = {path.name: path.read_text(encoding="utf-8") for path in PAGES.glob("*.md")}
    pictures = {path.stem for path in PAGES.glob("*.png")}
    wrong = sorted(name for name in wanted.keys() | present.keys()
                   if wanted.get(name) != present.get(name))
    wrong += [f"{name}.png" for name in sorted(names.keys() ^ pictures)]
    if wrong:
        print("not up to date in docs/structures: " + ", ".join(wrong) +
              f"; run tests/structure_pages.py {sys.argv[1]} --write")
        return 1
    print(f"{len(names)} pages")
    return 0


if __name__ == "__main__":
    sys.exit(main())
