//! Checks against the limits of standards, and how the greatest values of irregular seas are found for them.

use crate::case::fields::{of, positive};
use crate::case::schema::{table, words};

words! {
    /// How the greatest value of the records of a sea is found.
    #[derive(Hash)]
    pub enum GreatestMethod {
        /// Gumbel's law from 5 runs on, Weibull's with fewer; the greatest value seen where the law cannot be fitted.
        Auto = "auto",
        /// Gumbel's law of the greatest values of the runs.
        Gumbel = "gumbel",
        /// Weibull's law of the peaks between up-crossings of the mean.
        Weibull = "weibull",
        /// The generalized Pareto law of the peaks over a threshold.
        PeaksOverThreshold = "peaks-over-threshold",
        /// The greatest value that was seen, without a law.
        Seen = "seen",
        /// The law of a normal process with the spectrum of a quick look; of runs in time the greatest value seen.
        Spectrum = "spectrum",
    }
}

table! {
    /// How the results of load cases are summed up: each sea by the records of its seeds.
    #[derive(Debug, Clone, PartialEq)]
    pub struct StatisticsInputs => StatisticsKeys {
        /// The greatest values are the most probable ones of so many hours.
        hours: f64 = 3.0, "hours", range of(1e-3, 1e6);
        /// Level of confidence of the intervals of the sample.
        confidence: f64 = 0.95, "confidence", unit "", range of(0.5, 0.999);
        /// What comes before this time is left out, such as the ramp of the waves.
        from_s: f64 = 0.0, "begin", range of(0.0, 1e7);
        /// How the greatest value of a sea is found.
        method: GreatestMethod = GreatestMethod::Auto, "method";
        /// Whether a sweep draws the seeds of a sea only until its checks are settled, by intervals that hold at all looks together.
        until_settled: bool = false, "seeds until settled";
        /// Rounds in which load cases are computed again, twice as fine, whose verdict by a check lies within their numerical error.
        finer_runs: usize = 0, "rounds of finer runs", range of(0.0, 6.0);
        /// Years of service, for fatigue.
        service_years: f64 = 25.0, "service", range positive(1e3);
    }
}

impl StatisticsInputs {
    /// Whether what is computed next follows from what was.
    #[must_use]
    pub fn is_in_rounds(&self) -> bool {
        self.until_settled || self.finer_runs > 0
    }

    /// The time from where the start is over to the end of a run of a duration \[s\]; nothing where no start is left out.
    #[must_use]
    pub fn settled_window(&self, duration_s: f64) -> Option<[f64; 2]> {
        (self.from_s > 0.0 && self.from_s < duration_s).then_some([self.from_s, duration_s])
    }
}

words! {
    /// What a check compares.
    #[derive(Hash)]
    pub enum CheckKind {
        /// The greatest tension times a factor with the strength.
        SafetyFactor = "safety-factor",
        /// Mean tension and its dynamic part, each times a factor of its own, with the strength.
        PartialFactors = "partial-factors",
        /// The least tension with a limit: no slack, no compression, least tension of fibre rope.
        LeastTension = "least-tension",
        /// The sharpest bend of the line with the least radius allowed.
        BendRadius = "bend-radius",
        /// The vertical force of the lines on an anchor with what it may take.
        Uplift = "uplift",
        /// The horizontal distance of a point or body from its place at the start with a limit.
        Offset = "offset",
        /// The height of a point or body above the level sea bed, or of a line above any bed, with the least allowed.
        BedClearance = "bed-clearance",
        /// The depth of a point or body below still water with the least allowed.
        SurfaceClearance = "surface-clearance",
        /// The fatigue damage of the years of service, times a factor, with 1.
        Fatigue = "fatigue",
    }
}

words! {
    /// How the units of a cross-section move against each other where it bends.
    #[derive(Hash)]
    pub enum UnitSlip {
        /// Each bends about its own axis alone: the lower bound of the stress.
        Full = "full-slip",
        /// Plane sections stay plane: the upper bound.
        None = "full-stick",
    }
}

words! {
    /// Which load cases a check is for.
    #[derive(Default, Hash)]
    pub enum CheckCondition {
        /// All of them.
        Any = "any",
        /// No line is lost and none breaks.
        #[default]
        Intact = "intact",
        /// One line is lost from the start, by damage.lost_line.
        LineLost = "line-lost",
        /// A line breaks on the way.
        Transient = "transient",
    }
}

words! {
    /// Which analysis a check is for.
    #[derive(Hash)]
    pub enum CheckAnalysis {
        /// Any.
        Any = "any",
        /// Lines at rest.
        QuasiStatic = "quasi-static",
        /// Lines in motion.
        Dynamic = "dynamic",
    }
}

table! {
    /// A limit that results are held to, or rules of a standard. `seacable sweep` states how much of it each sea uses.
    #[derive(Debug, Clone, PartialEq)]
    pub struct CheckInputs => CheckKeys {
        /// Rules of a standard, by the name of a shipped set (`seacable rules` lists them) or a file NAME.toml of such.
        rules: Option<String>, "rules", absent "a check of its own";
        /// Which rules of the set, by name.
        only: Option<Vec<String>>, "names of rules", absent "all of the set";
        /// Its name.
        name: Option<String>, "name", absent "its kind";
        /// Where the limit is printed: standard, edition, clause.
        clause: Option<String>, "clause", absent "none stated";
        /// What is compared.
        kind: Option<CheckKind>, "kind", absent "that of the rules";
        /// Which load cases it is for.
        condition: CheckCondition = CheckCondition::Any, "condition";
        /// Which analysis it is for.
        analysis: CheckAnalysis = CheckAnalysis::Any, "analysis";
        /// What is held to it: lines, points or bodies by name; a name holds for all copies NAME@ANGLE.
        of: Option<Vec<String>>, "subjects", absent "all lines, all anchors, or the whole line";
        /// Stretch of the lines by arc length from end A: of the bend radius, and of the height above the bed.
        stretch_m: Option<[f64; 2]>, "stretch", range of(0.0, f64::INFINITY), absent "the whole line";
        /// Factor on the greatest tension, or on the damage.
        factor: Option<f64>, "factor", unit "", range positive(1e3), absent "1";
        /// Factor on the mean tension.
        mean_factor: Option<f64>, "factor on the mean", unit "", range positive(1e3), absent "1";
        /// Factor on the dynamic part: the greatest tension less the mean.
        dynamic_factor: Option<f64>, "factor on the dynamic part", unit "", range positive(1e3), absent "1";
        /// Share of the breaking load that counts as strength; of a least tension, the limit as a share of it.
        strength_share: Option<f64>, "share of the breaking load", unit "", range positive(10.0), absent "1";
        /// Breaking load, in the place of that of the material.
        break_load_n: Option<f64>, "breaking load", range positive(1e12), absent "that of the material";
        /// Limit of a force.
        limit_n: Option<f64>, "limit", range of(0.0, 1e12), absent "not used";
        /// Limit of a length.
        limit_m: Option<f64>, "limit", range positive(1e6), absent "not used";
        /// Fatigue curve, by the name of a published one (`seacable statistics --curves` lists them) or a file NAME.toml.
        curve: Option<String>, "fatigue curve", absent "not used";
        /// Whether fatigue is counted at every node along the lines, while they are computed, not at the recorded places alone.
        along: bool = false, "along the line";
        /// Cross-section in whose units fatigue is counted along the line, of tension and bending: a file NAME.toml.
        section: Option<String>, "cross-section", absent "the tension of the line";
        /// Which of its units, or layers, by name.
        units: Option<Vec<String>>, "units", absent "all whose area is known";
        /// How these units move against each other where it bends.
        slip: Option<UnitSlip>, "slip of the units", absent "full-stick";
        /// Nominal diameter, for curves of stress.
        diameter_m: Option<f64>, "diameter", range positive(10.0), absent "that of the material";
    }
}

table! {
    /// Rules of a standard, as data.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RuleSet => RuleSetKeys {}
    tables {
        /// The standard.
        about: RuleSetInfo as "rules";
        /// Its rules.
        checks: Vec<CheckInputs>, required;
    }
}

table! {
    /// A standard whose rules are stated as data.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RuleSetInfo => RuleSetInfoKeys {
        /// Name of the standard.
        title: String, "title";
        /// Edition.
        edition: String, "edition";
        /// Where its numbers were taken from, and how far they are confirmed.
        source: String, "source";
    }
}
