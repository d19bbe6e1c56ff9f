//! The line's equation of motion, as the solvers see it: residual, tangent, explicit accelerations.

use std::ops::Range;

use super::water::BodyInWater;
use super::{AttachedBody, End, Scene};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::seabed::Seabed;
use crate::solve::{
    ExplicitRhs, Factors, Hysteresis, Kinematics, MidstepBalance, Residual, State, StaticSearch,
};

impl Kinematics for Scene {
    fn nodes(&self) -> usize {
        self.mass.len()
    }

    fn free(&self) -> Range<usize> {
        let held = |end: usize| usize::from(matches!(self.ends[end], End::Prescribed(_)));
        held(0)..self.nodes() - held(1)
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        let last = self.nodes() - 1;
        for (end, node) in [(0, 0), (1, last)] {
            if let End::Prescribed(motion) = &self.ends[end] {
                (state.x[node], state.v[node], state.a[node]) = motion.at(t);
            }
        }
    }

    fn update_wave_kinematics(&self, t: f64, state: &mut State) {
        self.write_wave_kinematics(t, state);
    }
}

impl Residual for Scene {
    fn is_pentadiagonal(&self) -> bool {
        self.flexure.is_some() || self.traveller.is_some()
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.segment_residual(t, state, r);
        self.add_bed(state, r);
        self.add_water(state, r);
        self.add_traveller(t, state, r);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
        }
        for (number, AttachedBody { node: i, body }) in self.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = self.body_in_water(number, state);
            r[*i] += (body.added.component_mul(&a) - body.drag(&u)) * share;
        }
        if let Some(rigid_payload) = &self.rigid_payload {
            rigid_payload.add_forces(self, state, r);
        }
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.segment_tangent(t, state, c, r, tangent);
        self.add_bed(state, r);
        self.add_bed_tangent(state, c, tangent);
        self.add_water(state, r);
        self.add_water_tangent(state, c, tangent);
        self.add_traveller(t, state, r);
        match &self.flexure {
            Some(flexure) => flexure.linearise(self, state, c.stiffness, r, tangent),
            None => tangent.clear_far(),
        }
        self.add_traveller_tangent(t, state, c, tangent);
        for (number, AttachedBody { node: i, body }) in self.bodies.iter().enumerate() {
            let BodyInWater { u, a, share, .. } = self.body_in_water(number, state);
            let (_, shear) = self.current.at(state.x[*i].z);
            r[*i] += (body.added.component_mul(&a) - body.drag(&u)) * share;
            let by_velocity = body.drag_by_velocity(&u) * share;
            let added = body.added * share;
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(added * c.mass));
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
            tangent.diag[*i] += own;
        }
        if let Some(rigid_payload) = &self.rigid_payload {
            rigid_payload.add_forces(self, state, r);
            rigid_payload.add_tangent(self, state, c, tangent);
        }
    }

    fn extrapolate_tensions(&self, d: &[V3], state: &mut State) {
        self.extrapolate_segment_tensions(d, state);
    }

    fn force_norm_displacement(&self, d: &[V3], state: &State) -> f64 {
        self.force_norm_displacement(d, state)
    }
}

impl ExplicitRhs for Scene {
    fn accelerate(&self, t: f64, state: &mut State) {
        self.accelerations(t, state);
        self.accelerate_rigid_payload(state);
        self.accelerate_traveller(t, state);
    }

    fn fastest_decay(&self, state: &State) -> (f64, usize) {
        self.fastest_drag_decay(state)
    }
}

impl Hysteresis for Scene {
    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        self.update_grips(state);
        self.remember_ropes(t, dt, state);
    }

    fn freeze_drag_coefficients(&self, state: &mut State) {
        let segments = self.segments.len();
        state.memory.drag_coefficients.resize(segments, [0.0; 2]);
        for i in 0..self.segments.len() {
            let u = self.relative_velocities(i, state);
            let tangent = self.chord(i, state).tangent;
            state.memory.drag_coefficients[i] = self.segments[i]
                .drag
                .normal_coefficients(&tangent, [&u[0], &u[1]]);
        }
    }
}

impl MidstepBalance for Scene {
    fn correct_chord_lengths(&self, share: f64, before: &State, end: &mut State) {
        self.chord_corrections(share, before, end);
    }

    fn snap_acceleration(&self, between: &State, end: &State) -> f64 {
        self.acceleration_by_snaps(between, end)
    }
}

impl StaticSearch for Scene {
    fn force_scale(&self) -> f64 {
        self.force_scale
    }

    fn rounding_force(&self) -> f64 {
        self.stiffest() * self.rounding()
    }

    fn position_tolerance(&self, relative: f64) -> f64 {
        (relative * self.force_scale / self.stiffest()).max(self.rounding())
    }

    fn initialise_tensions(&self, state: &mut State) {
        self.initial_segment_tensions(state);
    }

    fn kinked_node(&self, state: &State) -> Option<usize> {
        self.flexure.as_ref()?.kinked_node(self, state)
    }

    fn with_clamps(&self, start: &State, fraction: f64) -> Option<Self> {
        let flexure = self.flexure.as_ref()?.with_clamps(self, start, fraction)?;
        let mut scene = self.clone();
        scene.flexure = Some(flexure);
        Some(scene)
    }

    fn without_friction(&self) -> Option<Self> {
        let rough = self.bed.filter(|bed| bed.friction.is_some())?;
        let mut scene = self.clone();
        scene.bed = Some(Seabed {
            friction: None,
            ..rough
        });
        scene.start_grips.clear();
        Some(scene)
    }

    fn reset_friction(&self, state: &mut State) {
        state.memory.grips = self.grips_at(&state.x);
    }
}
