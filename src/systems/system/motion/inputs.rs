//! The motions that a file prescribes, in SI.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::PoseMotion;
use crate::case::{Attachment, MotionInterpolation, OneOrMany, attachments};
use crate::numerics::V3;
use crate::numerics::piecewise::PiecewiseCubic;
use crate::numerics::spline::Spline;
use crate::physics::EndMotion;
use crate::physics::motion::MotionPath;
use crate::physics::sea::{Component, Harmonics};
use crate::scene::IrregularMotion;
use crate::system::model::{BodyInputs, PointInputs};

/// The motion of a moved point about its place \[m\]; the files of its system hold the table that it may name.
#[must_use]
pub fn point_motion(
    given: &PointInputs,
    files: &BTreeMap<String, Attachment>,
    place: V3,
) -> EndMotion {
    let periods = match &given.period_s {
        Some(OneOrMany::One(period)) => [*period; 3],
        Some(OneOrMany::Many(periods)) => {
            std::array::from_fn(|k| periods.get(k).copied().unwrap_or(f64::INFINITY))
        }
        None => [f64::INFINITY; 3],
    };
    if let Some(peak_period) = given.peak_period_s {
        let motion = IrregularMotion {
            rms: given.rms_m,
            peak_period,
            gamma: given.gamma,
            components: given.components,
            seed: given.seed,
        };
        return EndMotion {
            position: place,
            course: motion.path(),
            ramp: given.ramp_s,
        };
    }
    let columns = [&given.table_x_m, &given.table_y_m, &given.table_z_m];
    let rows = match &given.motion_file {
        Some(name) => rows_of_file(files, name),
        None => rows(&given.table_time_s, columns, 1.0),
    };
    if let Some(course) = table(&rows, given.table_interpolation) {
        return EndMotion {
            position: place,
            course,
            ramp: given.ramp_s,
        };
    }
    harmonic(
        place,
        given.amplitude_m,
        periods,
        given.phase_deg,
        given.ramp_s,
    )
}

/// The motion of a moved body about its pose.
#[must_use]
pub fn body_motion(given: &BodyInputs) -> PoseMotion {
    let period = |k: usize| match given.period_s.as_slice() {
        [] => f64::INFINITY,
        [one] => *one,
        many => many.get(k).copied().unwrap_or(f64::INFINITY),
    };
    let phase = |k: usize| given.phase_deg.get(k).copied().unwrap_or(0.0);
    let angles = [given.roll_deg, given.pitch_deg, given.yaw_deg].map(f64::to_radians);
    let three = |from: usize, place: V3, amplitude: [f64; 3]| {
        let axes = [from, from + 1, from + 2];
        harmonic(
            place,
            amplitude,
            axes.map(period),
            axes.map(phase),
            given.ramp_s,
        )
    };
    let by_table = |columns, scale, position| {
        let rows = rows(&given.table_time_s, columns, scale);
        let course = table(&rows, given.table_interpolation)?;
        Some(EndMotion {
            position,
            course,
            ramp: given.ramp_s,
        })
    };
    let places = [&given.table_x_m, &given.table_y_m, &given.table_z_m];
    let turns = [
        &given.table_roll_deg,
        &given.table_pitch_deg,
        &given.table_yaw_deg,
    ];
    let moved = by_table(places, 1.0, V3::from(given.position_m.unwrap_or_default()));
    let turned = by_table(turns, 1_f64.to_radians(), V3::from(angles));
    if let Some((place, angles)) = moved.zip(turned) {
        return PoseMotion { place, angles };
    }
    PoseMotion {
        place: three(
            0,
            V3::from(given.position_m.unwrap_or_default()),
            given.amplitude_m,
        ),
        angles: three(
            3,
            V3::from(angles),
            given.amplitude_deg.map(f64::to_radians),
        ),
    }
}

/// The rows of a file of places over time, which was checked with its system; none where it is not carried.
fn rows_of_file(files: &BTreeMap<String, Attachment>, name: &str) -> Vec<(f64, V3)> {
    let carried = files.get(name);
    let rows = carried.and_then(|file| attachments::places(&file.text, name).ok());
    let rows = rows.iter().flat_map(|rows| rows.iter());
    rows.map(|row| (row[0], V3::new(row[1], row[2], row[3])))
        .collect()
}

/// The rows of a table, absent columns zero.
fn rows(times: &[f64], columns: [&Vec<f64>; 3], scale: f64) -> Vec<(f64, V3)> {
    let row = |(k, time): (usize, &f64)| {
        let at = columns.map(|column| column.get(k).map_or(0.0, |value| value * scale));
        (*time, V3::from(at))
    };
    times.iter().enumerate().map(row).collect()
}

/// The course through the rows of a table; nothing without a table.
fn table(rows: &[(f64, V3)], interpolation: MotionInterpolation) -> Option<MotionPath> {
    match interpolation {
        MotionInterpolation::Spline => Spline::through(rows).ok().map(MotionPath::Table),
        MotionInterpolation::Monotone => {
            let path = PiecewiseCubic::monotone(rows).ok();
            path.map(MotionPath::Piecewise)
        }
        MotionInterpolation::Linear => {
            let path = PiecewiseCubic::linear(rows).ok();
            path.map(MotionPath::Piecewise)
        }
    }
}

/// `A sin(2 pi t / T + phase)` along each axis about a place, growing over a ramp.
fn harmonic(
    position: V3,
    amplitude: [f64; 3],
    period: [f64; 3],
    phase_deg: [f64; 3],
    ramp: f64,
) -> EndMotion {
    let axis = |k: usize| {
        let moves = amplitude[k] != 0.0 && period[k].is_finite();
        let component = moves.then(|| Component {
            omega: TAU / period[k],
            amplitude: amplitude[k],
            phase: phase_deg[k].to_radians() - 0.25 * TAU,
        });
        component.into_iter().collect()
    };
    let axes = [axis(0), axis(1), axis(2)];
    let still = axes.iter().all(Vec::is_empty);
    EndMotion {
        position,
        course: if still {
            MotionPath::Still
        } else {
            MotionPath::Sum(Harmonics::along_axes(&axes))
        },
        ramp,
    }
}
