//! Slots part bonds, and parts that hang on others stay with the body.

use super::super::*;
use super::bodies::{matrix, parameters};
use crate::body::Crack;
use crate::body::cut_bonds;
use crate::model::Points;
use crate::model::plane::{Edges, Mirrors};
use nalgebra::DMatrix;

/// Numbers between 0 and 1, the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

const SIZE: [i32; 2] = [18, 13];

/// What remains of 18 × 13 cells without slots, wedges, and what lies beside bridges and between wedges.
fn cut_up(random: &mut Random) -> impl Fn(f64, f64) -> bool + use<> {
    let count = 1 + (3.0 * random.next()) as usize;
    let cuts: Vec<([f64; 4], usize, [f64; 2], f64)> = (0..count)
        .map(|_| {
            let kind = (4.0 * random.next()) as usize;
            let at = [0, 1].map(|k| random.between(0.0, f64::from(SIZE[k])));
            let angle = match random.next() < 0.6 {
                true => random.between(0.0, std::f64::consts::PI),
                false => (4.0 * random.next()).floor() * std::f64::consts::FRAC_PI_4,
            };
            let numbers = [random.between(0.5, 1.2), random.between(0.1, 0.5)];
            ([at[0], at[1], angle.cos(), angle.sin()], kind, numbers, random.between(4.0, 12.0))
        })
        .collect();
    move |x, y| {
        cuts.iter().all(|([x0, y0, c, s], kind, [wide, steep], length)| {
            let along = (x - x0) * c + (y - y0) * s;
            let across = (y - y0) * c - (x - x0) * s;
            let ahead = along > 0.0 && along < *length;
            let beside = |w: f64| w > steep * along && w < steep * along + 1.2;
            !match kind {
                0 => across.abs() < *wide && along.abs() < 0.5 * length,
                1 => ahead && across.abs() < steep * along,
                2 => across.abs() < 0.7 && along.abs() > 1.0 + *wide,
                _ => ahead && (beside(across) || beside(-across)),
            }
        })
    }
}

/// The largest part, by cells beside each other, of the blocks of two by two cells of a body.
fn opened(inside: &dyn Fn([i32; 2]) -> bool) -> Vec<[i32; 2]> {
    let blocks = (0..SIZE[1] - 1).flat_map(|j| (0..SIZE[0] - 1).map(move |i| [i, j]));
    let corners = |[i, j]: [i32; 2]| [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
    let whole = blocks.filter(|&block| corners(block).into_iter().all(inside));
    let mut left: std::collections::BTreeSet<[i32; 2]> = whole.flat_map(corners).collect();
    let mut largest = Vec::new();
    while let Some(first) = left.pop_first() {
        let (mut part, mut next) = (vec![first], 0);
        while let Some(&[i, j]) = part.get(next) {
            next += 1;
            let beside = [[i + 1, j], [i - 1, j], [i, j + 1], [i, j - 1]];
            part.extend(beside.into_iter().filter(|cell| left.remove(cell)));
        }
        if part.len() > largest.len() {
            largest = part;
        }
    }
    largest
}

/// Whether a body has motions without energy beside rigid ones: then its stiffness with that of these is not above 1e-9 of its
/// largest entry.
fn has_mechanism(plate: &BondPlane) -> bool {
    let (n, mut stiffness) = (plate.points(), matrix(plate));
    let scale = stiffness.diagonal().amax();
    let mut rigid = DMatrix::zeros(2 * n, 3);
    for p in 0..n {
        let [x, y] = plate.place(p);
        rigid[(p, 0)] = 1.0;
        rigid[(n + p, 1)] = 1.0;
        (rigid[(p, 2)], rigid[(n + p, 2)]) = (-y, x);
    }
    let q = rigid.qr().q();
    stiffness += scale * &q * q.transpose();
    stiffness -= DMatrix::identity(2 * n, 2 * n) * (1e-9 * scale);
    stiffness.cholesky().is_none()
}

/// As the note of the rule has it: of 200 bodies of this kind, opened by blocks of two by two cells, none has a mechanism.
#[test]
fn bodies_of_blocks_have_no_mechanisms() {
    let mut random = Random(11);
    let (mut bodies, mut parted) = (0, 0);
    while bodies < 200 {
        let inside = cut_up(&mut random);
        let of = |[i, j]: [i32; 2]| inside(f64::from(i) + 0.5, f64::from(j) + 0.5);
        let cells = opened(&of);
        if cells.len() <= 40 || cells.len() == (SIZE[0] * SIZE[1]) as usize {
            continue;
        }
        bodies += 1;
        let lattice = SquareLattice::plane(1.0, [0.0; 2], 0..SIZE[0], 0..SIZE[1], |c| cells.contains(&c));
        let lattice = Arc::new(lattice);
        for (m, edges) in [(2.0, Edges::None), (3.0, Edges::None), (2.0, Edges::Overlay)] {
            let parameters = PlaneParameters { edges, ..parameters(m, [1.0; 3]) };
            let plate = BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
            let Body::Lattice(body) = &plate.body else { panic!("a lattice") };
            parted += body.apart.len();
            assert!(!has_mechanism(&plate), "{bodies} {m} {edges:?}");
        }
    }
    assert!(parted > 2000, "slots part bonds: {parted}");
}

/// Two blocks whose next rows are three apart have nothing in common, whatever bonds could reach.
#[test]
fn a_gap_as_wide_as_bonds_parts_a_body() {
    for width in [1, 2] {
        let inside = |[_, j]: [i32; 2]| !(4..4 + width).contains(&j);
        let lattice = Arc::new(SquareLattice::plane(1.0, [0.0; 2], 0..6, 0..9, inside));
        for edges in [Edges::None, Edges::Overlay, Edges::Volume, Edges::Energy, Edges::Border] {
            let parameters = PlaneParameters { edges, ..parameters(3.0, [1.0; 3]) };
            let plate = BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
            let n = plate.points();
            let mut upper = vec![0.0; 2 * n];
            (0..n).filter(|&p| plate.place(p)[1] > 5.0).for_each(|p| upper[n + p] = 1.0);
            let force = matrix(&plate) * nalgebra::DVector::from_vec(upper);
            assert!(force.amax() < 1e-12, "{width} {edges:?}: {}", force.amax());
        }
    }
}

/// A bond that never was is no damage, and no family counts it.
#[test]
fn slots_are_no_damage() {
    let inside = |[i, j]: [i32; 2]| j != 6 || !(4..12).contains(&i);
    let lattice = Arc::new(SquareLattice::plane(1.0, [0.0; 2], 0..16, 0..13, inside));
    let parameters = PlaneParameters { edges: Edges::Overlay, ..parameters(2.0, [1.0; 3]) };
    let damage = |cuts: &[(usize, usize)]| {
        let plate = BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, cuts).unwrap();
        let of = |cell| plate.damage()[lattice.number(cell).unwrap()];
        [of([8, 5, 0]), of([8, 4, 0])]
    };
    assert_eq!(damage(&[]), [0.0; 2]);
    // A crack up to the slot, left of column 8. Three cells beside are slot, and one of twelve neighbours lies behind it; of the
    // other eight, three are across the crack. One row below only one is slot, and four are across.
    let crack = Crack::new(vec![[8.0, 3.0], [8.0, 6.5]]).unwrap();
    let cuts = cut_bonds(&lattice, &BondPlane::offsets(&parameters).unwrap(), &[crack]);
    let [beside, above] = damage(&cuts);
    assert!((beside - 3.0 / 8.0).abs() < 1e-12, "{beside}");
    assert!((above - 4.0 / 11.0).abs() < 1e-12, "{above}");
}
