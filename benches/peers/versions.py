"""Prints the versions of the packages named, one a line, nothing for one that is missing."""

import sys
from importlib import metadata

for name in sys.argv[1:]:
    try:
        print(name, metadata.version(name))
    except metadata.PackageNotFoundError:
        pass
