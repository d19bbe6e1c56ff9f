//! Materials: their stiffness given once, by a number or by a table that rises from 0, and bores inside their diameter.

use std::f64::consts::FRAC_PI_4;

use super::creep;
use crate::case::diagnostic::Finding;
use crate::case::fields::number;
use crate::case::model::{BoreKeys, CaseKeys, DynamicStiffness, MaterialKeys, StiffnessScope};
use crate::case::schema::{Key, KeyValue};

/// Checks of every material's elasticity and axial damping.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    case.materials
        .iter()
        .flat_map(|(_, material)| of_material(material))
        .collect()
}

/// Checks of one material.
pub fn of_material(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let mut found = table(material);
    found.extend(given_once(
        &material.ea_n,
        &material.strain,
        "the stiffness is given twice, by ea_n and by a table of strain and tension_n",
    ));
    found.extend(given_once(
        &material.axial_damping_n_s,
        &material.axial_damping_ratio,
        "the axial damping is given twice, by axial_damping_n_s and by axial_damping_ratio",
    ));
    found.extend(dynamic(material));
    found.extend(creep::of_material(material));
    found.extend(material.bore.as_ref().and_then(|b| bore(material, b)));
    found
}

/// A bore is narrower than its pipe, and its content weighs no more than pipe and content together.
fn bore(material: &MaterialKeys<'_>, bore: &BoreKeys<'_>) -> Option<Finding> {
    let (inner, outer) = (bore.diameter_m.value()?, material.diameter_m.value()?);
    if inner >= outer {
        let problem = format!("is no bore of a pipe {} m wide", number(outer));
        return Some(
            bore.diameter_m
                .finding(problem, "give less than diameter_m"),
        );
    }
    let content = bore.content_density_kg_per_m3.value()? * FRAC_PI_4 * inner * inner;
    let mass = material.mass_kg_per_m.value()?;
    (content >= mass).then(|| {
        let problem = format!(
            "the content alone weighs {} kg/m, and mass_kg_per_m, of which it is part, is {}",
            number((1e3 * content).round() / 1e3),
            number(mass)
        );
        let remedy = "give the mass of pipe and content as mass_kg_per_m";
        bore.content_density_kg_per_m3.finding(problem, remedy)
    })
}

/// Two keys that say the same thing: a finding at the later one.
fn given_once<A: KeyValue, B: KeyValue>(
    one: &Key<'_, A>,
    other: &Key<'_, B>,
    problem: &str,
) -> Option<Finding> {
    let remedy = "keep one of the two";
    let one_is_later = one.start()? > other.start()?;
    Some(if one_is_later {
        one.finding_at_name(problem, remedy)
    } else {
        other.finding_at_name(problem, remedy)
    })
}

/// Dynamic stiffness comes with alpha and a breaking load, on a rope that does not bend; its numbers come with it.
fn dynamic(material: &MaterialKeys<'_>) -> Vec<Finding> {
    if !material.dynamic_stiffness.is_given() {
        let numbers = [
            &material.dynamic_alpha,
            &material.dynamic_beta,
            &material.dynamic_gamma,
            &material.mean_window_s,
        ];
        // A number that is the default says no more than no number.
        let idle = numbers
            .into_iter()
            .filter(|key| key.is_given() && !key.is(&0.0));
        let problem = "has no effect: dynamic_stiffness is not given";
        let remedy = "add `dynamic_stiffness = \"secant\"` or \"about-the-mean\", or remove it";
        let scope = &material.stiffness_scope;
        let scope = scope
            .is(&StiffnessScope::Rope)
            .then(|| scope.finding_at_name(problem, remedy));
        return idle
            .map(|key| key.finding_at_name(problem, remedy))
            .chain(scope)
            .collect();
    }
    let of_motion = [DynamicStiffness::Secant, DynamicStiffness::AboutTheMean];
    if !of_motion
        .iter()
        .any(|reading| material.dynamic_stiffness.is(reading))
    {
        return Vec::new();
    }
    let alpha = "add `dynamic_alpha = ...`: alpha of the stiffness it stands for";
    let load = "add `break_load_n = ...`: the breaking load that the stiffness refers to";
    let bends = material.ei_n_m2.get().is_some_and(|ei| *ei > 0.0);
    let bending = bends.then(|| {
        let remedy = "set it to 0, or dynamic_stiffness to \"none\"";
        material
            .ei_n_m2
            .finding("a rope with dynamic stiffness does not bend", remedy)
    });
    let missing = [
        material.dynamic_alpha.if_missing(alpha),
        material.break_load_n.if_missing(load),
    ];
    missing.into_iter().chain([bending]).flatten().collect()
}

/// Both lists, equally long, at least two points, rising from 0.
fn table(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let (strain, tension) = (&material.strain, &material.tension_n);
    match (strain.is_given(), tension.is_given()) {
        (false, false) => return Vec::new(),
        (true, false) => return vec![half(strain, tension)],
        (false, true) => return vec![half(tension, strain)],
        (true, true) => {}
    }
    let mut found: Vec<Finding> = [strain, tension].into_iter().filter_map(rising).collect();
    if let (true, Some(strains), Some(tensions)) = (found.is_empty(), strain.get(), tension.get())
        && strains.len() != tensions.len()
    {
        let problem = format!(
            "has {} values for {} strains",
            tensions.len(),
            strains.len()
        );
        found.push(tension.finding(problem, "give one tension for each strain"));
    }
    found
}

fn half(given: &Key<'_, Vec<f64>>, missing: &Key<'_, Vec<f64>>) -> Finding {
    let (given_name, missing) = (given.name(), missing.name());
    given.finding_at_name(
        format!("is half a table: {missing} is missing"),
        format!("add `{missing} = [0.0, ...]`, as long as {given_name}, or remove {given_name}"),
    )
}

/// A list that begins at 0 and rises.
fn rising(key: &Key<'_, Vec<f64>>) -> Option<Finding> {
    let values = key.get()?;
    let first = values.first().copied()?;
    if first != 0.0 {
        let remedy = "begin at 0: a rope that is not stretched has no tension";
        return Some(key.finding_at_item(0, format!("begins at {}", number(first)), remedy));
    }
    if values.len() < 2 {
        let remedy = "give at least two values, the first of them 0";
        return Some(key.finding("is a table of one point", remedy));
    }
    let back = values.windows(2).position(|pair| pair[1] <= pair[0])?;
    let problem = format!(
        "does not rise: {} comes after {}",
        number(values[back + 1]),
        number(values[back])
    );
    Some(key.finding_at_item(
        back + 1,
        problem,
        "give values that grow from one to the next",
    ))
}
