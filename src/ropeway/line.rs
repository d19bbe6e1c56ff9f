//! The ropeway as a discretised line: typed line cases of it, their equilibrium and their runs.

use std::sync::atomic::AtomicBool;

use super::RopewayError;
use super::elastic::{AT_SUPPORT, ElasticRope};
use super::model::Ropeway;
use crate::case::{
    self, Attachment, Case, ChannelId, ChannelLocation, ChannelQuantity, Clump, End, Ends,
    Material, Method, Section, Solver, Statistic,
};
use crate::run::job::{self, Request};
use crate::run::{QuantityId, Run, RunState, Subject};
use crate::scene;
use crate::solve::{Kinematics, State};
use crate::statics::equilibrium::EquilibriumSearch;

/// Equilibrium of the discretised line.
#[derive(Debug, Clone, PartialEq)]
pub struct LineEquilibrium {
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

/// Axial damping of the line in motion, of critical of a segment's highest axial mode \[-\].
const AXIAL_DAMPING: f64 = 0.02;

/// Step of the line in motion \[s\].
const TIME_STEP: f64 = 0.05;

/// The case in which the ship's end moves along displacements over time \[s, m\], the rope made fast and the cargo at its
/// place along it; the motion grows from nothing over `ramp_s`.
#[must_use]
pub fn moving_case(
    ropeway: &Ropeway,
    (length_m, arc_m): (f64, f64),
    displacements: impl IntoIterator<Item = (f64, [f64; 3])>,
    (duration_s, ramp_s, interval_s): (f64, f64, f64),
) -> Case {
    const FILE: &str = "ship.csv";
    let mut case = rope_case(ropeway, Some(AXIAL_DAMPING));
    hang_cargo(&mut case, ropeway, length_m, arc_m);
    case.ends.b = case.ends.b.moved_by_table(FILE, ramp_s);
    let table = Attachment::displacements(displacements);
    case.files.insert(FILE.to_owned(), table);
    case.solver = in_motion(duration_s, true);
    case.output.interval_s = interval_s;
    case
}

/// The static case: the rope of this unstretched length between its ends, with the cargo as a body at `arc_m` from the
/// platform, nowhere near a support.
#[must_use]
pub fn static_case(ropeway: &Ropeway, length_m: f64, arc_m: f64) -> Case {
    let mut case = rope_case(ropeway, None);
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
fn rope_case(ropeway: &Ropeway, axial_damping_ratio: Option<f64>) -> Case {
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
    let rope = Material {
        axial_damping_ratio,
        ..Material::new(diameter, mass, ropeway.ea_n())
    };
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

/// Generalized-alpha in constant steps.
fn in_motion(duration_s: f64, error_estimate: bool) -> Solver {
    Solver {
        method: Method::Alpha,
        duration_s,
        time_step_s: Some(TIME_STEP),
        error_estimate,
        ..Solver::default()
    }
}

/// A line case of a ropeway computed.
pub struct LineRun {
    case: Case,
    /// What was computed.
    pub run: Run,
}

impl LineRun {
    /// Computes a case.
    ///
    /// # Errors
    /// [`RopewayError::NotFound`] where the solver gives up.
    pub fn compute(case: Case) -> Result<Self, RopewayError> {
        let request = Request {
            text: case::write(&case),
            case,
            file: "ropeway.toml".to_owned(),
            overrides: Vec::new(),
            id: String::new(),
        };
        let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
        if run.info.state != RunState::Done {
            return Err(RopewayError::NotFound(
                "the dynamic solver gave up on the line",
            ));
        }
        let case = request.case;
        Ok(Self { case, run })
    }

    /// Values of a quantity at the output times.
    ///
    /// # Errors
    /// [`RopewayError::NotFound`] where the run does not record it there.
    pub fn values(
        &self,
        quantity: ChannelQuantity,
        site: ChannelLocation,
    ) -> Result<&[f64], RopewayError> {
        let id = self.channel_id(quantity, site);
        let mut channels = self.run.history.channels.iter();
        let channel = channels.find(|channel| Some(&channel.id) == id.as_ref());
        let channel = channel.ok_or(RopewayError::NotFound(
            "the run of the line lacks a channel",
        ))?;
        Ok(&channel.values)
    }

    /// Time and mesh error of the greatest tension at the ship \[N\].
    #[must_use]
    pub fn errors_of_greatest_tension(&self) -> (Option<f64>, Option<f64>) {
        let channel = self.channel_id(ChannelQuantity::Tension, self.ship());
        let maximum = channel.map(|id| QuantityId::new(Subject::Channel(id), Statistic::Max, None));
        let mut summary = self.run.summary.iter();
        let found = summary.find(|found| Some(&found.id) == maximum.as_ref());
        (
            found.and_then(|found| found.time_error),
            found.and_then(|found| found.mesh_error),
        )
    }

    /// The joint at the ship.
    #[must_use]
    pub fn ship(&self) -> ChannelLocation {
        ChannelLocation::Joint(self.case.line.len())
    }

    fn channel_id(&self, quantity: ChannelQuantity, site: ChannelLocation) -> Option<ChannelId> {
        let channels = case::channels(&self.case).into_iter();
        let mut ids = channels.filter(|c| c.site == site).map(|c| c.id);
        ids.find(|id| id.quantity == quantity)
    }
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
) -> Result<LineEquilibrium, RopewayError> {
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

fn line_equilibrium(ropeway: &Ropeway, scene: &scene::Scene, state: &State) -> LineEquilibrium {
    let last = scene.nodes() - 1;
    let cargo = scene.labels.clumps.first().map_or(0, |node| *node);
    let at = state.x[cargo];
    let line = ropeway.platform.height_m + ElasticRope::of(ropeway).geometry.line_m(at.x);
    LineEquilibrium {
        nodes: state.x.iter().map(|p| (p.x, p.z)).collect(),
        horizontal_n: scene.end_force(0, state).x.abs(),
        platform_n: scene.tension_at(0, state),
        ship_n: scene.tension_at(last, state),
        sag_m: line - at.z,
        segments: last,
    }
}
