//! The line node by node as a table, with the greatest values marked.

use super::number::{digits, rounded};
use super::table::{Align, Cell, CellStyle, Table};
use seacable_runs::run::Profile;

/// A column of numbers: its head and values, and of those whose greatest value is marked the name and node of the mark.
struct NodeNumbers {
    head: &'static str,
    values: Vec<f64>,
    mark: Option<(&'static str, usize)>,
}

impl NodeNumbers {
    fn new(head: &'static str, values: Vec<f64>) -> Self {
        let mark = None;
        Self { head, values, mark }
    }

    /// The first node with the greatest value is marked by this name.
    fn marked(head: &'static str, values: &[f64], name: &'static str) -> Self {
        let all = values.iter().enumerate();
        let best = all.reduce(|best, here| if here.1 > best.1 { here } else { best });
        Self {
            mark: best.map(|(node, _)| (name, node)),
            ..Self::new(head, values.to_vec())
        }
    }

    /// The name of the mark at a node.
    fn mark_at(&self, node: usize) -> Option<&'static str> {
        let mark = self.mark.filter(|(_, at)| *at == node);
        mark.map(|(name, _)| name)
    }

    fn cell(&self, node: usize) -> Cell {
        let text = self.values.get(node).map(|value| match self.mark {
            Some(_) => digits(*value, 4),
            None => rounded(*value, 2),
        });
        let ink = self
            .mark_at(node)
            .map_or(CellStyle::Plain, |_| CellStyle::Warn);
        Cell::new(text.unwrap_or_default(), ink)
    }
}

fn columns(profile: &Profile) -> Vec<NodeNumbers> {
    let axis = |i: usize| profile.nodes.iter().map(|p| p[i]).collect();
    let mut list = vec![
        NodeNumbers::new("arc [m]", profile.arc.clone()),
        NodeNumbers::new("x [m]", axis(0)),
        NodeNumbers::new("y [m]", axis(1)),
        NodeNumbers::new("z [m]", axis(2)),
        NodeNumbers::marked("tension [N]", &profile.tension, "tension"),
    ];
    if profile.bends() {
        let curvature = NodeNumbers::marked("curvature [1/m]", &profile.curvature, "curvature");
        list.extend([
            curvature,
            NodeNumbers::marked("moment [N m]", &profile.moment, "moment"),
        ]);
    }
    list
}

/// The words of a node's marks: "tension, moment".
fn marks(columns: &[NodeNumbers], node: usize) -> String {
    let words: Vec<&str> = columns.iter().filter_map(|c| c.mark_at(node)).collect();
    words.join(", ")
}

/// All nodes at the end of the run; the node at which a value is greatest says so in the last column.
#[must_use]
pub fn table(profile: &Profile) -> Table {
    some(profile, |_| true)
}

/// As [`table`], with about so many rows: both ends, nodes at even intervals, and the marked ones.
#[must_use]
pub fn sampled(profile: &Profile, rows: usize) -> Table {
    let last = profile.nodes.len().saturating_sub(1);
    let every = profile.nodes.len().div_ceil(rows.max(1)).max(1);
    let mut table = some(profile, |node| node % every == 0 || node == last);
    if every > 1 {
        table.notes.push(format!(
            "Every {every}th node, the last, and those with a greatest value; profile.csv holds all {}.",
            profile.nodes.len()
        ));
    }
    table
}

fn some(profile: &Profile, wanted: impl Fn(usize) -> bool) -> Table {
    let columns = columns(profile);
    let is_marked = |node: usize| columns.iter().any(|c| c.mark_at(node).is_some());
    let nodes = (0..profile.nodes.len()).filter(|node| wanted(*node) || is_marked(*node));
    let nodes: Vec<usize> = nodes.collect();
    let table = columns
        .iter()
        .fold(Table::of_records("", &nodes), |table, column| {
            table.cell(column.head, Align::Decimal, |node| column.cell(*node))
        });
    table
        .cell("greatest", Align::Left, |node| {
            Cell::new(marks(&columns, *node), CellStyle::Warn)
        })
        .build()
}

/// All nodes as CSV, every digit kept, units in the heads.
#[must_use]
pub fn csv(profile: &Profile) -> String {
    let columns = columns(profile);
    let heads: Vec<&str> = columns.iter().map(|c| c.head).collect();
    let mut text = format!("node,{},greatest\n", heads.join(","));
    for node in 0..profile.nodes.len() {
        let values = columns.iter().map(|c| {
            let value = c.values.get(node);
            value.map(ToString::to_string).unwrap_or_default()
        });
        let values: Vec<String> = values.collect();
        // Marks are words and blanks; a semicolon keeps them in one field.
        let marks = marks(&columns, node).replace(',', ";");
        text.push_str(&format!("{node},{},{marks}\n", values.join(",")));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn profile() -> Profile {
        Profile {
            arc: vec![0.0, 1.0, 2.0],
            nodes: vec![[0.0, 0.0, -1.5], [0.5, 0.0, -0.75], [1.0, 0.0, 0.0]],
            tension: vec![10.0, 20.0, 30.0],
            curvature: vec![0.0, 0.25, 0.0],
            moment: vec![0.0, 715.0, 0.0],
            ..Profile::default()
        }
    }

    #[test]
    fn the_greatest_values_are_marked_in_words() {
        let table = table(&profile());
        let last = |row: usize| table.cell(row, table.columns.len() - 1).text;
        assert_eq!(
            [last(0), last(1), last(2)],
            ["", "curvature, moment", "tension"]
        );
        assert_eq!(table.cell(1, 5).ink, CellStyle::Warn);
        assert_eq!(table.cell(0, 5).ink, CellStyle::Plain);
    }

    #[test]
    fn a_sampled_table_keeps_ends_and_marks() {
        let mut long = profile();
        long.arc = (0..100).map(f64::from).collect();
        long.nodes = vec![[0.0; 3]; 100];
        long.tension = (0..100).map(|i| -f64::from((i - 37) * (i - 37))).collect();
        (long.curvature, long.moment) = (Vec::new(), Vec::new());
        let table = sampled(&long, 10);
        let arcs: Vec<String> = (0..table.rows.len())
            .map(|r| table.cell(r, 0).text)
            .collect();
        assert_eq!(arcs[..2], ["0.00", "10.00"]);
        assert!(arcs.contains(&"37.00".to_owned()) && arcs.contains(&"99.00".to_owned()));
        assert_eq!(arcs.len(), 12);
    }

    #[test]
    fn csv_holds_every_digit() {
        let mut profile = profile();
        profile.tension[1] = 1.0 / 3.0;
        let text = csv(&profile);
        let line = text.lines().nth(2).unwrap();
        assert_eq!(
            line,
            "1,1,0.5,0,-0.75,0.3333333333333333,0.25,715,curvature; moment"
        );
        assert!(text.starts_with("node,arc [m],x [m],"));
    }
}
