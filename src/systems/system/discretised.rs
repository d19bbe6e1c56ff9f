//! Lines that have no closed form: in a current, with bending stiffness, or with a tension-strain table. They take part as discretised lines once the closed forms have
//! found where everything is.

use std::sync::{Arc, OnceLock};

use super::line_at_rest::{LineAtRest, LineNote};
use super::model::{LineInputs, SystemFile};
use super::parts::{Part, is_crossed, parts};
use crate::case::{
    Case, Clump, DynamicStiffness, End, Ends, Floats, Method, Modules, Seabed, Section,
};
use crate::line_between_ends::{LineBetweenEnds, LineEquilibrium, LineError};
use crate::numerics::V3;
use crate::scene::{LaidFrom, Scene};
use crate::solve::State;

/// Segments of a line that does not say how many.
pub const SEGMENTS: usize = 100;
/// The fewest of a section; its pieces share them.
pub(in crate::system) const FEWEST: usize = 8;

/// How a line takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineForm {
    /// By its closed form everywhere.
    Closed,
    /// By its closed form where the bed below it is flat and it does not float at the surface, else divided into segments.
    ClosedWhereKnown,
    /// Divided into segments.
    Divided,
}

impl LineForm {
    /// The form of a line of these parts: divided where its file has a current, or a material of it bends, has a table or is stiffer at
    /// rest than its static stiffness; all of a run of the rest, which is on the mesh.
    #[must_use]
    pub fn of_parts(file: &SystemFile, line: &LineInputs, parts: &[Part]) -> Self {
        let bends = |part: &Part| part.material.ei_n_m2 > 0.0;
        let still = file.current.is_none() || line.still_water;
        let tabled = |part: &Part| part.material.strain.is_some();
        let secant = |part: &Part| part.material.dynamic_stiffness == DynamicStiffness::Secant;
        let is_open = |part: &Part| bends(part) || tabled(part) || secant(part);
        let closed = still && !file.is_run_at_rest() && !parts.iter().any(is_open);
        if !closed {
            Self::Divided
        } else if is_crossed(file) || file.seabed.as_ref().is_some_and(|bed| !bed.is_level()) {
            Self::ClosedWhereKnown
        } else {
            Self::Closed
        }
    }
}

/// A line as the element that is solved between its ends, and the case that states it.
#[derive(Debug, Clone)]
pub struct DiscretisedLine {
    /// Built where it is first needed, of a line that may have a closed form everywhere.
    element: OnceLock<Result<LineBetweenEnds, String>>,
    case: Case,
    /// Unstretched arc lengths of the nodes from A over the whole length, 0 to 1.
    shares: Vec<f64>,
}

/// A discretised line at rest: its element, to be solved again from here, and its nodes.
#[derive(Debug, Clone)]
pub struct DiscretisedRest {
    element: LineBetweenEnds,
    /// Forces, nodes, tensions.
    pub found: LineEquilibrium,
    shares: Arc<DiscretisedLine>,
}

/// Why a line has no equilibrium between its ends, and the Newton iterations of the search.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unsolved {
    /// Why.
    pub why: String,
    /// Newton iterations.
    pub iterations: u64,
}

impl Unsolved {
    /// A reason that took no iterations to find.
    #[must_use]
    pub fn of_reason(why: &(impl ToString + ?Sized)) -> Self {
        Self {
            why: why.to_string(),
            iterations: 0,
        }
    }
}

impl From<LineError> for Unsolved {
    fn from(error: LineError) -> Self {
        let iterations = match &error {
            LineError::NoEquilibrium(error) => error.iterations,
            _ => 0,
        };
        Self {
            iterations,
            ..Self::of_reason(&error)
        }
    }
}

impl DiscretisedLine {
    /// The element of a line of these parts, where it needs one.
    ///
    /// # Errors
    /// What the element says of the line.
    pub fn where_needed(
        file: &SystemFile,
        line: &LineInputs,
        parts: &[Part],
    ) -> Result<Option<Arc<Self>>, String> {
        let form = LineForm::of_parts(file, line, parts);
        if form == LineForm::Closed {
            return Ok(None);
        }
        let line = Arc::new(Self::of_parts(file, line, parts));
        let is_flat = file.seabed.as_ref().is_none_or(Seabed::is_level);
        if form == LineForm::Divided || !is_flat {
            line.element()?;
        }
        Ok(Some(line))
    }

    /// The element of a line of these parts, which needs none at rest.
    ///
    /// # Errors
    /// What the element says of the line.
    pub fn divided(
        file: &SystemFile,
        line: &LineInputs,
        parts: &[Part],
    ) -> Result<Arc<Self>, String> {
        Arc::new(Self::of_parts(file, line, parts)).with_element()
    }

    /// The same with its element built.
    ///
    /// # Errors
    /// What the element says of the line.
    pub fn with_element(self: Arc<Self>) -> Result<Arc<Self>, String> {
        self.element()?;
        Ok(self)
    }

    fn of_parts(file: &SystemFile, line: &LineInputs, parts: &[Part]) -> Self {
        let mut case = case(file, line, parts);
        if let Some((bed, given)) = case.seabed.as_mut().zip(file.seabed.as_ref()) {
            bed.stiffness_n_per_m3 = given.stiffness_n_per_m3;
            bed.damping_n_s_per_m3 = given.damping_n_s_per_m3;
            let [along, across] = file.friction_under(line);
            (bed.friction, bed.friction_lateral) = (Some(along), Some(across));
            bed.friction_law = given.friction_law;
            bed.grip_stiffness_n_per_m3 = given.grip_stiffness_n_per_m3;
            bed.slip_speed_m_per_s = given.slip_speed_m_per_s;
        }
        Self::stated_by(case)
    }

    fn stated_by(case: Case) -> Self {
        let shares = shares(&case);
        Self {
            element: OnceLock::new(),
            case,
            shares,
        }
    }

    /// The same line with so many times the segments in each section.
    ///
    /// # Errors
    /// What the element says of the line.
    pub fn refined(&self, by: usize) -> Result<Self, String> {
        let mut case = self.case.clone();
        for section in &mut case.line {
            section.segments *= by;
        }
        let refined = Self::stated_by(case);
        refined.element()?;
        Ok(refined)
    }

    /// The element of the line.
    fn element(&self) -> Result<&LineBetweenEnds, String> {
        let build = || LineBetweenEnds::new(&self.case).map_err(|error| error.to_string());
        self.element
            .get_or_init(build)
            .as_ref()
            .map_err(String::clone)
    }

    /// Number of its segments.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.shares.len() - 1
    }

    /// Whether it has bending stiffness.
    #[must_use]
    pub fn bends(&self) -> bool {
        let case = &self.case;
        let of = |name: &str| case.materials.get(name).map(|material| material.ei_n_m2);
        let mut sections = case.line.iter().filter_map(|section| of(&section.material));
        sections.any(|stiffness| stiffness > 0.0)
    }

    /// The case that states it.
    #[must_use]
    pub fn case(&self) -> &Case {
        &self.case
    }

    /// The line at rest between two places, from the solution before if there is one; its clamps in `directions`, where these are on bodies.
    ///
    /// # Errors
    /// Why it has no equilibrium.
    pub fn solve(
        self: &Arc<Self>,
        (a, b): (&V3, &V3),
        directions: &[Option<V3>; 2],
        laid_from: LaidFrom,
        before: Option<&LineAtRest>,
    ) -> Result<LineAtRest, Unsolved> {
        let near = before.and_then(|before| before.discretised.as_ref());
        let mut element = match near {
            Some(near) => near.element.clone(),
            None => self
                .element()
                .map_err(|why| Unsolved::of_reason(&why))?
                .clone(),
        };
        element.lay_from(laid_from);
        element.turn_clamps(directions);
        let found = element.solve(*a, *b)?;
        // Springs without stiffness: neither end lies, and nothing says how it was laid.
        let grips = &element.scene_and_state().0.start.grips;
        let left_out = !grips.is_empty() && grips.iter().all(|grip| grip.stiffness == 0.0);
        let without_friction = left_out && found.on_bed_m > 0.0;
        Ok(LineAtRest {
            note: without_friction.then_some(LineNote::WithoutFriction),
            ..self.at_rest(*a, element, found)
        })
    }

    /// The line straight between two places and without forces, which it begins a run from in the place of an equilibrium.
    ///
    /// # Errors
    /// Why it has no element.
    pub fn unloaded(self: &Arc<Self>, (a, b): (&V3, &V3)) -> Result<LineAtRest, Unsolved> {
        let mut element = self
            .element()
            .map_err(|why| Unsolved::of_reason(&why))?
            .clone();
        let found = element.unloaded(*a, *b);
        Ok(LineAtRest {
            note: Some(LineNote::NoEquilibrium),
            ..self.at_rest(*a, element, found)
        })
    }

    fn at_rest(
        self: &Arc<Self>,
        a: V3,
        element: LineBetweenEnds,
        found: LineEquilibrium,
    ) -> LineAtRest {
        LineAtRest {
            force_a: found.force_a_n,
            force_b: found.force_b_n,
            by_ends: found.stiffness_n_per_m,
            solution: None,
            from_b: false,
            origin: a,
            along: V3::x(),
            note: None,
            replaced: None,
            added_weight: 0.0,
            discretised: Some(Box::new(DiscretisedRest {
                element,
                found,
                shares: Arc::clone(self),
            })),
        }
    }
}

impl DiscretisedRest {
    /// Lays the line on the bed anew where its ends are, for its next solution: see [`LineBetweenEnds::lay`].
    pub fn lay(&mut self) {
        self.element.lay();
    }

    /// Frees what it would be solved again by: see [`LineBetweenEnds::free_work`].
    pub fn free_work(&mut self) {
        self.element.free_work();
    }

    /// Unstretched length of its longest segment \[m\].
    #[must_use]
    pub fn longest_segment_m(&self) -> f64 {
        let sections = self.shares.case.line.iter();
        let segments = sections.map(|section| section.length_m / section.segments as f64);
        segments.fold(0.0, f64::max)
    }

    /// The scene of the line and its state at rest.
    #[must_use]
    pub fn scene_and_state(&self) -> (&Scene, &State) {
        self.element.scene_and_state()
    }

    /// Unstretched arc lengths of its nodes from A over the whole length, 0 to 1.
    #[must_use]
    pub fn shares(&self) -> &[f64] {
        &self.shares.shares
    }

    /// A place of the line \[m\] and the tension there \[N\], at a share of its unstretched length from A.
    #[must_use]
    pub fn at(&self, share: f64) -> (V3, f64) {
        let shares = &self.shares.shares;
        let next = shares
            .partition_point(|s| *s < share)
            .clamp(1, shares.len() - 1);
        let (from, to) = (shares[next - 1], shares[next]);
        let part = ((share - from) / (to - from)).clamp(0.0, 1.0);
        let (place, tension) = (&self.found.position_m, &self.found.tension_n);
        (
            place[next - 1].lerp(&place[next], part),
            tension[next - 1] + part * (tension[next] - tension[next - 1]),
        )
    }
}

/// The case of one line between held ends.
fn case(file: &SystemFile, line: &LineInputs, parts: &[Part]) -> Case {
    let mut ends = Ends {
        a: End::fixed("a", [0.0; 3]),
        b: End::fixed("b", [1.0, 0.0, 0.0]),
    };
    ends.a.clamp_elevation_deg = line.clamp_a_elevation_deg;
    ends.a.clamp_azimuth_deg = line.clamp_a_azimuth_deg;
    ends.b.clamp_elevation_deg = line.clamp_b_elevation_deg;
    ends.b.clamp_azimuth_deg = line.clamp_b_azimuth_deg;
    let mut case = Case::new(&line.name, ends);
    case.environment = file.environment.clone();
    case.current = file.current.clone().filter(|_| !line.still_water);
    let bed = file.seabed.as_ref().filter(|_| line.bed_contact);
    case.seabed = bed.map(|bed| Seabed {
        depth_at_m: bed.depth_at_m,
        slope_deg: bed.slope_deg,
        slope_azimuth_deg: bed.slope_azimuth_deg,
        depth_file: bed.depth_file.clone(),
        interpolation: bed.interpolation,
        ..Seabed::level(bed.depth_m)
    });
    let depths = file.seabed.as_ref().and_then(|bed| bed.depth_file.as_ref());
    let depths = depths.and_then(|name| file.files.get_key_value(name));
    let current = case
        .current
        .as_ref()
        .and_then(|current| current.file.as_ref());
    let current = current.and_then(|name| file.files.get_key_value(name));
    case.files.extend(
        depths
            .into_iter()
            .chain(current)
            .map(|(name, file)| (name.clone(), file.clone())),
    );
    case.solver.method = Method::Static;
    let shape = line.start.as_ref().filter(|start| start.begins_search());
    if let Some(start) = shape {
        case.start = start.clone();
    }
    for (k, part) in parts.iter().enumerate() {
        let name = format!("section{}", k + 1);
        // Each section has a material of its own: parts of one material may differ.
        case.materials.insert(name.clone(), part.material.clone());
        let count = segments_of(line, part, parts);
        case.line
            .push(Section::new(&name, &name, part.length_m, count));
        attach(&mut case, part, (k, name));
    }
    case
}

/// Attaches to a section, by its number and name, what is on a part.
fn attach(case: &mut Case, part: &Part, (number, name): (usize, String)) {
    let section = Some(name);
    let floats = part.floats.iter().map(|floats| Floats {
        section: section.clone(),
        ..floats.clone()
    });
    case.floats.extend(floats);
    let modules = part.modules.iter().map(|modules| Modules {
        section: section.clone(),
        ..modules.clone()
    });
    case.modules.extend(modules);
    for clump in &part.clumps {
        let name = match clump.name.is_empty() {
            true => format!("clump{}", number + 1),
            false => clump.name.clone(),
        };
        case.clumps.push(Clump {
            name,
            section: section.clone(),
            ..clump.clone()
        });
    }
}

/// Segments of a part of a line: by what its sections ask for, or by its length.
fn segments_of(line: &LineInputs, part: &Part, parts: &[Part]) -> usize {
    let asked = |part: &Part| Some(part.segments? as f64 / part.pieces as f64);
    let all: Option<f64> = parts.iter().map(asked).sum();
    let whole: f64 = parts.iter().map(|part| part.length_m).sum();
    let (share, fewest) = match asked(part).zip(all) {
        Some((own, all)) => (own / all, 1),
        None => (part.length_m / whole, FEWEST.div_ceil(part.pieces)),
    };
    let count = (line.wanted_segments() as f64 * share).round();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count of segments, bounded by the file"
    )]
    let count = count as usize;
    count.max(fewest)
}

/// Whether the bodies on a line of a file hang at nodes where it is divided into so many times fewer segments.
#[must_use]
pub fn keeps_its_places(file: &SystemFile, line: &LineInputs, coarser: usize) -> bool {
    const ROUNDING: f64 = 1e-9;
    if line.clumps.is_empty() {
        return true;
    }
    let parts = parts(file, line);
    let coarse = LineInputs {
        segments: Some(line.wanted_segments().div_ceil(coarser)),
        ..line.clone()
    };
    parts.iter().all(|part| {
        let segments = segments_of(&coarse, part, &parts) as f64;
        let mut places = part.clumps.iter();
        places.all(|clump| {
            let place = clump.at_m / part.length_m * segments;
            (place - place.round()).abs() < ROUNDING * segments
        })
    })
}

/// Segments that a line of a file is divided into.
#[must_use]
pub fn segments(file: &SystemFile, line: &LineInputs) -> usize {
    let parts = parts(file, line);
    let each = parts.iter().map(|part| segments_of(line, part, &parts));
    each.sum()
}

fn shares(case: &Case) -> Vec<f64> {
    let whole: f64 = case.line.iter().map(|section| section.length_m).sum();
    let mut shares = vec![0.0];
    let mut before = 0.0;
    for section in &case.line {
        for k in 1..=section.segments {
            let arc = before + section.length_m * k as f64 / section.segments as f64;
            shares.push(arc / whole);
        }
        before += section.length_m;
    }
    shares
}
