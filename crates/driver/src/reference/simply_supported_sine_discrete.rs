//! The grid's own answer for a simply supported beam with image ends and lumped loads h q0 sin(kx), k = n pi
//! / L.
//!
//! A sine on an endless uniform grid of spacing h stays a sine, so two amplitudes w = W sin kx, phi = P cos
//! kx solve all equations. With bonds of n spacings, xi = n h and theta = k xi, the internal force is (-a W +
//! b P) sin kx and the internal moment (b W - c P) cos kx:
//!
//! ```text
//! a = sum alpha_n S_n 4 sin²(theta/2) / xi                   b = sum alpha_n S_n sin theta
//! c = sum alpha_n [ 4 EI sin²(theta/2) / xi + S_n xi cos²(theta/2) ]
//! W = h q0 c / (ac - b²)      P = h q0 b / (ac - b²)         U = q0 W L / 4
//! ```
//!
//! In a slender beam ac and b² agree in most digits. Lagrange's identity turns the part of ac - b² that comes
//! from shear into a sum of squares, so the determinant is a sum of positive terms: with tau = k h / 2, p = j
//! + i, r = j - i
//!
//! ```text
//! ac - b² = a c_bending + sum over i < j of A_i A_j (r sin p tau - p sin r tau)² / ij,     A_n = alpha_n S_n
//! ```

use super::simply_supported_sine::{sine_cosine, wave_number};
use super::{BondClass, End, Facts, PUBLISHED_BEAM, Reference, Solution};

pub(super) const ENTRY: Reference = Reference {
    name: "simply_supported_sine_discrete",
    about: "simply supported beam with image ends, lumped sine load: the exact answer of the grid, any bond law",
    source: PUBLISHED_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Simple, End::Simple)?;
    facts.has_uniform_grid()?;
    facts.has_image_ends()?;
    facts.has_lumped_loads()?;
    let (q, half_waves) = facts.only_sine()?;
    let (l, h) = (facts.length, facts.spacing);
    if f64::from(half_waves) * h > l * (1.0 - 1e-9) {
        return Err(format!(
            "it needs fewer half waves than cells, the scene has {half_waves} half waves over cells of {h}"
        ));
    }
    let symbol = Symbol::new(&facts.bonds, facts.bending_stiffness, h, wave_number(half_waves, l));
    let deflection = h * q * symbol.c() / symbol.determinant();
    let rotation = h * q * symbol.b / symbol.determinant();
    Ok(Solution::nonlocal(q * deflection * l / 4.0, move |x| {
        let (sine, cosine) = sine_cosine(half_waves, x, l);
        (deflection * sine, rotation * cosine)
    }))
}

/// What the operator does to a sine, as the sums that make up a, b, c and ac - b².
#[derive(Default)]
struct Symbol {
    a: f64,
    b: f64,
    /// Part of c from bending.
    bending: f64,
    /// Part of c from shear.
    shear: f64,
    /// a times the shear part of c, minus b².
    squares: f64,
}

impl Symbol {
    fn new(bonds: &[BondClass], bending_stiffness: f64, spacing: f64, wave_number: f64) -> Self {
        let half_angle = wave_number * spacing / 2.0;
        let mut symbol = Self::default();
        for (j, bond) in numbered(bonds) {
            let xi = j * spacing;
            let (sine, cosine) = (j * half_angle).sin_cos();
            let stiffness = bond.weight * bond.shear_stiffness;
            symbol.a += stiffness * 4.0 * sine * sine / xi;
            symbol.b += stiffness * 2.0 * sine * cosine;
            symbol.bending += bond.weight * bending_stiffness * 4.0 * sine * sine / xi;
            symbol.shear += stiffness * xi * cosine * cosine;
            for (i, shorter) in numbered(bonds).take_while(|&(i, _)| i < j) {
                let difference = sine_difference(j + i, j - i, half_angle);
                let other = shorter.weight * shorter.shear_stiffness;
                symbol.squares += stiffness * other * difference * difference / (i * j);
            }
        }
        symbol
    }

    fn c(&self) -> f64 {
        self.bending + self.shear
    }

    fn determinant(&self) -> f64 {
        self.a * self.bending + self.squares
    }
}

fn numbered(bonds: &[BondClass]) -> impl Iterator<Item = (f64, &BondClass)> {
    (1_u32..).map(f64::from).zip(bonds)
}

/// r sin(p t) - p sin(r t), without the linear terms that cancel.
fn sine_difference(p: f64, r: f64, t: f64) -> f64 {
    p * r * t * (sinc_deficit(r * t) - sinc_deficit(p * t))
}

/// 1 - sin(z) / z.
fn sinc_deficit(z: f64) -> f64 {
    if z.abs() > 1.0 {
        return 1.0 - z.sin() / z;
    }
    let (mut sum, mut term, mut n) = (0.0, 1.0, 2.0);
    while n < 20.0 {
        term *= -z * z / (n * (n + 1.0));
        sum -= term;
        n += 2.0;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Law, sine_facts};
    use super::*;
    use std::f64::consts::PI;

    // EI = 1, L = 1, q0 = 1, spacing 1/32, three spacings per horizon, k = pi; evaluated with 50 digits
    // (mpmath). Columns a, b, c for S = 4, then W, P for S = 4, then W, P for S = 4e8.
    const SYMBOLS: [(Law, f64, f64, f64); 3] = [
        (Law::Published, 1.2287569827547826, 0.3895553786425956, 0.4306915483425425),
        (Law::Mean, 1.2267603025748106, 0.388922366977593, 0.43049086211788556),
        (Law::Corrected, 1.2267645013767299, 0.38892465034699775, 0.4304918877275677),
    ];
    const AMPLITUDES: [(Law, f64, f64); 3] = [
        (Law::Published, 0.03565687692268214, 0.03225122072695158),
        (Law::Mean, 0.035698270526855896, 0.03225122085520433),
        (Law::Corrected, 0.03569823341197637, 0.03225129983528219),
    ];
    const SLENDER: [(Law, f64, f64); 3] = [
        (Law::Published, 4.161050648632184e-05, 0.00013124934400646595),
        (Law::Mean, 0.01025073973389609, 0.03220287992795971),
        (Law::Corrected, 0.010266028115709506, 0.03225145273898883),
    ];

    fn close(found: f64, expected: f64) {
        assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{found} is not {expected}");
    }

    #[test]
    fn symbol_of_the_three_laws() {
        for (law, a, b, c) in SYMBOLS {
            let facts = sine_facts(law, 3, 1.0 / 32.0);
            let symbol = Symbol::new(&facts.bonds, 1.0, 1.0 / 32.0, PI);
            close(symbol.a, a);
            close(symbol.b, b);
            close(symbol.c(), c);
        }
    }

    #[test]
    fn amplitudes_of_the_three_laws() {
        for (law, w, p) in AMPLITUDES {
            let solution = build(&sine_facts(law, 3, 1.0 / 32.0)).unwrap();
            close((solution.at)(0.5).w, w);
            close((solution.at)(0.0).phi, p);
        }
    }

    /// The plain determinant would keep seven digits here.
    #[test]
    fn amplitudes_of_a_slender_beam() {
        for (law, w, p) in SLENDER {
            let mut facts = sine_facts(law, 3, 1.0 / 32.0);
            facts.shear_stiffness = 4e8;
            facts.bonds = law.bonds(3, 1.0 / 32.0, 1.0, 4e8);
            let solution = build(&facts).unwrap();
            close((solution.at)(0.5).w, w);
            close((solution.at)(0.0).phi, p);
        }
    }

    #[test]
    fn a_wave_shorter_than_two_cells_is_refused() {
        let mut facts = sine_facts(Law::Published, 3, 1.0 / 32.0);
        facts.loads = vec![crate::reference::Load::Sine { amplitude: 1.0, half_waves: 32 }];
        let message = build(&facts).unwrap_err();
        assert_eq!(
            message,
            "it needs fewer half waves than cells, the scene has 32 half waves over cells of 0.03125"
        );
    }
}
