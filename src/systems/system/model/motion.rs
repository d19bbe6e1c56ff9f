//! How a system is computed in time, and what is recorded.

use crate::case::fields::ValueType::Name;
use crate::case::fields::{Conditions, of, positive};
use crate::case::schema::{table, words};

words! {
    /// Where what is free begins a run in time.
    #[derive(Default)]
    pub enum StartPlacement {
        /// Where it rests.
        #[default]
        Equilibrium = "equilibrium",
        /// Where the file puts it: held there while everything else comes to rest, and let go at time zero.
        Given = "given",
    }
}

const PLACED: Conditions = &[("placement", &["given"])];

table! {
    /// Where a run in time begins. Points, bodies and rods have offsets from there and velocities of their own.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SystemStart => SystemStartKeys {
        /// Where free points, free and pinned bodies and rods begin.
        placement: StartPlacement = StartPlacement::Equilibrium, "start placement";
        /// Those that begin where the file puts them; all others begin at rest.
        parts: Option<Vec<String>>, "parts placed", absent "all that are free or pinned", matters PLACED;
    }
}

words! {
    /// An end of a line.
    #[derive(Default)]
    pub enum WhichEnd {
        /// Its end A.
        #[default]
        A = "a",
        /// Its end B.
        B = "b",
    }
}

impl WhichEnd {
    /// 0 for A and 1 for B.
    #[must_use]
    pub fn index(self) -> usize {
        usize::from(self == Self::B)
    }
}

table! {
    /// A line that is paid out or hauled in at one of its ends, in motion: at a rate, by a table, against the heave of that end, or by a winch.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PayoutInputs => PayoutKeys {
        /// The line.
        line: String, "line", kind Name;
        /// The end that it is paid out of.
        end: WhichEnd = WhichEnd::A, "end";
        /// Unstretched length paid out a second; negative hauls in.
        rate_m_per_s: Option<f64>, "payout rate", range of(-100.0, 100.0), absent "by another key";
        /// Time at which the rate sets in.
        start_s: f64 = 0.0, "start", range of(0.0, 1e6);
        /// Time at which the rate begins to fall to nothing.
        stop_s: Option<f64>, "stop", range of(0.0, 1e6), absent "at the end of the run";
        /// A rate grows over this time and falls over it, a table grows in, a winch is let go.
        ramp_s: f64 = 1.0, "ramp", range positive(1e6);
        /// Times of a payout by table: from 0 to the end of the run; a spline through its rows.
        table_time_s: Vec<f64>, "times of the table", range of(0.0, 1e6), absent "no table";
        /// Unstretched length paid out at these times, the first 0.
        table_m: Vec<f64>, "payout of the table", range of(-1e5, 1e5), absent "no table";
        /// Share of the heave of that end that is paid out, alone or beside a rate or a table, so that the line below stays; the end is prescribed.
        heave_compensation: Option<f64>, "heave compensation", range of(-2.0, 2.0), absent "by another key";
        /// Tension that a winch keeps at that end, whichever way the line runs.
        tension_n: Option<f64>, "winch tension", range positive(1e12), absent "by another key";
        /// Greatest tension at that end: there the winch gives way, and pays out faster than at its rate.
        greatest_tension_n: Option<f64>, "greatest tension", range positive(1e12), absent "the rate is kept at any tension";
        /// Greatest rate of a winch that keeps a tension, either way.
        greatest_rate_m_per_s: Option<f64>, "greatest rate", range positive(100.0), absent "none";
        /// Moment of inertia of drum and drive by the square of the radius of the drum; of a winch.
        drum_mass_kg: f64 = 1000.0, "drum", range positive(1e9);
    }
}

table! {
    /// A point that slides along a line, freely or hauled: two lines of the file, of one material where they meet at it, are one line that runs
    /// through it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct SlidingInputs => SlidingKeys {
        /// The point, a free one or one on a free body.
        point: String, "point", kind Name;
        /// The line on one side of it.
        line: String, "line", kind Name;
        /// The line on the other side.
        other: String, "other line", kind Name;
        /// Friction that does not depend on the tension.
        friction_n: f64 = 0.0, "friction", range of(0.0, 1e12);
        /// Friction by the force of the line across the point, that which both tensions make together.
        friction: f64 = 0.0, "friction coefficient", range of(0.0, 10.0);
        /// Unstretched length that it is hauled along a second: towards `other`, so that `line` grows; negative back.
        rate_m_per_s: Option<f64>, "hauling rate", range of(-100.0, 100.0), absent "it slides freely";
        /// Time at which the rate sets in.
        start_s: f64 = 0.0, "start", range of(0.0, 1e6);
        /// Time at which the rate begins to fall to nothing.
        stop_s: Option<f64>, "stop", range of(0.0, 1e6), absent "at the end of the run";
        /// Times of a hauling by table: from 0 to the end of the run; a spline through its rows.
        table_time_s: Vec<f64>, "times of the table", range of(0.0, 1e6), absent "no table";
        /// Unstretched length that it is hauled along at these times, the first 0.
        table_m: Vec<f64>, "hauling of the table", range of(-1e5, 1e5), absent "no table";
        /// It is let go over this time; a rate grows over it and falls over it, a table grows in.
        ramp_s: f64 = 1.0, "ramp", range positive(1e6);
    }
}
