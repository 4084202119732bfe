/* What Rust takes for granted of PETSc and MPI, asked of their headers; and the calls of MPI whose arguments are macros. */
#include <petscksp.h>

_Static_assert(PETSC_VERSION_GE(3, 18, 0), "PETSc 3.18 or later");
#if defined(PETSC_USE_COMPLEX) || !defined(PETSC_USE_REAL_DOUBLE)
#error "PETSc is to have real numbers of double precision: on Debian libpetsc-real-dev"
#endif
_Static_assert(sizeof(PetscInt) == 4, "PETSc is to count with 32 bits");
_Static_assert(sizeof(PetscErrorCode) == 4 && sizeof(PetscBool) == 4, "codes have 32 bits");
_Static_assert(sizeof(MPI_Comm) == sizeof(void *), "MPI is to be Open MPI");
_Static_assert(INSERT_VALUES == 1 && SCATTER_FORWARD == 0 && PETSC_COPY_VALUES == 0 && PETSC_TRUE == 1, "modes");
_Static_assert(KSP_NORM_UNPRECONDITIONED == 2 && MATOP_MULT == 3, "norm and product");
_Static_assert(KSP_DIVERGED_ITS == -3 && KSP_DIVERGED_INDEFINITE_PC == -8 && KSP_DIVERGED_NANORINF == -9
                   && KSP_DIVERGED_INDEFINITE_MAT == -10,
               "reasons");

/* Declarations that differ from those of ffi.rs, type by type, do not compile. */
typedef PetscErrorCode (*Apply)(PC, Vec, Vec);
#define IS_AS(name, ...) \
  __attribute__((unused)) static PetscErrorCode (*const as_##name)(__VA_ARGS__) = name
IS_AS(PetscInitializeNoArguments, void);
IS_AS(PetscFinalize, void);
IS_AS(PetscOptionsSetValue, PetscOptions, const char *, const char *);
IS_AS(PetscErrorMessage, int, const char **, char **);
IS_AS(VecCreateMPIWithArray, MPI_Comm, PetscInt, PetscInt, PetscInt, const PetscScalar *, Vec *);
IS_AS(VecCreateSeqWithArray, MPI_Comm, PetscInt, PetscInt, const PetscScalar *, Vec *);
IS_AS(VecPlaceArray, Vec, const PetscScalar *);
IS_AS(VecResetArray, Vec);
IS_AS(VecGetArrayRead, Vec, const PetscScalar **);
IS_AS(VecRestoreArrayRead, Vec, const PetscScalar **);
IS_AS(VecGetArray, Vec, PetscScalar **);
IS_AS(VecRestoreArray, Vec, PetscScalar **);
IS_AS(VecDestroy, Vec *);
IS_AS(ISCreateGeneral, MPI_Comm, PetscInt, const PetscInt *, PetscCopyMode, IS *);
IS_AS(ISDestroy, IS *);
IS_AS(VecScatterCreate, Vec, IS, Vec, IS, VecScatter *);
IS_AS(VecScatterBegin, VecScatter, Vec, Vec, InsertMode, ScatterMode);
IS_AS(VecScatterEnd, VecScatter, Vec, Vec, InsertMode, ScatterMode);
IS_AS(VecScatterDestroy, VecScatter *);
IS_AS(MatCreateShell, MPI_Comm, PetscInt, PetscInt, PetscInt, PetscInt, void *, Mat *);
IS_AS(MatShellSetOperation, Mat, MatOperation, void (*)(void));
IS_AS(MatDestroy, Mat *);
IS_AS(KSPCreate, MPI_Comm, KSP *);
IS_AS(KSPSetOperators, KSP, Mat, Mat);
IS_AS(KSPSetType, KSP, KSPType);
IS_AS(KSPSetNormType, KSP, KSPNormType);
IS_AS(KSPSetTolerances, KSP, PetscReal, PetscReal, PetscReal, PetscInt);
IS_AS(KSPSetComputeEigenvalues, KSP, PetscBool);
IS_AS(KSPComputeEigenvalues, KSP, PetscInt, PetscReal[], PetscReal[], PetscInt *);
IS_AS(KSPGetPC, KSP, PC *);
IS_AS(KSPSolve, KSP, Vec, Vec);
IS_AS(KSPGetIterationNumber, KSP, PetscInt *);
IS_AS(KSPGetResidualNorm, KSP, PetscReal *);
IS_AS(KSPGetConvergedReason, KSP, KSPConvergedReason *);
IS_AS(KSPDestroy, KSP *);
IS_AS(PCSetType, PC, PCType);
IS_AS(PCShellSetContext, PC, void *);
IS_AS(PCShellSetApply, PC, Apply);

/* Their contexts come back through a pointer to a pointer, which PETSc declares as a plain one. */
PetscErrorCode peristat_mat_context(Mat matrix, void **context) { return MatShellGetContext(matrix, context); }
PetscErrorCode peristat_pc_context(PC pc, void **context) { return PCShellGetContext(pc, context); }

/* A failed call returns its code; the text of it is asked for by PetscErrorMessage. */
PetscErrorCode peristat_return_errors(void) { return PetscPushErrorHandler(PetscReturnErrorHandler, NULL); }

MPI_Comm peristat_world(void) { return PETSC_COMM_WORLD; }
MPI_Comm peristat_self(void) { return PETSC_COMM_SELF; }

int peristat_rank(int *rank) { return MPI_Comm_rank(PETSC_COMM_WORLD, rank); }
int peristat_size(int *size) { return MPI_Comm_size(PETSC_COMM_WORLD, size); }
int peristat_abort(int code) { return MPI_Abort(MPI_COMM_WORLD, code); }
int peristat_broadcast(double *values, int count) {
  return MPI_Bcast(values, count, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
}
int peristat_sum(double *values, int count) {
  return MPI_Allreduce(MPI_IN_PLACE, values, count, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
}
int peristat_gather_counts(int own, int *counts) {
  return MPI_Gather(&own, 1, MPI_INT, counts, 1, MPI_INT, 0, PETSC_COMM_WORLD);
}
int peristat_gather(const double *own, int count, double *all, const int *counts, const int *starts) {
  return MPI_Gatherv(own, count, MPI_DOUBLE, all, counts, starts, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
}
int peristat_deal(const double *all, const int *counts, const int *starts, double *own, int count) {
  return MPI_Scatterv(all, counts, starts, MPI_DOUBLE, own, count, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
}
