"""Opens what limes writes with VTK itself and compares with `limes evaluate`.

Usage: open_with_vtk.py PROGRAM DATA        exit code 1 and a traceback when something differs
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

LAGRANGE, BEZIER = 70, 77  # VTK_LAGRANGE_QUADRILATERAL, VTK_BEZIER_QUADRILATERAL
LAGRANGE_TRIANGLE, BEZIER_TRIANGLE = 69, 76
SAMPLES = [(0.5, 0.5), (0.25, 0.75), (0.9, 0.2), (0.0, 0.4)]

program, data = sys.argv[1], Path(sys.argv[2])
folder = tempfile.TemporaryDirectory()  # vanishes at the end
out = Path(folder.name)


def limes(*arguments):
    subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def opened(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()


def evaluate(mesh, points, scheme="catmull-clark"):
    """Positions at (face, u, v) of quads, or of triangles with loop."""
    table = out / "points.csv"
    table.write_text("face,corner,u,v\n" + "".join(f"{f},0,{u},{v}\n" for f, u, v in points))
    values = out / "values.csv"
    limes("evaluate", mesh, "--scheme", scheme, "--at", table, "-o", values)
    with open(values) as rows:
        return [tuple(float(row[c]) for c in "xyz") for row in csv.DictReader(rows)]


def location(grid, cell, u, v):
    """Point of a cell as VTK evaluates it, and the weights of the cell's points there."""
    x, weights = [0.0] * 3, [0.0] * grid.GetCell(cell).GetNumberOfPoints()
    grid.GetCell(cell).EvaluateLocation(mutable(0), [u, v, 0.0], x, weights)
    return x, weights


def interpolated(grid, name, cell, u, v):
    weights = location(grid, cell, u, v)[1]
    array, ids = grid.GetPointData().GetArray(name), grid.GetCell(cell).GetPointIds()
    values = [array.GetTuple(ids.GetId(i)) for i in range(len(weights))]
    return [sum(w * v[k] for w, v in zip(weights, values)) for k in range(len(values[0]))]


def expect_near(a, b, tolerance, what):
    assert math.dist(a, b) <= tolerance, f"{what}: {a} is not {b}"


def expect_arrays(section, names):
    assert [section.GetArrayName(i) for i in range(section.GetNumberOfArrays())] == names


def expect_finite(grid, name):
    array = grid.GetPointData().GetArray(name)
    for i in range(array.GetNumberOfTuples()):
        assert all(map(math.isfinite, array.GetTuple(i))), f"{name} of point {i}"


def cells_of_faces(grid):
    cells = {}
    for cell in range(grid.GetNumberOfCells()):
        assert grid.GetCell(cell).GetNumberOfPoints() == 16
        cells.setdefault(int(grid.GetCellData().GetArray("face").GetTuple1(cell)), []).append(cell)
    return cells


def expect_whole_faces(grid, mesh, tolerance):
    """Faces that are one cell are where `limes evaluate` says."""
    single = {f: cells[0] for f, cells in cells_of_faces(grid).items() if len(cells) == 1}
    points = [(f, u, v) for f in single for u, v in SAMPLES]
    for (f, u, v), x in zip(points, evaluate(mesh, points)):
        expect_near(location(grid, single[f], u, v)[0], x, tolerance, f"face {f} at {u}, {v}")
    return len(single)


def limit_of_torus():
    mesh = data / "torus.obj"
    for name, kind in ("lagrange", LAGRANGE), ("bezier", BEZIER):
        limes("limit", mesh, "-o", out / "torus.vtu", "--scheme", "catmull-clark", "--cells", name)
        grid = opened(out / "torus.vtu")
        faces = sum(line.startswith("f ") for line in mesh.read_text().splitlines())
        assert grid.GetNumberOfCells() == faces
        assert all(grid.GetCellType(i) == kind for i in range(faces))
        expect_arrays(grid.GetPointData(), ["normal", "mean_curvature", "gauss_curvature"])
        expect_arrays(grid.GetCellData(), ["face", "corner"])
        for array in "normal", "mean_curvature", "gauss_curvature":
            expect_finite(grid, array)
        assert expect_whole_faces(grid, mesh, 1e-12) == faces


def limit_of_cube():
    """All vertices extraordinary: where a cell lies in its face is told by its corners."""
    mesh, levels, tolerance = data / "cube.obj", 5, 1e-3
    n = 2**levels
    dyadic = [(i / n, j / n) for i in range(n + 1) for j in range(n + 1)]
    position = evaluate(mesh, [(0, u, v) for u, v in dyadic])
    limes("limit", mesh, "-o", out / "cube.vtu", "--scheme", "catmull-clark", "--tolerance", tolerance)
    limes("limit", mesh, "-o", out / "bezier.vtu", "--scheme", "catmull-clark", "--tolerance", tolerance,
          "--cells", "bezier")
    lagrange, bezier = opened(out / "cube.vtu"), opened(out / "bezier.vtu")
    assert lagrange.GetNumberOfCells() == bezier.GetNumberOfCells() > 6
    for cell in range(lagrange.GetNumberOfCells()):
        for u, v in SAMPLES:
            expect_near(location(lagrange, cell, u, v)[0], location(bezier, cell, u, v)[0], 1e-13, cell)
    cells, points = cells_of_faces(lagrange)[0], []
    for cell in cells:
        corners = []
        for u, v in (0, 0), (1, 1):
            x = location(lagrange, cell, u, v)[0]
            i = min(range(len(position)), key=lambda k: math.dist(x, position[k]))
            expect_near(x, position[i], 1e-9, f"corner of cell {cell}")
            corners.append(dyadic[i])
        points.append((0, *(0.5 * (a + b) for a, b in zip(*corners))))
    errors = [math.dist(location(lagrange, cell, 0.5, 0.5)[0], x)
              for cell, x in zip(cells, evaluate(mesh, points))]
    assert max(errors) < tolerance * 2 * math.sqrt(3)  # of the diagonal of [-1, 1]^3
    assert sum(e < 1e-12 for e in errors) == len(cells) - 4  # all but those at the corners


def triangulated_torus(columns=7, lines=6):
    """All vertices of valence 6."""
    points, faces = [], []
    for i in range(columns):
        for j in range(lines):
            a, b = 2 * math.pi * i / columns, 2 * math.pi * j / lines
            r = 3 + math.cos(b) + 0.1 * math.sin(5 * i + 3 * j)
            points.append((r * math.cos(a), r * math.sin(a), math.sin(b)))
            right, up = (i + 1) % columns * lines, (j + 1) % lines
            v = i * lines + j, right + j, right + up, i * lines + up
            faces += [(v[0], v[1], v[2]), (v[0], v[2], v[3])]
    file = out / "triangles.obj"
    file.write_text("".join("v %r %r %r\n" % p for p in points)
                    + "".join("f %d %d %d\n" % tuple(k + 1 for k in f) for f in faces))
    return file, len(faces)


def limit_of_triangles():
    mesh, faces = triangulated_torus()
    places = [(0.2, 0.3), (0.5, 0.5), (0.0, 0.4), (0.1, 0.85)]
    samples = [(face, u, v) for face in range(faces) for u, v in places]
    expected = evaluate(mesh, samples, "loop")
    for name, kind in ("lagrange", LAGRANGE_TRIANGLE), ("bezier", BEZIER_TRIANGLE):
        limes("limit", mesh, "-o", out / "triangles.vtu", "--scheme", "loop", "--cells", name)
        grid = opened(out / "triangles.vtu")
        assert grid.GetNumberOfCells() == faces
        for (face, u, v), x in zip(samples, expected):
            assert grid.GetCellType(face) == kind
            assert grid.GetCell(face).GetNumberOfPoints() == 15
            expect_near(location(grid, face, u, v)[0], x, 1e-12, f"triangle {face} at {u}, {v}")
        for array in "normal", "mean_curvature", "gauss_curvature":
            expect_finite(grid, array)


def result_of_block():
    problem = data / "block.toml"
    limes("solve", problem, "-o", out / "block")
    grid = opened(out / "block" / "result.vtu")
    assert all(grid.GetCellType(i) == LAGRANGE for i in range(grid.GetNumberOfCells()))
    expect_arrays(grid.GetPointData(), ["displacement", "stress", "strain", "von_mises"])
    expect_arrays(grid.GetCellData(), ["material", "face"])
    for name in "displacement", "stress", "strain", "von_mises":
        expect_finite(grid, name)
    # Refined as levels = 1 of the problem says.
    mesh = out / "block.obj"
    limes("refine", data / "block.obj", "-o", mesh, "--scheme", "catmull-clark", "--levels", 1)
    faces = sum(line.startswith("f ") for line in mesh.read_text().splitlines())
    assert len(cells_of_faces(grid)) == faces
    whole = expect_whole_faces(grid, mesh, 1e-12)
    assert whole > faces / 3  # the others have extraordinary vertices
    expect_continuous(grid, whole)


def expect_continuous(grid, whole):
    """Interpolated displacements of two whole faces agree in the middle of a side they share."""
    middle = {}
    for u, v in (0.5, 0), (0.5, 1), (0, 0.5), (1, 0.5):
        for cells in cells_of_faces(grid).values():
            if len(cells) == 1:
                x = location(grid, cells[0], u, v)[0]
                u_there = interpolated(grid, "displacement", cells[0], u, v)
                middle.setdefault(tuple(round(c, 9) + 0.0 for c in x), []).append(u_there)
    shared = [values for values in middle.values() if len(values) == 2]
    assert len(shared) > whole / 2
    for a, b in shared:
        expect_near(a, b, 1e-9, "displacement of two cells")


limit_of_torus()
limit_of_cube()
limit_of_triangles()
result_of_block()
