//! A body in the plane, whatever its model: one arm per number of unknowns of a point.

use peristat_assembly::model::BodyModel;
use peristat_assembly::model::plane::Solvable;
use std::any::Any;
use std::ops::Deref;

/// A body in the plane.
#[derive(Clone, Debug)]
pub enum AnyBody {
    /// Its points have one unknown.
    One(Box<dyn Solvable<1>>),
    /// They have two.
    Two(Box<dyn Solvable<2>>),
    /// They have three.
    Three(Box<dyn Solvable<3>>),
}

/// Evaluates an expression with the body inside an [`AnyBody`].
macro_rules! with_body {
    ($any:expr, $body:ident => $value:expr) => {
        match $any {
            $crate::model::AnyBody::One($body) => $value,
            $crate::model::AnyBody::Two($body) => $value,
            $crate::model::AnyBody::Three($body) => $value,
        }
    };
}
pub(crate) use with_body;

impl Deref for AnyBody {
    type Target = dyn BodyModel;

    fn deref(&self) -> &Self::Target {
        with_body!(self, body => &**body)
    }
}

impl AnyBody {
    /// The body, where its points have `D` unknowns.
    pub(crate) fn of<const D: usize>(self) -> Option<Box<dyn Solvable<D>>> {
        fn same<A: 'static, B: 'static>(a: A) -> Option<B> {
            let any: Box<dyn Any> = Box::new(a);
            any.downcast().ok().map(|b| *b)
        }
        with_body!(self, body => same(body))
    }

    /// The body, to change it.
    pub(crate) fn as_mut(&mut self) -> &mut dyn BodyModel {
        with_body!(self, body => &mut **body)
    }
}
