//! How materials stretch: by one stiffness or by a table, whose strains and tensions rise from nought.

use crate::case::diagnostic::Finding;
use crate::case::fields::number;
use crate::case::tree::{Data, Entry, Node};

/// Keys that mean nothing without `dynamic_stiffness`.
const OF_DYNAMIC: [&str; 4] = [
    "dynamic_alpha",
    "dynamic_beta",
    "dynamic_gamma",
    "mean_window_s",
];

/// Checks of every material's elasticity.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let materials = root.get("materials").map_or(&[] as &[_], Node::entries);
    let mut found = Vec::new();
    for entry in materials {
        let name = format!("materials.{}", entry.key);
        found.extend(given_once(&entry.node, &name));
        found.extend(table(&entry.node, &name));
        found.extend(dynamic(&entry.node, &name));
    }
    found
}

/// Stiffness and table say the same thing.
fn given_once(material: &Node, name: &str) -> Option<Finding> {
    let stiffness = material.entry("ea_n")?;
    let table = material.entry("strain")?;
    let (second, key) = if table.key_span.start > stiffness.key_span.start {
        (table, "strain")
    } else {
        (stiffness, "ea_n")
    };
    Some(Finding::new(
        &second.key_span,
        format!("{name}.{key}"),
        "the stiffness is given twice, by ea_n and by a table of strain and tension_n",
        "keep one of the two",
    ))
}

/// Dynamic stiffness comes with alpha and a breaking load, on a rope that does not bend; its numbers come with it.
fn dynamic(material: &Node, name: &str) -> Vec<Finding> {
    let Some(reading) = material.entry("dynamic_stiffness") else {
        // A number that is the default says no more than no number.
        let said = |entry: &&Entry| entry.node.number().is_none_or(|value| value != 0.0);
        let lost = OF_DYNAMIC.iter().filter_map(|key| material.entry(key));
        let lost = lost.filter(said);
        let lost = lost.map(|entry| {
            Finding::new(
                &entry.key_span,
                format!("{name}.{}", entry.key),
                "has no effect: dynamic_stiffness is not given",
                "add `dynamic_stiffness = \"secant\"` or \"about-the-mean\", or remove it",
            )
        });
        return lost.collect();
    };
    if !matches!(reading.node.text(), Some("secant" | "about-the-mean")) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (key, what) in [
        ("dynamic_alpha", "alpha of the stiffness it stands for"),
        (
            "break_load_n",
            "the breaking load that the stiffness refers to",
        ),
    ] {
        if material.get(key).is_none() {
            let remedy = format!("add `{key} = ...`: {what}");
            found.push(Finding::new(
                &material.span,
                format!("{name}.{key}"),
                "is missing",
                remedy,
            ));
        }
    }
    if let Some(bending) = material
        .get("ei_n_m2")
        .filter(|node| node.number().is_some_and(|ei| ei > 0.0))
    {
        found.push(Finding::new(
            &bending.span,
            format!("{name}.ei_n_m2"),
            "a rope with dynamic stiffness does not bend",
            "set it to 0, or dynamic_stiffness to \"none\"",
        ));
    }
    found
}

/// Both lists, equally long, at least two points, rising from nought.
fn table(material: &Node, name: &str) -> Vec<Finding> {
    let (strain, tension) = (material.entry("strain"), material.entry("tension_n"));
    let (strain, tension) = match (strain, tension) {
        (None, None) => return Vec::new(),
        (Some(alone), None) => return vec![half(&alone.key_span, name, "strain", "tension_n")],
        (None, Some(alone)) => return vec![half(&alone.key_span, name, "tension_n", "strain")],
        (Some(strain), Some(tension)) => (&strain.node, &tension.node),
    };
    let mut found = Vec::new();
    for (node, key) in [(strain, "strain"), (tension, "tension_n")] {
        found.extend(rising(node, &format!("{name}.{key}")));
    }
    let count = |node: &Node| matches!(node.data, Data::List(_)).then(|| node.items().len());
    if found.is_empty()
        && let (Some(strains), Some(tensions)) = (count(strain), count(tension))
        && strains != tensions
    {
        found.push(Finding::new(
            &tension.span,
            format!("{name}.tension_n"),
            format!("has {tensions} values for {strains} strains"),
            "give one tension for each strain",
        ));
    }
    found
}

fn half(span: &std::ops::Range<usize>, name: &str, given: &str, missing: &str) -> Finding {
    Finding::new(
        span,
        format!("{name}.{given}"),
        format!("is half a table: {missing} is missing"),
        format!("add `{missing} = [0.0, ...]`, as long as {given}, or remove {given}"),
    )
}

/// A list that begins at nought and rises.
fn rising(node: &Node, key: &str) -> Option<Finding> {
    let values = node.numbers()?;
    let items = node.items();
    let first = values.first()?;
    if *first != 0.0 {
        return Some(Finding::new(
            &items[0].span,
            key,
            format!("begins at {}", number(*first)),
            "begin at 0: a rope that is not stretched has no tension",
        ));
    }
    if values.len() < 2 {
        let remedy = "give at least two values, the first of them 0";
        return Some(Finding::new(
            &node.span,
            key,
            "is a table of one point",
            remedy,
        ));
    }
    let back = values.windows(2).position(|pair| pair[1] <= pair[0])?;
    Some(Finding::new(
        &items[back + 1].span,
        key,
        format!(
            "does not rise: {} comes after {}",
            number(values[back + 1]),
            number(values[back])
        ),
        "give values that grow from one to the next",
    ))
}
