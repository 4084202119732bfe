//! How stiff the bonds of a cloud are.

use super::{Pair, Place, Sites};
use crate::bonds::Mat;
use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, DimDiff, DimSub, SMatrix, U1};

/// Moments `M = (1/V) ½ Σ k ξ² N Nᵀ`, Pa, of all points: their stiffness in uniform strains.
pub(in super::super) fn moments<const D: usize, const S: usize>(
    pairs: &[Pair<D>],
    sites: &Sites<D>,
) -> Vec<Mat<S, S>>
where
    [f64; D]: Place<D, S>,
{
    let mut moments = vec![[[0.0; S]; S]; sites.positions.len()];
    for pair in pairs {
        let (n, half) = (pair.direction.product(), 0.5 * pair.stiffness * pair.length * pair.length);
        for p in pair.ends() {
            let volume = sites.volume(p);
            for r in 0..S {
                (0..S).for_each(|c| moments[p][r][c] += half / volume * n[r] * n[c]);
            }
        }
    }
    moments
}

/// Multiplies every bond by the smaller scale of its ends, the largest with which `C − g M` is positive semidefinite.
pub(in super::super) fn scale<const D: usize, const S: usize>(
    pairs: &mut [Pair<D>],
    sites: &Sites<D>,
    stiffness: &Mat<S, S>,
) where
    [f64; D]: Place<D, S>,
    Const<S>: DimSub<U1>,
    DefaultAllocator: Allocator<DimDiff<Const<S>, U1>> + Allocator<Const<S>, DimDiff<Const<S>, U1>>,
{
    let c = SMatrix::<f64, S, S>::from_fn(|r, k| stiffness[r][k]).symmetric_eigen();
    let root = c.eigenvectors
        * SMatrix::<f64, S, S>::from_diagonal(&c.eigenvalues.map(|v| 1.0 / v.sqrt()))
        * c.eigenvectors.transpose();
    let scale_of = |moment: &Mat<S, S>| {
        let relative = root * SMatrix::<f64, S, S>::from_fn(|r, k| moment[r][k]) * root;
        1.0 / relative.symmetric_eigenvalues().max()
    };
    let scales: Vec<f64> = moments(pairs, sites).iter().map(scale_of).collect();
    for pair in pairs {
        let [i, j] = pair.ends();
        pair.stiffness *= scales[i].min(scales[j]);
    }
}
