"""What the scripts in this folder share: the program's output, and SVG text."""
import pathlib
import subprocess

INK, GREY, LIGHT, BLUE, RED = "#1f2328", "#5c6670", "#d5dae0", "#1f5fa8", "#c8452f"


def run(program, *arguments):
    """What the program prints."""
    return subprocess.run([program, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def points_of(obj):
    """The vertices of an OBJ file."""
    lines = pathlib.Path(obj).read_text().splitlines()
    return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith("v ")]


def polyline(points, style, closed=False):
    at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<{"polygon" if closed else "polyline"} points="{at}" {style}/>'


def text(x, y, label, size=12, colour=INK, anchor="start", weight="normal"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" text-anchor="{anchor}" '
            f'font-weight="{weight}">{label}</text>')


def dot(x, y, radius, colour):
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>'


def write(file, width, height, parts):
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif">\n'
            f'<rect width="{width}" height="{height}" fill="#ffffff"/>\n')
    pathlib.Path(file).write_text(head + "\n".join(parts) + "\n</svg>\n")
