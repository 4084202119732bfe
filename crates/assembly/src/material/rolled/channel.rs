//! Rolled channels: flanges that grow thinner outwards, rounded where they meet the web and at their toes.

use crate::material::Section;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Dimensions of DIN 1026-1, mm.
#[derive(Debug, PartialEq)]
pub(super) struct Channel {
    pub(super) name: &'static str,
    /// Height, width of the flanges, thickness of the web and of each flange, which is also the radius of its root, radius of its toe.
    size: [f64; 5],
}

impl Channel {
    /// Slope of the inner faces of the flanges, and where on them, from the back of the web, they are as thick as the table says.
    fn slope(&self) -> (f64, f64) {
        let [height, width, web, ..] = self.size;
        if height <= 300.0 { (0.08, width / 2.0) } else { (0.05, f64::midpoint(width, web)) }
    }

    /// Its properties about the strong axis, in a unit of which a millimetre is so much; κ is the area of the web over that of the section,
    /// as for every I.
    pub(super) fn section(&self, millimetre: f64) -> Section {
        let [height, width, web, flange, toe] = self.size;
        let (slope, middle) = self.slope();
        // Distance of the inner face of a flange from the axis, at the web and at the toe.
        let inner = |x: f64| height / 2.0 - flange + slope * (x - middle);
        let (root_face, toe_face, reach) = (inner(web), inner(width), width - web);
        let flanges = reach * (height - root_face - toe_face);
        let hollow = reach * (root_face + toe_face) * (root_face.powi(2) + toe_face.powi(2)) / 4.0;
        let web_moment = web * height.powi(3) / 12.0;
        let flange_moment = 2.0 / 3.0 * (reach * (height / 2.0).powi(3) - hollow);
        // What a circle leaves of the corner that it rounds, over the square of its radius; the slope makes both corners blunt.
        let angle = slope.atan();
        let corner = 1.0 / (FRAC_PI_4 + angle / 2.0).tan() - (FRAC_PI_2 - angle) / 2.0;
        // Its centroid, radii from the corner, is next to that in a right angle.
        let centroid = (5.0 / 6.0 - FRAC_PI_4) / (1.0 - PI / 4.0);
        let round = |radius: f64, arm: f64| {
            let area = 2.0 * corner * radius * radius;
            (area, area * arm * arm)
        };
        let (root_area, root_moment) = round(flange, root_face - centroid * flange);
        let (toe_area, toe_moment) = round(toe, toe_face + centroid * toe);
        let area = height * web + flanges + root_area - toe_area;
        Section::General {
            area: area * millimetre.powi(2),
            second_moment: (web_moment + flange_moment + root_moment - toe_moment) * millimetre.powi(4),
            kappa: height * web / area,
            height: Some(height * millimetre),
        }
    }
}

const fn channel(name: &'static str, size: [f64; 5]) -> Channel {
    Channel { name, size }
}

pub(super) static TABLE: [Channel; 18] = [
    channel("UPN 50", [50.0, 38.0, 5.0, 7.0, 3.5]),
    channel("UPN 65", [65.0, 42.0, 5.5, 7.5, 4.0]),
    channel("UPN 80", [80.0, 45.0, 6.0, 8.0, 4.0]),
    channel("UPN 100", [100.0, 50.0, 6.0, 8.5, 4.5]),
    channel("UPN 120", [120.0, 55.0, 7.0, 9.0, 4.5]),
    channel("UPN 140", [140.0, 60.0, 7.0, 10.0, 5.0]),
    channel("UPN 160", [160.0, 65.0, 7.5, 10.5, 5.5]),
    channel("UPN 180", [180.0, 70.0, 8.0, 11.0, 5.5]),
    channel("UPN 200", [200.0, 75.0, 8.5, 11.5, 6.0]),
    channel("UPN 220", [220.0, 80.0, 9.0, 12.5, 6.5]),
    channel("UPN 240", [240.0, 85.0, 9.5, 13.0, 6.5]),
    channel("UPN 260", [260.0, 90.0, 10.0, 14.0, 7.0]),
    channel("UPN 280", [280.0, 95.0, 10.0, 15.0, 7.5]),
    channel("UPN 300", [300.0, 100.0, 10.0, 16.0, 8.0]),
    channel("UPN 320", [320.0, 100.0, 14.0, 17.5, 8.75]),
    channel("UPN 350", [350.0, 100.0, 14.0, 16.0, 8.0]),
    channel("UPN 380", [380.0, 102.0, 13.5, 16.0, 8.0]),
    channel("UPN 400", [400.0, 110.0, 14.0, 18.0, 9.0]),
];
