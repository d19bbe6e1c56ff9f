"""Runs a file of MoorDyn along a table of motion, and prints its tensions.

    python march.py FILE TABLE EVERY

The table has a row for each step: the time in s and the coordinates of every coupled point in m. For one of EVERY steps the time is
printed and the tensions at the outer ends of the first and of the last line in N. MoorDyn has the tensions of segments: those at the ends
are extrapolated from the two nearest. Its own messages go to standard error.
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
    assert moordyn.Init(system, first, [0.0] * len(first)) == 0
    lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
    counts = [moordyn.GetLineNumberNodes(line) for line in lines]
    out = os.fdopen(printed, "w")

    def tension(line, node):
        return sum(part * part for part in moordyn.GetLineNodeTen(line, node)) ** 0.5

    def at_end(line, end, beside):
        # At an end it is that of the segment there, at the node beside it the mean of two segments.
        return 2.0 * tension(line, end) - tension(line, beside)

    def print_row(time):
        last = counts[-1] - 1
        ends = at_end(lines[0], 0, 1), at_end(lines[-1], last, last - 1)
        print(repr(time), *map(repr, ends), file=out)

    step = moordyn.Step
    for from_row in range(0, len(rows) - 1, every):
        for now, then in zip(rows[from_row : from_row + every], rows[from_row + 1 :]):
            time, *place = now
            length = then[0] - time
            step(system, place, [(b - a) / length for a, b in zip(place, then[1:])], time, length)
        print_row(then[0])
    moordyn.Close(system)


main()
