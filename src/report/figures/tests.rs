//! What the charts of runs are made of.

use super::*;
use seacable_display::chart::{Chart, LimitLine};
use seacable_runs::run::{Channel, Profile};

fn channel(name: &str, values: Vec<f64>) -> Channel {
    Channel {
        values,
        ..Channel::new(name.parse().unwrap())
    }
}

fn history() -> History {
    History {
        time: vec![0.0, 1.0, 2.0],
        channels: vec![
            channel("tension_n[vessel|wire]", vec![3e6, 2e6, 1e6]),
            channel("tension_n[wire|payload]", vec![1e6, 1e6, 1e6]),
            channel("x_m[payload]", vec![1400.0, 700.0, 0.0]),
            channel("z_m[payload]", vec![0.0, -900.0, -1400.0]),
        ],
    }
}

fn shapes() -> Vec<LineShape> {
    let at = |time: f64, x: f64, z: f64| LineShape {
        time,
        line: 0,
        nodes: vec![[0.0, 0.0, 0.0], [x, 0.0, z]],
        tension: vec![0.0, 0.0],
        ..LineShape::default()
    };
    vec![at(0.0, 1400.0, 0.0), at(5.0, 0.0, -1390.0)]
}

fn labels(chart: &Chart) -> Vec<&str> {
    chart.series.iter().map(|s| s.label.as_str()).collect()
}

fn tensions(sources: &[PlottedRun]) -> Chart {
    against_time(sources, ChannelQuantity::Tension)
}

#[test]
fn joints_come_from_the_channel_names() {
    let history = history();
    let chart = tensions(&[PlottedRun::streamed(&history, &[], "a").until(600.0)]);
    assert_eq!(labels(&chart), ["vessel|wire", "wire|payload"]);
    assert_eq!(chart.series[0].points[1], (1.0, 2e6));
    assert_eq!(chart.x.range, Some((0.0, 600.0)));
}

#[test]
fn an_older_run_shares_slots_and_a_second_one_does_not() {
    let history = history();
    let new = PlottedRun::streamed(&history, &[], "new");
    let old = PlottedRun::streamed(&history, &[], "old");
    let slots = |sources: &[PlottedRun]| -> Vec<usize> {
        tensions(sources).series.iter().map(|s| s.slot).collect()
    };
    assert_eq!(slots(&[old.dimmed(), new]), [0, 1, 0, 1]);
    assert_eq!(slots(&[old, new]), [0, 1, 2, 3]);
    let chart = tensions(&[old.dimmed(), new]);
    assert_eq!(labels(&chart)[0], "vessel|wire, old");
    assert!(chart.series[0].dimmed && !chart.series[2].dimmed);
}

#[test]
fn the_path_is_to_equal_scale_with_still_water_and_the_instant() {
    let history = history();
    let chart = trajectory(&[PlottedRun::streamed(&history, &[], "")], Some(1.2));
    assert!(chart.equal_scale);
    assert_eq!(labels(&chart), ["payload", "at 1 s"]);
    assert_eq!(chart.series[1].points, [(700.0, -900.0)]);
    assert_eq!(chart.limits[0].line, LimitLine::Horizontal(0.0));
}

#[test]
fn the_path_is_that_of_the_loose_end_whatever_its_name() {
    let mut history = history();
    history.channels = ["x_m[vessel]", "z_m[vessel]", "x_m[clump]", "z_m[clump]"]
        .map(|name| channel(name, vec![0.0; 3]))
        .into();
    let title =
        |history: &History| trajectory(&[PlottedRun::streamed(history, &[], "")], None).title;
    assert_eq!(title(&history), "Path of the vessel");
    history
        .channels
        .push(channel("speed_m_per_s[clump]", vec![0.0; 3]));
    assert_eq!(title(&history), "Path of the clump");
}

#[test]
fn the_axes_of_the_shape_stand_still() {
    let (history, shapes) = (history(), shapes());
    let sources = [PlottedRun::streamed(&history, &shapes, "")];
    let (early, late) = (line_shape(&sources, 0.0), line_shape(&sources, 99.0));
    assert_eq!(early.x.range, late.x.range);
    assert_eq!(early.y.range, Some((-1400.0, 0.0)));
    assert_eq!(labels(&late), ["line at 5 s"]);
}

#[test]
fn a_line_at_rest_is_seen_from_three_sides_and_has_no_envelope() {
    let history = History {
        time: vec![0.0],
        ..History::default()
    };
    let profile = Profile {
        arc: vec![0.0, 5.0],
        nodes: vec![[0.0, 0.0, -4.0], [3.0, 1.0, 0.0]],
        tension: vec![1.0, 2.0],
        tension_min: vec![1.0, 2.0],
        tension_max: vec![1.0, 2.0],
        curvature: vec![0.0, 0.1],
        curvature_max: vec![0.0, 0.1],
        moment: vec![0.0, 10.0],
        moment_max: vec![0.0, 10.0],
        ..Profile::default()
    };
    let named = |label| PlottedRun {
        profiles: std::slice::from_ref(&profile),
        ..PlottedRun::streamed(&history, &[], label)
    };
    let alone = [named("a")];
    let points = |chart: Chart| chart.series[0].points.clone();
    assert_eq!(points(line_shape(&alone, 0.0))[1], (3.0, 0.0));
    assert_eq!(points(line_from_above(&alone, 0.0))[1], (3.0, 1.0));
    assert_eq!(points(line_from_ahead(&alone, 0.0))[1], (1.0, 0.0));
    assert!(line_from_above(&alone, 0.0).limits.is_empty());
    assert_eq!(labels(&tension_profile(&alone)), ["at rest"]);
    assert_eq!(points(moment_profile(&alone))[1], (5.0, 10.0));
    let two = [named("a"), named("b")];
    assert_eq!(labels(&curvature_profile(&two)), ["a", "b"]);
    assert_eq!(labels(&line_shape(&two, 0.0)), ["a", "b"]);
}

#[test]
fn nothing_yet_is_an_empty_chart() {
    let history = History::default();
    let sources = [PlottedRun::streamed(&history, &[], "")];
    for chart in [
        tensions(&sources),
        payload_position(&sources),
        trajectory(&sources, Some(1.0)),
        line_shape(&sources, 1.0),
        tension_profile(&sources),
        tensions(&[]),
    ] {
        assert!(chart.series.is_empty());
    }
}

const STATED: &str = r#"
[case]
title = "x"
[materials.wire]
diameter_m = 0.1
mass_kg_per_m = 10.0
ea_n = 1e8
break_load_n = 2.5e6
[[line]]
name = "wire"
material = "wire"
length_m = 100.0
segments = 4
[seabed]
depth_m = 1500.0
[ends.a]
name = "vessel"
kind = "fixed"
[ends.b]
name = "payload"
kind = "free"
[solver]
duration_s = 2.0
[[published]]
name = "late tension"
channel = "tension_n[wire|payload]"
statistic = "mean"
window_s = [1.0, 2.0]
value = 1.1e6
tolerance_rel = 0.1
source = "table 1"
inputs = "published"
"#;

#[test]
fn limits_and_published_values_are_drawn_where_the_case_states_them() {
    let case = seacable_model::case::parse_keys(STATED).unwrap();
    let history = history();
    let runs = [PlottedRun::streamed(&history, &[], "a")];
    let mut row = seacable_runs::reference::ValidationRow::default();
    let lines = |id: FigureId, limits: bool, chosen: Option<usize>, checks: &[_]| {
        let data = FigureData {
            case: Some(&case),
            runs: &runs,
            checks,
            instant: None,
            chosen,
            limits,
        };
        let chart = id.figure().draw(&data);
        chart
            .limits
            .into_iter()
            .map(|limit| (limit.label, limit.line))
            .collect::<Vec<_>>()
    };
    let breaks = ("wire breaks at 2.5 MN".to_owned(), LimitLine::Bound(2.5e6));
    let band = (
        "published: late tension".to_owned(),
        LimitLine::Band {
            x: (1.0, 2.0),
            y: (1.1e6 - 0.1 * 1.1e6, 1.1e6 + 0.1 * 1.1e6),
        },
    );
    let all = lines(FigureId::Tensions, true, None, &[]);
    assert_eq!(all, [breaks.clone(), band.clone()]);
    // Of the joint at the vessel nothing is published.
    assert_eq!(
        lines(FigureId::Tensions, true, Some(0), &[]),
        std::slice::from_ref(&breaks)
    );
    assert_eq!(lines(FigureId::Tensions, true, Some(1), &[]).len(), 2);
    assert!(lines(FigureId::Tensions, false, None, &[]).is_empty());
    let bed = lines(FigureId::Payload, true, None, &[]);
    assert_eq!(bed, [("sea bed".to_owned(), LimitLine::Bound(-1500.0))]);
    // A published value does not stand beside the curves of an edited case.
    row.outcome = seacable_runs::reference::Outcome::Edited;
    let edited = lines(FigureId::Tensions, true, None, &[row]);
    assert_eq!(edited, [breaks]);
}

#[test]
fn a_bound_beyond_the_plot_is_named_at_its_edge() {
    use seacable_display::chart::{Axis, Glyphs, ReferenceLine, Series, draw};
    let series = vec![Series::new("top", 0, vec![(0.0, 0.0), (600.0, 2.0e6)])];
    let mut chart = Chart::new(
        "t",
        Axis::new("time", "s"),
        Axis::new("tension", "N"),
        series,
    );
    chart.limits = vec![
        ReferenceLine::new("breaks", LimitLine::Bound(9e6)),
        ReferenceLine::new("bed", LimitLine::Bound(-9e6)),
        ReferenceLine::new(
            "published",
            LimitLine::Band {
                x: (300.0, 500.0),
                y: (2e5, 4e5),
            },
        ),
    ];
    let text = draw(&chart, 60, 16, Glyphs::Ascii).to_text();
    assert!(
        text.contains("^ breaks") && text.contains("v bed"),
        "{text}"
    );
    assert!(
        text.contains("=====") && text.contains("published"),
        "{text}"
    );
}
