"""Finds the rest of a file of points and lines by MoorPy.

    python bridles.py FILE TOLERANCE

Rows of the file are `point free|fixed X Y Z MASS` and `line A B LENGTH`, with points counted from 1, in m and kg; the first row is
`line_type DIAMETER MASS EA`. Where free points rest is printed in m, a row each. The last line is `inside` and the CPU time in s of
`initialize` and `solveEquilibrium`.
"""

import math
import os
import sys
import time

import moorpy

DENSITY, GRAVITY = 1025.0, 9.80665


def line_type(diameter, mass, ea):
    weight = (mass - 0.25 * math.pi * diameter**2 * DENSITY) * GRAVITY
    given = {"name": "wire", "material": "wire", "d_vol": diameter, "d_nom": diameter, "m": mass, "EA": ea, "w": weight}
    unused = ("MBL", "EAd", "EAd_Lm", "BA", "EI", "Cd", "Ca", "CdAx", "CaAx", "cost")
    return given | dict.fromkeys(unused, 0.0)


def main():
    path, tolerance = sys.argv[1], float(sys.argv[2])
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    system = moorpy.System(depth=1000.0, rho=DENSITY, g=GRAVITY)
    for line in open(path):
        kind, *words = line.split()
        if kind == "line_type":
            system.lineTypes["wire"] = line_type(*map(float, words))
        elif kind == "point":
            x, y, z, mass = map(float, words[1:])
            system.addPoint(0 if words[0] == "free" else 1, [x, y, z], m=mass)
        else:
            system.addLine(float(words[2]), "wire", pointA=int(words[0]), pointB=int(words[1]))
    begun = time.process_time()
    system.initialize()
    assert system.solveEquilibrium(tol=tolerance)
    spent = time.process_time() - begun
    for point in system.pointList:
        if point.type == 0:
            print(*map(float, point.r), file=out)
    print("inside", spent, file=out)


main()
