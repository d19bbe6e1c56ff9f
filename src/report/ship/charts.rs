//! A ship as charts: the moment about the mooring against the heading, with its isolate_roots_, and its motions in time.

use std::f64::consts::PI;

use crate::physics::sea::DEGREES;
use crate::report::chart::{Axis, Chart, Limit, LimitLine, Series};
use crate::ship::MotionAnalysis;
use crate::ship::StaticAnalysis;
use crate::ship::yaw_equilibria::YawStability;

/// Time of a record that is drawn \[s\].
const MINUTES: f64 = 300.0;

/// Points of a curve over the full turn.
const POINTS: u32 = 720;

/// Moment about the mooring point against the heading, that of each load and together; every heading in balance marked.
#[must_use]
pub fn moments(statics: &StaticAnalysis) -> Chart {
    let arm = statics.loads.arm;
    let over = |moment: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        let heading = |i: u32| -PI + 2.0 * PI * f64::from(i) / f64::from(POINTS);
        (0..=POINTS)
            .map(|i| (heading(i).to_degrees(), moment(heading(i))))
            .collect()
    };
    let mut series = vec![Series::new(
        "together",
        0,
        over(&|heading| statics.loads.moment(heading).0),
    )];
    for (i, load) in statics.loads.each.iter().enumerate() {
        let of = |heading: f64| {
            let (value, _) = load.at(heading);
            value[2] - value[1] * arm
        };
        series.push(Series::new(load.name, i + 1, over(&of)));
    }
    Chart {
        title: "Moment about the mooring point; the ship rests where it vanishes".to_owned(),
        x: Axis {
            range: Some((-180.0, 180.0)),
            ..Axis::new("heading", "deg")
        },
        y: Axis::new("moment", "N m"),
        series,
        limits: limits(statics),
        legend: true,
        ..Chart::default()
    }
}

/// The ship's motions over the first minutes of the record: all six, or one alone.
#[must_use]
pub fn motions(motion: &MotionAnalysis, alone: Option<usize>) -> Chart {
    let shown = motion
        .motions
        .instants
        .min((MINUTES / motion.motions.step) as usize + 1);
    let series = DEGREES.iter().enumerate().map(|(degree, name)| {
        let (unit, scale) = if degree < 3 {
            ("m", 1.0)
        } else {
            ("deg", 1.0_f64.to_degrees())
        };
        let values = &motion.records[degree].x;
        let points = (0..shown).map(|i| (motion.motions.time(i), scale * values[i]));
        Series {
            visible: alone.is_none_or(|one| one == degree),
            ..Series::new(&format!("{name} [{unit}]"), degree, points.collect())
        }
    });
    Chart {
        title: "Motion of the ship, from its record".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("motion", ""),
        series: series.collect(),
        legend: true,
        ..Chart::default()
    }
}

fn limits(statics: &StaticAnalysis) -> Vec<Limit> {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    let mut limits = vec![Limit {
        label: String::new(),
        line: LimitLine::Horizontal(0.0),
    }];
    limits.extend(equilibria.iter().map(|one| Limit {
        label: match one.yaw.stability {
            YawStability::Stable => "stable".to_owned(),
            other => other.label().to_owned(),
        },
        line: LimitLine::Vertical(one.yaw.heading.to_degrees()),
    }));
    limits
}
