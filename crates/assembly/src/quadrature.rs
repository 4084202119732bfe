//! Gauss' rule for integrals over a cell or a part of a border.

/// Gauss-Legendre rule with 8 points on (0, 1), exact to degree 15: `(position, weight)`.
pub const GAUSS: [(f64, f64); 8] = {
    const X: [f64; 4] =
        [0.183_434_642_495_649_8, 0.525_532_409_916_329, 0.796_666_477_413_626_7, 0.960_289_856_497_536_3];
    const W: [f64; 4] =
        [0.362_683_783_378_362, 0.313_706_645_877_887_27, 0.222_381_034_453_374_48, 0.101_228_536_290_376_26];
    let mut rule = [(0.0, 0.0); 8];
    let mut k = 0;
    while k < 4 {
        rule[2 * k] = (0.5 - 0.5 * X[k], 0.5 * W[k]);
        rule[2 * k + 1] = (0.5 + 0.5 * X[k], 0.5 * W[k]);
        k += 1;
    }
    rule
};

/// The same with 3 points, exact to degree 5.
pub const GAUSS_3: [(f64, f64); 3] =
    [(0.112_701_665_379_258_31, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_rules_are_exact_for_polynomials_of_their_degree() {
        for (rule, most) in [(&GAUSS[..], 15), (&GAUSS_3[..], 5)] {
            for degree in 0..=most {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(degree)).sum();
                let exact = 1.0 / f64::from(degree + 1);
                assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
            }
        }
    }
}
