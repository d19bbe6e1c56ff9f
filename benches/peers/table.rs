//! Rows of a table, and how many times slower a peer is at no smaller error.

use crate::place::{Cost, Peer};

/// What a row is of.
pub(crate) struct Row {
    /// The other program; none here.
    pub(crate) peer: Option<Peer>,
    pub(crate) setting: String,
    /// Errors as their heads say.
    pub(crate) errors: Vec<f64>,
    pub(crate) cost: Cost,
}

pub(crate) struct Table {
    title: String,
    heads: Vec<&'static str>,
    rows: Vec<Row>,
    remarks: Vec<String>,
}

impl Table {
    pub(crate) fn new(title: &str, heads: &[&'static str]) -> Self {
        Self {
            title: title.to_owned(),
            heads: heads.to_vec(),
            rows: Vec::new(),
            remarks: Vec::new(),
        }
    }

    pub(crate) fn add(
        &mut self,
        peer: Option<Peer>,
        setting: impl Into<String>,
        errors: &[f64],
        cost: Cost,
    ) {
        let setting = setting.into();
        self.rows.push(Row {
            peer,
            setting,
            errors: errors.to_vec(),
            cost,
        });
    }

    pub(crate) fn remark(&mut self, text: impl Into<String>) {
        self.remarks.push(text.into());
    }

    /// Prints it. A peer is compared with the cheapest row here whose errors, squared and summed, are not greater than its own.
    pub(crate) fn print(&self) {
        println!("\n{}", self.title);
        let heads: String = self
            .heads
            .iter()
            .map(|head| format!(" {head:>14}"))
            .collect();
        println!(
            "{:<66}{heads} {:>11} {:>11} {:>7}",
            "", "process ms", "inside ms", "slower"
        );
        for row in &self.rows {
            let name = row.peer.map_or("seacable", Peer::name);
            let errors: String = row
                .errors
                .iter()
                .map(|error| format!(" {:>14}", written(*error)))
                .collect();
            let inside = row
                .cost
                .inside
                .map_or_else(String::new, |time| format!("{:.2}", 1e3 * time));
            println!(
                "{:<66}{errors} {:>11.2} {inside:>11} {:>7}",
                format!("{name}, {}", row.setting),
                1e3 * row.cost.process,
                self.slower(row)
            );
        }
        for remark in &self.remarks {
            println!("{remark}");
        }
    }

    fn slower(&self, row: &Row) -> String {
        if row.peer.is_none() {
            return String::new();
        }
        let squares = |of: &Row| of.errors.iter().map(|error| error * error).sum::<f64>();
        let here = self.rows.iter().filter(|other| other.peer.is_none());
        let as_exact = here.filter(|other| squares(other) <= squares(row));
        let times = as_exact.map(|other| other.cost.process);
        match times.fold(f64::INFINITY, f64::min) {
            time if time.is_finite() => format!("{:.1}", row.cost.least() / time),
            _ => "-".to_owned(),
        }
    }
}

/// An error in percent or in m: fixed where it is not small.
fn written(error: f64) -> String {
    if error == 0.0 || error >= 1e-3 {
        format!("{error:.3}")
    } else {
        format!("{error:.1e}")
    }
}
