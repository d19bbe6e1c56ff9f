//! Random systems whose lines are divided into segments, as files: in a current, with bending stiffness, with tables of tension by strain,
//! beside lines of closed form.

use std::fmt::Write;

use crate::numerics::random::Random;

/// The kinds of random files, in turn.
pub const DIVIDED_KINDS: [&str; 6] = [
    "floating platform",
    "junction of three lines",
    "platform with bridles",
    "shared line between platforms",
    "line with a buoyant part",
    "chain of free points",
];

/// A random system of a kind, as a file.
#[must_use]
pub fn divided(kind: usize, random: &mut Random) -> String {
    let mut maker = FileMaker {
        random,
        text: String::new(),
        depth: 0.0,
        lines: 0,
    };
    maker.head(kind);
    match kind {
        0 => maker.platform(false),
        1 => maker.junction(),
        2 => maker.platform(true),
        3 => maker.shared(),
        4 => maker.lazy_wave(),
        _ => maker.free_points(),
    }
    maker.text
}

struct FileMaker<'a> {
    random: &'a mut Random,
    text: String,
    depth: f64,
    lines: usize,
}

impl FileMaker<'_> {
    fn put(&mut self, words: std::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.text.write_fmt(words);
    }

    /// Water, bed, current, materials: chain, rope, cable, floating.
    fn head(&mut self, kind: usize) {
        self.depth = self.random.between(40.0, 400.0);
        let depth = self.depth;
        self.put(format_args!("[system]\ntitle = \"random\"\n"));
        let on_bed = kind != 5 && self.random.chance(0.8);
        if on_bed {
            let stiffness = self.random.power(4.0, 6.0);
            self.put(format_args!(
                "[seabed]\ndepth_m = {depth:?}\nstiffness_n_per_m3 = {stiffness:?}\n"
            ));
        }
        let flows = self.random.chance(0.6);
        if flows {
            let [fast, slow] = [(); 2].map(|()| self.random.between(0.1, 1.2));
            let [one, two] = [(); 2].map(|()| self.random.between(-180.0, 180.0));
            self.put(format_args!(
                "[current]\nspeed_m_per_s = [{fast:?}, {slow:?}]\ndirection_deg = [{one:?}, {two:?}]\ndepth_m = [0.0, {depth:?}]\n"
            ));
        }
        for (name, lightest, heaviest) in
            [("chain", 5.0, 9.0), ("rope", 1.1, 3.0), ("float", 0.5, 0.9)]
        {
            let diameter = self.random.power(-1.7, -0.7);
            let mass = 805.0 * diameter * diameter * self.random.between(lightest, heaviest);
            let (ea, normal, along) = (
                self.random.power(6.0, 9.0),
                self.random.between(0.3, 2.4),
                self.random.between(0.0, 0.4),
            );
            self.put(format_args!(
                "[materials.{name}]\ndiameter_m = {diameter:?}\nmass_kg_per_m = {mass:?}\nea_n = {ea:?}\ndrag_normal = {normal:?}\ndrag_tangential = {along:?}\n"
            ));
            // Without a current, some line is divided for its bending stiffness.
            if self.random.chance(0.4) || (!flows && name == "chain") {
                let bending = self.random.power(0.0, 4.5);
                self.put(format_args!("ei_n_m2 = {bending:?}\n"));
            }
        }
    }

    fn fixed(&mut self, name: &str, [x, y, z]: [f64; 3]) {
        self.put(format_args!(
            "[points.{name}]\nkind = \"fixed\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"
        ));
    }

    fn on(&mut self, name: &str, body: &str, [x, y, z]: [f64; 3]) {
        self.put(format_args!(
            "[points.{name}]\nkind = \"body\"\nbody = \"{body}\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"
        ));
    }

    /// A free point: a junction, a clump or a buoy.
    fn free(&mut self, name: &str, [x, y, z]: [f64; 3]) {
        self.put(format_args!(
            "[points.{name}]\nkind = \"free\"\nposition_m = [{x:?}, {y:?}, {z:?}]\n"
        ));
        let mass = self.random.power(1.0, 4.0);
        let share = match self.random.between(0.0, 3.0) {
            draw if draw < 1.0 => return,
            draw if draw < 2.0 => 0.2,
            _ => self.random.between(1.2, 3.0),
        };
        let (volume, area) = (share * mass / 1025.0, self.random.between(0.0, 2.0));
        self.put(format_args!(
            "mass_kg = {mass:?}\nvolume_m3 = {volume:?}\ndrag_area_m2 = {area:?}\n"
        ));
    }

    /// A line of these shares of materials between points that are so far apart, in 20 to 120 segments.
    fn line(&mut self, from: &str, to: &str, length: f64, sections: &[(&str, f64)]) {
        let (name, segments) = (self.lines, self.random.power(1.3, 2.1).round());
        self.lines += 1;
        self.put(format_args!(
            "[[lines]]\nname = \"l{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nsegments = {segments}\n"
        ));
        for (material, share) in sections {
            let length = length * share;
            self.put(format_args!(
                "[[lines.sections]]\nmaterial = \"{material}\"\nlength_m = {length:?}\n"
            ));
        }
    }

    /// The sections of a line from its lower end.
    fn sections(&mut self) -> Vec<(&'static str, f64)> {
        let share = self.random.between(0.2, 0.8);
        match self.random.between(0.0, 5.0) {
            draw if draw < 1.5 => vec![("chain", 1.0)],
            draw if draw < 3.0 => vec![("rope", 1.0)],
            draw if draw < 4.0 => vec![("chain", share), ("rope", 1.0 - share)],
            _ => vec![("rope", share), ("chain", 1.0 - share)],
        }
    }

    fn hull(&mut self, name: &str, x: f64) {
        let mass = self.random.power(5.0, 7.0);
        let volume = mass / 1025.0 * self.random.between(1.0, 1.1);
        let spring = 1025.0 * 9.8 * volume / self.random.between(3.0, 15.0);
        let (roll, yaw) = (
            spring * self.random.between(10.0, 100.0),
            self.random.between(0.0, 360.0),
        );
        self.put(format_args!(
            "[bodies.{name}]\nkind = \"free\"\nposition_m = [{x:?}, 0.0, 0.0]\nyaw_deg = {yaw:?}\nmass_kg = {mass:?}\nvolume_m3 = {volume:?}\n\
             centre_of_gravity_m = [0.0, 0.0, -2.0]\ncentre_of_buoyancy_m = [0.0, 0.0, -2.5]\n\
             waterplane_stiffness = [0.0, 0.0, {spring:?}, {roll:?}, {roll:?}, 0.0]\ndrag_area_m2 = [20.0, 20.0, 50.0]\n"
        ));
    }

    /// Three or four lines from a floating platform to anchors, all or some of them in two parts above.
    fn platform(&mut self, bridled: bool) {
        let depth = self.depth;
        self.hull("hull", 0.0);
        let count = if self.random.chance(0.5) { 3 } else { 4 };
        for k in 0..count {
            let angle = std::f64::consts::TAU * (f64::from(k) + self.random.between(0.0, 0.3))
                / f64::from(count);
            let (sin, cos) = angle.sin_cos();
            let far = self.random.between(1.0, 3.0) * depth;
            let anchor = format!("a{k}");
            self.fixed(&anchor, [far * cos, far * sin, -depth]);
            let span = (far - 8.0).hypot(depth - 5.0);
            let slack = self.random.between(0.995, 1.12);
            let sections = self.sections();
            if !bridled {
                let fairlead = format!("f{k}");
                self.on(&fairlead, "hull", [8.0 * cos, 8.0 * sin, -5.0]);
                self.line(&anchor, &fairlead, slack * span, &sections);
                continue;
            }
            let junction = format!("j{k}");
            let near = 0.25 * far;
            self.free(&junction, [near * cos, near * sin, -0.3 * depth]);
            self.line(&anchor, &junction, 0.78 * slack * span, &sections);
            for side in [-1.0, 1.0] {
                let fairlead = format!("f{k}{}", if side < 0.0 { "s" } else { "n" });
                let place = [
                    8.0 * cos - 5.0 * side * sin,
                    8.0 * sin + 5.0 * side * cos,
                    -5.0,
                ];
                self.on(&fairlead, "hull", place);
                self.line(&junction, &fairlead, 0.23 * slack * span, &[("rope", 1.0)]);
            }
        }
    }

    /// A free point between three or four fixed ones.
    fn junction(&mut self) {
        let depth = self.depth;
        self.free("j", [0.0, 0.0, -0.4 * depth]);
        let count = if self.random.chance(0.6) { 3 } else { 4 };
        for k in 0..count {
            let angle = std::f64::consts::TAU * (f64::from(k) + self.random.between(0.0, 0.4))
                / f64::from(count);
            let (far, deep) = (
                self.random.between(0.3, 2.0) * depth,
                self.random.between(0.02, 1.0) * depth,
            );
            let end = format!("e{k}");
            self.fixed(&end, [far * angle.cos(), far * angle.sin(), -deep]);
            let span = far.hypot(deep - 0.4 * depth);
            let (slack, sections) = (self.random.between(0.97, 1.4), self.sections());
            self.line(&end, "j", slack * span, &sections);
        }
    }

    /// Two floating platforms with two anchored lines each and one between them.
    fn shared(&mut self) {
        let (depth, apart) = (self.depth, self.random.between(60.0, 400.0));
        for (name, side) in [("west", -1.0), ("east", 1.0)] {
            let x = 0.5 * side * apart;
            self.hull(name, x);
            for across in [-1.0, 1.0] {
                let word = if across < 0.0 { "s" } else { "n" };
                let (anchor, on) = (format!("{name}-a{word}"), format!("{name}-b{word}"));
                self.fixed(&anchor, [x + side * depth, across * depth, -depth]);
                self.on(&on, name, [6.0 * side, 6.0 * across, -5.0]);
                let span = (std::f64::consts::SQRT_2 * (depth - 6.0)).hypot(depth - 5.0);
                let (slack, sections) = (self.random.between(0.99, 1.1), self.sections());
                self.line(&anchor, &on, slack * span, &sections);
            }
            self.on(&format!("{name}-in"), name, [-6.0 * side, 0.0, -5.0]);
        }
        let slack = self.random.between(1.0, 1.3);
        self.line(
            "west-in",
            "east-in",
            slack * (apart - 12.0),
            &[("rope", 1.0)],
        );
    }

    /// A line from the bed to a hull whose middle floats, beside two moorings of the hull.
    fn lazy_wave(&mut self) {
        let depth = self.depth;
        self.hull("hull", 0.0);
        let far = self.random.between(0.8, 2.0) * depth;
        self.fixed("foot", [far, 0.0, -depth]);
        self.on("hang", "hull", [5.0, 0.0, -5.0]);
        let slack = self.random.between(1.1, 1.6);
        let (low, middle) = (self.random.between(0.2, 0.4), self.random.between(0.1, 0.3));
        let sections = [
            ("rope", low),
            ("float", middle),
            ("rope", 1.0 - low - middle),
        ];
        self.line("foot", "hang", slack * far.hypot(depth), &sections);
        for side in [-1.0, 1.0] {
            let word = if side < 0.0 { "s" } else { "n" };
            let (anchor, on) = (format!("a{word}"), format!("b{word}"));
            self.fixed(&anchor, [-1.5 * depth, 1.5 * side * depth, -depth]);
            self.on(&on, "hull", [-5.0, 5.0 * side, -5.0]);
            let (slack, sections) = (self.random.between(1.0, 1.08), self.sections());
            self.line(&anchor, &on, slack * 2.34 * depth, &sections);
        }
    }

    /// Free points in a row between two fixed ones.
    fn free_points(&mut self) {
        let depth = self.depth;
        let span = self.random.between(0.5, 2.0) * depth;
        let count = if self.random.chance(0.5) { 1 } else { 2 };
        self.fixed("p0", [0.0, 0.0, -0.1 * depth]);
        let last = self.random.between(0.1, 0.9);
        self.fixed("end", [span, 0.0, -last * depth]);
        let mut before = "p0".to_owned();
        let each = span.hypot((last - 0.1) * depth) / f64::from(count + 1);
        for k in 1..=count {
            let next = format!("p{k}");
            let x = span * f64::from(k) / f64::from(count + 1);
            self.free(&next, [x, 0.0, -0.5 * depth]);
            let (slack, sections) = (self.random.between(0.98, 1.3), self.sections());
            self.line(&before, &next, slack * each, &sections);
            before = next;
        }
        let (slack, sections) = (self.random.between(0.98, 1.3), self.sections());
        self.line(&before, "end", slack * each, &sections);
    }
}
