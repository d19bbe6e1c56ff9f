//! Bodies on lines that do not hang at nodes.

use super::discretised::keeps_its_places;
use super::model::LineInputs;
use super::solved::SolvedSystem;

/// Lines in segments whose bodies hang between two nodes.
#[must_use]
pub fn off_nodes(solved: &SolvedSystem) -> Vec<String> {
    let SolvedSystem { file, network, .. } = solved;
    let in_time = file.in_time().is_some();
    let is_divided = |line: &LineInputs| {
        let own = network
            .line(&line.name)
            .map(|number| &network.lines[number]);
        in_time || own.is_some_and(|own| own.discretised.is_some() && !own.closed_where_known)
    };
    let lines = file.lines.iter();
    let off = lines.filter(|line| is_divided(line) && !keeps_its_places(file, line, 1));
    let remark = |line: &LineInputs| {
        format!(
            "Bodies on line {} hang at the nearest nodes: choose the segments of their sections so that a node lies where each hangs.",
            line.name
        )
    };
    off.map(remark).collect()
}
