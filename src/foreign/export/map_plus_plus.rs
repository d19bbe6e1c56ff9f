//! The text of a file of MAP++.

use super::number::{all_written, written};
use super::sheet::{Sheet, SheetLine, SheetPoint, TypeRow};

/// The file. Free nodes have what MAP++ solves for behind `#`.
#[must_use]
pub fn text(sheet: &Sheet) -> String {
    let tables = [
        table(
            "LINE DICTIONARY",
            [
                "LineType  Diam  MassDenInAir  EA  CB  CIntDamp  Ca  Cdn  Cdt",
                "(-)  (m)  (kg/m)  (N)  (-)  (Pa-s)  (-)  (-)  (-)",
            ],
            sheet.types.iter().map(type_row),
        ),
        table(
            "NODE PROPERTIES",
            [
                "Node  Type  X  Y  Z  M  B  FX  FY  FZ",
                "(-)  (-)  (m)  (m)  (m)  (kg)  (m^3)  (N)  (N)  (N)",
            ],
            (1..).zip(&sheet.points).map(point_row),
        ),
        table(
            "LINE PROPERTIES",
            [
                "Line  LineType  UnstrLen  NodeAnch  NodeFair  Flags",
                "(-)  (-)  (m)  (-)  (-)  (-)",
            ],
            (1..).zip(&sheet.lines).map(line_row),
        ),
        table(
            "SOLVER OPTIONS",
            ["Option", "(-)"],
            ["outer_tol 1e-8".to_owned()].into_iter(),
        ),
    ];
    tables.concat()
}

/// A table with its title and both rows of its header.
fn table(title: &str, heads: [&str; 2], rows: impl Iterator<Item = String>) -> String {
    let mut text = format!("---------------------- {title} ----------------------\n");
    for row in heads.into_iter().map(str::to_owned).chain(rows) {
        text += row.trim_end();
        text.push('\n');
    }
    text
}

fn type_row(of: &TypeRow) -> String {
    format!(
        "{}  {}  {}  {}",
        of.name,
        all_written(&[of.diameter, of.mass]),
        of.ea,
        all_written(&[of.friction])
    ) + &format!(
        "  {}  {}",
        of.damping,
        all_written(&[of.added_mass[0], of.drag[0], of.drag[1]])
    )
}

fn point_row((number, point): (usize, &SheetPoint)) -> String {
    let [x, y, z] = point.place.map(written);
    let own = all_written(&[point.mass, point.volume]);
    match point.hold.as_str() {
        "Free" => format!(
            "{number}  Connect  #{x}  #{y}  #{z}  {own}  {}",
            all_written(&point.load)
        ),
        "Fixed" => format!("{number}  Fix  {x}  {y}  {z}  {own}  #  #  #"),
        _ => format!("{number}  Vessel  {x}  {y}  {z}  {own}  #  #  #"),
    }
}

fn line_row((number, line): (usize, &SheetLine)) -> String {
    format!(
        "{number}  {}  {}  {}  {}  tension_fair  tension_anch{}",
        line.of_type,
        written(line.length),
        line.ends[0],
        line.ends[1],
        if line.without_bed {
            "  omit_contact"
        } else {
            ""
        }
    )
}
