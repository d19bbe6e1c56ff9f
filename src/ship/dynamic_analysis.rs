//! A ship in its sea: what takes longer than a key stroke to work out. The ship at rest ([`StaticAnalysis`]) comes first and is enough
//! to draw; this is for a thread of its own, and stops when asked.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::coupled::{CoupledAnalysis, CoupledError};
use super::model::Follows;
use super::motion_analysis::{MotionAnalysis, MotionError};
use super::rope::{HangOffMotion, RopeAnalysis};
use super::static_analysis::StaticAnalysis;
use crate::numerics::V3;

/// A ship in its sea.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicAnalysis {
    /// Its six motions; absent where the file gives none.
    pub motion: Option<Result<MotionAnalysis, MotionError>>,
    /// The ship and its anchor line in time; absent where the file does not ask for it.
    pub coupled: Option<Result<CoupledAnalysis, CoupledError>>,
    /// The rope that follows it, or why it cannot; absent where the file names none.
    pub rope: Option<Result<RopeAnalysis, String>>,
}

impl DynamicAnalysis {
    /// Works a ship at sea out; absent once `stop` was set. `folder` is that of the ship's file.
    #[must_use]
    pub fn of(statics: &StaticAnalysis, folder: &Path, stop: &AtomicBool) -> Option<Self> {
        let going = || (!stop.load(Ordering::Relaxed)).then_some(());
        let motion = MotionAnalysis::of(statics, folder);
        going()?;
        let computed = motion.as_ref().and_then(|motion| motion.as_ref().ok());
        let asked = statics.ship.coupled.is_some();
        let coupled = asked.then(|| match &motion {
            Some(Err(_)) => Err(CoupledError::Missing("the ship has no such motion")),
            _ => CoupledAnalysis::new(statics, computed, stop),
        });
        going()?;
        let rope = hang_off_motion(statics, computed, coupled.as_ref())
            .map(|hang_off| hang_off.and_then(|hang_off| hang_off.follow(folder)));
        going()?;
        Some(Self {
            motion,
            coupled,
            rope,
        })
    }
}

/// Where the rope's hang point goes, or why nowhere; absent where the file names no rope.
fn hang_off_motion<'a>(
    statics: &'a StaticAnalysis,
    motion: Option<&'a MotionAnalysis>,
    coupled: Option<&Result<CoupledAnalysis, CoupledError>>,
) -> Option<Result<HangOffMotion<'a>, String>> {
    let rope = statics.ship.rope.as_ref()?;
    let settings = statics.ship.motion.as_ref();
    Some(match rope.follows {
        Follows::Motion => settings
            .zip(motion)
            .map(|(settings, motion)| HangOffMotion::of_ship(rope, settings, motion))
            .ok_or_else(|| "the ship has no such motion".to_owned()),
        Follows::Coupled => match coupled {
            Some(Ok(coupled)) => {
                let hang_off = settings.map_or([0.0; 3], |settings| settings.hang_point_m);
                Ok(HangOffMotion {
                    rope,
                    places: coupled.point_displacements(&V3::from(hang_off)),
                    step: coupled.step,
                    others: None,
                })
            }
            Some(Err(why)) => Err(format!("ship and anchor line have no motion: {why}")),
            None => Err("the file has no [coupled] to follow".to_owned()),
        },
    })
}
