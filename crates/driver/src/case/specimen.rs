//! Specimens of crack tests as bodies: each brings its crack, its regions and what holds it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A compact tension specimen, with the proportions of ASTM E399 where nothing else is said. x = 0 is the load line, the
/// crack runs along y = 0 from the mouth to `crack_length`. Its pins are rigid regions that turn; no holes are cut.
///
/// It brings the crack `crack` and the regions `upper_pin`, `lower_pin`, `pins` (both) and, with all within a horizon of them,
/// `around_upper_pin`, `around_lower_pin`, `around_pins`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompactTension {
    /// Width W from the load line to the back face, > 0.
    pub width: f64,
    /// Crack length a from the load line, > 0.
    pub crack_length: f64,
    /// Cells per quarter of the width; the spacing is W/(4 cells). Multiples of 5 put the crack between rows.
    pub cells: usize,
    /// How far the pins move apart at a load factor of one, half of it each; their displacement along x is zero.
    pub opening: f64,
    /// Whole height; 1.2 W if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// From the mouth to the load line; W/4 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub back: Option<f64>,
    /// Radius of the pins; W/8 if not given. Points on their rim belong to them where they pull, else to the plate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pin_radius: Option<f64>,
    /// Distance of their centres from the plane of the crack; 0.275 W if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pin_distance: Option<f64>,
    /// The pins bear within this angle to either side of the direction in which they pull, degrees; 60 if not given, 180 if
    /// they are glued all around.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bearing: Option<f64>,
}

/// A bend specimen with an edge crack, on two rollers with a third one against it. The crack runs along x = 0 from the
/// bottom, y = 0, to `crack_length`. Rollers are small rigid regions that turn; both supports slide along x.
///
/// It brings the crack `crack` and the regions `left_roller`, `right_roller`, `load_roller`, `rollers` (all three) and, with
/// all within a horizon of them, the same with `around_` before their names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingleEdgeBend {
    /// Width W from the bottom to the top, > 0.
    pub width: f64,
    /// Crack length a from the bottom, > 0.
    pub crack_length: f64,
    /// Cells per width; the spacing is W/cells. Multiples of 4 put the crack between columns of the usual length.
    pub cells: usize,
    /// How far the load roller moves down at a load factor of one.
    pub deflection: f64,
    /// Distance of the supports; 4 W if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub span: Option<f64>,
    /// Whole length; 4.5 W if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Radius of the parts of the body that move with the rollers; W/20 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roller_radius: Option<f64>,
}

/// A panel with a crack in its middle, along y = 0 from -`crack_length`/2 to `crack_length`/2. The origin is its centre.
///
/// It brings the crack `crack`. Its ends are the edges `bottom` and `top`; what pulls them is `opening`, or loads of the
/// case. Without `opening`, and supports of the case, two points beside the middle of the right edge hold it without force.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CentreCrackedPanel {
    /// Whole width, > 0.
    pub width: f64,
    /// Whole height, > 0.
    pub height: f64,
    /// Whole length of the crack, > 0.
    pub crack_length: f64,
    /// Cells per width; the spacing is width/cells.
    pub cells: usize,
    /// How far the ends move apart at a load factor of one, half of it each; they are free along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub opening: Option<f64>,
}
