//! A payload that turns: the last two nodes of the scene and the rod between them, with what the water does to it.
//!
//! Waves act by drag at the centre of drag and, at the centre of buoyancy, by their pressure and by the water that goes with
//! the body. Across the surface, drag and waves count by the share that is wet, and buoyancy is lost to a potential,
//! as if the body were a sphere of its volume about the centre of buoyancy; its added mass stays whole.

use super::{Scene, Water, wetting};
use crate::linalg::{BlockBand, M3, V3};
use crate::physics::RigidBody;
use crate::physics::added_mass::AddedMass;
use crate::physics::sea::Flow;
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

/// The body in the water: what flows past its centre of drag, and what else the water does to it.
struct Afloat {
    axis: Chord,
    /// Velocity of the water relative to the centre of drag \[m/s\].
    u: V3,
    /// Velocity of the centre of drag \[m/s\].
    v: V3,
    /// How the water's velocity changes with the place there \[1/s\].
    gradient: M3,
    /// Acceleration of the water at the centre of buoyancy \[m/s²\], and how it changes with the place \[1/s²\].
    carried: (V3, M3),
    /// The share that is wet, and its derivative by the place of the centre of buoyancy \[1/m\].
    wet: (f64, V3),
    /// Mass of the water displaced \[kg\]; nothing where neither waves nor a surface are named.
    displaced: f64,
}

impl Turning {
    fn at<'s>(&self, values: &'s [V3], place: f64) -> V3 {
        let [near, far]: [&'s V3; 2] = [&values[self.node], &values[self.node + 1]];
        near * (1.0 - place) + far * place
    }

    /// What waves make of the water at its two nodes, and how much of each counts at a place on the rod.
    fn flows<'s>(&self, place: f64, state: &'s State) -> impl Iterator<Item = (f64, &'s Flow)> {
        let nodes = (self.node..).zip(RigidBody::shares(place));
        nodes.filter_map(|(node, share)| Some((share, state.water.get(node)?)))
    }

    fn afloat(&self, scene: &Scene, state: &State) -> Afloat {
        let (drag_at, lift_at) = (self.body.drag_at, self.body.buoyancy_at);
        let (x, v) = (self.at(&state.x, drag_at), self.at(&state.v, drag_at));
        let (mut water, shear) = scene.current.at(x.z);
        let mut gradient = shear * V3::z().transpose();
        for (share, flow) in self.flows(drag_at, state) {
            water += flow.velocity_at(&x) * share;
            gradient += flow.gradient * share;
        }
        let centre = self.at(&state.x, lift_at);
        let mut carried = (V3::zeros(), M3::zeros());
        for (share, flow) in self.flows(lift_at, state) {
            carried.0 += flow.acceleration_at(&centre) * share;
            carried.1 += flow.acceleration_gradient * share;
        }
        Afloat {
            axis: scene.chord(self.node, state),
            u: water - v,
            v,
            gradient,
            carried,
            wet: self.wet(scene, state),
            displaced: scene.water.as_ref().map_or(0.0, |w| self.displaced(w)),
        }
    }

    /// Mass of the water it displaces \[kg\].
    fn displaced(&self, water: &Water) -> f64 {
        (self.body.buoyancy / water.gravity).max(0.0)
    }

    /// The share of it that is wet, as a sphere of its volume about the centre of buoyancy, and its derivative by the place of
    /// that \[1/m\].
    fn wet(&self, scene: &Scene, state: &State) -> (f64, V3) {
        let Some(water) = scene.water.as_ref().filter(|w| w.crossed) else {
            return (1.0, V3::zeros());
        };
        let centre = self.at(&state.x, self.body.buoyancy_at);
        let (mut above, mut by_place) = (centre.z, V3::z());
        for (share, flow) in self.flows(self.body.buoyancy_at, state) {
            above -= flow.elevation_at(&centre) * share;
            by_place -= flow.slope * share;
        }
        let (share, slope) = wetting::sphere(water.radius_of(self.displaced(water)), above);
        (share, by_place * slope)
    }

    /// What the masses at the two nodes are more along the axis than across.
    fn along(&self) -> [AddedMass; 2] {
        self.body.along.map(|tangential| AddedMass {
            normal: 0.0,
            tangential,
        })
    }

    /// Its added mass about the centre of buoyancy.
    fn added(&self) -> AddedMass {
        let [normal, tangential] = self.body.added;
        AddedMass { normal, tangential }
    }

    /// What the water's acceleration does to it where it is wet, less the buoyancy of what is dry: a load at the centre
    /// of buoyancy \[N\].
    fn pressure(&self, there: &Afloat) -> V3 {
        let (share, a) = (there.wet.0, &there.carried.0);
        let moved = self.added().force(&there.axis.tangent, a) + a * there.displaced;
        moved * share - V3::z() * ((1.0 - share) * self.body.buoyancy)
    }

    /// Loads of the water on both nodes \[N\], and the axis.
    fn loads(&self, scene: &Scene, state: &State) -> ([V3; 2], V3) {
        let there = self.afloat(scene, state);
        let drag = self.body.drag(&there.axis.tangent, &there.u) * there.wet.0;
        let pressure = self.pressure(&there);
        let (by_drag, by_pressure) = (
            RigidBody::shares(self.body.drag_at),
            RigidBody::shares(self.body.buoyancy_at),
        );
        let load = [0, 1].map(|i| drag * by_drag[i] + pressure * by_pressure[i]);
        (load, there.axis.tangent)
    }

    /// Takes the water's loads from the residual, and adds what is heavier along the axis.
    pub(super) fn add_forces(&self, scene: &Scene, state: &State, r: &mut [V3]) {
        let (loads, axis) = self.loads(scene, state);
        for ((i, load), mass) in (self.node..).zip(loads).zip(self.along()) {
            r[i] += mass.force(&axis, &state.a[i]) - load;
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
        let there = self.afloat(scene, state);
        let (axis, share) = (&there.axis, there.wet.0);
        let t = &axis.tangent;
        let (by_velocity, by_axis) = self.body.drag_slopes(t, &there.u);
        let turn = (M3::identity() - t * t.transpose()) * axis.inverse;
        // Drag by velocity and place of its centre; pressure by place of its own; both by the axis and by what is wet.
        let drag_by_place = by_velocity * there.gradient * share;
        let drag_by_axis = by_axis * turn * share;
        let (pressure_by_place, pressure_by_axis) = self.pressure_slopes(&there);
        let pressure_by_axis = pressure_by_axis * turn;
        let drag_by_wet = self.body.drag(t, &there.u) * there.wet.1.transpose();
        let (d, p) = (
            RigidBody::shares(self.body.drag_at),
            RigidBody::shares(self.body.buoyancy_at),
        );
        let along = self.along();
        for i in 0..2 {
            let a = &state.a[self.node + i];
            let (s, q) = along[i].by_chord(t, a, axis.inverse);
            let turned = M3::from_diagonal_element(s) + t * q.transpose();
            for j in 0..2 {
                let sign = if j == 0 { -1.0 } else { 1.0 };
                let drag = by_velocity * (share * c.damping * d[j])
                    - (drag_by_place * d[j] + drag_by_axis * sign + drag_by_wet * p[j])
                        * c.stiffness;
                let pressure = (pressure_by_place * p[j] + pressure_by_axis * sign) * -c.stiffness;
                let mut block = drag * d[i] + pressure * p[i] + turned * (sign * c.stiffness);
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

    /// Derivatives of the pressure by the place of the centre of buoyancy \[N/m\] and by the axis \[N\].
    fn pressure_slopes(&self, there: &Afloat) -> (M3, M3) {
        let (t, (share, by_place)) = (&there.axis.tangent, there.wet);
        let (a, gradient) = (&there.carried.0, &there.carried.1);
        let added = self.added();
        let more = added.tangential - added.normal;
        let mass =
            M3::from_diagonal_element(added.normal + there.displaced) + t * t.transpose() * more;
        let gained = mass * a + V3::z() * self.body.buoyancy;
        (
            mass * gradient * share + gained * by_place.transpose(),
            (M3::from_diagonal_element(t.dot(a)) + t * a.transpose()) * (more * share),
        )
    }

    /// What the water loads a node with \[N\], the axis, and what the node is heavier along it \[kg\]; nothing for nodes of
    /// the line.
    pub(super) fn load(&self, scene: &Scene, node: usize, state: &State) -> Option<(V3, V3, f64)> {
        let i = node.checked_sub(self.node).filter(|i| *i < 2)?;
        let (loads, axis) = self.loads(scene, state);
        Some((loads[i], axis, self.body.along[i]))
    }

    /// Power that drag takes out of the body \[W\].
    pub(super) fn dissipation(&self, scene: &Scene, state: &State) -> f64 {
        let there = self.afloat(scene, state);
        let drag = self.body.drag(&there.axis.tangent, &there.u) * there.wet.0;
        -drag.dot(&there.v)
    }

    /// Power that waves put into it by their pressure \[W\], its potential that in still water.
    pub(super) fn power_of_waves(&self, scene: &Scene, state: &State, still: &State) -> f64 {
        let load = self.pressure(&self.afloat(scene, state));
        let lost = self.pressure(&self.afloat(scene, still));
        (load - lost).dot(&self.at(&state.v, self.body.buoyancy_at))
    }

    /// Energy of the buoyancy it lacks in still water \[J\].
    pub(super) fn lifted(&self, water: &Water, state: &State) -> f64 {
        let z = self.at(&state.x, self.body.buoyancy_at).z;
        let radius = water.radius_of(self.displaced(water));
        self.body.buoyancy.max(0.0) * wetting::sphere_lifted(radius, z)
    }

    /// Kinetic energy of what the nodes are heavier along the axis \[J\].
    pub(super) fn energy(&self, scene: &Scene, state: &State) -> f64 {
        let t = scene.chord(self.node, state).tangent;
        let part = |i: usize| 0.5 * self.body.along[i] * t.dot(&state.v[self.node + i]).powi(2);
        part(0) + part(1)
    }

    /// Fastest rate at which drag slows the body \[1/s\].
    pub(super) fn decay(&self, scene: &Scene, state: &State) -> f64 {
        let speed = self.afloat(scene, state).u.norm();
        let mass = [scene.mass[self.node], scene.mass[self.node + 1]];
        self.body.decay(speed, mass)
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

    /// The same in waves, hung so that it is partly out of the water.
    fn at_sea(surface: &str) -> Scene {
        let height = if surface == "crossed" { 17.4 } else { 0.0 };
        let text = BODY.replace("[0, 0, 0]", &format!("[0, 0, {height:?}]"));
        let more = format!(
            "\nwaves = {{ kind = \"regular\", height_m = 1.5, period_s = 5.0, direction_deg = 25.0 }}\n\
             environment.water_surface = \"{surface}\"\n"
        );
        let text = text.replace("case.title", &format!("{more}case.title"));
        scene::build(&toml::from_str::<Case>(&text).unwrap(), 1).unwrap()
    }

    fn scenes() -> [Scene; 3] {
        [scene(), at_sea("ignored"), at_sea("crossed")]
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
        scene.take_water(1.3, &mut state);
        state
    }

    #[test]
    fn it_is_partly_wet_in_the_tests() {
        let scene = at_sea("crossed");
        let (share, slope) = scene.turning.unwrap().wet(&scene, &moving(&scene));
        assert!((0.1..0.9).contains(&share) && slope.norm() > 0.1, "{share}");
    }

    /// Without the rod, whose stiffness would hide everything else in a share of the whole.
    #[test]
    fn the_tangent_of_the_body_is_the_finite_difference() {
        scenes().iter().for_each(has_its_tangent);
    }

    fn has_its_tangent(scene: &Scene) {
        let turning = scene.turning.unwrap();
        let state = moving(scene);
        let forces = |state: &State| {
            let mut r = vec![V3::zeros(); scene.nodes()];
            turning.add_forces(scene, state, &mut r);
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
            turning.add_tangent(scene, &state, c, &mut tangent);
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
        for scene in scenes() {
            let mut state = moving(&scene);
            scene.accelerate(0.0, &mut state);
            let mut r = vec![V3::zeros(); scene.nodes()];
            scene.residual(0.0, &state, &mut r);
            let size = scene.stiffest() * 0.01;
            assert!(r[1..].iter().all(|r| r.norm() < 1e-12 * size), "{r:?}");
        }
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
