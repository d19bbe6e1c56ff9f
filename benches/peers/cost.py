"""Prints the least CPU times in s that a command takes of so many repeats: of the process, and what it says itself.

    python cost.py REPEATS COMMAND...

A command may print `inside SECONDS` as its last line: the time without the import of packages. Otherwise the second number is nan.
Repeats end where they have taken 20 s together.
"""

import resource
import subprocess
import sys

ENOUGH = 20.0


def spent():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def once(command):
    before = spent()
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    process = spent() - before
    last = done.stdout.decode().splitlines()[-1:] or [""]
    said = last[0].split()
    return process, float(said[1]) if said[:1] == ["inside"] else float("nan")


def main():
    repeats, command = int(sys.argv[1]), sys.argv[2:]
    begun = spent()
    times = [once(command)]
    while len(times) < repeats and spent() - begun < ENOUGH:
        times.append(once(command))
    print(*(min(column) for column in zip(*times)))


main()
