//! Random systems whose lines are paid out or hauled in, or run through points that slide along them.

use super::{DURATION_S, MovingSystemWriter};

/// What pays a line out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RandomDrive {
    /// A rate or a table.
    Rate,
    /// The heave of its end, alone or beside a rate.
    Heave,
    /// A winch that keeps a tension.
    Tension,
    /// A winch at a rate, up to a tension.
    GivesWay,
}

impl MovingSystemWriter<'_> {
    /// A line from a top to a load, an anchor, or along the bed, that is paid out.
    pub(super) fn paid_out(&mut self, drive: RandomDrive) {
        let depth = self.depth;
        // Now and then it comes out of the water.
        let deepest = if self.random.chance(0.3) {
            3.0
        } else {
            0.2 * depth
        };
        let height = -self.random.between(0.5, deepest);
        if drive != RandomDrive::Heave && self.random.chance(0.3) {
            self.fixed("top", [0.0, 0.0, height]);
        } else {
            self.moved("top", [0.0, 0.0, height], 2.5);
        }
        let draw = self.random.uniform();
        let (apart, low) = if draw < 0.4 {
            self.loaded("low");
            let length = self.random.between(5.0, 0.9 * (depth + height));
            (length, 1.0)
        } else {
            let deep = if draw < 0.7 {
                1.0
            } else {
                self.random.between(0.2, 0.9)
            };
            let far = self.random.between(0.05, 2.0) * depth;
            self.fixed("low", [far, 0.0, -deep * depth]);
            (
                far.hypot(deep * depth + height),
                self.random.between(0.97, 1.3),
            )
        };
        let length = apart * low;
        let down = self.random.chance(0.5);
        let (from, to) = if down { ("top", "low") } else { ("low", "top") };
        let first = self.line_of_sections(from, to, length);
        let at_top = drive == RandomDrive::Heave || self.random.chance(0.8);
        let end = if at_top == down { "a" } else { "b" };
        let tension = self.wet_weight(first) * length + 1.0;
        self.payout("l0", end, drive, tension);
        // The other end of the same line.
        if self.random.chance(0.15) {
            let other = if end == "a" { "b" } else { "a" };
            self.payout("l0", other, RandomDrive::Rate, tension);
        }
    }

    /// A clump or a buoy, never without mass.
    fn loaded(&mut self, name: &str) {
        let mass = self.random.power(1.0, 4.5);
        let share = if self.random.chance(0.8) { 0.3 } else { 1.2 };
        let volume = share * mass / 1025.0;
        let area = self.random.between(0.0, 3.0) * volume.powf(2.0 / 3.0);
        self.put(format_args!(
            "[points.{name}]\nkind = \"free\"\nmass_kg = {mass:?}\nvolume_m3 = {volume:?}\ndrag_area_m2 = {area:?}\n"
        ));
    }

    /// Weight of a material in water, without its sign \[N/m\].
    fn wet_weight(&self, material: usize) -> f64 {
        self.wet_weights
            .get(material)
            .map_or(1.0, |weight| weight.abs())
    }

    /// A line of one to three sections, of this unstretched length; returns the first material.
    fn line_of_sections(&mut self, from: &str, to: &str, length: f64) -> usize {
        let first = self.lines;
        let count = if self.random.chance(0.5) {
            1
        } else {
            2 + usize::from(self.random.chance(0.3))
        };
        let (segments, rough) = (
            self.random.between(4.0, 50.0).round(),
            self.random.chance(0.5),
        );
        let name = self.lines;
        self.lines += 1;
        self.put(format_args!(
            "[[lines]]\nname = \"l{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nsegments = {segments}\n"
        ));
        if rough {
            let friction = self.random.between(0.1, 1.0);
            self.put(format_args!("friction = {friction:?}\n"));
        }
        for k in 0..count {
            let material = ["one", "two", "three"][(first + k) % 3];
            let part = length / count as f64;
            self.put(format_args!(
                "[[lines.sections]]\nmaterial = \"{material}\"\nlength_m = {part:?}\n"
            ));
            if k + 1 < count && self.random.chance(0.2) {
                let mass = self.random.power(1.0, 3.5);
                self.put(format_args!("clump_kg = {mass:?}\n"));
            }
        }
        first % 3
    }

    /// A payout of an end of a line; tensions are of the size of this one \[N\].
    fn payout(&mut self, line: &str, end: &str, drive: RandomDrive, tension: f64) {
        self.put(format_args!(
            "[[payouts]]\nline = \"{line}\"\nend = \"{end}\"\n"
        ));
        let rate = self.random.power(-1.5, 1.2) * if self.random.chance(0.5) { 1.0 } else { -1.0 };
        let tension = tension * self.random.power(-0.5, 0.7);
        match drive {
            RandomDrive::Rate if self.random.chance(0.3) => {
                let [a, b] = [(); 2].map(|()| 3.0 * self.random.between(-rate.abs(), rate.abs()));
                self.put(format_args!(
                    "table_time_s = [0.0, 2.0, 5.0, {DURATION_S:?}]\ntable_m = [0.0, 0.0, {a:?}, {b:?}]\n"
                ));
            }
            RandomDrive::Rate => self.rate(rate),
            RandomDrive::Heave => {
                let share = self.random.between(0.5, 1.2);
                self.put(format_args!("heave_compensation = {share:?}\n"));
                if self.random.chance(0.5) {
                    self.rate(rate);
                }
            }
            RandomDrive::Tension => {
                self.put(format_args!("tension_n = {tension:?}\n"));
                if self.random.chance(0.5) {
                    let fastest = self.random.power(-1.0, 0.7);
                    self.put(format_args!("greatest_rate_m_per_s = {fastest:?}\n"));
                }
                self.drum();
            }
            RandomDrive::GivesWay => {
                self.put(format_args!(
                    "rate_m_per_s = {rate:?}\ngreatest_tension_n = {tension:?}\n"
                ));
                self.drum();
            }
        }
    }

    fn rate(&mut self, rate: f64) {
        let (start, ramp) = (self.random.between(0.0, 3.0), self.random.between(0.2, 4.0));
        self.put(format_args!(
            "rate_m_per_s = {rate:?}\nstart_s = {start:?}\nramp_s = {ramp:?}\n"
        ));
        if self.random.chance(0.3) {
            let stop = start + self.random.between(0.5, 4.0);
            self.put(format_args!("stop_s = {stop:?}\n"));
        }
    }

    fn drum(&mut self) {
        let (mass, ramp) = (self.random.power(1.0, 4.0), self.random.between(0.2, 4.0));
        self.put(format_args!("drum_mass_kg = {mass:?}\nramp_s = {ramp:?}\n"));
    }

    /// A load that slides along a line between two points, one of which may move, and that a third line may haul.
    pub(super) fn bead(&mut self) {
        let depth = self.depth;
        let (span, low) = (
            self.random.between(0.1, 1.5) * depth,
            self.random.between(0.05, 0.5) * depth,
        );
        self.moved("left", [0.0, 0.0, -0.1 * depth], 2.0);
        self.fixed("right", [span, 0.0, -low]);
        self.loaded("bead");
        let (share, slack) = (
            self.random.between(0.2, 0.8),
            self.random.between(1.02, 1.4),
        );
        let length = slack * span.hypot(low - 0.1 * depth);
        // Of one material at the bead.
        let turned = self.random.chance(0.5);
        let (from, to) = if turned {
            ("bead", "left")
        } else {
            ("left", "bead")
        };
        for (from, to, length) in [
            (from, to, share * length),
            ("bead", "right", (1.0 - share) * length),
        ] {
            let name = self.lines;
            self.lines += 1;
            let segments = self.random.between(4.0, 20.0).round();
            self.put(format_args!(
                "[[lines]]\nname = \"l{name}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"one\"\nlength_m = {length:?}\nsegments = {segments}\n"
            ));
        }
        self.sliding("bead", "l0", "l1");
        if self.random.chance(0.4) {
            self.fixed("hauler", [0.5 * span, 0.3 * span, -0.1 * depth]);
            let length = self.random.between(0.9, 1.3) * span;
            self.line_of_sections("hauler", "bead", length);
            let tension = self.wet_weight(2) * length + 1.0;
            self.payout("l2", "a", RandomDrive::Rate, tension);
        }
        if self.random.chance(0.2) {
            let end = if turned { "b" } else { "a" };
            self.payout("l0", end, RandomDrive::Rate, 1.0);
        }
    }

    fn sliding(&mut self, point: &str, line: &str, other: &str) {
        self.put(format_args!(
            "[[sliding_points]]\npoint = \"{point}\"\nline = \"{line}\"\nother = \"{other}\"\n"
        ));
        if self.random.chance(0.4) {
            let friction = self.random.power(0.0, 4.0);
            self.put(format_args!("friction_n = {friction:?}\n"));
        }
        if self.random.chance(0.4) {
            let friction = self.random.power(-2.0, -0.3);
            self.put(format_args!("friction = {friction:?}\n"));
        }
        let ramp = self.random.between(0.2, 4.0);
        self.put(format_args!("ramp_s = {ramp:?}\n"));
    }

    /// A body that floats on three lines: winches on it, or a line that runs through a point of it.
    pub(super) fn winches_on_body(&mut self) {
        let kind = if self.random.chance(0.7) {
            "free"
        } else {
            "moved"
        };
        self.body(kind);
        let tension = self.wet_weight(0) * self.depth + 1.0;
        for line in ["l0", "l1"] {
            let draw = self.random.uniform();
            let drive = match draw {
                _ if draw < 0.3 => RandomDrive::Rate,
                _ if draw < 0.6 => RandomDrive::Tension,
                _ if draw < 0.8 => RandomDrive::GivesWay,
                _ => continue,
            };
            let end = if self.random.chance(0.8) { "b" } else { "a" };
            self.payout(line, end, drive, tension);
        }
        if kind == "free" && self.random.chance(0.5) {
            self.on("pulley", "hull", [-10.0, 3.0, -4.0]);
            let (depth, far) = (self.depth, self.random.between(1.0, 2.0) * self.depth);
            self.fixed("p0", [-far, far, -depth]);
            self.moved("p1", [-60.0, 20.0, -5.0], 2.0);
            let (first, slack) = (
                (far - 10.0).hypot(far).hypot(depth),
                self.random.between(1.0, 1.1),
            );
            let name = self.lines;
            for (k, (from, to, length)) in [
                ("p0", "pulley", slack * first),
                ("pulley", "p1", 1.1 * 53.0),
            ]
            .into_iter()
            .enumerate()
            {
                self.put(format_args!(
                    "[[lines]]\nname = \"l{}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"two\"\nlength_m = {length:?}\nsegments = 12\n",
                    name + k
                ));
            }
            self.lines += 2;
            self.sliding("pulley", &format!("l{name}"), &format!("l{}", name + 1));
        }
    }
}
