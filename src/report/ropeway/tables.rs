//! A ropeway at rest in tables: its models side by side, the crossing, the ropes; warnings.

use seacable_base::number::{percent, rounded};
use seacable_display::table::{Align, Cell, NumberFormat, Table};
use seacable_systems::ropeway::elastic::{Carrier, RopeEquilibrium};
use seacable_systems::ropeway::weight_check::WeightCheck;
use seacable_systems::ropeway::{ModelResults, SolvedRopeway};

/// A force in newtons as the paper prints them.
pub(super) const NEWTONS: NumberFormat = NumberFormat::With(newtons);

/// A length in metres.
pub(super) const METRES: NumberFormat = NumberFormat::Decimals(3, "m");

pub(super) fn newtons(value: f64) -> String {
    let decimals = if value.abs() >= 1e6 { -1 } else { 1 };
    format!("{} N", rounded(value, decimals))
}

pub(super) fn metres(value: f64) -> String {
    METRES.write(value)
}

/// Results of a model of the ropeway; absent where it has none.
#[derive(Debug, Clone, Copy, Default)]
struct ModelSummary {
    length_m: Option<f64>,
    horizontal_n: Option<f64>,
    platform_n: Option<f64>,
    ship_n: Option<f64>,
    greatest_n: Option<f64>,
    sag_m: Option<f64>,
    clearance_m: Option<f64>,
}

impl ModelSummary {
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

/// The models of the ropeway side by side, at the position of the results.
#[must_use]
pub fn models(solved: &SolvedRopeway, results: &ModelResults) -> Table {
    let title = format!(
        "Models with the cargo at {} of the span from the platform",
        percent(results.position)
    );
    let [model, parabola, exact, line] = summaries(solved, results);
    let models = [
        ("inextensible", model),
        ("parabola", parabola),
        ("exact", exact),
        ("line", line),
    ];
    Table::compare(title, "", &models)
        .number("length of rope", METRES, |m| m.length_m)
        .number("horizontal tension", NEWTONS, |m| m.horizontal_n)
        .number("tension at the platform", NEWTONS, |m| m.platform_n)
        .number("tension at the ship", NEWTONS, |m| m.ship_n)
        .number("greatest tension", NEWTONS, |m| m.greatest_n)
        .number("sag at the cargo", METRES, |m| m.sag_m)
        .number("clearance of the cargo", METRES, |m| m.clearance_m)
        .build()
        .noted(notes(solved, results))
}

/// The inextensible model, parabola theory, the elastic rope, and the discretised line.
fn summaries(solved: &SolvedRopeway, results: &ModelResults) -> [Option<ModelSummary>; 4] {
    let exact = &results.exact;
    let model = solved
        .inextensible
        .as_ref()
        .ok()
        .map(|inextensible| ModelSummary {
            length_m: Some(inextensible.rope.length_m()),
            horizontal_n: Some(inextensible.rope.horizontal_n),
            greatest_n: Some(inextensible.max_tension_n),
            sag_m: Some(inextensible.rope.sag_m()),
            ..ModelSummary::default()
        });
    let parabola = results.parabola.map(|(platform, ship, sag)| {
        ModelSummary::new(model.and_then(|m| m.horizontal_n), (platform, ship), sag)
    });
    let ends = (exact.platform_n(), exact.ship_n());
    let elastic = ModelSummary {
        length_m: Some(exact.length_m),
        ..ModelSummary::new(Some(exact.solution.h_b_n), ends, exact.sag_m)
    };
    let line = results.line.as_ref().ok().map(|line| ModelSummary {
        length_m: Some(exact.length_m),
        ..ModelSummary::new(
            Some(line.horizontal_n),
            (line.platform_n, line.ship_n),
            line.sag_m,
        )
    });
    // At the position of the elastic rope, lower by the difference of the sags.
    let with_clearance = |summary: ModelSummary| ModelSummary {
        clearance_m: summary
            .sag_m
            .map(|sag| solved.clearance_m(exact) + exact.sag_m - sag),
        ..summary
    };
    [
        model,
        parabola.map(with_clearance),
        Some(with_clearance(elastic)),
        line.map(with_clearance),
    ]
}

fn notes(solved: &SolvedRopeway, results: &ModelResults) -> Vec<String> {
    let mut notes = vec![
        "Inextensible: the paper's model, the unloaded rope with the weight of the cargo at one end at any position; its sag is \
         that of the unloaded rope at mid-span."
            .to_owned(),
        "Parabola: eqs (11) and (13) with the horizontal tension of the inextensible model.".to_owned(),
        "Exact: the elastic catenary with the cargo on it, unstretched length. Line: the same discretised in segments.".to_owned(),
    ];
    if let Some((platform, ship)) = results.mean_tensions_n {
        notes.push(format!(
            "Mean tensions by eqs (9) and (10), corrected: {} on the platform's side of the cargo, {} on the ship's.",
            newtons(platform),
            newtons(ship)
        ));
    }
    match results.exact.carrier {
        Carrier::Rope => {}
        Carrier::Platform => {
            notes.push("The cargo hangs on the platform; the rope is unloaded.".to_owned());
        }
        Carrier::Ship => {
            notes.push("The cargo hangs on the ship; the rope is unloaded.".to_owned());
        }
    }
    if let (Err(error), Carrier::Rope) = (&results.line, results.exact.carrier) {
        notes.push(format!("The line has no solution: {error}."));
    }
    if let Err(error) = &solved.inextensible {
        notes.push(format!("The inextensible model has no solution: {error}."));
    }
    notes
}

/// Warnings: cargo or rope in the water, more rope than there is.
#[must_use]
pub fn warnings(solved: &SolvedRopeway, results: &ModelResults) -> Vec<String> {
    let exact = &results.exact;
    let mut warnings = Vec::new();
    let clear = solved.clearance_m(exact);
    if clear < 0.0 && exact.carrier == Carrier::Rope {
        warnings.push(format!(
            "The cargo is in the water: its lower side hangs {} below the wave crests. The weight is that in air; raise the ends, increase the tension or reduce the span.",
            metres(-clear)
        ));
    }
    let rope = solved.rope_clearance_m(exact);
    if rope < 0.0 {
        warnings.push(format!(
            "The rope reaches {} below the wave crests.",
            metres(-rope)
        ));
    }
    if let Some((position, clear)) = solved.lowest_crossing(39)
        && clear < 0.0
    {
        warnings.push(format!(
            "During the crossing the cargo is up to {} below the wave crests, at {} of the span from the platform.",
            metres(-clear),
            percent(position)
        ));
    }
    let parabola = results.parabola.map(|p| clear + exact.sag_m - p.2);
    if let Some(under) = parabola.filter(|under| *under < 0.0) {
        warnings.push(format!(
            "With the horizontal tension of the inextensible model the cargo hangs {} below the wave crests.",
            metres(-under)
        ));
    }
    let stored = solved.ropeway.stored_m();
    if results.length_m > stored {
        warnings.push(format!(
            "The length between the ends is {}, and that of the shortest rope {}.",
            metres(results.length_m),
            metres(stored)
        ));
    }
    warnings
}

/// The crossing by the elastic rope at equally spaced positions.
#[must_use]
pub fn crossing(solved: &SolvedRopeway, places: usize) -> Table {
    let positions = (0..=places).map(|i| i as f64 / places as f64);
    let rests: Vec<_> = positions
        .filter_map(|p| solved.equilibrium(p).ok())
        .collect();
    Table::of_records("Crossing of the cargo (exact)", &rests)
        .number("from the platform", METRES, |rest| rest.cargo_m.0)
        .number("sag at the cargo", METRES, |rest| rest.sag_m)
        .cell("clearance", Align::Decimal, |rest| {
            let clear = solved.clearance_m(rest);
            Cell::bad_if(clear < 0.0 && rest.carrier == Carrier::Rope, metres(clear))
        })
        .number("horizontal tension", NEWTONS, |rest| rest.solution.h_b_n)
        .number("at the platform", NEWTONS, RopeEquilibrium::platform_n)
        .number("at the ship", NEWTONS, RopeEquilibrium::ship_n)
        .build()
}

/// The parallel ropes with their shares of the greatest tension.
#[must_use]
pub fn ropes(solved: &SolvedRopeway, results: &ModelResults) -> Table {
    let most = results.exact.platform_n().max(results.exact.ship_n());
    let ea = solved.rope.ea_n;
    let sum: f64 = solved.ropeway.ropes.iter().map(|r| r.mass_kg_per_m).sum();
    let used = solved.rope.weight_n_per_m / solved.ropeway.about.gravity_m_per_s2;
    let title = "Ropes, with their shares of the greatest tension";
    Table::of_records(title, &solved.ropeway.ropes)
        .text("rope", |rope| &rope.name)
        .number("diameter", NumberFormat::Decimals(1, "mm"), |rope| {
            1e3 * rope.diameter_m
        })
        .number("mass", NumberFormat::Decimals(3, "kg/m"), |rope| {
            rope.mass_kg_per_m
        })
        .number("length", METRES, |rope| rope.length_m)
        .number("share", NumberFormat::Percent, |rope| rope.ea_n / ea)
        .number("tension", NEWTONS, |rope| rope.ea_n / ea * most)
        .cell("use of breaking load", Align::Decimal, |rope| {
            let part = rope.break_load_n.map(|load| rope.ea_n / ea * most / load);
            part.map_or_else(Cell::none, |part| Cell::bad_if(part > 1.0, percent(part)))
        })
        .build()
        .noted([format!(
            "All ropes have the same strain, so that each carries in proportion to its EA. The sum of their masses is {} kg/m; {} kg/m is used.",
            rounded(sum, 3),
            rounded(used, 3)
        )])
}

/// The difference between the finite-element check and the model, by its causes; absent without a check.
#[must_use]
pub fn weight_check(solved: &SolvedRopeway) -> Option<Table> {
    let check = WeightCheck::of_ropeway(solved).ok()?;
    let model_n = check.lighter.max_tension_n;
    let rows = [
        ("end tension of the check", check.tension_n),
        ("end tension of the inextensible model", model_n),
        ("difference", check.tension_n - model_n),
        ("by the heavier rope of the check", check.by_weight_n()),
        ("remainder with equal rope weights", check.remainder_n()),
    ];
    let heavier = check.model.rope.weight_n() / check.lighter.rope.weight_n() - 1.0;
    let table = Table::of_records("Difference to the finite-element check", &rows)
        .text("", |row| row.0)
        .number("tension", NEWTONS, |row| row.1)
        .number("ratio", NumberFormat::Percent, |row| {
            row.1 / check.tension_n
        })
        .build();
    Some(table.noted([format!(
        "The bar of the check weighs {} more than the rope of the model. The paper's conclusion 5 attributes the difference to the simple theory and calls for simulation beyond 80 m; its cause is the weight.",
        percent(heavier)
    )]))
}
