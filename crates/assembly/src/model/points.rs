//! What the points of a model can do: their unknowns, and the motions that cost no energy.

use crate::bonds::Point;

/// An unknown of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Component {
    /// Its name, such as `ux`.
    pub name: &'static str,
    /// The axis along which it is, or about which it turns: 0 for x, 1 for y, 2 for z or outwards.
    pub axis: usize,
    /// Whether it is a rotation, not a displacement.
    pub is_rotation: bool,
    /// What multiplies the displacement, m, or the rotation, rad, to make the unknown.
    pub scale: f64,
}

impl Component {
    /// A displacement along an axis, m.
    pub const fn displacement(name: &'static str, axis: usize) -> Self {
        Self { name, axis, is_rotation: false, scale: 1.0 }
    }

    /// A rotation about z, rad, times a scale.
    pub const fn rotation(name: &'static str, scale: f64) -> Self {
        Self { name, axis: 2, is_rotation: true, scale }
    }
}

/// A motion of a body that costs no energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RigidMotion {
    /// Its name, such as `translation along x`.
    pub name: &'static str,
    /// Whether it turns the body.
    pub is_rotation: bool,
    /// What a body does that moves so, such as `move along {direction}` or `turn about {centre}`; whoever tells it fills in
    /// the amounts.
    pub verb: &'static str,
}

impl RigidMotion {
    /// A translation.
    pub const fn translation(name: &'static str, verb: &'static str) -> Self {
        Self { name, is_rotation: false, verb }
    }

    /// A rotation.
    pub const fn rotation(name: &'static str, verb: &'static str) -> Self {
        Self { name, is_rotation: true, verb }
    }
}

/// Numbered points with unknowns.
pub trait Points {
    /// Number of points, images and ghosts included.
    fn points(&self) -> usize;

    /// Position of a point, m.
    fn position(&self, point: usize) -> Point;

    /// The unknowns of a point, in order; a model that solves for fewer has the first of them.
    fn components(&self) -> &[Component];

    /// Index and properties of an unknown.
    fn component(&self, name: &str) -> Option<(usize, Component)> {
        self.components().iter().copied().enumerate().find(|(_, component)| component.name == name)
    }

    /// Index of the displacement along an axis.
    fn along(&self, axis: usize) -> Option<usize> {
        self.components().iter().position(|component| !component.is_rotation && component.axis == axis)
    }

    /// Index and scale of the rotation.
    fn turning(&self) -> Option<(usize, f64)> {
        let rotation = self.components().iter().enumerate().find(|(_, component)| component.is_rotation);
        rotation.map(|(k, component)| (k, component.scale))
    }

    /// What multiplies the displacement or rotation of a component to make the unknown; 1 where there is no such component.
    fn scale(&self, component: usize) -> f64 {
        self.components().get(component).map_or(1.0, |of| of.scale)
    }
}
