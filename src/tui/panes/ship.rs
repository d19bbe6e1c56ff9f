//! A ship from above, with every equilibrium heading beside it.

use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

use super::Pane;
use crate::report::chart::marker;
use crate::report::number::{digits, si};
use crate::report::ship::plan;
use crate::ship::Equilibrium;
use crate::ship::stability::DynamicStability;
use crate::ship::yaw_equilibria::YawStability;
use crate::tui::command::{self, Command, DOWN, Id};
use crate::tui::msg::Effect;
use crate::tui::state::{AppState, Content, ShipView};
use crate::tui::theme::Theme;
use crate::tui::update::motion::{moved, step};
use crate::tui::view::paint::wrap;
use crate::tui::view::painter::Painter;

/// Columns of the list of headings.
const LIST: u16 = 34;

pub(super) struct Ship;

impl Pane for Ship {
    fn title(&self) -> &'static str {
        "Ship"
    }

    fn go(&self) -> &'static str {
        "Go to the drawing"
    }

    fn commands(&self) -> &'static [&'static [Command]] {
        &[&[DOWN], command::LIST]
    }

    fn update(&self, state: &mut AppState, id: Id) -> Option<Vec<Effect>> {
        let by = step(state, id)?;
        if let Content::Ship(ship) = &mut state.document.as_mut()?.content {
            let count = ship.rest.equilibria.as_ref().map_or(0, Vec::len);
            ship.equilibrium = moved(ship.equilibrium, by, count);
        }
        Some(Vec::new())
    }

    fn view(&self, painter: &mut Painter, area: Rect) {
        let document = painter.state.document.as_ref();
        let Some(Content::Ship(ship)) = document.map(|document| &document.content) else {
            return;
        };
        let [drawing, list] =
            Layout::horizontal([Constraint::Min(0), Constraint::Length(LIST)]).areas(area);
        let mut chart = plan::chart(&ship.rest, ship.equilibrium);
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
    match &ship.rest.equilibria {
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
        Err(why) => {
            let words = wrap(&format!("No heading in balance: {why}."), LIST.into());
            lines.extend(words.into_iter().map(|line| (line, theme.error())));
        }
    }
    lines.push((String::new(), plain));
    let count = ship.rest.equilibria.as_ref().map_or(0, Vec::len);
    let names = ["anchor"].into_iter().map(str::to_owned);
    let flows = ship.rest.loads.each.iter().map(|load| {
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

/// What is said of a heading: itself and how it stands, and of the one chosen, what holds the ship there.
fn equilibrium_lines(
    theme: Theme,
    i: usize,
    equilibrium: &Equilibrium,
    chosen: bool,
) -> Vec<(String, Style)> {
    let balance = &equilibrium.yaw;
    let style = match (balance.stability, equilibrium.dynamic_stability()) {
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
            digits(balance.heading.to_degrees(), 5),
            plan::word(equilibrium)
        ),
        style,
    )];
    if !chosen {
        return lines;
    }
    let mut say = |words: String| lines.push((format!("    {words}"), theme.plain()));
    say(format!("at rest {}", balance.stability.label()));
    say(format!("pull {}", si(balance.pull, "N")));
    match &equilibrium.reach {
        Some(Ok(reach)) => {
            say(format!("bow {} from anchor", si(reach.distance, "m")));
            if reach.anchor_uplift > 0.0 {
                say(format!("LIFTS ANCHOR by {}", si(reach.anchor_uplift, "N")));
            }
        }
        Some(Err(_)) => say("the line does not reach".to_owned()),
        None => say("no mooring line given".to_owned()),
    }
    match equilibrium.dynamic_stability().map(DynamicStability::times) {
        Some((period, time)) => {
            let seconds = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| si(v, "s"));
            let grows = matches!(
                equilibrium.dynamic_stability(),
                Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. })
            );
            let verb = if grows { "doubles" } else { "halves" };
            say(format!("swings in {}", seconds(period)));
            say(format!("{verb} in {}", seconds(time)));
        }
        None => say("small motions: give [hull]".to_owned()),
    }
    lines
}
