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

/// A spin needs its moment of inertia, and no body has more about one axis than about two others together.
fn spins(rotation: &Node) -> Option<Finding> {
    let number = |key: &str| rotation.get(key).and_then(Node::number);
    let finding = |node: &Node, problem: String, remedy: String| {
        let key = "payload.rotation.spin_inertia_kg_m2";
        Some(Finding::new(&node.span, key, problem, remedy))
    };
    let Some(node) = rotation.get("spin_inertia_kg_m2") else {
        let spin = rotation.get("spin_deg_per_s")?;
        spin.number().filter(|spin| *spin != 0.0)?;
        let remedy = "add `spin_inertia_kg_m2 = ...`, the moment of inertia about its own axis";
        return finding(spin, "is missing".to_owned(), remedy.to_owned());
    };
    let (own, across) = (node.number()?, number("inertia_kg_m2")?);
    if own <= 2.0 * across {
        return None;
    }
    let [own, across, most] = [own, across, 2.0 * across].map(|size| quantity(size, "kg m²"));
    let problem = format!("no body has {own} about its axis and only {across} across it");
    finding(node, problem, format!("give at most {most}"))
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
