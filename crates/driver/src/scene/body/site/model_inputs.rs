//! The model of a body in the plane: points of its lattice with images, or its listed points.

use super::bearing::{self, Bearing};
use super::cracks::NamedCrack;
use super::fronts;
use super::of_case::horizon_key;
use super::symmetry::Symmetry;
use crate::case::{Case, CrackFronts};
use crate::model::{AnyBody, Material, Mixture, OnGround, OnLattice, Refusal};
use peristat_assembly::body::{
    CRACK_SLACK, Cell, Crack, PointBody, SquareLattice, cut_bonds, in_space, plus,
};
use peristat_assembly::model::BodyModel;
use std::cell::RefCell;
use std::collections::HashSet;
use std::ops::Range;

/// What a model is made of, to make it again with other cracks.
#[derive(Clone, Debug)]
pub(crate) struct ModelInputs {
    /// The points of the body, without images.
    pub(crate) body: PointBody,
    /// Hash of the file that lists them.
    pub(crate) file: Option<blake3::Hash>,
    /// Its mirrors.
    pub(crate) symmetry: Symmetry,
    /// Rigid regions that bear on the rest in some directions only. Coarser lattices, which only precondition, know none.
    pub(crate) bearings: Vec<Bearing>,
    /// Material and bonds.
    pub(crate) material: Box<dyn Material>,
    /// Materials of regions.
    pub(crate) materials: Mixture,
    /// Horizon, m.
    pub(crate) horizon: f64,
    /// Whether its bonds break or soften.
    pub(crate) breaks: bool,
    /// Which bonds its cracks cut next to their ends.
    pub(crate) crack_fronts: CrackFronts,
}

impl ModelInputs {
    /// The model with some cracks.
    ///
    /// # Errors
    /// [`Refusal`].
    pub(crate) fn make(&self, cracks: &[Crack]) -> Result<AnyBody, Refusal> {
        self.cut_by(&self.acting(cracks))
    }

    /// Cracks as they cut bonds, with their images.
    pub(crate) fn acting(&self, cracks: &[Crack]) -> Vec<Crack> {
        self.symmetry.with_images(&self.as_cut(cracks))
    }

    /// Cracks as they cut bonds.
    pub(crate) fn as_cut(&self, cracks: &[Crack]) -> Vec<Crack> {
        match self.crack_fronts {
            CrackFronts::Effective => self.around().receded(cracks),
            CrackFronts::Crossed => cracks.to_vec(),
        }
    }

    /// What cracks end in.
    pub(crate) fn around(&self) -> fronts::Around<'_> {
        fronts::Around { body: &self.body, symmetry: &self.symmetry, horizon: self.horizon }
    }

    /// The model with all bonds cut that some cracks cross.
    ///
    /// # Errors
    /// [`Refusal`].
    pub(crate) fn cut_by(&self, cracks: &[Crack]) -> Result<AnyBody, Refusal> {
        match &self.body {
            PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
                let (mirrors, apart) = (self.symmetry.mirrors, RefCell::new(Vec::new()));
                let cuts = |extended: &SquareLattice, offsets: &[Cell]| {
                    let mut cuts = cut_bonds(extended, offsets, cracks);
                    let found = bearing::on_lattice(&self.bearings, (extended, lattice), &mirrors, offsets);
                    cuts.extend(&found);
                    *apart.borrow_mut() = found;
                    cuts
                };
                let slack = CRACK_SLACK * lattice.spacing();
                let separated = |a: Cell, b: Cell| {
                    let ends = [lattice.centre(a), lattice.centre(b)];
                    cracks.iter().any(|crack| crack.cuts(ends[0], ends[1], slack))
                };
                let materials = &self.materials;
                let on = OnLattice { real: lattice, mirrors, materials, cuts: &cuts, separated: &separated };
                let mut body = self.material.on_lattice(&on)?;
                body.as_mut().never_joined(&apart.into_inner());
                if self.breaks {
                    body.as_mut().prepare_to_break();
                }
                Ok(body)
            }
            PointBody::Cloud(cloud) => {
                let slack = CRACK_SLACK * cloud.spacing();
                let apart = bearing::between(&self.bearings, &self.body);
                let cut = |a: [f64; 3], b: [f64; 3]| {
                    cracks.iter().any(|c| c.cuts(a, b, slack)) || apart([a[0], a[1]], [b[0], b[1]])
                };
                self.material.on_points(cloud, self.horizon, &cut)
            }
        }
    }

    /// The same of the part of a lattice that lies in ranges of columns, rows and layers. What it ends at there is an edge of the
    /// part, as it is none of the body.
    pub(crate) fn within(&self, ranges: &[Range<i32>; 3]) -> Self {
        let (body, lattice) = match &self.body {
            PointBody::Lattice(lattice) => (PointBody::Lattice(lattice.within(ranges)), lattice),
            PointBody::Solid(lattice) => (PointBody::Solid(lattice.within(ranges)), lattice),
            PointBody::Cloud(_) => return self.clone(),
        };
        let mut materials = self.materials.clone();
        if let Some(part) = body.cells().filter(|_| !materials.is_one()) {
            // Every cell of the part is one of the whole.
            let of: Vec<usize> = (0..part.points()).filter_map(|p| lattice.number(part.cell(p))).collect();
            materials.numbers = of.iter().map(|&p| self.materials.numbers[p]).collect();
            materials.factors = of.iter().map(|&p| self.materials.factors[p]).collect();
        }
        Self { body, materials, ..self.clone() }
    }

    /// Cut bonds of a lattice, for the coarser ones of this model.
    pub(crate) fn cuts(
        &self,
        cracks: &[NamedCrack],
        lattice: &SquareLattice,
        offsets: &[Cell],
    ) -> Vec<(usize, usize)> {
        let cracks: Vec<Crack> = cracks.iter().map(|c| c.crack.clone()).collect();
        cut_bonds(lattice, offsets, &self.acting(&cracks))
    }

    /// Whether a crack cuts any bond.
    pub(crate) fn is_cut_by(&self, crack: &Crack) -> bool {
        match &self.body {
            PointBody::Lattice(lattice) | PointBody::Solid(lattice) => {
                let depth = self.material.depth().unwrap_or(0);
                let offsets = self.material.offsets().unwrap_or_default();
                // A crack along a mirror cuts bonds to images only.
                let lattice = self.symmetry.mirrors.extended(lattice, depth);
                !cut_bonds(&lattice, &offsets, std::slice::from_ref(crack)).is_empty()
            }
            PointBody::Cloud(cloud) => {
                let slack = CRACK_SLACK * cloud.spacing();
                let neighbours = cloud.neighbours(self.horizon * (1.0 + 1e-9));
                let at = |p: u32| cloud.positions()[p as usize];
                neighbours.pairs().any(|[i, j]| crack.cuts(at(i), at(j), slack))
            }
        }
    }

    /// Whether the image of a crack in a mirror cuts bonds before that mirror which the crack does not cut itself.
    pub(crate) fn is_cut_by_image_of(&self, crack: &Crack) -> bool {
        let Some(lattice) = self.body.cells() else { return false };
        let slack = CRACK_SLACK * lattice.spacing();
        let ends = crack.surface().map_or_else(Vec::new, |surface| surface.boxes().flatten().collect());
        let ends: Vec<[f64; 3]> = crack.vertices().iter().map(|v| in_space(*v)).chain(ends).collect();
        let mirrors = self.symmetry.at.iter().enumerate().filter_map(|(side, at)| Some((side, (*at)?)));
        // A crack that stays before a mirror has its image behind it.
        let beyond = mirrors.filter(|&(side, at)| {
            let outwards = if side % 2 == 1 { 1.0 } else { -1.0 };
            ends.iter().any(|end| outwards * (end[side / 2] - at) > slack)
        });
        let beyond: Vec<(usize, f64)> = beyond.collect();
        if beyond.is_empty() {
            return false;
        }
        let depth = self.material.depth().unwrap_or(0);
        let offsets = self.material.offsets().unwrap_or_default();
        let extended = self.symmetry.mirrors.extended(lattice, depth);
        let cut = |crack: Crack| cut_bonds(&extended, &offsets, &[crack]);
        let own: HashSet<(usize, usize)> = cut(crack.clone()).into_iter().collect();
        beyond.into_iter().any(|(side, at)| {
            let axis = side / 2;
            let is_before = |cell: Cell| (lattice.centre(cell)[axis] < at) == (side % 2 == 1);
            let planes = [0, 1, 2].map(|k| (k == axis).then_some(at));
            cut(crack.reflected(planes)).into_iter().filter(|bond| !own.contains(bond)).any(
                |(step, lower)| {
                    let lower = extended.cell(lower);
                    is_before(lower) && is_before(plus(lower, offsets[step]))
                },
            )
        })
    }

    /// What the strength of bonds depends on.
    pub(crate) fn on_ground(&self, case: &Case) -> OnGround {
        OnGround {
            is_lattice: self.body.cells().is_some(),
            spacing: self.body.spacing(),
            horizon: self.horizon,
            horizon_key: horizon_key(case),
        }
    }

    /// Numbers in the model of points of the body.
    pub(crate) fn number(&self, model: &dyn BodyModel, point: u32) -> u32 {
        match (self.body.cells(), model.lattice()) {
            (Some(lattice), Some((extended, _))) if !model.ghosts().is_empty() => {
                let number = extended.number(lattice.cell(point as usize));
                number.map_or(point, |n| n as u32)
            }
            _ => point,
        }
    }
}
