#!/usr/bin/env python3
"""Runs rfm-solve --picture and check --picture, and looks at what they drew.

    check_pictures.py RFM_SOLVE
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from png import Picture

RING = """
title: Ring θ
dimension: 2
geometry:
  shapes:
    outer: {circle: {center: [3, 1], radius: 1}}
    inner: {circle: {center: [3, 1], radius: 0.5}}
  domain: outer - inner
physics: {type: poisson}
conditions: [{at: inner, value: 1}, {at: outer, value: 2}]
discretization: {basis: {bspline: 2, cells: 12}}
"""
BAR = """
dimension: 1
geometry: {shapes: {bar: {box: {min: [0], max: [2]}}}, domain: bar}
physics: {type: poisson, source: 1}
conditions: [{at: bar.left, value: 0}, {at: bar.right, flux: 0}]
"""
BRACKET = """
dimension: 2
geometry:
  shapes:
    plate: {box: {min: [0, 0], max: [3, 1.6]}}
    notch: {box: {min: [1.2, 1.1], max: [1.9, 2]}}
    hole: {circle: {center: [0.6, 0.8], radius: 0.3}}
  domain: plate - notch - hole
regions:
  warm: {of: hole, where: "y - 0.8"}
physics: {type: heat, conductivity: 45}
conditions:
  - {at: plate.bottom, value: 350}
  - {at: warm, flux: 3}
  - {at: rest, flux: 0}
"""
SETS = """
sets:
  spot: {point: [2.2, 0.5]}
  wire: {polyline: {points: [[1.2, 0.3], [1.6, 0.9], [2.6, 0.9]]}}
  bow: {arc: {center: [0.6, 0.8], radius: 0.45, from: 20, to: 160}}
  wave: {curve: {of: "y - 0.3 - 0.1*sin(5*x)", where: "(x - 1)*(2 - x)"}}
"""
EXACT = """
verify:
  exact: {u: "1 + log(2*hypot(x - 3, y - 1)) / log(2)"}
"""


class Runs:
    def __init__(self, program, folder):
        self.program, self.folder, self.failures = program, Path(folder), []
        self.number = 0

    def run(self, text, *arguments, check=False, width=None):
        """Solves (or checks) a file; the names of what was written, and its folder."""
        self.number += 1
        folder = self.folder / str(self.number)
        folder.mkdir()
        (folder / "case.yaml").write_text(text, encoding="utf-8")
        command = [self.program] + (["check"] if check else [])
        command += [str(folder / "case.yaml"), "--output", str(folder / "out"), *arguments]
        if width:
            command += ["--set", f"outputs.picture.width={width}"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=120)
        if done.returncode != 0:
            raise AssertionError(f"{' '.join(command)}: {done.returncode}\n{done.stderr}")
        out = folder / "out"
        return sorted(p.name for p in out.iterdir()) if out.exists() else [], out, done.stdout


def ring_area(picture):
    """The coloured pixels left of the colour bar: width, height and number."""
    columns = [sum(picture.is_coloured(x, y) for y in range(picture.height))
               for x in range(picture.width)]
    first = next(x for x in range(picture.width) if columns[x])
    end = next(x for x in range(first, picture.width) if not columns[x])
    rows = [y for y in range(picture.height)
            if any(picture.is_coloured(x, y) for x in range(first, end))]
    return end - first, rows[-1] - rows[0] + 1, sum(columns[first:end])


def strong_colours(picture, columns):
    """Colours other than grey and pale that fill sixty pixels or more."""
    count = {}
    for y in range(picture.height):
        for x in columns:
            colour = picture.pixel(x, y)
            if max(colour) - min(colour) > 60:
                count[colour] = count.get(colour, 0) + 1
    return {colour for colour, pixels in count.items() if pixels >= 60}


def check_ring(runs):
    names, out, _ = runs.run(RING, "--picture", "--set", "outputs.picture.contours=0")
    assert "case.png" in names, names
    assert not [n for n in names if "convergence" in n or n.startswith(".")], names
    picture = Picture(out / "case.png")
    assert picture.width == 1000, picture.width
    width, height, area = ring_area(picture)
    assert abs(width - height) <= 2, f"the aspect is not kept: {width} x {height}"
    assert width > 600, f"the ring is only {width} pixels wide"
    # The black lines on both circles are 2 pixels wide and hide 1 on each side of the ring.
    expected = math.pi / 4 * (width ** 2 - (width / 2) ** 2)
    assert abs(area / expected - 1) < 0.02, f"{area} pixels are coloured, not {expected:.0f}"
    assert picture.pixel(2, 2) == (255, 255, 255)


def check_options(runs):
    names, _, _ = runs.run(RING)
    assert not [n for n in names if n.endswith(".png")], "a picture that nobody asked for"
    file = RING + "outputs: {picture: {field: flux, width: 300, range: [0, 2]}}\n"
    names, out, _ = runs.run(file)
    assert Picture(out / "case.png").width == 300
    names, out, _ = runs.run(RING, "--picture", "--set", "outputs.picture.colours=diverging",
                             "--set", "outputs.picture.field=u-1.5", width=400)
    picture = Picture(out / "case.png")
    reds = blues = 0
    for y in range(0, picture.height, 3):
        for x in range(0, picture.width, 3):
            red, _, blue = picture.pixel(x, y)
            reds += red > blue + 40
            blues += blue > red + 40
    assert reds > 500 and blues > 500, (reds, blues)


def check_line(runs):
    names, out, _ = runs.run(BAR, "--picture", width=500)
    picture = Picture(out / "case.png")
    assert picture.width == 500 and "case.png" in names
    # u = 2x - x²/2 rises from the lower left to the upper right.
    curve = {}
    for x in range(picture.width):
        ys = [y for y in range(picture.height) if picture.is_coloured(x, y)]
        if ys:
            curve[x] = sum(ys) / len(ys)
    left, right = min(curve), max(curve)
    share = (curve[left] - curve[(left + right) // 2]) / (curve[left] - curve[right])
    assert abs(share - 0.75) < 0.01, f"u(1) / u(2) is drawn as {share}, not 3/4"


def check_missing_values(runs):
    """Where there is nothing to see, log and summary say why, in the plane and on a line."""
    for text, field, cause in ((RING, "sqrt(x-3)", ": sqrt(-"), (BAR, "log(x-1)", ": log(-")):
        _, out, printed = runs.run(text, "--picture", "--set", f"outputs.picture.field={field}",
                                   width=200)
        notes = json.loads((out / "summary.json").read_text())["notes"]
        assert len(notes) == 1, notes
        shown = field.replace("-", " - ")
        assert f"where {field} is not a finite number, as at the point (" in notes[0], notes
        assert cause in notes[0] and notes[0].endswith(f" in {shown}"), notes
        assert f"note: {notes[0]}" in printed, printed
        assert notes[0] in (out / "log.txt").read_text()
    _, out, _ = runs.run(RING, "--picture", width=200)
    assert "notes" not in json.loads((out / "summary.json").read_text())


def check_convergence(runs):
    names, out, _ = runs.run(RING + EXACT, "--converge", "3", "--picture", width=400)
    assert "case.convergence.png" in names and "case.png" in names, names
    assert Picture(out / "case.convergence.png").width == 400
    summary = json.loads((out / "summary.json").read_text())
    assert len(summary["convergence"]) == 3
    names, out, _ = runs.run(RING, "--converge", "3", "--picture", width=400)  # the change of u
    assert "case.convergence.png" in names, names
    names, _, _ = runs.run(RING, "--converge", "2", "--picture", width=400)  # one change is no curve
    assert "case.convergence.png" not in names, names


def check_check(runs):
    names, out, text = runs.run(RING, "--picture", check=True, width=400)
    assert names == ["case.check.png"], names
    assert f"picture: {out}/case.check.png" in text, text
    picture = Picture(out / "case.check.png")
    assert picture.width == 400
    colours = {picture.pixel(x, y) for y in range(picture.height) for x in range(picture.width)}
    for wanted in ((0, 115, 179), (214, 94, 0)):  # the two pieces
        assert wanted in colours, f"no pixel has the colour {wanted}"
    # Nine parts of a boundary, two of them halves of one circle, each in a colour of its own: what
    # the legend shows at the right is drawn at the left.
    names, out, _ = runs.run(BRACKET, "--picture", check=True)
    picture = Picture(out / "case.check.png")
    legend = strong_colours(picture, range(int(0.74 * picture.width), picture.width))
    drawn = strong_colours(picture, range(0, int(0.7 * picture.width)))
    assert len(legend) == 9, f"the legend has {len(legend)} colours: {legend}"
    assert legend <= drawn, f"{legend - drawn} are not drawn"
    # Sets in colours of their own, in the legend and on the picture.
    names, out, _ = runs.run(BRACKET + SETS, "--picture", check=True)
    picture = Picture(out / "case.check.png")
    more = strong_colours(picture, range(int(0.74 * picture.width), picture.width)) - legend
    assert len(more) == 4, f"the legend has {len(more)} colours for four sets: {more}"
    drawn = strong_colours(picture, range(0, int(0.7 * picture.width)))
    assert more <= drawn, f"{more - drawn} are not drawn"
    names, out, _ = runs.run(BAR, "--picture", check=True, width=400)
    assert names == ["case.check.png"] and Picture(out / "case.check.png").width == 400
    names, _, _ = runs.run(RING, check=True)
    assert names == [], "check without --picture wrote files"


def main():
    status = 0
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(sys.argv[1], folder)
        for check in (check_ring, check_options, check_line, check_missing_values,
                      check_convergence, check_check):
            try:
                check(runs)
            except AssertionError as failure:
                print(f"{check.__name__}: {failure}")
                status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
