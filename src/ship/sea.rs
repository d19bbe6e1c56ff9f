//! A ship in its sea: what takes longer than a key stroke to work out. The ship at rest ([`Rest`]) comes first and is enough
//! to draw; this is for a thread of its own, and stops when asked.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use super::coupled::{Coupled, CoupledError};
use super::model::Follows;
use super::rest::Rest;
use super::rope::{Course, RopeAtSea};
use super::voyage::{Voyage, VoyageError};
use crate::numerics::V3;

/// A ship in its sea.
#[derive(Debug, Clone, PartialEq)]
pub struct AtSea {
    /// Its six motions; absent where the file gives none.
    pub voyage: Option<Result<Voyage, VoyageError>>,
    /// The ship and its anchor line in time; absent where the file does not ask for it.
    pub coupled: Option<Result<Coupled, CoupledError>>,
    /// The rope that follows it, or why it cannot; absent where the file names none.
    pub rope: Option<Result<RopeAtSea, String>>,
}

impl AtSea {
    /// Works a ship at sea out; absent once `stop` was set. `folder` is that of the ship's file.
    #[must_use]
    pub fn of(rest: &Rest, folder: &Path, stop: &AtomicBool) -> Option<Self> {
        let going = || (!stop.load(Ordering::Relaxed)).then_some(());
        let voyage = Voyage::of(rest, folder);
        going()?;
        let sails = voyage.as_ref().and_then(|voyage| voyage.as_ref().ok());
        let asked = rest.ship.coupled.is_some();
        let coupled = asked.then(|| match &voyage {
            Some(Err(_)) => Err(CoupledError::Missing("the ship has no such motion")),
            _ => Coupled::new(rest, sails, stop),
        });
        going()?;
        let rope = course(rest, sails, coupled.as_ref())
            .map(|course| course.and_then(|course| course.followed(folder)));
        going()?;
        Some(Self {
            voyage,
            coupled,
            rope,
        })
    }
}

/// Where the rope's hang point goes, or why nowhere; absent where the file names no rope.
fn course<'a>(
    rest: &'a Rest,
    voyage: Option<&'a Voyage>,
    coupled: Option<&Result<Coupled, CoupledError>>,
) -> Option<Result<Course<'a>, String>> {
    let rope = rest.ship.rope.as_ref()?;
    let motion = rest.ship.motion.as_ref();
    Some(match rope.follows {
        Follows::Motion => motion
            .zip(voyage)
            .map(|(motion, voyage)| Course::of_voyage(rope, motion, voyage))
            .ok_or_else(|| "the ship has no such motion".to_owned()),
        Follows::Coupled => match coupled {
            Some(Ok(coupled)) => {
                let hang = motion.map_or([0.0; 3], |motion| motion.hang_point_m);
                Ok(Course {
                    rope,
                    places: coupled.of_point(&V3::from(hang)),
                    step: coupled.step,
                    others: None,
                })
            }
            Some(Err(why)) => Err(format!("ship and anchor line have no motion: {why}")),
            None => Err("the file has no [coupled] to follow".to_owned()),
        },
    })
}
