"""The command `peristat`."""

from __future__ import annotations

import signal
import sys

from . import _peristat


def main() -> None:
    """Do what the arguments of the process say, and end it with the exit code of the command."""
    # The command hears signals itself; what it leaves to the system ends the process at once.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_peristat.command(["peristat", *sys.argv[1:]]))
