//! The method of a run in time whose file leaves the choice to the program, as for a line: see [`outlook`](crate::run::outlook).

use std::sync::atomic::AtomicBool;

use super::checkpoint::ResumedSystem;
use super::settings::MotionSettings;
use super::start::Start;
use super::system_under_way::compute;
use crate::run::Work;
use crate::run::lines_along::LinesAlong;
use crate::run::outlook::{Cheaper, Outlook, TRIAL};
use crate::system::model::{MotionInputs, MotionMethod};

/// The inputs with the method that the program chooses, and why; nothing where the file names one. A run that is resumed keeps its
/// method.
pub(super) fn chosen(
    given: &MotionInputs,
    begun: &Start,
    from: Option<&ResumedSystem>,
    cancel: &AtomicBool,
) -> Option<(MotionInputs, String)> {
    if given.method != MotionMethod::Auto {
        return None;
    }
    let by = |method| MotionInputs {
        method,
        ..given.clone()
    };
    if let Some(from) = from.filter(|from| from.checkpoint.place.steps > 0) {
        let begun_with = match from.checkpoint.method.work_counts.evaluations {
            0 => Cheaper::Alpha,
            _ => Cheaper::Rk4,
        };
        return Some((by(method(begun_with)), begun_with.as_begun()));
    }
    // Nothing but bodies: no segment limits a step.
    let Some(steps) = MotionSettings::step_lengths(given, &begun.system) else {
        let why = "alpha: there is no line whose segments bind the steps of RK4";
        return Some((by(MotionMethod::Alpha), why.to_owned()));
    };
    let outlook = Outlook::of_steps(&steps);
    if let Some(why) = outlook.clear {
        return Some((by(MotionMethod::Alpha), why));
    }
    let (cheaper, why) = outlook.choose(&trial(&by(MotionMethod::Alpha), begun, cancel));
    Some((by(method(cheaper)), why))
}

const fn method(cheaper: Cheaper) -> MotionMethod {
    match cheaper {
        Cheaper::Rk4 => MotionMethod::Rk4,
        Cheaper::Alpha => MotionMethod::Alpha,
    }
}

/// Work of generalized-alpha over a part of the duration.
fn trial(given: &MotionInputs, begun: &Start, cancel: &AtomicBool) -> Work {
    let duration_s = TRIAL * given.duration_s;
    let given = MotionInputs {
        duration_s,
        ..given.clone()
    };
    let begun = Start {
        along: LinesAlong::default(),
        ..begun.clone()
    };
    let settings = MotionSettings::new(&given, duration_s, &begun.system);
    let tried = compute(begun, &settings, None, cancel, None);
    tried.outcome.work
}
