//! The motion of a moved body in waves by its responses: a sum of harmonics about its pose.

use std::sync::Arc;

use crate::case::{Attachment, Diagnostic};
use crate::numerics::V3;
use crate::physics::EndMotion;
use crate::physics::motion::MotionPath;
use crate::physics::sea::{Harmonics, Sea};
use crate::scene::rao_file::{self, HeadingRao};
use crate::system::model::{BodyInputs, SystemFile};
use crate::system::motion::PoseMotion;

/// Share of the waves' energy beyond the periods of a table above which a warning says so.
pub const MUCH_BEYOND: f64 = 0.02;

/// The motion of a body by its responses.
#[derive(Debug, Clone)]
pub struct BodyWaveResponse {
    /// Its motion.
    pub motion: PoseMotion,
    /// Share of the waves' energy beyond the periods of the table.
    pub energy_beyond: f64,
}

/// The motion in a sea of a body that names a file of responses, which the system carries; nothing for others.
///
/// # Errors
/// What is wrong with the file, or a wave direction that it does not cover.
pub fn wave_response(
    file: &SystemFile,
    body: &BodyInputs,
    sea: &Sea,
) -> Result<Option<BodyWaveResponse>, Diagnostic> {
    let Some(name) = &body.response_file else {
        return Ok(None);
    };
    let Some(raos) = read(file, name)? else {
        return Ok(None);
    };
    motion(file, body, sea, &raos, name).map(Some)
}

/// The responses that a body names, which the system carries and which can be read; nothing for others.
pub(in crate::system) fn responses(
    file: &SystemFile,
    body: &BodyInputs,
) -> Option<Arc<Vec<HeadingRao>>> {
    let name = body.response_file.as_ref()?;
    read(file, name).ok().flatten()
}

fn read(file: &SystemFile, name: &str) -> Result<Option<Arc<Vec<HeadingRao>>>, Diagnostic> {
    let carried = file.files.get(name);
    let read = |carried: &Attachment| {
        let text = &carried.text;
        text.parsed((), |text| rao_file::read(text, name))
    };
    carried.map(read).transpose()
}

fn motion(
    file: &SystemFile,
    body: &BodyInputs,
    sea: &Sea,
    raos: &[HeadingRao],
    name: &str,
) -> Result<BodyWaveResponse, Diagnostic> {
    let [roll, pitch, yaw] = [body.roll_deg, body.pitch_deg, body.yaw_deg].map(f64::to_radians);
    let place = V3::from(body.position_m.unwrap_or_default());
    // From where the responses are to its origin.
    let arm = -V3::from(body.response_at_m);
    let (sin, cos) = yaw.sin_cos();
    let turned_arm = V3::new(arm.x * cos - arm.y * sin, arm.x * sin + arm.y * cos, arm.z);
    let (mut moved, mut turned) = (Vec::new(), Vec::new());
    let (mut beyond, mut all) = (0.0, 0.0);
    for field in sea.fields() {
        let from_bow = (field.direction() - yaw).rem_euclid(std::f64::consts::TAU);
        let rao = rao_file::at_angle(raos, from_bow, name)?;
        let waves = field.at_point(&(place - turned_arm));
        let energy: f64 = waves.iter().map(|c| c.amplitude * c.amplitude).sum();
        beyond += rao.energy_beyond(&waves) * energy;
        all += energy;
        moved.push(rao.motion_at(&waves, yaw, &arm));
        turned.push(rao.rotations_in(&waves));
    }
    let grown = file.waves.iter().map(|waves| waves.ramp_s);
    let ramp = grown.fold(body.ramp_s, f64::max);
    let about = |position: V3, parts: Vec<Harmonics>| EndMotion {
        position,
        course: MotionPath::Sum(Harmonics::sum(parts)),
        ramp,
    };
    Ok(BodyWaveResponse {
        motion: PoseMotion {
            place: about(place, moved),
            angles: about(V3::new(roll, pitch, yaw), turned),
        },
        energy_beyond: if all > 0.0 { beyond / all } else { 0.0 },
    })
}
