#!/usr/bin/env python3
"""Runs rfm-solve --picture and check --picture on bodies in space, and looks at what they drew.

    check_space_pictures.py RFM_SOLVE
"""
import math
import sys
import tempfile

from check_pictures import Runs
from png import Picture

SHELL = """
dimension: 3
geometry:
  shapes:
    outer: {sphere: {center: [0, 0, 0], radius: 1}}
    inner: {sphere: {center: [0, 0, 0], radius: 0.5}}
  domain: outer - inner
physics: {type: poisson}
conditions: [{at: inner, value: 1}, {at: outer, value: 2}]
discretization: {basis: {bspline: 2, cells: 8}}
"""


def coloured_parts(picture):
    """Lists (width, pixels) of the parts, from the left, that blank columns separate."""
    columns = [sum(picture.is_coloured(x, y) for y in range(80, picture.height))
               for x in range(picture.width)]
    parts, width, pixels = [], 0, 0
    for count in columns + [0]:
        if count:
            width, pixels = width + 1, pixels + count
        elif width:
            parts.append((width, pixels))
            width = pixels = 0
    return [part for part in parts if part[0] > 60]


def check_cut_shell(runs):
    # Seen from the front: the whole ball is a disk of the colour of u = 2; cut open it is a disk of
    # the same size whose middle is the inner wall, where u = 1 (the other end of the scale).
    view = ["--set", "outputs.picture.view=[0, -1, 0]", "--set", "outputs.picture.contours=0"]
    names, out, _ = runs.run(SHELL, "--picture", *view)
    assert "case.png" in names and "case.boundary.vtu" in names, names
    picture = Picture(out / "case.png")
    assert picture.width == 1000
    parts = coloured_parts(picture)
    assert len(parts) == 2, parts
    for width, pixels in parts:
        assert width > 300, f"a view is only {width} pixels wide"
        assert abs(pixels / (math.pi / 4 * width ** 2) - 1) < 0.03, (width, pixels)
    assert abs(parts[0][0] - parts[1][0]) <= 4, f"the views have different scales: {parts}"
    names, out, _ = runs.run(SHELL, "--picture", *view, "--set", "outputs.picture.cut=false")
    parts = coloured_parts(Picture(out / "case.png"))
    assert len(parts) == 1 and parts[0][0] > 600, parts


def check_boundary_file(runs):
    _, out, _ = runs.run(SHELL)
    head = (out / "case.boundary.vtu").read_bytes()[:4000].decode("latin-1")
    for name in ("u", "gradient", "normal", "piece", "flux.n"):
        assert f'Name="{name}"' in head, f"no {name} in case.boundary.vtu"


def check_pieces(runs):
    names, out, _ = runs.run(SHELL, "--picture", check=True)
    assert names == ["case.check.png"], names
    picture = Picture(out / "case.check.png")
    # Blue outside in three views, orange inside in one of them only: the last.
    blue, orange = [], []
    for y in range(60, int(0.85 * picture.height)):
        for x in range(picture.width):
            red, green, b = picture.pixel(x, y)
            if b > red + 60 and b > 100:
                blue.append(x)
            elif red > b + 60 and red > 100:
                orange.append(x)
    third = picture.width / 3
    for panel in range(3):
        assert sum(panel * third <= x < (panel + 1) * third for x in blue) > 500, panel
    inside = [x for x in orange if x > 2 * third]
    assert len(inside) > 500, len(inside)


def main():
    status = 0
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(sys.argv[1], folder)
        for check in (check_cut_shell, check_boundary_file, check_pieces):
            try:
                check(runs)
            except AssertionError as failure:
                print(f"{check.__name__}: {failure}")
                status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
