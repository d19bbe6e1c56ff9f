use super::{ink, map, svg};
use crate::chart::{Axis, AxisScale, Chart, GridMap, LimitLine, ReferenceLine, Series};

fn ramp(slot: usize) -> Series {
    let points = (0..=10).map(|i| (f64::from(i), f64::from(i) * (slot + 1) as f64));
    Series::new(&format!("curve {slot}"), slot, points.collect())
}

fn chart(curves: usize) -> Chart {
    let series = (0..curves).map(ramp).collect();
    Chart::new(
        "A ramp",
        Axis::new("time", "s"),
        Axis::new("tension", "N"),
        series,
    )
}

/// What stands between two words, of each time that the first is found.
fn between<'t>(text: &'t str, from: &'t str, to: &'t str) -> Vec<&'t str> {
    let parts = text.split(from).skip(1);
    parts.filter_map(|part| part.split(to).next()).collect()
}

/// The luminance of a colour (WCAG 2.1), from 0 for black to 1 for white.
fn luminance(colour: &str) -> f64 {
    let part = |at: usize| {
        let value = u8::from_str_radix(&colour[at..at + 2], 16).unwrap();
        let value = f64::from(value) / 255.0;
        match value <= 0.04045 {
            true => value / 12.92,
            false => ((value + 0.055) / 1.055).powf(2.4),
        }
    };
    0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
}

#[test]
fn lines_and_words_are_dark_enough_on_white() {
    let words = [ink::BLACK, ink::LIMIT, ink::DIMMED];
    for colour in words.iter().chain(&ink::COLOURS) {
        let contrast = 1.05 / (luminance(colour) + 0.05);
        assert!(contrast >= 4.5, "{colour}: {contrast}");
    }
}

#[test]
fn curves_differ_without_colour() {
    let looks = |slot: usize| {
        let series = ramp(slot);
        (ink::dash(&series), ink::marker(slot), ink::is_filled(slot))
    };
    for one in 0..16 {
        for other in 0..one {
            assert_ne!(looks(one), looks(other), "{one} {other}");
        }
        for other in 0..one.min(8) {
            assert!(one >= 8 || looks(one).0 != looks(other).0);
        }
    }
    let dimmed = Series {
        dimmed: true,
        ..ramp(0)
    };
    assert_ne!(ink::dash(&dimmed), ink::dash(&ramp(0)));
}

#[test]
fn a_map_darkens_with_the_value() {
    let shades: Vec<f64> = map::SHADES.iter().map(|shade| luminance(shade)).collect();
    assert!(
        shades.windows(2).all(|pair| pair[0] > 1.15 * pair[1]),
        "{shades:?}"
    );
}

#[test]
fn words_are_words_and_no_markup() {
    let mut hostile = chart(1);
    hostile.title = "</svg><script>alert(1)</script>".to_owned();
    hostile.series[0].label = "a\" onload=\"b".to_owned();
    hostile.x.label = "time & <b>".to_owned();
    hostile.limits = vec![ReferenceLine::new(
        "<img src=x>",
        LimitLine::Horizontal(5.0),
    )];
    let text = svg(&hostile, 20);
    assert_eq!(text.matches("<svg").count(), 1);
    assert_eq!(text.matches("</svg>").count(), 1);
    for word in ["<script", "<img", "<b>", "onload=\"", "href", "url("] {
        assert!(!text.contains(word), "{word}");
    }
    assert!(text.contains("time &amp; &lt;b&gt; [s]"));
}

#[test]
fn curves_are_named_at_their_ends_or_above() {
    let few = svg(&chart(3), 20);
    for slot in 0..3 {
        assert_eq!(few.matches(&format!(">curve {slot}<")).count(), 1);
    }
    // A curve that ends early has no right end.
    let mut early = chart(2);
    early.series[1].points.truncate(3);
    let above = svg(&early, 20);
    let row = |text: &str, name: &str| {
        let before = text.split(&format!(">{name}<")).next().unwrap();
        let y = before.rsplit("y=\"").next().unwrap();
        y.split('"').next().unwrap().parse::<f64>().unwrap()
    };
    assert!((row(&above, "curve 0") - row(&above, "curve 1")).abs() < 0.1);
    assert!((row(&few, "curve 0") - row(&few, "curve 1")).abs() >= 15.0);
}

#[test]
fn a_peak_one_sample_wide_stays_and_the_picture_small() {
    let points = |i: u32| {
        (
            f64::from(i),
            if i == 50_000 {
                9.0
            } else {
                (f64::from(i) * 0.7).sin()
            },
        )
    };
    let series = vec![Series::new("noise", 0, (0..100_000).map(points).collect())];
    let chart = Chart::new("", Axis::new("time", "s"), Axis::new("x", "m"), series);
    let text = svg(&chart, 20);
    assert!(text.len() < 60_000, "{}", text.len());
    let curve = between(&text, "<path d=\"", "\"");
    let longest = curve.iter().max_by_key(|d| d.len()).unwrap();
    let ys = longest
        .split(['M', 'L'])
        .filter_map(|at| at.split(' ').nth(1)?.parse::<f64>().ok());
    let ys: Vec<f64> = ys.collect();
    let highest = ys.iter().copied().fold(f64::INFINITY, f64::min);
    let second = ys
        .iter()
        .copied()
        .filter(|y| *y > highest)
        .fold(f64::INFINITY, f64::min);
    assert!(second - highest > 100.0, "{highest} {second}");
}

#[test]
fn nothing_is_drawn_outside_the_plot() {
    let mut wide = chart(1);
    wide.series[0].points = vec![
        (-1e9, 5.0),
        (5.0, 5.0),
        (5.0, 1e30),
        (6.0, f64::NAN),
        (7.0, 3.0),
    ];
    wide.x.range = Some((0.0, 10.0));
    wide.y.range = Some((0.0, 10.0));
    let text = svg(&wide, 20);
    let numbers = between(&text, " d=\"", "\"").join(" ");
    let numbers = numbers.split(|c: char| !c.is_ascii_digit() && c != '.' && c != '-');
    for number in numbers.filter_map(|number| number.parse::<f64>().ok()) {
        assert!(number.abs() <= super::page::WIDTH, "{number}");
    }
    assert!(!text.contains("NaN") && !text.contains("inf"));
}

#[test]
fn axes_are_logarithmic_maps_shaded_and_scales_equal() {
    let mut log = chart(1);
    log.series[0].points = vec![(1.0, 1.0), (10.0, 10.0), (1000.0, 100.0)];
    log.x.scale = AxisScale::Log;
    assert!(svg(&log, 20).contains(">time, log [s]<"));

    let grid = GridMap {
        x: vec![0.0, 1.0, 2.0],
        y: vec![0.0, 1.0],
        values: vec![-1.0, 0.0, 1.0, 2.0, f64::NAN, 2.0],
        of: Axis::new("displacement", "m"),
    };
    let text = svg(
        &Chart {
            map: Some(grid),
            ..chart(0)
        },
        30,
    );
    assert!(text.contains(map::SHADES[8]) && text.contains(">2 m<") && text.contains(">-2 m<"));
    assert!(!text.contains("NaN"));

    let circle = (0..=36).map(|i| (f64::from(i) * 10.0).to_radians());
    let circle = circle.map(|a| (a.cos(), a.sin())).collect();
    let round = Chart {
        equal_scale: true,
        ..Chart::new(
            "",
            Axis::new("x", "m"),
            Axis::new("y", "m"),
            vec![Series::new("o", 0, circle)],
        )
    };
    let text = svg(&round, 20);
    let longest = between(&text, "<path d=\"", "\"")
        .into_iter()
        .max_by_key(|d| d.len())
        .unwrap();
    let places = longest.split(['M', 'L']).filter_map(|at| {
        let (x, y) = at.split_once(' ')?;
        Some((x.parse::<f64>().ok()?, y.parse::<f64>().ok()?))
    });
    let places: Vec<(f64, f64)> = places.collect();
    let span = |of: fn(&(f64, f64)) -> f64| {
        let values = places.iter().map(of);
        values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
    };
    assert!((span(|p| p.0) - span(|p| p.1)).abs() < 0.5);
}

#[test]
fn error_bars_have_caps_and_no_gaps() {
    let mut bars = chart(1);
    let points = vec![
        (2.0, 1.0),
        (2.0, 3.0),
        (2.0, f64::NAN),
        (4.0, 3.0),
        (4.0, 5.0),
    ];
    bars.series.push(Series::new("error bars", 1, points));
    let text = svg(&bars, 20);
    let caps = text.lines().filter(|line| line.matches("h6").count() == 4);
    assert_eq!(caps.clone().count(), 1, "{text}");
    assert!(caps.clone().all(|line| !line.contains("dasharray")));
}

#[test]
fn reference_lines_are_named_beside_each_other() {
    let mut limited = chart(1);
    limited.limits = vec![
        ReferenceLine::new("breaks at 5 N", LimitLine::Bound(5.0)),
        ReferenceLine::new("rope breaks at 5 N", LimitLine::Bound(5.0)),
        ReferenceLine::new("chain breaks at 5 MN", LimitLine::Bound(5e6)),
        ReferenceLine::new(
            "published: mean",
            LimitLine::Band {
                x: (2.0, 4.0),
                y: (3.0, 4.0),
            },
        ),
        ReferenceLine::new("at the time", LimitLine::Vertical(8.0)),
    ];
    let text = svg(&limited, 20);
    for name in [
        "breaks at 5 N",
        "rope breaks at 5 N",
        "↑ chain breaks at 5 MN",
        "published: mean",
        "at the time",
    ] {
        assert!(text.contains(&format!(">{name}<")), "{name}");
    }
    assert!(text.contains("<rect"));
}

#[test]
fn the_same_chart_is_the_same_picture() {
    assert_eq!(svg(&chart(5), 20), svg(&chart(5), 20));
}
