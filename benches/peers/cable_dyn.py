"""Runs a deck of CableDyn along a table of motion, and prints its tensions.

    python cable_dyn.py FILE TABLE EVERY

The table has a row for each step: the time in s, and how far all coupled points are moved along x in m, their velocity and their
acceleration. For one of EVERY steps the time is printed and the tensions at the ends of the first line in N. The last line is `inside`
and the CPU time in s without the import.
"""

import os
import sys
import time


def main():
    path, table, every = sys.argv[1], sys.argv[2], int(sys.argv[3])
    rows = [[float(word) for word in line.split()] for line in open(table)]
    # The library may write messages to standard output.
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    from cabledyn import CableDyn

    begun = time.process_time()
    with CableDyn(path) as model:
        at_rest = model.get_coupled_motion()
        along_x = model.host_dofs()[::3]
        for number, (now, then) in enumerate(zip(rows, rows[1:]), 1):
            motion = [column.copy() for column in at_rest]
            for column, value in zip(motion, then[1:]):
                column[along_x] += value
            model.step(then[0] - now[0], *motion)
            if number % every == 0:
                ends = model.channel("AnchTen1"), model.channel("FairTen1")
                print(repr(then[0]), *map(repr, ends), file=out)
    print("inside", time.process_time() - begun, file=out)


main()
