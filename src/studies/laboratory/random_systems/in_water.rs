//! Random bodies in the water: buoys of members, rods.

use super::RandomNetworkBuilder;
use crate::numerics::V3;
use crate::physics::current::CurrentProfile;
use crate::system::network::{Body, Held, Member};
use crate::system::pose::Pose;

impl RandomNetworkBuilder<'_> {
    fn member(&mut self, from: V3, to: V3, radius: f64) -> Member {
        Member {
            from,
            to,
            radius: (radius, radius * self.random.between(0.5, 1.0)),
            drag: self.random.between(0.0, 1.5),
            added_mass: 1.0,
            drag_ends: [1.0; 2],
            added_mass_ends: [0.6; 2],
            drag_only: false,
        }
    }

    /// In half of the systems, a current that falls with the depth.
    fn current(&mut self) {
        let speed = self.random.between(0.1, 1.5);
        if self.random.uniform() < 0.5 {
            self.network.current = Some(CurrentProfile::Table {
                depth: vec![0.0, self.depth],
                velocity: vec![V3::new(speed, 0.3 * speed, 0.0), V3::zeros()],
            });
        }
    }

    /// A floating body of one to four members, upright or inclined, on three lines.
    pub(super) fn buoy(&mut self) {
        self.current();
        let draught = self.random.between(0.05, 0.4) * self.depth.min(150.0);
        let radius = draught * self.random.between(0.05, 0.5);
        let up = 0.4 * draught;
        let mut members = vec![self.member(V3::z() * -draught, V3::z() * up, radius)];
        for k in 0..self.random.whole(0, 3) {
            let angle = std::f64::consts::TAU * k as f64 / 3.0;
            let out = V3::new(angle.cos(), angle.sin(), 0.0) * draught;
            let lean = out * self.random.between(0.5, 1.0);
            members.push(self.member(lean - V3::z() * draught, out + V3::z() * up, 0.4 * radius));
        }
        let volume: f64 = members
            .iter()
            .map(|m| std::f64::consts::PI * m.radius.0 * m.radius.1 * (m.to - m.from).norm())
            .sum();
        let gravity = self.network.gravity;
        let mass = self.network.density * volume * self.random.between(0.3, 0.6);
        let low = draught * self.random.between(0.4, 0.8);
        self.network.bodies.push(Body {
            name: "buoy".to_owned(),
            free: true,
            mass,
            weight: mass * gravity,
            centre_of_gravity: V3::z() * -low,
            members,
            ..Body::default()
        });
        let far = self.random.between(1.0, 3.0) * self.depth;
        for k in 0..3 {
            let angle = std::f64::consts::TAU * f64::from(k) / 3.0;
            let towards = V3::new(angle.cos(), angle.sin(), 0.0);
            let anchor = self.point(Held::At(towards * far - V3::z() * self.depth));
            let place = towards * radius - V3::z() * 0.5 * draught;
            let fairlead = self.point(Held::On(0, place));
            let distance = (far - radius).hypot(self.depth - 0.5 * draught);
            self.between_points(anchor, fairlead, distance);
        }
    }

    /// One to three rods in a row between two anchors, heavy or buoyant.
    pub(super) fn rods(&mut self) {
        self.current();
        let (a, b) = (self.place(0.5 * self.depth), self.place(0.5 * self.depth));
        let count = self.random.whole(1, 3);
        let each = (b - a) / (2 * count + 1) as f64;
        let mut before = self.point(Held::At(a));
        let last = self.point(Held::At(b));
        for k in 0..count {
            let long = each.norm();
            let radius = long * self.random.between(0.002, 0.03);
            let volume = std::f64::consts::PI * radius * radius * long;
            let mass = self.network.density * volume * self.random.between(0.3, 4.0);
            let axis = each / long;
            let origin = a + each * (2 * k + 1) as f64 + 0.5 * each;
            let pitch = -axis.z.asin();
            let half = V3::x() * 0.5 * long;
            let weight = mass * self.network.gravity;
            let mut member = self.member(-half, half, radius);
            member.radius.1 = radius;
            self.network.bodies.push(Body {
                name: format!("rod{k}"),
                pose: Pose::new(origin, 0.0, pitch, axis.y.atan2(axis.x)),
                free: true,
                mass,
                weight,
                members: vec![member],
                spins_about: Some(V3::x()),
                ..Body::default()
            });
            let ends = [-half, half].map(|place| self.point(Held::On(k, place)));
            self.between_points(before, ends[0], long);
            before = ends[1];
        }
        self.between_points(before, last, each.norm());
    }
}
