//! A ship from above, with every heading at which it rests beside it.

use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Style;

use super::Painter;
use super::paint::{row, text};
use crate::report::chart::marker;
use crate::report::number::{digits, si};
use crate::report::ship::plan;
use crate::ship::Equilibrium;
use crate::ship::stability::DynamicStability;
use crate::ship::yaw_equilibria::YawStability;
use crate::tui::plot_pane::draw_chart;
use crate::tui::state::ShipView;

/// Columns of the list of headings.
const LIST: u16 = 34;

impl Painter<'_> {
    pub(super) fn ship_from_above(&mut self, area: Rect, ship: &ShipView) {
        let [drawing, list] =
            Layout::horizontal([Constraint::Min(0), Constraint::Length(LIST)]).areas(area);
        let mut chart = plan::chart(&ship.rest, ship.equilibrium);
        // The list beside it names the ships; every line counts here.
        chart.title.clear();
        chart.legend = false;
        draw_chart(
            &chart,
            drawing,
            self.buf,
            self.state.capabilities.glyphs,
            self.theme,
        );
        let mut lines: Vec<(String, Style)> = Vec::new();
        let plain = self.theme.plain();
        match &ship.rest.equilibria {
            Ok(equilibria) => {
                for (i, equilibrium) in equilibria.iter().enumerate() {
                    lines.extend(self.equilibrium(i, equilibrium, i == ship.equilibrium));
                }
            }
            Err(why) => {
                let words =
                    super::paint::wrap(&format!("No heading in balance: {why}."), LIST.into());
                lines.extend(words.into_iter().map(|line| (line, self.theme.error())));
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
        for (i, (line, style)) in lines.iter().enumerate() {
            let at = u16::try_from(i).unwrap_or(u16::MAX);
            if at < list.height {
                let place = row(list, at);
                text(self.buf, (place.x, place.y), place.width, line, *style);
            }
        }
    }

    /// What is said of a heading: itself and how it stands, and of the one chosen, what holds the ship there.
    fn equilibrium(
        &self,
        i: usize,
        equilibrium: &Equilibrium,
        chosen: bool,
    ) -> Vec<(String, Style)> {
        let balance = &equilibrium.yaw;
        let style = match (balance.stability, equilibrium.dynamic_stability()) {
            (YawStability::Stable, None | Some(DynamicStability::Stable { .. })) => {
                self.theme.good()
            }
            (
                YawStability::Stable,
                Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. }),
            ) => self.theme.error(),
            _ => self.theme.plain(),
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
        let mut say = |words: String| lines.push((format!("    {words}"), self.theme.plain()));
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
                let seconds =
                    |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |v| si(v, "s"));
                let grows = matches!(
                    equilibrium.dynamic_stability(),
                    Some(
                        DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. }
                    )
                );
                let verb = if grows { "doubles" } else { "halves" };
                say(format!("swings in {}", seconds(period)));
                say(format!("{verb} in {}", seconds(time)));
            }
            None => say("small motions: give [hull]".to_owned()),
        }
        lines
    }
}
