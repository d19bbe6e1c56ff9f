//! Random systems with all that a file may have: bed, friction, slopes, current, waves, wind, members, bodies that float, are moved or pinned,
//! rods, lines that are paid out, let go or break, ropes with tables, lines that bend or float, a surface that is crossed, clumps.

use std::fmt::{Arguments, Write};

use toml::Table;

use crate::numerics::random::Random;

/// The kinds, in turn; the last of them in motion alone.
pub const KINDS: [&str; 10] = [
    "lines between held ends",
    "web of free points",
    "floating body",
    "moved body",
    "buoy of members",
    "rods and pinned bodies",
    "bodies with a shared line",
    "clump on the bed",
    "line paid out",
    "end let go, line that breaks",
];
/// Kinds that differ from others in motion alone.
pub(super) const IN_MOTION_ALONE: usize = 2;

/// Simulated time \[s\].
const DURATION_S: f64 = 5.0;

/// An inclined plane as a grid of depths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plane {
    /// Over x = y = 0 \[m\].
    pub(super) depth: f64,
    /// Change of the depth along x and y \[-\].
    pub(super) by_x: f64,
    /// See `by_x`.
    pub(super) by_y: f64,
}

impl Plane {
    /// Half of the side of the grid \[m\].
    const REACH: f64 = 4e3;

    /// The CSV file.
    pub(super) fn text(&self) -> String {
        let mut text = "x_m,y_m,depth_m\n".to_owned();
        for x in [-1.0, 0.0, 1.0].map(|k| k * Self::REACH) {
            for y in [-1.0, 0.0, 1.0].map(|k| k * Self::REACH) {
                let depth = self.depth + self.by_x * x + self.by_y * y;
                // Writing to a string cannot fail.
                let _ = writeln!(text, "{x:?},{y:?},{depth:?}");
            }
        }
        text
    }

    /// The plane of such a file.
    pub(super) fn read(text: &str) -> Option<Self> {
        let depth = |x: f64, y: f64| {
            let rows = text.lines().filter_map(|row| {
                let mut numbers = row.split(',').map(str::parse::<f64>);
                let mut next = || numbers.next()?.ok();
                Some((next()?, next()?, next()?))
            });
            let mut rows = rows.filter(|row| row.0 == x && row.1 == y);
            rows.next().map(|row| row.2)
        };
        let middle = depth(0.0, 0.0)?;
        Some(Self {
            depth: middle,
            by_x: (depth(Self::REACH, 0.0)? - middle) / Self::REACH,
            by_y: (depth(0.0, Self::REACH)? - middle) / Self::REACH,
        })
    }

    /// The depth over a place \[m\].
    fn at(&self, x: f64, y: f64) -> f64 {
        self.depth + self.by_x * x + self.by_y * y
    }
}

/// A random system of a kind, in motion or at rest.
///
/// # Errors
/// Where what is written is no TOML, which would be a fault here.
pub(super) fn drawn(kind: usize, random: &mut Random, moves: bool) -> Result<Table, String> {
    let mut maker = Maker {
        random,
        text: String::new(),
        moves,
        plane: Plane {
            depth: 0.0,
            by_x: 0.0,
            by_y: 0.0,
        },
        bed: false,
        current: false,
        lines: 0,
        points: 0,
    };
    maker.head();
    match kind {
        0 => maker.held(),
        1 => maker.web(),
        2 => maker.body("free"),
        3 => maker.body("moved"),
        4 => maker.buoy(),
        5 => maker.rods(),
        6 => maker.shared(),
        7 => maker.clump(),
        8 => maker.paid_out(),
        _ => maker.let_go(),
    }
    toml::from_str(&maker.text).map_err(|why| format!("{why}\n{}", maker.text))
}

struct Maker<'a> {
    random: &'a mut Random,
    text: String,
    moves: bool,
    plane: Plane,
    /// Whether there is a bed.
    bed: bool,
    current: bool,
    lines: usize,
    points: usize,
}

impl Maker<'_> {
    fn put(&mut self, words: Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(words);
    }

    /// Water, bed, current, waves, three materials, settings.
    fn head(&mut self) {
        self.plane.depth = self.random.between(40.0, 400.0);
        self.put(format_args!("[system]\ntitle = \"random\"\n"));
        if self.random.chance(0.1) {
            self.put(format_args!("[environment]\nwater_surface = \"crossed\"\n"));
        }
        if self.moves {
            self.put(format_args!("[solver]\nduration_s = {DURATION_S:?}\n"));
        }
        self.bed = self.random.chance(0.75);
        if self.bed {
            self.seabed();
        }
        self.current = self.random.chance(0.55);
        if self.current {
            let (speed, towards) = (
                self.random.between(0.1, 1.2),
                self.random.between(-180.0, 180.0),
            );
            if self.random.chance(0.5) {
                let (low, depth) = (speed * self.random.uniform(), self.plane.depth);
                self.put(format_args!(
                    "[current]\nspeed_m_per_s = [{speed:?}, {low:?}]\ndirection_deg = [{towards:?}, {towards:?}]\ndepth_m = [0.0, {depth:?}]\n"
                ));
            } else {
                self.put(format_args!(
                    "[current]\nspeed_m_per_s = {speed:?}\ndirection_deg = {towards:?}\n"
                ));
            }
        }
        if self.moves && self.random.chance(0.4) {
            self.waves();
        }
        for k in 0..3 {
            self.material(k);
        }
    }

    fn seabed(&mut self) {
        let (stiffness, damping) = (self.random.power(4.3, 5.3), self.random.power(3.0, 4.5));
        let depth = self.plane.depth;
        self.put(format_args!(
            "[seabed]\ndepth_m = {depth:?}\nstiffness_n_per_m3 = {stiffness:?}\ndamping_n_s_per_m3 = {damping:?}\n"
        ));
        if self.random.chance(0.15) {
            (self.plane.by_x, self.plane.by_y) = (
                self.random.between(-0.03, 0.03),
                self.random.between(-0.03, 0.03),
            );
            let plane = self.plane.text();
            self.put(format_args!(
                "depth_file = \"plane.csv\"\n[files.\"plane.csv\"]\ntext = {plane:?}\n"
            ));
        } else if self.random.chance(0.4) {
            let friction = self.random.between(0.1, 1.0);
            self.put(format_args!("friction = {friction:?}\n"));
        }
    }

    fn waves(&mut self) {
        let towards = self.random.between(-180.0, 180.0);
        let (height, period) = (
            self.random.between(0.5, 5.0),
            self.random.between(6.0, 14.0),
        );
        if self.random.chance(0.5) {
            self.put(format_args!(
                "[[waves]]\nkind = \"regular\"\nheight_m = {height:?}\nperiod_s = {period:?}\ndirection_deg = {towards:?}\nramp_s = 3.0\n"
            ));
        } else {
            let seed = self.random.whole(1, 1000);
            self.put(format_args!(
                "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = {height:?}\npeak_period_s = {period:?}\ncomponents = 12\nseed = {seed}\ndirection_deg = {towards:?}\nramp_s = 3.0\n"
            ));
        }
    }

    /// From a floating rope to chain; a rope with a table, or one that bends.
    fn material(&mut self, k: usize) {
        let diameter = self.random.power(-1.7, -0.7);
        let mass = 805.0 * diameter * diameter * self.random.between(0.85, 7.0);
        let ea = self.random.power(6.5, 9.0);
        let (normal, along, damping) = (
            self.random.between(0.5, 2.0),
            self.random.between(0.0, 0.3),
            self.random.between(0.05, 0.5),
        );
        self.put(format_args!(
            "[materials.m{k}]\ndiameter_m = {diameter:?}\nmass_kg_per_m = {mass:?}\ndrag_normal = {normal:?}\n\
             drag_tangential = {along:?}\nadded_mass_normal = 1.0\naxial_damping_ratio = {damping:?}\n"
        ));
        if self.random.chance(0.12) {
            let (low, high) = (0.02 * ea, 0.02 * ea * self.random.between(2.2, 4.0));
            let most = high + (high - low) * 2.0;
            self.put(format_args!(
                "strain = [0.0, 0.02, 0.04, 0.08]\ntension_n = [0.0, {low:?}, {high:?}, {most:?}]\n"
            ));
            return;
        }
        self.put(format_args!("ea_n = {ea:?}\n"));
        if self.random.chance(0.12) {
            let stiffness = ea * diameter * diameter * self.random.power(-3.0, -1.3);
            self.put(format_args!("ei_n_m2 = {stiffness:?}\n"));
        }
    }

    /// The name of a new point and its table so far.
    fn point(&mut self, kind: &str) -> String {
        let name = format!("p{}", self.points);
        self.points += 1;
        self.put(format_args!("[points.{name}]\nkind = \"{kind}\"\n"));
        name
    }

    fn fixed(&mut self, at: [f64; 3]) -> String {
        let name = self.point("fixed");
        let at = self.above_bed(at);
        self.put(format_args!("position_m = {at:?}\n"));
        name
    }

    /// A place no deeper than the bed.
    fn above_bed(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        [x, y, z.max(-self.plane.at(x, y))]
    }

    /// An anchor on the bed, or as deep without one.
    fn anchor(&mut self, x: f64, y: f64) -> String {
        let z = -self.plane.at(x, y);
        self.fixed([x, y, z])
    }

    /// The keys of a motion in harmonics of up to this amplitude \[m\].
    fn motion(&mut self, most: f64) {
        let by = [(); 3].map(|()| self.random.between(-most, most));
        let period = self.random.between(5.0, 14.0);
        self.put(format_args!(
            "amplitude_m = {by:?}\nperiod_s = {period:?}\nramp_s = 3.0\n"
        ));
    }

    /// An upper end: moved in motion, else held.
    fn top(&mut self, at: [f64; 3]) -> String {
        if !self.moves {
            return self.fixed(at);
        }
        let name = self.point("moved");
        self.put(format_args!("position_m = {at:?}\n"));
        self.motion(1.5);
        name
    }

    /// A junction, a clump or a buoy.
    fn free(&mut self) -> String {
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

    fn on(&mut self, body: &str, at: [f64; 3]) -> String {
        let name = self.point("body");
        self.put(format_args!("body = \"{body}\"\nposition_m = {at:?}\n"));
        name
    }

    /// A line between points that are so far apart, with more keys.
    fn line(&mut self, from: &str, to: &str, apart: f64, (low, high): (f64, f64), more: &str) {
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

    /// One or two lines from the bed or from anywhere to an upper end.
    fn held(&mut self) {
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

    fn web(&mut self) {
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

    fn body_of(&mut self, name: &str, kind: &str, x: f64) {
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

    fn member(&mut self, kind: &str, name: &str, from: [f64; 3], to: [f64; 3], diameter: f64) {
        let drag = self.random.between(0.0, 1.2);
        self.put(format_args!(
            "[[{kind}.{name}.members]]\nfrom_m = {from:?}\nto_m = {to:?}\ndiameter_m = {diameter:?}\n\
             drag_normal = {drag:?}\nadded_mass_normal = 1.0\n"
        ));
    }

    /// A body on three lines, of which one may have a bridle.
    fn body(&mut self, kind: &str) {
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
    fn buoy(&mut self) {
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
    fn rods(&mut self) {
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

    fn rod(&mut self, kind: &str, a: [f64; 3], b: [f64; 3], (mass, diameter): (f64, f64)) {
        self.put(format_args!(
            "[rods.r0]\nkind = \"{kind}\"\nend_a_m = {a:?}\nend_b_m = {b:?}\nmass_kg = {mass:?}\ndiameter_m = {diameter:?}\ndrag_normal = 1.0\n"
        ));
    }

    /// Two bodies, each on two lines, with one between them.
    fn shared(&mut self) {
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
    fn clump(&mut self) {
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
    fn paid_out(&mut self) {
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
    fn let_go(&mut self) {
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

fn distance(one: [f64; 3], other: [f64; 3]) -> f64 {
    let squares = one.iter().zip(other).map(|(a, b)| (a - b).powi(2));
    squares.sum::<f64>().sqrt()
}
