//! All levels of a cycle, and the way of vectors to them and back.

use super::border::Border;
use super::cells::{Cells, FOLLOWING, SOLID};
use super::coarsest::{self, CoarsestMatrix};
use super::followers::Followers;
use super::gaps::Gaps;
use super::grid::Grid;
use super::level::CubicLevel;
use super::stencil::Stencil;
use super::transfer::Transfer;
use crate::body::{Cell, SquareLattice};
use crate::bonds::Mat;
use crate::model::plane::Mirrors;
use crate::stiffness::NodedBonds;

/// Cells of the box around a solid per point, at most.
const MOST_EMPTY: f64 = 4.0;

/// A solid as the levels see it.
#[derive(Clone, Debug)]
pub struct CubicSolid<'a> {
    /// Its points, images among them.
    pub lattice: &'a SquareLattice,
    /// What they are images of.
    pub mirrors: &'a Mirrors,
    /// Bonds of a point.
    pub stencil: Stencil,
    /// Components of points that rest.
    pub held: Vec<(usize, usize)>,
    /// Springs of points to the ground, N/m.
    pub springs: Vec<(usize, Mat<3, 3>)>,
    /// Components of points that follow those of others, and their shares in them.
    pub followers: Vec<Follower>,
    /// Bonds that are cut or broken: the steps of the stencil, and their lower points.
    pub cuts: Vec<(Cell, usize)>,
    /// What is done about the bonds that points beside faces lack.
    pub faces: CubicFaces<'a>,
}

/// A component of a point that follows others: point and component, and those of the others with their shares.
pub type Follower = ((usize, usize), Vec<((usize, usize), f64)>);

/// What completes the families of points beside faces.
#[derive(Clone, Copy, Debug)]
pub enum CubicFaces<'a> {
    /// Nothing.
    Bare,
    /// Bonds that end on the border.
    Border(&'a NodedBonds<3, 1>),
    /// Something else, for which bonds are made stiffer.
    Other,
}

/// Points that follow each other on the lattice and on the grid.
#[derive(Clone, Copy, Debug)]
struct Piece {
    point: u32,
    place: u32,
    count: u32,
}

/// Levels of a solid, the finest first.
#[derive(Clone, Debug)]
pub struct CubicLevels {
    levels: Vec<CubicLevel>,
    transfers: Vec<Transfer>,
    pieces: Vec<Piece>,
    points: usize,
    /// Stiffness by which those of the levels are divided, N/m.
    unit: f64,
}

impl CubicLevels {
    /// Levels down to the first that `is_coarsest` by its numbers of columns, rows and layers and of its points; none if sides are
    /// joined, if that is the first one, if bonds are cut beside images, or if the solid fills so little of its box that empty cells
    /// would be most of the work.
    pub fn new(solid: &CubicSolid<'_>, is_coarsest: &dyn Fn([usize; 3], usize) -> bool) -> Option<Self> {
        let has_cut_images = !solid.cuts.is_empty() && !solid.mirrors.is_none();
        if solid.mirrors.joined != [false; 3] || has_cut_images {
            return None;
        }
        let unit = solid.stencil.stiffness();
        let stencil = solid.stencil.scaled(1.0 / unit);
        let (mut cells, pieces, first) = cells_of(solid, &stencil)?;
        for (point, spring) in &solid.springs {
            let place = place_of(&pieces, *point)?;
            cells.add_spring(place, &spring.map(|row| row.map(|k| k / unit)));
        }
        for (point, component) in &solid.held {
            cells.state[place_of(&pieces, *point)?] |= 1 << component;
        }
        cells.finish();
        let mut followers = Followers::default();
        for ((point, component), leaders) in &solid.followers {
            let place = place_of(&pieces, *point)?;
            let entry = |(point, c): &(usize, usize)| Some(c * cells.grid.len() + place_of(&pieces, *point)?);
            let leaders = leaders.iter().map(|(of, share)| Some((entry(of)?, *share)));
            followers
                .push(component * cells.grid.len() + place, leaders.collect::<Option<Vec<_>>>()?.into_iter());
            cells.state[place] |= 1 << (FOLLOWING + *component as u8);
        }
        let border = |bonds| {
            let at = |cell: Cell| cells.grid.at([0, 1, 2].map(|k| i64::from(cell[k] - first[k]))) as u32;
            Border::new((bonds, unit), &cells.grid, &|point| {
                let cell = solid.lattice.cell(point as usize);
                let (real, signs) = solid.mirrors.image(cell);
                (at(cell), at(real), signs)
            })
        };
        type Make = fn(Cells, Stencil) -> CubicLevel;
        let (finest, coarser, border): (Make, Make, _) = match solid.faces {
            CubicFaces::Bare => (CubicLevel::bare, CubicLevel::bare, None),
            CubicFaces::Border(bonds) => (CubicLevel::bare, CubicLevel::stiffened, Some(border(bonds))),
            CubicFaces::Other => (CubicLevel::stiffened, CubicLevel::stiffened, None),
        };
        let cut = |(step, lower): &(Cell, usize)| {
            let cell = solid.lattice.cell(*lower);
            ([0, 1, 2].map(|k| cell[k] - first[k]), *step)
        };
        let gaps = Gaps::new(solid.cuts.iter().map(cut).collect(), &cells, &stencil);
        let mut levels = vec![finest(cells, stencil).with(border, followers).without(gaps)];
        let mut transfers = Vec::new();
        loop {
            let fine = &levels[levels.len() - 1];
            if is_coarsest(fine.grid().cells, fine.points()) || !fine.cells.can_be_coarser() {
                break;
            }
            let coarse = coarser(fine.cells.coarser(), fine.stencil.scaled(2.0));
            let gaps = Gaps::new(fine.gaps.coarser(fine.cells.shift), &coarse.cells, &coarse.stencil);
            let coarse = coarse.without(gaps);
            transfers.push(Transfer::new(fine, &coarse));
            levels.push(coarse);
        }
        let points = solid.lattice.points();
        (levels.len() > 1).then_some(Self { levels, transfers, pieces, points, unit })
    }

    /// The levels.
    pub fn levels(&self) -> &[CubicLevel] {
        &self.levels
    }

    /// Writes forces, N, of the solid over a vector of the finest level, per their 2-norm, which is returned.
    pub fn enter(&self, forces: &[f64], b: &mut [f32]) -> f64 {
        let norm = forces.iter().map(|f| f * f).sum::<f64>().sqrt();
        let per_norm = if norm > 0.0 { 1.0 / norm } else { 0.0 };
        let finest = &self.levels[0];
        let len = finest.grid().len();
        b.fill(0.0);
        for c in 0..3 {
            let (b, forces) = (&mut b[c * len..][..len], &forces[c * self.points..][..self.points]);
            for piece in &self.pieces {
                let own = piece.of(b);
                let scales = &finest.inverse_scale[piece.place as usize..];
                let forces = &forces[piece.point as usize..];
                own.iter_mut()
                    .zip(forces.iter().zip(scales))
                    .for_each(|(b, (f, scale))| *b = (f * per_norm) as f32 * scale);
            }
        }
        finest.hand_over(b);
        norm
    }

    /// Writes the displacements, m, of a vector of the finest level for forces of a norm over `u`; images rest.
    pub fn leave(&self, v: &[f32], norm: f64, u: &mut [f64]) {
        let finest = &self.levels[0];
        let (len, factor) = (finest.grid().len(), norm / self.unit);
        u.fill(0.0);
        for c in 0..3 {
            let (v, u) = (&v[c * len..][..len], &mut u[c * self.points..][..self.points]);
            for piece in &self.pieces {
                let places = piece.place as usize..(piece.place + piece.count) as usize;
                let own = &mut u[piece.point as usize..][..piece.count as usize];
                let scaled = v[places.clone()].iter().zip(&finest.inverse_scale[places]);
                own.iter_mut().zip(scaled).for_each(|(u, (v, scale))| *u = f64::from(v * scale) * factor);
            }
        }
    }

    /// Writes over `coarse`, of the level after this one, what `fine` of this one is there.
    pub fn restrict(&self, level: usize, fine: &[f32], coarse: &mut [f32]) {
        self.transfers[level].restrict([&self.levels[level], &self.levels[level + 1]], fine, coarse);
    }

    /// Adds to `fine`, of this level, what is interpolated from `coarse` of the level after it.
    pub fn prolong_add(&self, level: usize, coarse: &[f32], fine: &mut [f32]) {
        self.transfers[level].prolong_add([&self.levels[level], &self.levels[level + 1]], coarse, fine);
    }

    /// The matrix of the coarsest level.
    pub fn coarsest(&self) -> CoarsestMatrix {
        coarsest::assemble(&self.levels[self.levels.len() - 1])
    }
}

impl Piece {
    fn of<'a, T>(&self, plane: &'a mut [T]) -> &'a mut [T] {
        &mut plane[self.place as usize..][..self.count as usize]
    }
}

fn place_of(pieces: &[Piece], point: usize) -> Option<usize> {
    let k = pieces.partition_point(|piece| piece.point as usize <= point).checked_sub(1)?;
    let along = point - pieces[k].point as usize;
    (along < pieces[k].count as usize).then_some(pieces[k].place as usize + along)
}

/// The cells of the real points of a solid, where these are, and the first of them along every axis; none without points, or with
/// few of them in a large box.
fn cells_of(solid: &CubicSolid<'_>, stencil: &Stencil) -> Option<(Cells, Vec<Piece>, Cell)> {
    let (lattice, mirrors) = (solid.lattice, solid.mirrors);
    let mut real = Vec::new();
    for run in lattice.runs() {
        let mut columns = run.columns.clone();
        let [low, high] = mirrors.lines[0];
        columns.start = low.map_or(columns.start, |low| low.max(columns.start));
        columns.end = high.map_or(columns.end, |high| high.min(columns.end));
        if !columns.is_empty() && mirrors.is_real(run.cell(columns.start)) {
            real.push((run.number(columns.start), run.cell(columns.start), columns.len()));
        }
    }
    let least = |k: usize| real.iter().map(|(_, cell, _)| cell[k]).min();
    let most = |k: usize| {
        real.iter().map(|(_, cell, len)| if k == 0 { cell[0] + *len as i32 } else { cell[k] + 1 }).max()
    };
    let first = [least(0)?, least(1)?, least(2)?];
    let behind = [most(0)?, most(1)?, most(2)?];
    let sides = [0, 1, 2].map(|k| (behind[k] - first[k]) as usize);
    // Where nothing reaches a plane of symmetry there are no images.
    let points: usize = real.iter().map(|(_, _, count)| count).sum();
    let is_sparse = sides.map(|side| side as f64).iter().product::<f64>() > MOST_EMPTY * points as f64;
    let mirrored =
        [0, 1, 2].map(|k| [mirrors.lines[k][0] == Some(first[k]), mirrors.lines[k][1] == Some(behind[k])]);
    // What moves with images on the border is at most two cells behind those that bonds reach.
    let beyond = if matches!(solid.faces, CubicFaces::Border(_)) && !mirrors.is_none() { 2 } else { 0 };
    let grid = Grid::new(sides, stencil.reach().max(2) + beyond, mirrored);
    // Entries of vectors are numbered by u32.
    if is_sparse || u32::try_from(3 * grid.len()).is_err() {
        return None;
    }
    let mut cells = Cells::new(grid);
    let mut pieces = Vec::with_capacity(real.len());
    for (point, cell, count) in real {
        let place = cells.grid.at([0, 1, 2].map(|k| i64::from(cell[k] - first[k])));
        cells.state[place..place + count].fill(SOLID);
        pieces.push(Piece { point: point as u32, place: place as u32, count: count as u32 });
    }
    Some((cells, pieces, first))
}
