//! A payload that turns: the last two nodes of the scene and the rod between them, with the drag on it.

use super::Scene;
use crate::linalg::{BlockBand, M3, V3};
use crate::physics::RigidBody;
use crate::physics::added_mass::AddedMass;
use crate::physics::tension::Chord;
use crate::solve::{Factors, State};

/// A turning body on the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// The node it hangs from, the last of the line; the next one is its centre of percussion.
    pub node: usize,
    /// The body; its masses and weights are those of the two nodes already, its rod the last segment.
    pub body: RigidBody,
}

/// A point of the body: where it is and how it moves.
struct Point {
    axis: Chord,
    /// Velocity of the water relative to it \[m/s\].
    u: V3,
    /// Its own velocity \[m/s\].
    v: V3,
    /// Shear of the current there \[1/s\].
    shear: V3,
}

impl Turning {
    fn at<'s>(&self, values: &'s [V3], place: f64) -> V3 {
        let [near, far]: [&'s V3; 2] = [&values[self.node], &values[self.node + 1]];
        near * (1.0 - place) + far * place
    }

    /// The centre of drag.
    fn drag_centre(&self, scene: &Scene, state: &State) -> Point {
        let place = self.body.drag_at;
        let (x, v) = (self.at(&state.x, place), self.at(&state.v, place));
        let (water, shear) = scene.current.at(x.z);
        Point {
            axis: scene.chord(self.node, state),
            u: water - v,
            v,
            shear,
        }
    }

    /// What the masses at the two nodes are more along the axis than across.
    fn along(&self) -> [AddedMass; 2] {
        self.body.along.map(|tangential| AddedMass {
            normal: 0.0,
            tangential,
        })
    }

    /// Takes drag from the residual, and adds what is heavier along the axis.
    pub(super) fn add_forces(&self, scene: &Scene, state: &State, r: &mut [V3]) {
        let Point { axis, u, .. } = self.drag_centre(scene, state);
        let drag = self.body.drag(&axis.tangent, &u);
        let shares = RigidBody::shares(self.body.drag_at);
        for ((i, share), mass) in (self.node..).zip(shares).zip(self.along()) {
            r[i] += mass.force(&axis.tangent, &state.a[i]) - drag * share;
        }
    }

    /// Adds the derivatives of those.
    pub(super) fn add_tangent(
        &self,
        scene: &Scene,
        state: &State,
        c: Factors,
        tangent: &mut BlockBand,
    ) {
        let Point { axis, u, shear, .. } = self.drag_centre(scene, state);
        let t = &axis.tangent;
        let (by_velocity, by_axis) = self.body.drag_slopes(t, &u);
        let across = M3::identity() - t * t.transpose();
        let by_far_end = by_axis * across * axis.inverse;
        let sheared = by_velocity * shear * V3::z().transpose();
        let shares = RigidBody::shares(self.body.drag_at);
        let along = self.along();
        for i in 0..2 {
            let a = &state.a[self.node + i];
            let (s, p) = along[i].by_chord(t, a, axis.inverse);
            let turned = M3::from_diagonal_element(s) + t * p.transpose();
            for j in 0..2 {
                let sign = if j == 0 { -1.0 } else { 1.0 };
                let slope = by_velocity * (c.damping * shares[j])
                    - (sheared * shares[j] + by_far_end * sign) * c.stiffness;
                let mut block = slope * shares[i] + turned * (sign * c.stiffness);
                if i == j {
                    block += t * t.transpose() * (c.mass * along[i].tangential);
                }
                match (i, j) {
                    (0, 1) => tangent.upper[self.node] += block,
                    (1, 0) => tangent.lower[self.node + 1] += block,
                    _ => tangent.diag[self.node + i] += block,
                }
            }
        }
    }

    /// What drag pushes a node with \[N\], the axis, and what the node is heavier along it \[kg\]; nothing for nodes of
    /// the line.
    pub(super) fn load(&self, scene: &Scene, node: usize, state: &State) -> Option<(V3, V3, f64)> {
        let i = node.checked_sub(self.node).filter(|i| *i < 2)?;
        let Point { axis, u, .. } = self.drag_centre(scene, state);
        let share = RigidBody::shares(self.body.drag_at)[i];
        let push = self.body.drag(&axis.tangent, &u) * share;
        Some((push, axis.tangent, self.body.along[i]))
    }

    /// Power that drag takes out of the body \[W\].
    pub(super) fn dissipation(&self, scene: &Scene, state: &State) -> f64 {
        let Point { axis, u, v, .. } = self.drag_centre(scene, state);
        -self.body.drag(&axis.tangent, &u).dot(&v)
    }

    /// Kinetic energy of what the nodes are heavier along the axis \[J\].
    pub(super) fn energy(&self, scene: &Scene, state: &State) -> f64 {
        let t = scene.chord(self.node, state).tangent;
        let part = |i: usize| 0.5 * self.body.along[i] * t.dot(&state.v[self.node + i]).powi(2);
        part(0) + part(1)
    }

    /// Fastest rate at which drag slows the body \[1/s\].
    pub(super) fn decay(&self, scene: &Scene, state: &State) -> f64 {
        let Point { u, .. } = self.drag_centre(scene, state);
        let mass = [scene.mass[self.node], scene.mass[self.node + 1]];
        self.body.decay(u.norm(), mass)
    }
}

impl Scene {
    /// Nodes of the line itself: all of them, less the far end of a body that turns.
    #[must_use]
    pub fn line_nodes(&self) -> usize {
        self.mass.len() - usize::from(self.turning.is_some())
    }

    /// Position of end B \[m\]: its last node, or the centre of gravity of a body that turns there.
    #[must_use]
    pub fn place_of_b(&self, state: &State) -> V3 {
        self.of_b(&state.x)
    }

    /// Velocity of end B \[m/s\], likewise.
    #[must_use]
    pub fn velocity_of_b(&self, state: &State) -> V3 {
        self.of_b(&state.v)
    }

    fn of_b(&self, values: &[V3]) -> V3 {
        match &self.turning {
            Some(turning) => turning.at(values, turning.body.centre),
            None => values[values.len() - 1],
        }
    }

    /// Mass of a node in the direction in which it is lightest, without the added mass of the line \[kg\].
    pub(super) fn least_mass(&self, node: usize) -> f64 {
        let along = self.turning.as_ref().and_then(|turning| {
            let i = node.checked_sub(turning.node)?;
            turning.body.along.get(i)
        });
        self.mass[node] + along.map_or(0.0, |more| more.min(0.0))
    }

    /// Angle between the axis of a body that turns and straight down \[rad\]; zero where none does.
    #[must_use]
    pub fn tilt(&self, state: &State) -> f64 {
        self.turning.as_ref().map_or(0.0, |turning| {
            let t = self.chord(turning.node, state).tangent;
            t.x.hypot(t.y).atan2(-t.z)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;
    use crate::scene;
    use crate::solve::System;

    const BODY: &str = r#"
        line = [{ name = "rope", material = "rope", length_m = 20.0, segments = 2 }]
        case.title = "turning"
        current = { speed_m_per_s = [0.2, 2.7], direction_deg = [0.0, 80.0], depth_m = [0.0, 60.0] }
        materials.rope = { diameter_m = 0.1, mass_kg_per_m = 5.0, ea_n = 1e6 }
        ends.a = { name = "vessel", kind = "fixed", position_m = [0, 0, 0] }
        ends.b = { name = "body", kind = "payload" }
        start = { shape = "straight", elevation_deg = -50.0 }
        [payload]
        dry_mass_kg = 2000.0
        wet_mass_kg = 1500.0
        drag_area_m2 = [3.0, 3.0, 1.0]
        added_mass_kg = [700.0, 700.0, 400.0]
        [payload.rotation]
        centre_of_gravity_m = 2.0
        inertia_kg_m2 = 1500.0
        centre_of_buoyancy_m = 1.7
        centre_of_drag_m = 2.4
        added_inertia_kg_m2 = 200.0
        start_tilt_deg = 35.0
        start_azimuth_deg = 20.0
    "#;

    fn scene() -> Scene {
        scene::build(&toml::from_str::<Case>(BODY).unwrap(), 1).unwrap()
    }

    /// A state in which everything moves.
    fn moving(scene: &Scene) -> State {
        let mut state = scene.initial_state();
        for i in 1..scene.nodes() {
            let k = i as f64;
            state.x[i] += V3::new((7.0 * k).sin(), (5.0 * k).cos(), (3.0 * k).sin()) * 0.01;
            state.v[i] = V3::new((2.0 * k).cos(), (4.0 * k).sin(), (6.0 * k).cos());
            state.a[i] = V3::new((9.0 * k).sin(), (8.0 * k).sin(), (5.0 * k).cos()) * 3.0;
        }
        state
    }

    /// Without the rod, whose stiffness would hide everything else in a share of the whole.
    #[test]
    fn the_tangent_of_the_body_is_the_finite_difference() {
        let scene = scene();
        let turning = scene.turning.unwrap();
        let state = moving(&scene);
        let forces = |state: &State| {
            let mut r = vec![V3::zeros(); scene.nodes()];
            turning.add_forces(&scene, state, &mut r);
            r
        };
        let size = forces(&state).iter().map(V3::amax).fold(0.0, f64::max);
        for factors in [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)] {
            let c = Factors {
                mass: factors.0,
                damping: factors.1,
                stiffness: factors.2,
            };
            let mut tangent = BlockBand::new(scene.nodes());
            turning.add_tangent(&scene, &state, c, &mut tangent);
            for (j, axis) in (0..2).flat_map(|j| (0..3).map(move |axis| (j, axis))) {
                let shifted = |h: f64| {
                    let (mut moved, node) = (state.clone(), turning.node + j);
                    moved.x[node][axis] += h * c.stiffness;
                    moved.v[node][axis] += h * c.damping;
                    moved.a[node][axis] += h * c.mass;
                    forces(&moved)
                };
                let (up, down) = (shifted(1e-5), shifted(-1e-5));
                for i in 0..2 {
                    let row = turning.node + i;
                    let block = match (i, j) {
                        (0, 1) => tangent.upper[row],
                        (1, 0) => tangent.lower[row],
                        _ => tangent.diag[row],
                    };
                    let off = block.column(axis) - (up[row] - down[row]) / 2e-5;
                    assert!(off.amax() < 1e-7 * size, "{c:?} {i} {j} {axis}: {off}");
                }
            }
        }
    }

    #[test]
    fn the_explicit_acceleration_leaves_no_residual() {
        let scene = scene();
        let mut state = moving(&scene);
        scene.accelerate(0.0, &mut state);
        let mut r = vec![V3::zeros(); scene.nodes()];
        scene.residual(0.0, &state, &mut r);
        let size = scene.stiffest() * 0.01;
        assert!(r[1..].iter().all(|r| r.norm() < 1e-12 * size), "{r:?}");
    }

    /// The body is hung as tilted; where it is and how fast, by its centre of gravity.
    #[test]
    fn place_velocity_and_tilt_are_those_of_the_body() {
        let scene = scene();
        let mut state = scene.initial_state();
        assert_eq!(scene.line_nodes(), 3);
        assert!((scene.tilt(&state).to_degrees() - 35.0).abs() < 1e-9);
        let tilt = 35_f64.to_radians();
        let aside = V3::new(20_f64.to_radians().cos(), 20_f64.to_radians().sin(), 0.0);
        let centre = state.x[2] + (aside * tilt.sin() - V3::z() * tilt.cos()) * 2.0;
        assert!((scene.place_of_b(&state) - centre).norm() < 1e-9);
        // Turning about the hang point at 1 rad/s about the vertical.
        let spin = V3::z();
        state.v[3] = spin.cross(&(state.x[3] - state.x[2]));
        let expected = spin.cross(&(centre - state.x[2]));
        assert!((scene.velocity_of_b(&state) - expected).norm() < 1e-9);
    }
}
