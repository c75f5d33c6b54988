#!/usr/bin/env python3
"""Draws two-scale.svg: limit functions of curve schemes as sums of narrower copies of themselves.

Usage: two_scale.py LIMES OUT.svg      LIMES is the program; masks and curves come from it.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

LIMES, OUT = sys.argv[1], sys.argv[2]
PANELS = [("lane-riesenfeld:1", "linear B-spline"), ("chaikin", "quadratic B-spline"),
          ("lane-riesenfeld:3", "cubic B-spline"), ("four-point", "four-point")]
WIDTH, HEIGHT, GAP = 300, 170, 24
REACH = 3.2  # of the functions, in sides of the polygon


def limit_function(scheme):
    """Points (t, value) of the function that belongs to one control point at 0."""
    with tempfile.TemporaryDirectory() as folder:
        polygon = pathlib.Path(folder) / "p.obj"
        curve = pathlib.Path(folder) / "c.obj"
        lines = [f"v {i} {1 if i == 0 else 0} 0\n" for i in range(-6, 7)]
        polygon.write_text("".join(lines) + "l " + " ".join(map(str, range(1, 14))) + "\n")
        subprocess.run([LIMES, "refine", polygon, "-o", curve, "--scheme", scheme, "--levels", "5"],
                       check=True, stdout=subprocess.DEVNULL)
        points = [line.split() for line in curve.read_text().splitlines() if line.startswith("v ")]
    return [(float(x), float(y)) for _, x, y, _ in points if abs(float(x)) <= REACH + 0.01]


def masks():
    curves = json.loads(subprocess.run([LIMES, "schemes", "--json"], check=True,
                                       capture_output=True).stdout)["curves"]
    return {c["name"]: (c["first"], c["mask"]) for c in curves}


def path(points, corner, style):
    x0, y0 = corner
    at = [(x0 + (t + REACH) / (2 * REACH) * WIDTH, y0 + HEIGHT * (0.86 - 0.72 * y)) for t, y in points]
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in at)
    return f'<polyline points="{text}" fill="none" {style}/>'


def panel(scheme, title, mask, corner):
    first, weights = mask
    x0, y0 = corner
    function = limit_function(scheme)
    # New points of a dual scheme lie a quarter of a side beside the old ones.
    offset = 0 if len(weights) % 2 else -0.5
    parts = [path([(-REACH, 0), (REACH, 0)], corner, 'stroke="#d5dae0"')]
    for i, weight in enumerate(weights):
        if weight == 0:
            continue
        shift = first + i + offset
        copy = [((t + shift) / 2, weight * y) for t, y in function if abs(t) <= REACH]
        parts.append(path(copy, corner, 'stroke="#1f5fa8" stroke-width="1.2"'))
        x = x0 + (shift / 2 + REACH) / (2 * REACH) * WIDTH
        parts.append(f'<text x="{x:.1f}" y="{y0 + HEIGHT - 4}" font-size="10" text-anchor="middle" '
                     f'fill="#1f5fa8">{weight:g}</text>')
    parts.append(path(function, corner, 'stroke="#c8452f" stroke-width="2.2"'))
    parts.append(f'<text x="{x0 + 4}" y="{y0 + 16}" font-size="13" font-weight="bold" '
                 f'fill="#1f2328">{title}</text>')
    return "\n".join(parts)


known = masks()
width, height = 2 * WIDTH + 3 * GAP, 2 * HEIGHT + 3 * GAP + 18
svg = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
       f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif">',
       f'<rect width="{width}" height="{height}" fill="#ffffff"/>']
for i, (scheme, title) in enumerate(PANELS):
    corner = (GAP + i % 2 * (WIDTH + GAP), GAP + i // 2 * (HEIGHT + GAP))
    svg.append(panel(scheme, title, known[scheme], corner))
svg.append(f'<text x="{GAP}" y="{height - 12}" font-size="12" fill="#5c6670">Red: the limit function of one '
           'control point. Blue: copies of half the width, heights from the mask; red is their sum.</text></svg>')
pathlib.Path(OUT).write_text("\n".join(svg) + "\n")
