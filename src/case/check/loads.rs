//! What acts on the line: the current's table over depth, the payload's weight and drag, damping
//! given once, output that fits into memory.

use crate::case::diagnostic::Finding;
use crate::case::fields::{number, quantity};
use crate::case::tree::Node;

/// More output instants than this would fill memory and disk before they help anyone.
const MOST_INSTANTS: f64 = 1e6;

/// Checks of current, payload, damping and output.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let mut found = current(root);
    found.extend(payload(root));
    found.extend(damping(root));
    found.extend(output(root));
    found
}

/// Lists of the current go with a list of depths, as long, increasing.
fn current(root: &Node) -> Vec<Finding> {
    let Some(current) = root.get("current") else {
        return Vec::new();
    };
    let lists = ["speed_m_per_s", "direction_deg"]
        .into_iter()
        .filter_map(|key| {
            let list = current.get(key)?;
            list.numbers().map(|values| (key, list, values.len()))
        });
    let lists: Vec<_> = lists.collect();
    let Some((depth, values)) = current
        .get("depth_m")
        .and_then(|node| Some((node, node.numbers()?)))
    else {
        return lists
            .into_iter()
            .filter(|_| current.get("depth_m").is_none())
            .map(|(key, list, count)| {
                let remedy = format!("add `depth_m = [...]` with {count} depths in m, increasing");
                Finding::new(
                    &list.span,
                    format!("current.{key}"),
                    "is a list, and the depths it belongs to are missing",
                    remedy,
                )
            })
            .collect();
    };
    let mut found = Vec::new();
    for (key, list, count) in &lists {
        if *count != values.len() {
            let problem = format!("has {count} values for {} depths", values.len());
            found.push(Finding::new(
                &list.span,
                format!("current.{key}"),
                problem,
                "give one value for each depth of depth_m",
            ));
        }
    }
    if lists.is_empty()
        && current
            .get("speed_m_per_s")
            .and_then(Node::number)
            .is_some()
    {
        let remedy = "give a list of speeds, one for each depth, or remove depth_m";
        found.push(Finding::new(
            &depth.span,
            "current.depth_m",
            "has no effect: speed and direction are the same at every depth",
            remedy,
        ));
    }
    let step_back = values.windows(2).position(|pair| pair[1] <= pair[0]);
    found.extend(step_back.and_then(|at| {
        let span = &depth.items().get(at + 1)?.span;
        let problem = format!(
            "the depths must increase: {} follows {}",
            quantity(values[at + 1], "m"),
            quantity(values[at], "m")
        );
        Some(Finding::new(
            span,
            "current.depth_m",
            problem,
            "list the depths from the surface down, each once",
        ))
    }));
    found
}

/// Weight in water is told once, and what the payload's keys leave out follows from its shape.
fn payload(root: &Node) -> Vec<Finding> {
    let Some(payload) = root.get("payload") else {
        return Vec::new();
    };
    let wet = payload.get("wet_mass_kg");
    let volume = payload.get("volume_m3");
    let mut found = Vec::new();
    if let (Some(_), Some(volume)) = (wet, volume) {
        found.push(Finding::new(
            &volume.span,
            "payload.volume_m3",
            "the weight in water is given twice, by wet_mass_kg and by volume_m3",
            "keep one of the two",
        ));
    }
    let dry = payload.get("dry_mass_kg").and_then(Node::number);
    let heavier = wet.zip(dry).and_then(|(node, dry)| {
        let wet = node.number().filter(|wet| *wet > dry)?;
        let problem = format!(
            "a mass in water of {} kg is more than the {} kg in air",
            number(wet),
            number(dry)
        );
        let remedy = "give dry_mass_kg less the mass of the displaced water";
        Some(Finding::new(
            &node.span,
            "payload.wet_mass_kg",
            problem,
            remedy,
        ))
    });
    found.extend(heavier);
    if payload.get("shape").is_some() {
        return found;
    }
    if wet.is_none() && volume.is_none() {
        found.push(missing(
            payload,
            "wet_mass_kg",
            "the weight in water is not known",
            "wet_mass_kg in kg, volume_m3 in m³",
        ));
    }
    if payload.get("drag_area_m2").is_none() {
        found.push(missing(
            payload,
            "drag_area_m2",
            "the drag is not known",
            "drag_area_m2 in m² (drag coefficient times area)",
        ));
    }
    if payload.get("added_mass_kg").is_none() {
        found.push(missing(
            payload,
            "added_mass_kg",
            "the added mass is not known",
            "added_mass_kg in kg",
        ));
    }
    found
}

fn missing(payload: &Node, key: &str, problem: &str, wanted: &str) -> Finding {
    let remedy = format!("give {wanted}, or a [payload.shape] it follows from");
    Finding::new(&payload.span, format!("payload.{key}"), problem, remedy)
}

fn damping(root: &Node) -> Vec<Finding> {
    let materials = root.get("materials").map_or(&[] as &[_], Node::entries);
    let twice = materials.iter().filter_map(|material| {
        let coefficient = material.node.entry("axial_damping_n_s")?;
        let ratio = material.node.entry("axial_damping_ratio")?;
        let second = if ratio.key_span.start > coefficient.key_span.start {
            ratio
        } else {
            coefficient
        };
        let key = format!("materials.{}.{}", material.key, second.key);
        let problem =
            "the axial damping is given twice, by axial_damping_n_s and by axial_damping_ratio";
        Some(Finding::new(
            &second.key_span,
            key,
            problem,
            "keep one of the two",
        ))
    });
    twice.collect()
}

fn output(root: &Node) -> Option<Finding> {
    let duration = root
        .find(&["solver", "duration_s"])
        .map_or(Some(600.0), Node::number)?;
    let node = root.find(&["output", "interval_s"])?;
    let interval = node.number().filter(|interval| *interval > 0.0)?;
    let instants = duration / interval;
    (instants > MOST_INSTANTS).then(|| {
        let problem = format!(
            "would write {instants:.1e} output instants in {}",
            quantity(duration, "s")
        );
        let remedy = format!("give at least {}", quantity(duration / MOST_INSTANTS, "s"));
        Finding::new(&node.span, "output.interval_s", problem, remedy)
    })
}
