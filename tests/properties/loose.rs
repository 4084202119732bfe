//! Motions that nothing holds cost no energy and keep all equations.

use super::consistency::{Noise, constrained, largest};
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{ConnectedParts, NumberedParts, Term};
use peristat_assembly::system::{FreeMotion, System, free_motions};

pub(crate) fn free_motions_are_free<const D: usize, M: Model<D>>(
    model: &M,
    extra: &dyn Fn() -> Vec<Box<dyn Term<D>>>,
    noise: &mut Noise,
) {
    for held in 0..3 {
        let mut equations = constrained::<D>(model.points(), noise);
        equations.truncate(held);
        let system = System::new(model, extra(), equations).expect("homogeneous equations never contradict");
        let mut parts = ConnectedParts::new(system.points());
        system.terms().iter().for_each(|term| term.join(&mut parts));
        let parts = parts.numbered();
        let found = free_motions(model, &system);
        let mut equations = system.constraints().equations().to_vec();
        for term in system.terms() {
            term.ground_motions(&mut |shares| {
                equations
                    .push(shares.iter().map(|&(c, p, share)| (c * system.points() + p, share)).collect());
            });
        }
        for motion in &found {
            costs_nothing(model, &system, &parts, motion, &equations);
        }
    }
}

pub(crate) fn costs_nothing<const D: usize, M: Model<D>>(
    model: &M,
    system: &System<D>,
    parts: &NumberedParts,
    motion: &FreeMotion,
    equations: &[Vec<(usize, f64)>],
) {
    let n = system.points();
    let mut u = vec![0.0; D * n];
    for (span, part) in motion.parts.iter().zip(&motion.moves) {
        for point in (0..n).filter(|&point| parts.spans()[parts.of(point)] == *span) {
            for (kind, amount) in part.amounts.iter().enumerate() {
                let unit = model.rigid_motion(kind, point, part.centre);
                (0..D).for_each(|c| u[c * n + point] += amount * unit[c]);
            }
        }
    }
    let size = largest(&u);
    assert!(size > 0.0 && size.is_finite());
    // Amounts below a millionth of the largest are reported as zero.
    for equation in equations {
        let (mut sum, mut scale) = (0.0, 0.0);
        for (unknown, coefficient) in equation {
            sum += coefficient * u[*unknown];
            scale += coefficient.abs() * size;
        }
        assert!(sum.abs() <= 1e-5 * scale, "{motion:?}: {sum:e} in {equation:?}");
    }
    let mut force = vec![f64::NAN; D * n];
    system.force(&u, &mut force);
    let mut blocks = vec![[[0.0; D]; D]; n];
    system.terms().iter().for_each(|term| term.add_diagonal(&mut blocks));
    let stiffness = largest(blocks.as_flattened().as_flattened());
    assert!(largest(&force) <= 1e-5 * stiffness * size, "{motion:?}");
}
