#!/usr/bin/env python3
"""Writes the meshes ironing_block*.msh: the block of the shallow ironing problem.

Fischer & Wriggers 2006, dimensions after Yastrebov, in mm: x = 0.2 ... 1.4, top at
y = 5.4, foot an arc of radius 0.75 through (0.8, 4.2) with corners at y = 4.5. A
structured mesh of NX by NY cells, in metres. With `surface' the sides of the block
belong to its foot, for slabs that fold up along them.

    python3 ironing_block.py 12 12 > ironing_block.msh
    python3 ironing_block.py 12 6 surface > ironing_block_surface.msh
    python3 ironing_block.py 18 9 surface > ironing_block_surface_fine.msh
"""
import math
import sys

nx, ny = int(sys.argv[1]), int(sys.argv[2])
surface = sys.argv[3:] == ["surface"]
if sys.argv[3:] and not surface:
    sys.exit("usage: ironing_block.py NX NY [surface]")


def foot(x):
    return 4.95 - math.sqrt(0.75**2 - (x - 0.8) ** 2)


def number(i, j):
    return 1 + i + j * (nx + 1)


print("$MeshFormat\n2.2 0 8\n$EndMeshFormat")
if surface:
    right = left = 1
    print('$PhysicalNames\n3\n1 1 "foot"\n1 3 "top"\n2 5 "block"\n$EndPhysicalNames')
else:
    right, left = 2, 4
    print('$PhysicalNames\n5\n1 1 "foot"\n1 2 "right"\n1 3 "top"\n1 4 "left"\n2 5 "block"\n$EndPhysicalNames')
print("$Nodes\n%d" % ((nx + 1) * (ny + 1)))
for j in range(ny + 1):
    for i in range(nx + 1):
        x = 0.2 + 1.2 * i / nx
        y = foot(x) + (5.4 - foot(x)) * j / ny
        print("%d %.15g %.15g 0" % (number(i, j), 1e-3 * x, 1e-3 * y))
print("$EndNodes")
lines = [(1, number(i, 0), number(i + 1, 0)) for i in range(nx)]
lines += [(3, number(i + 1, ny), number(i, ny)) for i in range(nx)]
lines += [(right, number(nx, j), number(nx, j + 1)) for j in range(ny)]
lines += [(left, number(0, j + 1), number(0, j)) for j in range(ny)]
print("$Elements\n%d" % (len(lines) + nx * ny))
e = 0
for group, a, b in lines:
    e += 1
    print("%d 1 2 %d %d %d %d" % (e, group, group, a, b))
for j in range(ny):
    for i in range(nx):
        e += 1
        print("%d 3 2 5 5 %d %d %d %d" % (e, number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)))
print("$EndElements")
