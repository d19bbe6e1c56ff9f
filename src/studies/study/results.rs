//! The results of a case by name: which a run will have, and which matter most.

use crate::case::fields::nearest;
use crate::case::{
    self, Case, EndKind, EnergyQuantity, LineQuantity, Method, QuantityId, Statistic, Subject,
};
use crate::run::published_curve::{difference_id, held};
use crate::run::requested_statistics::{StatisticSource, requested};

/// Published values among the main results, at most.
const MOST_PUBLISHED: usize = 3;

/// A name that no result of the case has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` is no result of this case; {remedy}")]
pub struct UnknownResult {
    /// The name.
    pub name: String,
    /// What would be right.
    pub remedy: String,
}

/// The results that matter most: what the case has published values of, three at most; the greatest tension; the final height of a loose
/// end; the smallest bending radius of a line with bending stiffness.
#[must_use]
pub fn main_results(case: &Case) -> Vec<QuantityId> {
    let known = result_ids(case);
    let mut list: Vec<QuantityId> = Vec::new();
    let own = case
        .published
        .iter()
        .filter(|published| published.at.is_none());
    for published in own {
        let (of, statistic) = (published.channel.clone(), published.statistic);
        let id = QuantityId::new(of, statistic, published.within()).numbered(published.nth);
        if !list.contains(&id) && list.len() < MOST_PUBLISHED {
            list.push(id);
        }
    }
    let line = |quantity, statistic| QuantityId::new(Subject::Line(quantity), statistic, None);
    let mut more = vec![line(LineQuantity::Tension, Statistic::Max)];
    let loose = [&case.ends.a, &case.ends.b];
    let loose = loose
        .into_iter()
        .filter(|end| matches!(end.kind, EndKind::Payload | EndKind::Free));
    more.extend(loose.filter_map(|end| format!("z_m[{}].final", end.name).parse().ok()));
    if case
        .materials
        .values()
        .any(|material| material.ei_n_m2 > 0.0)
    {
        more.push(line(LineQuantity::BendRadius, Statistic::Min));
    }
    list.extend(more);
    let mut distinct: Vec<QuantityId> = Vec::new();
    for id in list {
        if known.contains(&id) && !distinct.contains(&id) {
            distinct.push(id);
        }
    }
    distinct
}

/// The result of a name.
///
/// # Errors
/// No result of the case has it.
pub fn named_result(case: &Case, name: &str) -> Result<QuantityId, UnknownResult> {
    let known = result_ids(case);
    let name = name.trim();
    if let Some(id) = name
        .parse::<QuantityId>()
        .ok()
        .filter(|id| known.contains(id))
    {
        return Ok(id);
    }
    let names: Vec<String> = known.iter().map(ToString::to_string).collect();
    let names = || names.iter().map(String::as_str);
    let below: Vec<&str> = names()
        .filter(|known| known.starts_with(&format!("{name}.")))
        .collect();
    let remedy = match (below.is_empty(), nearest(name, names())) {
        (false, _) => format!("it has {}", below.join(", ")),
        (true, Some(near)) => format!("did you mean `{near}`?"),
        (true, None) => {
            let main: Vec<String> = main_results(case).iter().map(ToString::to_string).collect();
            format!(
                "name one as in the summary of a run, such as {}",
                main.join(", ")
            )
        }
    };
    Err(UnknownResult {
        name: name.to_owned(),
        remedy,
    })
}

/// Every result that a run of the case may have.
#[must_use]
pub fn result_ids(case: &Case) -> Vec<QuantityId> {
    let channels = case::channels(case);
    let statistics = requested(case, &channels).into_iter().map(|asked| {
        let of = match asked.of {
            StatisticSource::Channel(index) => Subject::Channel(channels[index].id.clone()),
            StatisticSource::Line(_, quantity) => Subject::Line(quantity),
        };
        QuantityId::new(of, asked.statistic, asked.window).numbered(asked.nth)
    });
    let mut ids: Vec<QuantityId> = statistics.collect();
    let modes = case.modes.as_ref();
    let modes = modes.map_or_else(Vec::new, |m| {
        Subject::of_modes(m.count, m.near_hz.is_some())
    });
    ids.extend(modes.into_iter().map(QuantityId::single));
    if matches!(
        case.solver.method,
        Method::Alpha | Method::Rk4 | Method::Auto
    ) {
        let energy =
            EnergyQuantity::ALL.map(|quantity| QuantityId::single(Subject::Energy(quantity)));
        ids.extend(energy);
    }
    if case.output.response_from_s.is_some() {
        ids.push(QuantityId::single(Subject::SteadyTime));
    }
    for (number, curve) in case.published_curve.iter().enumerate() {
        let measures = held(curve).into_iter();
        ids.extend(measures.map(|(measure, _)| difference_id(curve, measure, number)));
    }
    ids
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::shipped::SHIPPED;

    fn manifold() -> Case {
        let found = SHIPPED
            .iter()
            .find(|(path, _)| path.ends_with("pendulous/manifold.toml"));
        case::parse(found.unwrap().1, "manifold.toml").unwrap()
    }

    #[test]
    fn published_values_come_first() {
        let names: Vec<String> = main_results(&manifold())
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(
            names,
            [
                "tension_n[wire|payload].mean(0..200)",
                "tension_n[wire|payload].mean(600..1200)",
                "tension_n.max",
                "z_m[payload].final"
            ]
        );
    }

    #[test]
    fn names_that_are_near_are_proposed() {
        let case = manifold();
        assert!(named_result(&case, "tension_n[wire|payload].max").is_ok());
        let remedy = |name: &str| named_result(&case, name).unwrap_err().remedy;
        assert!(
            remedy("tension_n[wire|payload].mx")
                .contains("did you mean `tension_n[wire|payload].max`")
        );
        assert!(remedy("tension_n[wire|payload]").contains(".max, tension_n[wire|payload].min"));
        assert!(remedy("colour").contains("such as tension_n"));
    }
}
