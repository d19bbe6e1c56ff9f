"""Runs a file of MoorDyn along a table of motion, and prints the tensions of all lines.

    python march.py FILE TABLE EVERY

The table has a row for each step: the time in s and the coordinates of every coupled point in m. A row is printed for one of EVERY
steps: the time and FairTen of each line in N. MoorDyn's own messages go to standard error.
"""

import os
import sys


def main():
    path, table, every = sys.argv[1], sys.argv[2], int(sys.argv[3])
    rows = [[float(word) for word in line.split()] for line in open(table)]
    # The library writes its messages to standard output.
    printed = os.dup(1)
    os.dup2(2, 1)
    import moordyn

    system = moordyn.Create(path)
    first = rows[0][1:]
    assert moordyn.NCoupledDOF(system) == len(first), moordyn.NCoupledDOF(system)
    assert moordyn.Init(system, first, [0.0] * len(first)) == 0
    lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
    out = os.fdopen(printed, "w")
    for step, (now, then) in enumerate(zip(rows, rows[1:])):
        if step % every == 0:
            tensions = [moordyn.GetLineFairTen(line) for line in lines]
            print(*map(repr, [now[0], *tensions]), file=out)
        length = then[0] - now[0]
        speed = [(b - a) / length for a, b in zip(now[1:], then[1:])]
        moordyn.Step(system, now[1:], speed, now[0], length)
    moordyn.Close(system)


main()
