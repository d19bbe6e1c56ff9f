//! Waves and motions: what is missing, what is told twice, and what has no effect.

use crate::case::diagnostic::Finding;
use crate::case::tree::Node;

/// Checks of the waves, and of ends that do not move in harmonics of one period.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let mut found = waves(root);
    for letter in ["a", "b"] {
        found.extend(motion(root, letter));
        found.extend(idle(root, letter));
    }
    found
}

/// A direction of a clamp that is none.
fn idle(root: &Node, letter: &str) -> Option<Finding> {
    let end = root.find(&["ends", letter])?;
    let node = end.get("clamp_azimuth_deg")?;
    let said = end.get("clamp_elevation_deg").is_none() && node.number() != Some(0.0);
    said.then(|| {
        Finding::new(
            &node.span,
            format!("ends.{letter}.clamp_azimuth_deg"),
            "has no effect: the end is hinged",
            "add `clamp_elevation_deg = ...`, the angle above the horizontal, or remove it",
        )
    })
}

/// What the motion of an end needs, by its kind.
fn motion(root: &Node, letter: &str) -> Vec<Finding> {
    let Some(end) = root.find(&["ends", letter]) else {
        return Vec::new();
    };
    let Some(motion) = end.get("motion") else {
        return Vec::new();
    };
    let needs: &[(&str, &str)] = match motion.text() {
        Some("table") => &[(
            "motion_file",
            "the CSV file beside the case with time_s,x_m,y_m,z_m",
        )],
        Some("irregular") => &[
            ("rms_m", "the root mean squares along x, y, z in m"),
            ("peak_period_s", "the period of the spectrum's peak in s"),
        ],
        Some("vessel") => &[(
            "motion_file",
            "the CSV file beside the case with the vessel's responses",
        )],
        _ => &[],
    };
    let mut found: Vec<Finding> = needs
        .iter()
        .filter(|(key, _)| end.get(key).is_none())
        .map(|(key, what)| {
            let remedy = format!("add `{key} = ...`: {what}");
            Finding::new(
                &motion.span,
                format!("ends.{letter}.{key}"),
                "is missing",
                remedy,
            )
        })
        .collect();
    if motion.text() == Some("vessel") && root.get("waves").is_none() {
        found.push(Finding::new(
            &motion.span,
            format!("ends.{letter}.motion"),
            "a vessel moves in waves, and the case has none",
            "add [waves]",
        ));
    }
    found
}

fn waves(root: &Node) -> Vec<Finding> {
    let Some(waves) = root.get("waves") else {
        return Vec::new();
    };
    let text = |key: &str| waves.get(key).and_then(Node::text);
    let finding = |key: &str, problem: &str, remedy: &str| {
        let node = waves.get(key)?;
        Some(Finding::new(
            &node.span,
            format!("waves.{key}"),
            problem,
            remedy,
        ))
    };
    let mut found = Vec::new();
    if root.get("seabed").is_some() {
        found.extend(finding(
            "depth_m",
            "the depth is given twice, here and by seabed.depth_m",
            "remove it: the waves feel the sea bed",
        ));
    }
    if text("spectrum") == Some("pierson-moskowitz") {
        found.extend(finding(
            "gamma",
            "has no effect: a Pierson-Moskowitz spectrum has no peak enhancement",
            "remove it, or set spectrum = \"jonswap\"",
        ));
    }
    if !matches!(text("decay"), Some("airy-cut" | "logarithmic")) {
        found.extend(finding(
            "decay_depth_m",
            "has no effect: Airy's theory goes down to the bed",
            "remove it, or set decay = \"airy-cut\" or \"logarithmic\"",
        ));
    }
    found
}
