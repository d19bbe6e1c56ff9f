//! Compared runs as tables.

use seacable::chart::Glyphs;
use seacable::comparison::Comparison;
use seacable::report::comparison;
use seacable::report::document::Report;
use seacable::run::{LineShape, Quantity, Run};

use crate::sample;

/// Accepted tables live in the top-level `snapshots/`, named by what they show.
fn accept(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

const CASE: &str = r#"
case.title = "a rope"
materials.m = { diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e8 }
line = [{ name = "wire", material = "m", length_m = 10.0, segments = 2 }]
ends.a = { name = "a", kind = "fixed", position_m = [0.0, 0.0, 0.0] }
ends.b = { name = "payload", kind = "free" }
"#;

fn runs() -> [Run; 2] {
    let first = Run {
        case_text: CASE.to_owned(),
        ..sample::run()
    };
    let mut second = first.clone();
    second.info.id = "other".to_owned();
    second.info.settings.method = "rk4".to_owned();
    second.info.cost.cpu_s = 1.5;
    second.case_text =
        CASE.replace("length_m = 10.0", "length_m = 12.5") + "current.speed_m_per_s = 0.4\n";
    for channel in &mut second.history.channels {
        channel.values.iter_mut().for_each(|value| *value *= 1.01);
    }
    second.summary[0].value *= 1.5;
    second.summary[1].unsettled = Some([1.5e6, 2.5e6]);
    second.summary[2] = Quantity::new("z_m[pay,load].max".parse().unwrap(), -1400.0);
    [first, second]
}

#[test]
fn two_runs() {
    let [first, second] = runs();
    let compared = Comparison::of_runs(&[&first, &second]);
    accept(
        "comparison_80",
        &comparison::tables(&compared, 80).to_text(80, Glyphs::Braille),
    );
}

#[test]
fn three_runs() {
    let [first, second] = runs();
    let compared = Comparison::of_runs(&[&first, &second, &first]);
    accept(
        "comparison_of_three_120",
        &comparison::tables(&compared, 120).to_text(120, Glyphs::Braille),
    );
    let csv = String::from_utf8(comparison::csv(&compared).unwrap()).unwrap();
    assert!(csv.lines().all(|line| line.contains(',')));
}

/// A line straight down that swings away by so much each second.
fn swinging(by: f64, nodes: u32) -> Run {
    let [mut run, _] = runs();
    let arc = || (0..nodes).map(|i| 100.0 * f64::from(i) / f64::from(nodes - 1));
    let shape = |time: f64| LineShape {
        time,
        line: 0,
        nodes: arc().map(|s| [by * time * s / 100.0, 0.0, -s]).collect(),
        tension: arc().map(|_| 0.0).collect(),
        ..LineShape::default()
    };
    run.shapes = (0..=4).map(|i| shape(f64::from(i))).collect();
    run.profiles[0].arc = arc().collect();
    run
}

/// The shapes of runs as a report of their own.
fn shapes(runs: &[&Run]) -> Report {
    let mut page = Report::default();
    comparison::add_shapes(&mut page, runs);
    page
}

#[test]
fn lines_are_drawn_where_they_are_furthest_apart() {
    let (mut first, mut second) = (swinging(0.0, 5), swinging(5.0, 9));
    for run in [&mut first, &mut second] {
        run.shapes.push(LineShape {
            time: 5.0,
            ..run.shapes[1].clone()
        });
    }
    accept(
        "comparison_shapes_80",
        &shapes(&[&first, &second]).to_text(80, Glyphs::Braille),
    );
    assert!(shapes(&[&first, &first]).blocks().is_empty());
    let rest = Run {
        shapes: Vec::new(),
        ..second.clone()
    };
    assert!(shapes(&[&first, &rest]).blocks().is_empty());
}

/// A case that this version cannot read leaves the rest of the comparison as it is.
#[test]
fn a_case_that_cannot_be_read_is_noted() {
    let [first, mut second] = runs();
    second.case_text = "nonsense = 1".to_owned();
    let compared = Comparison::of_runs(&[&first, &second]);
    assert!(
        compared.notes.iter().any(|note| note.contains("case of B")),
        "{:?}",
        compared.notes
    );
    assert!(compared.inputs.is_empty() && !compared.results.is_empty());
}
