//! The text of a file of MAP++.

use super::number::{all_written, written};
use super::sheet::Sheet;

/// The file. Free nodes have what MAP++ solves for behind `#`.
#[must_use]
pub fn text(sheet: &Sheet) -> String {
    let mut text = String::new();
    let mut table = |title: &str, heads: [&str; 2], rows: Vec<String>| {
        text += &format!("---------------------- {title} ----------------------\n");
        for row in heads.into_iter().map(str::to_owned).chain(rows) {
            text += row.trim_end();
            text.push('\n');
        }
    };
    let types = sheet.types.iter().map(|of| {
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
    });
    table(
        "LINE DICTIONARY",
        [
            "LineType  Diam  MassDenInAir  EA  CB  CIntDamp  Ca  Cdn  Cdt",
            "(-)  (m)  (kg/m)  (N)  (-)  (Pa-s)  (-)  (-)  (-)",
        ],
        types.collect(),
    );
    let nodes = sheet.points.iter().zip(1..).map(|(point, number)| {
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
    });
    table(
        "NODE PROPERTIES",
        [
            "Node  Type  X  Y  Z  M  B  FX  FY  FZ",
            "(-)  (-)  (m)  (m)  (m)  (kg)  (m^3)  (N)  (N)  (N)",
        ],
        nodes.collect(),
    );
    let lines = sheet.lines.iter().zip(1..).map(|(line, number)| {
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
    });
    table(
        "LINE PROPERTIES",
        [
            "Line  LineType  UnstrLen  NodeAnch  NodeFair  Flags",
            "(-)  (-)  (m)  (-)  (-)  (-)",
        ],
        lines.collect(),
    );
    table(
        "SOLVER OPTIONS",
        ["Option", "(-)"],
        vec!["outer_tol 1e-8".to_owned()],
    );
    text
}
