//! Charts as people see them, and what must hold at any size and for any data.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use proptest::prelude::*;
use seacable::case::{self, shipped::SHIPPED};
use seacable::chart::{
    Axis, AxisScale, Chart, Glyphs, GridMap, LimitLine, PictureCell, PicturePart, ReferenceLine,
    Series, draw, marker, readout,
};
use seacable::report::figures::{FigureData, FigureId, PlottedRun};
use seacable::run::job::{self, Request};

/// Accepted pictures live in the top-level `snapshots/`, named by what they show.
fn accept(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// A tension that surges, falls and settles, as a lowered payload's does.
fn tension(peak_s: f64, final_n: f64) -> Vec<(f64, f64)> {
    let at = |i: i32| {
        let t = f64::from(i) * 0.5;
        let settling = 1.0 - (-(t / 180.0).powi(3)).exp();
        let surge = 0.35 * (-((t - peak_s) / 12.0).powi(2)).exp();
        (t, final_n * (0.4 + 0.6 * settling + surge))
    };
    (0..=1200).map(at).collect()
}

fn tensions() -> Chart {
    Chart {
        title: "Tension at the joints".to_owned(),
        x: Axis::new("time", "s"),
        y: Axis::new("tension", "N"),
        series: vec![
            Series::new("vessel|chain", 0, tension(25.0, 3.94e6)),
            Series::new("chain|polyester", 1, tension(25.0, 3.6e6)),
            Series::new("polyester|wire", 2, tension(30.0, 2.4e6)),
            Series::new("wire|payload", 3, tension(30.0, 1.96e6)),
        ],
        limits: vec![ReferenceLine {
            label: "hanging weight 3.77 MN".to_owned(),
            line: LimitLine::Horizontal(3.766e6),
        }],
        cursor: Some(281.0),
        legend: true,
        ..Chart::default()
    }
}

fn trajectory() -> Chart {
    let swing = |i: i32| {
        let angle = f64::from(i) / 200.0 * std::f64::consts::FRAC_PI_2;
        (1400.0 * angle.cos(), -1400.0 * angle.sin())
    };
    Chart {
        title: "Path of the payload".to_owned(),
        x: Axis::new("x", "m"),
        y: Axis::new("z", "m"),
        series: vec![
            Series::new("this run", 0, (0..=200).map(swing).collect()),
            Series {
                dimmed: true,
                ..Series::new(
                    "run before",
                    1,
                    vec![(1400.0, 0.0), (900.0, -900.0), (0.0, -1380.0)],
                )
            },
        ],
        equal_scale: true,
        legend: true,
        ..Chart::default()
    }
}

#[test]
fn tensions_at_80x24_in_braille_and_ascii() {
    let chart = tensions();
    accept(
        "chart_tensions_80x24_braille",
        &draw(&chart, 80, 24, Glyphs::Braille).to_text(),
    );
    accept(
        "chart_tensions_80x24_ascii",
        &draw(&chart, 80, 24, Glyphs::Ascii).to_text(),
    );
}

#[test]
fn a_trajectory_to_equal_scale() {
    let chart = trajectory();
    accept(
        "chart_trajectory_60x24_braille",
        &draw(&chart, 60, 24, Glyphs::Braille).to_text(),
    );
    accept(
        "chart_trajectory_60x24_ascii",
        &draw(&chart, 60, 24, Glyphs::Ascii).to_text(),
    );
}

/// The force of the bed is drawn where a case records it: here on a clump that lands.
#[test]
fn the_bed_force_on_a_clump_that_lands() {
    let text = |file: &str| SHIPPED.iter().find(|case| case.0 == file).unwrap().1;
    let parse = |file: &str| case::parse(text(file), file).unwrap();
    let without_bed = FigureId::of_case(&parse("basics/pendulum.toml"));
    assert!(!without_bed.contains(&FigureId::BedForce));
    let mut clump = parse("hard/clump_on_bed.toml");
    (clump.solver.duration_s, clump.output.interval_s) = (4.0, 0.02);
    clump.solver.error_estimate = false;
    let request = Request {
        case: clump.clone(),
        text: String::new(),
        file: "clump.toml".to_owned(),
        overrides: Vec::new(),
        id: "clump".to_owned(),
    };
    let run = job::execute(&request, &AtomicBool::new(false), &mut |_| {});
    assert!(FigureId::of_case(&clump).contains(&FigureId::BedForce));
    let chart = FigureId::BedForce.figure().draw(&FigureData {
        case: Some(&clump),
        runs: &[PlottedRun::whole(&run, "")],
        checks: &[],
        instant: None,
        limits: true,
        chosen: None,
    });
    accept(
        "chart_bed_force_80x24",
        &draw(&chart, 80, 24, Glyphs::Ascii).to_text(),
    );
}

/// A wave of period 10 s and length 60 m on a line of 120 m that comes back with this share of its amplitude.
fn waves(back: f64) -> Chart {
    let x: Vec<f64> = (0..=60).map(f64::from).collect();
    let y: Vec<f64> = (0..=40).map(|i| 3.0 * f64::from(i)).collect();
    let height = |t: f64, s: f64| {
        let (time, place) = (TAU * t / 10.0, TAU * s / 60.0);
        (time + place).cos() + back * (time - place).cos()
    };
    let values = x.iter().flat_map(|t| y.iter().map(|s| height(*t, *s)));
    let values = values.collect();
    Chart {
        title: format!("A wave and {back} of it coming back"),
        x: Axis {
            range: Some((0.0, 60.0)),
            ..Axis::new("time", "s")
        },
        y: Axis {
            range: Some((0.0, 120.0)),
            ..Axis::new("arc length", "m")
        },
        map: Some(GridMap {
            x,
            y,
            values,
            of: Axis::new("displacement", "D"),
        }),
        ..Chart::default()
    }
}

#[test]
fn stripes_lean_where_waves_travel_and_are_upright_where_they_stand() {
    let mut all = String::new();
    for (back, glyphs) in [
        (0.0, Glyphs::Braille),
        (0.0, Glyphs::Ascii),
        (1.0, Glyphs::Ascii),
    ] {
        all.push_str(&draw(&waves(back), 80, 24, glyphs).to_text());
        all.push('\n');
    }
    accept("chart_map_80x24", &all);
}

#[test]
fn a_map_has_logarithmic_axes_with_values_in_their_unit() {
    let y: Vec<f64> = (0..=6).map(|i| 10_f64.powf(f64::from(i) / 3.0)).collect();
    let x: Vec<f64> = (0..=4).map(f64::from).collect();
    let value = |x: &f64, y: &f64| x * y.log10() - 2.0;
    let values = x.iter().flat_map(|x| y.iter().map(move |y| value(x, y)));
    let ends = |axis: &[f64]| axis.first().copied().zip(axis.last().copied());
    let chart = Chart {
        map: Some(GridMap {
            values: values.collect(),
            of: Axis::new("displacement", "m"),
            x: x.clone(),
            y: y.clone(),
        }),
        ..Chart::new(
            "A map over even ratios",
            Axis {
                range: ends(&x),
                ..Axis::new("time", "s")
            },
            Axis {
                range: ends(&y),
                scale: AxisScale::Log,
                ..Axis::new("drag area", "m²")
            },
            Vec::new(),
        )
    };
    let text = draw(&chart, 80, 20, Glyphs::Braille).to_text();
    assert!(text.contains("drag area, log [m²]"), "{text}");
    accept("chart_map_log", &text);
}

#[test]
fn a_map_is_read_at_both_cursors() {
    let chart = Chart {
        cursor: Some(20.0),
        cursor_y: Some(60.0),
        ..waves(0.5)
    };
    let read = readout(&chart, 20.0).remove(0);
    assert_eq!(read.words("s"), "displacement at 60 m 1.5 D");
    let inks = draw(&chart, 80, 24, Glyphs::Braille);
    assert!(
        inks.cells
            .iter()
            .any(|cell| cell.ink == PicturePart::Shade(2))
    );
    assert!(
        inks.cells
            .iter()
            .any(|cell| cell.ink == PicturePart::Shade(-2))
    );
}

#[test]
fn small_charts_lose_their_surroundings_before_their_plot() {
    let mut all = String::new();
    for (width, height) in [(40, 12), (30, 8), (20, 5), (10, 3), (3, 2), (1, 1)] {
        let text = draw(&tensions(), width, height, Glyphs::Braille).to_text();
        all.push_str(&format!("{width}x{height}\n{text}\n"));
    }
    accept("chart_tensions_small", &all);
}

#[test]
fn equal_scale_is_equal() {
    for (width, height) in [(80, 24), (40, 30), (200, 20)] {
        for glyphs in [Glyphs::Braille, Glyphs::Ascii] {
            let frame = draw(&trajectory(), width, height, glyphs).frame;
            // A cell is twice as tall as it is wide.
            let (nx, ny) = frame.dot_count();
            let across = 1.0 / frame.dots.0 as f64;
            let up = 2.0 / frame.dots.1 as f64;
            let per_x = (frame.x.1 - frame.x.0) / ((nx - 1) as f64 * across);
            let per_y = (frame.y.1 - frame.y.0) / ((ny - 1) as f64 * up);
            assert!((per_x / per_y - 1.0).abs() < 1e-9, "{per_x} {per_y}");
            assert!(frame.x.0 <= 0.0 && frame.x.1 >= 1400.0);
            assert!(frame.y.0 <= -1400.0 && frame.y.1 >= 0.0);
        }
    }
}

#[test]
fn a_peak_one_sample_wide_stays_visible() {
    let mut points: Vec<(f64, f64)> = (0..200_000).map(|i| (f64::from(i), 0.0)).collect();
    points[123_456].1 = 1.0;
    let chart = Chart {
        y: Axis {
            range: Some((-0.1, 1.0)),
            ..Axis::default()
        },
        series: vec![Series::new("s", 0, points)],
        ..Chart::default()
    };
    for glyphs in [Glyphs::Braille, Glyphs::Ascii] {
        let picture = draw(&chart, 80, 20, glyphs);
        let top = picture.frame.top;
        let reaches = (0..80).any(|c| picture.get(c, top).unwrap().ink == PicturePart::Series(0));
        assert!(reaches, "{}", picture.to_text());
    }
}

#[test]
fn the_later_of_two_series_owns_their_common_cells() {
    let flat = vec![(0.0, 1.0), (10.0, 1.0)];
    let chart = Chart {
        series: vec![
            Series::new("first", 0, flat.clone()),
            Series::new("second", 1, flat),
        ],
        ..Chart::default()
    };
    let picture = draw(&chart, 80, 10, Glyphs::Braille);
    let count = |ch: char| picture.cells.iter().filter(|cell| cell.ch == ch).count();
    // Both markers are on the line, though only the second's dots are.
    assert!(count(marker(0)) > 0 && count(marker(1)) > 0);
    let dots = |ink: PicturePart| {
        let of = |c: &&PictureCell| c.ink == ink && c.ch > '\u{2800}';
        picture.cells.iter().filter(of).count()
    };
    assert_eq!(dots(PicturePart::Series(0)), 0);
    assert!(dots(PicturePart::Series(1)) > 60);
}

#[test]
fn a_zoomed_line_is_cut_at_the_edges_with_its_true_slope() {
    let chart = Chart {
        x: Axis {
            range: Some((40.0, 60.0)),
            ..Axis::default()
        },
        y: Axis {
            range: Some((0.0, 100.0)),
            ..Axis::default()
        },
        series: vec![Series::new("s", 0, vec![(0.0, 0.0), (100.0, 100.0)])],
        ..Chart::default()
    };
    let picture = draw(&chart, 60, 24, Glyphs::Ascii);
    let frame = picture.frame;
    for (x, y) in [(40.0, 40.0), (60.0, 60.0)] {
        let (column, row) = (frame.column_of(x).unwrap(), frame.row_of(y).unwrap());
        let cell = picture.get(frame.left + column, frame.top + row).unwrap();
        assert_eq!(cell.ink, PicturePart::Series(0), "{}", picture.to_text());
    }
}

#[test]
fn a_logarithmic_axis_makes_a_power_a_straight_line() {
    let points = |power: f64| {
        (0..=40)
            .map(move |i| f64::from(i) / 4.0)
            .map(move |x| (x, x.powf(power)))
    };
    let series = [("square", 2.0), ("cube", 3.0)].into_iter().enumerate();
    let log = |axis: Axis| Axis {
        scale: AxisScale::Log,
        ..axis
    };
    let chart = Chart {
        x: log(Axis::new("length", "m")),
        y: log(Axis::new("load", "N")),
        series: series
            .map(|(slot, (name, power))| Series::new(name, slot, points(power).collect()))
            .collect(),
        legend: true,
        ends: true,
        ..Chart::default()
    };
    let frame = draw(&chart, 80, 24, Glyphs::Braille).frame;
    let cell = |x: f64| (frame.column_of(x).unwrap(), frame.row_of(x * x).unwrap());
    let (a, b, c) = (cell(0.4), cell(2.0), cell(10.0));
    assert!((a.0 + c.0).abs_diff(2 * b.0) <= 2 && (a.1 + c.1).abs_diff(2 * b.1) <= 2);
    // Zero has no place on it.
    assert_eq!((frame.column_of(0.0), frame.row_of(-1.0)), (None, None));
    accept(
        "chart_log_braille",
        &draw(&chart, 80, 24, Glyphs::Braille).to_text(),
    );
    accept(
        "chart_log_ascii",
        &draw(&chart, 80, 24, Glyphs::Ascii).to_text(),
    );
}

#[test]
fn ascii_is_ascii_whatever_the_words() {
    let mut chart = tensions();
    chart.title = "Zugkraft – Größe ± 漢字".to_owned();
    chart.series[0].label = "Schäkel→Kette".to_owned();
    chart.limits[0].label = "≤ 4 MN".to_owned();
    for width in [5, 20, 80] {
        assert!(draw(&chart, width, 24, Glyphs::Ascii).to_text().is_ascii());
    }
}

fn value() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -1e7..1e7,
        2 => -1.0..1.0,
        1 => prop::sample::select(vec![
            f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1e300, -1e300, 1e-300, f64::MAX,
            f64::MIN_POSITIVE, 5e-324, 1e305,
        ]),
    ]
}

fn points() -> impl Strategy<Value = Vec<(f64, f64)>> {
    let constant = (value(), value(), 0..5_usize).prop_map(|(x, y, n)| vec![(x, y); n]);
    prop_oneof![prop::collection::vec((value(), value()), 0..40), constant]
}

prop_compose! {
    fn axis()(
        range in prop::option::of((value(), value())),
        unit in "(N|m|-|)",
        scale in prop::sample::select(vec![AxisScale::Linear, AxisScale::Log]),
    ) -> Axis {
        Axis { label: "quantity".to_owned(), unit, range, scale }
    }
}

prop_compose! {
    fn chart()(
        x in axis(),
        y in axis(),
        series in prop::collection::vec((points(), 0..40_usize, any::<bool>(), any::<bool>()), 0..5),
        limit in value(),
        cursor in prop::option::of(value()),
        equal_scale in any::<bool>(),
        ends in any::<bool>(),
        title in "(|Title|ein längerer Titel 漢字)",
        field in prop::option::of((prop::collection::vec(value(), 6), value(), value())),
    ) -> Chart {
        let series = series.into_iter().map(|(points, slot, dimmed, visible)| {
            Series { dimmed, visible, ..Series::new("a series", slot, points) }
        });
        Chart {
            title, x, y, cursor, equal_scale, ends,
            series: series.collect(),
            limits: vec![
                ReferenceLine { label: "limit".to_owned(), line: LimitLine::Horizontal(limit) },
                ReferenceLine { label: "limit".to_owned(), line: LimitLine::Vertical(limit) },
            ],
            legend: true,
            cursor_y: field.as_ref().map(|(_, first, _)| *first),
            map: field.map(|(values, first, step)| GridMap {
                x: vec![first, first + step.abs()],
                y: vec![0.0, 1.0, 2.0],
                values,
                of: Axis::new("height", "m"),
            }),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_chart_fits_any_size(chart in chart(), width in 0..90_usize, height in 0..40_usize) {
        for glyphs in [Glyphs::Braille, Glyphs::Ascii] {
            let picture = draw(&chart, width, height, glyphs);
            prop_assert_eq!(picture.cells.len(), width * height);
            let frame = picture.frame;
            prop_assert!(frame.left + frame.width <= width && frame.top + frame.height <= height);
            if width > 0 && height > 0 {
                prop_assert!(frame.width > 0 && frame.height > 0);
                prop_assert!(frame.x.0 < frame.x.1 && frame.y.0 < frame.y.1);
                prop_assert!(frame.x_of_column(0).is_finite());
            }
            if let Some(x) = chart.cursor {
                let _ = readout(&chart, x);
            }
        }
    }

    #[test]
    fn numbers_at_the_axes_are_whole_and_apart(
        low in -1e9..1e9, span in 1e-3..1e9, width in 20..120_usize, height in 5..50_usize,
    ) {
        let chart = Chart {
            series: vec![Series::new("s", 0, vec![(low, low), (low + span, low + span)])],
            ..Chart::default()
        };
        let picture = draw(&chart, width, height, Glyphs::Ascii);
        let row = picture.frame.top + picture.frame.height + 1;
        let text = picture.to_text();
        let line = text.lines().nth(row).unwrap_or_default();
        let numbers: Vec<f64> = line.split_whitespace().map(|t| t.parse().unwrap()).collect();
        // Evenly spaced, increasing: none was cut and none ran into its neighbour.
        for three in numbers.windows(3) {
            let (a, b) = (three[1] - three[0], three[2] - three[1]);
            prop_assert!(a > 0.0 && (a - b).abs() < 1e-6 * a, "{}", text);
        }
    }
}
