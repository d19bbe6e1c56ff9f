//! End conditions of a case.

use std::sync::Arc;

use nalgebra::Complex;

use super::EndCondition;
use super::error::SceneError;
use super::irregular_record::{IrregularMotion, IrregularRecord};
use crate::case::{self, Case, EndKind, MotionInterpolation, MotionName};
use crate::numerics::V3;
use crate::numerics::piecewise::PiecewiseCubic;
use crate::numerics::spline::Spline;
use crate::physics::EndMotion;
use crate::physics::motion::{self, HarmonicMotion, MotionPath};
use crate::physics::sea::{Rao, Sea};

/// Fraction of the wave energy beyond a table of responses that gives a remark.
const MUCH_BEYOND: f64 = 0.02;

/// The condition at an end: `key` is that of its table, `waves` those that move a vessel; adds remarks.
pub(super) fn end(
    case: &Case,
    end: &case::End,
    key: &str,
    waves: Option<&Sea>,
    remarks: &mut Vec<String>,
) -> Result<EndCondition, SceneError> {
    let position = || {
        end.position_m
            .map(V3::from)
            .ok_or_else(|| missing(key, "position_m", "a held end must be somewhere"))
    };
    match end.kind {
        EndKind::Payload | EndKind::Free => Ok(EndCondition::Free),
        EndKind::Fixed | EndKind::Anchor => {
            Ok(EndCondition::Prescribed(EndMotion::still(position()?)))
        }
        EndKind::Moving => {
            let place = position()?;
            let course = match end.motion {
                MotionName::Harmonic => swing(end, key)?,
                MotionName::Table => table(case, end, key, remarks)?,
                MotionName::Irregular => irregular(end, key)?,
                MotionName::Vessel => vessel(case, end, key, &place, waves, remarks)?,
            };
            Ok(EndCondition::Prescribed(EndMotion {
                position: place,
                course,
                ramp: end.ramp_s,
            }))
        }
    }
}

/// The prescribed motion of an end of a case, whose table has this key; nothing where it is free.
///
/// # Errors
/// What the motion lacks.
pub fn end_motion(
    case: &Case,
    end: &case::End,
    key: &str,
) -> Result<Option<EndMotion>, SceneError> {
    let bed = case.seabed.as_ref().map(|bed| bed.depth_m);
    let given = case.waves.as_slice();
    let sea = super::sea(given, bed, case.environment.gravity_m_per_s2)?;
    let waves = case.waves.as_ref().map(|_| &sea);
    match self::end(case, end, key, waves, &mut Vec::new())? {
        EndCondition::Prescribed(motion) => Ok(Some(motion)),
        EndCondition::Free => Ok(None),
    }
}

fn missing(table: &str, key: &str, why: &'static str) -> SceneError {
    SceneError::Missing {
        key: format!("{table}.{key}"),
        why,
    }
}

fn swing(end: &case::End, key: &str) -> Result<MotionPath, SceneError> {
    let why = "a moving end needs the period of its motion";
    let period = end.period_s.filter(|p| *p > 0.0);
    let period = period.ok_or_else(|| missing(key, "period_s", why))?;
    let amplitude = V3::from(end.amplitude_m);
    if amplitude == V3::zeros() {
        return Ok(MotionPath::Still);
    }
    Ok(MotionPath::Harmonic(HarmonicMotion {
        amplitude,
        omega: motion::omega(period),
        phase: V3::from(end.phase_deg).map(f64::to_radians),
    }))
}

/// The rows of the motion file of an end.
fn rows(
    case: &Case,
    end: &case::End,
    key: &str,
    columns: &[String],
) -> Result<Arc<Vec<Vec<f64>>>, SceneError> {
    let why = "the motion is read from a file";
    let name = end.motion_file.as_ref();
    let name = name.ok_or_else(|| missing(key, "motion_file", why))?;
    let carried = case.files.get(name);
    let carried = carried.ok_or_else(|| missing("files", name, why))?;
    case::attachments::carried_numbers(&carried.text, name, columns)
        .map_err(|fault| SceneError::File(fault.to_string()))
}

/// Overshoot of a spline by the range of its axis that gives a remark.
const NOTABLE_OVERSHOOT: f64 = 0.01;

fn table(
    case: &Case,
    end: &case::End,
    key: &str,
    remarks: &mut Vec<String>,
) -> Result<MotionPath, SceneError> {
    let columns = case::attachments::PLACES.map(str::to_owned);
    let points: Vec<(f64, V3)> = rows(case, end, key, &columns)?
        .iter()
        .map(|row| (row[0], V3::new(row[1], row[2], row[3])))
        .collect();
    let no_table = |fault| SceneError::File(format!("{key}.motion_file: {fault}"));
    let ((first, last), path) = match end.motion_interpolation {
        MotionInterpolation::Spline => {
            let spline = Spline::through(&points).map_err(no_table)?;
            remarks.extend(overshoot(case, end, &spline, key));
            (spline.span(), MotionPath::Table(spline))
        }
        MotionInterpolation::Monotone => {
            let path = PiecewiseCubic::monotone(&points).map_err(no_table)?;
            (path.span(), MotionPath::Piecewise(path))
        }
        MotionInterpolation::Linear => {
            let path = PiecewiseCubic::linear(&points).map_err(no_table)?;
            (path.span(), MotionPath::Piecewise(path))
        }
    };
    let dynamic = case.solver.method != case::Method::Static;
    if first > 0.0 || (dynamic && last < case.solver.duration_s * (1.0 - 1e-9)) {
        return Err(SceneError::File(format!(
            "{key}.motion_file: its times go from {first} s to {last} s, and the run from 0 s to {} s",
            case.solver.duration_s
        )));
    }
    Ok(path)
}

/// A remark where the spline through a table overshoots it during the run.
fn overshoot(case: &Case, end: &case::End, spline: &Spline, key: &str) -> Option<String> {
    let dynamic = case.solver.method != case::Method::Static;
    let until = if dynamic { case.solver.duration_s } else { 0.0 };
    let found = spline.overshoot(until)?;
    (found.share > NOTABLE_OVERSHOOT).then(|| {
        format!(
            "the spline through `{}` overshoots its rows along {} by {:.3} m at {:.3} s, {:.1} % of the range: set \
             {key}.motion_interpolation to \"monotone\" or \"linear\", or give more rows there",
            end.motion_file.as_deref().unwrap_or_default(),
            ["x", "y", "z"][found.axis],
            found.distance,
            found.time,
            100.0 * found.share
        )
    })
}

fn irregular(end: &case::End, key: &str) -> Result<MotionPath, SceneError> {
    let why = "an irregular motion is made to its root mean square and peak period";
    let motion = irregular_motion(end, key, why)?;
    Ok(motion.path())
}

fn irregular_motion(
    end: &case::End,
    key: &str,
    why: &'static str,
) -> Result<IrregularMotion, SceneError> {
    let rms = end.rms_m.ok_or_else(|| missing(key, "rms_m", why))?;
    let period = end.peak_period_s;
    Ok(IrregularMotion {
        rms,
        peak_period: period.ok_or_else(|| missing(key, "peak_period_s", why))?,
        gamma: end.gamma,
        components: end.components,
        seed: end.seed,
    })
}

/// The records of an end that moves irregularly.
pub(super) fn records(end: &case::End) -> Vec<IrregularRecord> {
    let moves = end.kind == EndKind::Moving && end.motion == MotionName::Irregular;
    match irregular_motion(end, "", "") {
        Ok(motion) if moves => motion.records(&end.name),
        _ => Vec::new(),
    }
}

fn vessel(
    case: &Case,
    end: &case::End,
    key: &str,
    place: &V3,
    waves: Option<&Sea>,
    remarks: &mut Vec<String>,
) -> Result<MotionPath, SceneError> {
    let why = "a vessel moves in the waves of the case";
    let waves = waves.ok_or_else(|| missing("waves", "kind", why))?;
    let columns = case::attachments::response_columns();
    let mut entries: Vec<_> = rows(case, end, key, &columns)?
        .iter()
        .map(|r| entry(r))
        .collect();
    entries.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rao = Rao::new(entries)
        .map_err(|fault| SceneError::File(format!("{key}.motion_file: {fault}")))?;
    let heading = end.heading_deg.to_radians();
    let arm = V3::from(end.hang_point_m);
    // The reference point in plan: the line is attached at the arm from it, rotated with the ship.
    let (sin, cos) = heading.sin_cos();
    let turned = V3::new(arm.x * cos - arm.y * sin, arm.x * sin + arm.y * cos, arm.z);
    let sea = waves.at_point(&(place - turned));
    let beyond = rao.energy_beyond(&sea);
    if beyond > MUCH_BEYOND {
        remarks.push(format!(
            "{:.0} % of the energy of the waves lies beyond the periods of `{}`; its last response holds there",
            100.0 * beyond,
            end.motion_file.as_deref().unwrap_or_default()
        ));
    }
    Ok(MotionPath::Sum(rao.motion_at(&sea, heading, &arm)))
}

/// A row of a table of responses: angular frequency and complex responses.
pub(crate) fn entry(row: &[f64]) -> (f64, [Complex<f64>; 6]) {
    let response = |i: usize| {
        let (size, phase) = (row[1 + 2 * i], row[2 + 2 * i].to_radians());
        let size = if i < 3 { size } else { size.to_radians() };
        Complex::from_polar(size, phase)
    };
    (motion::omega(row[0]), std::array::from_fn(response))
}
