//! A cross-section in tables: layers, stiffness, weight and strength, load sharing.

use seacable_base::number::{digits, percent, si};
use seacable_display::table::{Align, Cell, NumberFormat, Table};
use seacable_model::section::model::{Core, Voids};
use seacable_model::section::stiffness::{EndRotation, StiffnessMatrix, ea_with_core_pressure};
use seacable_model::section::strength::load_shares;
use seacable_model::section::{Design, Helix, LaidLayer};

/// A length in millimetres.
const MM: NumberFormat = NumberFormat::With(mm);

/// Stiffness in bending and torsion.
const STIFFNESS: NumberFormat = NumberFormat::Si("N m²");

fn mm(metres: f64) -> String {
    format!("{} mm", digits(metres * 1e3, 4))
}

/// A layer as the table shows it.
struct LayerRow<'a> {
    name: &'a str,
    made_of: String,
    angle: String,
    helix: Option<&'a Helix>,
    outer_radius: f64,
    mass: f64,
}

/// The layers, from the inside out.
#[must_use]
pub fn layers(design: &Design) -> Table {
    let centre = design.layout.centre.iter().map(|centre| LayerRow {
        name: "centre",
        made_of: format!("{} {}", centre.element.what, centre.element.name),
        angle: "straight".to_owned(),
        helix: None,
        outer_radius: centre.radius,
        mass: centre.mass(),
    });
    let shells = design.layout.shells.iter().map(layer);
    let layers: Vec<LayerRow<'_>> = centre.chain(shells).collect();
    let around = |layer: &LayerRow<'_>, of: fn(&Helix) -> f64| layer.helix.map(of);
    Table::of_records("Layers, from the inside out", &layers)
        .text("layer", |layer| layer.name)
        .text("made of", |layer| &layer.made_of)
        .text("lay angle", |layer| &layer.angle)
        .number("pitch radius", MM, |layer| {
            around(layer, |helix| helix.pitch_radius)
        })
        .number("lay length", NumberFormat::Si("m"), |layer| {
            around(layer, Helix::lay_length)
        })
        .number("cover", NumberFormat::Percent, |layer| {
            around(layer, |helix| helix.coverage)
        })
        .number("outer diameter", MM, |layer| 2.0 * layer.outer_radius)
        .number("mass", NumberFormat::Si("kg/m"), |layer| layer.mass)
        .build()
}

fn layer(shell: &LaidLayer) -> LayerRow<'_> {
    match shell {
        LaidLayer::Helix(helix) => {
            let side = if helix.angle < 0.0 { "left" } else { "right" };
            let angle = digits(helix.angle.abs().to_degrees(), 4);
            LayerRow {
                name: &helix.name,
                made_of: made_of(helix),
                angle: format!("{angle} deg {side}"),
                helix: Some(helix),
                outer_radius: helix.outer_radius,
                mass: helix.mass(),
            }
        }
        LaidLayer::Tube(tube) => LayerRow {
            name: &tube.input.name,
            made_of: format!("sheath of {}", mm(tube.input.thickness_m)),
            angle: "-".to_owned(),
            helix: None,
            outer_radius: tube.outer_radius,
            mass: tube.mass(),
        },
    }
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
    let input: Vec<String> = kinds
        .iter()
        .map(|(name, count)| format!("{count} {name}"))
        .collect();
    input.join(", ")
}

/// A stiffness with a rigid and an incompressible core.
struct StiffnessRow {
    name: &'static str,
    format: NumberFormat,
    values: [f64; 2],
    spread: String,
    theory: &'static str,
}

/// Stiffness, with both kinds of core side by side.
#[must_use]
pub fn stiffness(design: &Design) -> Table {
    let mut rows = tension_and_torsion(design);
    rows.extend(bending(design));
    let cell = |row: &StiffnessRow, core: usize| row.format.cell(Some(row.values[core]));
    Table::of_records("Stiffness", &rows)
        .text("quantity", |row| row.name)
        .cell("rigid core, Theta = 0", Align::Decimal, |row| cell(row, 0))
        .cell("incompressible core, Theta = 1", Align::Decimal, |row| {
            cell(row, 1)
        })
        .cell("model error", Align::Decimal, |row| {
            Cell::plain(&row.spread)
        })
        .text("theory", |row| row.theory)
        .build()
        .noted(stiffness_notes(design))
}

/// Name, format and value of a coefficient of the stiffness matrix.
type StiffnessCoefficient = (&'static str, NumberFormat, fn(&StiffnessMatrix) -> f64);

fn tension_and_torsion(design: &Design) -> Vec<StiffnessRow> {
    const N: NumberFormat = NumberFormat::Si("N");
    const NM: NumberFormat = NumberFormat::Si("N m");
    let has_core = design.layout.centre.is_some();
    let quantities: [StiffnessCoefficient; 6] = [
        ("EA, ends fixed", N, |m| m.ea(EndRotation::Fixed)),
        ("EA, ends free to rotate", N, |m| m.ea(EndRotation::Free)),
        (
            "GJ, length fixed",
            STIFFNESS,
            StiffnessMatrix::gj_fixed_length,
        ),
        (
            "GJ, length free",
            STIFFNESS,
            StiffnessMatrix::gj_free_length,
        ),
        ("tension by twist per length", NM, |m| m.tension_twist),
        ("torque by strain", NM, |m| m.torque_strain),
    ];
    let rows = quantities.map(|(name, format, of)| {
        let [rigid, soft] = [of(&design.rigid), of(&design.incompressible)];
        StiffnessRow {
            name,
            format,
            values: [rigid, soft],
            spread: if has_core {
                spread(rigid, soft)
            } else {
                "unknown".to_owned()
            },
            theory: "Knapp, eqs. (16)-(17)",
        }
    });
    rows.into()
}

fn bending(design: &Design) -> [StiffnessRow; 4] {
    let bending = &design.bending;
    let rows = [
        (
            "EI, full slip",
            bending.full_slip(),
            "sum of the two rows below",
        ),
        (
            "EI of units, wires, centre",
            bending.helices + bending.centre,
            "Costello, eqs. (18)-(19)",
        ),
        ("EI of the sheaths", bending.sheaths, "E I of a tube"),
        (
            "EI, full stick",
            bending.full_stick(),
            "plane sections remain plane",
        ),
    ];
    rows.map(|(name, value, theory)| StiffnessRow {
        name,
        format: STIFFNESS,
        values: [value; 2],
        spread: "-".to_owned(),
        theory,
    })
}

/// Relative difference between the core models.
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

fn stiffness_notes(design: &Design) -> Vec<String> {
    let mut notes = vec![
        "Equations as numbered in Lin et al. 2016, Periodical of Ocean University of China 46(12), 111-116; tension and torsion after Knapp 1979, bending after Costello and Phillips 1976.".to_owned(),
        "Model error: the difference between a core of constant diameter and one of constant volume. A real core lies between them, or is softer. Rounding errors are negligible.".to_owned(),
    ];
    if design.layout.centre.is_some() {
        notes.push(format!(
            "With an incompressible core the coupling is not symmetric, as eqs. (16)-(17) count the tension of the wires but not the pressure in the core. With that pressure, EA with fixed ends is {}.",
            si(ea_with_core_pressure(&design.layout), "N")
        ));
    } else {
        notes.push(
            "Without a central cylinder both columns agree, and the model error is unknown."
                .to_owned(),
        );
    }
    notes.push("Positive coupling: tension unwinds right-handed layers.".to_owned());
    notes.push("EI lies between full stick at small curvature and full slip at large curvature. Their difference is a model error; the curvature at which friction is overcome is not computed. The material takes the value of full slip.".to_owned());

    let (ea, gj) = design.sheaths;
    if ea > 0.0 {
        notes.push(format!(
            "EA and GJ are without the sheaths, which eqs. (16)-(17) neglect: these add {} and {}.",
            si(ea, "N"),
            si(gj, "N m²")
        ));
    }
    notes
}

/// A quantity, its value and its basis.
type Fact = (&'static str, String, String);

/// Size, weight and strength.
#[must_use]
pub fn summary(design: &Design) -> Table {
    let weight = &design.weight;
    let gaps = match design.section.about.voids {
        Voids::Dry => "gaps dry",
        Voids::Flooded => "gaps flooded",
    };
    let gaps = || gaps.to_owned();
    let mut facts: Vec<Fact> = vec![
        (
            "outer diameter",
            mm(2.0 * design.layout.outer_radius),
            "sum of the layers".to_owned(),
        ),
        (
            "mass in air",
            si(weight.in_air, "kg/m"),
            "gaps empty, tubes as filled".to_owned(),
        ),
        ("mass including flooding", si(weight.moving, "kg/m"), gaps()),
        ("weight in water", si(weight.in_water_force, "N/m"), gaps()),
        (
            "weight in water, as mass",
            si(weight.in_water, "kg/m"),
            gaps(),
        ),
        (
            "gaps",
            format!("{} mm²", digits(1e6 * weight.voids, 4)),
            "area without unit, filler or sheath".to_owned(),
        ),
    ];
    facts.extend(strength(design));
    Table::of_records("The cable as a whole", &facts)
        .text("quantity", |fact| fact.0)
        .cell("value", Align::Decimal, |fact| Cell::plain(&fact.1))
        .text("basis", |fact| &fact.2)
        .build()
}

fn strength(design: &Design) -> Vec<Fact> {
    let Some(strength) = &design.strength else {
        return vec![(
            "breaking load",
            "unknown".to_owned(),
            "no load-carrying unit has a strength or breaking load".to_owned(),
        )];
    };
    let (layer, unit) = &strength.weakest;
    let weakest = if layer == unit {
        layer.clone()
    } else {
        format!("{unit} in {layer}")
    };
    let (core, twist) = strength.governing;
    let ends = ends(twist);
    let used = percent(design.section.about.usage_factor);
    vec![
        (
            "breaking load",
            si(strength.break_load, "N"),
            format!("first to reach its strength: {weakest}, {core} core, ends {ends}"),
        ),
        (
            "allowable tension",
            si(strength.allowable, "N"),
            format!("usage factor {used}"),
        ),
    ]
}

fn ends(twist: EndRotation) -> &'static str {
    match twist {
        EndRotation::Fixed => "fixed",
        EndRotation::Free => "free to rotate",
    }
}

/// Load sharing under a tension \[N\].
#[must_use]
pub fn load_sharing(design: &Design, core: Core, twist: EndRotation, tension: f64) -> Table {
    let title = format!(
        "Load sharing at {} ({core} core, ends {})",
        si(tension, "N"),
        ends(twist)
    );
    let known = |value: Option<String>| Cell::plain(value.unwrap_or_else(|| "unknown".to_owned()));
    Table::of_records(title, &load_shares(&design.layout, core, twist, tension))
        .text("layer", |share| &share.layer)
        .text("unit", |share| &share.unit)
        .count("count", |share| share.count)
        .number("share", NumberFormat::Percent, |share| share.share)
        .number("force per unit", NumberFormat::Si("N"), |share| share.force)
        .cell("stress", Align::Decimal, |share| {
            known(share.stress.map(|stress| si(stress, "Pa")))
        })
        .cell("utilisation", Align::Decimal, |share| {
            match share.utilisation {
                Some(used) if used > 1.0 => Cell::bad_if(true, percent(used) + " EXCEEDED"),
                used => known(used.map(percent)),
            }
        })
        .build()
}
