//! A system in SI: points, bodies, lines and what surrounds them.

use std::sync::Arc;

use nalgebra::Matrix6;

use super::bed::Bed;
use super::discretised::DiscretisedLine;
use super::initial::{BodyInitial, PointInitial};
use super::motion::PoseMotion;
use super::motion::payout::Payout;
use super::point_on_bed::BearingArea;
use super::pose::Pose;
use super::potential_flow::PotentialFlow;
use crate::case::{Start, StartShape};
use crate::numerics::{M3, V3};
use crate::physics::current::CurrentProfile;
use crate::physics::rigid_body::drag_strips;
use crate::physics::sea::Sea;
use crate::physics::{CurrentGrid, EndMotion, Suction};
use crate::statics::catenary::SectionProperties;

/// A system of lines, in SI.
#[derive(Debug, Clone, Default)]
pub struct Network {
    /// Gravity \[m/s²\].
    pub gravity: f64,
    /// Density of the water \[kg/m³\].
    pub density: f64,
    /// Whether lines and points weigh what they weigh in air where they are out of the water; else they count as under water there.
    pub crossed: bool,
    /// The sea bed; nothing where none is in reach.
    pub bed: Option<Bed>,
    /// The current on lines, points and bodies, if there is one; where it changes with time, that at time zero.
    pub current: Option<CurrentProfile>,
    /// The same in motion, where it changes with time.
    pub current_over_time: Option<Arc<CurrentGrid>>,
    /// Waves in motion, if there are any.
    pub sea: Option<Sea>,
    /// Where the height of the waves is recorded \[m\].
    pub gauge: V3,
    /// Whether the upward pull of the lines on fixed points is recorded in motion.
    pub records_uplift: bool,
    /// Whether their force on fixed and moved points is.
    pub records_forces: bool,
    /// Whether the energy of all of it is.
    pub records_energy: bool,
    /// Velocity of the wind on bodies \[m/s\].
    pub wind: V3,
    /// Points that lines end at.
    pub points: Vec<Point>,
    /// Bodies that points are on.
    pub bodies: Vec<Body>,
    /// Lines.
    pub lines: Vec<Line>,
    /// What of them is paid out or slides, in motion.
    pub payouts: Vec<Payout>,
}

/// A point that lines end at.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// What holds it.
    pub held: Held,
    /// How it moves about its place, where it is moved.
    pub motion: Option<EndMotion>,
}

/// What holds a point.
#[derive(Debug, Clone, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "points are few, and those that are free are read at every step"
)]
pub enum Held {
    /// It is at this place \[m\].
    At(V3),
    /// It is at this place of a body's frame \[m\].
    On(usize, V3),
    /// Nothing but lines, bed and surface.
    Free(FreePoint),
}

/// A point that lines hold.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct FreePoint {
    /// Weight in air \[N\].
    pub weight: f64,
    /// Buoyancy under water \[N\].
    pub buoyancy: f64,
    /// Whether it counts as under water at any height.
    pub always_wet: bool,
    /// Mass with added mass, and the added mass alone, along x, y, z \[kg\].
    pub moving_mass: V3,
    /// See `moving_mass`.
    pub added_mass: V3,
    /// Drag coefficient times area along x, y, z \[m²\].
    pub drag_area: V3,
    /// Steady load \[N\].
    pub load: V3,
    /// Friction on the bed in motion \[-\].
    pub friction: f64,
    /// The speed below which that is in proportion to the velocity \[m/s\], where it goes by that and not about an anchor.
    pub slip_speed: Option<f64>,
    /// How far its bottom is below it \[m\].
    pub below: f64,
    /// The area that bears on the bed; without, it does so by its weight.
    pub bearing: Option<BearingArea>,
    /// Suction of the bed on it in motion, once it has borne on it.
    pub suction: Option<Suction>,
    /// Where the search begins \[m\], if that is given.
    pub start: Option<V3>,
    /// How it begins a run in time.
    pub initial: PointInitial,
}

/// A rigid body.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Where it is held, or where the search begins and its hydrostatics hold.
    pub pose: Pose,
    /// Whether it is free.
    pub free: bool,
    /// Whether it is pinned: its origin is held or moved, and it is free to turn.
    pub pinned: bool,
    /// The body that it is pinned to, and where in the frame of that body \[m\]; nothing for the earth.
    pub carrier: Option<(usize, V3)>,
    /// Mass in air \[kg\] and weight in air \[N\]; zero while a held body does not say its mass.
    pub mass: f64,
    /// See `mass`.
    pub weight: f64,
    /// Centre of gravity in its frame \[m\].
    pub centre_of_gravity: V3,
    /// Inertia about the centre of gravity, in its frame \[kg m²\].
    pub inertia: M3,
    /// Buoyancy at the pose given \[N\].
    pub buoyancy: f64,
    /// Centre of buoyancy in its frame \[m\].
    pub centre_of_buoyancy: V3,
    /// Stiffness of the water-plane about the origin, along the axes of the body \[N/m, N, N m\].
    pub waterplane: Matrix6<f64>,
    /// Added mass about the origin, along the axes of the body \[kg, kg m, kg m²\].
    pub added_mass: Matrix6<f64>,
    /// Centre of its added mass in its frame \[m\], where current and waves act on that and on the volume; nothing where they do not.
    pub centre_of_added_mass: Option<V3>,
    /// Damping about the origin, along the axes of the body \[N s/m, N s, N m s\], and the same by the squares of its velocities.
    pub damping: Matrix6<f64>,
    /// See `damping`.
    pub quadratic_damping: Matrix6<f64>,
    /// How it moves about its pose, where it is moved.
    pub motion: Option<PoseMotion>,
    /// Steady load and moment at the origin, in the earth's directions \[N, N m\].
    pub load: V3,
    /// See `load`.
    pub moment: V3,
    /// From the origin down to what bears on the bed \[m\].
    pub bottom: Option<f64>,
    /// Friction on the bed in motion \[-\], and the speed below which that is in proportion to the velocity \[m/s\].
    pub bed_friction: f64,
    /// See `bed_friction`.
    pub slip_speed: Option<f64>,
    /// What of it bears on the bed with an area, at points on it.
    pub feet: Vec<BodyFoot>,
    /// Its members in the water.
    pub members: Vec<Member>,
    /// Drag coefficient times area along its axes \[m²\].
    pub drag_area: V3,
    /// Where that acts in its frame \[m\], and the length along its z over which it is spread there \[m\].
    pub centre_of_drag: V3,
    /// See `centre_of_drag`.
    pub drag_length: f64,
    /// Loads of the wind by its heading.
    pub wind_loads: Option<HeadingLoads>,
    /// Loads of the current at the surface by its heading.
    pub current_loads: Option<HeadingLoads>,
    /// Mean drift of waves by their heading \[N, N m\], and the direction towards which they run.
    pub drift_loads: Option<(HeadingLoads, V3)>,
    /// How it begins a run in time.
    pub initial: BodyInitial,
    /// Coefficients of potential flow around it.
    pub potential_flow: Option<Arc<PotentialFlow>>,
    /// Axis of a rod in its frame, about which it spins freely and nothing hangs on.
    pub spins_about: Option<V3>,
}

impl Body {
    /// Where in its frame the waves are read that act on the body itself \[m\].
    #[must_use]
    pub fn station(&self) -> V3 {
        self.centre_of_added_mass.unwrap_or(self.centre_of_drag)
    }

    /// The strips that its drag acts on: their places in its frame \[m\] and their shares of it; one where it is not spread.
    pub fn drag_strips(&self) -> impl Iterator<Item = (V3, f64)> {
        let strips = drag_strips(0.5 * self.drag_length);
        strips.map(|(along, share)| (self.centre_of_drag + V3::z() * along, share))
    }

    /// How many strips have waves of their own: none where drag is not spread.
    #[must_use]
    pub fn strips_in_waves(&self) -> usize {
        match self.drag_length > 0.0 {
            true => self.drag_strips().count(),
            false => 0,
        }
    }

    /// Angle between the vertical and what is vertical at the pose given \[rad\].
    #[must_use]
    pub fn tilt(&self, pose: &Pose) -> f64 {
        let upright = self.pose.rotation.inverse() * V3::z();
        pose.arm(&upright).angle(&V3::z())
    }

    /// Whether its rotation is unknown.
    #[must_use]
    pub fn turns(&self) -> bool {
        self.free || self.pinned
    }

    /// The greatest arm of its centres and of its members from its origin \[m\].
    #[must_use]
    pub fn size(&self) -> f64 {
        let ends = self
            .members
            .iter()
            .flat_map(|member| [member.from, member.to]);
        let centres = [
            self.centre_of_gravity,
            self.centre_of_buoyancy,
            self.centre_of_drag,
        ];
        ends.chain(centres)
            .map(|arm| arm.norm())
            .fold(0.0, f64::max)
    }

    /// What holds the spin of a rod where it is \[N m\]: of the size of its other stiffness, without effect on any result.
    #[must_use]
    pub fn spin_stiffness(&self) -> f64 {
        let longest = self.members.iter().map(|m| (m.to - m.from).norm());
        (self.weight + self.buoyancy).max(1.0) * longest.fold(1.0, f64::max)
    }
}

/// A point on a body that bears on the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyFoot {
    /// Which point of the network.
    pub point: usize,
    /// Where it is in the frame of the body \[m\].
    pub at: V3,
    /// Its area and its friction.
    pub bears: FreePoint,
}

/// A round member of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Its ends in the frame of the body \[m\].
    pub from: V3,
    /// See `from`.
    pub to: V3,
    /// Radii there \[m\].
    pub radius: (f64, f64),
    /// Drag coefficient across it, on the diameter \[-\].
    pub drag: f64,
    /// Added mass coefficient across it, on the displaced volume \[-\].
    pub added_mass: f64,
    /// Drag coefficients of its ends along it, on their areas \[-\].
    pub drag_ends: [f64; 2],
    /// Added mass coefficients of its ends along it, on the half balls over them \[-\].
    pub added_mass_ends: [f64; 2],
    /// Whether it has drag alone, and displaces no water of its own.
    pub drag_only: bool,
}

impl Member {
    /// Its volume \[m³\]: of a cone from end to end.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let (a, b) = self.radius;
        let long = (self.to - self.from).norm();
        std::f64::consts::PI / 3.0 * long * (a * a + a * b + b * b)
    }
}

/// Loads of a flow by its heading.
#[derive(Debug, Clone, PartialEq)]
pub struct HeadingLoads {
    /// Headings towards which the flow runs, from the body's bow towards port, increasing \[rad\].
    pub headings: Vec<f64>,
    /// Surge and sway \[N s²/m²\] and yaw \[N s²/m\] over speed squared; of drift the loads themselves.
    pub loads: Vec<[f64; 3]>,
}

/// When an end of a line is let go in motion, whichever comes first.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ReleaseCondition {
    /// At this time \[s\].
    pub time: Option<f64>,
    /// Where the tension at the end comes to this \[N\].
    pub tension: Option<f64>,
}

impl ReleaseCondition {
    /// Whether it is ever let go.
    #[must_use]
    pub fn is_given(&self) -> bool {
        self.time.is_some() || self.tension.is_some()
    }
}

/// A section of a line as its file states it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StatedSection {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// Unstretched length \[m\].
    pub length_m: f64,
    /// Breaking load \[N\], where its material states one.
    pub break_load: Option<f64>,
}

/// A body hung on a line.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BodyOnLine {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// Unstretched arc length from A \[m\].
    pub arc_m: f64,
}

/// A line between two points.
#[derive(Debug, Clone, Default)]
pub struct Line {
    /// Its name.
    pub name: String,
    /// Point at end A.
    pub from: usize,
    /// Point at end B.
    pub to: usize,
    /// Sections from A to B.
    pub sections: Vec<SectionProperties>,
    /// The same from B to A: lines are solved from their lower end.
    pub reversed: Vec<SectionProperties>,
    /// The sections that its file states.
    pub parts: Vec<StatedSection>,
    /// The bodies on it.
    pub bodies: Vec<BodyOnLine>,
    /// Weight that weightless sections were given \[N\]: see [`weighted`].
    pub added_weight: f64,
    /// Axial friction under the line at rest \[-\], none by a law that holds nothing.
    pub friction: f64,
    /// Friction across it at rest \[-\].
    pub friction_lateral: f64,
    /// Directions in the frames of the bodies that its ends A and B are on, where these are clamped, from A to B; nothing elsewhere.
    pub clamps: [Option<V3>; 2],
    /// Whether current and waves leave it alone.
    pub still_water: bool,
    /// Whether the bed bears it.
    pub bed_contact: bool,
    /// When its ends are let go in motion, A first.
    pub releases: [ReleaseCondition; 2],
    /// How it begins a run in time, where that is not at rest.
    pub start: Option<Start>,
    /// The line divided into segments, where it has no closed form.
    pub discretised: Option<Arc<DiscretisedLine>>,
    /// Whether it has a closed form where the bed below it is flat and it does not float at the surface.
    pub closed_where_known: bool,
    /// Weight of the water that each section displaces per unstretched length, from A to B \[N/m\].
    pub displaced: Vec<f64>,
    /// The same from B to A.
    pub displaced_reversed: Vec<f64>,
}

impl Line {
    /// Unstretched length \[m\].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.sections.iter().map(|section| section.length_m).sum()
    }

    /// The places where its sections meet, from A: by the names of both, `chain|rope`, or by their number from 1 where they have none, as pieces of
    /// one section.
    pub fn meetings(&self) -> impl Iterator<Item = String> {
        let pairs = self.parts.windows(2).enumerate();
        pairs.map(|(before, pair)| match (&pair[0].name, &pair[1].name) {
            (Some(one), Some(other)) if one != other => format!("{one}|{other}"),
            _ => (before + 1).to_string(),
        })
    }

    /// Its sections by their names, or by number from 1 where they have none, each with its first and its last part.
    #[must_use]
    pub fn named_sections(&self) -> Vec<(String, [usize; 2])> {
        let mut found: Vec<(String, [usize; 2])> = Vec::new();
        for (number, part) in self.parts.iter().enumerate() {
            let name = part.name.clone();
            let name = name.unwrap_or_else(|| (number + 1).to_string());
            match found.last_mut().filter(|(before, _)| *before == name) {
                Some((_, [_, last])) => *last = number,
                None => found.push((name, [number; 2])),
            }
        }
        found
    }

    /// Whether it begins a run in time in a shape of its own, which needs no equilibrium between its ends.
    #[must_use]
    pub fn begins_in_shape(&self) -> bool {
        let start = self.start.as_ref();
        start.is_some_and(|start| start.shape != StartShape::Equilibrium)
    }

    /// Whether the bed has friction under it, along or across.
    #[must_use]
    pub fn is_rough(&self) -> bool {
        self.friction > 0.0 || self.friction_lateral > 0.0
    }

    /// Whether all of it sinks.
    #[must_use]
    pub fn sinks(&self) -> bool {
        let sinks = |s: &SectionProperties| s.weight_n_per_m >= 0.0 && s.clump_n >= 0.0;
        self.sections.iter().all(sinks)
    }

    /// Whether all of it floats.
    #[must_use]
    pub fn is_buoyant(&self) -> bool {
        let floats = |s: &SectionProperties| s.weight_n_per_m < 0.0 && s.clump_n <= 0.0;
        self.sections.iter().all(floats)
    }
}

/// Weight per length that a weightless section counts with beside others, by the weight of its line.
pub const WEIGHTLESS: f64 = 1e-9;

/// Sections of a line that are solved together: without weight a slack section has no shape, so that beside others it
/// has at least this share of their weight per length.
#[must_use]
pub fn weighted(mut sections: Vec<SectionProperties>, share: f64) -> Vec<SectionProperties> {
    let weights = sections
        .iter()
        .map(|section| section.weight_n_per_m.abs() + section.clump_n.abs() / section.length_m);
    let least = share * weights.fold(0.0, f64::max);
    if sections.len() > 1 {
        for section in &mut sections {
            if section.weight_n_per_m.abs() < least {
                section.weight_n_per_m = least;
            }
        }
    }
    sections
}

/// Weight in water of sections and of the bodies between them \[N\].
#[must_use]
pub fn weight(sections: &[SectionProperties]) -> f64 {
    let each =
        |section: &SectionProperties| section.weight_n_per_m * section.length_m + section.clump_n;
    sections.iter().map(each).sum()
}

/// Sections in the other order: bodies between them stay where they are.
#[must_use]
pub fn reversed(sections: &[SectionProperties]) -> Vec<SectionProperties> {
    let n = sections.len();
    (0..n)
        .map(|k| SectionProperties {
            clump_n: if k + 1 < n {
                sections[n - 2 - k].clump_n
            } else {
                0.0
            },
            ..sections[n - 1 - k]
        })
        .collect()
}

impl Network {
    /// The point of this name.
    #[must_use]
    pub fn point(&self, name: &str) -> Option<usize> {
        self.points.iter().position(|point| point.name == name)
    }

    /// The line of this name.
    #[must_use]
    pub fn line(&self, name: &str) -> Option<usize> {
        self.lines.iter().position(|line| line.name == name)
    }

    /// Whether a current, a wind or the drift of waves acts on points or bodies.
    #[must_use]
    pub fn flows(&self) -> bool {
        let current = self.current.as_ref();
        current.is_some_and(|current| current.max_speed() > 0.0)
            || self.wind != V3::zeros()
            || self.bodies.iter().any(|body| body.drift_loads.is_some())
    }

    /// The free points.
    pub fn free_points(&self) -> impl Iterator<Item = &FreePoint> {
        self.points.iter().filter_map(|point| match &point.held {
            Held::Free(free) => Some(free),
            Held::At(_) | Held::On(..) => None,
        })
    }

    /// Whether a point is free and sinks into the bed, over an area.
    #[must_use]
    pub fn sinks_into_bed(&self, point: usize) -> bool {
        matches!(&self.points[point].held, Held::Free(free) if free.bearing.is_some())
    }

    /// The initial conditions of the bodies that are free or pinned, by their numbers.
    pub fn initial_of_bodies(&self) -> impl Iterator<Item = (usize, &BodyInitial)> {
        let bodies = self.bodies.iter().enumerate();
        let unknown = bodies.filter(|(_, body)| body.turns());
        unknown.map(|(number, body)| (number, &body.initial))
    }

    /// Whether anything begins a run in time off its equilibrium.
    #[must_use]
    pub fn begins_off_rest(&self) -> bool {
        let mut bodies = self.initial_of_bodies();
        bodies.any(|(_, initial)| initial.is_off_rest())
            || self.free_points().any(|point| point.initial.is_off_rest())
    }

    /// Whether any line bends.
    #[must_use]
    pub fn bends(&self) -> bool {
        let mut divided = self
            .lines
            .iter()
            .filter_map(|line| line.discretised.as_ref());
        divided.any(|line| line.bends())
    }

    /// The same system with so many times the segments in every divided line.
    ///
    /// # Errors
    /// The name of a line that has no element, and why.
    pub fn refined(&self, by: usize) -> Result<Self, (String, String)> {
        let mut network = self.clone();
        for line in &mut network.lines {
            if let Some(coarse) = &line.discretised {
                let fine = coarse.refined(by);
                let fine = fine.map_err(|why| (line.name.clone(), why))?;
                line.discretised = Some(Arc::new(fine));
            }
        }
        Ok(network)
    }

    /// The body of this name.
    #[must_use]
    pub fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }
}
