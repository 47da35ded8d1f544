#!/usr/bin/env python3
"""The ladder of folders as a test: a source file includes only from folders below its own.

    core <- basis, quadrature, solution_structures (siblings: never each other) <- solvers
         <- problems <- tests

Also: only problems/output includes VTK, only problems includes yaml-cpp and CLI11, and every test
is registered in tests/CMakeLists.txt.
"""

import pathlib
import re
import sys

ALLOWED = {
    "core": {"core"},
    "basis": {"core", "basis"},
    "quadrature": {"core", "quadrature"},
    "solution_structures": {"core", "solution_structures"},
    "solvers": {"core", "basis", "quadrature", "solution_structures", "solvers"},
    "problems": {"core", "basis", "quadrature", "solution_structures", "solvers", "problems"},
}
EXTERNAL = {  # header pattern -> folder that alone may include it
    r"^vtk\w+\.h$": "problems/output",
    r"^yaml-cpp/": "problems",
    r"^CLI/": "problems",
    r"^nlohmann/": "problems",
    r"^cholmod": "solvers",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def violations(root: pathlib.Path):
    for folder, allowed in ALLOWED.items():
        for path in sorted((root / folder).rglob("*.[hc]pp")):
            name = path.relative_to(root).as_posix()
            for kind, header in INCLUDE.findall(path.read_text(encoding="utf-8")):
                if kind == '"':
                    target = header.split("/")[0]
                    if target not in allowed:
                        yield f"{name} includes {header}: {folder} must not know {target}"
                    elif not (root / header).is_file():
                        yield f"{name} includes {header}, which is no file under the root"
                    if name.startswith("problems/output/") and target == "problems":
                        if not header.startswith("problems/output/"):
                            yield f"{name} includes {header}: output knows no problems"
                else:
                    for pattern, only in EXTERNAL.items():
                        if re.search(pattern, header) and not name.startswith(only + "/"):
                            yield f"{name} includes <{header}>: only {only} may"


def unregistered_tests(root: pathlib.Path):
    """Every ..._test.cpp under tests/ stands among the sources of a call of rfm_unit_tests."""
    lists = (root / "tests/CMakeLists.txt").read_text(encoding="utf-8")
    calls = re.findall(r"rfm_unit_tests\((.*?)\)", lists, re.DOTALL)
    registered = {source for call in calls for source in call.split()}
    for path in sorted((root / "tests").rglob("*_test.cpp")):
        name = path.relative_to(root / "tests").as_posix()
        if name not in registered:
            yield f"tests/{name} is not registered in tests/CMakeLists.txt"


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]
    root = root.resolve()
    found = [*violations(root), *unregistered_tests(root)]
    for line in found:
        print(line)
    print(f"{len(found)} violations of the architecture")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
