"""What goes wrong, as exceptions and warnings with their parts."""

from __future__ import annotations

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
    """The value at fault, such as `body.rectangle.size`; empty for the whole case."""
    place: Optional[tuple[int, int]]
    """Line and column in the text of the case, counted from 1."""
    hint: Optional[str]
    """What to do about it."""


class CaseError(ValueError):
    """A case is at fault. The text of the exception shows every fault in its place; `faults` has their parts."""

    def __init__(self, text: str, faults: list[tuple[str, str, str, Optional[tuple[int, int]], Optional[str]]]) -> None:
        super().__init__(text)
        self.faults = [Fault(*fault) for fault in faults]


class NotConverged(RuntimeError):
    """A state did not converge; `result` has all that was found."""

    def __init__(self, result: Result) -> None:
        super().__init__("a state did not converge; `result` of this exception has what was found")
        self.result = result


class Interrupted(RuntimeError):
    """`on_state` returned `False`."""


class PeristatWarning(UserWarning):
    """A doubt about a case or its answer."""
