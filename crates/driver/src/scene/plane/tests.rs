//! Scenes of bodies in the plane as cases make them.
