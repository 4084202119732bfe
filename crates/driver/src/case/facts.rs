//! What checks know beside probes, by name.

/// Of every body that breaks, in their order.
pub const FRACTURE_FACTS: [&str; 7] = [
    "first_break_load_factor",
    "first_break_load",
    "peak_load_factor",
    "peak_load",
    "load_factor",
    "broken_bonds",
    "island_points",
];

/// Of every body that softens, in their order.
pub const PATH_FACTS: [&str; 18] = [
    "first_yield_load_factor",
    "first_yield_load",
    "peak_load_factor",
    "peak_load",
    "load_factor",
    "end_load",
    "initial_stiffness",
    "work",
    "stored_energy",
    "dissipated_energy",
    "energy_balance",
    "work_identity",
    "steps",
    "snap_back_steps",
    "branch_load_factor",
    "refused_steps",
    "broken_bonds",
    "island_points",
];
