"""The program: ``kinegon``, or ``python -m kinegon``."""

import signal
import sys

from ._kinegon import program


def main() -> None:
    """Runs the command line of this process."""
    # Ctrl-C ends the program as it ends any other, without waiting for Python.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(program(sys.argv))


if __name__ == "__main__":
    main()
