//! Limiting values of seas as a table, as CSV and as a chart.

use super::chart::{Axis, Chart, Series};
use super::table::{Align, Cell, CellStyle, Table};
use seacable_base::number::si;
use seacable_model::checks::utilisation::UtilisationVerdict;
use seacable_studies::study::points::Setting;
use seacable_studies::study::window::{WindowKey, WindowRow};

/// Curves of the chart, at most.
const MOST_CURVES: usize = 6;

/// The limiting values of the seas.
#[derive(Debug, Clone, Copy)]
pub struct WindowView<'a> {
    /// What was sought.
    pub key: &'a WindowKey,
    /// What was found.
    pub rows: &'a [WindowRow],
}

impl WindowView<'_> {
    /// A row a sea: its settings, the greatest value that passes, the least that does not, and what governs there.
    #[must_use]
    pub fn table(&self) -> Table {
        let numbered: Vec<(usize, &WindowRow)> = self.rows.iter().enumerate().collect();
        let name = self.name();
        let [least, greatest] = self.ends();
        Table::of_records(format!("Limiting {name}"), &numbered)
            .count("sea", |(number, _)| number + 1)
            .text("settings", |(_, row)| row.sea.words())
            .cell("passes at", Align::Decimal, |(_, row)| match row.bracket.passes {
                Some(place) => Cell::plain(self.value(place)),
                None if row.bracket.fails.is_some() => Cell::new("nowhere", CellStyle::Bad),
                None => Cell::none(),
            })
            .cell("not at", Align::Decimal, |(_, row)| match row.bracket.fails {
                Some((place, _)) => Cell::plain(self.value(place)),
                None => Cell::none(),
            })
            .cell("there it", Align::Left, |(_, row)| match row.bracket.fails {
                Some((_, UtilisationVerdict::Open)) => Cell::new(UtilisationVerdict::Open.word(), CellStyle::Warn),
                Some((_, verdict)) => Cell::plain(verdict.word()),
                None => Cell::none(),
            })
            .cell("governed by", Align::Left, |(_, row)| {
                row.governing.as_ref().map_or_else(Cell::none, |governing| {
                    let used = match governing.used.is_finite() {
                        true => format!("{:.3}", governing.used),
                        false => "beyond".to_owned(),
                    };
                    Cell::plain(format!("{} at {}, {used}", governing.check, governing.place))
                })
            })
            .build()
            .noted([format!(
                "The greatest {name} from {least} to {greatest} at which all checks pass with both errors, by bisection over {} values: what passes at one is taken to pass at all lower ones. Not settled: the limit lies within the errors of the seeds there are.",
                self.key.values.len()
            )])
    }

    /// The same with every digit.
    #[must_use]
    pub fn csv_table(&self) -> Table {
        let mut table = Table::of_records("", self.rows);
        let keys = self.rows.first().map_or(&[][..], |row| &row.sea.settings);
        for (column, setting) in keys.iter().enumerate() {
            table = table.text(&setting.key, move |row| {
                let own = row.sea.settings.get(column);
                own.map_or_else(String::new, Setting::written)
            });
        }
        let value = |place: Option<usize>| {
            let value = place.map(|place| self.key.values[place].to_string());
            Cell::plain(value.unwrap_or_default())
        };
        let key = &self.key.key.path;
        let governing =
            |row: &WindowRow,
             read: &dyn Fn(&seacable_studies::study::window::Governing) -> String| {
                row.governing.as_ref().map_or_else(String::new, read)
            };
        table
            .cell(&format!("{key}, passes"), Align::Right, |row| {
                value(row.bracket.passes)
            })
            .cell(&format!("{key}, does not"), Align::Right, |row| {
                value(row.bracket.fails.map(|(place, _)| place))
            })
            .text("there", |row| {
                row.bracket.fails.map_or("", |(_, verdict)| verdict.word())
            })
            .text("check", |row| governing(row, &|g| g.check.clone()))
            .text("place", |row| governing(row, &|g| g.place.clone()))
            .text("used", |row| governing(row, &|g| g.used.to_string()))
            .build()
    }

    /// The greatest value that passes against the first key that takes numbers, a curve for each set of the others; nothing where there is
    /// no such key or too many curves.
    #[must_use]
    pub fn chart(&self) -> Option<Chart> {
        let first = self.rows.first()?;
        let mut settings = first.sea.settings.iter();
        let across = settings.position(|setting| setting.value.number().is_some())?;
        let mut curves: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
        for row in self.rows {
            let (Some(place), Some(setting)) = (row.bracket.passes, row.sea.settings.get(across))
            else {
                continue;
            };
            let others = row.sea.settings.iter().enumerate();
            let others = others.filter(|(column, _)| *column != across);
            let name: Vec<String> = others.map(|(_, setting)| setting.as_override()).collect();
            let name = name.join(", ");
            let point = (setting.value.number()?, self.key.values[place]);
            match curves.iter_mut().find(|(known, _)| *known == name) {
                Some((_, points)) => points.push(point),
                None => curves.push((name, vec![point])),
            }
        }
        let drawn = (1..=MOST_CURVES).contains(&curves.len());
        let is_curve = curves.iter().any(|(_, points)| points.len() > 1);
        (drawn && is_curve).then(|| {
            let series = curves.into_iter().enumerate();
            let series = series.map(|(slot, (name, points))| Series::new(&name, slot, points));
            let unit = self.key.key.field.unit;
            let x = Axis::new(&first.sea.settings[across].key, "");
            let y = Axis::new(&self.name(), unit);
            Chart::new(
                format!("Greatest {} that passes", self.name()),
                x,
                y,
                series.collect(),
            )
        })
    }

    fn name(&self) -> String {
        self.key.key.field.label.to_owned()
    }

    fn value(&self, place: usize) -> String {
        si(self.key.values[place], self.key.key.field.unit)
    }

    fn ends(&self) -> [String; 2] {
        [0, self.key.values.len() - 1].map(|place| self.value(place))
    }
}
