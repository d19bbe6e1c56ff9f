//! The ropeway as a discretised line: its typed line case, and the equilibrium of that.

use super::RopewayError;
use super::elastic::{AT_SUPPORT, ElasticRope};
use super::model::Ropeway;
use crate::case::{self, Case, Clump, End, Ends, Material, Method, Section};
use crate::scene;
use crate::solve::{Kinematics, State};
use crate::statics::equilibrium::EquilibriumSearch;

/// Equilibrium of the discretised line.
#[derive(Debug, Clone, PartialEq)]
pub struct DiscretisedEquilibrium {
    /// Nodes from the platform to the ship, x and height above still water \[m\].
    pub nodes: Vec<(f64, f64)>,
    /// Horizontal tension \[N\].
    pub horizontal_n: f64,
    /// Tension at the platform \[N\].
    pub platform_n: f64,
    /// Tension at the ship \[N\].
    pub ship_n: f64,
    /// Depth of the cargo below the straight line between the ends \[m\].
    pub sag_m: f64,
    /// Number of segments.
    pub segments: usize,
}

/// Name of the cargo in line cases.
const CARGO: &str = "cargo";

/// Name of the rope's material in line cases.
const ROPE: &str = "rope";

/// The static case: the rope of this unstretched length between its ends, with the cargo as a body at `arc_m` from the
/// platform, nowhere near a support.
#[must_use]
pub fn static_case(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> Case {
    let mut case = rope_case(ropeway);
    hang_cargo(&mut case, ropeway, length_m, arc_m);
    case.solver.method = Method::Static;
    case
}

/// The static case as a file.
#[must_use]
pub fn static_case_file(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> String {
    let text = case::write(&static_case(ropeway, length_m, arc_m));
    format!("# Written by seacable from a ropeway: all ropes as one, hanging in air.\n\n{text}")
}

/// All ropes as one material in air between platform and ship, both lying still; without sections yet.
fn rope_case(ropeway: &Ropeway) -> Case {
    let about = &ropeway.about;
    let squares = ropeway.ropes.iter().map(|rope| rope.diameter_m.powi(2));
    let diameter = squares.sum::<f64>().sqrt();
    let mass = ropeway.weight_n_per_m() / about.gravity_m_per_s2;
    let ends = Ends {
        a: End::fixed("platform", [0.0, 0.0, ropeway.platform.height_m]),
        b: End::fixed("ship", [about.span_m, 0.0, ropeway.ship.height_m]),
    };
    let mut case = Case::new(&about.title, ends);
    case.case.source.clone_from(&about.source);
    case.environment.gravity_m_per_s2 = about.gravity_m_per_s2;
    case.environment.water_density_kg_per_m3 = 0.0;
    let rope = Material::new(diameter, mass, ropeway.ea_n());
    case.materials.insert(ROPE.to_owned(), rope);
    case
}

/// Divides the rope at the cargo and hangs the cargo there.
fn hang_cargo(case: &mut Case, ropeway: &Ropeway, length_m: f64, arc_m: f64) {
    const BEFORE: &str = "platform-side";
    let [before, behind] = segments_beside_cargo(ropeway.about.segments, length_m, arc_m);
    case.line = vec![
        Section::new(BEFORE, ROPE, before.0, before.1),
        Section::new("ship-side", ROPE, behind.0, behind.1),
    ];
    case.clumps = vec![Clump::in_air(CARGO, BEFORE, arc_m, ropeway.cargo.mass_kg)];
}

/// Lengths of the rope and numbers of its segments on both sides of the cargo, the segments of nearly equal length.
pub(super) fn segments_beside_cargo(
    segments: usize,
    length_m: f64,
    arc_m: f64,
) -> [(f64, usize); 2] {
    let all = segments.max(4);
    let share = (arc_m / length_m * all as f64).round() as usize;
    let before = share.clamp(2, all - 2);
    [(arc_m, before), (length_m - arc_m, all - before)]
}

/// Equilibrium of the discretised line with the cargo at an unstretched length from the platform.
///
/// # Errors
/// [`RopewayError::NotFound`] where the cargo hangs on a support, or the line has no scene or no equilibrium.
pub fn equilibrium(
    ropeway: &Ropeway,
    length_m: f64,
    arc_m: f64,
) -> Result<DiscretisedEquilibrium, RopewayError> {
    if !(arc_m > AT_SUPPORT * length_m && arc_m < (1.0 - AT_SUPPORT) * length_m) {
        return Err(RopewayError::NotFound("the cargo hangs on a support"));
    }
    let case = static_case(ropeway, length_m, arc_m);
    let scene =
        scene::build(&case, 1).map_err(|_| RopewayError::NotFound("the line case has no scene"))?;
    let mut state = scene.initial_state();
    EquilibriumSearch::default()
        .run(&scene, 0.0, &mut state)
        .map_err(|_| RopewayError::NotFound("the discretised line has no equilibrium"))?;
    Ok(line_equilibrium(ropeway, &scene, &state))
}

fn line_equilibrium(
    ropeway: &Ropeway,
    scene: &scene::Scene,
    state: &State,
) -> DiscretisedEquilibrium {
    let last = scene.nodes() - 1;
    let cargo = scene.labels.clumps.first().map_or(0, |node| *node);
    let at = state.x[cargo];
    let line = ropeway.platform.height_m + ElasticRope::of_ropeway(ropeway).geometry.line_m(at.x);
    DiscretisedEquilibrium {
        nodes: state.x.iter().map(|p| (p.x, p.z)).collect(),
        horizontal_n: scene.end_force(0, state).x.abs(),
        platform_n: scene.tension_at(0, state),
        ship_n: scene.tension_at(last, state),
        sag_m: line - at.z,
        segments: last,
    }
}
