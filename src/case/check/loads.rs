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
    found.extend(friction(root));
    found.extend(level(root));
    found.extend(output(root));
    found
}

/// Keys of the bed's friction that have no effect.
fn friction(root: &Node) -> Vec<Finding> {
    let Some(bed) = root.get("seabed") else {
        return Vec::new();
    };
    let idle = |key: &str, problem: &str, remedy: &str| {
        let node = bed.get(key)?;
        Some(Finding::new(
            &node.span,
            format!("seabed.{key}"),
            problem,
            remedy,
        ))
    };
    let keys = [
        "friction_lateral",
        "friction_law",
        "grip_stiffness_n_per_m3",
        "slip_speed_m_per_s",
    ];
    if bed.get("friction").is_none() {
        let problem = "has no effect: the bed has no friction";
        let remedy = "add `friction = ...`, its coefficient along the line, or remove this key";
        return keys
            .iter()
            .filter_map(|key| idle(key, problem, remedy))
            .collect();
    }
    let grip = bed.get("friction_law").and_then(Node::text) != Some("zhu-2017");
    let (others, law) = if grip {
        (&keys[3..], "grip")
    } else {
        (&keys[..], "zhu-2017")
    };
    others
        .iter()
        .filter(|key| grip || matches!(**key, "friction_lateral" | "grip_stiffness_n_per_m3"))
        .filter_map(|key| {
            idle(
                key,
                &format!("has no effect with the friction law `{law}`"),
                "remove it, or choose the other law",
            )
        })
        .collect()
}

/// Where a level bed is how deep, and which way it does not rise.
fn level(root: &Node) -> Vec<Finding> {
    let Some(bed) = root
        .get("seabed")
        .filter(|bed| bed.get("slope_deg").is_none())
    else {
        return Vec::new();
    };
    // Zero says no more than nothing.
    let said = |node: &&Node| {
        let list = node.numbers().or(node.number().map(|one| vec![one]));
        list.is_none_or(|list| list.iter().any(|value| *value != 0.0))
    };
    let keys = ["slope_azimuth_deg", "depth_at_m"].into_iter();
    keys.filter_map(|key| {
        Some(Finding::new(
            &bed.get(key).filter(said)?.span,
            format!("seabed.{key}"),
            "has no effect: the bed is level",
            "add `slope_deg = ...`, how steeply it rises, or remove this key",
        ))
    })
    .collect()
}

/// Lists of the current go with a list of depths, as long, increasing.
fn current(root: &Node) -> Vec<Finding> {
    let Some(current) = root.get("current") else {
        return Vec::new();
    };
    let lists = current_lists(current);
    let Some(depth) = current.get("depth_m") else {
        return lists.iter().map(without_depths).collect();
    };
    let Some(depths) = depth.numbers() else {
        return Vec::new();
    };
    let mut found: Vec<Finding> = lists
        .iter()
        .filter(|list| list.count != depths.len())
        .map(|list| {
            let problem = format!("has {} values for {} depths", list.count, depths.len());
            list.finding(problem, "give one value for each depth of depth_m")
        })
        .collect();
    let one_speed = current.get("speed_m_per_s").and_then(Node::number);
    if lists.is_empty() && one_speed.is_some() {
        found.push(Finding::new(
            &depth.span,
            "current.depth_m",
            "has no effect: speed and direction are the same at every depth",
            "give a list of speeds, one for each depth, or remove depth_m",
        ));
    }
    found.extend(depths_that_step_back(depth, &depths));
    found
}

/// A key of the current that holds a list.
struct CurrentList<'a> {
    key: &'static str,
    node: &'a Node,
    count: usize,
}

impl CurrentList<'_> {
    fn finding(&self, problem: impl Into<String>, remedy: impl Into<String>) -> Finding {
        let key = format!("current.{}", self.key);
        Finding::new(&self.node.span, key, problem, remedy)
    }
}

fn current_lists(current: &Node) -> Vec<CurrentList<'_>> {
    let keys = ["speed_m_per_s", "direction_deg"].into_iter();
    keys.filter_map(|key| {
        let node = current.get(key)?;
        let count = node.numbers()?.len();
        Some(CurrentList { key, node, count })
    })
    .collect()
}

fn without_depths(list: &CurrentList<'_>) -> Finding {
    let remedy = format!(
        "add `depth_m = [...]` with {} depths in m, increasing",
        list.count
    );
    list.finding(
        "is a list, and the depths it belongs to are missing",
        remedy,
    )
}

fn depths_that_step_back(node: &Node, depths: &[f64]) -> Option<Finding> {
    let at = depths.windows(2).position(|pair| pair[1] <= pair[0])?;
    let problem = format!(
        "the depths must increase: {} follows {}",
        quantity(depths[at + 1], "m"),
        quantity(depths[at], "m")
    );
    let remedy = "list the depths from the surface down, each once";
    let span = &node.items().get(at + 1)?.span;
    Some(Finding::new(span, "current.depth_m", problem, remedy))
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
    if payload.get("shape").is_none() {
        found.extend(left_open(payload));
    }
    found
}

/// What neither the keys of a payload without shape tell nor a shape could.
fn left_open(payload: &Node) -> Vec<Finding> {
    let weight = ["wet_mass_kg", "volume_m3"];
    let wanted: [(&[&str], &str, &str); 3] = [
        (
            &weight,
            "the weight in water is not known",
            "wet_mass_kg in kg, volume_m3 in m³",
        ),
        (
            &["drag_area_m2"],
            "the drag is not known",
            "drag_area_m2 in m² (drag coefficient times area)",
        ),
        (
            &["added_mass_kg"],
            "the added mass is not known",
            "added_mass_kg in kg",
        ),
    ];
    wanted
        .into_iter()
        .filter(|(keys, _, _)| keys.iter().all(|key| payload.get(key).is_none()))
        .map(|(keys, problem, remedy)| missing(payload, keys[0], problem, remedy))
        .collect()
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
