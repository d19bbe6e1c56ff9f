//! Which of both methods is the cheaper, where a file leaves the choice to the program. An explicit step is bound by the stiffest, lightest segment; an
//! implicit one by what moves the scene, which a trial shows.

use super::Work;
use crate::case::Method;

/// Cost of a Newton iteration, and of reading an accepted step, in evaluations of the force alone, measured on lines without
/// bending.
const ITERATION: f64 = 2.7;
const READING: f64 = 1.5;

/// Part of the duration that generalized-alpha is tried for.
pub const TRIAL: f64 = 0.2;

/// Beyond this ratio of the least costs no trial is needed.
const CLEAR: f64 = 200.0;

/// What is known of the cost of both methods before a trial, in evaluations of the force.
#[derive(Debug, Clone, PartialEq)]
pub struct Outlook {
    explicit: f64,
    /// The explicit step and what binds it, in words.
    bound: String,
    /// Why it is generalized-alpha, where that is clear without a trial.
    pub clear: Option<String>,
}

/// The steps of both methods.
#[derive(Debug, Clone, PartialEq)]
pub struct StepLengths<'a> {
    /// Simulated time \[s\].
    pub duration: f64,
    /// The stability limit of explicit steps \[s\].
    pub limit: f64,
    /// What sets it, in words.
    pub limited_by: &'a str,
    /// The step that the file gives \[s\].
    pub given: Option<f64>,
    /// The explicit step \[s\].
    pub explicit: f64,
    /// The longest implicit step \[s\].
    pub implicit: f64,
}

/// The cheaper method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cheaper {
    /// Runge-Kutta of order 4.
    Rk4,
    /// Generalized-alpha.
    Alpha,
}

impl From<Cheaper> for Method {
    fn from(cheaper: Cheaper) -> Self {
        match cheaper {
            Cheaper::Rk4 => Self::Rk4,
            Cheaper::Alpha => Self::Alpha,
        }
    }
}

impl Cheaper {
    const fn word(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Alpha => "alpha",
        }
    }

    /// Why a run that is resumed has this method: up to a later end a trial might choose the other.
    #[must_use]
    pub fn as_begun(self) -> String {
        let word = self.word();
        format!("{word}: chosen when the run was begun that this one resumes")
    }
}

/// The method that an outlook chooses, after a trial of generalized-alpha where it needs one, and why; without an outlook there are no segments
/// that bind explicit steps.
pub fn method_by(outlook: Option<Outlook>, trial: impl FnOnce() -> Work) -> (Method, String) {
    let Some(outlook) = outlook else {
        let why = "alpha: there is no line whose segments bind the steps of RK4";
        return (Method::Alpha, why.to_owned());
    };
    if let Some(why) = outlook.clear {
        return (Method::Alpha, why);
    }
    let (cheaper, why) = outlook.choose(&trial());
    (cheaper.into(), why)
}

impl Outlook {
    /// By the steps that both methods take where no error shortens them.
    #[must_use]
    pub fn of_steps(steps: &StepLengths<'_>) -> Self {
        let StepLengths {
            limit,
            given,
            limited_by,
            ..
        } = steps;
        let bound = format!("its step is bound to {limit:.2e} s by {limited_by}");
        let explicit = steps.duration / steps.explicit * (4.0 + READING);
        let least = steps.duration / steps.implicit * (ITERATION + READING);
        let clear = if given.is_some_and(|step| step > *limit) {
            Some(format!(
                "alpha: the time step is above the limit of RK4, {limit:.2e} s, set by {limited_by}"
            ))
        } else {
            (explicit > CLEAR * least).then(|| format!(
                "alpha: RK4 needs some {explicit:.1e} evaluations of the force ({bound}), generalized-alpha the worth of {least:.1e} \
                 where no error shortens its steps"
            ))
        };
        Self {
            explicit,
            bound,
            clear,
        }
    }

    /// The method with the smaller cost, and why, after a trial of generalized-alpha over [`TRIAL`] of the duration. At its stable
    /// steps RK4 is the more accurate of the two.
    #[must_use]
    pub fn choose(&self, trial: &Work) -> (Cheaper, String) {
        let Self {
            explicit, bound, ..
        } = self;
        let work = trial.iterations as f64 * ITERATION + trial.steps as f64 * READING;
        let implicit = work / TRIAL;
        let method = if *explicit < implicit {
            Cheaper::Rk4
        } else {
            Cheaper::Alpha
        };
        let word = method.word();
        let why = format!(
            "{word}: RK4 needs some {explicit:.1e} evaluations of the force ({bound}), generalized-alpha by a trial over a fifth of \
             the duration the worth of {implicit:.1e}"
        );
        (method, why)
    }
}
