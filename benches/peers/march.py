"""Runs a file of MoorDyn along a table of motion, and prints its tensions.

    python march.py FILE TABLE EVERY [LINE]

The table has a row for each step: the time in s and the coordinates of every coupled point in m. For one of EVERY steps the time is
printed and the tensions at end A of the first and at end B of the last line in N, or at both ends of LINE, counted from 1. MoorDyn has the
tensions of segments: those at the ends are extrapolated from the two nearest. Its own messages go to standard error. The last line is
`inside` and the CPU time in s without the import.
"""

import os
import sys
import time


def main():
    path, table, every = sys.argv[1], sys.argv[2], int(sys.argv[3])
    rows = [[float(word) for word in line.split()] for line in open(table)]
    # The library writes its messages to standard output.
    printed = os.dup(1)
    os.dup2(2, 1)
    import moordyn

    begun = time.process_time()
    system = moordyn.Create(path)
    first = rows[0][1:]
    assert moordyn.Init(system, first, [0.0] * len(first)) == 0
    numbers = [int(sys.argv[4])] * 2 if len(sys.argv) > 4 else [1, moordyn.GetNumberLines(system)]
    lines = [moordyn.GetLine(system, number) for number in numbers]
    last = moordyn.GetLineNumberNodes(lines[1]) - 1
    out = os.fdopen(printed, "w")

    def tension(line, node):
        return sum(part * part for part in moordyn.GetLineNodeTen(line, node)) ** 0.5

    def at_end(line, end, beside):
        # At an end it is that of the segment there, at the node beside it the mean of two segments.
        return 2.0 * tension(line, end) - tension(line, beside)

    def print_row(moment):
        ends = at_end(lines[0], 0, 1), at_end(lines[1], last, last - 1)
        print(repr(moment), *map(repr, ends), file=out)

    step = moordyn.Step
    for from_row in range(0, len(rows) - 1, every):
        for now, then in zip(rows[from_row : from_row + every], rows[from_row + 1 :]):
            moment, *place = now
            length = then[0] - moment
            step(system, place, [(b - a) / length for a, b in zip(place, then[1:])], moment, length)
        print_row(then[0])
    moordyn.Close(system)
    print("inside", time.process_time() - begun, file=out)


main()
