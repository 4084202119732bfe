//! Pressures on plates.

use super::plate_loads::PlateLoads;
use super::site::Site;
use crate::case::{Amount, Pressure};
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plate_bending::PlateBending;

/// Places of Gauss' rule of two points from the middle of an interval, per its length.
const GAUSS: f64 = 0.288_675_134_594_812_9;
/// Part of a pressure by formula that its values at the points may miss without a word: of a sine with 13 cells per half wave.
pub(super) const COARSE: f64 = 0.01;

/// The cells that are loaded: those of a region, or all.
#[derive(Clone)]
pub(super) struct Loaded(Option<Vec<u32>>);

impl Loaded {
    /// Their numbers, ascending; none of all.
    pub(super) fn numbers(self) -> Option<Vec<u32>> {
        self.0
    }

    /// Whether a cell of the plate is.
    pub(super) fn has(&self, site: &Site, [column, row]: [i32; 2]) -> bool {
        match (&self.0, site.nodes.cells().number([column, row, 0])) {
            (Some(region), Some(number)) => region.binary_search(&(number as u32)).is_ok(),
            _ => true,
        }
    }
}

/// The cells of a region of a load; none with a fault if it has none.
pub(super) fn inside(
    region: Option<&String>,
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Loaded> {
    let Some(name) = region else { return Some(Loaded(None)) };
    if !site.case.regions.contains_key(name) && site.outline.members(name).is_some() {
        faults
            .error(
                path.key("region"),
                format!("`{name}` is a part of the border, and the load acts on cells"),
            )
            .hint("name one of the `regions`; without `region` the load acts on all of the plate");
        return None;
    }
    let found = site.cells.region(name, &path.key("region"), faults);
    // One without points has its fault already; here it may have points, and no middles.
    if found.is_none() && site.case.regions.contains_key(name) {
        let message = format!("no cell has its middle in the region `{name}`: nothing is loaded");
        faults.error(path.key("region"), message).hint("use a larger region, or a smaller spacing");
    }
    Some(Loaded(Some(found?)))
}

/// Places of Gauss' rule in a cell.
pub(super) fn places(site: &Site, [column, row]: [i32; 2]) -> impl Iterator<Item = [f64; 3]> {
    let [x, y] = site.nodes.cells().place_of([column, row, 0]);
    let reach = GAUSS * site.nodes.spacing();
    let signs = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
    signs.into_iter().map(move |(a, b)| [x + a * reach, y + b * reach, 0.0])
}

/// Adds a pressure.
pub(super) fn add(
    load: &Pressure,
    (site, factor): (&Site, Option<f64>),
    plate: &PlateBending,
    path: &JsonPath,
    to: &mut PlateLoads,
    faults: &mut Faults,
) {
    for (key, _) in
        [("harmonic", load.harmonic != 0), ("sharing", load.sharing.is_some())].iter().filter(|key| key.1)
    {
        faults.error(path.key(*key), format!("`{key}` is for shells")).hint("leave it out");
    }
    let given = match &load.formula {
        Some(_) if load.value != 0.0 => {
            faults.error(path.clone(), "`value` and `formula` are both given").hint("remove one of them");
            return;
        }
        Some(formula) => Amount::Formula(formula.clone()),
        None => Amount::Number(load.value),
    };
    let Some(pressure) = Prescribed::new(&given, (2, factor), &path.key("formula"), faults) else { return };
    if pressure.is_zero() && factor.is_none() {
        faults.error(path.clone(), "this load is zero").hint("give `value`, or a `formula`");
    }
    let Some(loaded) = inside(load.region.as_ref(), site, path, faults) else { return };
    let inside = |cell: [i32; 2]| loaded.has(site, cell);
    let at = |[x, y]: [f64; 2]| pressure.at([x, y, 0.0]).unwrap_or(f64::NAN);
    plate.add_pressure(inside, at, &mut to.force);
    let (h, [mut taken, mut asked, mut size]) = (site.nodes.spacing(), [0.0; 3]);
    for cell in site.nodes.all_cells().filter(|&cell| inside(cell)) {
        for [x, y, _] in places(site, cell) {
            let part = 0.25 * h * h * at([x, y]);
            to.asked.add([0.0, 0.0, part], [x, y, 0.0]);
            (asked, size) = (asked + part, size + part.abs());
        }
        let corners = site.nodes.corners(cell).into_iter().flatten();
        taken += corners.map(|point| 0.25 * h * h * at(site.nodes.place(point))).sum::<f64>();
    }
    if (taken - asked).abs() > COARSE * size {
        let message = format!(
            "the pressure is taken at the points: it sums to {}, and is {}",
            tidy(taken),
            tidy(asked)
        );
        faults.warning(path.key("formula"), message).hint("use a smaller spacing");
    }
    to.is_approximate |= load.formula.is_some();
}
