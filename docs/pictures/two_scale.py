#!/usr/bin/env python3
"""Draws two-scale.svg: the bases before and after a step, a box whose shadows are linear B-splines, and limit functions
of curve schemes as sums of narrower copies of themselves ([barendrecht_2013], Figures 2 and 3).

Usage: two_scale.py LIMES OUT.svg      LIMES is the program; masks and curves come from it.

The script fails if a function is not the sum of its copies, or if a mask of B-splines does not count the sub-cubes of a
box that have the same shadow.
"""
import collections
import itertools
import json
import pathlib
import sys
import tempfile

import drawing

LIMES, OUT = sys.argv[1], sys.argv[2]
PANELS = [("lane-riesenfeld:1", "linear B-spline"), ("chaikin", "quadratic B-spline"),
          ("lane-riesenfeld:3", "cubic B-spline"), ("four-point", "four-point")]
WIDTH, HEIGHT, GAP = 300, 170, 24
REACH = 3.2  # of the functions, in sides of the polygon
LEVELS = 5


def limit_function(scheme, levels=LEVELS):
    """Points {t: value} of the function that belongs to one control point at 0, after some steps."""
    with tempfile.TemporaryDirectory() as folder:
        polygon, curve = pathlib.Path(folder) / "p.obj", pathlib.Path(folder) / "c.obj"
        lines = [f"v {i} {1 if i == 0 else 0} 0\n" for i in range(-6, 7)]
        polygon.write_text("".join(lines) + "l " + " ".join(map(str, range(1, 14))) + "\n")
        drawing.run(LIMES, "refine", polygon, "-o", curve, "--scheme", scheme, "--levels", levels)
        return {x: y for x, y, _ in drawing.points_of(curve) if abs(x) <= REACH + 0.01}


def shifts(mask):
    """Where the copies stand, in half sides: new points of a dual scheme lie a quarter of a side beside the old ones."""
    first, weights = mask
    return [(first + i - (0.5 if len(weights) % 2 == 0 else 0), w) for i, w in enumerate(weights) if w != 0]


def check(scheme, mask):
    """A step further, the function is the sum of copies of what it was."""
    fine, coarse = limit_function(scheme), limit_function(scheme, LEVELS - 1)
    for t, value in fine.items():
        if abs(t) > REACH - 0.1:
            continue
        total = sum(w * coarse.get(2 * t - shift, 0) for shift, w in shifts(mask))
        if abs(total - value) > 1e-14:
            sys.exit(f"{scheme} at {t}: {value!r}, the copies add up to {total!r}")


def check_boxes(masks):
    """A cube of d + 1 dimensions falls into 2^(d + 1) of half the size; so many have the same shadow."""
    for scheme, degree in (("lane-riesenfeld:1", 1), ("chaikin", 2), ("lane-riesenfeld:3", 3)):
        count = collections.Counter(map(sum, itertools.product((0, 1), repeat=degree + 1)))
        shadows = [count[k] / 2**degree for k in range(degree + 2)]
        if masks[scheme][1] != shadows:
            sys.exit(f"{scheme}: mask {masks[scheme][1]}, shadows {shadows}")


def placed(x0, y0, width, reach, height=HEIGHT):
    """From (t, value) to the picture."""
    return lambda t, y: (x0 + (t + reach) / (2 * reach) * width, y0 + height * (0.86 - 0.72 * y))


def curve(points, style):
    return drawing.polyline(points, f'fill="none" {style}')


def sum_of_copies(scheme, title, mask, x0, y0):
    place = placed(x0, y0, WIDTH, REACH)
    function = sorted(limit_function(scheme).items())
    parts = [curve([place(-REACH, 0), place(REACH, 0)], f'stroke="{drawing.LIGHT}"')]
    for shift, weight in shifts(mask):
        copy = [place((t + shift) / 2, weight * y) for t, y in function]
        parts.append(curve(copy, f'stroke="{drawing.BLUE}" stroke-width="1.2"'))
        parts.append(drawing.text(place(shift / 2, 0)[0], y0 + HEIGHT - 4, f"{weight:g}", 10, drawing.BLUE, "middle"))
    parts.append(curve([place(t, y) for t, y in function], f'stroke="{drawing.RED}" stroke-width="2.2"'))
    return parts + [drawing.text(x0 + 4, y0 + 16, title, 13, weight="bold")]


def bases(mask, x0, y0, width):
    """Cubic B-splines of the old and the new control points; those that make up one of the old are marked."""
    function = [(t, y) for t, y in sorted(limit_function("lane-riesenfeld:3").items()) if abs(t) <= 2]
    chosen, weights = 3, dict((6 + shift, w) for shift, w in shifts(mask))
    parts = [drawing.text(x0 + 4, y0 + 16, "cubic B-splines before and after a step", 13, weight="bold")]
    for top, name, scale, count in ((y0 + 8, "A", 1, 7), (y0 + 118, "B", 2, 13)):
        at = placed(x0, top, width, 3.5, 130)
        place = lambda t, y: at(t - 3, y)
        parts.append(curve([place(-0.5, 0), place(6.5, 0)], f'stroke="{drawing.LIGHT}"'))
        for i in range(count):
            marked = i == chosen if scale == 1 else i in weights
            colour = drawing.GREY if not marked else drawing.RED if scale == 1 else drawing.BLUE
            points = [place((i + t) / scale, y) for t, y in function if -0.5 <= (i + t) / scale <= 6.5]
            parts.append(curve(points, f'stroke="{colour}" stroke-width="{2 if marked else 0.8}"'))
            parts.append(drawing.text(*place(i / scale, -0.14), f'{name}<tspan font-size="8" dy="2">{i}</tspan>', 11,
                                      colour, "middle"))
    terms = " + ".join(f"{'' if w == 1 / 8 else f'{8 * w:g} '}B{j:g}" for j, w in sorted(weights.items()))
    parts.append(drawing.text(x0 + width, y0 + 16, f"A{chosen} = ({terms}) / 8", 12, drawing.BLUE, "end"))
    return parts


def box(x0, y0):
    """A square on its corner over its shadow: how long the vertical chords are."""
    side = 56
    at = lambda i, j: (x0 + WIDTH / 2 + (i + j - 1) * side, y0 + 82 + (j - i) * side)
    parts = [drawing.text(x0 + 4, y0 + 16, "a square and its shadow", 13, weight="bold")]
    for i, j in itertools.product((0, 0.5), repeat=2):
        parts.append(drawing.polyline([at(i, j), at(i + 0.5, j), at(i + 0.5, j + 0.5), at(i, j + 0.5)],
                                      f'fill="#eef3f9" stroke="{drawing.BLUE}"', closed=True))
    parts.append(drawing.polyline([at(0, 0), at(1, 0), at(1, 1), at(0, 1)],
                                  f'fill="none" stroke="{drawing.RED}" stroke-width="2.2"', closed=True))
    shadow = lambda t, y: (x0 + WIDTH / 2 + t * side, y0 + 240 - 2 * side * y * 0.7)
    for t in (-1, -0.5, 0, 0.5, 1):
        x, axis = shadow(t, 0)
        parts.append(curve([(x, y0 + 82), (x, axis)], f'stroke="{drawing.LIGHT}" stroke-dasharray="3 3"'))
    for k, count in sorted(collections.Counter(map(sum, itertools.product((0, 1), repeat=2))).items()):
        t = (k - 1) / 2
        parts.append(curve([shadow(t - 0.5, 0), shadow(t, count / 2), shadow(t + 0.5, 0)],
                           f'stroke="{drawing.BLUE}" stroke-width="1.2"'))
        parts.append(drawing.text(shadow(t, 0)[0], y0 + 256, f"{count}", 11, drawing.BLUE, "middle"))
    parts.append(curve([shadow(-1, 0), shadow(0, 1), shadow(1, 0)], f'stroke="{drawing.RED}" stroke-width="2.2"'))
    return parts


masks = {c["name"]: (c["first"], c["mask"]) for c in json.loads(drawing.run(LIMES, "schemes", "--json"))["curves"]}
check_boxes(masks)
for scheme, _ in PANELS:
    check(scheme, masks[scheme])

parts = bases(masks["lane-riesenfeld:3"], GAP, GAP, 2 * WIDTH + GAP)
below = GAP + 272
for i, (scheme, title) in enumerate(PANELS):
    parts += sum_of_copies(scheme, title, masks[scheme], GAP + i % 2 * (WIDTH + GAP), below + i // 2 * (HEIGHT + GAP))
below += 2 * (HEIGHT + GAP)
parts += box(GAP, below)
notes = ["Red: the limit function of one control point. Blue:", "copies of half the width, heights from the mask; red is",
         "their sum.", "The linear B-spline is the shadow of a square: how", "long the vertical chords are. Of its four quarters 1, 2",
         "and 1 have the same shadow: the mask (1 2 1)/2."]
for k, note in enumerate(notes):
    parts.append(drawing.text(2 * GAP + WIDTH, below + 90 + 18 * k, note, 12, drawing.GREY))
drawing.write(OUT, 2 * WIDTH + 3 * GAP, below + 280, parts)
