//! The equation of motion of a scene, by the traits of the solvers.

use std::ops::Range;

use super::element::Element;
use super::elements::{BedContact, BodyContact};
use super::{EndCondition, Scene};
use crate::numerics::{BlockBand, V3};
use crate::solve::{
    ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Residual, State, StaticSearch,
};

impl Kinematics for Scene {
    fn nodes(&self) -> usize {
        self.line.nodes()
    }

    fn free(&self) -> Range<usize> {
        self.line.free()
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        let last = self.nodes() - 1;
        for (end, node) in [(0, 0), (1, last)] {
            if let EndCondition::Prescribed(motion) = &self.line.ends[end] {
                let piece = state.memory.motion_pieces[end];
                (state.x[node], state.v[node], state.a[node]) = motion.on_piece(piece, t);
            }
        }
    }

    fn next_kink(&self, state: &State) -> f64 {
        let kinks = self.end_kinks(state);
        kinks[0].min(kinks[1]).min(self.traveller_kink(state))
    }

    fn pass_kink(&self, t: f64, state: &mut State) -> bool {
        let next = self.next_kink(state);
        let mut jumps = false;
        for (end, kink) in self.end_kinks(state).into_iter().enumerate() {
            if let EndCondition::Prescribed(motion) = &self.line.ends[end]
                && kink == next
            {
                let piece = &mut state.memory.motion_pieces[end];
                jumps |= motion.velocity_jumps(*piece);
                *piece += 1;
            }
        }
        if self.traveller_kink(state) == next {
            state.memory.traveller_kinks += 1;
            jumps = true;
        }
        self.prescribe(t, state);
        jumps
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut State) {
        self.write_wave_kinematics(t, None, state);
    }

    fn extrapolate_wave_kinematics(&self, t: f64, time: f64, before: &State, state: &mut State) {
        self.write_wave_kinematics(t, Some((time, before)), state);
    }
}

impl Scene {
    /// Time of the next kink of the motion of a traveller \[s\]; infinite where there is none.
    fn traveller_kink(&self, state: &State) -> f64 {
        let traveller = self.elements.traveller.as_ref();
        traveller.map_or(f64::INFINITY, |traveller| {
            traveller.next_kink(state.memory.traveller_kinks)
        })
    }

    /// Time of the next kink of the motion of end A and of end B \[s\]; infinite where there is none.
    fn end_kinks(&self, state: &State) -> [f64; 2] {
        [0, 1].map(|end| match &self.line.ends[end] {
            EndCondition::Prescribed(motion) => motion.next_kink(state.memory.motion_pieces[end]),
            EndCondition::Free => f64::INFINITY,
        })
    }
}

impl Residual for Scene {
    fn is_pentadiagonal(&self) -> bool {
        self.elements.iter().any(Element::is_pentadiagonal)
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.line.segment_residual(t, state, r);
        for element in self.elements.iter() {
            element.add_residual(self.at(t, state), r);
        }
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.line.segment_tangent(t, state, c, r, tangent);
        if self.elements.flexure.is_none() {
            tangent.clear_far();
        }
        for element in self.elements.iter() {
            element.linearise(self.at(t, state), c, r, tangent);
        }
    }

    fn extrapolate_tensions(&self, d: &[V3], state: &mut State) {
        self.line.extrapolate_segment_tensions(d, state);
    }

    fn passes_kink(&self, d: &[V3], state: &State) -> bool {
        self.line.turns_taut_or_slack(d, [0.0; 2], state)
    }

    fn force_norm_displacement(&self, d: &[V3], state: &State) -> f64 {
        let stiffest = self.stiffest();
        let by_segments = self.line.force_in_segments(d, state) / stiffest;
        let at = self.at(state.memory.time, state);
        let by_elements = self.elements.iter();
        by_elements
            .map(|e| e.equivalent_displacement(at, d, stiffest))
            .fold(by_segments, f64::max)
    }
}

impl ExplicitRhs for Scene {
    fn accelerate(&self, t: f64, state: &mut State) {
        self.accelerations(t, state);
        self.accelerate_rigid_payload(state);
        self.accelerate_traveller(t, state);
        self.line.write_creep_rates(t, state);
    }

    fn fastest_decay(&self, state: &State) -> (f64, usize) {
        self.fastest_drag_decay(self.line.free(), state)
    }
}

impl Hysteresis for Scene {
    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        for element in self.elements.iter() {
            element.commit(&self.line, state);
        }
        self.line.remember_ropes(t, dt, state);
    }

    fn freeze_drag_coefficients(&self, state: &mut State) {
        let line = &self.line;
        let segments = line.segments.len();
        state.memory.drag_coefficients.resize(segments, [0.0; 2]);
        for i in 0..segments {
            let u = line.relative_velocities(i, state);
            let tangent = line.chord(i, state).tangent;
            state.memory.drag_coefficients[i] = line.segments[i]
                .drag
                .normal_coefficients(&tangent, [&u[0], &u[1]]);
        }
    }
}

impl MidstepBalance for Scene {
    fn correct_chord_lengths(&self, fraction: f64, before: &State, end: &mut State) {
        self.line
            .chord_corrections(fraction, (&self.line, before), end);
    }

    fn snap_acceleration(&self, between: &State, end: &State) -> f64 {
        self.line.acceleration_by_snaps((&self.line, between), end)
    }
}

impl StaticSearch for Scene {
    fn force_scale(&self) -> f64 {
        self.line.force_scale
    }

    fn rounding_force(&self) -> f64 {
        self.stiffest() * self.rounding()
    }

    fn position_tolerance(&self, relative: f64) -> f64 {
        (relative * self.line.force_scale / self.stiffest()).max(self.rounding())
    }

    fn initialise_tensions(&self, state: &mut State) {
        self.line
            .initial_segment_tensions(&self.start.tension, state);
    }

    fn share_stiffness(&self, state: &mut State) -> f64 {
        self.line.share_stiffness_at_rest(state)
    }

    fn kinked_node(&self, state: &State) -> Option<usize> {
        let flexure = self.elements.flexure.as_ref()?;
        flexure.kinked_node(&self.line, state)
    }

    fn with_clamps(&self, start: &State, fraction: f64) -> Option<Self> {
        let flexure = self.elements.flexure.as_ref()?;
        let flexure = flexure.with_clamps(&self.line, start, fraction)?;
        let mut scene = self.clone();
        scene.elements.flexure = Some(flexure);
        Some(scene)
    }

    fn without_friction(&self) -> Option<Self> {
        let bed = self.elements.bed.as_ref()?;
        bed.seabed.friction?;
        let mut smooth = bed.clone();
        smooth.seabed.friction = None;
        let mut scene = self.clone();
        scene.elements.bed = Some(smooth);
        let bodies = self.elements.body_contact.as_ref();
        scene.elements.body_contact = bodies.map(BodyContact::without_friction);
        scene.start.grips.clear();
        Some(scene)
    }

    fn sliding_node(&self, state: &State) -> Option<usize> {
        self.elements.bed.as_ref()?.sliding_node(self.free(), state)
    }

    fn flows_over_rough_bed(&self) -> bool {
        let holds = self.start.grips.iter().any(|grip| grip.stiffness > 0.0);
        holds && self.line.current.max_speed() > 0.0
    }

    fn with_secant_friction(&self) -> Option<Self> {
        let bed = self.elements.bed.as_ref()?;
        bed.seabed.friction?;
        let mut scene = self.clone();
        scene.elements.bed = Some(BedContact {
            secant: true,
            ..bed.clone()
        });
        Some(scene)
    }

    fn slides_slack(&self, state: &State) -> bool {
        let Some(bed) = self.elements.bed.as_ref() else {
            return false;
        };
        let friction = bed.seabed.friction.map_or(0.0, |friction| friction.axial);
        self.sliding_node(state).is_some_and(|node| {
            let normal = bed.seabed.normal(&state.x[node]);
            let steep = (1.0 - normal.z * normal.z).max(0.0).sqrt() > friction * normal.z;
            let beside = [
                node.saturating_sub(1),
                node.min(self.line.segments.len() - 1),
            ];
            steep && beside.iter().any(|i| self.is_slack(*i, state))
        })
    }

    fn pulls_on_bed(&self, state: &State) -> bool {
        let Some(bed) = self.elements.bed.as_ref() else {
            return false;
        };
        let mut lying = self.free().filter(|i| bed.push(*i, state).force > 0.0);
        lying.any(|node| !self.is_slack(node.min(self.line.segments.len() - 1), state))
    }

    fn reset_friction(&self, state: &mut State) {
        state.memory.grips = self.grips_at(&state.x);
    }
}
