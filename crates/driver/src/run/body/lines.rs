//! The places of unknowns on the rows of a lattice, along which a cycle makes membranes coarser.

use crate::run::semicoarsened::COARSEST;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::system::System;
use peristat_solve::LinePlace;

/// Whether a lattice is worth coarser levels: with fewer columns it would be the coarsest itself, whose factor takes as long as cycles
/// over one that is half as long, and leaves three digits more.
pub(super) fn suits(lattice: &SquareLattice) -> bool {
    lattice.columns().len() > COARSEST as usize
}

/// The places of all unknowns; none of those that are held or follow others. None at all where the body has no such levels.
pub(super) fn places<const D: usize>(
    model: &dyn BodyModel,
    system: &System<D>,
) -> Option<Vec<Option<LinePlace>>> {
    let (lattice, _) = model.lattice().filter(|(lattice, _)| model.needs_all_rows() && suits(lattice))?;
    let (columns, rows) = (lattice.columns(), lattice.rows());
    let cells = (0..D).flat_map(|c| (0..lattice.points()).map(move |point| (c, lattice.cell(point))));
    let place = |(component, [column, row, _]): (usize, [i32; 3])| {
        let line = component * rows.len() + (row - rows.start) as usize;
        Some(LinePlace { station: (column - columns.start) as u32, line: line as u32 })
    };
    let mut places: Vec<Option<LinePlace>> = cells.map(place).collect();
    system.constraints().rows().iter().for_each(|row| places[row.unknown] = None);
    places.iter().any(Option::is_some).then_some(places)
}
