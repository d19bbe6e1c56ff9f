//! The discretised line: its parts, and where they are.

use crate::numerics::V3;
use crate::numerics::lanes::Two;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::{Drag, DragProperties};
use crate::physics::rope::TensionLaw;
use crate::physics::tension::{Axial, Chord};
use crate::physics::{Body, Current, EndMotion, Grip, Seabed};

use super::submergence::Submergence;
use super::{Event, Flexure, RigidPayload, Traveller, Water};
use crate::solve::{Kinematics, State};

/// A segment between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Axial constants.
    pub axial: Axial,
    /// Drag per length.
    pub drag: DragProperties,
    /// Added mass of half the segment.
    pub added: AddedMass,
    /// Mass of half the segment \[kg\].
    pub half_mass: f64,
    /// Weight in water of half the segment \[N\], positive down.
    pub half_weight: f64,
    /// Bending stiffness EI \[N m²\].
    pub ei: f64,
    /// Hydrodynamic diameter \[m\].
    pub diameter: f64,
}

/// One end of the line.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// Prescribed.
    Prescribed(EndMotion),
    /// Moves by its equation of motion.
    Free,
}

/// A body and the node it hangs on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AttachedBody {
    /// The node.
    pub node: usize,
    /// The body; its mass and weight are those of the node already.
    pub body: Body,
}

/// A named place where the tension is reported.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Joint {
    /// As in channel names: `chain|polyester`.
    pub name: String,
    /// Its node.
    pub node: usize,
}

/// A line ready to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Segments from A to B, then the rod of a payload that turns; node i lies before segment i.
    pub segments: Vec<Segment>,
    /// How tension follows from strain where a material does not have it in proportion; see [`Axial::law`].
    pub laws: Vec<TensionLaw>,
    /// Masses of the nodes without added mass, bodies included \[kg\].
    pub mass: Vec<f64>,
    /// Weights of the nodes in water, bodies included \[N\], positive down.
    pub weight: Vec<f64>,
    /// Names of the ends A and B.
    pub end_names: [String; 2],
    /// What holds the ends A and B.
    pub ends: [End; 2],
    /// Bodies on the line that are points, by their nodes, the payload last.
    pub bodies: Vec<AttachedBody>,
    /// A payload that turns about the last node of the line.
    pub rigid_payload: Option<RigidPayload>,
    /// Nodes of the clumps, in the order of the case.
    pub clumps: Vec<usize>,
    /// A body that travels along the line, if there is one.
    pub traveller: Option<Traveller>,
    /// Bending, where any material has a bending stiffness.
    pub flexure: Option<Flexure>,
    /// The sea bed, if there is one.
    pub bed: Option<Seabed>,
    /// Area of line that each node rests on the bed with \[m²\].
    pub footprint: Vec<f64>,
    /// The current.
    pub current: Current,
    /// Waves and the surface of the water, where the case names them.
    pub water: Option<Water>,
    /// Where tension is reported, from A to B.
    pub joints: Vec<Joint>,
    /// Unstretched arc length of the nodes from A \[m\].
    pub arc: Vec<f64>,
    /// Positions at time zero, or a first guess where the start is an equilibrium \[m\].
    pub start: Vec<V3>,
    /// What the user should know of how the case was made into this line.
    pub remarks: Vec<String>,
    /// Tensions of the segments that go with the start \[N\].
    pub start_tension: Vec<f64>,
    /// Where the bed has hold of the nodes at the start; none where it has no hold.
    pub start_grips: Vec<Grip>,
    /// Velocity at time zero of what is not held \[m/s\].
    pub start_velocity: V3,
    /// What happens to the line, the earliest first.
    pub events: Vec<Event>,
    /// Whether the line starts in equilibrium.
    pub start_in_equilibrium: bool,
    /// A force typical of this line \[N\]: its whole weight, or what its drag can be.
    pub force_scale: f64,
}

impl Scene {
    /// The state at time zero, ends where their motion has them.
    #[must_use]
    pub fn initial_state(&self) -> State {
        let mut state = State::at_rest(self.start.clone());
        state.memory.grips.clone_from(&self.start_grips);
        self.prescribe(0.0, &mut state);
        state
    }

    /// The chord of segment i.
    #[inline(always)]
    #[must_use]
    pub fn chord(&self, i: usize, state: &State) -> Chord {
        Chord::new(
            (&state.x[i], &state.x[i + 1]),
            (&state.v[i], &state.v[i + 1]),
            self.segments[i].axial.length,
        )
    }

    /// Stretched length that the water sees \[m\], and 1 / chord length where it grows with the chord.
    #[inline(always)]
    pub(super) fn wetted_length(&self, i: usize, chord: &Chord) -> (f64, f64) {
        let unstretched = self.segments[i].axial.length;
        if chord.length > unstretched {
            (chord.length, chord.inverse)
        } else {
            (unstretched, 0.0)
        }
    }

    /// Drag on both halves of segment i.
    #[inline(always)]
    pub(super) fn drag(&self, i: usize, chord: &Chord, state: &State) -> Drag<Two> {
        self.submerged_drag(i, chord, state, self.wet(i, state).as_ref())
    }

    /// The same where it is known how much of both halves is wet.
    #[inline(always)]
    pub(super) fn submerged_drag(
        &self,
        i: usize,
        chord: &Chord,
        state: &State,
        wet: Option<&[Submergence; 2]>,
    ) -> Drag<Two> {
        let full = self.full_drag(i, chord, state);
        match wet {
            None => full,
            Some([first, second]) => full.scaled(Two::new([first.share, second.share])),
        }
    }

    /// Drag on both halves of segment i as if all of it were under water.
    #[inline(always)]
    pub(super) fn full_drag(&self, i: usize, chord: &Chord, state: &State) -> Drag<Two> {
        let u = self.relative_velocities(i, state);
        let length = self.wetted_length(i, chord).0;
        self.segments[i].drag.drag(
            &chord.tangent,
            [&u[0], &u[1]],
            0.5 * length,
            state.memory.drag_coefficients.get(i),
        )
    }

    /// Velocities of the water relative to both nodes of segment i \[m/s\].
    #[inline(always)]
    pub(super) fn relative_velocities(&self, i: usize, state: &State) -> [V3; 2] {
        [
            self.water_at(i, state) - state.v[i],
            self.water_at(i + 1, state) - state.v[i + 1],
        ]
    }
}

impl Scene {
    /// The same line without drag, in still water without waves or surface.
    #[must_use]
    pub fn without_drag(&self) -> Self {
        let mut bare = self.clone();
        bare.current = Current::Uniform(V3::zeros());
        bare.water = None;
        for segment in &mut bare.segments {
            let drag = &mut segment.drag;
            (drag.normal, drag.tangential, drag.floats) = (0.0, 0.0, 0.0);
        }
        for hung in &mut bare.bodies {
            hung.body.drag = V3::zeros();
        }
        bare
    }

    /// Greatest stiffness of a segment along itself, or of the bed's hold on a node \[N/m\].
    pub(super) fn stiffest(&self) -> f64 {
        let segments = self.segments.iter().map(|s| s.axial.ea / s.axial.length);
        let grips = self.start_grips.iter().map(|grip| grip.stiffness);
        segments.chain(grips).fold(0.0, f64::max)
    }

    /// What the drag of the line could be in the fastest current there is, all of it across that or along \[N\].
    pub(super) fn greatest_drag(&self) -> f64 {
        let speed = self.current.max_speed();
        let per_square = |s: &Segment| s.axial.length * s.drag.greatest(speed);
        speed * speed * self.segments.iter().map(per_square).sum::<f64>()
    }

    /// Positions carry no more digits than this \[m\].
    pub(super) fn rounding(&self) -> f64 {
        8.0 * f64::EPSILON * self.start.iter().map(V3::amax).fold(1.0, f64::max)
    }
}
