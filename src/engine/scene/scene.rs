//! A case ready to compute.

use super::element::At;
use super::elements::Elements;
use super::{LaidFrom, LumpedLine, SceneEvent, labels::Labels};
use crate::numerics::V3;
use crate::physics::{CurrentProfile, ElasticBed, FrictionAnchor, PipeWall};
use crate::solve::{Kinematics, State};

/// A case ready to compute, in SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The line: nodes, segments, point bodies, and the water around them.
    pub line: LumpedLine,
    /// Pipe walls of the sections from A to B; none of those without a bore.
    pub walls: Vec<Option<PipeWall>>,
    /// The other forces on it.
    pub elements: Elements,
    /// Its state at time zero.
    pub start: InitialState,
    /// Names for the outputs.
    pub labels: Labels,
    /// Events, the earliest first.
    pub events: Vec<SceneEvent>,
}

/// The state of the line at time zero, or the initial guess at its equilibrium.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct InitialState {
    /// Positions of the nodes \[m\].
    pub positions: Vec<V3>,
    /// Tensions of the segments \[N\].
    pub tension: Vec<f64>,
    /// Friction springs of the bed; empty without.
    pub grips: Vec<FrictionAnchor>,
    /// Where it was laid from, if it lies on the bed from end to end.
    pub laid_from: LaidFrom,
    /// Velocity of all free nodes \[m/s\].
    pub velocity: V3,
    /// Whether the line starts in equilibrium.
    pub in_equilibrium: bool,
}

/// Share of the slip speed to which velocities are resolved, and with them friction to the same share of its greatest.
const SHARE_OF_SLIP: f64 = 1e-3;

impl Scene {
    /// The state at time zero, with prescribed ends at their motion.
    #[must_use]
    pub fn initial_state(&self) -> State {
        let mut state = State::at_rest(self.start.positions.clone());
        state.memory.grips.clone_from(&self.start.grips);
        self.prescribe(0.0, &mut state);
        let bodies = self.elements.body_contact.as_ref();
        state.memory.bodies =
            bodies.map_or_else(Vec::new, |bodies| bodies.history_at_start(&state));
        state
    }

    /// The state of a line that begins in this shape, node by node \[m\], at rest for an instant and with the friction of the bed unloaded.
    #[must_use]
    pub fn state_in_shape(&self, nodes: Vec<V3>) -> State {
        let mut state = State::at_rest(nodes);
        state.memory.grips = self.grips_at(&state.x);
        state
    }

    /// Sets the start velocity of a line at rest; prescribed ends keep theirs.
    pub fn apply_start_velocity(&self, state: &mut State) {
        if self.start.velocity != V3::zeros() {
            state.v.fill(self.start.velocity);
            self.prescribe(0.0, state);
        }
    }

    /// Where elements are evaluated.
    pub(super) fn at<'a>(&'a self, t: f64, state: &'a State) -> At<'a> {
        let line = &self.line;
        At { line, t, state }
    }

    /// The scene without drag, in still water without waves or surface.
    #[must_use]
    pub fn without_drag(&self) -> Self {
        let mut bare = self.clone();
        let line = &mut bare.line;
        line.current = CurrentProfile::Uniform(V3::zeros());
        line.water = None;
        for segment in &mut line.segments {
            let drag = &mut segment.drag;
            (drag.normal, drag.tangential) = (0.0, 0.0);
            (drag.floats, drag.floats_tangential) = (0.0, 0.0);
        }
        for hung in &mut line.bodies {
            hung.body.drag = V3::zeros();
        }
        bare.elements.clump_drag = None;
        bare
    }

    /// The sea bed.
    pub(super) fn seabed(&self) -> Option<&ElasticBed> {
        self.elements.bed.as_ref().map(|bed| &bed.seabed)
    }

    /// What a step aside from a place leads too far into the bed \[m\]: beyond its surface, or beyond the place where that is in it.
    #[must_use]
    pub fn lift_to_bed(&self, place: &V3, aside: &V3) -> V3 {
        self.seabed().map_or_else(V3::zeros, |bed| {
            let least = bed.height(place).min(0.0);
            bed.way_out(place) * (least - bed.height(&(place + aside))).max(0.0)
        })
    }

    /// Contact area of node i with the bed \[m²\].
    pub(super) fn footprint(&self, i: usize) -> f64 {
        self.elements
            .bed
            .as_ref()
            .map_or(0.0, |bed| bed.footprint[i])
    }

    /// The same with the bodies at the node \[m²\].
    pub(super) fn bearing_area(&self, i: usize) -> f64 {
        let bodies = self.elements.body_contact.as_ref();
        let bodies = bodies.map_or(&[][..], |contact| &contact.bodies);
        let here = bodies.iter().filter(|body| body.node == i);
        self.footprint(i) + here.map(|body| body.area).sum::<f64>()
    }

    /// Friction springs of the bed at these positions, without force; none without them.
    #[must_use]
    pub fn grips_at(&self, nodes: &[V3]) -> Vec<FrictionAnchor> {
        let bed = self.elements.bed.as_ref();
        bed.map_or_else(Vec::new, |bed| bed.grips_at(nodes))
    }

    /// Speed to which velocities are resolved \[m/s\], where friction of the bed depends on them.
    #[must_use]
    pub fn velocity_resolution(&self) -> Option<f64> {
        let slip = self.elements.bed.as_ref()?.slip_speed()?;
        Some(SHARE_OF_SLIP * slip)
    }

    /// Greatest stiffness of a segment along itself, or of a friction spring \[N/m\].
    pub(super) fn stiffest(&self) -> f64 {
        let segments = self
            .line
            .segments
            .iter()
            .map(|s| s.axial.ea / s.axial.length);
        let grips = self.start.grips.iter().map(|grip| grip.stiffness);
        segments.chain(grips).fold(0.0, f64::max)
    }

    /// Rounding error of positions \[m\].
    pub(super) fn rounding(&self) -> f64 {
        let places = self.start.positions.iter().map(V3::amax);
        8.0 * f64::EPSILON * places.fold(1.0, f64::max)
    }
}
