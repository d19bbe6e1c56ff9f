//! A ropeway in tables: the readings side by side, the crossing, what is to be looked at.

use super::exact::Carrier;
use super::quantities::quantity;
use super::work::{Readings, Worked};
use crate::report::number::{percent, rounded};
use crate::report::table::{Cell, CellInk, Column, Table};

/// A force in newtons as the paper prints them.
pub(crate) fn newtons(value: f64) -> String {
    let decimals = if value.abs() >= 1e6 { -1 } else { 1 };
    format!("{} N", rounded(value, decimals))
}

/// A length in metres.
pub(crate) fn metres(value: f64) -> String {
    format!("{} m", rounded(value, 3))
}

/// A table title.
pub(crate) fn titled(title: &str, columns: Vec<Column>) -> Table {
    Table {
        title: title.to_owned(),
        columns,
        ..Table::default()
    }
}

fn none() -> Cell {
    Cell::new("-", CellInk::Dim)
}

fn cell(value: Option<f64>, word: fn(f64) -> String) -> Cell {
    value.map_or_else(none, |value| Cell::plain(word(value)))
}

/// The readings of the ropeway side by side, with the cargo where they have it.
#[must_use]
pub fn readings(worked: &Worked, readings: &Readings) -> Table {
    let tabled = worked.tabled.as_ref().ok();
    let line = readings.line.as_ref().ok();
    let exact = &readings.exact;
    let mut table = titled(
        &format!(
            "Readings with the cargo at {} of the way from the platform",
            percent(readings.position)
        ),
        vec![
            Column::left(""),
            Column::decimal("paper's model"),
            Column::decimal("parabola"),
            Column::decimal("exact"),
            Column::decimal("line"),
        ],
    );
    let mut row = |name: &str, values: [Option<f64>; 4], word: fn(f64) -> String| {
        let mut cells = vec![Cell::plain(name)];
        cells.extend(values.map(|value| cell(value, word)));
        table.rows.push(cells);
    };
    let model = |f: fn(&super::paper::Tabled) -> f64| tabled.map(f);
    let pull = model(|t| t.rope.horizontal_n);
    row(
        "rope between the ends",
        [
            model(|t| t.rope.length_m()),
            None,
            Some(exact.length_m),
            line.map(|_| exact.length_m),
        ],
        metres,
    );
    row(
        "horizontal pull",
        [
            pull,
            readings.parabola.and(pull),
            Some(exact.solution.h_b_n),
            line.map(|l| l.horizontal_n),
        ],
        newtons,
    );
    row(
        "tension at the platform",
        [
            None,
            readings.parabola.map(|p| p.0),
            Some(exact.platform_n()),
            line.map(|l| l.platform_n),
        ],
        newtons,
    );
    row(
        "tension at the ship",
        [
            None,
            readings.parabola.map(|p| p.1),
            Some(exact.ship_n()),
            line.map(|l| l.ship_n),
        ],
        newtons,
    );
    let most = [
        model(|t| t.max_tension_n),
        readings.parabola.map(|p| p.0.max(p.1)),
        Some(exact.platform_n().max(exact.ship_n())),
        line.map(|l| l.platform_n.max(l.ship_n)),
    ];
    row("greatest tension", most, newtons);
    row(
        "sag at the cargo",
        [
            model(|t| t.rope.sag_m()),
            readings.parabola.map(|p| p.2),
            Some(exact.sag_m),
            line.map(|l| l.sag_m),
        ],
        metres,
    );
    let under = |sag: f64| worked.clearance_m(exact) + exact.sag_m - sag;
    row(
        "cargo above the crests",
        [
            None,
            readings.parabola.map(|p| under(p.2)),
            Some(under(exact.sag_m)),
            line.map(|l| under(l.sag_m)),
        ],
        metres,
    );
    table.notes = notes(worked, readings);
    table
}

fn notes(worked: &Worked, readings: &Readings) -> Vec<String> {
    let mut notes = vec![
        "Paper's model: the bare rope that cannot stretch, the whole cargo added at one end, wherever it hangs; its sag is \
         that of the bare rope at mid-span."
            .to_owned(),
        "Parabola: eqs (11) and (13) with the pull of the paper's model, as a winch would keep it.".to_owned(),
        "Exact: the elastic rope with the cargo on it, unstretched length. Line: the same in segments.".to_owned(),
    ];
    if let Some((platform, ship)) = readings.means_n {
        notes.push(format!(
            "Mean tensions by eqs (9) and (10), corrected: {} on the platform's side of the cargo, {} on the ship's.",
            newtons(platform),
            newtons(ship)
        ));
    }
    match readings.exact.carrier {
        Carrier::Rope => {}
        Carrier::Platform => {
            notes.push("The cargo hangs on the platform; the rope is bare.".to_owned());
        }
        Carrier::Ship => notes.push("The cargo hangs on the ship; the rope is bare.".to_owned()),
    }
    if let (Err(trouble), Carrier::Rope) = (&readings.line, readings.exact.carrier) {
        notes.push(format!("No line: {trouble}."));
    }
    if let Err(trouble) = &worked.tabled {
        notes.push(format!("No answer of the paper's model: {trouble}."));
    }
    notes
}

/// What is to be looked at: the cargo in the water, the rope in the water.
#[must_use]
pub fn warnings(worked: &Worked, readings: &Readings) -> Vec<String> {
    let mut warnings = Vec::new();
    let clear = worked.clearance_m(&readings.exact);
    if clear < 0.0 && readings.exact.carrier == Carrier::Rope {
        warnings.push(format!(
            "The cargo is in the water: its lower side would hang {} below the wave crests. The weight is that in air; raise the ends, give more tension, or less span.",
            metres(-clear)
        ));
    }
    let rope = worked.rope_clearance_m(&readings.exact);
    if rope < 0.0 {
        warnings.push(format!(
            "The rope reaches {} below the wave crests.",
            metres(-rope)
        ));
    }
    if let Some((position, clear)) = worked.lowest_crossing(39)
        && clear < 0.0
    {
        warnings.push(format!(
            "On its way across the cargo comes down to {} below the wave crests, at {} of the way from the platform.",
            metres(-clear),
            percent(position)
        ));
    }
    let parabola = readings
        .parabola
        .map(|p| worked.clearance_m(&readings.exact) + readings.exact.sag_m - p.2);
    if let Some(under) = parabola.filter(|under| *under < 0.0) {
        warnings.push(format!(
            "With the pull of the paper's model kept by a winch the cargo would hang {} below the wave crests.",
            metres(-under)
        ));
    }
    let stored = worked.ropeway.stored_m();
    if readings.length_m > stored {
        warnings.push(format!(
            "The rope between the ends takes {}, and of the shortest there is {}.",
            metres(readings.length_m),
            metres(stored)
        ));
    }
    warnings
}

/// The cargo on its way across, by the exact rope: so many places between the supports.
#[must_use]
pub fn crossing(worked: &Worked, places: usize) -> Table {
    let mut table = titled(
        "The cargo on its way across (exact)",
        vec![
            Column::decimal("from the platform"),
            Column::decimal("sag at the cargo"),
            Column::decimal("above the crests"),
            Column::decimal("pull"),
            Column::decimal("at the platform"),
            Column::decimal("at the ship"),
        ],
    );
    for i in 0..=places {
        let position = i as f64 / places as f64;
        let Ok(rest) = worked.rest(position) else {
            continue;
        };
        let clear = worked.clearance_m(&rest);
        let ink = if clear < 0.0 && rest.carrier == Carrier::Rope {
            CellInk::Bad
        } else {
            CellInk::Plain
        };
        table.rows.push(vec![
            Cell::plain(metres(rest.cargo_m.0)),
            Cell::plain(metres(rest.sag_m)),
            Cell::new(metres(clear), ink),
            Cell::plain(newtons(rest.solution.h_b_n)),
            Cell::plain(newtons(rest.platform_n())),
            Cell::plain(newtons(rest.ship_n())),
        ]);
    }
    table
}

/// The ropes that hang side by side: what each of them carries of the greatest tension.
#[must_use]
pub fn ropes(worked: &Worked, readings: &Readings) -> Table {
    let most = readings.exact.platform_n().max(readings.exact.ship_n());
    let ea = worked.span.ea_n;
    let mut table = titled(
        "The ropes, each with its share of the greatest tension",
        vec![
            Column::left("rope"),
            Column::decimal("diameter"),
            Column::decimal("mass"),
            Column::decimal("length there is"),
            Column::decimal("share"),
            Column::decimal("tension"),
            Column::decimal("of its breaking load"),
        ],
    );
    for rope in &worked.ropeway.ropes {
        let share = rope.ea_n / ea;
        let broken = rope.break_load_n.map(|load| share * most / load);
        table.rows.push(vec![
            Cell::plain(&rope.name),
            Cell::plain(format!("{} mm", rounded(1e3 * rope.diameter_m, 1))),
            Cell::plain(format!("{} kg/m", rounded(rope.mass_kg_per_m, 3))),
            Cell::plain(metres(rope.length_m)),
            Cell::plain(percent(share)),
            Cell::plain(newtons(share * most)),
            broken.map_or_else(none, |part| {
                let ink = if part > 1.0 {
                    CellInk::Bad
                } else {
                    CellInk::Plain
                };
                Cell::new(percent(part), ink)
            }),
        ]);
    }
    let sum: f64 = worked.ropeway.ropes.iter().map(|r| r.mass_kg_per_m).sum();
    let used = worked.span.weight_n_per_m / worked.ropeway.about.gravity_m_per_s2;
    table.notes.push(format!(
        "They hang as one and stretch alike, so that each carries by its EA. Together they weigh {} kg/m; {} kg/m is counted.",
        rounded(sum, 3),
        rounded(used, 3)
    ));
    table
}

/// The finite-element check taken apart; absent: there is none.
#[must_use]
pub fn check(worked: &Worked, readings: &Readings) -> Option<Table> {
    let given = worked.ropeway.finite_element.as_ref()?;
    let of = |name: &str| quantity(worked, readings, name).ok();
    let model = of("model.max_tension_n")?;
    let mut table = titled(
        "What the finite-element check differs by",
        vec![
            Column::left(""),
            Column::decimal("tension"),
            Column::decimal("of it"),
        ],
    );
    let rows = [
        ("end tension of the check", Some(given.tension_n)),
        ("end tension of the paper's model", Some(model)),
        ("difference", Some(given.tension_n - model)),
        (
            "of that, by the heavier rope of the check",
            of("finite_element.by_weight_n"),
        ),
        (
            "left when both ropes weigh the same",
            of("finite_element.left_n"),
        ),
    ];
    for (name, value) in rows {
        table.rows.push(vec![
            Cell::plain(name),
            cell(value, newtons),
            cell(value.map(|v| v / given.tension_n), percent),
        ]);
    }
    let heavier = of("finite_element.weight_n").zip(of("model.weight_n"));
    if let Some((check, model)) = heavier {
        table.notes.push(format!(
            "The bar of the check weighs {} more than the rope of the model. The paper's conclusion 5 lays the difference to theory being too simple and wants simulation beyond 80 m; it is the weight.",
            percent(check / model - 1.0)
        ));
    }
    Some(table)
}
