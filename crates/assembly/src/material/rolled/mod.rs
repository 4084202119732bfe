//! Rolled steel sections by name.

mod channel;

use super::Section;
use channel::Channel;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// A rolled section of the table, chosen by its name such as `IPE 270`; blanks and case do not matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolled(Profile);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Profile {
    I(&'static Shape),
    Channel(&'static Channel),
}

/// Dimensions of EN 10365 or, of wide flanges, of the AISC Manual, mm.
#[derive(Debug, PartialEq)]
struct Shape {
    name: &'static str,
    /// Height, width of the flanges, thickness of the web and of each flange, radius of the fillets.
    size: [f64; 5],
}

impl Rolled {
    /// The rolled section of a name; `HE 300 B` is `HEB 300`.
    pub fn of(name: &str) -> Option<Self> {
        let plain = |name: &str| name.split_whitespace().collect::<String>().to_uppercase();
        let mut wanted = plain(name);
        let series = wanted.chars().next_back().filter(|series| "ABM".contains(*series));
        if let Some((size, series)) = wanted.strip_prefix("HE").zip(series) {
            wanted = format!("HE{series}{}", size.trim_end_matches(series));
        }
        all().find(|rolled| plain(rolled.name()) == wanted)
    }

    /// All names.
    pub fn names() -> impl Iterator<Item = &'static str> {
        all().map(Self::name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self.0 {
            Profile::I(shape) => shape.name,
            Profile::Channel(channel) => channel.name,
        }
    }

    /// Its shape, in a unit of which a millimetre is so much.
    pub fn section(self, millimetre: f64) -> Section {
        match self.0 {
            Profile::I(shape) => {
                let [height, width, web, flange, fillet] = shape.size.map(|length| millimetre * length);
                Section::I { width, height, web, flange, fillet }
            }
            Profile::Channel(channel) => channel.section(millimetre),
        }
    }
}

fn all() -> impl Iterator<Item = Rolled> {
    let channels = channel::TABLE.iter().map(Profile::Channel);
    TABLE.iter().map(Profile::I).chain(channels).map(Rolled)
}

impl Serialize for Rolled {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for Rolled {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Self::of(&name).ok_or_else(|| de::Error::unknown_variant(&name, &NAMES))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Rolled {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Rolled".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A rolled steel section by its name: IPE, HEA, HEB and HEM of EN 10365, W of the AISC Manual, UPN of DIN 1026-1; or a profile of the `library` of the case.",
            "anyOf": [{ "type": "string", "enum": NAMES.to_vec() }, { "type": "string" }]
        })
    }
}

const NAMES: [&str; TABLE.len() + channel::TABLE.len()] = {
    let mut names = [""; TABLE.len() + channel::TABLE.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = if k < TABLE.len() { TABLE[k].name } else { channel::TABLE[k - TABLE.len()].name };
        k += 1;
    }
    names
};

const fn shape(name: &'static str, size: [f64; 5]) -> Shape {
    Shape { name, size }
}

/// A wide flange of the AISC Manual, inches: depth, width, web, flange, and the distance from the outer face to the foot of the fillet.
const fn wide(name: &'static str, [depth, width, web, flange, foot]: [f64; 5]) -> Shape {
    const INCH: f64 = 25.4;
    shape(name, [INCH * depth, INCH * width, INCH * web, INCH * flange, INCH * (foot - flange)])
}

static TABLE: [Shape; 111] = [
    shape("IPE 80", [80.0, 46.0, 3.8, 5.2, 5.0]),
    shape("IPE 100", [100.0, 55.0, 4.1, 5.7, 7.0]),
    shape("IPE 120", [120.0, 64.0, 4.4, 6.3, 7.0]),
    shape("IPE 140", [140.0, 73.0, 4.7, 6.9, 7.0]),
    shape("IPE 160", [160.0, 82.0, 5.0, 7.4, 9.0]),
    shape("IPE 180", [180.0, 91.0, 5.3, 8.0, 9.0]),
    shape("IPE 200", [200.0, 100.0, 5.6, 8.5, 12.0]),
    shape("IPE 220", [220.0, 110.0, 5.9, 9.2, 12.0]),
    shape("IPE 240", [240.0, 120.0, 6.2, 9.8, 15.0]),
    shape("IPE 270", [270.0, 135.0, 6.6, 10.2, 15.0]),
    shape("IPE 300", [300.0, 150.0, 7.1, 10.7, 15.0]),
    shape("IPE 330", [330.0, 160.0, 7.5, 11.5, 18.0]),
    shape("IPE 360", [360.0, 170.0, 8.0, 12.7, 18.0]),
    shape("IPE 400", [400.0, 180.0, 8.6, 13.5, 21.0]),
    shape("IPE 450", [450.0, 190.0, 9.4, 14.6, 21.0]),
    shape("IPE 500", [500.0, 200.0, 10.2, 16.0, 21.0]),
    shape("IPE 550", [550.0, 210.0, 11.1, 17.2, 24.0]),
    shape("IPE 600", [600.0, 220.0, 12.0, 19.0, 24.0]),
    shape("HEA 100", [96.0, 100.0, 5.0, 8.0, 12.0]),
    shape("HEA 120", [114.0, 120.0, 5.0, 8.0, 12.0]),
    shape("HEA 140", [133.0, 140.0, 5.5, 8.5, 12.0]),
    shape("HEA 160", [152.0, 160.0, 6.0, 9.0, 15.0]),
    shape("HEA 180", [171.0, 180.0, 6.0, 9.5, 15.0]),
    shape("HEA 200", [190.0, 200.0, 6.5, 10.0, 18.0]),
    shape("HEA 220", [210.0, 220.0, 7.0, 11.0, 18.0]),
    shape("HEA 240", [230.0, 240.0, 7.5, 12.0, 21.0]),
    shape("HEA 260", [250.0, 260.0, 7.5, 12.5, 24.0]),
    shape("HEA 280", [270.0, 280.0, 8.0, 13.0, 24.0]),
    shape("HEA 300", [290.0, 300.0, 8.5, 14.0, 27.0]),
    shape("HEA 320", [310.0, 300.0, 9.0, 15.5, 27.0]),
    shape("HEA 340", [330.0, 300.0, 9.5, 16.5, 27.0]),
    shape("HEA 360", [350.0, 300.0, 10.0, 17.5, 27.0]),
    shape("HEA 400", [390.0, 300.0, 11.0, 19.0, 27.0]),
    shape("HEA 450", [440.0, 300.0, 11.5, 21.0, 27.0]),
    shape("HEA 500", [490.0, 300.0, 12.0, 23.0, 27.0]),
    shape("HEA 550", [540.0, 300.0, 12.5, 24.0, 27.0]),
    shape("HEA 600", [590.0, 300.0, 13.0, 25.0, 27.0]),
    shape("HEA 650", [640.0, 300.0, 13.5, 26.0, 27.0]),
    shape("HEA 700", [690.0, 300.0, 14.5, 27.0, 27.0]),
    shape("HEA 800", [790.0, 300.0, 15.0, 28.0, 30.0]),
    shape("HEA 900", [890.0, 300.0, 16.0, 30.0, 30.0]),
    shape("HEA 1000", [990.0, 300.0, 16.5, 31.0, 30.0]),
    shape("HEB 100", [100.0, 100.0, 6.0, 10.0, 12.0]),
    shape("HEB 120", [120.0, 120.0, 6.5, 11.0, 12.0]),
    shape("HEB 140", [140.0, 140.0, 7.0, 12.0, 12.0]),
    shape("HEB 160", [160.0, 160.0, 8.0, 13.0, 15.0]),
    shape("HEB 180", [180.0, 180.0, 8.5, 14.0, 15.0]),
    shape("HEB 200", [200.0, 200.0, 9.0, 15.0, 18.0]),
    shape("HEB 220", [220.0, 220.0, 9.5, 16.0, 18.0]),
    shape("HEB 240", [240.0, 240.0, 10.0, 17.0, 21.0]),
    shape("HEB 260", [260.0, 260.0, 10.0, 17.5, 24.0]),
    shape("HEB 280", [280.0, 280.0, 10.5, 18.0, 24.0]),
    shape("HEB 300", [300.0, 300.0, 11.0, 19.0, 27.0]),
    shape("HEB 320", [320.0, 300.0, 11.5, 20.5, 27.0]),
    shape("HEB 340", [340.0, 300.0, 12.0, 21.5, 27.0]),
    shape("HEB 360", [360.0, 300.0, 12.5, 22.5, 27.0]),
    shape("HEB 400", [400.0, 300.0, 13.5, 24.0, 27.0]),
    shape("HEB 450", [450.0, 300.0, 14.0, 26.0, 27.0]),
    shape("HEB 500", [500.0, 300.0, 14.5, 28.0, 27.0]),
    shape("HEB 550", [550.0, 300.0, 15.0, 29.0, 27.0]),
    shape("HEB 600", [600.0, 300.0, 15.5, 30.0, 27.0]),
    shape("HEB 650", [650.0, 300.0, 16.0, 31.0, 27.0]),
    shape("HEB 700", [700.0, 300.0, 17.0, 32.0, 27.0]),
    shape("HEB 800", [800.0, 300.0, 17.5, 33.0, 30.0]),
    shape("HEB 900", [900.0, 300.0, 18.5, 35.0, 30.0]),
    shape("HEB 1000", [1000.0, 300.0, 19.0, 36.0, 30.0]),
    shape("HEM 100", [120.0, 106.0, 12.0, 20.0, 12.0]),
    shape("HEM 120", [140.0, 126.0, 12.5, 21.0, 12.0]),
    shape("HEM 140", [160.0, 146.0, 13.0, 22.0, 12.0]),
    shape("HEM 160", [180.0, 166.0, 14.0, 23.0, 15.0]),
    shape("HEM 180", [200.0, 186.0, 14.5, 24.0, 15.0]),
    shape("HEM 200", [220.0, 206.0, 15.0, 25.0, 18.0]),
    shape("HEM 220", [240.0, 226.0, 15.5, 26.0, 18.0]),
    shape("HEM 240", [270.0, 248.0, 18.0, 32.0, 21.0]),
    shape("HEM 260", [290.0, 268.0, 18.0, 32.5, 24.0]),
    shape("HEM 280", [310.0, 288.0, 18.5, 33.0, 24.0]),
    shape("HEM 300", [340.0, 310.0, 21.0, 39.0, 27.0]),
    shape("HEM 320", [359.0, 309.0, 21.0, 40.0, 27.0]),
    shape("HEM 340", [377.0, 309.0, 21.0, 40.0, 27.0]),
    shape("HEM 360", [395.0, 308.0, 21.0, 40.0, 27.0]),
    shape("HEM 400", [432.0, 307.0, 21.0, 40.0, 27.0]),
    shape("HEM 450", [478.0, 307.0, 21.0, 40.0, 27.0]),
    shape("HEM 500", [524.0, 306.0, 21.0, 40.0, 27.0]),
    shape("HEM 550", [572.0, 306.0, 21.0, 40.0, 27.0]),
    shape("HEM 600", [620.0, 305.0, 21.0, 40.0, 27.0]),
    shape("HEM 650", [668.0, 305.0, 21.0, 40.0, 27.0]),
    shape("HEM 700", [716.0, 304.0, 21.0, 40.0, 27.0]),
    shape("HEM 800", [814.0, 303.0, 21.0, 40.0, 30.0]),
    shape("HEM 900", [910.0, 302.0, 21.0, 40.0, 30.0]),
    shape("HEM 1000", [1008.0, 302.0, 21.0, 40.0, 30.0]),
    wide("W 6x15", [5.99, 5.99, 0.23, 0.26, 0.51]),
    wide("W 8x10", [7.89, 3.94, 0.17, 0.205, 0.505]),
    wide("W 8x31", [8.0, 8.0, 0.285, 0.435, 0.829]),
    wide("W 10x12", [9.87, 3.96, 0.19, 0.21, 0.51]),
    wide("W 10x49", [9.98, 10.0, 0.34, 0.56, 1.06]),
    wide("W 12x14", [11.9, 3.97, 0.2, 0.225, 0.525]),
    wide("W 12x26", [12.2, 6.49, 0.23, 0.38, 0.68]),
    wide("W 12x50", [12.2, 8.08, 0.37, 0.64, 1.14]),
    wide("W 12x65", [12.1, 12.0, 0.39, 0.605, 1.2]),
    wide("W 14x90", [14.0, 14.5, 0.44, 0.71, 1.31]),
    wide("W 16x26", [15.7, 5.5, 0.25, 0.345, 0.747]),
    wide("W 16x31", [15.9, 5.53, 0.275, 0.44, 0.842]),
    wide("W 18x35", [17.7, 6.0, 0.3, 0.425, 0.827]),
    wide("W 18x50", [18.0, 7.5, 0.355, 0.57, 0.972]),
    wide("W 21x44", [20.7, 6.5, 0.35, 0.45, 0.95]),
    wide("W 21x62", [21.0, 8.24, 0.4, 0.615, 1.12]),
    wide("W 24x55", [23.6, 7.01, 0.395, 0.505, 1.01]),
    wide("W 24x68", [23.7, 8.97, 0.415, 0.585, 1.09]),
    wide("W 24x76", [23.9, 8.99, 0.44, 0.68, 1.18]),
    wide("W 27x84", [26.7, 10.0, 0.46, 0.64, 1.24]),
    wide("W 36x150", [35.9, 12.0, 0.625, 0.94, 1.69]),
];

#[cfg(test)]
mod tests;
