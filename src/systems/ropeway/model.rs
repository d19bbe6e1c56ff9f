//! A ropeway as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;
use std::fmt;

use crate::case::fields::ValueType::Name;
use crate::case::fields::{Range, of, positive};
use crate::case::schema::{table, words};

const LENGTH: Range = positive(1e4);
const FORCE: Range = positive(1e9);

use crate::case::{Direction, Mark};
use crate::published::PublishedNumber;

table! {
    /// Everything a ropeway file says. The platform stands at x = 0 and holds end A, the ship holds end B
    /// at the span; z = 0 is still water.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Ropeway => RopewayKeys {}
    tables {
        /// What the ropeway is, and what holds for it as a whole.
        about: RopewayInfo as "ropeway";
        /// The ropes, side by side; they hang as one.
        ropes: Vec<Rope> as "rope", required;
        /// End A: what does not move.
        platform: Support;
        /// End B: the ship, with the winch.
        ship: Support;
        /// What is carried.
        cargo: Cargo;
        /// How the rope is set before anything moves.
        setting: RopeSetting;
        /// The water below.
        water: WaterBelow, optional;
        /// A winch that keeps the tension at the ship.
        winch: Option<Winch>;
        /// The motion of the rope's hang point on the ship.
        motion: Option<HangPointMotion>;
        /// The cargo's own motion on the rope.
        dynamics: Dynamics, optional;
        /// The rope as a finite-element check had it: a round bar.
        finite_element: Option<FiniteElement>;
        /// Where an input comes from that the source does not print.
        marks: BTreeMap<String, Mark>;
        /// A published value the ropeway is held against.
        published: Vec<PublishedNumber>;
        /// A published statement of trend, checked along values of a key.
        trend: Vec<RopewayTrend>;
    }
}

table! {
    /// What the ropeway is, and what holds for it as a whole.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RopewayInfo => AboutKeys {
        /// What the ropeway is, in one line.
        title: String, "title";
        /// Where the data come from.
        source: String = "", "source";
        /// What is missing in the source, what was decided.
        notes: String = "", "notes";
        /// Horizontal distance from platform to ship.
        span_m: f64, "span", range LENGTH;
        /// Mass per length of all ropes together.
        mass_kg_per_m: Option<f64>, "mass of all ropes", range positive(1e4), absent "the sum of the ropes";
        /// Gravity, for weights.
        gravity_m_per_s2: f64 = 9.80665, "gravity", range positive(100.0);
        /// Segments of the discretised line.
        segments: usize = 80, "segments", range of(4.0, 2000.0);
        /// Why the tolerances of the published values are what they are, where a value states no reason of its own.
        tolerance_reason: Option<String>, "reason of the tolerances", absent "none stated";
    }
}

table! {
    /// One of the ropes. They hang as one: their weights and stiffnesses add.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Rope => RopeKeys {
        /// Name of the rope.
        name: String, "name", kind Name;
        /// Diameter of the rope.
        diameter_m: f64, "diameter", range positive(1.0);
        /// Mass per length of the rope.
        mass_kg_per_m: f64, "mass", range positive(1e3);
        /// EA of the rope.
        ea_n: f64, "axial stiffness", range of(1e3, 1e13);
        /// Length there is of the rope: no more can be paid out.
        length_m: f64, "length there is", range LENGTH;
        /// Tension at which the rope breaks.
        break_load_n: Option<f64>, "breaking load", range FORCE, absent "not checked";
    }
}

table! {
    /// What holds an end of the rope.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Support => SupportKeys {
        /// Height of the rope's hang point above still water.
        height_m: f64, "height", range of(0.0, 1e3);
    }
}

table! {
    /// What is carried.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Cargo => CargoKeys {
        /// Mass of the cargo with trolley and hook.
        mass_kg: f64, "mass", range of(0.0, 1e6);
        /// Where it hangs: 0 at the platform, 1 at the ship.
        position: f64 = 0.5, "position", range of(0.0, 1.0);
        /// How far its lower side hangs below the rope.
        drop_m: f64 = 0.0, "drop", range of(0.0, 100.0);
        /// Speed at which it is hauled along the rope.
        speed_m_per_s: f64 = 1.0, "speed", range positive(100.0);
    }
}

table! {
    /// How the rope is set before anything moves.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RopeSetting => SettingKeys {
        /// What is given: a sag, the horizontal tension of the bare rope, the length, or the tension that the winch keeps.
        by: SetBy, "set by";
        /// Sag at mid-span below the straight line between the ends.
        sag_m: Option<f64>, "sag", range LENGTH, absent "needed where a sag sets the rope";
        /// Horizontal tension of the rope without cargo.
        horizontal_n: Option<f64>, "horizontal tension", range FORCE, absent "needed where it sets the rope";
        /// Unstretched length between the ends.
        length_m: Option<f64>, "length", range LENGTH, absent "needed where the length sets the rope";
        /// Tension at the ship, with the cargo where it is.
        tension_n: Option<f64>, "tension", range FORCE, absent "needed where the tension sets the rope";
    }
}

words! {
    /// What the rope is set by.
    pub enum SetBy {
        /// Sag of the rope without cargo.
        BareSag = "bare-sag",
        /// Sag with the cargo at mid-span.
        LoadedSag = "loaded-sag",
        /// Horizontal tension of the rope without cargo.
        BareHorizontal = "bare-horizontal",
        /// Unstretched length.
        Length = "length",
        /// Tension at the ship with the cargo where it is: the winch pays out and hauls in.
        Tension = "tension",
    }
}

impl fmt::Display for SetBy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::BareSag => "sag of the bare rope",
            Self::LoadedSag => "sag with the cargo at mid-span",
            Self::BareHorizontal => "horizontal tension of the bare rope",
            Self::Length => "length",
            Self::Tension => "tension at the ship",
        })
    }
}

table! {
    /// The water below.
    #[derive(Debug, Clone, PartialEq)]
    pub struct WaterBelow => WaterKeys {
        /// Height of the wave crests that the cargo must clear.
        crest_m: f64 = 0.0, "wave crest", range of(0.0, 50.0);
    }
}

table! {
    /// A winch that keeps the tension at the ship.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Winch => WinchKeys {
        /// Tension that the winch keeps at the ship.
        tension_n: Option<f64>, "tension kept", range FORCE, absent "that of the setting, with the cargo on";
        /// Greatest speed at which the winch moves the rope.
        speed_m_per_s: Option<f64>, "greatest speed", range positive(100.0), absent "no limit";
        /// Greatest power of the winch: tension times speed.
        power_w: Option<f64>, "greatest power", range positive(1e9), absent "no limit";
    }
}

table! {
    /// Motion of the rope's hang point on the ship: harmonic away from the platform and upwards.
    #[derive(Debug, Clone, PartialEq)]
    pub struct HangPointMotion => MotionKeys {
        /// Amplitude away from the platform.
        surge_m: f64 = 0.0, "surge", range of(0.0, 1e3);
        /// Period of the motion away from the platform.
        surge_period_s: f64 = 10.0, "period of surge", range of(0.1, 1e4);
        /// Amplitude upwards.
        heave_m: f64 = 0.0, "heave", range of(0.0, 1e3);
        /// Period of the motion upwards.
        heave_period_s: f64 = 10.0, "period of heave", range of(0.1, 1e4);
    }
}

table! {
    /// The cargo's own motion on the rope.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Dynamics => DynamicsKeys {
        /// Damping ratio of the cargo's up-and-down motion.
        damping_ratio: f64 = 0.05, "damping ratio", range of(0.0, 1.0);
        /// Time that is followed.
        duration_s: f64 = 60.0, "duration", range positive(1e5);
    }
}

table! {
    /// The rope as a finite-element check had it: a round bar.
    #[derive(Debug, Clone, PartialEq)]
    pub struct FiniteElement => FiniteElementKeys {
        /// Radius of the bar that stands for the ropes.
        radius_m: f64, "radius", range positive(1.0);
        /// Density of the bar.
        density_kg_per_m3: f64, "density", range positive(3e4);
        /// End tension that the check gave.
        tension_n: f64, "tension", range FORCE;
    }
}

table! {
    /// A published statement of trend, checked along values of a key.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RopewayTrend => TrendKeys {
        /// The statement, in words.
        name: String, "name";
        /// The key that is varied.
        key: String, "key";
        /// Its values, growing.
        values: Vec<f64>, "values", unit "";
        /// The quantity that is looked at.
        quantity: String, "quantity";
        /// What the quantity does as the values grow.
        expect: Direction, "expect";
        /// Where it is printed.
        source: String, "source";
        /// What else the reader must know.
        note: Option<String>, "note", absent "no note";
        /// Why the statement cannot be reached; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "not used";
    }
}

impl Ropeway {
    /// Weight per length of all ropes together \[N/m\].
    #[must_use]
    pub fn weight_n_per_m(&self) -> f64 {
        let sum = || self.ropes.iter().map(|rope| rope.mass_kg_per_m).sum();
        self.about.mass_kg_per_m.unwrap_or_else(sum) * self.about.gravity_m_per_s2
    }

    /// Axial stiffness EA of all ropes together \[N\].
    #[must_use]
    pub fn ea_n(&self) -> f64 {
        self.ropes.iter().map(|rope| rope.ea_n).sum()
    }

    /// Weight of the cargo \[N\].
    #[must_use]
    pub fn cargo_n(&self) -> f64 {
        self.cargo.mass_kg * self.about.gravity_m_per_s2
    }

    /// Height of the ship's hang point above the platform's \[m\]: h of the paper.
    #[must_use]
    pub fn rise_m(&self) -> f64 {
        self.ship.height_m - self.platform.height_m
    }

    /// Length of the shortest rope \[m\]: no more can lie between the ends.
    #[must_use]
    pub fn stored_m(&self) -> f64 {
        let lengths = self.ropes.iter().map(|rope| rope.length_m);
        lengths.fold(f64::INFINITY, f64::min)
    }
}
