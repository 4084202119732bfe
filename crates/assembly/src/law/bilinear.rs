//! Elastic up to a yield stretch, then softening linearly to nothing at a failure stretch (Yolum, Taştan, Güler 2016).
//!
//! The source shows the envelope and calls it micro-plastic; what happens on unloading and in compression it does not say.
//! Two readings are offered. *Plastic*: the bond keeps a permanent stretch `s_p` and unloads with its elastic slope; a
//! variable κ, equal to the permanent stretch as long as only tension flows, lowers the limit `s_y (1 − κ/s_f)`. *Damage*:
//! the bond unloads towards the origin and is as stiff as ever in compression. Both have the same envelope and the same
//! fracture energy `s_y s_f/2`. With `s_f = s_y` a bond is brittle.

use super::{BondEnergy, Law, Piece, Response};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// How near to the failure stretch a bond counts as failed.
const FAILED: f64 = 1.0 - 1e-12;

/// How a bond unloads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Unloading {
    /// With its elastic slope: it keeps a permanent stretch, and bears compression where it is still longer than it was.
    #[default]
    Plastic,
    /// Towards the origin: no stretch remains.
    Damage,
}

/// How a bond answers compression.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Compression {
    /// Elastically, whatever it has been through.
    #[default]
    Elastic,
    /// It flows at the force of its yield stretch and does not soften; with plastic unloading.
    PerfectlyPlastic,
}

/// What a bond remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Permanent stretch.
    pub permanent: f64,
    /// How far it has softened, a stretch: κ with plastic unloading, the largest stretch beyond yield with damage.
    pub softened: f64,
    /// Energy that it has dissipated in compression.
    pub pressed: f64,
    /// Whether it bears nothing for good.
    pub broken: bool,
}

/// Why there is no such law.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum BilinearError {
    /// Bonds would fail before they yield: the force would have to snap back inside a bond.
    #[error("the failure stretch {failure} is not above the yield stretch {yielding}")]
    FailsBeforeItYields {
        /// s_f.
        failure: f64,
        /// s_y.
        yielding: f64,
    },
    /// A stretch is not positive.
    #[error("yield and failure stretch must be positive, found {0} and {1}")]
    NotPositive(f64, f64),
    /// Damage has no plastic compression.
    #[error("perfectly plastic compression goes with plastic unloading")]
    PlasticDamage,
}

/// The bilinear law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bilinear {
    yield_stretch: f64,
    failure_stretch: f64,
    unloading: Unloading,
    compression: Compression,
}

impl Bilinear {
    /// A law with `0 < s_y <= s_f`; stretches are without unit.
    ///
    /// # Errors
    /// [`BilinearError`].
    pub fn new(
        [yield_stretch, failure_stretch]: [f64; 2],
        unloading: Unloading,
        compression: Compression,
    ) -> Result<Self, BilinearError> {
        if !(yield_stretch > 0.0 && failure_stretch > 0.0) {
            return Err(BilinearError::NotPositive(yield_stretch, failure_stretch));
        }
        if failure_stretch < yield_stretch {
            return Err(BilinearError::FailsBeforeItYields {
                failure: failure_stretch,
                yielding: yield_stretch,
            });
        }
        if unloading == Unloading::Damage && compression == Compression::PerfectlyPlastic {
            return Err(BilinearError::PlasticDamage);
        }
        Ok(Self { yield_stretch, failure_stretch, unloading, compression })
    }

    /// The same bond without limits: elastic for ever.
    #[must_use]
    pub fn elastic() -> Self {
        Self {
            yield_stretch: f64::INFINITY,
            failure_stretch: f64::INFINITY,
            unloading: Unloading::Plastic,
            compression: Compression::Elastic,
        }
    }

    /// The law of a part of a bond that takes as much energy as the whole one: it yields at the same stretch and fails at one
    /// over the part of that of the whole.
    #[must_use]
    pub fn of_part(&self, part: f64) -> Self {
        Self { failure_stretch: self.failure_stretch / part, ..*self }
    }

    /// Yield stretch s_y.
    pub fn yield_stretch(&self) -> f64 {
        self.yield_stretch
    }

    /// Failure stretch s_f.
    pub fn failure_stretch(&self) -> f64 {
        self.failure_stretch
    }

    /// `s_f/s_y`: about 5 is easy, below 2.5 bodies snap back.
    pub fn brittleness(&self) -> f64 {
        self.failure_stretch / self.yield_stretch
    }

    fn is_elastic(&self) -> bool {
        self.yield_stretch == f64::INFINITY
    }

    /// Stretch beyond the permanent one at which the bond flows in tension.
    fn limit(&self, h: &History) -> f64 {
        match self.unloading {
            Unloading::Plastic => self.yield_stretch * (1.0 - h.softened / self.failure_stretch),
            Unloading::Damage => self.yield_stretch + h.softened,
        }
    }

    /// Force at the limit.
    fn limit_force(&self, h: &History) -> f64 {
        match self.unloading {
            Unloading::Plastic => self.limit(h),
            Unloading::Damage if h.softened == 0.0 => self.yield_stretch,
            Unloading::Damage => {
                -self.softening_slope() * (self.failure_stretch - self.yield_stretch - h.softened).max(0.0)
            }
        }
    }

    /// Elastic slope at a stretch beyond the permanent one.
    fn slope(&self, x: f64, h: &History) -> f64 {
        match self.unloading {
            Unloading::Damage if x > 0.0 && h.softened > 0.0 => self.limit_force(h) / self.limit(h),
            _ => 1.0,
        }
    }

    fn elastic_response(&self, x: f64, h: &History) -> Response {
        if self.compression == Compression::PerfectlyPlastic && x < -self.yield_stretch {
            let y = self.yield_stretch;
            return Response { force: -y, tangent: 0.0, secant: -y / x, energy: 0.5 * y * y + y * (-y - x) };
        }
        let slope = self.slope(x, h);
        Response { force: slope * x, tangent: slope, secant: slope, energy: 0.5 * slope * x * x }
    }
}

impl Law for Bilinear {
    type History = History;

    fn response(&self, stretch: f64, h: &History) -> Response {
        if h.broken {
            return Response::default();
        }
        let x = stretch - h.permanent;
        if self.is_elastic() {
            return Response { force: x, tangent: 1.0, secant: 1.0, energy: 0.5 * x * x };
        }
        let limit = self.limit(h);
        if x <= limit {
            return self.elastic_response(x, h);
        }
        let (top, end) = (self.limit_force(h), self.failure(h) - h.permanent);
        let elastic = 0.5 * top * limit;
        if x >= end {
            return Response { energy: elastic + 0.5 * top * (end - limit), ..Response::default() };
        }
        let slope = self.softening_slope();
        let force = top + slope * (x - limit);
        Response {
            force,
            tangent: slope,
            secant: force / x,
            energy: elastic + 0.5 * (top + force) * (x - limit),
        }
    }

    fn commit(&self, stretch: f64, h: &History) -> History {
        if h.broken || self.is_elastic() {
            return *h;
        }
        let x = stretch - h.permanent;
        if x > self.limit(h) {
            if stretch >= self.failure(h) {
                return self.broken(h);
            }
            let next = match self.unloading {
                Unloading::Plastic => {
                    let permanent = stretch - self.response(stretch, h).force;
                    let softened = h.softened + (permanent - h.permanent);
                    History { permanent, softened, ..*h }
                }
                Unloading::Damage => History { softened: stretch - self.yield_stretch, ..*h },
            };
            let failed = self.damage(&next) >= FAILED;
            return if failed { self.broken(&next) } else { next };
        }
        if self.compression == Compression::PerfectlyPlastic && x < -self.yield_stretch {
            let flown = -self.yield_stretch - x;
            return History {
                permanent: h.permanent - flown,
                pressed: h.pressed + self.yield_stretch * flown,
                ..*h
            };
        }
        *h
    }

    fn energies(&self, stretch: f64, h: &History) -> BondEnergy {
        if self.is_elastic() {
            return BondEnergy { stored: self.response(stretch, h).energy, dissipated: 0.0 };
        }
        let (y, f) = (self.yield_stretch, self.failure_stretch);
        let force = self.response(stretch, h).force;
        let (stored, dissipated) = match self.unloading {
            Unloading::Plastic => (0.5 * force * force, y * (h.softened - 0.5 * h.softened * h.softened / f)),
            Unloading::Damage => (0.5 * force * stretch, 0.5 * y * f * self.damage(h)),
        };
        BondEnergy { stored, dissipated: dissipated + h.pressed }
    }

    fn piece(&self, stretch: f64, h: &History) -> Piece {
        let none = Piece {
            slope: 0.0,
            upper: f64::INFINITY,
            lower: f64::NEG_INFINITY,
            flows_below: false,
            bend: f64::INFINITY,
        };
        if h.broken {
            return none;
        }
        if self.is_elastic() {
            return Piece { slope: 1.0, ..none };
        }
        let x = stretch - h.permanent;
        let piece = Piece { slope: self.slope(x, h), upper: h.permanent + self.limit(h), ..none };
        let bent = self.unloading == Unloading::Damage && h.softened > 0.0;
        match self.compression {
            Compression::PerfectlyPlastic => {
                Piece { lower: h.permanent - self.yield_stretch, flows_below: true, ..piece }
            }
            Compression::Elastic if bent && x > 0.0 => Piece { lower: 0.0, ..piece },
            Compression::Elastic if bent => Piece { bend: 0.0, ..piece },
            Compression::Elastic => piece,
        }
    }

    fn softening_slope(&self) -> f64 {
        -self.yield_stretch / (self.failure_stretch - self.yield_stretch)
    }

    fn failure(&self, h: &History) -> f64 {
        match self.unloading {
            Unloading::Plastic => h.permanent + self.limit(h) * self.brittleness(),
            Unloading::Damage => self.failure_stretch,
        }
    }

    fn dissipation_rate(&self) -> f64 {
        0.5 * self.yield_stretch * self.brittleness() / (self.brittleness() - 1.0)
    }

    fn damage(&self, h: &History) -> f64 {
        if h.broken {
            return 1.0;
        }
        if self.is_elastic() || h.softened == 0.0 {
            return 0.0;
        }
        match self.unloading {
            Unloading::Plastic => h.softened / self.failure_stretch,
            Unloading::Damage => (h.softened / (self.failure_stretch - self.yield_stretch)).min(1.0),
        }
    }

    fn is_broken(&self, h: &History) -> bool {
        h.broken
    }

    fn broken(&self, h: &History) -> History {
        let softened = match self.unloading {
            Unloading::Plastic => self.failure_stretch,
            Unloading::Damage => self.failure_stretch - self.yield_stretch,
        };
        History { softened, broken: true, ..*h }
    }
}
