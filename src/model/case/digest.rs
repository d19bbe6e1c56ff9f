//! Digests of the tables of a case from which its line and its motion follow, so that a checkpoint is known to be of its case.

use std::collections::BTreeMap;

use toml_edit::DocumentMut;

use super::model::{Case, CaseInfo, EndKind, Output, Solver, StatisticsInputs};
use super::schema::{TableType, WrittenKeys};

/// The digest of every such table by its name: the whole case without what only describes, records or judges it, how long
/// it is computed and whether errors are estimated. Keys that hold their default count as left out.
#[must_use]
pub fn digests(case: &Case) -> BTreeMap<String, String> {
    let table = physics(case).write(WrittenKeys::WithoutDefaults);
    let digest = |(name, item): (String, toml_edit::Item)| {
        let mut alone = toml_edit::Table::new();
        alone.insert(&name, item);
        let text = DocumentMut::from(alone).to_string();
        (name, format!("{:016x}", fnv1a(text.as_bytes())))
    };
    let named = table
        .into_iter()
        .map(|(name, item)| (name.to_string(), item));
    named.map(digest).collect()
}

/// The digest of a text, by which texts are known to be the same.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextDigest(pub u64);

impl TextDigest {
    /// The digest of this text.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        Self(fnv1a(text.as_bytes()))
    }
}

/// The case without all that changes no state of its line.
fn physics(case: &Case) -> Case {
    let mut kept = case.clone();
    let solver = Solver::default();
    kept.case = CaseInfo::default();
    kept.output = Output::default();
    kept.solver.duration_s = solver.duration_s;
    kept.solver.error_estimate = solver.error_estimate;
    kept.modes = None;
    kept.marks.clear();
    kept.study.clear();
    kept.load_cases.clear();
    kept.statistics = StatisticsInputs::default();
    kept.checks.clear();
    kept.published.clear();
    kept.published_curve.clear();
    kept.trend.clear();
    kept.trial.clear();
    let ends = [&case.ends.a, &case.ends.b];
    let moving = ends.into_iter().filter(|end| end.kind == EndKind::Moving);
    let named: Vec<_> = moving.filter_map(|end| end.motion_file.as_ref()).collect();
    kept.files.retain(|name, _| named.contains(&name));
    kept
}

/// The 64-bit hash FNV-1a of Fowler, Noll and Vo (RFC 9923): the same in every version and on every machine.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{edit, parse, shipped::SHIPPED};

    #[test]
    fn the_hash_is_that_of_its_authors() {
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn what_moves_the_line_counts_and_nothing_else() {
        let text = SHIPPED
            .iter()
            .find(|case| case.0.ends_with("manifold_on_bed.toml"));
        let text = text.unwrap().1;
        let of = |edits: &[(&str, &str)]| {
            let text = edit::set_all(text, edits).unwrap();
            digests(&parse(&text, "case").unwrap())
        };
        let before = of(&[]);
        let same = [
            ("case.title", "another"),
            ("output.interval_s", "0.25"),
            ("solver.duration_s", "300"),
            ("solver.error_estimate", "false"),
            ("solver.max_iterations", "30"),
        ];
        assert_eq!(of(&same), before);
        for (table, key, value) in [
            ("materials", "materials.wire.ea_n", "6.3e8"),
            ("solver", "solver.rho_inf", "0.3"),
            ("seabed", "seabed.friction", "0.4"),
            ("ends", "ends.a.motion_interpolation", "linear"),
            ("line", "line.wire.segments", "4"),
        ] {
            let after = of(&[(key, value)]);
            let changed = before
                .iter()
                .filter(|(name, digest)| after[*name] != **digest);
            let changed: Vec<_> = changed.map(|(name, _)| name.as_str()).collect();
            assert_eq!(changed, [table]);
        }
        let moved = text.replace("80,2,0,-19.55", "80,2,0,-19.56");
        let after = digests(&parse(&moved, "case").unwrap());
        assert_ne!(after["files"], before["files"]);
    }
}
