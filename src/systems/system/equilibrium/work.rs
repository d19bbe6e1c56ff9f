//! What the divided lines of a search cost, and when it is given up.

use super::{SystemEquilibriumSearch, SystemError};
use crate::system::balance::{Balance, UnsolvedLine};

/// Newton iterations of a divided line, by its segments, that a search may take: seconds. Without an equilibrium near by, a line takes
/// thousands of iterations for every place that its ends are tried at.
const MOST_WORK: u64 = 15_000_000;

impl SystemEquilibriumSearch<'_> {
    /// The line that took more work than the search is given, if one has.
    pub(super) fn too_much_work(&self) -> Option<SystemError> {
        let work = self.work.borrow();
        let line = work.iter().position(|work| *work > MOST_WORK)?;
        Some(SystemError::TooMuchWork {
            line,
            work: work[line],
            steps: self.steps,
        })
    }

    /// Counts the work of the divided lines of an evaluation.
    pub(super) fn count_work(&self, evaluated: &Result<Balance, UnsolvedLine>) {
        let segments = |line: usize| {
            let divided = self.network.lines[line].discretised.as_ref();
            divided.map_or(0, |divided| divided.segments() as u64)
        };
        let mut work = self.work.borrow_mut();
        match evaluated {
            Ok(balance) => {
                for (index, line) in balance.lines.iter().enumerate() {
                    let divided = line.discretised.as_ref();
                    let iterations = divided.map_or(0, |divided| divided.found.iterations);
                    work[index] += iterations * segments(index);
                }
            }
            Err(UnsolvedLine {
                line, iterations, ..
            }) => work[*line] += iterations * segments(*line),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::freedoms::{Freedoms, UnknownBodies};
    use super::super::super::line_physics::LinePhysics;
    use super::*;
    use crate::case::kind::parse_stored;
    use crate::system::SystemFile;

    #[test]
    fn a_search_without_an_end_is_given_up_by_the_name_of_its_line() {
        let text = r#"
            system.title = "a buoy in a current"
            materials.rope = { diameter_m = 0.1, mass_kg_per_m = 20.0, ea_n = 1e7 }
            lines = [{ name = "rope", from = "anchor", to = "buoy", material = "rope", length_m = 100.0, segments = 10 }]
            current = { speed_m_per_s = 0.5 }
            [points]
            anchor = { kind = "fixed", position_m = [0.0, 0.0, -90.0] }
            buoy = { kind = "free", mass_kg = 100.0, volume_m3 = 5.0 }
        "#;
        let solved = parse_stored::<SystemFile>(text, "trial.toml").unwrap();
        let network = &solved.network;
        let freedoms = Freedoms::of_network(network, UnknownBodies::Free);
        let place = solved.rest.placement.clone();
        let search =
            SystemEquilibriumSearch::begin(network, freedoms, place, LinePhysics::Full).unwrap();
        search.evaluate(&search.placement).unwrap();
        let of_one = search.work.borrow()[0];
        assert!(of_one > 0 && of_one.is_multiple_of(10), "{of_one}");
        search.work.borrow_mut()[0] = MOST_WORK + 1;
        let error = search.evaluate(&search.placement).unwrap_err();
        assert!(matches!(error, SystemError::TooMuchWork { line: 0, .. }));
        let error = search.result(Err(error)).unwrap_err();
        let said = crate::system::rest::refused(network, &error);
        assert_eq!(said.line.as_deref(), Some("rope"));
        assert!(said.problem.contains("given up"), "{}", said.problem);
    }
}
