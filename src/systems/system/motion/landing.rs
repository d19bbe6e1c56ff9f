//! What of a system bears on the bed by itself, points with weight or mass and the feet of bodies: how hard the bed pushes it, how fast it landed.

use super::foot::Foot;
use super::joints::Role;
use super::moving_system::MovingSystem;
use super::point_loads::{Around, BedHolds, anchor, bears, fastest_on_bed, normal_force};
use super::system_state::SystemState;
use crate::numerics::V3;
use crate::solve::{BodyOnBed, State};
use crate::system::bed::Bed;

/// Step times frequency up to which Runge-Kutta of order 4 is stable, on the imaginary axis and on the real one.
const STABLE: f64 = 2.785;

impl MovingSystem {
    /// What bears on the bed by itself, free points before bodies; nothing without a bed.
    pub(super) fn landing(&self) -> impl Iterator<Item = Foot> {
        let feet = self.network.bed.iter().flat_map(|_| self.bearing());
        feet.filter(|foot| bears(&foot.point))
    }

    /// The stability limits of explicit steps \[s\] of what bears on the bed by itself, and what sets each.
    pub(super) fn landing_limits(&self) -> impl Iterator<Item = (f64, String)> {
        let heavy = self.landing().filter_map(|foot| {
            let mass = foot.point.moving_mass.min() + self.mass_of_lines_at(foot.joint);
            (mass > 0.0).then(|| (foot.joint, STABLE / fastest_on_bed(&foot.point, mass)))
        });
        heavy.map(|(joint, limit)| {
            let at = format!("{} on the bed", self.name_of_bearing(joint));
            (limit, at)
        })
    }

    /// Mass of the lines that is lumped at a free point \[kg\]; none of a body, of which it is little.
    fn mass_of_lines_at(&self, joint: usize) -> f64 {
        let Role::Free(point) = self.joints.roles[joint] else {
            return 0.0;
        };
        let lines = self.network.lines.iter().zip(&self.scenes);
        let at_ends = lines.map(|(line, scene)| {
            let mass = &scene.line.mass;
            let ends = [(line.from, mass.first()), (line.to, mass.last())];
            let here = ends.into_iter().filter(|(end, _)| *end == point);
            here.filter_map(|(_, mass)| mass).sum::<f64>()
        });
        at_ends.sum()
    }

    /// Name of the point or body of a joint that bears on the bed.
    pub(super) fn name_of_bearing(&self, joint: usize) -> &str {
        match self.joints.roles[joint] {
            Role::Free(number) => &self.network.points[number].name,
            Role::Origin(body) => &self.network.bodies[body].name,
            Role::OnBody(..) => {
                let point = self.joints.points.iter().position(|own| *own == joint);
                point.map_or("", |point| &self.network.points[point].name)
            }
            _ => "",
        }
    }

    /// Attaches the springs of friction where everything is, and counts its landings from there.
    pub(super) fn begin_contacts(&self, joints: &mut State) {
        joints.memory.grips = self.anchors(joints);
        let Some(bed) = &self.network.bed else {
            return;
        };
        let begun = |foot: Foot| BodyOnBed {
            grip: anchor(&foot.point, &foot.place(&joints.x[foot.joint])),
            stuck: false,
            height: height(bed, &foot, joints),
            landing_speed: 0.0,
        };
        joints.memory.bodies = self.landing().map(begun).collect();
    }

    /// What holds all that bears on the bed.
    pub(super) fn holds<'a>(&'a self, joints: &'a State) -> BedHolds<'a> {
        BedHolds {
            grips: &joints.memory.grips,
            bodies: &joints.memory.bodies,
            numbers: &self.bearing_numbers,
        }
    }

    /// What surrounds the point of a joint.
    pub(super) fn around<'a>(&'a self, joints: &'a State, joint: usize) -> Around<'a> {
        Around {
            waves: joints.wave_flow.get(joint),
            hold: self.holds(joints).at(joint),
        }
    }

    /// Takes in where everything is after an accepted step; does not allocate.
    pub(super) fn note_landings(&self, joints: &mut State) {
        let Some(bed) = &self.network.bed else {
            return;
        };
        let mut bodies = std::mem::take(&mut joints.memory.bodies);
        for (foot, body) in self.landing().zip(&mut bodies) {
            body.update(height(bed, &foot, joints));
            if let Some(suction) = foot.point.suction {
                let height = bed.height(&foot.place(&joints.x[foot.joint]));
                body.stuck = suction.holds(body.stuck, height);
            }
        }
        joints.memory.bodies = bodies;
    }

    /// Normal force of the bed on what bears at a joint \[N\], with that on the ends of lines there.
    pub(super) fn bed_force(&self, joint: usize, state: &SystemState) -> f64 {
        let joints = &state.joints;
        let own = self.landing().find(|foot| foot.joint == joint);
        let own = own.map_or(0.0, |foot| {
            let place = foot.place(&joints.x[joint]);
            let hold = self.holds(joints).at(joint);
            normal_force(&self.network, &foot.point, (&place, &joints.v[joint]), hold)
        });
        // Lines are where their joints are.
        if own == 0.0 || !matches!(self.joints.roles[joint], Role::Free(_)) {
            return own;
        }
        let ends = state.attached.iter().enumerate();
        let on_line = |(number, ends): (usize, &[usize; 2])| -> f64 {
            let line = &state.lines[number];
            let nodes = [0, line.x.len() - 1].into_iter().zip(ends);
            let there = nodes.filter(|(_, at)| **at == joint);
            there
                .map(|(node, _)| self.scene(number, state).bed_force_at(node, line))
                .sum()
        };
        own + ends.map(on_line).sum::<f64>()
    }
}

/// Height of a foot above the bed along its normal \[m\], and its rates \[m/s\], \[m/s²\].
fn height(bed: &Bed, foot: &Foot, joints: &State) -> [f64; 3] {
    let joint = foot.joint;
    let place: V3 = foot.place(&joints.x[joint]);
    let gradient = bed.gradient(&place);
    let (normal, steepness) = (gradient.normalize(), gradient.norm());
    [
        bed.height(&place) / steepness,
        normal.dot(&joints.v[joint]),
        normal.dot(&joints.a[joint]),
    ]
}
