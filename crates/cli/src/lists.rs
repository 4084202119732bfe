//! `new`, `list` and `schema`.

use super::args::{Global, Kind};
use super::{DONE, USAGE, case_reference, note, say};
use peristat::Error;
use peristat::case::{Case, STARTS};
use peristat::reference;
use peristat::study::Study;
use peristat_assembly::model::timoshenko_beam::{bond_law, end_treatment};
use serde_json::json;

const BEAM: (&str, &str) = (
    "timoshenko_beam",
    "peridynamic Timoshenko beam: sections rectangle, circle, tube, i, general, tapered, by stiffness, power_law",
);

const PLATE: [(&str, &str); 38] = [
    (
        "bond_plane",
        "isotropic plate of central bonds, plane stress (ν = 1/3) or plane strain (ν = 1/4): rectangle, outline, points, mesh, and the specimens compact_tension, single_edge_bend, centre_cracked_panel",
    ),
    (
        "  calibration matched",
        "bonds with which a lattice has the moduli of the material to rounding (default)",
    ),
    (
        "  calibration published",
        "the constants of the continuum; moduli of a lattice are off by percents; with volume_factor full, clip, ramp, area",
    ),
    ("  influence constant", "ω = 1, how the stiffness of bonds depends on their length (default)"),
    ("  influence inverse", "ω = δ/ξ"),
    ("  influence linear", "ω = 1 − ξ/δ"),
    (
        "  edges overlay",
        "triangles replace missing bonds: exact for every uniform strain at every point (default of matched)",
    ),
    ("  edges none", "bonds beyond an edge are missing (default of published)"),
    ("  edges volume", "bonds are stiffened by the volumes of the families of their ends"),
    ("  edges energy", "bonds are stiffened by the energies of their ends in stretches along x and y"),
    (
        "beam_bond_orthotropic",
        "orthotropic plate of beam bonds, plane stress, fibres at any angle: rectangle, outline; points turn; calibrations and edges as bond_plane",
    ),
    (
        "  start aligned",
        "bonds that lie exactly on the fibres carry what the fibres add (default where there are such bonds)",
    ),
    (
        "  start oblique",
        "bonds carry the more of it the closer they are to the fibres: elasticity at any angle",
    ),
    ("  lattice axes", "rows of the lattice along x (default)"),
    (
        "  lattice fibre",
        "rows of the lattice along the fibres, so that bonds lie on them whatever their angle",
    ),
    (
        "shell_membrane",
        "membrane of a cylindrical shell of central bonds, ν = 1/3: a rectangle of length and arc, joined by periodic; calibrations as bond_plane",
    ),
    ("  kinematics chord", "elongations of straight lines in space: rigid motions are free (default)"),
    ("  kinematics published", "elongations in the developed plane"),
    ("  bending", "rows that resist changes of the curvature of the circumference, for ovalling"),
    (
        "state_plane",
        "isotropic plate of state-based families, plane stress or plane strain, any Poisson's ratio below 1/2: rectangle, outline",
    ),
    (
        "axisymmetric",
        "isotropic body of revolution of state-based families, any Poisson's ratio below 1/2: x is the radius, y the axis; volumes and forces are those of the whole ring: rectangle, outline",
    ),
    ("  influence linear", "ω = 1 − ξ/δ, how the weight of neighbours depends on their distance (default)"),
    ("  influence inverse", "ω = δ/ξ"),
    ("  influence constant", "ω = 1"),
    (
        "  edges ghosts",
        "points outside, moved by fits of those inside, complete every family (default on whole cells)",
    ),
    (
        "  edges border",
        "bonds end on the border, or leave what they have to triangles that it cuts: uniform stresses and held edges are exact (plates alone; default where a border cuts cells)",
    ),
    (
        "  edges moment_plus",
        "weights exact for every uniform strain in what is left of a family; points that would need negative ones give their energy away",
    ),
    ("  edges moment", "the same, refused where a weight would be negative, such as at corners"),
    ("  edges calibrated", "families are weighed by the neighbours that are there: moduli percents off"),
    ("  edges none", "families are weighed as if they were whole: moduli percents off"),
    ("  dilatation points", "every point measures its change of volume (default for ν <= 0.45)"),
    (
        "  dilatation blocks",
        "means over blocks of two by two points, so that nothing locks near ν = 1/2 (default in plane strain and of bodies of revolution for ν > 0.45)",
    ),
    ("  measure section", "of `axisymmetric`: neighbours count by their areas in the section (default)"),
    ("  measure published", "neighbours count by the volumes of their rings"),
    ("  axis table", "weights and radii that hold uniform stresses in equilibrium at the axis (default)"),
    ("  axis images", "images across the axis alone: hoop strains beside it are up to 70 % wrong"),
    ("  axis truncated", "families end at the axis: hoop strains beside it are about 17 % wrong"),
    (
        "  Poisson's ratio 1/3",
        "of `state_plane` in plane stress needs bonds alone, as does 1/4 of plane strain: no families are made",
    ),
];

const LOADS: [(&str, &str); 15] = [
    (
        "point",
        "a force and a moment at a position: force across, axial along the line, force_x and force_y in a frame; in the plane force_x and force_y, where points turn a moment, shared by the points of a region",
    ),
    ("distributed", "the same per length: uniform, linear or sine, over a line or a part of it"),
    ("w, phi, ux", "prescribed displacements of a support of a line, zero or not"),
    (
        "ux, uy, phi, inclined",
        "prescribed displacements of a support of a frame, zero or not; in the plane of a region or a point, phi where points turn",
    ),
    (
        "w_spring, phi_spring, ux_spring, uy_spring",
        "springs from a point to the ground; in the plane ux_spring and uy_spring, shared by the points of a region",
    ),
    ("hinges", "ends of the members of a frame that turn freely"),
    ("foundation", "springs per length against deflection under a part of a line, uniform or not"),
    ("rigid", "a rigid link between two points"),
    (
        "traction",
        "a force per area on an edge or hole in the plane: uniform, linear, parabolic, pressure, total or hertz, the pressure of a contact; depth is how far inwards it fades",
    ),
    (
        "body_force",
        "a force per volume on a region in the plane, or its total; of bodies of revolution spin, the inertia ρ ω² of turning about the axis",
    ),
    ("pressure", "a force per area outwards on a shell, the same all around or a cosine of it"),
    ("symmetry", "edges in the plane that are mirrors"),
    (
        "periodic",
        "opposite edges in the plane that are joined: held at their distance, or with stretches free to move apart, under a force or none",
    ),
    (
        "rigid regions",
        "regions in the plane that move as rigid bodies: held, moved or free to turn, such as pins, whose bearing is an angle",
    ),
    ("load_cases, combinations, steps", "several right-hand sides on one factorisation"),
];

const FRACTURE: [(&str, &str); 9] = [
    (
        "strategy batch",
        "bonds break together that are strained at least batch_threshold times as much as the worst (default)",
    ),
    (
        "strategy worst",
        "the worst bond breaks, with its equals by symmetry, wherever the load has to be for it: the load may snap back",
    ),
    ("strategy all", "all bonds break together that are strained beyond their critical strain"),
    ("stretch", "critical elongation over length of central bonds"),
    ("fibre_stretch, matrix_stretch", "the same of beam bonds along the fibres, and of all others"),
    (
        "energy_release_rate",
        "energy per area of a crack, for central bonds and beams in place of their strains",
    ),
    (
        "fibre_energy_release_rate, matrix_energy_release_rate",
        "the same across and along the fibres, for beam bonds",
    ),
    (
        "formula",
        "how stretches follow from energy release rates: energy, of the bonds that a crack on the lattice cuts (default), or published",
    ),
    ("curvature, shear_strain", "critical strains of a beam, one of them or both"),
];

const PATH: [(&str, &str); 9] = [
    ("bond_law bilinear", "bonds of `bond_plane` that yield, soften linearly and fail, for `path`"),
    ("unloading plastic, damage", "bonds keep a permanent stretch (default), or unload towards none"),
    ("compression elastic, perfectly_plastic", "how bonds answer compression"),
    ("kinematics linear, finite", "elongations of small displacements (default), or of any"),
    (
        "control auto",
        "displacement, or event where bonds are so brittle that the body snaps back; the summary says why (default)",
    ),
    ("control displacement", "steps of the load factor with a Newton method that cannot diverge"),
    ("control event", "exactly, from one bond that yields or fails to the next, snap-backs included"),
    ("control dissipation", "steps of dissipated energy, snap-backs included"),
    ("turns load_factor, load", "where the path turns: to load, unload and load again"),
];

const SOLVERS: [(&str, &str); 6] = [
    (
        "auto",
        "beams: the strain form where it applies, else a factor; plates: multigrid, a factor or pcg by their size; the summary says why (default)",
    ),
    (
        "strain",
        "strains of a straight beam with few supports: well conditioned whatever cells and slenderness",
    ),
    ("band", "band Cholesky factor of a beam, finished by conjugate gradients on the bonds"),
    (
        "sparse",
        "sparse Cholesky factor, ordered by minimum degree, in the plane by nested dissection, finished by conjugate gradients on the bonds",
    ),
    (
        "multigrid",
        "conjugate gradients on the bonds of a lattice in the plane, preconditioned by coarser lattices",
    ),
    (
        "pcg",
        "conjugate gradients on the bonds of a body in the plane, preconditioned by the blocks of its points",
    ),
];

/// Prints a starting case.
pub(super) fn new(name: &str) -> Result<u8, Error> {
    match STARTS.iter().find(|start| start.0 == name) {
        Some((_, case)) => {
            say(case)?;
            Ok(DONE)
        }
        None => {
            let known: Vec<&str> = STARTS.iter().map(|start| start.0).collect();
            note(&format!(
                "error: there is no case `{name}` to begin with\nhint: known are {}\n",
                known.join(", ")
            ));
            Ok(USAGE)
        }
    }
}

/// All entries of a kind: name and what it is.
fn entries(kind: Kind) -> Vec<(String, String)> {
    let own = |pairs: &[(&str, &str)]| -> Vec<(String, String)> {
        pairs.iter().map(|(a, b)| ((*a).into(), (*b).into())).collect()
    };
    match kind {
        Kind::Models => {
            let laws = bond_law::TABLE.iter().map(|l| (format!("  bond_law {}", l.name), l.about.into()));
            let ends =
                end_treatment::TABLE.iter().map(|t| (format!("  end_treatment {}", t.name), t.about.into()));
            own(&[BEAM]).into_iter().chain(laws).chain(ends).chain(own(&PLATE)).collect()
        }
        Kind::Loads => own(&LOADS),
        Kind::Fracture => own(&FRACTURE),
        Kind::Path => own(&PATH),
        Kind::References => reference::TABLE.iter().map(|r| (r.name.into(), r.about.into())).collect(),
        Kind::Solvers => own(&SOLVERS),
    }
}

/// Prints what there is.
pub(super) fn list(kind: Option<Kind>, global: &Global) -> Result<u8, Error> {
    let all = [
        (Kind::Models, "models"),
        (Kind::Loads, "loads"),
        (Kind::Fracture, "fracture"),
        (Kind::Path, "path"),
        (Kind::References, "references"),
        (Kind::Solvers, "solvers"),
    ];
    let chosen = all.iter().filter(|(k, _)| kind.is_none_or(|kind| kind == *k));
    if global.json {
        let lists = chosen.map(|(k, name)| {
            let list =
                entries(*k).into_iter().map(|(name, about)| json!({ "name": name.trim(), "about": about }));
            ((*name).to_string(), list.collect::<Vec<_>>().into())
        });
        say(&format!("{:#}\n", serde_json::Value::Object(lists.collect())))?;
        return Ok(DONE);
    }
    let mut text = String::new();
    for (k, name) in chosen {
        let list = entries(*k);
        let width = list.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        text += &format!("{name}\n");
        for (name, about) in list {
            text += &format!("  {name:<width$}  {about}\n");
        }
        text.push('\n');
    }
    say(text.trim_start())?;
    Ok(DONE)
}

/// Prints the JSON Schema of cases or of studies, or what it says as a page.
pub(super) fn schema(study: bool, markdown: bool) -> Result<u8, Error> {
    let (schema, head) = match study {
        true => (schemars::schema_for!(Study), case_reference::STUDIES),
        false => (schemars::schema_for!(Case), case_reference::CASES),
    };
    let schema = schema.to_value();
    say(&if markdown { case_reference::page(&schema, head) } else { format!("{schema:#}\n") })?;
    Ok(DONE)
}
