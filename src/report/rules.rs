//! Sets of rules as tables: what comes with the program, and the rules of one.

use super::table::{Align, Cell, Table};
use seacable_model::case::{CheckInputs, RuleSet};

/// The sets, by name.
#[must_use]
pub fn sets(sets: &[(&str, RuleSet)]) -> Table {
    Table::of_records("Sets of rules", sets)
        .text("rules", |(name, _)| *name)
        .text("standard", |(_, set)| set.about.title.as_str())
        .text("edition", |(_, set)| set.about.edition.as_str())
        .cell("checks", Align::Right, |(_, set)| {
            Cell::plain(set.checks.len().to_string())
        })
        .build()
        .noted(sets.iter().map(|(name, set)| format!("{name}: {}.", set.about.source)))
        .noted(["`[[checks]]` with `rules = \"NAME\"` holds a file to a set; `seacable rules NAME` lists its rules. Check them against your edition."])
}

/// The rules of a set.
#[must_use]
pub fn rules(set: &RuleSet) -> Table {
    let number = |value: Option<f64>| value.map_or_else(Cell::none, |v| Cell::plain(v.to_string()));
    Table::of_records(&set.about.title, &set.checks)
        .text("rule", |rule| rule.name.clone().unwrap_or_default())
        .text("kind", |rule| rule.kind.map_or("", |kind| kind.name()))
        .text("condition", |rule| rule.condition.name())
        .text("analysis", |rule| rule.analysis.name())
        .cell("factor", Align::Decimal, |rule| number(rule.factor))
        .cell("on mean", Align::Decimal, |rule| number(rule.mean_factor))
        .cell("on dynamic", Align::Decimal, |rule| {
            number(rule.dynamic_factor)
        })
        .cell("share of strength", Align::Decimal, |rule| {
            number(rule.strength_share)
        })
        .cell("limit", Align::Left, limit)
        .text("clause", |rule| rule.clause.clone().unwrap_or_default())
        .build()
        .noted([
            format!("{}.", set.about.edition),
            format!("{}.", set.about.source),
        ])
}

/// A limit of its own, with its unit.
fn limit(rule: &CheckInputs) -> Cell {
    match (rule.limit_n, rule.limit_m) {
        (Some(force), _) => Cell::plain(format!("{force} N")),
        (None, Some(length)) => Cell::plain(format!("{length} m")),
        (None, None) => Cell::none(),
    }
}
