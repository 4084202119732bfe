//! Cells of maps: their values, their colours, and the light on them.

/// A cell with its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Corners, around.
    pub corners: [[f64; 2]; 4],
    /// Value; a cell of a value that is no number is grey.
    pub value: f64,
    /// How much light falls on it.
    pub light: Light,
}

impl Patch {
    /// A cell in the plane.
    pub fn flat(corners: [[f64; 2]; 4], value: f64) -> Self {
        Self { corners, value, light: Light::Full }
    }
}

/// Light on a cell: sides of a body in space have different ones, so that its form is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Light {
    /// From in front.
    Full,
    /// From the side.
    Half,
    /// In the shade.
    Low,
}

impl Light {
    pub(super) const ALL: [Self; 3] = [Self::Full, Self::Half, Self::Low];

    /// Factor on a colour, small enough a difference for the colour bar to be read.
    fn factor(self) -> f64 {
        match self {
            Self::Full => 1.0,
            Self::Half => 0.88,
            Self::Low => 0.76,
        }
    }
}

/// The colour map viridis (van der Walt and Smith 2015) at equal steps: even for the eye, also without colours.
const VIRIDIS: [[u8; 3]; 11] = [
    [68, 1, 84],
    [72, 36, 117],
    [65, 68, 135],
    [53, 95, 141],
    [42, 120, 142],
    [33, 145, 140],
    [34, 168, 132],
    [68, 191, 112],
    [122, 209, 81],
    [189, 223, 38],
    [253, 231, 37],
];

/// The colour at a part of the range, 0 to 1, in some light.
pub(super) fn color(part: f64, light: Light) -> String {
    let at = part.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let low = (at.floor() as usize).min(VIRIDIS.len() - 2);
    let share = at - low as f64;
    let mix = |k: usize| {
        let [a, b] = [low, low + 1].map(|i| f64::from(VIRIDIS[i][k]));
        (light.factor() * (a + share * (b - a))).round() as u8
    };
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_run_from_one_end_of_the_table_to_the_other() {
        assert_eq!([0.0, 0.5, 1.0].map(|part| color(part, Light::Full)), ["#440154", "#21918c", "#fde725"]);
        // [33, 145, 140] times 1, 0.88 and 0.76.
        assert_eq!(Light::ALL.map(|light| color(0.5, light)), ["#21918c", "#1d807b", "#196e6a"]);
    }
}
