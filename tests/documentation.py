#!/usr/bin/env python3
"""Does what README.md and docs/*.md show, page by page in a scratch copy, so that it works as printed.

    documentation.py RFM_SOLVE

- ```yaml: a whole problem is solved; a part of one replaces the keys of the problem before it on the
  page, which is solved again. Where the text before it says "into `NAME.yaml`", it is written there.
  A problem of the gallery must be what its file holds (those files have tests of their own).
- ```sh: every line is run, with rfm-solve in the place of scripts/solve, so that nothing is built
  again. A line that ends in `# exit status N` must do so, others succeed. Commands that set up,
  build or test are left to the tests that do just that.
- ``` without a language, after ```sh: lines that its output must hold, in this order; "…" stands
  for any text.
- ```cpp: consecutive lines of an example in problems/examples, which is built and run; ```cmake of
  tests/install.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"into\s+`(\w+\.yaml)`")
STATUS = re.compile(r"#\s*exit status (\d+)\s*$")
ELSEWHERE = ("git clone", "cmake", "scripts/test", "scripts/gallery", "scripts/benchmark")
TOP_LEVEL = re.compile(r"^(\w+):", re.MULTILINE)


def sections(yaml):
    """The text of every top-level key, in order."""
    starts = [match.start() for match in TOP_LEVEL.finditer(yaml)] + [len(yaml)]
    return {TOP_LEVEL.match(yaml[a:b]).group(1): yaml[a:b].rstrip() for a, b in zip(starts, starts[1:])}


def make_scratch(folder, program):
    """A copy of the tree in which scripts/solve and build/release/rfm-solve are the given program."""
    for name in ("problems/gallery", "problems/examples", "tests/verification"):
        shutil.copytree(ROOT / name, folder / name)
    (folder / "scripts").mkdir()
    (folder / "scripts/solve").write_text(f'#!/bin/sh\nexec "{program}" "$@" --picture\n')
    (folder / "scripts/solve").chmod(0o755)
    (folder / "build/release").mkdir(parents=True)
    (folder / "build/release/rfm-solve").symlink_to(program)


class Page:
    def __init__(self, path, folder, program):
        self.path, self.folder, self.program = path, folder, program
        self.failures, self.done, self.problem, self.output = [], 0, None, None
        self.gallery = {problem.read_text(encoding="utf-8")
                        for problem in (ROOT / "problems/gallery").glob("*.yaml")}

    def fail(self, what, detail=""):
        self.failures.append(f"{self.path.name}: {what}\n{detail}".rstrip())

    def run(self):
        text = self.path.read_text(encoding="utf-8")
        end = 0
        for match in BLOCK.finditer(text):
            language, body = match.groups()
            step = {"yaml": self.yaml, "sh": self.shell, "cpp": self.cpp,
                    "cmake": self.cmake, "": self.plain}.get(language)
            if step:
                self.done += 1
                step(body, text[end:match.start()])
            else:
                self.fail(f"nothing checks what is written in '{language}'", body)
            if language != "":
                self.output = self.output if language == "sh" else None
            end = match.end()
        return self

    def command(self, line, status):
        run = subprocess.run(["bash", "-c", line], cwd=self.folder, capture_output=True, text=True,
                             timeout=300, env={**os.environ, "LC_ALL": "C.UTF-8"})
        if run.returncode != status:
            self.fail(f"`{line}`: exit status {run.returncode}", run.stdout + run.stderr)
        return run.stdout + run.stderr

    def yaml(self, body, before):
        if body in self.gallery:
            return
        named = NAMED.findall(before)
        if "dimension:" in body:
            self.problem = body
        elif self.problem is None:
            return self.fail("a part of a problem without a problem before it", body)
        else:
            merged = {**sections(self.problem), **sections(body)}
            self.problem = "\n".join(merged.values()) + "\n"
        name = named[-1] if named else "snippet.yaml"
        (self.folder / name).write_text(self.problem, encoding="utf-8")
        self.command(f"build/release/rfm-solve {name}", 0)

    def shell(self, body, before):
        self.output = ""
        for line in body.splitlines():
            if not line.strip() or line.startswith("#") or line.startswith(ELSEWHERE):
                continue
            status = STATUS.search(line)
            self.output += self.command(line, int(status.group(1)) if status else 0)

    def plain(self, body, before):
        if self.output is None:
            return
        lines = iter(self.output.splitlines())
        for expected in body.splitlines():
            pattern = re.compile(".*".join(re.escape(part) for part in expected.split("…")) + r"\s*")
            if not any(pattern.fullmatch(line) for line in lines):
                return self.fail(f"no line of the output is, in its place, '{expected}'", self.output)

    def cpp(self, body, before):
        self.excerpt(body, sorted((ROOT / "problems/examples").glob("*.cpp")))

    def cmake(self, body, before):
        self.excerpt(body, [ROOT / "tests/install/CMakeLists.txt"])

    def excerpt(self, body, files):
        wanted = [line.strip() for line in body.splitlines() if line.strip()]
        for path in files:
            lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
            lines = [line for line in lines if line]
            if any(lines[i:i + len(wanted)] == wanted for i in range(len(lines))):
                return
        self.fail("a snippet that is in none of the files it should be from", body)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    failures, done = [], 0
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        with tempfile.TemporaryDirectory() as folder:
            make_scratch(pathlib.Path(folder), program)
            page = Page(path, pathlib.Path(folder), program).run()
        failures += page.failures
        done += page.done
    print("\n\n".join(failures))
    print(f"{done} snippets, {len(failures)} failures")
    return 1 if failures or not done else 0


if __name__ == "__main__":
    sys.exit(main())
