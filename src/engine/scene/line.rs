//! The lumped-mass line: segments, nodes and point bodies.

use std::ops::Range;

use crate::numerics::V3;
use crate::numerics::lanes::Two;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::{Drag, DragProperties};
use crate::physics::rope::TensionLaw;
use crate::physics::tension::{AxialConstants, Chord};
use crate::physics::{BodyProperties, CurrentProfile, EndMotion};

use super::Water;
use super::submergence::Submergence;
use crate::solve::State;

/// A segment between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Axial constants.
    pub axial: AxialConstants,
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
    /// Width that bears on the sea bed \[m\]: the diameter, or that of buoyancy modules by their share of the length.
    pub bearing_width: f64,
}

/// Condition at an end of the line.
#[derive(Debug, Clone, PartialEq)]
pub enum EndCondition {
    /// Prescribed.
    Prescribed(EndMotion),
    /// Follows the equation of motion.
    Free,
}

/// A point body and its node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AttachedBody {
    /// The node.
    pub node: usize,
    /// The body; its mass and weight are included in those of the node.
    pub body: BodyProperties,
}

/// The lumped-mass line: n segments between n + 1 nodes, with point bodies on the nodes, in its water.
#[derive(Debug, Clone, PartialEq)]
pub struct LumpedLine {
    /// Segments from A to B, then the rod of a payload that rotates; node i is at the start of segment i.
    pub segments: Vec<Segment>,
    /// Number of nodes of the line itself, without the far node of a payload that rotates.
    pub line_nodes: usize,
    /// Tension-strain laws of materials without a constant EA; see [`AxialConstants::law`].
    pub laws: Vec<TensionLaw>,
    /// Masses of the nodes, bodies included, without added mass \[kg\].
    pub mass: Vec<f64>,
    /// Submerged weights of the nodes, bodies included \[N\], positive down.
    pub weight: Vec<f64>,
    /// Unstretched arc length of the nodes from A \[m\].
    pub arc: Vec<f64>,
    /// Conditions at the ends A and B.
    pub ends: [EndCondition; 2],
    /// Point bodies on the line, by their nodes, the payload last.
    pub bodies: Vec<AttachedBody>,
    /// The current.
    pub current: CurrentProfile,
    /// Waves and the water surface, where the case names them.
    pub water: Option<Water>,
    /// Whether drag acts on the stretched length of a taut line.
    pub stretched_drag: bool,
    /// A force typical of this line \[N\]: its whole weight, or the greatest drag.
    pub force_scale: f64,
}

impl LumpedLine {
    /// Number of nodes, both ends counted.
    pub(super) fn nodes(&self) -> usize {
        self.mass.len()
    }

    /// The nodes that are not prescribed.
    pub(super) fn free(&self) -> Range<usize> {
        let held = |end: usize| usize::from(matches!(self.ends[end], EndCondition::Prescribed(_)));
        held(0)..self.nodes() - held(1)
    }

    /// The chord of segment i. What opens it is its material: where more of it is paid out, its nodes part without stretching it.
    #[inline(always)]
    #[must_use]
    pub fn chord(&self, i: usize, state: &State) -> Chord {
        let axial = &self.segments[i].axial;
        let mut chord = Chord::new(
            (&state.x[i], &state.x[i + 1]),
            (&state.v[i], &state.v[i + 1]),
            axial.length,
        );
        if axial.growth != 0.0 {
            chord.opening -= chord.tangent * (chord.length * axial.growth);
        }
        chord
    }

    /// Length for drag \[m\], stretched if taut unless the case says otherwise, and 1 / chord length if it grows with the chord, else 0.
    #[inline(always)]
    pub(super) fn wetted_length(&self, i: usize, chord: &Chord) -> (f64, f64) {
        let unstretched = self.segments[i].axial.length;
        if chord.length > unstretched && self.stretched_drag {
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

    /// Drag on the whole of segment i \[N\].
    #[must_use]
    pub fn drag_on(&self, i: usize, chord: &Chord, state: &State) -> V3 {
        let [first, second] = self.drag(i, chord, state).forces();
        first + second
    }

    /// The same with known submerged fractions.
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

    /// Drag on both halves of segment i as if all of it were submerged.
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

    /// Greatest drag of the line in the fastest current, all of it normal or tangential \[N\].
    pub(super) fn greatest_drag(&self) -> f64 {
        let speed = self.current.max_speed();
        let per_square = |s: &Segment| s.axial.length * s.drag.greatest(speed);
        speed * speed * self.segments.iter().map(per_square).sum::<f64>()
    }
}
