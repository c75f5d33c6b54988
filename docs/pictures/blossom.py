#!/usr/bin/env python3
"""Draws blossom.svg: control points of B-splines and of one refinement, labelled by the arguments of the polar form.

Usage: blossom.py LIMES OUT.svg      LIMES is the program; refined points and curves come from it.

Labels are computed from the knots. Every refined point is compared with the polar form at its label; the script fails
where they differ.
"""
import math
import pathlib
import sys
import tempfile
from fractions import Fraction

import drawing

LIMES, OUT = sys.argv[1], sys.argv[2]
POLYGON = [(0.2, 0.3), (0.0, 2.4), (2.3, 3.3), (4.0, 0.5), (6.2, 0.2), (7.2, 2.9), (9.4, 2.2)]
WIDTH, HEIGHT, UNIT, GAP = 760, 300, 66, 40


def knots(degree, index, width):
    """The arguments of control point `index` where knots are `width` apart: in their middle lies the point's own place,
    index * width for odd degrees, half a knot further on for even ones. Open polygons of even degree lose the points
    of the refined one that need something beyond the ends."""
    lost = 0 if degree % 2 else degree // 2 if width < 1 else 0
    first = index + lost - (degree - 1) // 2
    return [first * width + k * width for k in range(degree)]


def polar_form(degree, points, arguments):
    """De Boor's recursion with one argument per step [ramshaw_1987]; points maps the first knot to a control point."""
    domain = min(points) + degree - 1, max(points) - 1  # first knots of the pieces that have all their control points
    piece = min(max(math.floor(arguments[degree // 2]), domain[0]), domain[1])
    d = [points[piece - degree + 1 + k] for k in range(degree + 1)]
    for r, argument in enumerate(arguments):
        for k in range(degree, r, -1):
            first = piece - degree + k
            share = float((argument - first) / (degree - r))
            d[k] = [(1 - share) * a + share * b for a, b in zip(d[k - 1], d[k])]
    return d[degree]


def refined(scheme, levels):
    with tempfile.TemporaryDirectory() as folder:
        polygon, curve = pathlib.Path(folder) / "p.obj", pathlib.Path(folder) / "c.obj"
        lines = [f"v {x} {y} 0\n" for x, y in POLYGON]
        polygon.write_text("".join(lines) + "l " + " ".join(str(i + 1) for i in range(len(POLYGON))) + "\n")
        drawing.run(LIMES, "refine", polygon, "-o", curve, "--scheme", scheme, "--levels", levels)
        return [(x, y) for x, y, _ in drawing.points_of(curve)]


def check(degree, fine):
    """Refined points are values of the polar form at their labels."""
    points = {knots(degree, i, Fraction(1))[0]: p for i, p in enumerate(POLYGON)}
    if degree % 2:  # beyond an end the polygon is reflected
        n = len(POLYGON)
        for k in range(1, degree):
            mirror = lambda end, inside: tuple(2 * a - b for a, b in zip(POLYGON[end], POLYGON[inside]))
            points[knots(degree, -k, Fraction(1))[0]] = mirror(0, k)
            points[knots(degree, n - 1 + k, Fraction(1))[0]] = mirror(n - 1, n - 1 - k)
    for j, point in enumerate(fine):
        value = polar_form(degree, points, knots(degree, j, Fraction(1, 2)))
        if math.dist(point, value) > 1e-12:
            sys.exit(f"degree {degree}: point {j} is {point}, the polar form there is {value}")


def label(arguments):
    def number(x):
        whole = math.floor(x)
        half = "½" if x != whole else ""
        sign = "−" if x < 0 else ""
        size = abs(x)
        whole = math.floor(size)
        return sign + (f"{whole}" if whole or not half else "") + half
    return " ".join(number(x) for x in arguments)


def labels(points, degree, width, side, size, colour, place):
    """Beside their points. side(i): 1 where the polygon bends to, -1 within the bend."""
    parts = []
    for i, (x, y) in enumerate(points):
        before, after = points[max(i - 1, 0)], points[min(i + 1, len(points) - 1)]
        dx, dy = after[0] - before[0], after[1] - before[1]
        bend = dx * (y - before[1]) - dy * (x - before[0])
        away = side(i)
        outward = away if bend >= 0 else -away
        length = math.hypot(dx, dy)
        px, py = place(x, y)
        nx, ny = -dy / length * outward, dx / length * outward
        anchor = "start" if nx > 0.35 else "end" if nx < -0.35 else "middle"
        reach = size + 2
        parts.append(drawing.text(px + nx * reach * 0.8, py - ny * reach + size * 0.35,
                                  label(knots(degree, i, width)), size, colour, anchor))
        parts.append(drawing.dot(px, py, 3.2 if size > 12 else 2.4, colour))
    return parts


def panel(scheme, title, degree, top):
    fine, limit = refined(scheme, 1), refined(scheme, 6)
    check(degree, fine)
    place = lambda x, y: (70 + UNIT * x, top + HEIGHT - 40 - UNIT * y)
    line = lambda points, style: drawing.polyline([place(*p) for p in points], f'fill="none" {style}')
    on_an_edge = lambda i: degree % 2 == 0 or i % 2  # labels stand outside there, else within the bend
    return [line(limit, f'stroke="{drawing.RED}" stroke-width="2.2"'),
            line(POLYGON, f'stroke="{drawing.INK}" stroke-width="1.2"'),
            line(fine, f'stroke="{drawing.BLUE}" stroke-width="1"'),
            *labels(POLYGON, degree, Fraction(1), lambda i: 1, 14, drawing.INK, place),
            *labels(fine, degree, Fraction(1, 2), lambda i: 1 if on_an_edge(i) else -1, 10.5, drawing.BLUE, place),
            drawing.text(GAP / 2, top + 18, title, 14, weight="bold")]


parts = panel("lane-riesenfeld:3", "degree 3 (lane-riesenfeld:3)", 3, 10)
parts += panel("chaikin", "degree 2 (chaikin)", 2, HEIGHT + 30)
parts.append(drawing.text(GAP / 2, 2 * HEIGHT + 52, "Black: control points; blue: after one step; red: the limit. "
                          "Labels: arguments of the polar form, knots at whole numbers.", 12, drawing.GREY))
drawing.write(OUT, WIDTH, 2 * HEIGHT + 64, parts)
