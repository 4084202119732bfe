//! `new`, `list` and `schema`.

use super::args::Global;
use super::choices::Kind;
use super::{DONE, case_reference, model_fields, say, schema, vocabulary};
use peristat::Error;
use peristat::case::{Case, Rolled};
use peristat::model::{self, Entry};
use peristat::reference;
use peristat::study::Study;
use serde_json::json;

/// The file of the schema, for editors.
const SCHEMA: &str = "case.schema.json";

const LOADS: [(&str, &str); 24] = [
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
    (
        "only, gap",
        "supports, springs and foundations of beams that push one way, once a gap is closed; members of a frame that bear tension alone, or compression",
    ),
    ("hinges", "ends of the members of a frame that turn freely"),
    ("offsets", "rigid arms from the joints of a frame to the ends of its members"),
    ("foundation", "springs per length against deflection under a part of a line, uniform or not"),
    ("rigid", "a rigid link between two points, or two joints"),
    (
        "traction",
        "a force per area on an edge or hole in the plane, or on a face or in a cut of a solid: uniform, linear, parabolic, pressure, total, or hertz, the pressure of a contact; depth is how far inwards it fades",
    ),
    ("body_force", "a force per volume on a region, or its total"),
    (
        "gravity",
        "the weight of a material of some density, of beams and of plates in bending, too; g in the units of the case",
    ),
    (
        "spin",
        "the inertia of a body of some density that turns: omega or rpm, about a point, of a solid along an axis",
    ),
    (
        "pressure",
        "a force per area outwards on a shell, the same all around or a cosine of it; along w on a plate in bending or a region of it, by a formula, too",
    ),
    ("line", "a force or moment per length of an edge of a plate in bending, or a force along a line on it"),
    (
        "w, phi_n, phi_t, phi_x, phi_y",
        "prescribed deflections and slopes of a plate in bending, zero or not: clamped, simply supported hard and soft, guided",
    ),
    (
        "phi_n_spring",
        "what a wall or a beam resists along an edge of a plate in bending that turns, per length",
    ),
    (
        "temperature",
        "a change of temperature of a body or a region, a number or a formula of the position, or a difference of it over the height of a beam or a plate in bending, with the `thermal_expansion` of the material",
    ),
    (
        "initial_strain",
        "a strain or a curvature that a line, a member, a body or a plate in bending would have if nothing held it: prestress, misfit, shrinkage",
    ),
    ("symmetry", "edges or faces that are mirrors"),
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
        "all bonds strained at least batch_threshold times as much as the worst break together (default)",
    ),
    (
        "strategy worst",
        "the most strained bond breaks, with those symmetric to it, at whatever load that takes: the load may snap back",
    ),
    ("strategy all", "all bonds strained beyond their critical strain break together"),
    ("stretch", "critical stretch of central bonds: elongation over length"),
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
        "how stretches follow from energy release rates: growth, of a crack that runs (default of central bonds in the plane), energy, of the bonds that a crack on the lattice cuts (default of others), or published",
    ),
    ("curvature, shear_strain", "critical strains of a beam or of a plate in bending, one of them or both"),
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
        "beams: the strain form where it applies, else a factor; other bodies: multigrid, a factor or pcg by their size; the summary says why (default)",
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
    ("multigrid", "conjugate gradients on the bonds of a lattice, preconditioned by coarser lattices"),
    (
        "pcg",
        "conjugate gradients on the bonds of a body other than a beam, preconditioned by the blocks of its points",
    ),
];

/// Prints a starting case, which names the schema that `schema` prints as the guide saves it: beside the case.
pub(super) fn new(name: &str) -> Result<u8, Error> {
    let case = model::start(name).unwrap_or_default();
    say(&case.replacen('{', &format!("{{\n  \"$schema\": \"{SCHEMA}\","), 1))?;
    Ok(DONE)
}

/// A model and what can be chosen of it.
fn of_model(entry: &Entry) -> Vec<(String, String)> {
    let option = |(name, about)| (format!("  {name}"), String::from(about));
    let own = std::iter::once((entry.name.to_string(), entry.about.to_string()));
    own.chain((entry.options)().into_iter().map(option)).collect()
}

/// All entries of a kind: name and what it is.
fn entries(kind: Kind) -> Vec<(String, String)> {
    let own = |pairs: &[(&str, &str)]| -> Vec<(String, String)> {
        pairs.iter().map(|(a, b)| ((*a).into(), (*b).into())).collect()
    };
    match kind {
        Kind::Models => model::TABLE.iter().flat_map(of_model).collect(),
        Kind::Bodies => vocabulary::of("Body"),
        Kind::Sections => vocabulary::of("Section"),
        Kind::Profiles => Rolled::names().map(|name| (name.into(), String::new())).collect(),
        Kind::Loads => own(&LOADS),
        Kind::Fields => vocabulary::of("FieldName"),
        Kind::Probes => vocabulary::of("Probe"),
        Kind::Checks => vocabulary::of("Check"),
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
        (Kind::Bodies, "bodies"),
        (Kind::Sections, "sections"),
        (Kind::Profiles, "profiles"),
        (Kind::Loads, "loads"),
        (Kind::Fields, "fields"),
        (Kind::Probes, "probes"),
        (Kind::Checks, "checks"),
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
            text += format!("  {name:<width$}  {about}").trim_end();
            text.push('\n');
        }
        text.push('\n');
    }
    say(text.trim_start())?;
    Ok(DONE)
}

/// Prints the JSON Schema of cases or of studies, or what it says as a page.
pub(super) fn schema(study: bool, markdown: bool) -> Result<u8, Error> {
    let (mut schema, head) = match study {
        true => (schema::of::<Study>(), case_reference::STUDIES),
        false => (schema::of::<Case>(), case_reference::CASES),
    };
    if !study {
        schema.insert("defaultSnippets".into(), schema::starts());
    }
    if !study && !markdown {
        model_fields::add(&mut schema)?;
        schema::without_moduli(&mut schema);
    }
    let schema = schema.to_value();
    say(&if markdown { case_reference::page(&schema, head) } else { format!("{schema:#}\n") })?;
    Ok(DONE)
}
