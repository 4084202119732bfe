"""What goes wrong, as exceptions and warnings with their parts."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, NamedTuple, Optional

if TYPE_CHECKING:
    from ._result import Result


class Fault(NamedTuple):
    """One fault of a case, or one warning."""

    severity: str
    """`error` or `warning`."""
    message: str
    """What is wrong, in one line."""
    path: str
    """The value at fault, such as `body.rectangle.size`; empty for what is no single value."""
    line: Optional[int]
    """Line in the text of the case, from 1."""
    column: Optional[int]
    """Column in characters, from 1."""
    hint: Optional[str]
    """What to do about it."""
    tasks: Optional[str] = None
    """The tasks of a study that have it, in words."""


class CaseError(ValueError):
    """A case is at fault. The text of the exception shows every fault in its place; `faults` has their parts."""

    def __init__(self, text: str, faults: str) -> None:
        super().__init__(text, faults)
        self.faults = [Fault(**fault) for fault in json.loads(faults)]

    def __str__(self) -> str:
        return str(self.args[0])


class NotConverged(RuntimeError):
    """A state did not converge; `result` has all that was found, but in another process."""

    def __init__(self, result: Optional[Result] = None) -> None:
        super().__init__("a state did not converge; `result` of this exception has what was found")
        self._result = result

    @property
    def result(self) -> Result:
        """All that was found."""
        if self._result is None:
            raise RuntimeError("the result stayed in the process that solved the case")
        return self._result

    def __reduce__(self) -> tuple[type[NotConverged], tuple[()]]:
        return type(self), ()


class Interrupted(RuntimeError):
    """`on_state` returned `False`."""


class PeristatWarning(UserWarning):
    """A doubt about a case or its answer."""


def missing(library: str, extra: str) -> ImportError:
    """What to say where a library is not there that only some answers need."""
    return ImportError(f"this needs {library}, which is not installed: pip install './crates/python[{extra}]'")
