"""``python -m pydy``."""

import sys

from pydy.cli import main

if __name__ == "__main__":
    sys.exit(main())
