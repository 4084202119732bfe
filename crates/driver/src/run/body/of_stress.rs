//! What follows from the stresses of a point: strains, equivalent and principal stresses.

use super::failure;
use crate::case::{Origin, Strengths};
use crate::scene::body::BodyScene;
use nalgebra::{Matrix3, SymmetricEigen};
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::solid::TENSOR;

/// Components of a symmetric tensor.
const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

/// What makes fields of stresses.
#[derive(Clone, Copy)]
pub(super) struct Medium<'a> {
    pub(super) model: &'a dyn BodyModel,
    /// Places of [`COMPONENTS`] among those of the model.
    places: [Option<usize>; COMPONENTS.len()],
    /// Angle of the fibres of the base material from x, rad.
    pub(super) fibre_angle: Option<f64>,
    pub(super) strengths: Option<&'a Strengths>,
    /// Whose points can be of other materials.
    scene: Option<&'a BodyScene>,
}

impl<'a> Medium<'a> {
    /// That of a scene.
    pub(super) fn of(scene: &'a BodyScene) -> Self {
        Self {
            model: &*scene.model,
            places: places(&*scene.model),
            fibre_angle: scene.material().fibres().map(|fibres| fibres.angle),
            strengths: scene.case.strengths.as_ref(),
            scene: Some(scene),
        }
    }

    /// Strengths of the material of a point.
    fn strengths(&self, point: usize) -> Option<&'a Strengths> {
        let own = self.scene.and_then(|scene| {
            let material = scene.case.materials.get(&scene.material_of(point)?.name);
            material?.strengths.as_ref()
        });
        own.or(self.strengths)
    }

    /// Whether a field of a sum over points is the sum of theirs, by the material and the fibres of each: strains are linear in
    /// stresses so, and several fibres have no axes in common.
    pub(super) fn is_by_point(&self, origin: Origin) -> bool {
        let Some(materials) = self.scene.map(BodyScene::materials) else { return false };
        match origin {
            Origin::Strain(..) | Origin::FibreStrain(_) => !materials.is_one(),
            Origin::FibreStress(_)
            | Origin::TsaiHill
            | Origin::TsaiWu
            | Origin::HashinFibre
            | Origin::HashinMatrix
            | Origin::Utilisation => self.fibre_angle.is_some() && materials.fibre_angles().len() > 1,
            _ => false,
        }
    }

    /// Angle of the fibres of a point from x, rad.
    fn fibre_angle(&self, point: usize) -> Option<f64> {
        let own = self.scene.and_then(|scene| scene.material_of(point)?.fibre_angle);
        own.map(f64::to_radians).or(self.fibre_angle)
    }

    /// Stresses of a point in the axes of its fibres.
    fn fibre_stress(&self, (point, [x, y, xy, ..]): (usize, [f64; TENSOR])) -> Option<[f64; 3]> {
        self.fibre_angle(point).map(|angle| failure::in_fibre_axes([x, y, xy], angle))
    }

    /// The index of a criterion.
    fn index(
        &self,
        criterion: fn([f64; 3], &Strengths) -> Option<f64>,
        (point, stress): (usize, [f64; TENSOR]),
    ) -> Option<f64> {
        criterion(self.fibre_stress((point, stress))?, self.strengths(point)?)
    }
}

/// Places of [`COMPONENTS`] among those of a model.
fn places(model: &dyn BodyModel) -> [Option<usize>; COMPONENTS.len()] {
    COMPONENTS.map(|name| component(model, name))
}

/// Index of a component of strains and stresses among those of a model.
pub(super) fn component(model: &dyn BodyModel, name: &str) -> Option<usize> {
    model.tensor_components().iter().position(|component| *component == name)
}

/// The stress tensor of the components that a model has, with the stress across the plane, unless that is one of them.
fn tensor(medium: Medium, stress: [f64; TENSOR], across: f64) -> Matrix3<f64> {
    let of = |place: Option<usize>| place.map(|k| stress[k]);
    let [x, y, z, xy, xz, yz] = medium.places.map(of);
    let z = z.unwrap_or(across);
    let [x, y, xy, xz, yz] = [x, y, xy, xz, yz].map(Option::unwrap_or_default);
    Matrix3::new(x, xy, xz, xy, y, yz, xz, yz, z)
}

/// Von Mises stress.
fn von_mises(s: &Matrix3<f64>) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|k| s[(k, k)]);
    let squares = (x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x);
    let shear: f64 = [s[(0, 1)], s[(0, 2)], s[(1, 2)]].iter().map(|s| s * s).sum();
    (0.5 * squares + 3.0 * shear).sqrt()
}

/// Principal stresses, the largest first. Of what is no number they are none.
fn principal(s: &Matrix3<f64>) -> [f64; 3] {
    // What fills the plane and its normal needs no search, and is exact for one stress alone.
    let mut found = if s[(0, 2)] == 0.0 && s[(1, 2)] == 0.0 {
        let (mean, radius) =
            (0.5 * (s[(0, 0)] + s[(1, 1)]), (0.5 * (s[(0, 0)] - s[(1, 1)])).hypot(s[(0, 1)]));
        [mean + radius, mean - radius, s[(2, 2)]]
    } else {
        match SymmetricEigen::try_new(*s, f64::EPSILON, 100) {
            Some(eigen) => eigen.eigenvalues.into(),
            None => [f64::NAN; 3],
        }
    };
    found.sort_by(|a, b| b.total_cmp(a));
    found
}

/// A field that follows from the stresses of a point and the one across the plane; none of others.
pub(super) fn of_stress(
    origin: Origin,
    medium: Medium,
    (point, stress): (usize, [f64; TENSOR]),
    across: f64,
) -> Option<f64> {
    let model = medium.model;
    match origin {
        Origin::Strain(name, factor) => {
            let component = component(model, name)?;
            Some(factor * model.strains_at(point, stress, across)[component])
        }
        Origin::VonMises => Some(von_mises(&tensor(medium, stress, across))),
        Origin::Principal(k) => Some(principal(&tensor(medium, stress, across))[k]),
        Origin::MaxShear => {
            let [largest, _, smallest] = principal(&tensor(medium, stress, across));
            Some(0.5 * (largest - smallest))
        }
        Origin::Hydrostatic => Some(tensor(medium, stress, across).trace() / 3.0),
        Origin::PrincipalDirection => {
            let s = tensor(medium, stress, across);
            // A shear of −0 would turn it by half a turn.
            Some(0.5 * (2.0 * s[(0, 1)] + 0.0).atan2(s[(0, 0)] - s[(1, 1)]))
        }
        Origin::FibreStress(k) => Some(medium.fibre_stress((point, stress))?[k]),
        Origin::FibreStrain(k) => {
            let [x, y, gamma, ..] = model.strains_at(point, stress, across);
            Some(failure::in_fibre_axes([x, y, 0.5 * gamma], medium.fibre_angle(point)?)[k])
        }
        Origin::TsaiHill => medium.index(failure::tsai_hill, (point, stress)),
        Origin::TsaiWu => medium.index(failure::tsai_wu, (point, stress)),
        Origin::HashinFibre => medium.index(failure::hashin_fibre, (point, stress)),
        Origin::HashinMatrix => medium.index(failure::hashin_matrix, (point, stress)),
        Origin::Utilisation => match medium.fibre_angle {
            Some(_) => medium.index(failure::utilisation, (point, stress)),
            None => Some(von_mises(&tensor(medium, stress, across)) / medium.strengths(point)?.yield_stress?),
        },
        Origin::Stress("zz") => Some(component(model, "zz").map_or(across, |k| stress[k])),
        Origin::Stress(name) => Some(stress[component(model, name)?]),
        Origin::Unknown
        | Origin::Beam
        | Origin::Plate(_)
        | Origin::Energy
        | Origin::Damage
        | Origin::Temperature
        | Origin::Material
        | Origin::Opening
        | Origin::Reaction(_)
        | Origin::Turn(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::FieldName;
    use peristat_assembly::body::SquareLattice;
    use peristat_assembly::model::bond_plane::{
        BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
    };
    use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
    use std::sync::Arc;

    fn model(youngs_modulus: f64, state: PlaneState) -> BondPlane {
        let parameters = PlaneParameters {
            material: PlaneMaterial { youngs_modulus, thickness: 1.0, state },
            horizon_ratio: 2.0,
            influence: Influence::Constant,
            weights: Weights::Nearest,
            calibration: Calibration::Matched,
            volume_factor: VolumeFactor::Full,
            edges: Edges::None,
        };
        let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [3, 3]));
        BondPlane::on_lattice(lattice, Mirrors::NONE, parameters, &[]).unwrap()
    }

    /// What follows from the stresses in a plane.
    fn of(model: &BondPlane, field: FieldName, [x, y, xy]: [f64; 3]) -> f64 {
        let stress = [x, y, xy, 0.0, 0.0, 0.0];
        let medium = Medium { model, places: places(model), fibre_angle: None, strengths: None, scene: None };
        of_stress(field.about().origin, medium, (0, stress), model.across_of(stress)).unwrap()
    }

    #[test]
    fn von_mises_is_that_of_the_three_dimensional_stress() {
        let stress = model(1.0, PlaneState::Stress);
        let von_mises = |model: &BondPlane, stress: [f64; 3]| of(model, FieldName::VonMises, stress);
        assert_eq!(von_mises(&stress, [-3.0, 0.0, 0.0]), 3.0);
        assert!((von_mises(&stress, [0.0, 0.0, 2.0]) - 12.0_f64.sqrt()).abs() < 1e-15);
        // Equal biaxial stress 1 with σ_zz = 1/2: the deviator is that of a uniaxial stress of 1/2.
        assert_eq!(von_mises(&model(1.0, PlaneState::Strain), [1.0, 1.0, 0.0]), 0.5);
    }

    #[test]
    fn strains_are_components_of_the_tensor() {
        let model = model(3.0, PlaneState::Stress);
        assert!((of(&model, FieldName::StrainXx, [3.0, 0.0, 0.0]) - 1.0).abs() < 1e-15);
        assert!((of(&model, FieldName::StrainYy, [3.0, 0.0, 0.0]) + 1.0 / 3.0).abs() < 1e-15);
        // ε_xy = σ_xy/(2G), 2G = E/(1 + ν) = 9/4.
        assert!((of(&model, FieldName::StrainXy, [0.0, 0.0, 9.0]) - 4.0).abs() < 1e-14);
    }

    #[test]
    fn principal_stresses_are_in_their_order_with_the_one_across_the_plane() {
        use FieldName::{Hydrostatic, MaxShear, PrincipalDirection};
        let principal = |model: &BondPlane, stress: [f64; 3]| {
            let fields =
                [FieldName::PrincipalStress1, FieldName::PrincipalStress2, FieldName::PrincipalStress3];
            fields.map(|field| of(model, field, stress))
        };
        let plate = model(1.0, PlaneState::Stress);
        // Compression alone, pure shear, and Mohr's circle of radius 5 around 1.
        assert_eq!(principal(&plate, [-3.0, 0.0, 0.0]), [0.0, 0.0, -3.0]);
        assert_eq!(principal(&plate, [0.0, 0.0, 2.0]), [2.0, 0.0, -2.0]);
        assert_eq!(principal(&plate, [4.0, -2.0, -4.0]), [6.0, 0.0, -4.0]);
        assert_eq!([MaxShear, Hydrostatic].map(|f| of(&plate, f, [4.0, -2.0, -4.0])), [5.0, 2.0 / 3.0]);
        // σ_zz = ν (σ_xx + σ_yy) = 1/2 with ν = 1/4 is the middle one.
        let slice = model(1.0, PlaneState::Strain);
        assert_eq!(principal(&slice, [4.0, -2.0, -4.0]), [6.0, 0.5, -4.0]);
        assert_eq!(of(&slice, Hydrostatic, [4.0, -2.0, 0.0]), 2.5 / 3.0);
        let angle = |stress: [f64; 3]| of(&plate, PrincipalDirection, stress).to_degrees();
        assert_eq!(
            [angle([1.0, 0.0, 0.0]), angle([0.0, 1.0, 0.0]), angle([0.0, 0.0, 1.0])],
            [0.0, 90.0, 45.0]
        );
        // tan 2θ = 2 · (−4)/6.
        assert!((angle([4.0, -2.0, -4.0]) - 0.5 * (-4.0_f64 / 3.0).atan().to_degrees()).abs() < 1e-13);
    }

    #[test]
    fn principal_stresses_of_solids_are_those_that_were_turned() {
        // Q diag(7, -1, -1) Qᵀ with Q of columns (2, 2, 1)/3, (-2, 1, 2)/3, (1, -2, 2)/3: two are equal.
        let first = nalgebra::Vector3::new(2.0, 2.0, 1.0) / 3.0;
        let turned = 8.0 * first * first.transpose() - Matrix3::identity();
        let found = principal(&turned);
        assert!(found.iter().zip([7.0, -1.0, -1.0]).all(|(f, e)| (f - e).abs() < 1e-14), "{found:?}");
        assert!(principal(&Matrix3::repeat(f64::NAN)).iter().all(|p| p.is_nan()));
    }
}
