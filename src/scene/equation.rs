//! The line's equation of motion, as the solvers see it: residual, tangent, explicit accelerations.

use std::ops::Range;

use super::water::Bathed;
use super::{End, Hung, Scene};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::seabed::Seabed;
use crate::solve::{Factors, State, System};

impl System for Scene {
    fn nodes(&self) -> usize {
        self.mass.len()
    }

    fn free(&self) -> Range<usize> {
        let held = |end: usize| usize::from(matches!(self.ends[end], End::Held(_)));
        held(0)..self.nodes() - held(1)
    }

    fn bends(&self) -> bool {
        self.flexure.is_some() || self.traveller.is_some()
    }

    fn folded(&self, state: &State) -> Option<usize> {
        self.flexure.as_ref()?.folded(self, state)
    }

    fn eased(&self, start: &State, share: f64) -> Option<Box<dyn System + '_>> {
        let flexure = self.flexure.as_ref()?.eased(self, start, share)?;
        let mut scene = self.clone();
        scene.flexure = Some(flexure);
        Some(Box::new(scene))
    }

    fn smooth(&self) -> Option<Box<dyn System + '_>> {
        let rough = self.bed.filter(|bed| bed.friction.is_some())?;
        let mut scene = self.clone();
        scene.bed = Some(Seabed {
            friction: None,
            ..rough
        });
        scene.start_grips.clear();
        Some(Box::new(scene))
    }

    fn hold_as_it_lies(&self, state: &mut State) {
        state.memory.grips = self.grips_at(&state.x);
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        let last = self.nodes() - 1;
        for (end, node) in [(0, 0), (1, last)] {
            if let End::Held(motion) = &self.ends[end] {
                (state.x[node], state.v[node], state.a[node]) = motion.at(t);
            }
        }
    }

    fn residual(&self, t: f64, state: &State, r: &mut [V3]) {
        self.begin_residual(t, state, r);
        self.add_bed(state, r);
        self.add_water(state, r);
        self.add_traveller(t, state, r);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
        }
        for (number, Hung { node: i, body }) in self.bodies.iter().enumerate() {
            let Bathed { u, a, share, .. } = self.bathed(number, state);
            r[*i] += (body.added.component_mul(&a) - body.drag(&u)) * share;
        }
        if let Some(turning) = &self.turning {
            turning.add_forces(self, state, r);
        }
    }

    fn linearise(&self, t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.begin_tangent(t, state, c, r, tangent);
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
        for (number, Hung { node: i, body }) in self.bodies.iter().enumerate() {
            let Bathed { u, a, share, .. } = self.bathed(number, state);
            let (_, shear) = self.current.at(state.x[*i].z);
            r[*i] += (body.added.component_mul(&a) - body.drag(&u)) * share;
            let by_velocity = body.drag_by_velocity(&u) * share;
            let added = body.added * share;
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(added * c.mass));
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
            tangent.diag[*i] += own;
        }
        if let Some(turning) = &self.turning {
            turning.add_forces(self, state, r);
            turning.add_tangent(self, state, c, tangent);
        }
    }

    fn take_water(&self, t: f64, state: &mut State) {
        self.take_in_waves(t, state);
    }

    fn fastest_decay(&self, state: &State) -> (f64, usize) {
        self.decay_by_drag(state)
    }

    fn tell_excess(&self, share: f64, before: &State, end: &mut State) {
        self.excess_of_mixing(share, before, end);
    }

    fn jolt(&self, between: &State, end: &State) -> f64 {
        self.jolt_of_snaps(between, end)
    }

    fn hold_drag(&self, state: &mut State) {
        let segments = self.segments.len();
        state.memory.held_drag.resize(segments, [0.0; 2]);
        for i in 0..self.segments.len() {
            let u = self.relative_velocities(i, state);
            let tangent = self.chord(i, state).tangent;
            state.memory.held_drag[i] = self.segments[i]
                .drag
                .normal_coefficients(&tangent, [&u[0], &u[1]]);
        }
    }

    fn commit(&self, t: f64, dt: f64, state: &mut State) {
        self.take_hold(state);
        self.remember_ropes(t, dt, state);
    }

    fn guess_tensions(&self, state: &mut State) {
        self.begin_foretelling(state);
    }

    fn foretell(&self, d: &[V3], state: &mut State) {
        self.foretell_tensions(d, state);
    }

    fn accelerate(&self, t: f64, state: &mut State) {
        self.accelerations(t, state);
        self.accelerate_turning(state);
        self.accelerate_traveller(t, state);
    }

    fn felt(&self, d: &[V3], state: &State) -> f64 {
        self.felt_displacement(d, state)
    }

    fn force_scale(&self) -> f64 {
        self.force_scale
    }

    fn rounding_force(&self) -> f64 {
        self.stiffest() * self.rounding()
    }

    fn position_tolerance(&self, relative: f64) -> f64 {
        (relative * self.force_scale / self.stiffest()).max(self.rounding())
    }
}
