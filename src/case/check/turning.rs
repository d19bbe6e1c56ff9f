//! A payload that turns: symmetric about its axis, never cut off, and spinning only with what that takes.

use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::tree::Node;

/// Checks of a payload with a rotation.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let Some(payload) = root.get("payload") else {
        return Vec::new();
    };
    let Some(rotation) = payload.get("rotation") else {
        return Vec::new();
    };
    let mut found: Vec<Finding> = cut_off(payload).into_iter().collect();
    found.extend(uneven(payload));
    found.extend(spins(rotation));
    found
}

fn cut_off(payload: &Node) -> Option<Finding> {
    let node = payload.get("release_s")?;
    Some(Finding::new(
        &node.span,
        "payload.release_s",
        "a payload that turns cannot be cut off",
        "remove [payload.rotation]: a body that hangs as a point can be cut off",
    ))
}

/// A spin needs its moment of inertia, and the other way round; no body has more about one axis than about two others
/// together.
fn spins(rotation: &Node) -> Option<Finding> {
    let key = |last: &str| format!("payload.rotation.{last}");
    let number = |key: &str| rotation.get(key).and_then(Node::number);
    let (spin, inertia) = (
        rotation.get("spin_deg_per_s"),
        rotation.get("spin_inertia_kg_m2"),
    );
    match (spin, inertia) {
        (None, Some(inertia)) => {
            let remedy = "add `spin_deg_per_s = ...`, how fast it spins, or remove it";
            let problem = "has no effect: the body does not spin";
            Some(Finding::new(
                &inertia.span,
                key("spin_inertia_kg_m2"),
                problem,
                remedy,
            ))
        }
        (Some(spin), None) => spin.number().filter(|spin| *spin != 0.0).map(|_| {
            let remedy =
                "add `spin_inertia_kg_m2 = ...`, the moment of inertia about its own axis in kg m²";
            Finding::new(&spin.span, key("spin_inertia_kg_m2"), "is missing", remedy)
        }),
        (Some(_), Some(node)) => {
            let (own, across) = (node.number()?, number("inertia_kg_m2")?);
            (own > 2.0 * across).then(|| {
                let problem = format!(
                    "no body has {} about its axis and only {} across it",
                    quantity(own, "kg m²"),
                    quantity(across, "kg m²")
                );
                let remedy = format!("give at most {}", quantity(2.0 * across, "kg m²"));
                Finding::new(&node.span, key("spin_inertia_kg_m2"), problem, remedy)
            })
        }
        (None, None) => None,
    }
}

/// A payload that turns is symmetric about its axis, which is z where it hangs upright.
fn uneven(payload: &Node) -> Vec<Finding> {
    let lists = ["drag_area_m2", "added_mass_kg"].into_iter();
    let given = lists.filter_map(|key| {
        let node = payload.get(key)?;
        let numbers = node.numbers()?;
        let (x, y) = (numbers.first()?, numbers.get(1)?);
        let problem = "differs along x and y, and a payload that turns is symmetric about its axis, which is z";
        let remedy = "give the same number along x and y: that across the axis";
        let key = format!("payload.{key}");
        (x != y).then(|| Finding::new(&node.span, key, problem, remedy))
    });
    let mut found: Vec<Finding> = given.collect();
    found.extend(oblong(payload));
    found
}

/// A box that turns, with sides that its drag or added mass would follow from, and that are not the same.
fn oblong(payload: &Node) -> Option<Finding> {
    let open = ["drag_area_m2", "added_mass_kg"]
        .iter()
        .any(|key| payload.get(key).is_none());
    let shape = payload.get("shape").filter(|_| open)?;
    let side = |key: &str| shape.get(key).and_then(Node::number);
    let (length, breadth) = (side("length_m")?, side("breadth_m")?);
    (length != breadth).then(|| {
        let problem = "is not symmetric about its axis, as a payload that turns must be";
        let remedy = "give drag_area_m2 and added_mass_kg, each with the same number along x and y, or a square box";
        Finding::new(&shape.span, "payload.shape", problem, remedy)
    })
}
