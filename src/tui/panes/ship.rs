//! Plan view of a ship, with a list of its equilibria.

use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

use super::{Pane, PaneInfo, about};
use crate::report::chart::marker;
use crate::report::number::{digits, si};
use crate::report::ship::plan;
use crate::ship::MooredEquilibrium;
use crate::ship::stability::DynamicStability;
use crate::ship::yaw_equilibria::YawStability;
use crate::tui::command::{self, CommandId, DOWN};
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, DocumentContent, ShipView};
use crate::tui::theme::Theme;
use crate::tui::update::motion::{moved, step};
use crate::tui::view::paint::wrap;
use crate::tui::view::painter::Painter;

/// Columns of the list of headings.
const LIST: u16 = 34;

pub(super) struct ShipPane;

impl Pane for ShipPane {
    fn about(&self) -> PaneInfo {
        about("Ship", "Go to the drawing", &[&[DOWN], command::LIST])
    }

    fn update(&self, state: &mut AppState, id: CommandId) -> Option<Vec<Effect>> {
        let by = step(state, id)?;
        if let DocumentContent::Ship(ship) = &mut state.document.as_mut()?.content {
            let count = ship.statics.equilibria.as_ref().map_or(0, Vec::len);
            ship.equilibrium = moved(ship.equilibrium, by, count);
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let document = painter.state.document.as_ref();
        let Some(DocumentContent::Ship(ship)) = document.map(|document| &document.content) else {
            return;
        };
        let [drawing, list] =
            Layout::horizontal([Constraint::Min(0), Constraint::Length(LIST)]).areas(area);
        let mut chart = plan::chart(&ship.statics, ship.equilibrium);
        // The list beside it names the ships; every line counts here.
        chart.title.clear();
        chart.legend = false;
        painter.chart(&chart, drawing);
        painter.lines(list, headings(painter.theme, ship));
    }
}

/// Every equilibrium heading, and the directions of anchor and loads.
fn headings(theme: Theme, ship: &ShipView) -> Vec<(String, Style)> {
    let mut lines: Vec<(String, Style)> = Vec::new();
    let plain = theme.plain();
    match &ship.statics.equilibria {
        Ok(equilibria) => {
            for (i, equilibrium) in equilibria.iter().enumerate() {
                lines.extend(equilibrium_lines(
                    theme,
                    i,
                    equilibrium,
                    i == ship.equilibrium,
                ));
            }
        }
        Err(error) => {
            let words = wrap(&format!("No equilibrium heading: {error}."), LIST.into());
            lines.extend(words.into_iter().map(|line| (line, theme.error())));
        }
    }
    lines.push((String::new(), plain));
    let count = ship.statics.equilibria.as_ref().map_or(0, Vec::len);
    let names = ["anchor"].into_iter().map(str::to_owned);
    let flows = ship.statics.loads.each.iter().map(|load| {
        let name = plan::name(load);
        format!(
            "{name} towards {} deg",
            digits(load.towards.to_degrees(), 4)
        )
    });
    for (i, name) in names.chain(flows).enumerate() {
        lines.push((format!("{} {name}", marker(count + i)), plain));
    }
    lines
}

/// Lines on an equilibrium: heading and stability, and of the chosen one mooring and dynamics.
fn equilibrium_lines(
    theme: Theme,
    i: usize,
    equilibrium: &MooredEquilibrium,
    chosen: bool,
) -> Vec<(String, Style)> {
    let yaw = &equilibrium.yaw;
    let style = match (yaw.stability, equilibrium.dynamic_stability()) {
        (YawStability::Stable, None | Some(DynamicStability::Stable { .. })) => theme.good(),
        (
            YawStability::Stable,
            Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. }),
        ) => theme.error(),
        _ => theme.plain(),
    };
    let head = if chosen { ">" } else { " " };
    let mut lines = vec![(
        format!(
            "{head}{} {} {} deg {}",
            i + 1,
            marker(i),
            digits(yaw.heading.to_degrees(), 5),
            plan::stability(equilibrium)
        ),
        style,
    )];
    if !chosen {
        return lines;
    }
    let mut say = |words: String| lines.push((format!("    {words}"), theme.plain()));
    say(format!("statically {}", yaw.stability.label()));
    say(format!("pull {}", si(yaw.pull, "N")));
    match &equilibrium.line {
        Some(Ok(line)) => {
            say(format!("bow {} from anchor", si(line.distance, "m")));
            if line.anchor_uplift > 0.0 {
                say(format!("ANCHOR UPLIFT {}", si(line.anchor_uplift, "N")));
            }
        }
        Some(Err(_)) => say("no mooring solution".to_owned()),
        None => say("no mooring line given".to_owned()),
    }
    match equilibrium.dynamic_stability().map(DynamicStability::times) {
        Some((period, time)) => {
            let seconds = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| si(v, "s"));
            let grows = matches!(
                equilibrium.dynamic_stability(),
                Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. })
            );
            let name = if grows { "doubling time" } else { "half-life" };
            say(format!("period {}", seconds(period)));
            say(format!("{name} {}", seconds(time)));
        }
        None => say("dynamic stability: give [hull]".to_owned()),
    }
    lines
}
