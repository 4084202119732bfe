//! Motions that nothing holds cost no energy and keep all equations, and frames have as many as statics says.

use crate::consistency::{Noise, constrained, largest};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Line, PHI, TimoshenkoBeam, U, VolumeFactor, W, bond_law, end_treatment,
};
use peristat_assembly::stiffness::{NumberedParts, Parts, Spring, Springs, Term};
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
        let mut parts = Parts::new(system.points());
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

fn costs_nothing<const D: usize, M: Model<D>>(
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
    // Amounts below a millionth of the largest are told as zero.
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

/// Two members at an angle, the second one from the end of the first.
#[test]
fn members_are_as_loose_as_statics_says() {
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find("exact").expect("a law"),
        end_treatment: end_treatment::find("cover").expect("a treatment"),
    };
    let line = Line::new(2.0, 8, SectionStiffness::uniform(2.0, 30.0, 5.0, 0.3));
    let second = Line { origin: [2.0, 0.0], direction: [0.6, 0.8], ..line.clone() };
    let frame = TimoshenkoBeam::new(parameters, vec![line, second]).expect("a frame");
    let equation = |terms: &[(usize, usize, f64)]| Equation {
        terms: terms.iter().map(|&(component, point, c)| (Unknown { component, point }, c)).collect(),
        value: 0.0,
        origin: String::new(),
    };
    // Displacements along x and y: −s w + c u and c w + s u.
    let hinge = [
        equation(&[(U, 8, 1.0), (W, 9, 0.8), (U, 9, -0.6)]),
        equation(&[(W, 8, 1.0), (W, 9, -0.6), (U, 9, -0.8)]),
    ];
    let clamp = [W, PHI, U].map(|c| equation(&[(c, 0, 1.0)]));
    let roller = [equation(&[(W, 17, 0.6), (U, 17, 0.8)])];
    let count = |equations: &[&[Equation]], springs: Vec<Spring>| {
        let extra: Vec<Box<dyn Term<3>>> = vec![Box::new(Springs::new(18, springs))];
        let system = System::new(&frame, extra, equations.concat()).expect("no contradiction");
        let found = free_motions(&frame, &system);
        let parts = Model::<3>::connected(&frame);
        found
            .iter()
            .for_each(|m| costs_nothing(&frame, &system, &parts, m, system.constraints().equations()));
        found.len()
    };
    let turn = Spring::on(PHI, 12, 4.0);
    assert_eq!(count(&[], Vec::new()), 6);
    assert_eq!(count(&[], vec![turn]), 5);
    assert_eq!(count(&[&hinge], Vec::new()), 4);
    assert_eq!(count(&[&clamp], Vec::new()), 3);
    assert_eq!(count(&[&clamp, &hinge], Vec::new()), 1);
    assert_eq!(count(&[&clamp, &hinge], vec![turn]), 0);
    assert_eq!(count(&[&clamp, &hinge, &roller], Vec::new()), 0);
}
