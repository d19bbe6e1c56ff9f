//! Points, lines, members and rods of random systems.

use super::DrawnSystemWriter;

impl DrawnSystemWriter<'_> {
    /// The name of a new point and its table so far.
    pub(super) fn point(&mut self, kind: &str) -> String {
        let name = format!("p{}", self.points);
        self.points += 1;
        self.put(format_args!("[points.{name}]\nkind = \"{kind}\"\n"));
        name
    }

    pub(super) fn fixed(&mut self, at: [f64; 3]) -> String {
        let name = self.point("fixed");
        let at = self.above_bed(at);
        self.put(format_args!("position_m = {at:?}\n"));
        name
    }

    /// A place no deeper than the bed.
    pub(super) fn above_bed(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, y, z.max(-self.plane.at(x, y))]
    }

    /// An anchor on the bed, or as deep without one.
    pub(super) fn anchor(&mut self, x: f64, y: f64) -> String {
        let z = -self.plane.at(x, y);
        self.fixed([x, y, z])
    }

    /// The keys of a motion in harmonics of up to this amplitude \[m\].
    pub(super) fn motion(&mut self, most: f64) {
        let by = [(); 3].map(|()| self.random.between(-most, most));
        let period = self.random.between(5.0, 14.0);
        self.put(format_args!(
            "amplitude_m = {by:?}\nperiod_s = {period:?}\nramp_s = 3.0\n"
        ));
    }

    /// An upper end: moved in motion, else held.
    pub(super) fn top(&mut self, at: [f64; 3]) -> String {
        if !self.moves {
            return self.fixed(at);
        }
        let name = self.point("moved");
        self.put(format_args!("position_m = {at:?}\n"));
        self.motion(1.5);
        name
    }

    /// A junction, a clump or a buoy.
    pub(super) fn free(&mut self) -> String {
        let name = self.point("free");
        let draw = self.random.uniform();
        if draw < 0.35 {
            return name;
        }
        let mass = self.random.power(1.5, 4.0);
        let of_mass = if draw < 0.7 {
            0.2
        } else {
            self.random.between(1.2, 3.0)
        };
        let volume = mass / 1025.0 * of_mass;
        let (added, area) = (500.0 * volume, volume.powf(2.0 / 3.0));
        self.put(format_args!(
            "mass_kg = {mass:?}\nvolume_m3 = {volume:?}\nadded_mass_kg = {added:?}\ndrag_area_m2 = {area:?}\n"
        ));
        name
    }

    pub(super) fn on(&mut self, body: &str, at: [f64; 3]) -> String {
        let name = self.point("body");
        self.put(format_args!("body = \"{body}\"\nposition_m = {at:?}\n"));
        name
    }

    /// A line between points that are so far apart, with more keys.
    pub(super) fn line(
        &mut self,
        from: &str,
        to: &str,
        apart: f64,
        (low, high): (f64, f64),
        more: &str,
    ) {
        let length = (apart * self.random.between(low, high)).max(2.0);
        let name = self.lines;
        self.lines += 1;
        let (from, to) = if self.random.chance(0.5) {
            (to, from)
        } else {
            (from, to)
        };
        let segments = self.random.whole(16, 30);
        self.put(format_args!(
            "[[lines]]\nname = \"l{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nsegments = {segments}\n{more}"
        ));
        if self.bed && self.plane.by_x == 0.0 && self.random.chance(0.05) {
            self.put(format_args!("friction = 0.5\n"));
        }
        if self.current && self.random.chance(0.05) {
            self.put(format_args!("still_water = true\n"));
        }
        let material = self.random.whole(0, 2);
        if !more.is_empty() || self.random.chance(0.7) {
            self.put(format_args!(
                "material = \"m{material}\"\nlength_m = {length:?}\n"
            ));
            return;
        }
        let (share, other) = (self.random.between(0.3, 0.7), self.random.whole(0, 2));
        let (first, second) = (share * length, (1.0 - share) * length);
        self.put(format_args!(
            "[[lines.sections]]\nmaterial = \"m{material}\"\nlength_m = {first:?}\n"
        ));
        if self.random.chance(0.4) {
            let clump = self.random.between(-300.0, 1500.0);
            self.put(format_args!("clump_kg = {clump:?}\n"));
        }
        self.put(format_args!(
            "[[lines.sections]]\nmaterial = \"m{other}\"\nlength_m = {second:?}\n"
        ));
    }

    pub(super) fn body_of(&mut self, name: &str, kind: &str, x: f64) {
        let kind = if kind == "moved" && !self.moves {
            "held"
        } else {
            kind
        };
        let (yaw, y) = (
            self.random.between(-60.0, 60.0),
            self.random.between(-5.0, 5.0),
        );
        self.put(format_args!(
            "[bodies.{name}]\nkind = \"{kind}\"\nposition_m = [{x:?}, {y:?}, 0.0]\nyaw_deg = {yaw:?}\n"
        ));
        match kind {
            "held" => return,
            "moved" => {
                let degrees = [(); 3].map(|()| self.random.between(-5.0, 5.0));
                let metres = [(); 3].map(|()| self.random.between(-2.0, 2.0));
                let period = self.random.between(5.0, 14.0);
                self.put(format_args!(
                    "amplitude_deg = {degrees:?}\namplitude_m = {metres:?}\nperiod_s = [{period:?}]\nramp_s = 4.0\n"
                ));
                return;
            }
            _ => {}
        }
        let mass = self.random.power(5.3, 6.8);
        let volume = mass / 1025.0 * self.random.between(1.0, 1.04);
        let spring = 1025.0 * 9.8 * (volume / 5.0);
        let (roll, inertia, damping) = (spring * 40.0, mass * 60.0, 0.1 * mass);
        let load = [
            self.random.between(-0.05, 0.05) * mass,
            self.random.between(-0.05, 0.05) * mass,
        ];
        let [along, across] = load;
        let area = (mass / 1025.0).powf(2.0 / 3.0);
        self.put(format_args!(
            "mass_kg = {mass:?}\ninertia_kg_m2 = [{inertia:?}, {inertia:?}, {inertia:?}]\nvolume_m3 = {volume:?}\n\
             centre_of_gravity_m = [0.0, 0.0, -2.0]\ncentre_of_buoyancy_m = [0.0, 0.0, -2.5]\n\
             waterplane_stiffness = [0.0, 0.0, {spring:?}, {roll:?}, {roll:?}, 0.0]\n\
             added_mass = [{mass:?}, {mass:?}, {mass:?}, {inertia:?}, {inertia:?}, {inertia:?}]\n\
             damping = [{damping:?}, {damping:?}, {damping:?}, {inertia:?}, {inertia:?}, {inertia:?}]\n\
             load_n = [{along:?}, {across:?}, 0.0]\ndrag_area_m2 = [{area:?}, {area:?}, {area:?}]\n"
        ));
        if self.random.chance(0.25) {
            self.member("bodies", name, [1.0, 2.0, -8.0], [1.0, 2.0, -4.0], 1.5);
        }
    }

    pub(super) fn member(
        &mut self,
        kind: &str,
        name: &str,
        from: [f64; 3],
        to: [f64; 3],
        diameter: f64,
    ) {
        let drag = self.random.between(0.0, 1.2);
        self.put(format_args!(
            "[[{kind}.{name}.members]]\nfrom_m = {from:?}\nto_m = {to:?}\ndiameter_m = {diameter:?}\n\
             drag_normal = {drag:?}\nadded_mass_normal = 1.0\n"
        ));
    }

    pub(super) fn rod(
        &mut self,
        kind: &str,
        a: [f64; 3],
        b: [f64; 3],
        (mass, diameter): (f64, f64),
    ) {
        self.put(format_args!(
            "[rods.r0]\nkind = \"{kind}\"\nend_a_m = {a:?}\nend_b_m = {b:?}\nmass_kg = {mass:?}\ndiameter_m = {diameter:?}\ndrag_normal = 1.0\n"
        ));
    }
}

/// Distance of two places \[m\].
pub(super) fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    let squares = one.iter().zip(other).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}
