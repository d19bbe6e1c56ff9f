//! The damaged condition: a system without the line that is lost.

use super::build::{angles, copy_name};
use super::model::{LineInputs, SystemFile};

/// The file without the line, or the copy of a line, that it states as lost: whatever reads it afterwards knows nothing of that line.
#[must_use]
pub(super) fn without_lost_line(mut file: SystemFile) -> SystemFile {
    let lost = &file.damage.lost_line;
    let is_left = |line: &mut LineInputs| {
        let all = angles(&line.repeat_at_deg).to_vec();
        let mut left = all.clone();
        left.retain(|angle| copy_name(&line.name, *angle) != *lost);
        if left.len() < all.len() {
            line.repeat_at_deg.clone_from(&left);
        }
        !left.is_empty()
    };
    file.lines.retain_mut(is_left);
    file
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::kind;
    use crate::system::SolvedSystem;

    fn solved(lost: &str) -> SolvedSystem {
        let text = include_str!("../../../cases/systems/oc3_spar.toml");
        let (_, solved) = kind::set_and_compute::<SystemFile>(
            &format!("{text}\n[damage]\n"),
            &[("damage.lost_line", lost)],
        )
        .unwrap();
        solved
    }

    /// The lines of the file are those of the network, which exports and reports count on.
    #[test]
    fn the_lost_line_is_in_neither_file_nor_network() {
        let names = |solved: &SolvedSystem| {
            let lines = solved.network.lines.iter();
            lines.map(|line| line.name.clone()).collect::<Vec<_>>()
        };
        let whole = solved("none");
        assert_eq!(names(&whole).len(), 3);
        for (lost, left) in [
            ("mooring", ["mooring@120", "mooring@240"]),
            ("mooring@120", ["mooring", "mooring@240"]),
        ] {
            let found = solved(lost);
            assert_eq!(names(&found), left);
            let copies = found.file.lines.iter().flat_map(|line| {
                angles(&line.repeat_at_deg)
                    .iter()
                    .map(|angle| copy_name(&line.name, *angle))
            });
            assert_eq!(copies.collect::<Vec<_>>(), left);
            // The other lines hang as they did: the spar is held.
            let tension = |solved: &SolvedSystem, name: &str| {
                let line = solved.network.line(name).unwrap();
                solved.rest.balance.lines[line].tensions()[1]
            };
            let change = tension(&found, "mooring@240") / tension(&whole, "mooring@240") - 1.0;
            assert!(change.abs() < 1e-12, "{lost}: {change}");
        }
    }
}
