#!/usr/bin/env python3
"""Draws basis-functions.svg: the functions of catmull-clark on each kind of patch, and cubic B-splines with their
boundary functions.

Usage: basis_functions.py LIMES OUT.svg      LIMES is the program; all values come from `limes evaluate`.

The script fails if the functions of a patch do not add up to 1, or if those of the boundary are not the combinations of
B-splines that [barendrecht_2013] section 6 gives.
"""
import math
import pathlib
import sys
import tempfile

import drawing

LIMES, OUT = sys.argv[1], sys.argv[2]
ALONG, ACROSS = 25, 7  # samples of a patch: along the curves that are drawn, and curves
STRIDE = 3  # of the samples along a curve, in small graphs
WIDTH = 800


def grid(columns, rows, face):
    """A net of squares. face: the one that is the patch, (column, row)."""
    places = [(i, j) for j in range(rows + 1) for i in range(columns + 1)]
    number = lambda i, j: j * (columns + 1) + i
    faces = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1))
             for j in range(rows) for i in range(columns)]
    return places, faces, face[1] * columns + face[0]


def extraordinary(n):
    """The net around the patch between a vertex of valence n, its corner 0, and three regular ones."""
    e = lambda i: (math.cos(math.radians(45) + (i - 0.5) * 2 * math.pi / n),
                   math.sin(math.radians(45) + (i - 0.5) * 2 * math.pi / n))
    places, index = [], {}

    def vertex(*steps):
        """The sum of spokes: (i, j) is one step along spoke i and one along spoke j."""
        key = tuple(sorted(i % n for i in steps))
        if key not in index:
            index[key] = len(places)
            places.append((sum(e(i)[0] for i in steps), sum(e(i)[1] for i in steps)))
        return index[key]

    faces = [(vertex(), vertex(i), vertex(i, i + 1), vertex(i + 1)) for i in range(n)]
    faces += [(vertex(0), vertex(-1, 0), vertex(-1, 0, 0), vertex(0, 0)),
              (vertex(0), vertex(0, 0), vertex(0, 0, 1), vertex(0, 1)),
              (vertex(0, 1), vertex(0, 0, 1), vertex(0, 0, 1, 1), vertex(0, 1, 1)),
              (vertex(1), vertex(0, 1), vertex(0, 1, 1), vertex(1, 1)),
              (vertex(1), vertex(1, 1), vertex(1, 1, 2), vertex(1, 2))]
    return places, faces, 0


def functions(net):
    """z of the limit surface where one control point has z = 1, the others 0: functions[point][v][u]. All in one mesh,
    a copy of the net for each control point."""
    places, faces, patch = net
    n = len(places)
    with tempfile.TemporaryDirectory() as folder:
        mesh, asked, answer = (pathlib.Path(folder) / name for name in ("net.obj", "at.csv", "values.csv"))
        lines = [f"v {x} {y} {int(i == one)}" for one in range(n) for i, (x, y) in enumerate(places)]
        lines += ["f " + " ".join(str(one * n + i + 1) for i in face) for one in range(n) for face in faces]
        mesh.write_text("\n".join(lines) + "\n")
        at = [f"{one * len(faces) + patch},0,{u / (ALONG - 1)!r},{v / (ACROSS - 1)!r}"
              for one in range(n) for v in range(ACROSS) for u in range(ALONG)]
        asked.write_text("face,corner,u,v\n" + "\n".join(at) + "\n")
        drawing.run(LIMES, "evaluate", mesh, "--scheme", "catmull-clark", "--boundary", "edges-and-corners",
                    "--at", asked, "-o", answer)
        z = [float(line.split(",")[2]) for line in answer.read_text().splitlines()[1:]]
    rows = [z[k:k + ALONG] for k in range(0, len(z), ALONG)]
    result = [rows[k:k + ACROSS] for k in range(0, len(rows), ACROSS)]
    for v in range(ACROSS):
        for u in range(ALONG):
            total = sum(f[v][u] for f in result)
            if abs(total - 1) > 1e-13:
                sys.exit(f"{n} functions add up to {total!r} at sample {u}, {v}")
    return result


def along_u(values, columns):
    """Functions of one variable: those of a column of control points add up to the function of the column."""
    rows = len(values) // columns
    return [[sum(values[j * columns + i][0][u] for j in range(rows)) for u in range(ALONG)] for i in range(columns)]


def compare_with_boundary_matrix(regular, boundary):
    """B_b = C^T B_r with the matrix printed in [barendrecht_2013], section 6."""
    transposed = [(2, 1, 0, 0), (-1, 0, 1, 0), (0, 0, 0, 1)]
    for row, function in zip(transposed, boundary):
        for u, value in enumerate(function):
            expected = sum(c * f[u] for c, f in zip(row, regular))
            if abs(value - expected) > 1e-14:
                sys.exit(f"boundary function at sample {u}: {value!r}, by the paper {expected!r}")


def plot(curves, names, title, x0, y0, width=330, height=120):
    place = lambda u, y: (x0 + u * width, y0 + height * (1 - y))
    parts = [drawing.text(x0, y0 - 14, title, 14, weight="bold"),
             drawing.polyline([place(0, 0), place(1, 0)], f'stroke="{drawing.GREY}"'),
             drawing.text(*place(0, -0.13), "0", 10, drawing.GREY, "middle"),
             drawing.text(*place(1, -0.13), "u = 1", 10, drawing.GREY, "middle")]
    for y in (1 / 6, 2 / 3, 1):
        parts.append(drawing.polyline([place(0, y), place(1, y)], f'stroke="{drawing.LIGHT}"'))
    for y, name in ((1 / 6, "1/6"), (2 / 3, "2/3"), (1, "1")):
        parts.append(drawing.text(x0 - 6, place(0, y)[1] + 4, name, 10, drawing.GREY, "end"))
    for curve, name, colour in zip(curves, names, ("#1f5fa8", "#c8452f", "#2e8540", "#8250a0")):
        points = [place(u / (ALONG - 1), y) for u, y in enumerate(curve)]
        parts.append(drawing.polyline(points, f'fill="none" stroke="{colour}" stroke-width="1.8"'))
        peak = max(range(ALONG), key=lambda u: curve[u])
        shift = 18 if peak == 0 else -18 if peak == ALONG - 1 else 0
        x, y = points[peak][0] + shift, points[peak][1]
        up = 14 if curve[peak] < 0.5 else 6
        parts.append(drawing.text(x + shift * (curve[peak] == 1), y - up * (curve[peak] != 1) + 4, name, 11, colour,
                                  "middle"))
    return parts


def surface(values, x, y, colour):
    """The graph of a function over the patch, seen from the front: curves v = const, those in front hide the others."""
    wide, back, slant, high = 46, 24, 18, 68
    place = lambda u, v, z: (x + wide * u + slant * v - (wide + slant) / 2, y - back * v - high * z)
    parts = [drawing.polyline([place(0, 0, 0), place(1, 0, 0), place(1, 1, 0), place(0, 1, 0)],
                              f'fill="#f3f5f8" stroke="{drawing.LIGHT}"', closed=True)]
    moves = lambda lines: " ".join("M" + " ".join(f"{x:.1f},{y:.1f}" for x, y in line) for line in lines)
    parts.append(f'<g fill="none" stroke="{colour}">')
    behind = None
    for row in reversed(range(ACROSS)):
        v = row / (ACROSS - 1)
        curve = [place(u / (ALONG - 1), v, values[row][u]) for u in range(0, ALONG, STRIDE)]
        lines = [curve] + ([[a, b] for a, b in zip(behind[::2], curve[::2])] if behind else [])
        skirt = [place(1, v, 0), place(0, v, 0)]
        parts.append(f'<path fill="#fff" fill-opacity="0.72" stroke="none" d="{moves([curve + skirt])}"/>'
                     f'<path d="{moves(lines)}"/>')
        behind = curve
    return parts + ["</g>"]


def panel(title, net, values, left, bottom, unit, inside):
    """Every graph stands where its control point is; those at the corners of the patch are red."""
    places, faces, patch = net
    parts = []
    at = lambda place: (left + unit[0] * place[0], bottom - unit[1] * place[1])
    for face in faces:
        parts.append(drawing.polyline([at(places[i]) for i in face], 'fill="none" stroke="#e6e9ee"', closed=True))
    for i in sorted(range(len(places)), key=lambda i: -places[i][1]):
        parts += surface(values[i], *at(places[i]), drawing.RED if i in faces[patch] else drawing.BLUE)
    return parts + [drawing.text(*inside, title, 14, weight="bold")]


nets = {"interior": grid(3, 3, (1, 1)), "boundary": grid(3, 2, (1, 0)), "side": grid(2, 3, (0, 1)),
        "corner": grid(2, 2, (0, 0)), "valence 5": extraordinary(5)}
values = {kind: functions(net) for kind, net in nets.items()}
regular, boundary = along_u(values["interior"], 4), along_u(values["side"], 3)
compare_with_boundary_matrix(regular, boundary)
parts = plot(regular, ["B₁", "B₂", "B₃", "B₄"], "cubic B-splines on one interval", 50, 50)
parts += plot(boundary, ["B₁", "B₂", "B₃"], "at a boundary, u = 0", 445, 50)
square = (88, 86)
count = lambda kind: len(values[kind])
parts += panel(f"interior patch: {count('interior')} functions", nets["interior"], values["interior"], 80, 580, square,
               (40, 240))
parts += panel(f"patch at a boundary (below): {count('boundary')} functions", nets["boundary"], values["boundary"], 470,
               580, square, (430, 240))
parts += panel(f"patch at a corner: {count('corner')} functions", nets["corner"], values["corner"], 80, 880, square,
               (40, 650))
parts += panel(f"patch at a vertex of valence 5: {count('valence 5')} functions", nets["valence 5"],
               values["valence 5"], 510, 970, (92, 92), (430, 650))
parts.append(drawing.text(40, 1150, "Each graph stands where its control point is; red: corners of the patch. "
                          "Curves v = const, u to the right, v to the back.", 12, drawing.GREY))
drawing.write(OUT, WIDTH, 1166, parts)
