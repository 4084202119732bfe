//! Mechanics of implicit peridynamics: bonds, measures, terms of the energy, constraints, assembly.
//!
//! **Every model is an energy that is a sum over bonds and families of a function of a few measures,
//! `E = Σ_e ½ s_eᵀ C_e s_e` with `s_e = B_e u`; every tangent is `Σ B_eᵀ C_e B_e`.** A model says which measures a
//! bond has and which moduli belong to them ([`bonds::BondModel`]); operator, assembly, constraints, reactions and free
//! motions are written once, for all models. Nothing here opens a file, prints, or solves.
//!
//! Models: plates of central bonds ([`model::bond_plane`]), plates in antiplane shear ([`model::bond_antiplane`]),
//! orthotropic plates of beam bonds whose points turn ([`model::beam_bond_orthotropic`]), Timoshenko beams
//! ([`model::timoshenko_beam`]), solids of central bonds and state-based ones ([`model::solid`]). Bonds of beams, and of plates
//! that move in their plane, can break ([`model::Breakable`]). What displacements tell between points and on holes is [`recovery`], how
//! they become those of local elasticity is [`correction`].
//!
//! Modules use only what stands to their left:
//! `sum → quadrature → recovery → law → material → bonds → body → condition → stiffness → model → correction → system → cubic`.
#![cfg_attr(test, allow(clippy::float_cmp))]

pub mod body;
pub mod bonds;
pub mod condition;
pub mod correction;
pub mod cubic;
pub mod law;
pub mod material;
pub mod model;
pub mod quadrature;
pub mod recovery;
mod register;
pub mod stiffness;
pub mod sum;
pub mod system;
