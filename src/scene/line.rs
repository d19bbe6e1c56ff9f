//! The discretised line: its parts, and where they are.

use crate::linalg::{BlockBand, V3};
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::{Drag, Profile};
use crate::physics::tension::{Axial, Chord};
use crate::physics::{Body, Current, EndMotion, Seabed};

use super::Flexure;
use crate::solve::{Factors, State, System};

/// A segment between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Axial constants.
    pub axial: Axial,
    /// Drag per length.
    pub drag: Profile,
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// Prescribed.
    Held(EndMotion),
    /// Moves by its equation of motion.
    Free,
}

/// A body and the node it hangs on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hung {
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
    /// Segments from A to B; node i lies before segment i.
    pub segments: Vec<Segment>,
    /// Masses of the nodes without added mass, bodies included \[kg\].
    pub mass: Vec<f64>,
    /// Weights of the nodes in water, bodies included \[N\], positive down.
    pub weight: Vec<f64>,
    /// Names of the ends A and B.
    pub end_names: [String; 2],
    /// What holds the ends A and B.
    pub ends: [End; 2],
    /// Bodies on the line, by their nodes, the payload last.
    pub bodies: Vec<Hung>,
    /// Nodes of the clumps, in the order of the case.
    pub clumps: Vec<usize>,
    /// Bending, where any material has a bending stiffness.
    pub flexure: Option<Flexure>,
    /// The sea bed, if there is one.
    pub bed: Option<Seabed>,
    /// Area of line that each node rests on the bed with \[m²\].
    pub footprint: Vec<f64>,
    /// The current.
    pub current: Current,
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
    pub(super) fn wetted(&self, i: usize, chord: &Chord) -> (f64, f64) {
        let unstretched = self.segments[i].axial.length;
        if chord.length > unstretched {
            (chord.length, chord.inverse)
        } else {
            (unstretched, 0.0)
        }
    }

    /// Shear of the current at both nodes of segment i \[1/s\]; nothing where the current is uniform.
    #[inline(always)]
    pub(super) fn shear(&self, i: usize, state: &State) -> Option<[V3; 2]> {
        match &self.current {
            Current::Uniform(_) => None,
            Current::Table { .. } => {
                Some([i, i + 1].map(|node| self.current.at(state.x[node].z).1))
            }
        }
    }

    /// Drag on both halves of segment i.
    #[inline(always)]
    pub(super) fn drag(&self, i: usize, chord: &Chord, state: &State) -> [Drag; 2] {
        let u = self.relative_velocities(i, state);
        let length = self.wetted(i, chord).0;
        self.segments[i].drag.drag(
            &chord.tangent,
            [&u[0], &u[1]],
            0.5 * length,
            state.memory.get(i),
        )
    }

    /// Velocities of the water relative to both nodes of segment i \[m/s\].
    #[inline(always)]
    pub(super) fn relative_velocities(&self, i: usize, state: &State) -> [V3; 2] {
        [
            self.current.at(state.x[i].z).0 - state.v[i],
            self.current.at(state.x[i + 1].z).0 - state.v[i + 1],
        ]
    }

    /// Takes the push of the bed from the residual.
    pub(super) fn add_bed(&self, state: &State, r: &mut [V3]) {
        if let Some(bed) = &self.bed {
            for (i, out) in r.iter_mut().enumerate() {
                out.z -= bed
                    .push(state.x[i].z, state.v[i].z, self.footprint[i])
                    .force;
            }
        }
    }

    /// Takes the derivatives of that push from the tangent.
    pub(super) fn add_bed_tangent(&self, state: &State, c: Factors, tangent: &mut BlockBand) {
        if let Some(bed) = &self.bed {
            for (i, block) in tangent.diag.iter_mut().enumerate() {
                let push = bed.push(state.x[i].z, state.v[i].z, self.footprint[i]);
                block[(2, 2)] -= c.stiffness * push.by_z + c.damping * push.by_speed;
            }
        }
    }
}

impl Scene {
    /// Greatest axial stiffness of a segment \[N/m\].
    pub(super) fn stiffest(&self) -> f64 {
        self.segments
            .iter()
            .map(|s| s.axial.ea / s.axial.length)
            .fold(0.0, f64::max)
    }

    /// Positions carry no more digits than this \[m\].
    pub(super) fn rounding(&self) -> f64 {
        8.0 * f64::EPSILON * self.start.iter().map(V3::amax).fold(1.0, f64::max)
    }
}
