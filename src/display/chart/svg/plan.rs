//! Where the parts of a picture lie.

use super::ink::{TEXT, TITLE};
use super::legend::{self, Legend};
use super::map;
use super::page::{Anchor, SvgPage, WIDTH, shortened, width};
use crate::chart::draw::{AxisDisplay, axis_name, ranges};
use crate::chart::range::equalise;
use crate::chart::ticks::{self, Tick};
use crate::chart::{AxisRange, AxisScale, Chart};
use crate::wrap::{WideWords, wrap};

/// Height of a row of words.
pub(super) const ROW: f64 = 16.0;

/// Room below the plot: the numbers of the axis and its name.
const BELOW: f64 = 2.0 * ROW + 10.0;

/// Room to the right of a plot without names there.
const RIGHT: f64 = 14.0;

/// The least height of a plot, and the greatest that a drawing to equal scale grows to.
const LEAST: f64 = 140.0;
const MOST: f64 = 400.0;

/// Room that a number needs beyond its own width, and the distance between numbers at the y axis.
const APART: (f64, f64) = (18.0, 26.0);

/// Where the parts of a picture lie, and what its axes show.
#[derive(Debug)]
pub(super) struct SvgPlan {
    /// Height of the picture.
    pub(super) height: f64,
    /// The plot: left and upper edge, width and height.
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) across: f64,
    pub(super) down: f64,
    /// What the axes show.
    pub(super) x: AxisDisplay,
    pub(super) y: AxisDisplay,
    /// Their ticks.
    pub(super) along: Vec<Tick>,
    pub(super) up: Vec<Tick>,
    /// Name and unit of the y axis.
    pub(super) name: String,
    /// Where the curves are named.
    pub(super) legend: Legend,
    title: Vec<String>,
}

impl SvgPlan {
    /// A plan of about this height.
    pub(super) fn of_chart(chart: &Chart, height: f64) -> Self {
        let title = wrap(&chart.title, title_columns(), WideWords::Broken);
        let title: Vec<String> = title.into_iter().filter(|line| !line.is_empty()).collect();
        let legend = legend::place(chart, ranges(chart), height);
        let head = (ROW + 3.0) * title.len() as f64 + legend.height() + ROW + 8.0;
        let right = legend.right().max(map::right(chart)).max(RIGHT);
        let down = down(chart, height - head - BELOW, WIDTH - 4.0 * TEXT - right);
        // Room for the numbers depends on the range, which at equal scale depends on the room.
        let mut left = 2.0 * TEXT;
        let mut plan = Self::with_left(chart, left, (head, right, down), (&title, &legend));
        for _ in 0..3 {
            let needed = plan.numbers() + 14.0;
            if needed <= left {
                break;
            }
            left = needed;
            plan = Self::with_left(chart, left, (head, right, down), (&title, &legend));
        }
        plan
    }

    fn with_left(
        chart: &Chart,
        left: f64,
        (top, right, down): (f64, f64, f64),
        (title, legend): (&[String], &Legend),
    ) -> Self {
        let across = WIDTH - left - right;
        let ((mut x, along), (mut y, up)) = ranges(chart);
        if chart.equal_scale {
            (x, y) = equalise(x, y, (across, down));
        }
        let mut plan = Self {
            height: top + down + BELOW,
            left,
            top,
            across,
            down,
            x: (x, along),
            y: (y, up),
            along: Vec::new(),
            up: Vec::new(),
            name: name(chart, (y, up)),
            legend: legend.clone(),
            title: title.to_vec(),
        };
        plan.up = ticks::along(up, y, &chart.y.unit, 60, |ticks| plan.roomy_up(ticks));
        plan.along = ticks::along(along, x, &chart.x.unit, 60, |ticks| plan.roomy_along(ticks));
        plan
    }

    fn numbers(&self) -> f64 {
        let widths = self.up.iter().map(|tick| width(&tick.label, TEXT));
        widths.fold(0.0, f64::max)
    }

    fn roomy_up(&self, ticks: &[Tick]) -> bool {
        let places: Vec<f64> = ticks.iter().map(|tick| self.y_of(tick.value)).collect();
        places.windows(2).all(|pair| pair[0] - pair[1] >= APART.1)
    }

    fn roomy_along(&self, ticks: &[Tick]) -> bool {
        let half = |tick: &Tick| 0.5 * width(&tick.label, TEXT);
        let apart = |a: &Tick, b: &Tick| self.x_of(b.value) - self.x_of(a.value);
        let room = |pair: &[Tick]| half(&pair[0]) + half(&pair[1]) + APART.0;
        ticks
            .windows(2)
            .all(|pair| apart(&pair[0], &pair[1]) >= room(pair))
    }

    /// The lower edge of the plot.
    pub(super) fn bottom(&self) -> f64 {
        self.top + self.down
    }

    /// The right edge of the plot.
    pub(super) fn right(&self) -> f64 {
        self.left + self.across
    }

    /// Where an x lies.
    pub(super) fn x_of(&self, x: f64) -> f64 {
        self.left + self.across * share(self.x, x)
    }

    /// Where a y lies.
    pub(super) fn y_of(&self, y: f64) -> f64 {
        self.bottom() - self.down * share(self.y, y)
    }

    /// Title and name of the y axis.
    pub(super) fn draw_head(&self, page: &mut SvgPage) {
        let mut row = TITLE;
        for line in &self.title {
            let style = format!(" font-size=\"{TITLE}\" font-weight=\"bold\"");
            page.styled_words((0.0, row), Anchor::Start, line, &style);
            row += ROW + 3.0;
        }
        let name = shortened(&self.name, WIDTH, TEXT);
        page.words((0.0, self.top - 8.0), Anchor::Start, &name);
    }
}

/// Height of the plot where so much is left for it, and for so wide a plot: to equal scale as much as its drawing needs, up to a limit.
fn down(chart: &Chart, left: f64, across: f64) -> f64 {
    let least = LEAST.max(left);
    if !chart.equal_scale {
        return least;
    }
    let ((x, _), (y, _)) = ranges(chart);
    let needed = across * (y.1 - y.0) / (x.1 - x.0);
    needed.clamp(LEAST, least.max(MOST))
}

/// Columns of the title.
fn title_columns() -> usize {
    (WIDTH / width("n", TITLE)) as usize
}

/// Name and unit of the y axis.
fn name(chart: &Chart, (range, scale): AxisDisplay) -> String {
    let unit = ticks::scale(range, &chart.y.unit).unit(&chart.y.unit);
    axis_name(&chart.y.label, &unit, scale, usize::MAX)
}

/// How far along its axis a value lies, from 0 to 1 within what is shown.
pub(super) fn share((range, scale): (AxisRange, AxisScale), value: f64) -> f64 {
    let (from, to) = scale.places(range);
    (scale.place(value) - from) / (to - from)
}
