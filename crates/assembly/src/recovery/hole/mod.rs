//! Stresses at round and elliptic holes, from displacements of points around them.
//!
//! Close to a hole fields vary within a fraction of its size, and points see little of that. All elastic fields without
//! tractions on the hole are known, though: complex potentials of Kolosov (1909) in isotropic materials, of Lekhnitskii (1968) in
//! others, mapped to the outside of the unit circle. A few of them, fitted to the displacements of a ring of points, give
//! the stress anywhere in the ring and on the hole, and the misfit tells whether the fields there are such.

mod fit;
mod kolosov;
mod lekhnitskii;
mod load;
#[cfg(test)]
mod tests;

pub use fit::HoleFit;
pub use load::HoleLoad;

use kolosov::Kolosov;
use lekhnitskii::Lekhnitskii;
use load::Outgoing;
use nalgebra::{Complex, Matrix3};

/// A complex number.
type C = Complex<f64>;

/// A material is isotropic whose compliances differ by no more from one that is.
const ISOTROPIC: f64 = 1e-9;

/// An ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Its middle, m.
    pub centre: [f64; 2],
    /// Half its axes, m, > 0: along x and y before it is turned.
    pub half_axes: [f64; 2],
    /// By how much it is turned, rad, counter-clockwise.
    pub turn: f64,
}

impl Ellipse {
    /// How many times larger the ellipse through a position is: one on its border.
    pub fn level(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.own(at);
        (x / self.half_axes[0]).hypot(y / self.half_axes[1])
    }

    /// A position from the middle along its own axes.
    fn own(&self, at: [f64; 2]) -> [f64; 2] {
        self.seen([0, 1].map(|k| at[k] - self.centre[k]))
    }

    /// A direction along its own axes.
    fn seen(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.turn.sin_cos();
        [c * x + s * y, c * y - s * x]
    }

    /// A direction along its own axes along x and y.
    fn back(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (s, c) = self.turn.sin_cos();
        [c * x - s * y, s * x + c * y]
    }

    /// A field along its own axes along x and y.
    fn field_back(&self, Field { displacement, rotation, stress: [xx, yy, xy] }: Field) -> Field {
        let (s, c) = self.turn.sin_cos();
        let (sum, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let [cosine, sine] = [c * c - s * s, 2.0 * s * c];
        let (half, shear) = (cosine * difference - sine * xy, sine * difference + cosine * xy);
        Field { displacement: self.back(displacement), rotation, stress: [sum + half, sum - half, shear] }
    }

    /// Strains `[ε_xx, ε_yy, γ_xy]` along x and y of those along its own axes.
    fn strains_back(&self) -> Matrix3<f64> {
        let (s, c) = self.turn.sin_cos();
        Matrix3::new(c * c, s * s, -s * c, s * s, c * c, s * c, 2.0 * s * c, -2.0 * s * c, c * c - s * s)
    }

    /// A position as a complex number from the middle, along its own axes.
    fn place_of(&self, at: [f64; 2]) -> C {
        let [x, y] = self.own(at);
        C::new(x, y)
    }

    /// Places on the border, all around it, equal steps of the parametric angle apart.
    fn places(&self, count: usize) -> Vec<[f64; 2]> {
        let [a, b] = self.half_axes;
        let place = |k: usize| {
            let (s, c) = (std::f64::consts::TAU * k as f64 / count as f64).sin_cos();
            let [x, y] = self.back([a * c, b * s]);
            [self.centre[0] + x, self.centre[1] + y]
        };
        (0..count).map(place).collect()
    }

    /// Unit normal of the ellipse through a position, away from its middle.
    pub fn normal(&self, at: [f64; 2]) -> [f64; 2] {
        let own = self.own(at);
        let [x, y] = [0, 1].map(|k| own[k] / self.half_axes[k].powi(2));
        let length = x.hypot(y);
        self.back([x / length, y / length])
    }
}

/// Displacement `[u_x, u_y]`, m, rotation, rad, and stress `[σ_xx, σ_yy, σ_xy]`, Pa, at a position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Field {
    /// Displacement.
    pub displacement: [f64; 2],
    /// `½ (∂u_y/∂x − ∂u_x/∂y)`, counter-clockwise.
    pub rotation: f64,
    /// Stress.
    pub stress: [f64; 3],
}

impl Field {
    /// Adds a multiple of another one.
    pub fn add_multiple(&mut self, factor: f64, other: &Self) {
        (0..2).for_each(|k| self.displacement[k] += factor * other.displacement[k]);
        self.rotation += factor * other.rotation;
        (0..3).for_each(|k| self.stress[k] += factor * other.stress[k]);
    }
}

/// Elastic fields outside an ellipse whose border is free of tractions: potentials of the powers ζ^±1 to ζ^±N, and the two
/// translations.
#[derive(Clone, Debug)]
pub struct HoleFields {
    ellipse: Ellipse,
    order: usize,
    potentials: Potentials,
}

#[derive(Clone, Debug)]
enum Potentials {
    Isotropic(Kolosov),
    Anisotropic(Lekhnitskii),
}

impl HoleFields {
    /// Fields of the powers up to `order` in a material of this stiffness, Pa, from strains `[ε_xx, ε_yy, γ_xy]` to
    /// stresses. None if it is not positive definite.
    pub fn new(stiffness: &[[f64; 3]; 3], ellipse: Ellipse, order: usize) -> Option<Self> {
        let matrix = Matrix3::from_fn(|r, c| 0.5 * (stiffness[r][c] + stiffness[c][r]));
        let strains = ellipse.strains_back();
        let inverse = (strains.transpose() * matrix * strains).cholesky()?.inverse();
        let s = std::array::from_fn(|r| std::array::from_fn(|c| inverse[(r, c)]));
        let potentials = match is_isotropic(&s) {
            true => Potentials::Isotropic(Kolosov::new(&s, ellipse)),
            false => Potentials::Anisotropic(Lekhnitskii::new(&s, ellipse)?),
        };
        Some(Self { ellipse, order, potentials })
    }

    /// The hole.
    pub fn ellipse(&self) -> &Ellipse {
        &self.ellipse
    }

    /// How many fields there are.
    pub fn count(&self) -> usize {
        Self::count_of(self.order)
    }

    /// How many fields the powers up to `order` make.
    pub const fn count_of(order: usize) -> usize {
        4 * order + 2
    }

    /// All fields at a position outside of the hole or on its border.
    pub fn at(&self, position: [f64; 2]) -> Vec<Field> {
        let mut fields = Vec::with_capacity(self.count());
        match &self.potentials {
            Potentials::Isotropic(kolosov) => kolosov.add(position, self.order, &mut fields),
            Potentials::Anisotropic(lekhnitskii) => lekhnitskii.add(position, self.order, &mut fields),
        }
        fields.extend([[1.0, 0.0], [0.0, 1.0]].map(|u| Field { displacement: u, ..Field::default() }));
        if self.ellipse.turn != 0.0 {
            fields.iter_mut().for_each(|field| *field = self.ellipse.field_back(*field));
        }
        fields
    }

    /// The potentials whose tractions on the hole are those of a load.
    fn outgoing(&self, load: &HoleLoad) -> Outgoing {
        match &self.potentials {
            Potentials::Isotropic(kolosov) => kolosov.outgoing(load),
            Potentials::Anisotropic(lekhnitskii) => lekhnitskii.outgoing(load),
        }
    }

    /// Their field at a position.
    fn field_of(&self, outgoing: &Outgoing, position: [f64; 2]) -> Field {
        let own = match &self.potentials {
            _ if outgoing.powers.is_empty() => Field::default(),
            Potentials::Isotropic(kolosov) => kolosov.field_of(position, outgoing),
            Potentials::Anisotropic(lekhnitskii) => lekhnitskii.field_of(position, outgoing),
        };
        self.ellipse.field_back(own)
    }
}

/// Whether compliances are those of an isotropic material.
fn is_isotropic(s: &[[f64; 3]; 3]) -> bool {
    let off = [s[0][0] - s[1][1], s[2][2] - 2.0 * (s[0][0] - s[0][1]), s[0][2], s[1][2]];
    off.iter().all(|x| x.abs() <= ISOTROPIC * s[0][0])
}

/// Image ζ, outside of the unit circle, of `z = ½ ((a − i μ b) ζ + (a + i μ b)/ζ)`, which takes that circle to an ellipse
/// `a cos θ + μ b sin θ`; and dζ/dz.
fn outside(z: C, [a, b]: [f64; 2], mu: C) -> [C; 2] {
    let i = C::i();
    let (outer, inner) = (a - i * mu * b, a + i * mu * b);
    let root = (z * z - outer * inner).sqrt();
    let both = [root, -root].map(|root| ((z + root) / outer, root));
    let (zeta, root) = if both[0].0.norm_sqr() >= both[1].0.norm_sqr() { both[0] } else { both[1] };
    [zeta, zeta / root]
}
