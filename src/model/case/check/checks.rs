//! Checks against limits: each has what its kind needs, and nothing else.

use super::taken;
use crate::case::diagnostic::Finding;
use crate::case::fields::nearest;
use crate::case::model::{CheckKeys, CheckKind};
use crate::case::rule_sets::{NAMES, is_shipped};

/// The extension of a file of rules or of a curve.
const TOML: &str = ".toml";

/// What a kind of check needs: the keys of one of these lists.
const fn needs(kind: CheckKind) -> &'static [&'static [&'static str]] {
    match kind {
        CheckKind::SafetyFactor => &[&["factor"]],
        CheckKind::PartialFactors => &[&["mean_factor", "dynamic_factor"]],
        CheckKind::LeastTension => &[&["limit_n"], &["strength_share"]],
        CheckKind::BendRadius => &[&["limit_m"]],
        CheckKind::Uplift => &[&["limit_n"]],
        CheckKind::Offset | CheckKind::SurfaceClearance => &[&["limit_m", "of"]],
        CheckKind::BedClearance => &[&["limit_m", "of"], &["limit_m", "stretch_m"]],
        CheckKind::Fatigue => &[&["curve"]],
    }
}

/// What it may have besides.
const fn takes(kind: CheckKind) -> &'static [&'static str] {
    match kind {
        CheckKind::SafetyFactor | CheckKind::PartialFactors => {
            &["of", "strength_share", "break_load_n"]
        }
        CheckKind::LeastTension => &["of", "break_load_n"],
        CheckKind::Uplift => &["of"],
        CheckKind::BendRadius => &["of", "stretch_m"],
        CheckKind::Fatigue => &[
            "of",
            "factor",
            "break_load_n",
            "diameter_m",
            "along",
            "section",
            "units",
            "slip",
        ],
        _ => &[],
    }
}

/// Whether a key matters in a check of a set of rules, or of this kind.
pub(crate) fn is_of_check(key: &str, (by_rules, kind): (bool, Option<&str>)) -> bool {
    if by_rules {
        return key == "rules" || OF_RULES.contains(&key);
    }
    let own = ["name", "clause", "kind", "condition", "analysis"];
    let all = CheckKind::ALL.iter().copied();
    let kind = all.into_iter().find(|known| Some(known.name()) == kind);
    let of_kind = kind.is_some_and(|kind| {
        let mut needed = needs(kind).iter().copied().flatten();
        takes(kind).contains(&key) || needed.any(|known| *known == key)
    });
    own.contains(&key) || of_kind
}

/// What rules of a set take besides.
const OF_RULES: [&str; 5] = ["only", "of", "break_load_n", "diameter_m", "along"];

/// Checks the checks of a file.
pub fn of_checks(checks: &[(String, CheckKeys<'_>)]) -> Vec<Finding> {
    let mut found = same_names(checks);
    for (_, check) in checks {
        match (check.rules.is_given(), check.kind.is_given()) {
            (true, false) => found.extend(of_set(check)),
            (false, true) => found.extend(of_kind(check)),
            (true, true) => found.extend(check.kind.if_given(
                "the check has rules and a kind",
                "give each a table of its own",
            )),
            (false, false) => found.push(check.kind.finding_at_table(
                "the check says neither what it compares nor by which rules",
                format!(
                    "add `rules = \"...\"` ({}) or `kind = \"...\"`",
                    NAMES.join(", ")
                ),
            )),
        }
    }
    found
}

/// Damage along a line is stored by the name of its check.
fn same_names(checks: &[(String, CheckKeys<'_>)]) -> Vec<Finding> {
    let along = checks.iter().map(|(_, check)| check).filter(|check| {
        let counts = check.along.get() == Some(&true) || check.section.is_given();
        counts && check.kind.is_given()
    });
    let mut known: Vec<Option<&String>> = Vec::new();
    let mut found = Vec::new();
    for check in along {
        let name = check.name.get();
        if known.contains(&name) {
            let problem = "another check along the lines has the same name";
            found.push(
                check
                    .kind
                    .finding(problem, "give each `name = \"...\"` of its own"),
            );
        }
        known.push(name);
    }
    found
}

/// Rules of a standard: the set is shipped or a file.
fn of_set(check: &CheckKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let named = check.rules.get().map(String::as_str).unwrap_or_default();
    if !named.is_empty() && !named.ends_with(TOML) && !is_shipped(named) {
        let remedy = match nearest(named, NAMES.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the sets are {}; a file ends in {TOML}", NAMES.join(", ")),
        };
        found.push(check.rules.finding("there is no such set of rules", remedy));
    }
    found.extend(unused(
        check,
        &|name| OF_RULES.contains(&name),
        "rules of a set",
    ));
    found
}

fn of_kind(check: &CheckKeys<'_>) -> Vec<Finding> {
    let Some(kind) = check.kind.get().copied() else {
        return Vec::new();
    };
    let mut found = Vec::new();
    let given = given(check);
    let is_given = |name: &str| given.iter().any(|(known, is)| *known == name && *is);
    let lists = needs(kind);
    if !lists
        .iter()
        .any(|list| list.iter().all(|name| is_given(name)))
    {
        let lists: Vec<String> = lists
            .iter()
            .map(|list| {
                list.iter()
                    .map(|name| format!("`{name}`"))
                    .collect::<Vec<_>>()
                    .join(" and ")
            })
            .collect();
        let problem = format!("a check of {} lacks its numbers", kind.name());
        found.push(
            check
                .kind
                .finding(problem, format!("add {}", lists.join(", or "))),
        );
    }
    let allowed =
        |name: &str| takes(kind).contains(&name) || lists.iter().any(|list| list.contains(&name));
    found.extend(unused(
        check,
        &allowed,
        &format!("a check of {}", kind.name()),
    ));
    found.extend(of_section(check));
    found.extend(taken::forward(&check.stretch_m));
    if kind == CheckKind::BedClearance
        || kind == CheckKind::Offset
        || kind == CheckKind::SurfaceClearance
    {
        let none = check.of.get().is_some_and(Vec::is_empty);
        found.extend(none.then(|| {
            check
                .of
                .finding("names nothing", "name points, bodies or lines")
        }));
    }
    found
}

/// What goes with a cross-section, or only without one.
fn of_section(check: &CheckKeys<'_>) -> Vec<Finding> {
    let Some(name) = check.section.get() else {
        let alone = "is of the units of a cross-section, which is not given";
        let remedy = "add `section = \"NAME.toml\"`, or leave it out";
        let given = [
            check.units.if_given(alone, remedy),
            check.slip.if_given(alone, remedy),
        ];
        return given.into_iter().flatten().collect();
    };
    let is_file = name.ends_with(TOML);
    let file = (!is_file).then(|| {
        let remedy = "name a file of a section, as `seacable section` reads it, that ends in .toml";
        check.section.finding("is no file", remedy)
    });
    let problem =
        "is of the line as a whole, and the units of the cross-section have their own stress";
    let whole = [
        check.break_load_n.if_given(problem, "leave it out"),
        check.diameter_m.if_given(problem, "leave it out"),
    ];
    file.into_iter()
        .chain(whole.into_iter().flatten())
        .collect()
}

/// The keys that only some kinds have, and whether each is given.
fn given(check: &CheckKeys<'_>) -> [(&'static str, bool); 16] {
    [
        ("only", check.only.is_given()),
        ("of", check.of.is_given()),
        ("stretch_m", check.stretch_m.is_given()),
        ("factor", check.factor.is_given()),
        ("mean_factor", check.mean_factor.is_given()),
        ("dynamic_factor", check.dynamic_factor.is_given()),
        ("strength_share", check.strength_share.is_given()),
        ("break_load_n", check.break_load_n.is_given()),
        ("limit_n", check.limit_n.is_given()),
        ("limit_m", check.limit_m.is_given()),
        ("curve", check.curve.is_given()),
        ("diameter_m", check.diameter_m.is_given()),
        ("along", check.along.get() == Some(&true)),
        ("section", check.section.is_given()),
        ("units", check.units.is_given()),
        ("slip", check.slip.is_given()),
    ]
}

/// Keys that are given and not used.
fn unused(check: &CheckKeys<'_>, allowed: &dyn Fn(&str) -> bool, by: &str) -> Vec<Finding> {
    let problem = |name: &str| format!("`{name}` is not used by {by}");
    let remedy = "leave it out";
    let keys = [
        check.only.if_given(problem("only"), remedy),
        check.of.if_given(problem("of"), remedy),
        check.stretch_m.if_given(problem("stretch_m"), remedy),
        check.factor.if_given(problem("factor"), remedy),
        check.mean_factor.if_given(problem("mean_factor"), remedy),
        check
            .dynamic_factor
            .if_given(problem("dynamic_factor"), remedy),
        check
            .strength_share
            .if_given(problem("strength_share"), remedy),
        check.break_load_n.if_given(problem("break_load_n"), remedy),
        check.limit_n.if_given(problem("limit_n"), remedy),
        check.limit_m.if_given(problem("limit_m"), remedy),
        check.curve.if_given(problem("curve"), remedy),
        check.diameter_m.if_given(problem("diameter_m"), remedy),
        check
            .along
            .if_given(problem("along"), remedy)
            .filter(|_| check.along.get() == Some(&true)),
        check.section.if_given(problem("section"), remedy),
        check.units.if_given(problem("units"), remedy),
        check.slip.if_given(problem("slip"), remedy),
    ];
    let names = given(check).map(|(name, _)| name);
    keys.into_iter()
        .zip(names)
        .filter(|(_, name)| !allowed(name))
        .filter_map(|(finding, _)| finding)
        .collect()
}
