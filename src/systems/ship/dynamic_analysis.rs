//! Dynamic analysis of a ship in waves, which takes seconds: motions, coupled analysis, rope. It runs in a thread of its own
//! after the [`StaticAnalysis`] and stops on request.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::coupled::{CoupledAnalysis, CoupledError};
use super::model::Follows;
use super::motion_analysis::{MotionAnalysis, MotionError};
use super::rope::{HangOffMotion, RopeAnalysis};
use super::static_analysis::StaticAnalysis;

/// Why an analysis that needs the motion is missing.
const NO_MOTION: &str = "the motion analysis failed";

/// The dynamic analysis of a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicAnalysis {
    /// Its six motions; absent without `[motion]`.
    pub motion: Option<Result<MotionAnalysis, MotionError>>,
    /// Ship and anchor line in the time domain; absent without `[coupled]`.
    pub coupled: Option<Result<CoupledAnalysis, CoupledError>>,
    /// The rope that follows it; absent without `[rope]`.
    pub rope: Option<Result<RopeAnalysis, String>>,
}

impl DynamicAnalysis {
    /// Analyses a ship; none once `stop` is set. `folder` is that of the ship's file.
    #[must_use]
    pub fn new(statics: &StaticAnalysis, folder: &Path, stop: &AtomicBool) -> Option<Self> {
        let unless_stopped = || (!stop.load(Ordering::Relaxed)).then_some(());
        let motion = MotionAnalysis::of_statics(statics, folder);
        unless_stopped()?;
        let computed = motion.as_ref().and_then(|motion| motion.as_ref().ok());
        let coupled = statics.ship.coupled.is_some().then(|| match &motion {
            Some(Err(_)) => Err(CoupledError::Missing(NO_MOTION)),
            _ => CoupledAnalysis::new(statics, computed, stop),
        });
        unless_stopped()?;
        let rope = hang_off_motion(statics, computed, coupled.as_ref())
            .map(|hang_off| RopeAnalysis::load(&hang_off?, folder));
        unless_stopped()?;
        Some(Self {
            motion,
            coupled,
            rope,
        })
    }
}

/// Motion of the rope's hang-off point; absent without `[rope]`.
fn hang_off_motion<'a>(
    statics: &'a StaticAnalysis,
    analysis: Option<&'a MotionAnalysis>,
    coupled: Option<&Result<CoupledAnalysis, CoupledError>>,
) -> Option<Result<HangOffMotion<'a>, String>> {
    let rope = statics.ship.rope.as_ref()?;
    let settings = statics.ship.motion.as_ref();
    Some(match (rope.follows, coupled) {
        (Follows::Motion, _) => settings
            .zip(analysis)
            .map(|(settings, analysis)| HangOffMotion::of_motion(rope, settings, analysis))
            .ok_or_else(|| NO_MOTION.to_owned()),
        (Follows::Coupled, Some(Ok(coupled))) => {
            Ok(HangOffMotion::of_coupled(rope, settings, coupled))
        }
        (Follows::Coupled, Some(Err(error))) => {
            Err(format!("the coupled analysis failed: {error}"))
        }
        (Follows::Coupled, None) => Err("the file has no [coupled] to follow".to_owned()),
    })
}
