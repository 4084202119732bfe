"""`python -m peristat` is the command `peristat`."""

from ._command import main

main()
