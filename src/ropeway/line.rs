//! The ropeway as a line of the ordinary kind: a case of its own, made into a scene and brought to rest node by node.

use super::Trouble;
use super::exact::{AT_SUPPORT, Span};
use super::model::Ropeway;
use crate::case;
use crate::scene;
use crate::solve::{Kinematics, State};
use crate::statics::equilibrium::EquilibriumSearch;

/// The discretised line at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct LineRest {
    /// Nodes from the platform to the ship, x and height above still water \[m\].
    pub nodes: Vec<(f64, f64)>,
    /// Horizontal pull \[N\].
    pub horizontal_n: f64,
    /// Tension at the platform \[N\].
    pub platform_n: f64,
    /// Tension at the ship \[N\].
    pub ship_n: f64,
    /// Depth of the cargo below the straight line between the ends \[m\].
    pub sag_m: f64,
    /// Its segments.
    pub segments: usize,
}

/// The text of the case in which the cargo is hauled over the whole line, the ship lying still and the rope made fast:
/// arc lengths from the platform at which it begins and ends \[m\], and time that is followed \[s\].
#[must_use]
pub fn crossing_text(ropeway: &Ropeway, length_m: f64, way: (f64, f64), duration_s: f64) -> String {
    let (mass, speed) = (ropeway.cargo.mass_kg, ropeway.cargo.speed_m_per_s);
    let mut text = head(ropeway);
    text.push_str("axial_damping_ratio = 0.02\n");
    text.push_str(&section("rope", length_m, ropeway.about.segments));
    text.push_str(&ends(ropeway));
    text.push_str(&format!(
        "\n[traveller]\nname = \"cargo\"\nmass_kg = {mass:?}\nwet_mass_kg = {mass:?}\n\
         from_m = {:?}\nto_m = {:?}\nspeed_m_per_s = {speed:?}\nramp_s = 2.0\n\
         \n[solver]\nmethod = \"alpha\"\nduration_s = {duration_s:?}\ntime_step_s = 0.05\nerror_estimate = false\n",
        way.0, way.1
    ));
    text
}

/// The text of the case in which the ship's end moves along a table of displacements, `time_s,x_m,y_m,z_m`, the rope made fast
/// and the cargo at its place along it; the motion grows from nothing over `ramp_s`.
#[must_use]
pub fn moving_text(
    ropeway: &Ropeway,
    (length_m, arc_m): (f64, f64),
    table: &str,
    (duration_s, ramp_s, interval_s): (f64, f64, f64),
) -> String {
    let mass = ropeway.cargo.mass_kg;
    let mut text = head(ropeway);
    text.push_str("axial_damping_ratio = 0.02\n");
    let [a, b] = sections(ropeway, length_m, arc_m);
    for (name, part) in [("platform-side", a), ("ship-side", b)] {
        text.push_str(&section(name, part.0, part.1));
    }
    let moving = format!(
        "kind = \"moving\"\nmotion = \"table\"\nmotion_file = \"ship.csv\"\nramp_s = {ramp_s:?}\n"
    );
    let still = ends(ropeway);
    let last = still.rfind("kind = \"fixed\"\n").unwrap_or(still.len());
    text.push_str(&still[..last]);
    text.push_str(&moving);
    text.push_str(still[last..].trim_start_matches("kind = \"fixed\"\n"));
    text.push_str(&format!(
        "\n[[clumps]]\nname = \"cargo\"\nsection = \"platform-side\"\nat_m = {:?}\nmass_kg = {mass:?}\nwet_mass_kg = {mass:?}\n\
         \n[solver]\nmethod = \"alpha\"\nduration_s = {duration_s:?}\ntime_step_s = 0.05\nerror_estimate = true\n\
         \n[output]\ninterval_s = {interval_s:?}\n\
         \n[files.\"ship.csv\"]\ntext = \"\"\"\n{table}\"\"\"\n",
        a.0
    ));
    text
}

/// The text of the line case: the rope of this unstretched length between its ends, with the cargo as a body at `arc_m`
/// from the platform, nowhere near a support.
#[must_use]
pub fn case_text(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> String {
    let [a, b] = sections(ropeway, length_m, arc_m);
    let mass = ropeway.cargo.mass_kg;
    let mut text = head(ropeway);
    for (name, part) in [("platform-side", a), ("ship-side", b)] {
        text.push_str(&section(name, part.0, part.1));
    }
    text.push_str(&ends(ropeway));
    text.push_str(&format!(
        "\n[[clumps]]\nname = \"cargo\"\nsection = \"platform-side\"\nat_m = {:?}\nmass_kg = {mass:?}\nwet_mass_kg = {mass:?}\n\
         \n[solver]\nmethod = \"static\"\n",
        a.0
    ));
    text
}

fn section(name: &str, length_m: f64, segments: usize) -> String {
    format!(
        "\n[[line]]\nname = \"{name}\"\nmaterial = \"rope\"\nlength_m = {length_m:?}\nsegments = {segments}\n"
    )
}

/// Platform and ship, both lying still.
fn ends(ropeway: &Ropeway) -> String {
    let (low, high) = (ropeway.platform.height_m, ropeway.ship.height_m);
    let span = ropeway.about.span_m;
    format!(
        "\n[ends.a]\nname = \"platform\"\nkind = \"fixed\"\nposition_m = [0.0, 0.0, {low:?}]\n\
         \n[ends.b]\nname = \"ship\"\nkind = \"fixed\"\nposition_m = [{span:?}, 0.0, {high:?}]\n"
    )
}

/// What every line case of a ropeway begins with.
fn head(ropeway: &Ropeway) -> String {
    let g = ropeway.about.gravity_m_per_s2;
    let mass = ropeway.weight_n_per_m() / g;
    let squares = ropeway.ropes.iter().map(|rope| rope.diameter_m.powi(2));
    let diameter = squares.sum::<f64>().sqrt();
    let title = toml_edit::Value::from(ropeway.about.title.as_str());
    let source = toml_edit::Value::from(ropeway.about.source.as_str());
    format!(
        "# Written by seacable from a ropeway: all ropes as one, hanging in air.\n\n\
         [case]\ntitle = {title}\nsource = {source}\n\n\
         [environment]\ngravity_m_per_s2 = {g:?}\nwater_density_kg_per_m3 = 0.0\n\n\
         [materials.rope]\ndiameter_m = {diameter:?}\nmass_kg_per_m = {mass:?}\nea_n = {:?}\n",
        ropeway.ea_n()
    )
}

/// Lengths and segments before and behind the cargo, segments of about one length.
fn sections(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> [(f64, usize); 2] {
    let all = ropeway.about.segments.max(4);
    let share = (arc_m / length_m * all as f64).round() as usize;
    let before = share.clamp(2, all - 2);
    [(arc_m, before), (length_m - arc_m, all - before)]
}

/// The discretised line at rest, with the cargo at an unstretched length from the platform.
///
/// # Errors
/// [`Trouble::NotFound`] where the line is not built or finds no rest; a cargo on a support is not its business.
pub fn at_rest(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> Result<LineRest, Trouble> {
    if !(arc_m > AT_SUPPORT * length_m && arc_m < (1.0 - AT_SUPPORT) * length_m) {
        return Err(Trouble::NotFound("the cargo hangs on a support"));
    }
    let text = case_text(ropeway, length_m, arc_m);
    let case = case::parse(&text, "ropeway")
        .map_err(|_| Trouble::NotFound("the ropeway makes no line case"))?;
    let scene =
        scene::build(&case, 1).map_err(|_| Trouble::NotFound("the line case makes no line"))?;
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .map_err(|_| Trouble::NotFound("the discretised line finds no rest"))?;
    Ok(read(ropeway, &scene, &state))
}

fn read(ropeway: &Ropeway, scene: &scene::Scene, state: &State) -> LineRest {
    let last = scene.nodes() - 1;
    let cargo = scene.clumps.first().map_or(0, |node| *node);
    let at = state.x[cargo];
    let line = ropeway.platform.height_m + Span::of(ropeway).gap.line_m(at.x);
    LineRest {
        nodes: state.x.iter().map(|p| (p.x, p.z)).collect(),
        horizontal_n: scene.end_force(0, state).x.abs(),
        platform_n: scene.tension_at(0, state),
        ship_n: scene.tension_at(last, state),
        sag_m: line - at.z,
        segments: last,
    }
}
