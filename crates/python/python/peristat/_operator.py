"""The stiffness of a case for the solvers of SciPy."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional

from . import _peristat
from ._case import Case, given
from ._errors import PeristatWarning, missing

if TYPE_CHECKING:
    from ._linear import Operator


def operator(
    case: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    max_memory: Optional[int] = None,
    allow_outside: bool = False,
) -> Operator:
    """The stiffness of a case under its supports, links and springs as a `scipy.sparse.linalg.LinearOperator`, in the units of the case.

    Its unknowns are what no support prescribes; a case without supports keeps its rigid motions, and the operator is then singular. Products
    are taken bond by bond, without a matrix, before any bond breaks or yields. Needs SciPy; raises `CaseError`, `MemoryError`;
    warns with `PeristatWarning`.
    """
    try:
        from ._linear import Operator
    except ImportError as error:
        raise missing("SciPy", "scipy") from error
    native = _peristat.operator(given(case, set, max_memory, allow_outside))
    for text in native.warnings():
        warnings.warn(text, PeristatWarning, stacklevel=2)
    return Operator(native)


def stiffness(
    case: Case,
    *,
    set: Optional[Mapping[str, Any]] = None,
    max_memory: Optional[int] = None,
    allow_outside: bool = False,
) -> Any:
    """The same assembled, a `scipy.sparse.csr_matrix`; its rows are numbered as `operator(case).unknowns` says."""
    return operator(case, set=set, max_memory=max_memory, allow_outside=allow_outside).matrix()
