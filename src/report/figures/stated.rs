//! What a case states, drawn on the figures of its runs: breaking loads, least bending radii, the sea bed, published values.

use super::{FigureData, FigureId};
use seacable_base::number::si;
use seacable_display::chart::{Chart, LimitLine, ReferenceLine};
use seacable_model::case::{
    Case, ChannelQuantity, Material, Published, Seabed, Statistic, Subject,
};
use seacable_model::published::{Outcome, tolerance};

/// Adds the limits of a case to a figure, and the published values of the places that are shown.
pub(super) fn add(chart: &mut Chart, id: FigureId, data: &FigureData, shown: &[String]) {
    let Some(case) = data.case.filter(|_| data.limits && !chart.is_empty()) else {
        return;
    };
    let limits = match id {
        FigureId::Tensions => {
            let mut all = breaking_loads(case);
            all.extend(published(case, data, &[ChannelQuantity::Tension], shown));
            all
        }
        FigureId::Profile => breaking_loads(case),
        FigureId::Curvature => least_radii(case),
        FigureId::Shape | FigureId::Front | FigureId::Path => bed(case),
        FigureId::Payload => {
            let mut all = bed(case);
            all.extend(published(
                case,
                data,
                &[ChannelQuantity::X, ChannelQuantity::Z],
                shown,
            ));
            all
        }
        FigureId::Speed => published(case, data, &[ChannelQuantity::Speed], shown),
        FigureId::Tilt => published(case, data, &[ChannelQuantity::Tilt], shown),
        FigureId::WallTension => published(case, data, &[ChannelQuantity::WallTension], shown),
        FigureId::BedForce => published(case, data, &[ChannelQuantity::BedForce], shown),
        _ => Vec::new(),
    };
    chart.limits.extend(limits);
}

/// The materials of the line, each once.
fn materials(case: &Case) -> Vec<(&str, &Material)> {
    let mut all: Vec<(&str, &Material)> = Vec::new();
    for section in &case.line {
        let found = case.materials.get_key_value(&section.material);
        let fresh = found.filter(|(name, _)| all.iter().all(|(known, _)| known != name));
        all.extend(fresh.map(|(name, material)| (name.as_str(), material)));
    }
    all
}

fn breaking_loads(case: &Case) -> Vec<ReferenceLine> {
    let limit = |(name, material): (&str, &Material)| {
        let load = material.break_load_n?;
        let label = format!("{name} breaks at {}", si(load, "N"));
        Some(ReferenceLine::new(label, LimitLine::Bound(load)))
    };
    materials(case).into_iter().filter_map(limit).collect()
}

fn least_radii(case: &Case) -> Vec<ReferenceLine> {
    let limit = |(name, material): (&str, &Material)| {
        let radius = material.min_bend_radius_m?;
        let label = format!("least radius of {name}, {}", si(radius, "m"));
        Some(ReferenceLine::new(label, LimitLine::Bound(1.0 / radius)))
    };
    materials(case).into_iter().filter_map(limit).collect()
}

/// A level bed; a slope has no one height.
fn bed(case: &Case) -> Vec<ReferenceLine> {
    let is_level = |bed: &&Seabed| bed.slope_deg.abs() <= 0.0 && bed.depth_file.is_none();
    let level = case.seabed.iter().filter(is_level);
    level
        .map(|bed| ReferenceLine::new("sea bed", LimitLine::Bound(-bed.depth_m)))
        .collect()
}

/// The published values of channels of these quantities at the places shown: bands of value and tolerance over their windows,
/// and the times of extremes. Those of other variants, and those that an edit has made those of another case, are left out.
fn published(
    case: &Case,
    data: &FigureData,
    quantities: &[ChannelQuantity],
    shown: &[String],
) -> Vec<ReferenceLine> {
    let mut limits = Vec::new();
    for (i, value) in case.published.iter().enumerate() {
        let Subject::Channel(channel) = &value.channel else {
            continue;
        };
        let row = data.checks.get(i);
        let foreign = row.is_some_and(|row| row.outcome == Outcome::Edited);
        let letter = channel.quantity.label();
        let seen = shown
            .iter()
            .any(|name| *name == channel.place || name == letter);
        if quantities.contains(&channel.quantity) && seen && of_case(value) && !foreign {
            limits.extend(limit(value, case.solver.duration_s));
        }
    }
    limits
}

/// Whether a value is of the case itself, and neither of a variant nor a change or a ratio.
fn of_case(value: &Published) -> bool {
    value.at.is_none() && value.change_from.is_none() && value.ratio_to.is_none()
}

fn limit(value: &Published, duration: f64) -> Option<ReferenceLine> {
    let label = format!("published: {}", value.name);
    let [from, to] = value.window_s.unwrap_or([0.0, duration]);
    let tolerance = tolerance(value.value, value.tolerance_rel, value.tolerance_abs);
    let band = |from: f64| LimitLine::Band {
        x: (from, to),
        y: (value.value - tolerance, value.value + tolerance),
    };
    let line = match value.statistic {
        Statistic::Mean
        | Statistic::Max
        | Statistic::Min
        | Statistic::MeanPeak
        | Statistic::MeanTrough => band(from),
        Statistic::Final => band(to),
        Statistic::TimeOfMax | Statistic::TimeOfMin | Statistic::SettlingTime => {
            LimitLine::Vertical(value.value)
        }
        _ => return None,
    };
    Some(ReferenceLine::new(label, line))
}
