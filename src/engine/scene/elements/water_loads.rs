//! Loads of waves and of the water surface on the line that are neither drag nor added mass: the pressure of the undisturbed
//! wave (Froude-Krylov) and the buoyancy that dry parts lack, with all derivatives by position in the water.

use crate::numerics::lanes::{self, Two, TwoM3};
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::drag::Drag;
use crate::physics::tension::Chord;
use crate::scene::element::{At, Element};
use crate::scene::submergence::{self, Submergence};
use crate::scene::water::{BodyInWater, height};
use crate::scene::{AttachedBody, LumpedLine, Water};
use crate::solve::{Factors, State};

/// The loads of [`Water`] on segments and point bodies.
pub(super) struct WaterLoads;

impl Element for WaterLoads {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        let At { line, state, .. } = at;
        if line.water.is_none() {
            return;
        }
        for i in 0..line.segments.len() {
            let wet = line.wet(i, state);
            for half in [0, 1] {
                r[i + half] -= line.pressure(i, half, wet.as_ref(), state);
            }
        }
        for (number, hung) in line.bodies.iter().enumerate() {
            r[hung.node] -= line.body_in_water(number, state).load;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        let At { line, state, .. } = at;
        let Some(water) = &line.water else {
            return;
        };
        for i in 0..line.segments.len() {
            let chord = line.chord(i, state);
            let drag = line.full_drag(i, &chord, state);
            let wet = line.wet(i, state);
            let segment = WetSegment {
                i,
                chord: &chord,
                drag: &drag,
                wet: wet.as_ref(),
            };
            for half in [0, 1] {
                let (own, other) = segment.half_by_position(half, line, water, state);
                tangent.diag[i + half] += own * c.stiffness;
                let coupling = if half == 0 {
                    &mut tangent.upper[i]
                } else {
                    &mut tangent.lower[i + 1]
                };
                *coupling += other * c.stiffness;
            }
        }
        for (number, hung) in line.bodies.iter().enumerate() {
            let own = body_by_position(line, water, number, hung, state);
            tangent.diag[hung.node] += own * c.stiffness;
        }
    }

    fn has_explicit_form(&self) -> bool {
        true
    }

    fn add_wave_power(&self, at: At<'_>, power: &mut f64) {
        let At { line, state, .. } = at;
        for i in 0..line.segments.len() {
            let (t, wet) = (line.chord(i, state).tangent, line.wet(i, state));
            for half in [0, 1] {
                let load = line.wave_force(i, half, &t, wet.as_ref(), state);
                let load = load - line.lost_in_still_water(i, half, state);
                *power += load.dot(&state.v[i + half]);
            }
        }
        for (number, hung) in line.bodies.iter().enumerate() {
            let BodyInWater {
                carried,
                share,
                load,
                ..
            } = line.body_in_water(number, state);
            let load = load + line.body_added_mass(number, state).force(&carried) * share;
            let load = load - line.body_lost_in_still_water(number, state);
            *power += load.dot(&state.v[hung.node]);
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        let At { line, state, .. } = at;
        if line.water.is_some() {
            let i = node.saturating_sub(1);
            *force += line.pressure(i, node - i, line.wet(i, state).as_ref(), state);
        }
    }
}

/// A segment in the water.
struct WetSegment<'a> {
    i: usize,
    chord: &'a Chord,
    /// Drag of both halves as if all of it were wet.
    drag: &'a Drag<Two>,
    wet: Option<&'a [Submergence; 2]>,
}

impl WetSegment<'_> {
    /// Derivatives of the residual of a half by the positions of its own node and of the other one, as far as they come from
    /// the water: `f [ -(M_added + m) dA/dx - dF/du dU/dx ] + (load as if all were wet) (df/dx)'`, f the submerged fraction.
    fn half_by_position(
        &self,
        half: usize,
        line: &LumpedLine,
        water: &Water,
        state: &State,
    ) -> (M3, M3) {
        let i = self.i;
        let (node, other) = (i + half, i + 1 - half);
        let (t, added) = (&self.chord.tangent, &line.segments[i].added);
        let displaced = water.displaced[i];
        let one = |blocks: &TwoM3| lanes::block(blocks, half);
        let (mut by_own, mut by_other) = (M3::zeros(), M3::zeros());
        let mut pressure = V3::zeros();
        if let (Some(here), Some(there)) = (state.wave_flow.get(node), state.wave_flow.get(other)) {
            by_own -= added.matrix(t, displaced) * here.acceleration_gradient
                + one(&self.drag.matrix(&lanes::twice(t))) * here.gradient;
            if let Some(blocks) = self.drag.by_other_velocity() {
                by_other -= one(&blocks) * there.gradient;
            }
            pressure = here.acceleration_at(&state.x[node]) * displaced;
        }
        if let Some(wet) = self.wet {
            let Submergence { share, by } = &wet[half];
            let relative = line.relative_acceleration(node, state);
            let all = added.force(t, &relative) - self.drag.forces()[half] - pressure;
            by_own = by_own * *share + all * by[half].transpose();
            by_other = by_other * *share + all * by[1 - half].transpose();
            let heights = [i, i + 1].map(|node| height(node, state));
            let dry = submergence::lost_buoyancy(water.radius[i], heights.map(|h| h.above));
            let lift = V3::z() * (2.0 * displaced * water.gravity);
            let by = |node: usize| lift * (heights[node].by_place * dry.by[half][node]).transpose();
            by_own += by(half);
            by_other += by(1 - half);
        }
        (by_own, by_other)
    }
}

/// The same for a point body, by the position of its node.
fn body_by_position(
    line: &LumpedLine,
    water: &Water,
    number: usize,
    hung: &AttachedBody,
    state: &State,
) -> M3 {
    let around = line.body_in_water(number, state);
    let (body, mass) = (&hung.body, water.by_bodies[number]);
    let added = line.body_added_mass(number, state);
    let mut by_position = M3::zeros();
    let mut pressure = V3::zeros();
    if let Some(flow) = state.wave_flow.get(hung.node) {
        let moved = added.matrix_with(mass);
        by_position -=
            moved * flow.acceleration_gradient + body.drag_by_velocity(&around.u) * flow.gradient;
        pressure = flow.acceleration_at(&state.x[hung.node]) * mass;
    }
    let all =
        added.force(&around.a) - body.drag(&around.u) - pressure - V3::z() * (mass * water.gravity);
    by_position * around.share + all * around.by_place.transpose()
}
