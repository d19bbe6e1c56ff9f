//! A design in tables: layers, stiffness, weight, who carries a tension.

use super::design::Design;
use super::layout::{Helix, Shell};
use super::misfit::mm;
use super::model::{Core, Voids};
use super::stiffness::{Twist, ea_with_pressure};
use super::strength::{Share, shares};
use crate::report::number::{digits, percent, si};
use crate::report::table::{Cell, CellInk, Column, Table};

/// The layers, from the inside out.
#[must_use]
pub fn layers(design: &Design) -> Table {
    let mut rows = Vec::new();
    if let Some(centre) = &design.layout.centre {
        rows.push(row(
            "centre",
            &format!("{} {}", centre.element.what, centre.element.name),
            ["straight".to_owned(), "-".into(), "-".into(), "-".into()],
            [2.0 * centre.radius, centre.mass()],
        ));
    }
    for shell in &design.layout.shells {
        rows.push(match shell {
            Shell::Helix(helix) => helix_row(helix),
            Shell::Tube(tube) => row(
                &tube.words.name,
                &format!("sheath of {}", mm(tube.words.thickness_m)),
                ["-".to_owned(), "-".into(), "-".into(), "-".into()],
                [2.0 * tube.outer_radius, tube.mass()],
            ),
        });
    }
    Table {
        title: "Layers, from the inside out".to_owned(),
        columns: vec![
            Column::left("layer"),
            Column::left("made of"),
            Column::left("lay angle"),
            Column::decimal("pitch radius"),
            Column::decimal("lay length"),
            Column::decimal("cover"),
            Column::decimal("outer diameter"),
            Column::decimal("mass"),
        ],
        rows,
        notes: Vec::new(),
    }
}

fn helix_row(helix: &Helix) -> Vec<Cell> {
    let side = if helix.angle < 0.0 { "left" } else { "right" };
    let angle = digits(helix.angle.abs().to_degrees(), 4);
    let around = [
        format!("{angle} deg {side}"),
        mm(helix.pitch_radius),
        si(helix.lay_length(), "m"),
        percent(helix.coverage),
    ];
    row(
        &helix.name,
        &made_of(helix),
        around,
        [2.0 * helix.outer_radius, helix.mass()],
    )
}

fn row(name: &str, made_of: &str, around: [String; 4], sizes: [f64; 2]) -> Vec<Cell> {
    let [diameter, mass] = sizes;
    let mut cells = vec![Cell::plain(name), Cell::plain(made_of)];
    cells.extend(around.map(Cell::plain));
    cells.push(Cell::plain(mm(diameter)));
    cells.push(Cell::plain(si(mass, "kg/m")));
    cells
}

/// "6 tubes hydraulic, 1 optical fibre"; of wires, how many and how thick.
fn made_of(helix: &Helix) -> String {
    let mut kinds: Vec<(&str, usize)> = Vec::new();
    for unit in &helix.elements {
        match kinds.iter_mut().find(|kind| kind.0 == unit.name) {
            Some(kind) => kind.1 += 1,
            None => kinds.push((&unit.name, 1)),
        }
    }
    let wire = helix.elements.first().filter(|_| helix.armour);
    if let Some(wire) = wire {
        return format!(
            "{} wires of {}",
            helix.elements.len(),
            mm(2.0 * wire.radius)
        );
    }
    let words: Vec<String> = kinds
        .iter()
        .map(|(name, count)| format!("{count} {name}"))
        .collect();
    words.join(", ")
}

/// Stiffness, with both kinds of middle side by side.
#[must_use]
pub fn stiffness(design: &Design) -> Table {
    let mut rows = tension_and_torsion(design);
    rows.extend(bending(design));
    Table {
        title: "Stiffness".to_owned(),
        columns: vec![
            Column::left("quantity"),
            Column::decimal("rigid core, Theta = 0"),
            Column::decimal("incompressible core, Theta = 1"),
            Column::decimal("model error"),
            Column::left("theory"),
        ],
        rows,
        notes: stiffness_notes(design),
    }
}

fn tension_and_torsion(design: &Design) -> Vec<Vec<Cell>> {
    const TENSION: &str = "Knapp, eqs. (16)-(17)";
    let (rigid, soft) = (&design.rigid, &design.incompressible);
    let both = |name: &str, rigid: f64, soft: f64, unit: &str, theory: &str| {
        let has_core = design.layout.centre.is_some();
        let spread = if has_core {
            spread(rigid, soft)
        } else {
            "not known".to_owned()
        };
        both(name, rigid, soft, unit, &spread, theory)
    };
    vec![
        both(
            "EA, ends held from turning",
            rigid.ea(Twist::Held),
            soft.ea(Twist::Held),
            "N",
            TENSION,
        ),
        both(
            "EA, ends free to turn",
            rigid.ea(Twist::Free),
            soft.ea(Twist::Free),
            "N",
            TENSION,
        ),
        both(
            "GJ, length held",
            rigid.gj_held_length(),
            soft.gj_held_length(),
            "N m²",
            TENSION,
        ),
        both(
            "GJ, length free",
            rigid.gj_free_length(),
            soft.gj_free_length(),
            "N m²",
            TENSION,
        ),
        both(
            "tension by twist per length",
            rigid.tension_twist,
            soft.tension_twist,
            "N m",
            TENSION,
        ),
        both(
            "torque by strain",
            rigid.torque_strain,
            soft.torque_strain,
            "N m",
            TENSION,
        ),
    ]
}

fn bending(design: &Design) -> [Vec<Cell>; 4] {
    let bending = &design.bending;
    let rows = [
        (
            "EI, all slips",
            bending.total(),
            "the two rows below together",
        ),
        (
            "EI of units, wires, middle",
            bending.helices + bending.centre,
            "Costello, eqs. (18)-(19)",
        ),
        ("EI of the sheaths", bending.sheaths, "E I of a tube"),
        (
            "EI, nothing slips",
            bending.stuck(),
            "plane sections stay plane",
        ),
    ];
    rows.map(|(name, value, theory)| alone(name, value, theory))
}

/// How far the two kinds of middle are apart.
fn spread(rigid: f64, soft: f64) -> String {
    // A difference of a few parts in 1e12 is rounding.
    let apart = (rigid - soft).abs();
    let size = rigid.abs().max(soft.abs());
    if apart > 1e-9 * size {
        percent(apart / size)
    } else {
        "0 %".to_owned()
    }
}

fn both(name: &str, rigid: f64, soft: f64, unit: &str, spread: &str, theory: &str) -> Vec<Cell> {
    vec![
        Cell::plain(name),
        Cell::plain(si(rigid, unit)),
        Cell::plain(si(soft, unit)),
        Cell::plain(spread),
        Cell::plain(theory),
    ]
}

fn alone(name: &str, value: f64, theory: &str) -> Vec<Cell> {
    vec![
        Cell::plain(name),
        Cell::plain(si(value, "N m²")),
        Cell::plain(si(value, "N m²")),
        Cell::plain("-"),
        Cell::plain(theory),
    ]
}

fn stiffness_notes(design: &Design) -> Vec<String> {
    let mut notes = vec![
        "Equations as numbered in Lin et al. 2016, Periodical of Ocean University of China 46(12), 111-116; tension and torsion after Knapp 1979, bending after Costello and Phillips 1976.".to_owned(),
        "Model error: the spread between a core that keeps its diameter and one that keeps its volume. A real core lies between them, or is softer. The arithmetic itself is exact to rounding.".to_owned(),
    ];
    if design.layout.centre.is_some() {
        notes.push(format!(
            "With an incompressible core the coupling is not symmetric, as eqs. (16)-(17) count the tension of the wires but not the pressure in the core. With that pressure, EA with ends held would be {}.",
            si(ea_with_pressure(&design.layout), "N")
        ));
    } else {
        notes.push("There is no central cylinder to squeeze, so both columns agree, and the model error is not known.".to_owned());
    }
    notes.push(
        "Positive coupling: under tension the cable wants to unwind its right-handed layers."
            .to_owned(),
    );
    notes.push("EI lies between its two values: a cable is stiff until its layers slip, and soft at large curvature. The spread between them is a model error; where friction lets the layers slip is not worked out. A line takes the value of full slip.".to_owned());

    let (ea, gj) = design.sheaths;
    if ea > 0.0 {
        notes.push(format!(
            "Not in EA and GJ, as eqs. (16)-(17) leave sheaths out: the sheaths alone would add {} and {}.",
            si(ea, "N"),
            si(gj, "N m²")
        ));
    }
    notes
}

/// Size, weight, strength: what else a line needs.
#[must_use]
pub fn whole(design: &Design) -> Table {
    let weight = &design.weight;
    let gaps = match design.section.about.voids {
        Voids::Dry => "gaps dry",
        Voids::Flooded => "gaps flooded",
    };
    let mut rows = vec![
        fact(
            "outer diameter",
            mm(2.0 * design.layout.outer_radius),
            "sum of the layers",
        ),
        fact(
            "mass in air",
            si(weight.in_air, "kg/m"),
            "gaps empty, tubes as filled",
        ),
        fact("mass that moves in water", si(weight.moving, "kg/m"), gaps),
        fact("weight in water", si(weight.in_water_force, "N/m"), gaps),
        fact(
            "weight in water, as mass",
            si(weight.in_water, "kg/m"),
            gaps,
        ),
        fact(
            "gaps",
            format!("{} mm²", digits(1e6 * weight.voids, 4)),
            "what no unit, filler or sheath takes",
        ),
    ];
    rows.extend(strength(design));
    Table {
        title: "The cable as a whole".to_owned(),
        columns: vec![
            Column::left("quantity"),
            Column::decimal("value"),
            Column::left("how"),
        ],
        rows,
        notes: Vec::new(),
    }
}

fn strength(design: &Design) -> Vec<Vec<Cell>> {
    let Some(strength) = &design.strength else {
        return vec![fact(
            "breaking load",
            "not known".to_owned(),
            "no unit that carries has a strength or breaking load",
        )];
    };
    let (layer, unit) = &strength.weakest;
    let weakest = if layer == unit {
        layer.clone()
    } else {
        format!("{unit} in {layer}")
    };
    let (core, twist) = strength.when;
    let ends = ends(twist);
    let used = percent(design.section.about.usage_factor);
    vec![
        fact(
            "breaking load",
            si(strength.break_load, "N"),
            &format!("first to reach its strength: {weakest}, {core} core, ends {ends}"),
        ),
        fact(
            "allowable tension",
            si(strength.allowable, "N"),
            &format!("{used} of it may be used"),
        ),
    ]
}

fn fact(name: &str, value: String, how: &str) -> Vec<Cell> {
    vec![Cell::plain(name), Cell::plain(value), Cell::plain(how)]
}

fn ends(twist: Twist) -> &'static str {
    match twist {
        Twist::Held => "held from turning",
        Twist::Free => "free to turn",
    }
}

/// Who carries a tension \[N\].
#[must_use]
pub fn carried(design: &Design, core: Core, twist: Twist, tension: f64) -> Table {
    let rows = shares(&design.layout, core, twist, tension);
    Table {
        title: format!(
            "Who carries {} ({core} core, ends {})",
            si(tension, "N"),
            ends(twist)
        ),
        columns: vec![
            Column::left("layer"),
            Column::left("unit"),
            Column::right("count"),
            Column::decimal("share"),
            Column::decimal("force in one"),
            Column::decimal("stress"),
            Column::decimal("use of its strength"),
        ],
        rows: rows.iter().map(share_row).collect(),
        notes: Vec::new(),
    }
}

fn share_row(share: &Share) -> Vec<Cell> {
    let known =
        |value: Option<String>| Cell::plain(value.unwrap_or_else(|| "not known".to_owned()));
    let over = share.utilisation.is_some_and(|used| used > 1.0);
    let ink = if over { CellInk::Bad } else { CellInk::Plain };
    let mut used = known(share.utilisation.map(percent));
    used.ink = ink;
    if over {
        used.text.push_str(" TOO MUCH");
    }
    vec![
        Cell::plain(&share.layer),
        Cell::plain(&share.unit),
        Cell::plain(share.count.to_string()),
        Cell::plain(percent(share.share)),
        Cell::plain(si(share.force, "N")),
        known(share.stress.map(|stress| si(stress, "Pa"))),
        used,
    ]
}
