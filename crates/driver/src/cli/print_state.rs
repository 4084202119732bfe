//! What a state is certified with, as text.

use crate::summary::StateSummary;
use std::fmt::Write;

/// A residual above this leaves section forces fewer digits than engineers expect.
const FEW_DIGITS: f64 = 1e-6;

/// What the result is certified with.
pub(super) fn certificate(out: &mut String, state: &StateSummary) {
    let c = &state.certificate;
    let balance: Vec<String> = c.balance.iter().map(|b| format!("{} {:.1e}", b.motion, b.relative)).collect();
    let _ = writeln!(
        out,
        "\n  certificate: {}, next correction {:.1e}, residual {:.1e}, balance of {}, energy {:.1e}",
        if c.converged { "converged" } else { "NOT CONVERGED" },
        c.next_correction,
        c.residual,
        balance.join(" and "),
        c.energy_balance
    );
    if c.converged && c.residual > FEW_DIGITS {
        let _ = writeln!(
            out,
            "  note: displacements are rounded, and end forces are their differences: section forces and reactions may be off by {:.0e} of the largest",
            c.residual
        );
    }
}
