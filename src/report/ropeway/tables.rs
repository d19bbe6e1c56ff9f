//! A ropeway at rest in tables: its models side by side, the crossing, the ropes, what is to be looked at.

use crate::report::number::{percent, rounded};
use crate::report::table::{Align, Cell, Format, Table};
use crate::ropeway::exact::Carrier;
use crate::ropeway::quantities::quantity;
use crate::ropeway::{Readings, Worked};

/// A force in newtons as the paper prints them.
pub(super) const NEWTONS: Format = Format::With(newtons);

/// A length in metres.
pub(super) const METRES: Format = Format::Decimals(3, "m");

pub(super) fn newtons(value: f64) -> String {
    let decimals = if value.abs() >= 1e6 { -1 } else { 1 };
    format!("{} N", rounded(value, decimals))
}

pub(super) fn metres(value: f64) -> String {
    METRES.write(value)
}

/// What a model of the ropeway computes; absent where it does not.
#[derive(Debug, Clone, Copy, Default)]
struct Summary {
    length_m: Option<f64>,
    horizontal_n: Option<f64>,
    platform_n: Option<f64>,
    ship_n: Option<f64>,
    greatest_n: Option<f64>,
    sag_m: Option<f64>,
    clearance_m: Option<f64>,
}

impl Summary {
    fn new(horizontal_n: Option<f64>, (platform_n, ship_n): (f64, f64), sag_m: f64) -> Self {
        Self {
            horizontal_n,
            platform_n: Some(platform_n),
            ship_n: Some(ship_n),
            greatest_n: Some(platform_n.max(ship_n)),
            sag_m: Some(sag_m),
            ..Self::default()
        }
    }
}

/// The models of the ropeway side by side, with the cargo where the readings have it.
#[must_use]
pub fn readings(worked: &Worked, readings: &Readings) -> Table {
    let title = format!(
        "Readings with the cargo at {} of the way from the platform",
        percent(readings.position)
    );
    let [model, parabola, exact, line] = summaries(worked, readings);
    let models = [
        ("paper's model", model),
        ("parabola", parabola),
        ("exact", exact),
        ("line", line),
    ];
    Table::compare(title, "", &models)
        .number("rope between the ends", METRES, |m| m.length_m)
        .number("horizontal pull", NEWTONS, |m| m.horizontal_n)
        .number("tension at the platform", NEWTONS, |m| m.platform_n)
        .number("tension at the ship", NEWTONS, |m| m.ship_n)
        .number("greatest tension", NEWTONS, |m| m.greatest_n)
        .number("sag at the cargo", METRES, |m| m.sag_m)
        .number("cargo above the crests", METRES, |m| m.clearance_m)
        .build()
        .noted(notes(worked, readings))
}

/// The paper's model, parabola theory, the elastic rope, and the discretised line.
fn summaries(worked: &Worked, readings: &Readings) -> [Option<Summary>; 4] {
    let exact = &readings.exact;
    let model = worked.tabled.as_ref().ok().map(|tabled| Summary {
        length_m: Some(tabled.rope.length_m()),
        horizontal_n: Some(tabled.rope.horizontal_n),
        greatest_n: Some(tabled.max_tension_n),
        sag_m: Some(tabled.rope.sag_m()),
        ..Summary::default()
    });
    let parabola = readings.parabola.map(|(platform, ship, sag)| {
        Summary::new(model.and_then(|m| m.horizontal_n), (platform, ship), sag)
    });
    let ends = (exact.platform_n(), exact.ship_n());
    let elastic = Summary {
        length_m: Some(exact.length_m),
        ..Summary::new(Some(exact.solution.h_b_n), ends, exact.sag_m)
    };
    let line = readings.line.as_ref().ok().map(|line| Summary {
        length_m: Some(exact.length_m),
        ..Summary::new(
            Some(line.horizontal_n),
            (line.platform_n, line.ship_n),
            line.sag_m,
        )
    });
    // The cargo hangs where the elastic rope has it, deeper by the difference of the sags.
    let cleared = |summary: Summary| Summary {
        clearance_m: summary
            .sag_m
            .map(|sag| worked.clearance_m(exact) + exact.sag_m - sag),
        ..summary
    };
    [
        model,
        parabola.map(cleared),
        Some(cleared(elastic)),
        line.map(cleared),
    ]
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

/// What is to be looked at: the cargo in the water, the rope in the water, more rope than there is.
#[must_use]
pub fn warnings(worked: &Worked, readings: &Readings) -> Vec<String> {
    let exact = &readings.exact;
    let mut warnings = Vec::new();
    let clear = worked.clearance_m(exact);
    if clear < 0.0 && exact.carrier == Carrier::Rope {
        warnings.push(format!(
            "The cargo is in the water: its lower side would hang {} below the wave crests. The weight is that in air; raise the ends, give more tension, or less span.",
            metres(-clear)
        ));
    }
    let rope = worked.rope_clearance_m(exact);
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
    let parabola = readings.parabola.map(|p| clear + exact.sag_m - p.2);
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
    let positions = (0..=places).map(|i| i as f64 / places as f64);
    let rests: Vec<_> = positions.filter_map(|p| worked.rest(p).ok()).collect();
    Table::of("The cargo on its way across (exact)", &rests)
        .number("from the platform", METRES, |rest| rest.cargo_m.0)
        .number("sag at the cargo", METRES, |rest| rest.sag_m)
        .cell("above the crests", Align::Decimal, |rest| {
            let clear = worked.clearance_m(rest);
            Cell::bad_if(clear < 0.0 && rest.carrier == Carrier::Rope, metres(clear))
        })
        .number("pull", NEWTONS, |rest| rest.solution.h_b_n)
        .number("at the platform", NEWTONS, |rest| rest.platform_n())
        .number("at the ship", NEWTONS, |rest| rest.ship_n())
        .build()
}

/// The ropes that hang side by side: what each of them carries of the greatest tension.
#[must_use]
pub fn ropes(worked: &Worked, readings: &Readings) -> Table {
    let most = readings.exact.platform_n().max(readings.exact.ship_n());
    let ea = worked.span.ea_n;
    let sum: f64 = worked.ropeway.ropes.iter().map(|r| r.mass_kg_per_m).sum();
    let used = worked.span.weight_n_per_m / worked.ropeway.about.gravity_m_per_s2;
    let title = "The ropes, each with its share of the greatest tension";
    Table::of(title, &worked.ropeway.ropes)
        .text("rope", |rope| &rope.name)
        .number("diameter", Format::Decimals(1, "mm"), |rope| {
            1e3 * rope.diameter_m
        })
        .number("mass", Format::Decimals(3, "kg/m"), |rope| {
            rope.mass_kg_per_m
        })
        .number("length there is", METRES, |rope| rope.length_m)
        .number("share", Format::Percent, |rope| rope.ea_n / ea)
        .number("tension", NEWTONS, |rope| rope.ea_n / ea * most)
        .cell("of its breaking load", Align::Decimal, |rope| {
            let part = rope.break_load_n.map(|load| rope.ea_n / ea * most / load);
            part.map_or_else(Cell::none, |part| Cell::bad_if(part > 1.0, percent(part)))
        })
        .build()
        .noted([format!(
            "They hang as one and stretch alike, so that each carries by its EA. Together they weigh {} kg/m; {} kg/m is counted.",
            rounded(sum, 3),
            rounded(used, 3)
        )])
}

/// The finite-element check taken apart; absent: there is none.
#[must_use]
pub fn check(worked: &Worked, readings: &Readings) -> Option<Table> {
    let given = worked.ropeway.finite_element.as_ref()?.tension_n;
    let of = |name: &str| quantity(worked, readings, name).ok();
    let model = of("model.max_tension_n")?;
    let rows = [
        ("end tension of the check", Some(given)),
        ("end tension of the paper's model", Some(model)),
        ("difference", Some(given - model)),
        (
            "of that, by the heavier rope of the check",
            of("finite_element.by_weight_n"),
        ),
        (
            "left when both ropes weigh the same",
            of("finite_element.left_n"),
        ),
    ];
    let heavier = of("finite_element.weight_n").zip(of("model.weight_n"));
    let note = heavier.map(|(check, model)| format!(
        "The bar of the check weighs {} more than the rope of the model. The paper's conclusion 5 lays the difference to theory being too simple and wants simulation beyond 80 m; it is the weight.",
        percent(check / model - 1.0)
    ));
    let table = Table::of("What the finite-element check differs by", &rows)
        .text("", |row| row.0)
        .number("tension", NEWTONS, |row| row.1)
        .number("of it", Format::Percent, |row| row.1.map(|v| v / given));
    Some(table.build().noted(note))
}
