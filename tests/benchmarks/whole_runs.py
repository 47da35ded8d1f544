#!/usr/bin/env python3
"""Whole runs of rfm-solve in CPU seconds (user + system), files written, on one thread.

    whole_runs.py RFM_SOLVE [--once]

Every run is repeated and the least time taken, since other work only adds to it. The parts are wall
seconds of that run, from its summary.json. Errors come from a run of their own of the same
discretisation: measuring them is no part of solving. Exit status 1 if a run fails or misses its
error (never for a time: those depend on the machine).
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
VERIFICATION = HERE.parent / "verification"

CIRCLES = "outer_circle*inner_circle*exp(x)*cos(2*y)"
ANNULUS = {"fields.exact": CIRCLES, "discretization.basis": "{bspline: 5, cells: 22}"}
BALLS = {"discretization.basis": "{bspline: 2, cells: 15}"}
FINE_BALLS = {"discretization.basis": "{bspline: 3, cells: 20}"}

# name, problem, values, largest relative error in L2
RUNS = [
    ("annulus, u = 0", "annulus_homogeneous", ANNULUS, 1e-8),
    ("ball minus ball", "balls", BALLS, 1e-4),
    ("same, finer", "balls", FINE_BALLS, 3e-6),
    ("turned cube", "rotated_cube", {}, 3e-6),
    ("turned rod", "rotated_cylinder", {}, 3e-6),
    ("polygons of 1,000 edges", "thousand_edges", {}, 5e-5),
]


def cpu_seconds(command, log=subprocess.DEVNULL):
    """CPU and wall seconds of one process, and its exit status."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    status = subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, check=False).returncode
    after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter() - start
    cpu = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return cpu, wall, status


def summary(folder):
    return json.loads((pathlib.Path(folder) / "summary.json").read_text(encoding="utf-8"))


def measure(solver, problem, values, folder, repetitions):
    command = [solver, str(VERIFICATION / f"{problem}.yaml"), "--output", folder, "--quiet"]
    for key, value in values.items():
        command += ["--set", f"{key}={value}"]
    error_run = command + ["--set", "verify={exact: {u: exact}}"]
    if subprocess.run(error_run, check=False).returncode != 0:
        raise SystemExit(f"{problem} failed")
    error = summary(folder)["errors"]["u"]["L2_relative"]
    best, seconds = None, None
    for _ in range(repetitions):
        cpu, _, status = cpu_seconds(command + ["--no-verify", "--threads", "1"])
        if status != 0:
            raise SystemExit(f"{problem} failed")
        if best is None or cpu < best:
            best, seconds = cpu, summary(folder)["seconds"]
    return error, best, seconds


def main():
    solver = os.path.abspath(sys.argv[1])
    repetitions = 1 if "--once" in sys.argv[2:] else 15
    parts = ["read", "prepare", "quadrature", "assembly", "solve", "output", "total"]
    print(f"{'run':<20}{'L2 error':>10}{'CPU s':>8} |" + "".join(f"{part:>11}" for part in parts))
    status = 0
    version = min(cpu_seconds([solver, "--version"])[0] for _ in range(repetitions))
    print(f"{'--version':<20}{'':>10}{version:>8.3f} |")
    with tempfile.TemporaryDirectory() as folder:
        for name, problem, values, bound in RUNS:
            error, best, seconds = measure(solver, problem, values, folder + "/run", repetitions)
            columns = "".join(f"{seconds[part]:>11.3f}" for part in parts)
            missed = "" if error <= bound else f"  MISSES {bound:.0e}"
            status |= error > bound
            print(f"{name:<20}{error:>10.1e}{best:>8.3f} |{columns}{missed}")
    return status


if __name__ == "__main__":
    sys.exit(main())
