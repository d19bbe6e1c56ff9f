//! Utilisation of the sections of a line, as a table.

use super::number::percent;
use super::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_model::case::Case;
use seacable_runs::run::Profile;
use seacable_runs::run::limits::{self, LimitCheck};

/// The word for a limit that is exceeded.
pub const EXCEEDED: &str = "EXCEEDED";

/// The sections of a case at the end of a run, as [`table`].
#[must_use]
pub fn of_run(case: &Case, profile: &Profile) -> Option<Table> {
    table(&limits::check(case, profile))
}

/// One row a section: tension against breaking load, bending radius against the least allowed. Nothing where no
/// material states a limit.
#[must_use]
pub fn table(checks: &[LimitCheck]) -> Option<Table> {
    if checks.is_empty() {
        return None;
    }
    let arc = NumberFormat::Decimals(1, "");
    let table = Table::of_records("", checks)
        .text("section", |c| c.section.as_str())
        .number("greatest tension", NumberFormat::Si("N"), |c| c.tension.0)
        .number("at arc [m]", arc, |c| c.tension.1)
        .number("breaking load", NumberFormat::Si("N"), |c| c.break_load)
        .cell("used", Align::Decimal, |c| used(c.tension_utilisation()))
        .number("least radius", NumberFormat::Si("m"), |c| {
            c.radius.map(|r| r.0)
        })
        .number("at arc [m]", arc, |c| c.radius.map(|r| r.1))
        .number("allowed", NumberFormat::Si("m"), |c| c.least_radius)
        .cell("used", Align::Decimal, |c| used(c.bending_utilisation()));
    Some(table.build())
}

/// How much of a limit is used; more than all of it is said in words too.
fn used(share: Option<f64>) -> Cell {
    match share {
        None => Cell::none(),
        Some(share) if share > 1.0 => {
            Cell::new(format!("{} {EXCEEDED}", percent(share)), CellStyle::Bad)
        }
        Some(share) => Cell::new(percent(share), CellStyle::Good),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(tension: f64) -> LimitCheck {
        LimitCheck {
            section: "upper".to_owned(),
            material: "umbilical".to_owned(),
            tension: (tension, 220.0),
            break_load: Some(1.4e6),
            radius: Some((9.2, 48.0)),
            least_radius: None,
        }
    }

    #[test]
    fn what_is_exceeded_says_so() {
        let table = table(&[check(1.6e4), check(2.8e6)]).unwrap();
        assert_eq!(table.cell(0, 4).ink, CellStyle::Good);
        assert_eq!(table.cell(1, 4).text, "200 % EXCEEDED");
        assert_eq!(table.cell(0, 8).text, "-");
        assert_eq!(super::table(&[]), None);
        assert_eq!(check(2.8e6).warnings().len(), 1);
        assert!(check(1.0).warnings().is_empty());
    }
}
