//! What identifies a single number of a run. Its text is the name in `summary.csv`:
//! `tension_n[wire|payload].mean(0..200)`.

use std::fmt;
use std::str::FromStr;

use super::Statistic;
use super::channel_id::{ChannelId, ChannelNameError};
use super::subject::Subject;

/// What identifies a single number of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum QuantityId {
    /// A statistic.
    Statistic {
        /// What it is taken of.
        of: Subject,
        /// What is taken of it.
        statistic: Statistic,
        /// Window of time \[s\] or, of the whole line, stretch \[m\]; absent: all of it.
        within: Option<[f64; 2]>,
        /// Of a statistic that is one of several, such as `peak`: its number, from 1.
        nth: Option<usize>,
    },
    /// Difference of a channel from a published curve, by the curve's number among those of its file, from 1.
    CurveDifference(ChannelId, CurveMeasure, usize),
}

/// How far a channel is from a published curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CurveMeasure {
    /// Root mean square of the differences, in percent of the curve's greatest size.
    RootMeanSquare,
    /// The greatest difference, in percent of the curve's range.
    Greatest,
}

impl CurveMeasure {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::RootMeanSquare, Self::Greatest];

    /// What the name of its number begins with.
    const fn prefix(self) -> &'static str {
        match self {
            Self::RootMeanSquare => "from_curve_",
            Self::Greatest => "greatest_from_curve_",
        }
    }
}

impl QuantityId {
    /// The statistic of a subject.
    #[must_use]
    pub const fn new(of: Subject, statistic: Statistic, within: Option<[f64; 2]>) -> Self {
        Self::Statistic {
            of,
            statistic,
            within,
            nth: None,
        }
    }

    /// The same with this number, of a statistic that is one of several.
    #[must_use]
    pub fn numbered(self, nth: Option<usize>) -> Self {
        match self {
            Self::Statistic {
                of,
                statistic,
                within,
                ..
            } => Self::Statistic {
                of,
                statistic,
                within,
                nth,
            },
            curve @ Self::CurveDifference(..) => curve,
        }
    }

    /// A number without a statistic over time: the final value of its subject.
    #[must_use]
    pub const fn single(of: Subject) -> Self {
        Self::new(of, Statistic::Final, None)
    }

    /// Its unit as shown.
    #[must_use]
    pub fn unit(&self) -> String {
        match self {
            Self::Statistic { of, statistic, .. } => statistic.unit(of.unit()),
            Self::CurveDifference(..) => "%".to_owned(),
        }
    }

    /// What it is taken of, and the rest of its name: `.max`.
    #[must_use]
    pub fn parts(&self) -> (Subject, String) {
        match self {
            Self::Statistic {
                of,
                statistic,
                within,
                nth,
            } => {
                let nth = nth.map(|nth| format!("_{nth}")).unwrap_or_default();
                let window = within.map(|[from, to]| format!("({from}..{to})"));
                let window = window.unwrap_or_default();
                (of.clone(), format!(".{}{nth}{window}", statistic.name()))
            }
            Self::CurveDifference(channel, measure, number) => (
                Subject::Channel(channel.clone()),
                format!(".{}{number}", measure.prefix()),
            ),
        }
    }
}

impl fmt::Display for QuantityId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (subject, rest) = self.parts();
        write!(f, "{subject}{rest}")
    }
}

impl FromStr for QuantityId {
    type Err = ChannelNameError;

    fn from_str(text: &str) -> Result<Self, ChannelNameError> {
        let wrong = || ChannelNameError(text.to_owned());
        let (name, within) = match text.strip_suffix(')').and_then(|t| t.rsplit_once('(')) {
            Some((name, window)) => (name, Some(window_from(window).ok_or_else(wrong)?)),
            None => (text, None),
        };
        let (of, word) = name.rsplit_once('.').ok_or_else(wrong)?;
        let of_curve =
            |measure: CurveMeasure| Some((measure, word.strip_prefix(measure.prefix())?));
        if let Some((measure, number)) = CurveMeasure::ALL.into_iter().find_map(of_curve) {
            let number = number.parse().map_err(|_| wrong())?;
            return Ok(Self::CurveDifference(of.parse()?, measure, number));
        }
        let (statistic, nth) = statistic_from(word).ok_or_else(wrong)?;
        Ok(Self::new(of.parse()?, statistic, within).numbered(nth))
    }
}

/// The statistic of this name, and the number that ends it: `peak_2`.
fn statistic_from(word: &str) -> Option<(Statistic, Option<usize>)> {
    let named = |name: &str| Statistic::ALL.into_iter().find(|s| s.name() == name);
    if let Some((name, number)) = word.rsplit_once('_')
        && let Some(statistic) = named(name).filter(|s| s.is_numbered())
    {
        return Some((statistic, Some(number.parse().ok()?)));
    }
    Some((named(word)?, None))
}

fn window_from(text: &str) -> Option<[f64; 2]> {
    let (from, to) = text.split_once("..")?;
    Some([from.parse().ok()?, to.parse().ok()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_reads_back_as_its_quantity() {
        for name in [
            "tension_n[wire|payload].mean",
            "tension_n[wire|payload].mean(0..200)",
            "tension_n[wire|payload].mean(2.5..20)",
            "z_m[a.b].c].arc_of_max(-1..0.5)",
            "tension_n[chain|wheel].from_curve_1",
            "tension_n[chain|wheel].greatest_from_curve_2",
            "bend_radius_m.min",
            "rms_displacement_d.peak_2",
            "rms_displacement_d.valley_10(0..60.5)",
            "in_plane_hz[12].final",
            "out_of_plane_mode_near.final",
            "response_steady_s.final",
            "energy_in_j.final",
            "energy_drift_percent.final",
        ] {
            let id: QuantityId = name.parse().unwrap();
            assert_eq!(id.to_string(), name);
        }
        for wrong in [
            "tension_n[a]",
            "tension_n[a].most",
            "x_m[a].max(1)",
            "q.max",
            "z_m.max_1",
            "z_m.peak_x",
        ] {
            assert!(wrong.parse::<QuantityId>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn units_follow_from_subject_and_statistic() {
        let unit = |name: &str| name.parse::<QuantityId>().unwrap().unit();
        assert_eq!(unit("tension_n[a|b].rate"), "N/s");
        assert_eq!(unit("tension_n.arc_of_max"), "m");
        assert_eq!(unit("in_plane_hz[1].final"), "Hz");
        assert_eq!(unit("x_m[a].from_curve_2"), "%");
    }
}
