//! Cross-sections of beams.

use super::Rolled;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use thiserror::Error;

/// Shape of a cross-section; lengths in m (or the length unit of the case).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Section {
    /// Solid rectangle, bent about the axis parallel to its width.
    Rectangle {
        /// Width.
        width: f64,
        /// Height, in the direction of the deflection.
        height: f64,
    },
    /// Solid circle.
    Circle {
        /// Diameter.
        diameter: f64,
    },
    /// Circular tube.
    Tube {
        /// Outer diameter.
        diameter: f64,
        /// Wall thickness, at most half the diameter.
        wall: f64,
    },
    /// Symmetric I, bent about its strong axis.
    I {
        /// Width of the flanges.
        width: f64,
        /// Total height.
        height: f64,
        /// Thickness of the web.
        web: f64,
        /// Thickness of each flange.
        flange: f64,
        /// Radius of the fillets between web and flanges; none if not given.
        #[serde(default, skip_serializing_if = "is_zero")]
        fillet: f64,
    },
    /// Rolled steel section by its name, such as `IPE 270`, bent about its strong axis.
    Rolled(Rolled),
    /// Any section, by its properties.
    General {
        /// Area.
        area: f64,
        /// Second moment of area about the bending axis.
        second_moment: f64,
        /// Shear correction factor κ.
        kappa: f64,
        /// Height, if bending stresses are wanted; the extreme fibres are at plus and minus half of it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        height: Option<f64>,
    },
}

/// A number without the digits that rounding left.
fn tidy(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// Where the shear correction factor comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ShearCorrection {
    /// 5/6 rectangle, 9/10 circle, 1/2 thin tube, web over total area for an I.
    #[default]
    Classical,
    /// Cowper's factors with Poisson's ratio (Cowper 1966, J. Appl. Mech. 33, 335-340).
    Cowper,
    /// A given κ.
    Value(f64),
}

/// What the beam needs of a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionProperties {
    /// Area A, m².
    pub area: f64,
    /// Second moment of area I, m⁴.
    pub second_moment: f64,
    /// Shear correction factor κ.
    pub kappa: f64,
    /// Height, m, where the section has one.
    pub height: Option<f64>,
}

/// A section that cannot be.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SectionError {
    /// A dimension is not a positive finite number.
    #[error("`{name}` must be greater than zero, found {value}")]
    NotPositive {
        /// Key of the dimension.
        name: &'static str,
        /// What was given.
        value: f64,
    },
    /// A wall, web or flange does not fit into the outline.
    #[error("`{name}` must be at most {} to fit into the outline, found {value}", tidy(*limit))]
    DoesNotFit {
        /// Key of the dimension.
        name: &'static str,
        /// What was given.
        value: f64,
        /// The largest value that fits.
        limit: f64,
    },
    /// No formula of Cowper is known for the shape.
    #[error("`cowper` has no formula for a general section, nor for a channel")]
    NoCowper,
}

impl Section {
    /// Area, second moment, κ and height, those of a rolled section in millimetres.
    ///
    /// # Errors
    /// [`SectionError`] names the dimension at fault by its key.
    pub fn properties(
        &self,
        shear: ShearCorrection,
        poisson_ratio: f64,
    ) -> Result<SectionProperties, SectionError> {
        for (name, value) in self.dimensions() {
            if !(value > 0.0 && value.is_finite()) {
                return Err(SectionError::NotPositive { name, value });
            }
        }
        for (name, value, limit) in self.limits() {
            if value > limit {
                return Err(SectionError::DoesNotFit { name, value, limit });
            }
        }
        let (area, second_moment, height) = self.geometry();
        let kappa = match shear {
            ShearCorrection::Classical => self.classical(),
            ShearCorrection::Cowper => self.cowper(poisson_ratio)?,
            ShearCorrection::Value(value) if value > 0.0 && value.is_finite() => value,
            ShearCorrection::Value(value) => {
                return Err(SectionError::NotPositive { name: "shear_correction", value });
            }
        };
        Ok(SectionProperties { area, second_moment, kappa, height })
    }

    fn dimensions(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::Rectangle { width, height } => vec![("width", width), ("height", height)],
            Self::Circle { diameter } => vec![("diameter", diameter)],
            Self::Tube { diameter, wall } => vec![("diameter", diameter), ("wall", wall)],
            Self::I { width, height, web, flange, fillet } => {
                let mut all = vec![("width", width), ("height", height), ("web", web), ("flange", flange)];
                all.extend((fillet != 0.0).then_some(("fillet", fillet)));
                all
            }
            Self::Rolled(rolled) => rolled.section(1.0).dimensions(),
            Self::General { area, second_moment, kappa, height } => {
                let mut all = vec![("area", area), ("second_moment", second_moment), ("kappa", kappa)];
                all.extend(height.map(|h| ("height", h)));
                all
            }
        }
    }

    fn limits(&self) -> Vec<(&'static str, f64, f64)> {
        match *self {
            Self::Tube { diameter, wall } => vec![("wall", wall, diameter / 2.0)],
            Self::I { width, height, web, flange, fillet } => vec![
                ("web", web, width),
                ("flange", flange, height / 2.0),
                ("fillet", fillet, (height / 2.0 - flange).min((width - web) / 2.0).max(0.0)),
            ],
            _ => Vec::new(),
        }
    }

    /// Area, second moment of area and height.
    fn geometry(&self) -> (f64, f64, Option<f64>) {
        match *self {
            Self::Rectangle { width: b, height: h } => (b * h, b * h.powi(3) / 12.0, Some(h)),
            Self::Circle { diameter: d } => (PI * d * d / 4.0, PI * d.powi(4) / 64.0, Some(d)),
            Self::Tube { diameter: d, wall } => {
                let inner = d - 2.0 * wall;
                // Sums instead of differences of powers: a thin wall keeps its digits.
                let (sum, difference) = (d * d + inner * inner, 4.0 * wall * (d - wall));
                (PI * difference / 4.0, PI * difference * sum / 64.0, Some(d))
            }
            Self::I { width: b, height: h, web, flange, fillet: r } => {
                let clear = h - 2.0 * flange;
                let arm = h / 2.0 - flange / 2.0;
                let flanges = 2.0 * (b * flange.powi(3) / 12.0 + b * flange * arm * arm);
                // Area, first and second moment of what a quarter of a circle leaves of a square, about a side of it.
                let (a, s, i) = (1.0 - PI / 4.0, 5.0 / 6.0 - PI / 4.0, 1.0 - 5.0 * PI / 16.0);
                let [corner, two] = [clear / 2.0, r * r];
                let fillets = 4.0 * two * (corner * corner * a - 2.0 * corner * r * s + two * i);
                let area = 2.0 * b * flange + clear * web + 4.0 * two * a;
                (area, flanges + web * clear.powi(3) / 12.0 + fillets, Some(h))
            }
            Self::Rolled(rolled) => rolled.section(1.0).geometry(),
            Self::General { area, second_moment, height, .. } => (area, second_moment, height),
        }
    }

    fn classical(&self) -> f64 {
        match *self {
            Self::Rectangle { .. } => 5.0 / 6.0,
            Self::Circle { .. } => 9.0 / 10.0,
            Self::Tube { .. } => 1.0 / 2.0,
            Self::I { height, web, .. } => web * height / self.geometry().0,
            Self::Rolled(rolled) => rolled.section(1.0).classical(),
            Self::General { kappa, .. } => kappa,
        }
    }

    /// Cowper (1966), table 1, ν = `nu`.
    fn cowper(&self, nu: f64) -> Result<f64, SectionError> {
        Ok(match *self {
            Self::Rectangle { .. } => 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu),
            Self::Circle { .. } => 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu),
            Self::Tube { diameter, wall } => {
                let m = (diameter - 2.0 * wall) / diameter;
                let (s, q) = ((1.0 + m * m).powi(2), m * m);
                6.0 * (1.0 + nu) * s / ((7.0 + 6.0 * nu) * s + (20.0 + 12.0 * nu) * q)
            }
            Self::Rolled(rolled) => rolled.section(1.0).cowper(nu)?,
            Self::I { width, height, web, flange, .. } => {
                // Thin-walled I: h between the flange centres, m = 2 b t_f / (h t_w), n = b / h.
                let h = height - flange;
                let (m, n) = (2.0 * width * flange / (h * web), width / h);
                let top = 10.0 * (1.0 + nu) * (1.0 + 3.0 * m).powi(2);
                let a = 12.0 + 72.0 * m + 150.0 * m * m + 90.0 * m.powi(3);
                let b = 11.0 + 66.0 * m + 135.0 * m * m + 90.0 * m.powi(3);
                let c = 30.0 * n * n * (m + m * m) + 5.0 * nu * n * n * (8.0 * m + 9.0 * m * m);
                top / (a + nu * b + c)
            }
            Self::General { .. } => return Err(SectionError::NoCowper),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn properties(section: Section) -> SectionProperties {
        section.properties(ShearCorrection::Classical, 0.3).unwrap()
    }

    #[test]
    fn rectangle_and_circle_have_textbook_properties() {
        let r = properties(Section::Rectangle { width: 0.05, height: 0.2 });
        // b h³/12 with b = 0.05, h = 0.2.
        assert!((r.second_moment - 3.333_333_333_333_333e-5).abs() < 1e-19 && r.kappa == 5.0 / 6.0);
        let c = properties(Section::Circle { diameter: 2.0 });
        assert!((c.area - PI).abs() < 1e-15 && (c.second_moment - PI / 4.0).abs() < 1e-15);
    }

    #[test]
    fn a_tube_whose_wall_fills_it_is_a_circle() {
        let tube = Section::Tube { diameter: 0.3, wall: 0.15 };
        let (t, c) = (properties(tube), properties(Section::Circle { diameter: 0.3 }));
        assert!((t.area / c.area - 1.0).abs() < 1e-15);
        assert!((t.second_moment / c.second_moment - 1.0).abs() < 1e-15);
        let cowper = |s: Section| s.properties(ShearCorrection::Cowper, 0.3).unwrap().kappa;
        assert!((cowper(tube) - cowper(Section::Circle { diameter: 0.3 })).abs() < 1e-15);
    }

    #[test]
    fn an_i_without_recess_is_a_rectangle() {
        let i = Section::I { width: 0.1, height: 0.3, web: 0.1, flange: 0.02, fillet: 0.0 };
        let r = properties(Section::Rectangle { width: 0.1, height: 0.3 });
        assert!((properties(i).second_moment / r.second_moment - 1.0).abs() < 1e-14);
        // IPE 200 without its root fillets: I = 1846 cm⁴ (1943 cm⁴ with them), web h t_w / A = 0.4088.
        let ipe = Section::I { width: 0.1, height: 0.2, web: 0.0056, flange: 0.0085, fillet: 0.0 };
        let p = properties(ipe);
        assert!((p.second_moment - 1.8456e-5).abs() < 1e-8, "{}", p.second_moment);
        // 2·0.1·0.0085 + 0.183·0.0056.
        assert!((p.area - 2.7248e-3).abs() < 1e-15, "{}", p.area);
        assert!((p.kappa - 0.2 * 0.0056 / p.area).abs() < 1e-15);
    }

    #[test]
    fn cowper_rectangle_at_zero_poisson_is_five_sixths() {
        let r = Section::Rectangle { width: 1.0, height: 1.0 };
        let kappa = |nu| r.properties(ShearCorrection::Cowper, nu).unwrap().kappa;
        // 10 (1 + ν)/(12 + 11 ν): 13/15.3 at ν = 0.3.
        assert!((kappa(0.0) - 5.0 / 6.0).abs() < 1e-15 && (kappa(0.3) - 13.0 / 15.3).abs() < 1e-15);
    }

    #[test]
    fn tubes_circles_and_given_numbers_have_textbook_properties() {
        let t = properties(Section::Tube { diameter: 0.3, wall: 0.02 });
        // π/4 (D² − d²) and π/64 (D⁴ − d⁴) with D = 0.3, d = 0.26.
        assert!((t.area / (PI * 0.0056) - 1.0).abs() < 1e-14, "{}", t.area);
        assert!((t.second_moment / (PI / 64.0 * (0.0081 - 0.004_569_76)) - 1.0).abs() < 1e-13);
        assert_eq!(t.height, Some(0.3));
        let c = properties(Section::Circle { diameter: 0.3 });
        assert!((c.area / (PI * 0.0225) - 1.0).abs() < 1e-15);
        assert!((c.second_moment / (PI * 0.0081 / 64.0) - 1.0).abs() < 1e-15);
        let given = Section::General { area: 0.2, second_moment: 0.03, kappa: 0.7, height: Some(0.4) };
        let of = |shear| given.properties(shear, 0.3).unwrap();
        let expected = SectionProperties { area: 0.2, second_moment: 0.03, kappa: 0.7, height: Some(0.4) };
        assert_eq!(of(ShearCorrection::Classical), expected);
        assert_eq!(of(ShearCorrection::Value(0.6)), SectionProperties { kappa: 0.6, ..expected });
        for value in [0.0, -0.5, f64::INFINITY] {
            let error = given.properties(ShearCorrection::Value(value), 0.3).unwrap_err();
            assert_eq!(error, SectionError::NotPositive { name: "shear_correction", value });
        }
    }

    #[test]
    fn cowper_is_his_table_for_thin_and_round_sections() {
        let kappa = |s: Section| s.properties(ShearCorrection::Cowper, 0.3).unwrap().kappa;
        // Circle 6(1 + ν)/(7 + 6ν), thin tube 2(1 + ν)/(4 + 3ν); half as thick a tube by hand: m = 1/2.
        assert!((kappa(Section::Circle { diameter: 0.3 }) - 7.8 / 8.8).abs() < 1e-15);
        let thin = kappa(Section::Tube { diameter: 1.0, wall: 1e-7 });
        assert!((thin - 2.6 / 4.9).abs() < 1e-6, "{thin}");
        let half = kappa(Section::Tube { diameter: 0.4, wall: 0.1 });
        assert!((half - 7.8 * 1.5625 / (8.8 * 1.5625 + 23.6 * 0.25)).abs() < 1e-15, "{half}");
        // Thin-walled I with m = 2 and n = 1/2: 10·1.3·49/(1476 + 0.3·1403 + 45 + 0.3·65).
        let i = Section::I { width: 0.1, height: 0.22, web: 0.01, flange: 0.02, fillet: 0.0 };
        assert!((kappa(i) - 637.0 / 1961.4).abs() < 1e-14, "{}", kappa(i));
    }

    #[test]
    fn impossible_sections_name_the_key() {
        let error = |s: Section| s.properties(ShearCorrection::Classical, 0.3).unwrap_err();
        let negative = error(Section::Rectangle { width: -1.0, height: 0.2 });
        assert_eq!(negative, SectionError::NotPositive { name: "width", value: -1.0 });
        let thick = error(Section::Tube { diameter: 0.1, wall: 0.06 });
        assert_eq!(thick, SectionError::DoesNotFit { name: "wall", value: 0.06, limit: 0.05 });
    }
}
