"""The stiffness of a case as an operator of SciPy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import LinearOperator

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from . import _peristat


class Operator(LinearOperator):  # type: ignore[misc]
    """`K` of `K q = f`: symmetric, and positive definite where supports hold the body."""

    def __init__(self, native: _peristat.Operator) -> None:
        self._native = native
        size = native.size()
        super().__init__(np.dtype(np.float64), (size, size))

    def _matvec(self, q: NDArray[np.float64]) -> NDArray[np.float64]:
        return self._native.product(np.ascontiguousarray(q, dtype=np.float64).ravel())

    def _adjoint(self) -> Operator:
        return self

    @property
    def components(self) -> list[str]:
        """Names of the displacements and rotations of a point, such as `ux`, `uy`."""
        return self._native.components()

    @property
    def unknowns(self) -> NDArray[np.uintp]:
        """Point, as in `Result.points`, and index of the component of every row, n x 2."""
        return self._native.unknowns()

    @property
    def state_count(self) -> int:
        """Number of states, each with its own right-hand side."""
        return self._native.states()

    def _number(self, state: int) -> int:
        if not -self.state_count <= state < self.state_count:
            raise IndexError(f"there is no state {state}: there are {self.state_count}")
        return state % self.state_count

    def rhs(self, state: int = -1) -> NDArray[np.float64]:
        """`f`: the loads of a state, the last one if not given, less the forces of its prescribed motions."""
        return self._native.right_hand_side(self._number(state))

    def expand(self, q: NDArray[np.float64], state: int = -1) -> NDArray[np.float64]:
        """Displacements and rotations of all points with what a state prescribes, points x components; NaN along members of
        frames that stretch as one bar, whose points have no displacement of their own along them."""
        return self._native.expand(np.ascontiguousarray(q, dtype=np.float64).ravel(), self._number(state))

    def matrix(self) -> Any:
        """`K` assembled, a `scipy.sparse.csr_matrix`."""
        starts, columns, values = self._native.matrix()
        return csr_matrix((values, columns, starts), shape=self.shape)
