//! A chart as a picture of lines and words (SVG) for pages that are printed: what [`draw`](super::draw()) shows in characters.
//!
//! The picture stands alone: no script, no style sheet, no font of its own, words as words, nothing that is not a vector. No meaning
//! is in a colour alone: curves have dashes and markers of their own, a map is darker where it is greater.

mod axes;
mod curves;
mod ink;
mod legend;
mod limits;
mod map;
mod page;
mod plan;

use super::Chart;
use crate::markup::escaped;
use page::SvgPage;
pub use page::WIDTH;
use plan::SvgPlan;

/// Units up for each line that the chart has in characters.
const LINE: f64 = 17.0;

/// The chart as an SVG element, about as tall as it is with so many lines of characters.
#[must_use]
pub fn svg(chart: &Chart, lines: usize) -> String {
    let plan = SvgPlan::of_chart(chart, LINE * lines as f64);
    let mut page = SvgPage::default();
    plan.draw_head(&mut page);
    if let Some(map) = &chart.map {
        map::draw(map, &plan, &mut page);
    } else {
        axes::grid(&plan, &mut page);
    }
    limits::areas(chart, &plan, &mut page);
    let lines = curves::draw(chart, &plan, &mut page);
    axes::draw(chart, &plan, &mut page);
    limits::names(chart, &plan, &lines, &mut page);
    legend::draw(chart, &plan, &mut page);
    let (title, body) = (escaped(&chart.title), page.finish());
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{title}\" \
         font-family=\"sans-serif\" font-size=\"{}\" fill=\"{}\">\n{body}</svg>\n",
        page::px(WIDTH),
        page::px(plan.height),
        page::px(ink::TEXT),
        ink::BLACK,
    )
}

#[cfg(test)]
mod tests;
