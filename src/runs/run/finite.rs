//! No result that is not finite leaves as one: a run that has one has failed, and says which it is.

use super::{Run, RunState};

/// Takes every result that is not finite out of a run, which has then failed. Errors that are not finite are none.
pub fn refuse_not_finite(run: &mut Run) {
    let mut wild = run.summary.iter().filter(|q| !q.value.is_finite());
    let failure = wild.next().map(|first| match wild.count() {
        0 => format!("{} is not finite", first.name()),
        more => format!("{} and {more} more results are not finite", first.name()),
    });
    run.summary.retain(|quantity| quantity.value.is_finite());
    for quantity in &mut run.summary {
        let finite = |error: &f64| error.is_finite();
        quantity.time_error = quantity.time_error.filter(finite);
        quantity.mesh_error = quantity.mesh_error.filter(finite);
        quantity.unsettled = quantity
            .unsettled
            .filter(|range| range.iter().all(|end| end.is_finite()));
    }
    if let Some(failure) = failure {
        run.info.state = RunState::Failed;
        run.info.failure.get_or_insert(failure);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{parse, shipped::SHIPPED};
    use crate::run::job::Request;
    use crate::run::{History, Quantity};

    #[test]
    fn a_run_with_a_result_that_is_not_finite_has_failed() {
        let text = SHIPPED
            .iter()
            .find(|case| case.0.ends_with("pendulum.toml"));
        let text = text.unwrap().1.to_owned();
        let request = Request {
            case: parse(&text, "case").unwrap(),
            text,
            file: String::new(),
            overrides: Vec::new(),
            id: String::new(),
        };
        let quantity = |name: &str, value: f64| Quantity {
            time_error: Some(f64::INFINITY),
            mesh_error: Some(1.0),
            ..Quantity::new(name.parse().unwrap(), value)
        };
        let mut run = Run {
            info: request.initial_info(),
            case_text: String::new(),
            history: History::default(),
            shapes: Vec::new(),
            profiles: Vec::new(),
            summary: vec![quantity("tension_n.max", 1.0)],
            fatigue: Vec::new(),
        };
        run.info.state = RunState::Done;
        refuse_not_finite(&mut run);
        assert_eq!(run.info.state, RunState::Done);
        let errors = (run.summary[0].time_error, run.summary[0].mesh_error);
        assert_eq!(errors, (None, Some(1.0)));

        run.summary.push(quantity("tension_n.min", f64::NAN));
        refuse_not_finite(&mut run);
        assert_eq!(run.info.state, RunState::Failed);
        let why = run.info.failure.unwrap();
        assert_eq!(why, "tension_n.min is not finite");
        assert_eq!(run.summary.len(), 1);
    }
}
