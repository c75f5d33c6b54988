#!/usr/bin/env python3
"""Writes the start meshes of shell problems into this folder.

hole_5.obj, hole_2_5.obj: a quarter of the Scordelis-Lo roof (radius 25, length 50, 40 degrees) with a hole
that is a circle of radius 5 or 2.5 on the developed surface. 4 quads from the hole outwards, 8 around.
hole_5_2x4.obj: the first with 2 and 4.

cylinder_plate_3.obj, cylinder_plate_6.obj: a cylinder of radius 3 or 6 that leaves a square plate of width
15 or 30 at 45 degrees, two parts with vertices of their own on the ellipse that they share. The plate has its
four corners and eight nodes on the ellipse. cylinder_plate_6_quads.obj: the same all of quads, for the scheme
kobbelt; the plate has the middles of its sides as well.

i_beam.obj: a beam of length 20 whose section is an I: two flanges of width 1 and a web of height 2. The web
shares its upper and lower vertices with the flanges: edges of three faces. 20 quads along.

twisted_beam.obj: a strip of length 12 and width 1.1, twisted by 90 degrees about its axis. 12 quads along, 2 across.
twisted_beam_zigzag.obj: the same with inner nodes moved by a quarter of a quad to and fro, along and across.
"""
import math
import pathlib

HERE = pathlib.Path(__file__).resolve().parent


def write(name, title, parts):
    lines, count = [f"# {title}; made by make_shells.py."], 0
    for part, points, faces in parts:
        if part:
            lines.append(f"o {part}")
        lines += ["v " + " ".join(repr(c + 0.0) for c in p) for p in points]
        lines += ["f " + " ".join(str(count + v + 1) for v in f) for f in faces]
        count += len(points)
    (HERE / name).write_text("\n".join(lines) + "\n")


def hole(a, rows=4, around=8):
    R, S, H = 25.0, 25.0 * math.radians(40), 25.0
    points, faces = [], []
    for j in range(rows + 1):
        for i in range(around + 1):
            u, v = i / around, j / rows
            h = (a * math.cos(u * math.pi / 2), a * math.sin(u * math.pi / 2))
            o = (S, 2 * u * H) if u <= 0.5 else (2 * (1 - u) * S, H)
            s, y = ((1 - v) * h[k] + v * o[k] for k in range(2))
            s = 0.0 if i == around else s
            y = 0.0 if i == 0 else y
            points.append((R * math.sin(s / R), y, R * math.cos(s / R)))
    n = around + 1
    for j in range(rows):
        for i in range(around):
            k = n * j + i
            faces.append((k, k + 1, k + n + 1, k + n)[::-1])
    return points, faces


def cylinder_plate(r, w, quads=False, length=10.0, rows=4):
    n, q = 8, math.sqrt(0.5)
    angle = [math.radians((0 if quads else 22.5) + 45 * i) for i in range(n)]
    points, faces = [], []
    for j in range(rows + 1):
        for p in angle:
            c, s = r * math.cos(p), r * math.sin(p)
            z = c + (length - c) * j / rows
            points.append((q * (c + z), s, 0.0 if j == 0 else q * (z - c)))
    for j in range(rows):
        for i in range(n):
            k = (i + 1) % n
            faces.append((j * n + i, j * n + k, (j + 1) * n + k, (j + 1) * n + i))
    b = w / 2
    corners = [(b, b, 0.0), (-b, b, 0.0), (-b, -b, 0.0), (b, -b, 0.0)]
    ellipse = points[:n]
    plate = []
    if quads:
        outer = [(b, 0.0, 0.0), corners[0], (0.0, b, 0.0), corners[1],
                 (-b, 0.0, 0.0), corners[2], (0.0, -b, 0.0), corners[3]]
        plate = [(i, n + i, n + (i + 1) % n, (i + 1) % n) for i in range(n)]
        return [("cylinder", points, faces), ("plate", ellipse + outer, plate)]
    for i in range(4):  # at corner i the ellipse's nodes 2 i, 2 i + 1
        plate.append((2 * i + 1, 2 * i, 8 + i))
        k = (i + 1) % 4
        plate.append((2 * k, 2 * i + 1, 8 + i, 8 + k))
    return [("cylinder", points, faces), ("plate", ellipse + corners, plate)]


def twisted_beam(zigzag, length=12.0, width=1.1, along=12, across=2):
    points, faces = [], []
    for i in range(along + 1):
        for j in range(across + 1):
            inner = 0 < i < along and 0 < j < across
            p = i + (zigzag * (-1) ** (i + j) if inner else 0)
            q = j + (zigzag * (-1) ** i if inner else 0)
            turn, d = math.pi / 2 * p / along, width * (q / across - 0.5)
            c, s = (1.0, 0.0) if i == 0 else (0.0, 1.0) if i == along else (math.cos(turn), math.sin(turn))
            points.append((length * p / along, d * c, d * s))
    n = across + 1
    for i in range(along):
        for j in range(across):
            k = n * i + j
            faces.append((k, k + n, k + n + 1, k + 1))
    return points, faces


def i_beam(length=20, width=1.0, height=2.0):
    b, h = width / 2, height / 2
    section = [(-b, -h), (0.0, -h), (b, -h), (0.0, 0.0), (-b, h), (0.0, h), (b, h)]
    strips = [(0, 1), (1, 2), (1, 3), (3, 5), (4, 5), (5, 6)]
    n = len(section)
    points = [(float(i), *p) for i in range(length + 1) for p in section]
    faces = [(n * i + p, n * i + q, n * i + n + q, n * i + n + p)
             for i in range(length) for p, q in strips]
    return points, faces


for a, name in ((5.0, "hole_5.obj"), (2.5, "hole_2_5.obj")):
    write(name, f"A quarter of a roof with a hole of radius {a}", [(None, *hole(a))])
write("hole_5_2x4.obj", "A quarter of a roof with a hole of radius 5.0", [(None, *hole(5.0, 2, 4))])
for r, w in ((3.0, 15.0), (6.0, 30.0)):
    write(f"cylinder_plate_{r:.0f}.obj", f"A cylinder of radius {r} on a plate of width {w}",
          cylinder_plate(r, w))
write("cylinder_plate_6_quads.obj", "A cylinder of radius 6 on a plate of width 30",
      cylinder_plate(6.0, 30.0, quads=True))
write("i_beam.obj", "A beam whose section is an I, the web on the flanges' vertices", [(None, *i_beam())])
for zigzag, name in ((0, "twisted_beam.obj"), (0.25, "twisted_beam_zigzag.obj")):
    write(name, "A strip of 12 by 1.1, twisted by 90 degrees", [(None, *twisted_beam(zigzag))])
