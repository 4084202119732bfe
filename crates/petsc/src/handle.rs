//! Objects of PETSc that are destroyed with their owners.

use crate::check::petsc;
use crate::error::PetscError;
use crate::ffi::{Code, Object};
use std::ptr;

/// An object of PETSc with what destroys it.
pub(crate) struct Handle {
    object: Object,
    destroy: unsafe extern "C" fn(*mut Object) -> Code,
}

impl Handle {
    /// The object that `make` creates at the address it gets, and that `destroy` frees.
    ///
    /// # Errors
    /// What `make`, which is named `call`, returns.
    pub(crate) fn new(
        call: &'static str,
        destroy: unsafe extern "C" fn(*mut Object) -> Code,
        make: impl FnOnce(*mut Object) -> Code,
    ) -> Result<Self, PetscError> {
        let mut object = ptr::null_mut();
        petsc(call, make(&raw mut object))?;
        Ok(Self { object, destroy })
    }

    /// The object, for calls while its owner lives.
    pub(crate) fn get(&self) -> Object {
        self.object
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        // SAFETY: the object was made by PETSc for this function, is not used after this, and is destroyed once. A session outlives
        // its objects, which borrow it or are locals of its methods. A code has nowhere to go.
        #[allow(unsafe_code)]
        unsafe {
            (self.destroy)(&raw mut self.object);
        }
    }
}
