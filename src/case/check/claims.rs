//! What the case says about itself: studies of keys that exist, published values and trends of
//! channels that a run records, marks of inputs that stand in the file.

use super::line::unknown_name;
use super::paths::{existing, named};
use super::spans::{stretch, suits, window};
use crate::case::along::{AlongLine, STEADY};
use crate::case::channels::{
    LineEnd, body_channels, elevation_channel, energy_channel, force_channels, joint_channels,
    motion_channels, rope_channels, tilt_channel, traveller_channels,
};
use crate::case::diagnostic::Finding;
use crate::case::fields::check_value;
use crate::case::fields::join;
use crate::case::fields::{Field, Kind, number};
use crate::case::model::{EndKind, Modes};
use crate::case::tree::{Data, Node};

/// Checks of studies, published values, trends and marks.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let mut found = studies(root);
    found.extend(marks(root));
    let mut channels = channel_names(root);
    if let Some(known) = &mut channels {
        known.extend(modal_names(root));
        let answers = root.find(&["output", "response_from_s"]).is_some();
        known.extend(answers.then(|| STEADY.to_owned()));
    }
    for (name, row) in named(root, "published_curve") {
        let key = |last: &str| join(&["published_curve", name.as_str(), last]);
        let known = channels.as_ref();
        found.extend(known.and_then(|known| over_time(row, known, key("channel"))));
        found.extend(window(row, &key("window_s")));
        found.extend(points(row, &key("time_s")));
        found.extend(row.get("at").and_then(|at| point(root, at, &key("at"))));
    }
    for list in ["published", "trend"] {
        for (name, row) in named(root, list) {
            let key = |last: &str| join(&[list, name.as_str(), last]);
            found.extend(
                channels
                    .as_ref()
                    .and_then(|known| channel(row, known, key("channel"))),
            );
            found.extend(suits(row, &key("statistic")));
            found.extend(window(row, &key("window_s")));
            for which in ["stretch_m", "by_stretch_m"] {
                found.extend(stretch(row, which, &key(which)));
            }
            if list == "published" {
                found.extend(tolerance(row, &key("tolerance_rel")));
                found.extend(one_other(row, &key("ratio_to")));
                for which in ["at", "change_from", "ratio_to"] {
                    found.extend(row.get(which).and_then(|at| point(root, at, &key(which))));
                }
            } else {
                found.extend(study_of(root, row, key("study")).err());
            }
        }
    }
    found
}

/// A study varies a key that exists and takes one number, over values in its range.
fn studies(root: &Node) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut taken: Vec<String> = Vec::new();
    for (name, study) in named(root, "study") {
        if let Some((node, own)) = study
            .get("name")
            .and_then(|node| Some((node, node.text()?)))
        {
            if taken.iter().any(|earlier| earlier == own) {
                let problem = format!("the name \"{own}\" is used twice");
                found.push(Finding::new(
                    &node.span,
                    join(&["study", &name, "name"]),
                    problem,
                    "give every study a name of its own",
                ));
            }
            taken.push(own.to_owned());
        }
        let Some((node, key)) = study.get("key").and_then(|node| Some((node, node.text()?))) else {
            continue;
        };
        match varied(root, key) {
            Ok(field) => found.extend(study_values(study, field, &name)),
            Err((problem, remedy)) => {
                found.push(Finding::new(
                    &node.span,
                    join(&["study", &name, "key"]),
                    problem,
                    remedy,
                ));
            }
        }
    }
    found
}

/// The field a study varies.
fn varied(root: &Node, key: &str) -> Result<&'static Field, (String, String)> {
    let field = existing(root, key)?;
    if field.takes_number() || matches!(field.kind, Kind::Choice(_)) {
        return Ok(field);
    }
    let problem = format!("`{key}` is not a number, so a study cannot vary it");
    Err((
        problem,
        "name a key that takes one number, or one of some words".to_owned(),
    ))
}

fn study_values(study: &Node, field: &Field, name: &str) -> Vec<Finding> {
    let items = study.get("values").map_or(&[] as &[Node], Node::items);
    let wrong = items.iter().filter_map(|item| {
        let fault = check_value(field, item)
            .err()
            .filter(|_| item.number().is_some() || item.text().is_some())?;
        Some(Finding::new(
            &item.span,
            join(&["study", name, "values"]),
            fault.problem,
            fault.remedy,
        ))
    });
    wrong.collect()
}

/// Marks point to inputs that the case has.
fn marks(root: &Node) -> Vec<Finding> {
    let marks = root.get("marks").map_or(&[] as &[_], Node::entries);
    let lost = marks.iter().filter_map(|mark| {
        let (problem, remedy) = existing(root, &mark.key).err()?;
        Some(Finding::new(
            &mark.key_span,
            join(&["marks", &mark.key]),
            problem,
            remedy,
        ))
    });
    lost.collect()
}

/// Names of the channels a run would record; nothing while line or ends are themselves faulty.
fn channel_names(root: &Node) -> Option<Vec<String>> {
    let end = |letter: &str| {
        let end = root.find(&["ends", letter])?;
        let kind = match end.get("kind")?.text()? {
            "fixed" => EndKind::Fixed,
            "anchor" => EndKind::Anchor,
            "payload" => EndKind::Payload,
            "moving" => EndKind::Moving,
            "free" => EndKind::Free,
            _ => return None,
        };
        Some((
            end.get("name")?.text()?,
            kind,
            end.get("release_s").is_some(),
        ))
    };
    let (a, b) = (end("a")?, end("b")?);
    let sections: Option<Vec<&str>> = root
        .get("line")?
        .items()
        .iter()
        .map(|section| section.get("name")?.text())
        .collect();
    let mut names = sections?;
    names.insert(0, a.0);
    names.push(b.0);
    let mut channels = joint_channels(&names);
    channels.extend(motion_channels(LineEnd::A, a.0, a.1, a.2));
    channels.extend(motion_channels(LineEnd::B, b.0, b.1, b.2));
    let turns = root.find(&["payload", "rotation"]).is_some();
    channels.extend(tilt_channel(b.0, b.1, turns));
    for (index, (_, clump)) in named(root, "clumps").iter().enumerate() {
        channels.extend(body_channels(index, clump.get("name")?.text()?));
    }
    if let Some(name) = root.find(&["traveller", "name"]) {
        channels.extend(traveller_channels(name.text()?));
    }
    channels.extend(force_channels(LineEnd::A, a.0, a.1));
    channels.extend(force_channels(LineEnd::B, b.0, b.1));
    channels.extend(root.get("waves").map(|_| elevation_channel()));
    let energy = root.find(&["output", "energy"]).map(|node| &node.data);
    channels.extend((energy == Some(&Data::Boolean(true))).then(energy_channel));
    for (index, section) in root.get("line")?.items().iter().enumerate() {
        let material = section.get("material").and_then(Node::text)?;
        // A variant with static stiffness lacks them, but what is said of the other variants is no fault.
        let reading = root.find(&["materials", material, "dynamic_stiffness"]);
        if reading.is_some() {
            channels.extend(rope_channels(index, section.get("name")?.text()?));
        }
    }
    Some(
        channels
            .into_iter()
            .map(|channel| channel.id.to_string())
            .collect(),
    )
}

/// Names of what a run tells of natural modes.
fn modal_names(root: &Node) -> Vec<String> {
    let wanted = root.get("modes").map(|modes| Modes {
        count: modes.get("count").and_then(Node::number).unwrap_or(10.0) as usize,
        near_hz: modes.get("near_hz").and_then(Node::number),
    });
    // Far beyond what anybody counts; the range of the field is told elsewhere.
    let wanted = wanted.filter(|wanted| wanted.count <= 1000);
    wanted.map_or_else(Vec::new, |wanted| wanted.names())
}

fn channel(row: &Node, known: &[String], key: String) -> Option<Finding> {
    let node = row.get("channel")?;
    let word = node.text()?;
    let line = AlongLine::ALL.map(AlongLine::name);
    let known: Vec<&str> = known.iter().map(String::as_str).chain(line).collect();
    if known.contains(&word) {
        return None;
    }
    let (problem, remedy) = unknown_name(word, &known, "channel");
    Some(Finding::new(&node.span, key, problem, remedy))
}

/// A channel against time, which a curve is held against.
fn over_time(row: &Node, known: &[String], key: String) -> Option<Finding> {
    let node = row.get("channel")?;
    let word = node.text()?;
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    if known.contains(&word) {
        return None;
    }
    let (problem, remedy) = unknown_name(word, &known, "channel");
    Some(Finding::new(&node.span, key, problem, remedy))
}

/// A curve has as many values as times, at least two, and its times increase.
fn points(row: &Node, key: &str) -> Option<Finding> {
    let node = row.get("time_s").or_else(|| row.get("value"))?;
    if row.get("points_file").is_some() {
        let problem = "the curve has its points twice: here and in `points_file`";
        return Some(Finding::new(&node.span, key, problem, "keep one of them"));
    }
    let (times, values) = (row.get("time_s")?.numbers()?, row.get("value")?.numbers()?);
    let problem = if times.len() != values.len() {
        format!("{} times stand beside {} values", times.len(), values.len())
    } else if times.len() < 2 {
        "a curve needs at least two points".to_owned()
    } else if !times.is_sorted_by(|a, b| a < b) {
        "the times do not increase".to_owned()
    } else {
        return None;
    };
    let remedy = "give as many values as times, the times increasing";
    Some(Finding::new(&node.span, key, problem, remedy))
}

fn tolerance(row: &Node, key: &str) -> Option<Finding> {
    let given = row.get("tolerance_rel").is_some() || row.get("tolerance_abs").is_some();
    (!given && row.get("value").is_some()).then(|| {
        let remedy = "add `tolerance_rel = ...` (a fraction of the value) or `tolerance_abs = ...` (in the unit of the value)";
        Finding::new(&row.span, key, "the row has no tolerance", remedy)
    })
}

/// A row is a change, a ratio to another point, or a ratio to another stretch; no two of them.
fn one_other(row: &Node, key: &str) -> Option<Finding> {
    let given = ["by_stretch_m", "ratio_to", "change_from"].map(|which| row.entry(which));
    let mut given = given.into_iter().flatten();
    let (first, _) = (given.next()?, given.next()?);
    let problem = "the row is held against two other numbers at once";
    Some(Finding::new(
        &first.key_span,
        key,
        problem,
        "keep one of change_from, ratio_to and by_stretch_m",
    ))
}

/// The study named by `table.study`.
fn study_of<'a>(root: &'a Node, table: &Node, key: String) -> Result<Option<&'a Node>, Finding> {
    let Some((node, word)) = table
        .get("study")
        .and_then(|node| Some((node, node.text()?)))
    else {
        return Ok(None);
    };
    let studies = named(root, "study");
    if let Some((_, study)) = studies.iter().find(|(name, _)| name == word) {
        return Ok(Some(*study));
    }
    let known: Vec<&str> = studies.iter().map(|(name, _)| name.as_str()).collect();
    let (problem, remedy) = unknown_name(word, &known, "study");
    Err(Finding::new(&node.span, key, problem, remedy))
}

/// The point of a study that a published row belongs to: one of the study's values.
fn point(root: &Node, at: &Node, key: &str) -> Option<Finding> {
    let study = match study_of(root, at, format!("{key}.study")) {
        Ok(study) => study?,
        Err(finding) => return Some(finding),
    };
    let node = at.get("value")?;
    let values = study.get("values")?.items();
    let same = |candidate: &Node| match (candidate.number(), node.number()) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        _ => candidate.text().is_some() && candidate.text() == node.text(),
    };
    if values.iter().any(same) {
        return None;
    }
    let shown = |node: &Node| match node.text() {
        Some(word) => Some(format!("\"{}\"", word.escape_default())),
        None => node.number().map(number),
    };
    let list: Vec<String> = values.iter().filter_map(shown).collect();
    let problem = format!("{} is not a value of the study", shown(node)?);
    Some(Finding::new(
        &node.span,
        format!("{key}.value"),
        problem,
        format!("the study's values are {}", list.join(", ")),
    ))
}
