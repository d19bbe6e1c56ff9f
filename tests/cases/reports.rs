//! The reports of all shipped cases, of every kind: ASCII on 80 columns.

use std::path::{Path, PathBuf};

use seacable::case::kind;
use seacable::case::shipped::{ROPEWAYS, SECTIONS, SHIPS, SYSTEMS};
use seacable::chart::Glyphs;
use seacable::plain;
use seacable::report::document::{Block, ReportFormat};
use seacable::report::subject::ReportSubject;
use seacable::ropeway::Ropeway;
use seacable::section::CrossSection;
use seacable::ship::Ship;
use seacable::system::SystemFile;
use seacable::system::analysis::analyses::Analyses;
use seacable::system::validation;

use super::validation::COMPUTED;

/// Columns of a report.
const WIDTH: usize = 80;

/// As it leaves the program with `--ascii`: only ASCII, and no line too wide.
fn fits(name: &str, report: &str) {
    let text = plain::ascii(report);
    assert!(text.is_ascii(), "{name}");
    assert!(text.lines().count() > 20, "{name}: {text}");
    for line in text.lines() {
        assert!(
            line.len() <= WIDTH,
            "{name}: {} columns: {line}",
            line.len()
        );
    }
}

/// The text of what is reported, with its other formats, which have a chart and a table each.
fn written(name: &str, subject: &ReportSubject<'_>) {
    let write = |format| subject.write(format, Glyphs::Ascii, &[]).unwrap();
    fits(name, &write(ReportFormat::Text));
    let html = write(ReportFormat::Html);
    assert!(html.contains("<table"), "{name}");
    assert!(!html.contains("NaN") && !html.contains("<script"), "{name}");
    assert!(!write(ReportFormat::Csv).is_empty());
    let json: serde_json::Value = serde_json::from_str(&write(ReportFormat::Json)).unwrap();
    assert!(json["kind"].is_string(), "{name}");
}

fn place(path: &str) -> PathBuf {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    cases.join(path.trim_start_matches("cases/"))
}

#[test]
fn line_cases() {
    let reports = COMPUTED
        .iter()
        .filter_map(|one| Some((one.path, one.report.as_ref()?)));
    let mut count = 0;
    for (path, report) in reports {
        fits(path, report);
        count += 1;
    }
    assert!(count > 25, "{count}");
}

#[test]
fn sections() {
    for (path, text) in SECTIONS {
        let design = kind::parse::<CrossSection>(text, path).unwrap();
        let fields = kind::rows::<CrossSection>(text);
        written(path, &ReportSubject::Section(&design, &fields, None));
    }
}

#[test]
fn ropeways() {
    for (path, text) in ROPEWAYS {
        let solved = kind::parse::<Ropeway>(text, path).unwrap();
        let fields = kind::rows::<Ropeway>(text);
        let results = solved.results(solved.ropeway.cargo.position).unwrap();
        let subject = ReportSubject::Ropeway(&solved, Box::new(results), &fields);
        written(path, &subject);
    }
}

#[test]
fn ships() {
    for (path, text) in SHIPS {
        let statics = seacable::open::load::<Ship>(&place(path)).unwrap().computed;
        let fields = kind::rows::<Ship>(text);
        written(path, &ReportSubject::Ship(&statics, None, &fields));
    }
}

#[test]
fn systems_at_rest() {
    for (path, text) in SYSTEMS {
        let solved = seacable::open::load::<SystemFile>(&place(path))
            .unwrap()
            .computed;
        let fields = kind::rows::<SystemFile>(text);
        let analyses = Analyses::of_system(&solved);
        let rows = validation::rows(&solved, None);
        written(
            path,
            &ReportSubject::System(&solved, &analyses, &rows, &fields),
        );
    }
}

/// What is drawn in characters is drawn as a picture in HTML, each once.
#[test]
fn every_chart_is_a_picture() {
    let (path, text) = &ROPEWAYS[0];
    let solved = kind::parse::<Ropeway>(text, path).unwrap();
    let fields = kind::rows::<Ropeway>(text);
    let results = solved.results(solved.ropeway.cargo.position).unwrap();
    let report = seacable::report::ropeway::report(&solved, &results, &fields);
    let is_chart = |block: &&Block| matches!(block, Block::Chart(..));
    let charts = report.blocks().iter().filter(is_chart).count();
    assert!(charts >= 4, "{charts}");
    assert_eq!(report.to_html().matches("<svg ").count(), charts);
    let fences = report
        .to_markdown(Glyphs::Ascii)
        .matches("```text\n")
        .count();
    assert_eq!(fences, charts);
}
