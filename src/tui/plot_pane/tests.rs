//! Cursor, zoom, pan, freeze, marks.

use proptest::prelude::*;

use super::*;
use crate::chart::{Axis, PicturePart};

const SIZE: (usize, usize) = (80, 20);

fn base() -> Chart {
    let points = (0..=600).map(|i| (f64::from(i), 1e6 + 1e3 * f64::from(i)));
    Chart::new(
        "",
        Axis::new("time", "s").over((0.0, 600.0)),
        Axis::new("tension", "N"),
        vec![
            Series::new("top", 0, points.collect()),
            Series::new("end", 1, vec![(0.0, 0.0), (600.0, 5e5)]),
        ],
    )
}

fn act(pane: &mut PlotPane, base: &Chart, verbs: &[PlotVerb]) {
    for verb in verbs {
        let frame = frame(pane, base);
        pane.act(*verb, base, frame);
    }
}

fn in_colour() -> Theme {
    Theme::new(crate::terminal::capabilities::Capabilities {
        glyphs: Glyphs::Braille,
        colour: true,
        palette: crate::theme::Palette::Dark,
        unsure: false,
    })
}

fn frame(pane: &PlotPane, base: &Chart) -> PlotFrame {
    chart::frame(&pane.chart(base), SIZE.0, SIZE.1, Glyphs::Braille)
}

fn is_zoomed(pane: &PlotPane) -> bool {
    pane.x.is_some() || pane.y.is_some()
}

#[test]
fn the_cursor_begins_in_the_middle_and_stops_at_the_ends() {
    let (base, mut pane) = (base(), PlotPane::default());
    act(&mut pane, &base, &[PlotVerb::Cursor(1.0, Stride::Fine)]);
    assert_eq!(pane.cursor(), Some(300.0));
    act(&mut pane, &base, &[PlotVerb::Cursor(1.0, Stride::Coarse)]);
    assert_eq!(pane.cursor(), Some(360.0));
    act(
        &mut pane,
        &base,
        &vec![PlotVerb::Cursor(1.0, Stride::Coarse); 20],
    );
    assert_eq!(pane.cursor(), Some(600.0));
    let read = pane.readout(&base);
    assert_eq!(read[0].y, Some(1.6e6));
    assert_eq!(read[1].words("s"), "end 500 kN");
}

#[test]
fn zoom_keeps_the_cursor_where_it_is_and_ends_at_everything() {
    let (base, mut pane) = (base(), PlotPane::default());
    pane.set_cursor(Some(150.0));
    let before = frame(&pane, &base).column_of(150.0);
    act(&mut pane, &base, &[PlotVerb::Zoom(0.5)]);
    let zoomed = frame(&pane, &base);
    assert_eq!(zoomed.x, (75.0, 375.0));
    assert_eq!(zoomed.column_of(150.0), before);
    act(&mut pane, &base, &[PlotVerb::Zoom(2.0)]);
    assert!(!is_zoomed(&pane));
}

#[test]
fn a_zoom_has_an_end() {
    let (base, mut pane) = (base(), PlotPane::default());
    act(&mut pane, &base, &vec![PlotVerb::Zoom(0.5); 100]);
    let x = frame(&pane, &base).x;
    assert!((x.1 - x.0) > 5e-4, "{x:?}");
    act(&mut pane, &base, &[PlotVerb::Fit]);
    assert_eq!(frame(&pane, &base).x, (0.0, 600.0));
}

#[test]
fn panning_stays_with_the_data_and_the_cursor_takes_the_view_along() {
    let (base, mut pane) = (base(), PlotPane::default());
    act(
        &mut pane,
        &base,
        &[PlotVerb::Zoom(0.5), PlotVerb::Pan(0.25, 0.0)],
    );
    assert_eq!(frame(&pane, &base).x, (225.0, 525.0));
    act(&mut pane, &base, &vec![PlotVerb::Pan(0.25, 0.0); 20]);
    assert_eq!(frame(&pane, &base).x, (450.0, 750.0));
    pane.set_cursor(Some(460.0));
    act(&mut pane, &base, &[PlotVerb::Cursor(-1.0, Stride::Coarse)]);
    assert_eq!(pane.cursor(), Some(430.0));
    assert_eq!(frame(&pane, &base).x, (430.0, 730.0));
}

#[test]
fn height_can_be_fitted_to_what_is_seen() {
    let (mut base, mut pane) = (base(), PlotPane::default());
    base.series[1].visible = false;
    act(&mut pane, &base, &[PlotVerb::Zoom(0.5), PlotVerb::FitUp]);
    // From 150 s to 450 s the visible series goes from 1.15 to 1.45 MN.
    assert_eq!(frame(&pane, &base).y, (1.15e6, 1.45e6));
}

#[test]
fn nothing_drawn_can_be_frozen_but_not_zoomed() {
    let (base, mut pane) = (base(), PlotPane::default());
    pane.act(PlotVerb::Freeze, &base, PlotFrame::default());
    pane.act(PlotVerb::Zoom(0.5), &base, PlotFrame::default());
    assert!(pane.is_frozen() && !is_zoomed(&pane));
}

#[test]
fn a_frozen_chart_does_not_see_new_curves() {
    let (mut base, mut pane) = (base(), PlotPane::default());
    act(&mut pane, &base, &[PlotVerb::Freeze]);
    base.series[0].points.push((601.0, 0.0));
    assert_eq!(pane.chart(&base).series[0].points.len(), 601);
    act(&mut pane, &base, &[PlotVerb::Freeze]);
    assert_eq!(pane.chart(&base).series[0].points.len(), 602);
}

#[test]
fn a_second_mark_in_the_same_column_removes_the_first() {
    let (base, mut pane) = (base(), PlotPane::default());
    act(&mut pane, &base, &[PlotVerb::Mark]);
    assert!(pane.marks.is_empty(), "there is no cursor yet");
    pane.set_cursor(Some(281.0));
    act(&mut pane, &base, &[PlotVerb::Mark]);
    assert_eq!(pane.chart(&base).limits[0].label, "1: 281 s");
    act(&mut pane, &base, &[PlotVerb::Mark]);
    assert!(pane.marks.is_empty());
}

#[test]
fn without_colour_series_are_told_apart_by_marker_and_dimmed_by_weight() {
    let mut base = base();
    base.series[1].dimmed = true;
    let area = Rect::new(3, 2, 60, 16);
    let mut buf = Buffer::empty(Rect::new(0, 0, 70, 20));
    draw_chart(&base, area, &mut buf, Glyphs::Ascii, Theme::default());
    let markers = |ch: &str| {
        buf.content()
            .iter()
            .filter(|cell| cell.symbol() == ch)
            .count()
    };
    assert!(markers("o") > 20 && markers("x") > 1 && markers(".") > 20);
    assert!(
        buf.content()
            .iter()
            .all(|cell| cell.fg == ratatui::style::Color::Reset)
    );
    assert_eq!(
        Theme::default().chart(PicturePart::Dimmed(1)),
        Theme::default().slot(1).dim()
    );
}

fn verb() -> impl Strategy<Value = PlotVerb> {
    use PlotVerb as V;
    prop::sample::select(vec![
        V::Cursor(-1.0, Stride::Fine),
        V::Cursor(1.0, Stride::Coarse),
        V::Pan(-0.25, 0.0),
        V::Pan(0.25, 0.0),
        V::Pan(0.0, 0.25),
        V::Pan(0.0, -0.25),
        V::Zoom(0.5),
        V::Zoom(2.0),
        V::Fit,
        V::FitUp,
        V::Freeze,
        V::Mark,
    ])
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_keys_at_any_size_leave_a_usable_view(
        verbs in prop::collection::vec(verb(), 0..60),
        equal_scale in any::<bool>(),
        size in (0..90_usize, 0..30_usize),
    ) {
        let mut base = base();
        base.equal_scale = equal_scale;
        let mut pane = PlotPane::default();
        for verb in &verbs {
            let frame = chart::frame(&pane.chart(&base), size.0, size.1, Glyphs::Ascii);
            pane.act(*verb, &base, frame);
        }
        let frame = chart::frame(&pane.chart(&base), 80, 20, Glyphs::Ascii);
        prop_assert!(frame.x.0 < frame.x.1 && frame.y.0 < frame.y.1);
        let area = Rect::new(0, 0, size.0 as u16, size.1 as u16);
        let mut buf = Buffer::empty(area);
        draw_chart(&pane.chart(&base), area, &mut buf, Glyphs::Braille, in_colour());
    }
}

/// The characters, and below them a map of their styles: `c`, `y` and so on for colours, capitals
/// for bold, `.` for dim, `-` for the terminal's own.
fn with_styles(buf: &Buffer) -> String {
    use ratatui::style::{Color, Modifier};
    let letter = |cell: &ratatui::buffer::Cell| {
        let colour = match cell.fg {
            Color::Cyan => 'c',
            Color::Yellow => 'y',
            Color::Red => 'r',
            _ if cell.modifier.contains(Modifier::DIM) => '.',
            _ => '-',
        };
        match (cell.symbol(), cell.modifier.contains(Modifier::BOLD)) {
            (" ", _) => ' ',
            (_, true) if colour == '-' => 'B',
            (_, true) => colour.to_ascii_uppercase(),
            _ => colour,
        }
    };
    let width = usize::from(buf.area().width);
    let mut text = String::new();
    for row in buf.content().chunks(width) {
        let line: String = row.iter().map(ratatui::buffer::Cell::symbol).collect();
        text.push_str(line.trim_end());
        text.push('\n');
    }
    for row in buf.content().chunks(width) {
        let line: String = row.iter().map(letter).collect();
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[test]
fn a_zoomed_and_marked_chart_with_its_styles() {
    let (mut base, mut pane) = (base(), PlotPane::default());
    base.title = "Tension".to_owned();
    base.series[1].dimmed = true;
    pane.set_cursor(Some(200.0));
    act(&mut pane, &base, &[PlotVerb::Mark, PlotVerb::Zoom(0.5)]);
    act(&mut pane, &base, &[PlotVerb::Cursor(1.0, Stride::Coarse)]);
    let mut buf = Buffer::empty(Rect::new(0, 0, 60, 16));
    let area = *buf.area();
    draw_chart(
        &pane.chart(&base),
        area,
        &mut buf,
        Glyphs::Braille,
        in_colour(),
    );
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../../snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("plot_pane_zoomed_60x16", with_styles(&buf)));
}
