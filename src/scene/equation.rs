//! The line's equation of motion, as the solvers see it: residual, tangent, explicit accelerations.

use std::ops::Range;

use super::half::{Half, pull_by_chord};
use super::{End, Hung, Scene};
use crate::linalg::{BlockBand, M3, V3};
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
        self.flexure.is_some()
    }

    fn folded(&self, state: &State) -> Option<usize> {
        self.flexure.as_ref()?.folded(self, state)
    }

    fn prescribe(&self, t: f64, state: &mut State) {
        let last = self.nodes() - 1;
        for (end, node) in [(0, 0), (1, last)] {
            if let End::Held(motion) = &self.ends[end] {
                (state.x[node], state.v[node], state.a[node]) = motion.at(t);
            }
        }
    }

    fn residual(&self, _t: f64, state: &State, r: &mut [V3]) {
        for (i, out) in r.iter_mut().enumerate() {
            *out = state.a[i] * self.mass[i];
            out.z += self.weight[i];
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let t = &chord.tangent;
            let pull = t * self.tension(i, &chord, state).0.value;
            r[i] -= pull;
            r[i + 1] += pull;
            for (node, drag) in [i, i + 1].into_iter().zip(self.drag(i, &chord, state)) {
                r[node] += self.segments[i].added.force(t, &state.a[node]) - drag.force;
            }
        }
        self.add_bed(state, r);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
        }
        for Hung { node: i, body } in &self.bodies {
            let (water, _) = self.current.at(state.x[*i].z);
            r[*i] += body.added.component_mul(&state.a[*i]) - body.drag(&(water - state.v[*i]));
        }
    }

    fn linearise(&self, _t: f64, state: &State, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for (i, (out, diag)) in r.iter_mut().zip(&mut tangent.diag).enumerate() {
            *out = state.a[i] * self.mass[i];
            out.z += self.weight[i];
            *diag = M3::from_diagonal_element(c.mass * self.mass[i]);
        }
        for i in 0..self.segments.len() {
            let chord = self.chord(i, state);
            let t = &chord.tangent;
            let (tension, foretold) = self.tension(i, &chord, state);
            let pull = t * tension.value;
            r[i] -= pull;
            r[i + 1] += pull;
            let by_chord = pull_by_chord(&chord, &foretold, c);
            let drag = self.drag(i, &chord, state);
            let sheared = self.shear(i, state);
            let (shear, back) = match &sheared {
                Some([first, second]) => (Some([first, second]), Some([second, first])),
                None => (None, None),
            };
            let stretch = self.wetted(i, &chord).1;
            let segment = &self.segments[i];
            let half = |drag, other, a, shear, sign| Half {
                segment,
                chord: &chord,
                pull: by_chord,
                drag,
                other,
                a,
                shear,
                stretch,
                sign,
            };
            let first = half(&drag[0], &drag[1], &state.a[i], shear, -1.0);
            tangent.upper[i] = first.add(c, &mut r[i], &mut tangent.diag[i]);
            let second = half(&drag[1], &drag[0], &state.a[i + 1], back, 1.0);
            tangent.lower[i + 1] = second.add(c, &mut r[i + 1], &mut tangent.diag[i + 1]);
        }
        self.add_bed(state, r);
        self.add_bed_tangent(state, c, tangent);
        if let Some(flexure) = &self.flexure {
            flexure.add_forces(self, state, r);
            flexure.add_tangent(self, state, c.stiffness, tangent);
        }
        for Hung { node: i, body } in &self.bodies {
            let (water, shear) = self.current.at(state.x[*i].z);
            let u = water - state.v[*i];
            r[*i] += body.added.component_mul(&state.a[*i]) - body.drag(&u);
            let by_velocity = body.drag_by_velocity(&u);
            let mut own = by_velocity * c.damping + M3::from_diagonal(&(body.added * c.mass));
            let column = own.column(2) - by_velocity * shear * c.stiffness;
            own.set_column(2, &column);
            tangent.diag[*i] += own;
        }
    }

    fn fastest_decay(&self, state: &State) -> (f64, usize) {
        self.decay_by_drag(state)
    }

    fn remember(&self, state: &mut State) {
        state.memory.resize(self.segments.len(), [0.0; 2]);
        for i in 0..self.segments.len() {
            let u = self.relative_velocities(i, state);
            let tangent = self.chord(i, state).tangent;
            state.memory[i] = self.segments[i]
                .drag
                .normal_coefficients(&tangent, [&u[0], &u[1]]);
        }
    }

    fn guess_tensions(&self, state: &mut State) {
        self.begin_foretelling(state);
    }

    fn foretell(&self, d: &[V3], state: &mut State) {
        self.foretell_tensions(d, state);
    }

    fn accelerate(&self, _t: f64, state: &mut State) {
        self.accelerations(state);
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
