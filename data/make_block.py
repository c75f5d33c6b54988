#!/usr/bin/env python3
"""Writes the two control meshes of the periodic block of material with holes and stiff grains.

block.obj            holes and grains set into a face with a ring of four quads: all extraordinary
                     vertices are inside, boundaries are regular; a grain has a ring of its own, so
                     that its border is a smooth curve of regular vertices
block_cut.obj        the same holes cut out as whole faces: extraordinary vertices on the boundary

usage: make_block.py [FOLDER]      FOLDER default: the script's own
"""
import math
import pathlib
import sys

N = 6                                      # faces along each side of the unit cell
HOLES = {(1, 1): 0.62, (4, 2): 0.5, (2, 4): 0.55}
GRAINS = {(1, 3): 0.6, (4, 4): 0.7, (3, 1): 0.6}


def grid_point(i, j):
    """Inner vertices are moved a little, so that the block does not look ruled."""
    x, y = i / N, j / N
    if 0 < i < N and 0 < j < N:
        x += 0.16 / N * math.sin(2.3 * i + 1.1 * j)
        y += 0.16 / N * math.sin(1.7 * j - 2.9 * i + 0.6)
    return x, y


class Block:
    def __init__(self, cut):
        self.points = [grid_point(i, j) for j in range(N + 1) for i in range(N + 1)]
        self.faces = {'matrix': [], 'grain': []}
        for j in range(N):
            for i in range(N):
                self.add_face(i, j, cut)

    def corners(self, i, j):
        v = j * (N + 1) + i
        return [v, v + 1, v + N + 2, v + N + 1]

    def inset(self, outer, scale):
        """A smaller copy of a face inside it."""
        centre = [sum(self.points[v][k] for v in outer) / 4 for k in (0, 1)]
        inner = []
        for v in outer:
            inner.append(len(self.points))
            self.points.append(tuple(c + scale * (p - c) for c, p in zip(centre, self.points[v])))
        return inner

    def ring(self, group, outer, scale):
        """Four quads between a face and a smaller copy, which is returned."""
        inner = self.inset(outer, scale)
        for k in range(4):
            n = (k + 1) % 4
            self.faces[group].append([outer[k], outer[n], inner[n], inner[k]])
        return inner

    def add_face(self, i, j, cut):
        outer = self.corners(i, j)
        if (i, j) in HOLES and cut:
            return
        scale = HOLES.get((i, j)) or GRAINS.get((i, j))
        if not scale:
            self.faces['matrix'].append(outer)
            return
        border = self.ring('matrix', outer, scale)
        if (i, j) in GRAINS:
            self.faces['grain'].append(self.ring('grain', border, 0.6))

    def write(self, path, what):
        lines = [f'# {what}', '# made by make_block.py; CC0-1.0']
        lines += [f'v {x:.6f} {y:.6f} 0' for x, y in self.points]
        for group, faces in self.faces.items():
            lines.append(f'g {group}')
            lines += ['f ' + ' '.join(str(v + 1) for v in f) for f in faces]
        lines.append('t interpolateboundary 1/0/0 1')
        path.write_text('\n'.join(lines) + '\n')


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    Block(False).write(folder / 'block.obj', 'block of material, holes and grains set into rings')
    Block(True).write(folder / 'block_cut.obj', 'block of material, holes cut out as whole faces')


if __name__ == '__main__':
    main()
