//! The acceptance tests: closed forms, observed orders, the discrete equations of the literature.
//!
//! A tolerance stands beside the measured value. Numbers that no formula gives carry their source.
#![allow(clippy::float_cmp)]

#[path = "../stress/mod.rs"]
mod stress;
mod support;

mod antiplane;
mod axial;
mod balance;
mod beam_fracture;
mod certificate;
mod closed_forms;
mod convergence;
mod cut_edges;
mod cut_edges_breaking;
mod default_ends;
mod default_law;
mod definiteness;
mod ductile;
mod edges_cost;
mod equation_12;
mod estimate_doubts;
mod estimates;
mod exact_law;
mod fields;
mod foundation;
mod fracture_plane;
mod frames;
mod grading;
mod held_borders;
mod hole_stress;
mod literature;
mod mirrored_loads;
mod orthotropic_elastic;
mod orthotropic_fracture;
mod orthotropic_patch;
mod orthotropic_strip;
mod plain_factor;
mod plane_borders;
mod plane_edges;
mod plane_loose;
mod plane_multigrid;
mod plane_orders;
mod plane_patch;
mod plane_patch_holes;
mod plane_results;
mod plane_solvers;
mod plausibility;
mod polygons;
mod reactions;
mod ring_borders;
mod ring_tractions;
mod section_forces;
mod sections;
mod served;
mod shell;
mod short_beams;
mod skipping;
mod softening_edges;
mod solid_files;
mod solid_rigid;
mod solid_tractions;
mod solids;
mod specimens;
mod state_based;
mod state_bodies;
mod state_plane;
mod stiffness_operator;
mod strain_form;
mod supports;
mod symbol;
mod units;
mod unsplit;
mod varying_members;
mod written_matrix;
