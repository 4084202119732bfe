//! Hoop strains of the points of a body of revolution that have not all bonds.
//!
//! A point has the energy of its dilatation and of its hoop strain h together, by one volume. What the displacement `u_x` does
//! over the section, `∫ u_x dA`, is a quarter for every whole block around a point, and that of the centres of the parts
//! elsewhere. All of it is handed to the points, who want the volumes that their dilatations have: `Σ V_k h_k` is the change of
//! the circumference of the body as its border has it, and `h_k` that of any displacement `u_x = a x`.

use super::border::follows;
use super::reach::{Lacking, Need, transport};
use super::sources::{Bonded, Source};
use super::transport::Transport;
use crate::stiffness::ConnectedParts;
use std::collections::BTreeMap;

/// Part by which the volumes of a part of the border may be off: at 12 %, beside a narrow bore, its stresses are 15 % wrong.
const MOST_OFF: f64 = 0.01;

/// Coefficients of `u_x` in a hoop strain, 1/m, by points.
pub(super) type Hoop = BTreeMap<u32, f64>;

/// The hoop strains of some points with these volumes, and the largest volume that does not fit, per that of a cell at the
/// largest radius.
pub(super) fn hoops(plate: &Bonded, points: &[Lacking], volumes: &[f64], scale: f64) -> (Vec<Hoop>, f64) {
    let spacing = plate.lattice.spacing();
    if !follows(plate) {
        let own = |l: &Lacking| Hoop::from([(l.point as u32, 1.0 / (l.weight * spacing))]);
        return (points.iter().map(own).collect(), 0.0);
    }
    let sources = sources(plate, points);
    let of =
        |wanted: &[f64]| transport(&sources, points, &plate.mirrors, (Need::Volumes(wanted), scale), 0.0);
    let (wanted, off) = fitted(volumes, &sources, &of(volumes));
    let mut transport = of(&wanted);
    // What is off by more is reported, as what does not fit.
    let left = transport.solve().max(if off > MOST_OFF { off } else { 0.0 });
    let mut found = Vec::with_capacity(points.len());
    let mut from = 0;
    for &end in &transport.ends {
        let (mut rows, mut volume) = (Hoop::new(), 0.0);
        for edge in &transport.edges[from..end] {
            let source = &sources[edge.place as usize];
            let part = edge.volume / (scale * source.volume());
            source.rows.iter().for_each(|(&point, row)| *rows.entry(point).or_default() += part * row[0]);
            volume += edge.volume / scale;
        }
        rows.values_mut().for_each(|row| *row /= if volume > 0.0 { volume } else { 1.0 });
        found.push(rows);
        from = end;
    }
    (found, left)
}

/// Volumes that sum to those of the sources in every part of the border by itself, and by how much any part had others: the sums of
/// all are those of the body, but dilatations hand a little from the inner border to the outer one, 0.3 % measured.
fn fitted(volumes: &[f64], sources: &[Source], reached: &Transport) -> (Vec<f64>, f64) {
    // Points, then sources, that hang together.
    let mut parts = ConnectedParts::new(volumes.len() + sources.len());
    let mut from = 0;
    for (point, &end) in reached.ends.iter().enumerate() {
        let places = reached.edges[from..end].iter().map(|edge| volumes.len() + edge.place as usize);
        places.for_each(|place| parts.join(point, place));
        from = end;
    }
    let parts = parts.numbered();
    let mut sums: BTreeMap<usize, [f64; 2]> = BTreeMap::new();
    volumes.iter().enumerate().for_each(|(k, v)| sums.entry(parts.of(k)).or_default()[1] += v);
    let given = sources.iter().enumerate();
    given.for_each(|(k, s)| sums.entry(parts.of(volumes.len() + k)).or_default()[0] += s.volume());
    let scaled = |(k, v): (usize, &f64)| {
        let [given, wanted] = sums[&parts.of(k)];
        v * given / wanted
    };
    let off = sums.values().map(|[given, wanted]| (given / wanted - 1.0).abs()).fold(0.0, f64::max);
    (volumes.iter().enumerate().map(scaled).collect(), off)
}

/// `∫ u_x dA` of the points and of the parts of blocks around them, in cells times spacings.
fn sources(plate: &Bonded, points: &[Lacking]) -> Vec<Source> {
    let spacing = plate.lattice.spacing();
    let section = plate.section(points.iter().map(|lacking| lacking.point));
    let mut sources = Vec::new();
    for (lacking, whole) in points.iter().zip(section.whole).filter(|(_, whole)| *whole > 0) {
        let area = 0.25 * f64::from(whole);
        let at = [0, 1].map(|k| f64::from(lacking.cell[k]));
        let mut source = of(at, area * lacking.weight);
        source.add_row(lacking.point as u32, [area / spacing, 0.0]);
        sources.push(source);
    }
    for part in section.parts {
        let mut source = of(part.at, part.volume);
        let row = |share: f64| [part.area * share / spacing, 0.0];
        part.shares.iter().for_each(|&(point, share)| source.add_row(point, row(share)));
        sources.push(source);
    }
    sources
}

/// A place with a volume that is alike in all directions.
fn of(at: [f64; 2], volume: f64) -> Source {
    Source { at, tensor: [volume, volume, 0.0], ..Source::default() }
}
