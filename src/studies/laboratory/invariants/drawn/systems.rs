//! The kinds of random systems, each of its parts.

use super::DrawnSystemWriter;
use super::parts::distance;

impl DrawnSystemWriter<'_> {
    /// One or two lines from the bed or from anywhere to an upper end.
    pub(super) fn held(&mut self) {
        let depth = self.plane.depth;
        let top = self.top([0.0, 0.0, -0.1 * depth]);
        for k in 0..self.random.whole(1, 2) {
            let (far, angle) = (self.random.between(0.2, 2.0) * depth, 2.0 * k as f64 + 0.4);
            let (x, y) = (far * angle.cos(), far * angle.sin());
            let low = if self.random.chance(0.7) {
                self.anchor(x, y)
            } else {
                let z = -self.random.between(0.2, 0.9) * depth;
                self.fixed([x, y, z])
            };
            self.line(&low, &top, far.hypot(0.9 * depth), (1.0, 1.3), "");
        }
    }

    pub(super) fn web(&mut self) {
        let depth = self.plane.depth;
        let top = self.top([0.0, 0.0, -0.1 * depth]);
        let mut before = (top, [0.0, 0.0, -0.1]);
        for k in 0..self.random.whole(1, 2) {
            let free = self.free();
            let at = [0.15 * (k + 1) as f64, 0.1, -0.1 - 0.35 * (k + 1) as f64];
            let apart = distance(at, before.1) * depth;
            self.line(&before.0, &free, apart, (0.98, 1.2), "");
            for side in [-1.0, 1.0] {
                let (x, y) = (0.6 * side, 0.5 * side + 0.2);
                let anchor = self.anchor(x * depth, y * depth);
                let apart = distance(at, [x, y, -1.0]) * depth;
                self.line(&anchor, &free, apart, (0.99, 1.25), "");
            }
            before = (free, at);
        }
    }

    /// A body on three lines, of which one may have a bridle.
    pub(super) fn body(&mut self, kind: &str) {
        let depth = self.plane.depth;
        self.body_of("b0", kind, 0.0);
        let bridled = self.random.chance(0.3);
        for k in 0..3 {
            let angle = std::f64::consts::TAU * f64::from(k) / 3.0 + 0.3;
            let (sin, cos) = angle.sin_cos();
            let far = self.random.between(1.0, 2.5) * depth;
            let anchor = self.anchor(far * cos, far * sin);
            let apart = (far - 6.0).hypot(depth - 5.0);
            if k == 0 && bridled {
                let junction = self.free();
                self.line(&anchor, &junction, 0.8 * apart, (1.0, 1.08), "");
                for side in [-4.0, 4.0] {
                    let on = self.on("b0", [6.0 * cos - side * sin, 6.0 * sin + side * cos, -5.0]);
                    self.line(&junction, &on, 0.2 * apart, (1.0, 1.08), "");
                }
                continue;
            }
            let on = self.on("b0", [6.0 * cos, 6.0 * sin, -5.0]);
            self.line(&anchor, &on, apart, (0.997, 1.08), "");
        }
    }

    /// A buoy of one or two members on one to three lines.
    pub(super) fn buoy(&mut self) {
        let depth = self.plane.depth;
        let draught = self.random.between(0.08, 0.25) * depth.min(150.0);
        let diameter = draught * self.random.between(0.15, 0.5);
        let volume = 0.785 * diameter * diameter * draught;
        let mass = 1025.0 * volume * self.random.between(0.7, 1.1);
        let (low, inertia) = (-0.7 * draught, 0.15 * mass * draught * draught);
        let (yaw, damping) = (self.random.between(-90.0, 90.0), 0.05 * mass);
        self.put(format_args!(
            "[bodies.b0]\nkind = \"free\"\nyaw_deg = {yaw:?}\nmass_kg = {mass:?}\ncentre_of_gravity_m = [0.0, 0.0, {low:?}]\n\
             inertia_kg_m2 = [{inertia:?}, {inertia:?}, {inertia:?}]\n\
             damping = [{damping:?}, {damping:?}, {damping:?}, {inertia:?}, {inertia:?}, {inertia:?}]\n"
        ));
        self.member(
            "bodies",
            "b0",
            [0.0, 0.0, -draught],
            [0.0, 0.0, 0.5 * draught],
            diameter,
        );
        if self.random.chance(0.4) {
            let out = 0.8 * draught;
            self.member(
                "bodies",
                "b0",
                [0.0, 0.0, -0.5 * draught],
                [out, 0.1 * out, -0.4 * draught],
                0.3 * diameter,
            );
        }
        let lines = self.random.whole(1, 3);
        for k in 0..lines {
            let angle = std::f64::consts::TAU * k as f64 / 3.0;
            let (sin, cos) = angle.sin_cos();
            let far = if lines == 1 {
                0.1
            } else {
                self.random.between(0.8, 2.0)
            } * depth;
            let anchor = self.anchor(far * cos, far * sin);
            let on = self.on(
                "b0",
                [0.5 * diameter * cos, 0.5 * diameter * sin, -0.6 * draught],
            );
            let apart = far.hypot(depth - 0.6 * draught);
            self.line(&anchor, &on, apart, (1.0, 1.1), "");
        }
    }

    /// A rod between two lines, or a pinned body or rod with a line from its end.
    pub(super) fn rods(&mut self) {
        let depth = self.plane.depth;
        let long = self.random.between(4.0, 20.0);
        let diameter = long * self.random.between(0.02, 0.08);
        let mass = 805.0 * diameter * diameter * long * self.random.between(0.5, 3.0);
        let z = -self.random.between(0.3, 0.6) * depth;
        let top = self.top([0.3 * depth, 0.1 * depth, -0.1 * depth]);
        let upper = distance([0.3, 0.1, -0.1], [0.0, 0.0, z / depth]) * depth;
        match self.random.whole(0, 2) {
            0 => {
                let low = self.anchor(-0.4 * depth, 0.1 * depth);
                self.rod(
                    "free",
                    [-0.5 * long, 0.0, z],
                    [0.5 * long, 0.1, z + 0.1],
                    (mass, diameter),
                );
                let lower = distance([-0.4, 0.1, -1.0], [0.0, 0.0, z / depth]) * depth;
                self.line(&low, "r0-a", lower, (1.0, 1.2), "");
                self.line("r0-b", &top, upper, (1.0, 1.2), "");
            }
            1 => {
                self.rod(
                    "pinned",
                    [0.0, 0.0, z],
                    [0.8 * long, 0.1, z + 0.5 * long],
                    (mass, diameter),
                );
                self.line("r0-b", &top, upper, (1.0, 1.2), "");
            }
            _ => {
                let (inertia, low) = (mass * long * long / 3.0, -0.5 * long);
                self.put(format_args!(
                    "[bodies.b0]\nkind = \"pinned\"\nposition_m = [0.0, 0.0, {z:?}]\nmass_kg = {mass:?}\n\
                     centre_of_gravity_m = [0.0, 0.0, {low:?}]\ninertia_kg_m2 = [{inertia:?}, {inertia:?}, {inertia:?}]\n"
                ));
                self.member("bodies", "b0", [0.0, 0.0, -long], [0.0, 0.0, 0.0], diameter);
                let on = self.on("b0", [0.3, 0.0, -long]);
                self.line(&on, &top, upper + long, (1.0, 1.2), "");
            }
        }
    }

    /// Two bodies, each on two lines, with one between them.
    pub(super) fn shared(&mut self) {
        let (depth, apart) = (self.plane.depth, self.random.between(60.0, 300.0));
        let kinds = if self.random.chance(0.5) {
            ["free", "free"]
        } else {
            ["moved", "free"]
        };
        let mut inner = Vec::new();
        for ((name, kind), side) in ["b0", "b1"].into_iter().zip(kinds).zip([-1.0, 1.0]) {
            let x = 0.5 * side * apart;
            self.body_of(name, kind, x);
            for across in [-1.0, 1.0] {
                let anchor = self.anchor(x + side * depth, across * depth);
                let on = self.on(name, [6.0 * side, 6.0 * across, -5.0]);
                let far = (1.414 * (depth - 6.0)).hypot(depth - 5.0);
                self.line(&anchor, &on, far, (0.995, 1.08), "");
            }
            inner.push(self.on(name, [-6.0 * side, 0.0, -5.0]));
        }
        self.line(&inner[0], &inner[1], apart - 12.0, (1.0, 1.2), "");
    }

    /// A clump on the bed or above it, with a line on to an anchor.
    pub(super) fn clump(&mut self) {
        let depth = self.plane.depth;
        let top = self.top([0.0, 0.0, -0.05 * depth]);
        let clump = self.point("free");
        let mass = self.random.power(2.5, 4.5);
        let volume = 0.3 * mass / 1025.0;
        let at = self.above_bed([0.5 * depth, 0.1 * depth, -0.98 * depth]);
        self.put(format_args!(
            "position_m = {at:?}\nmass_kg = {mass:?}\nvolume_m3 = {volume:?}\ndrag_area_m2 = 1.0\n"
        ));
        if self.bed && self.plane.by_x == 0.0 && self.random.chance(0.5) {
            self.put(format_args!("bed_friction = 0.6\n"));
        }
        self.line(
            &clump,
            &top,
            (0.51 * depth).hypot(0.95 * depth),
            (1.0, 1.25),
            "",
        );
        let (x, y) = (depth * self.random.between(0.9, 1.5), 0.3 * depth);
        let anchor = self.anchor(x, y);
        let apart = (x - 0.5 * depth).hypot(0.2 * depth);
        self.line(&anchor, &clump, apart, (0.98, 1.1), "");
    }

    /// A line with a clump at its end or an anchor, paid out or hauled in at its upper end.
    pub(super) fn paid_out(&mut self) {
        let depth = self.plane.depth;
        let top = self.top([0.0, 0.0, -0.05 * depth]);
        let low = if self.random.chance(0.5) {
            let far = 0.5 * depth;
            let anchor = self.anchor(far, 0.2 * depth);
            self.line(&anchor, &top, far.hypot(depth), (1.05, 1.3), "");
            anchor
        } else {
            let free = self.point("free");
            let mass = self.random.power(3.0, 4.5);
            let volume = 0.3 * mass / 1025.0;
            self.put(format_args!(
                "mass_kg = {mass:?}\nvolume_m3 = {volume:?}\ndrag_area_m2 = 1.0\n"
            ));
            self.line(&free, &top, 0.5 * depth, (1.0, 1.0), "");
            free
        };
        let rate = self.random.between(-0.5, 1.5);
        // The line may be written either way.
        let end = if self.text.contains(&format!("from = \"{low}\"")) {
            "b"
        } else {
            "a"
        };
        self.put(format_args!(
            "[[payouts]]\nline = \"l0\"\nend = \"{end}\"\nrate_m_per_s = {rate:?}\n"
        ));
    }

    /// A free point between an upper end and an anchor, with a side line that is let go or breaks.
    pub(super) fn let_go(&mut self) {
        let depth = self.plane.depth;
        let top = self.top([0.0, 0.0, -0.1 * depth]);
        let middle = self.free();
        let low = self.anchor(0.3 * depth, 0.0);
        let side = self.fixed([-0.4 * depth, 0.1 * depth, -0.8 * depth]);
        self.line(&middle, &top, 0.45 * depth, (0.97, 1.15), "");
        self.line(&low, &middle, 0.58 * depth, (0.97, 1.15), "");
        let (when, share) = (self.random.between(0.5, 3.0), self.random.between(0.2, 0.8));
        let more = if self.random.chance(0.5) {
            let end = if self.random.chance(0.5) { "a" } else { "b" };
            format!("release_{end}_s = {when:?}\n")
        } else {
            format!(
                "break_at_m = {:?}\nbreak_s = {when:?}\n",
                share * 0.5 * depth
            )
        };
        self.line(&side, &middle, 0.52 * depth, (1.0, 1.3), &more);
    }
}
