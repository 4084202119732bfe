//! The functions of PETSc that are used, and those of `shim.c`, which compares these declarations with the headers.
#![allow(non_snake_case, unsafe_code)]

use std::ffi::{c_char, c_int, c_void};

/// An object of PETSc: `Vec`, `Mat`, `KSP`, `PC`, `IS` or `VecScatter`, all of which are pointers.
pub(crate) type Object = *mut c_void;
/// A communicator of Open MPI.
pub(crate) type Comm = *mut c_void;
/// Zero, or what went wrong.
pub(crate) type Code = c_int;
/// How PETSc counts.
pub(crate) type Int = i32;

/// `INSERT_VALUES`
pub(crate) const INSERT: c_int = 1;
/// `SCATTER_FORWARD`
pub(crate) const FORWARD: c_int = 0;
/// `PETSC_COPY_VALUES`
pub(crate) const COPY: c_int = 0;
/// `PETSC_TRUE`
pub(crate) const TRUE: c_int = 1;
/// `KSP_NORM_UNPRECONDITIONED`
pub(crate) const TRUE_RESIDUAL: c_int = 2;
/// `MATOP_MULT`
pub(crate) const MULTIPLY: c_int = 3;
/// `KSP_DIVERGED_ITS`
pub(crate) const OUT_OF_ITERATIONS: c_int = -3;
/// `KSP_DIVERGED_INDEFINITE_PC`
pub(crate) const INDEFINITE_PRECONDITIONER: c_int = -8;
/// `KSP_DIVERGED_NANORINF`
pub(crate) const NOT_FINITE: c_int = -9;
/// `KSP_DIVERGED_INDEFINITE_MAT`
pub(crate) const INDEFINITE_MATRIX: c_int = -10;

/// A product, of a matrix or a preconditioner, with a vector, into another one.
pub(crate) type Product = unsafe extern "C" fn(Object, Object, Object) -> Code;

unsafe extern "C" {
    pub(crate) fn PetscInitializeNoArguments() -> Code;
    pub(crate) fn PetscFinalize() -> Code;
    pub(crate) fn PetscOptionsSetValue(options: Object, name: *const c_char, value: *const c_char) -> Code;
    pub(crate) fn PetscErrorMessage(code: c_int, text: *mut *const c_char, more: *mut *mut c_char) -> Code;

    pub(crate) fn VecCreateMPIWithArray(
        comm: Comm,
        block: Int,
        own: Int,
        all: Int,
        values: *const f64,
        vector: *mut Object,
    ) -> Code;
    pub(crate) fn VecCreateSeqWithArray(
        comm: Comm,
        block: Int,
        own: Int,
        values: *const f64,
        vector: *mut Object,
    ) -> Code;
    pub(crate) fn VecPlaceArray(vector: Object, values: *const f64) -> Code;
    pub(crate) fn VecResetArray(vector: Object) -> Code;
    pub(crate) fn VecGetArrayRead(vector: Object, values: *mut *const f64) -> Code;
    pub(crate) fn VecRestoreArrayRead(vector: Object, values: *mut *const f64) -> Code;
    pub(crate) fn VecGetArray(vector: Object, values: *mut *mut f64) -> Code;
    pub(crate) fn VecRestoreArray(vector: Object, values: *mut *mut f64) -> Code;
    pub(crate) fn VecDestroy(vector: *mut Object) -> Code;

    pub(crate) fn ISCreateGeneral(
        comm: Comm,
        count: Int,
        places: *const Int,
        mode: c_int,
        set: *mut Object,
    ) -> Code;
    pub(crate) fn ISDestroy(set: *mut Object) -> Code;

    pub(crate) fn VecScatterCreate(
        from: Object,
        places: Object,
        to: Object,
        there: Object,
        scatter: *mut Object,
    ) -> Code;
    pub(crate) fn VecScatterBegin(
        scatter: Object,
        from: Object,
        to: Object,
        insert: c_int,
        way: c_int,
    ) -> Code;
    pub(crate) fn VecScatterEnd(scatter: Object, from: Object, to: Object, insert: c_int, way: c_int)
    -> Code;
    pub(crate) fn VecScatterDestroy(scatter: *mut Object) -> Code;

    pub(crate) fn MatCreateShell(
        comm: Comm,
        own_rows: Int,
        own_columns: Int,
        rows: Int,
        columns: Int,
        context: *mut c_void,
        matrix: *mut Object,
    ) -> Code;
    pub(crate) fn MatShellSetOperation(matrix: Object, operation: c_int, product: Product) -> Code;
    pub(crate) fn MatDestroy(matrix: *mut Object) -> Code;

    pub(crate) fn KSPCreate(comm: Comm, solver: *mut Object) -> Code;
    pub(crate) fn KSPSetOperators(solver: Object, matrix: Object, preconditioning: Object) -> Code;
    pub(crate) fn KSPSetType(solver: Object, name: *const c_char) -> Code;
    pub(crate) fn KSPSetNormType(solver: Object, norm: c_int) -> Code;
    pub(crate) fn KSPSetTolerances(
        solver: Object,
        relative: f64,
        absolute: f64,
        growth: f64,
        iterations: Int,
    ) -> Code;
    pub(crate) fn KSPSetComputeEigenvalues(solver: Object, wanted: c_int) -> Code;
    pub(crate) fn KSPComputeEigenvalues(
        solver: Object,
        room: Int,
        real: *mut f64,
        imaginary: *mut f64,
        count: *mut Int,
    ) -> Code;
    pub(crate) fn KSPGetPC(solver: Object, preconditioner: *mut Object) -> Code;
    pub(crate) fn KSPSolve(solver: Object, b: Object, x: Object) -> Code;
    pub(crate) fn KSPGetIterationNumber(solver: Object, iterations: *mut Int) -> Code;
    pub(crate) fn KSPGetResidualNorm(solver: Object, norm: *mut f64) -> Code;
    pub(crate) fn KSPGetConvergedReason(solver: Object, reason: *mut c_int) -> Code;
    pub(crate) fn KSPDestroy(solver: *mut Object) -> Code;

    pub(crate) fn PCSetType(preconditioner: Object, name: *const c_char) -> Code;
    pub(crate) fn PCShellSetContext(preconditioner: Object, context: *mut c_void) -> Code;
    pub(crate) fn PCShellSetApply(preconditioner: Object, apply: Product) -> Code;

    pub(crate) fn peristat_mat_context(matrix: Object, context: *mut *mut c_void) -> Code;
    pub(crate) fn peristat_pc_context(preconditioner: Object, context: *mut *mut c_void) -> Code;
    pub(crate) fn peristat_return_errors() -> Code;
    pub(crate) fn peristat_world() -> Comm;
    pub(crate) fn peristat_self() -> Comm;
    pub(crate) fn peristat_rank(rank: *mut c_int) -> Code;
    pub(crate) fn peristat_size(size: *mut c_int) -> Code;
    pub(crate) fn peristat_abort(code: c_int) -> Code;
    pub(crate) fn peristat_broadcast(values: *mut f64, count: c_int) -> Code;
    pub(crate) fn peristat_sum(values: *mut f64, count: c_int) -> Code;
    pub(crate) fn peristat_gather_counts(own: c_int, counts: *mut c_int) -> Code;
    pub(crate) fn peristat_gather(
        own: *const f64,
        count: c_int,
        all: *mut f64,
        counts: *const c_int,
        starts: *const c_int,
    ) -> Code;
    pub(crate) fn peristat_deal(
        all: *const f64,
        counts: *const c_int,
        starts: *const c_int,
        own: *mut f64,
        count: c_int,
    ) -> Code;
}
