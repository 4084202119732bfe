//! Entries of a long vector that other processes keep.

use crate::check::{int, petsc};
use crate::error::PetscError;
use crate::ffi::{self, Int};
use crate::handle::Handle;
use crate::session::{Session, end_all};
use peristat_solve::Halo;
use std::ptr;

/// A `VecScatter` from the long vector to the wanted entries. The arrays of both vectors are put in place for every use.
pub(crate) struct PetscHalo<'a> {
    session: &'a Session,
    lengths: [usize; 2],
    own: Handle,
    wanted: Handle,
    scatter: Handle,
}

// SAFETY: the objects are used only on the thread that started PETSc, which every use checks: there are no two uses at the same
// time. They are destroyed where they were made, since this is not `Send`, and before the session, which they borrow.
#[allow(unsafe_code)]
unsafe impl Sync for PetscHalo<'_> {}

impl<'a> PetscHalo<'a> {
    /// That of entries by their places in the long vector, of which `own` are kept here.
    ///
    /// # Errors
    /// [`PetscError`]
    #[allow(unsafe_code)]
    pub(crate) fn new(session: &'a Session, own: usize, wanted: &[usize]) -> Result<Self, PetscError> {
        let world = session.world();
        let places: Vec<Int> = wanted.iter().map(|&place| int(place)).collect::<Result<_, _>>()?;
        let (lengths, own_count, count) = ([own, wanted.len()], int(own)?, int(wanted.len())?);
        // SAFETY: PETSc runs while there is a session; vectors without an array get one before they are read; the places are copied;
        // `-1` asks PETSc for the sum of the lengths.
        let (own, wanted, places) = unsafe {
            (
                Handle::new("VecCreateMPIWithArray", ffi::VecDestroy, |vector| {
                    ffi::VecCreateMPIWithArray(world, 1, own_count, -1, ptr::null(), vector)
                })?,
                Handle::new("VecCreateSeqWithArray", ffi::VecDestroy, |vector| {
                    ffi::VecCreateSeqWithArray(ffi::peristat_self(), 1, count, ptr::null(), vector)
                })?,
                Handle::new("ISCreateGeneral", ffi::ISDestroy, |set| {
                    ffi::ISCreateGeneral(ffi::peristat_self(), count, places.as_ptr(), ffi::COPY, set)
                })?,
            )
        };
        // SAFETY: all are alive; no set of places there means all, in their order.
        let scatter = unsafe {
            Handle::new("VecScatterCreate", ffi::VecScatterDestroy, |scatter| {
                ffi::VecScatterCreate(own.get(), places.get(), wanted.get(), ptr::null_mut(), scatter)
            })?
        };
        Ok(Self { session, lengths, own, wanted, scatter })
    }

    #[allow(unsafe_code)]
    fn try_fetch(&self, own: &[f64], wanted: &mut [f64]) -> Result<(), PetscError> {
        self.session.check();
        assert_eq!([own.len(), wanted.len()], self.lengths, "parts of the lengths of the halo");
        let (from, to, scatter) = (self.own.get(), self.wanted.get(), self.scatter.get());
        // SAFETY: the objects are alive; the arrays have the lengths of their vectors, outlive the calls and are taken out again;
        // the scatter only reads the first one.
        unsafe {
            petsc("VecPlaceArray", ffi::VecPlaceArray(from, own.as_ptr()))?;
            petsc("VecPlaceArray", ffi::VecPlaceArray(to, wanted.as_mut_ptr()))?;
            petsc("VecScatterBegin", ffi::VecScatterBegin(scatter, from, to, ffi::INSERT, ffi::FORWARD))?;
            petsc("VecScatterEnd", ffi::VecScatterEnd(scatter, from, to, ffi::INSERT, ffi::FORWARD))?;
            petsc("VecResetArray", ffi::VecResetArray(from))?;
            petsc("VecResetArray", ffi::VecResetArray(to))
        }
    }
}

impl Halo for PetscHalo<'_> {
    fn fetch(&self, own: &[f64], wanted: &mut [f64]) {
        self.try_fetch(own, wanted).unwrap_or_else(|error| end_all(&error));
    }
}
