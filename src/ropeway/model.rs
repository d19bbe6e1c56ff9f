//! A ropeway as the user words it: one struct a table of the file, one field a key.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;

use crate::case::{Direction, Mark};
use crate::reference::PublishedNumber;

/// Everything a ropeway file says. The platform stands at x = 0 and holds end A, the ship holds end B
/// at the span; z = 0 is still water.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ropeway {
    /// What the ropeway is, and what holds for it as a whole.
    #[serde(rename = "ropeway")]
    pub about: About,
    /// The ropes, side by side.
    #[serde(rename = "rope")]
    pub ropes: Vec<Rope>,
    /// End A: what does not move.
    pub platform: Support,
    /// End B.
    pub ship: Support,
    /// What is carried.
    pub cargo: Cargo,
    /// How the rope is set.
    pub setting: Setting,
    /// The water below.
    #[serde(default)]
    pub water: Water,
    /// The winch on the ship; absent: the rope is made fast.
    pub winch: Option<Winch>,
    /// The motion of the rope's hang point on the ship; absent: it lies still.
    pub motion: Option<Motion>,
    /// The cargo's own motion.
    #[serde(default)]
    pub dynamics: Dynamics,
    /// The rope as a finite-element check had it; absent: there is none.
    pub finite_element: Option<FiniteElement>,
    /// Where inputs come from, by key path: published inputs need no mark.
    #[serde(default)]
    pub marks: BTreeMap<String, Mark>,
    /// Published values the ropeway is held against.
    #[serde(default)]
    pub published: Vec<PublishedNumber>,
    /// Published statements of trend.
    #[serde(default)]
    pub trend: Vec<Trend>,
}

/// What the ropeway is, and what holds for it as a whole.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// One line.
    pub title: String,
    /// Where the data come from.
    #[serde(default)]
    pub source: String,
    /// A few sentences: what is missing in the source, what was decided.
    #[serde(default)]
    pub notes: String,
    /// Horizontal distance from platform to ship \[m\].
    pub span_m: f64,
    /// Mass per length of all ropes together \[kg/m\]; absent: the sum of the ropes.
    pub mass_kg_per_m: Option<f64>,
    /// Gravity \[m/s²\].
    #[serde(default = "standard_gravity")]
    pub gravity_m_per_s2: f64,
    /// Segments of the discretised line.
    #[serde(default = "segments")]
    pub segments: usize,
}

/// One of the ropes. They hang as one: their weights and stiffnesses add.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rope {
    /// Name.
    pub name: String,
    /// Diameter \[m\].
    pub diameter_m: f64,
    /// Mass per length \[kg/m\].
    pub mass_kg_per_m: f64,
    /// Axial stiffness EA \[N\].
    pub ea_n: f64,
    /// Length there is of it \[m\].
    pub length_m: f64,
    /// Tension at which it breaks \[N\].
    pub break_load_n: Option<f64>,
}

/// What holds an end of the rope.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Height of the rope's hang point above still water \[m\].
    pub height_m: f64,
}

/// What is carried.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cargo {
    /// Its mass, with trolley and hook \[kg\].
    pub mass_kg: f64,
    /// Where it hangs: 0 at the platform, 1 at the ship \[-\].
    #[serde(default = "half")]
    pub position: f64,
    /// How far its lower side hangs below the rope \[m\].
    #[serde(default)]
    pub drop_m: f64,
    /// Speed at which it is hauled \[m/s\].
    #[serde(default = "one")]
    pub speed_m_per_s: f64,
}

/// How the rope is set before anything moves.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// What is given.
    pub by: By,
    /// Sag below the straight line between the ends, at mid-span \[m\].
    pub sag_m: Option<f64>,
    /// Unstretched length between the ends \[m\].
    pub length_m: Option<f64>,
    /// Tension at the ship \[N\].
    pub tension_n: Option<f64>,
}

/// What the rope is set by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum By {
    /// Sag of the rope without cargo.
    BareSag,
    /// Sag with the cargo at mid-span.
    LoadedSag,
    /// Unstretched length.
    Length,
    /// Tension at the ship with the cargo where it is: the winch pays out and hauls in.
    Tension,
}

impl fmt::Display for By {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::BareSag => "sag of the bare rope",
            Self::LoadedSag => "sag with the cargo at mid-span",
            Self::Length => "length",
            Self::Tension => "tension at the ship",
        })
    }
}

/// The water below.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Water {
    /// Height of the wave crests that the cargo must clear \[m\].
    pub crest_m: f64,
}

/// A winch that keeps the tension at the ship.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Winch {
    /// Tension it keeps \[N\]; absent: that of the setting, with the cargo on.
    pub tension_n: Option<f64>,
    /// Greatest speed of the rope \[m/s\]; absent: no limit.
    pub speed_m_per_s: Option<f64>,
    /// Greatest power \[W\]; absent: no limit.
    pub power_w: Option<f64>,
}

/// Motion of the rope's hang point on the ship: harmonic away from the platform and upwards.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motion {
    /// Amplitude away from the platform \[m\].
    #[serde(default)]
    pub surge_m: f64,
    /// Its period \[s\].
    #[serde(default = "ten")]
    pub surge_period_s: f64,
    /// Amplitude upwards \[m\].
    #[serde(default)]
    pub heave_m: f64,
    /// Its period \[s\].
    #[serde(default = "ten")]
    pub heave_period_s: f64,
}

/// The cargo's own motion on the rope.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Dynamics {
    /// Damping ratio ζ of the cargo's up-and-down motion \[-\].
    pub damping_ratio: f64,
    /// Time that is followed \[s\].
    pub duration_s: f64,
}

impl Default for Dynamics {
    fn default() -> Self {
        Self {
            damping_ratio: 0.05,
            duration_s: 60.0,
        }
    }
}

/// The rope as a finite-element check had it: a round bar.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FiniteElement {
    /// Radius of the bar \[m\].
    pub radius_m: f64,
    /// Its density \[kg/m³\].
    pub density_kg_per_m3: f64,
    /// End tension that the check gave \[N\].
    pub tension_n: f64,
}

/// A published statement of trend, checked along values of a key.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Trend {
    /// The statement, in words.
    pub name: String,
    /// The key that is varied.
    pub key: String,
    /// Its values, growing.
    pub values: Vec<f64>,
    /// The quantity that is looked at.
    pub quantity: String,
    /// What it does as the values grow.
    pub expect: Direction,
    /// Where it is printed.
    pub source: String,
    /// Why it is out of reach; the row then reads DIFFERS instead of FAIL.
    pub out_of_reach: Option<String>,
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

fn standard_gravity() -> f64 {
    9.80665
}

fn segments() -> usize {
    80
}

fn half() -> f64 {
    0.5
}

fn one() -> f64 {
    1.0
}

fn ten() -> f64 {
    10.0
}
