//! What a state is certified with, as text.

use peristat::summary::StateSummary;
use std::fmt::Write;

/// What the result is certified with.
pub(super) fn certificate(out: &mut String, state: &StateSummary) {
    let c = &state.certificate;
    let balance: Vec<String> = c.balance.iter().map(|b| format!("{} {:.1e}", b.motion, b.relative)).collect();
    let _ = writeln!(
        out,
        "\n  certificate of the discrete solution: {}, digits you can trust: {} of displacements, {} of strains and forces\n    next correction {:.1e}, residual {:.1e}, balance of {}, energy {:.1e}",
        if c.converged { "converged" } else { "NOT CONVERGED" },
        c.digits,
        c.strain_digits,
        c.next_correction,
        c.residual,
        balance.join(" and "),
        c.energy_balance
    );
}
