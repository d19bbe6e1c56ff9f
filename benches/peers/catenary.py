"""Solves a line from an anchor on the bed by MoorPy for many places of its fairlead.

    python catenary.py LENGTH EA WEIGHT TOLERANCE PLACES PRINT

PLACES has the horizontal and the vertical distance in m on each row. With PRINT 1 the horizontal and vertical forces at the fairlead are
printed in N. The last line is `inside` and the CPU time in s of the calls alone.
"""

import sys
import time

from moorpy.Catenary import catenary


def main():
    length, ea, weight, tolerance = map(float, sys.argv[1:5])
    places = [tuple(map(float, line.split())) for line in open(sys.argv[5])]
    begun = time.process_time()
    forces = [catenary(x, z, length, ea, weight, CB=0.0, Tol=tolerance)[2:4] for x, z in places]
    spent = time.process_time() - begun
    if sys.argv[6] == "1":
        for horizontal, vertical in forces:
            print(abs(float(horizontal)), abs(float(vertical)))
    print("inside", spent)


main()
