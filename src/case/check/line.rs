//! The line as a whole: materials its sections name, names of sections and ends, what holds the
//! ends and whether the line reaches, floats and bodies inside their section.

use crate::case::diagnostic::Finding;
use crate::case::fields::nearest;
use crate::case::fields::{either, quantity};
use crate::case::tree::{Node, element_names};

/// Ends held farther apart than this multiple of the unstretched length are out of reach: no cable
/// material stands half its length in stretch.
const MOST_STRETCH: f64 = 1.5;

/// Checks of line, ends, floats and start.
pub(crate) fn check(root: &Node) -> Vec<Finding> {
    let mut found = materials(root);
    found.extend(names(root));
    found.extend(held_ends(root));
    found.extend(reach(root));
    for table in ["floats", "clumps", "modules"] {
        found.extend(on_stretches(root, table));
    }
    found.extend(nothing_holds(root));
    found.extend(travels(root));
    found
}

fn sections(root: &Node) -> Vec<(String, &Node)> {
    let items = root.get("line").map_or(&[] as &[Node], Node::items);
    element_names(items).into_iter().zip(items).collect()
}

fn clumps(root: &Node) -> Vec<(String, &Node)> {
    let items = root.get("clumps").map_or(&[] as &[Node], Node::items);
    element_names(items).into_iter().zip(items).collect()
}

/// The two ends with the letters they go by.
fn ends(root: &Node) -> impl Iterator<Item = (&'static str, &Node)> {
    let both = ["a", "b"].into_iter();
    both.filter_map(move |letter| Some((letter, root.find(&["ends", letter])?)))
}

/// A message that a word is not among those known, with the nearest one.
pub(super) fn unknown_name(word: &str, known: &[&str], what: &str) -> (String, String) {
    let problem = format!("there is no {what} named \"{}\"", word.escape_default());
    let remedy = match nearest(word, known.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None if known.is_empty() => format!("the case has no {what} yet; add one"),
        None => format!("the case has {}", either(known).replace(" or ", " and ")),
    };
    (problem, remedy)
}

fn materials(root: &Node) -> Vec<Finding> {
    let Some(materials) = root.get("materials") else {
        return Vec::new();
    };
    let known: Vec<&str> = materials
        .entries()
        .iter()
        .map(|entry| entry.key.as_str())
        .collect();
    let missing = sections(root).into_iter().filter_map(|(name, section)| {
        let material = section.get("material")?;
        let word = material.text()?;
        if known.contains(&word) {
            return None;
        }
        let (problem, remedy) = unknown_name(word, &known, "material");
        Some(Finding::new(
            &material.span,
            format!("line.{name}.material"),
            problem,
            remedy,
        ))
    });
    missing.collect()
}

/// Sections, ends and bodies share channel names, so no two of them may be called the same.
fn names(root: &Node) -> Vec<Finding> {
    let of_sections = sections(root)
        .into_iter()
        .map(|(name, section)| (format!("line.{name}.name"), section));
    let of_clumps = clumps(root)
        .into_iter()
        .map(|(name, clump)| (format!("clumps.{name}.name"), clump));
    let of_ends = ends(root).map(|(letter, end)| (format!("ends.{letter}.name"), end));
    let mut taken: Vec<&str> = Vec::new();
    let mut found = Vec::new();
    let traveller = root.get("traveller");
    let of_traveller = traveller.map(|node| ("traveller.name".to_owned(), node));
    let all = of_sections.chain(of_ends).chain(of_clumps);
    for (key, table) in all.chain(of_traveller) {
        let Some((node, name)) = table
            .get("name")
            .and_then(|node| Some((node, node.text()?)))
        else {
            continue;
        };
        if taken.contains(&name) {
            let problem = format!("the name \"{name}\" is used twice");
            let remedy =
                "give every section, every end and every body on the line a name of its own";
            found.push(Finding::new(&node.span, key, problem, remedy));
        }
        taken.push(name);
    }
    found
}

/// Whether a moving end moves in harmonics of one period.
fn swings(end: &Node) -> bool {
    let motion = end.get("motion").and_then(Node::text);
    motion.is_none_or(|motion| motion == "harmonic")
}

/// A body that travels along the line stays on it.
fn travels(root: &Node) -> Vec<Finding> {
    let length = |section: &Node| section.get("length_m")?.number();
    let lengths: Option<Vec<f64>> = sections(root).iter().map(|s| length(s.1)).collect();
    let (Some(traveller), Some(lengths)) = (root.get("traveller"), lengths) else {
        return Vec::new();
    };
    let whole: f64 = lengths.iter().sum();
    let beyond = ["from_m", "to_m"].into_iter().filter_map(|key| {
        let node = traveller.get(key)?;
        let place = node.number().filter(|place| *place > whole)?;
        let problem = format!("lies beyond the line: {place} m of {whole} m");
        let remedy =
            format!("give {whole} m or less, measured along the unstretched line from end A");
        Some(Finding::new(
            &node.span,
            format!("traveller.{key}"),
            problem,
            remedy,
        ))
    });
    beyond.chain(goes_nowhere(traveller, whole)).collect()
}

/// A way that ends where it begins, with a speed.
fn goes_nowhere(traveller: &Node, whole: f64) -> Option<Finding> {
    let number = |key: &str| traveller.get(key).map(Node::number);
    let (from, to) = (
        number("from_m").unwrap_or(Some(0.0))?,
        number("to_m").unwrap_or(Some(whole))?,
    );
    let speed = number("speed_m_per_s")??;
    (from == to && speed > 0.0).then(|| {
        let key = if traveller.get("to_m").is_some() {
            "to_m"
        } else {
            "from_m"
        };
        let span = traveller
            .get(key)
            .map_or(&traveller.span, |node| &node.span);
        let problem = format!("its way ends where it begins, at {}", quantity(from, "m"));
        let remedy = "let it end elsewhere, or give a speed of 0 to a body that stays";
        Finding::new(span, format!("traveller.{key}"), problem, remedy)
    })
}

fn kind(end: &Node) -> Option<&str> {
    end.get("kind")?.text()
}

fn is_held(end: &Node) -> bool {
    matches!(kind(end), Some("fixed" | "anchor" | "moving"))
}

/// Held ends need a position, moving ends a period, and there is a payload exactly when one end
/// carries it.
fn held_ends(root: &Node) -> Vec<Finding> {
    let mut found = Vec::new();
    let mut carriers = 0;
    for (letter, end) in ends(root) {
        if is_held(end) && end.get("position_m").is_none() {
            let remedy = "add `position_m = [x, y, z]` in m, z up from still water: what is held must be held somewhere";
            found.push(Finding::new(
                &end.span,
                format!("ends.{letter}.position_m"),
                "is missing",
                remedy,
            ));
        }
        if kind(end) == Some("moving") && swings(end) && end.get("period_s").is_none() {
            let remedy = "add `period_s = ...` in s: a moving end needs the period of its motion";
            found.push(Finding::new(
                &end.span,
                format!("ends.{letter}.period_s"),
                "is missing",
                remedy,
            ));
        }
        if let Some(node) = end
            .get("release_s")
            .filter(|_| !is_held(end) && kind(end).is_some())
        {
            let problem = "has no effect: nothing holds the end";
            let remedy = "hold it (fixed, anchor or moving), or remove the key; a payload is cut off by payload.release_s";
            let key = format!("ends.{letter}.release_s");
            found.push(Finding::new(&node.span, key, problem, remedy));
        }
        let Some(node) = end.get("kind").filter(|_| kind(end) == Some("payload")) else {
            continue;
        };
        carriers += 1;
        let key = format!("ends.{letter}.kind");
        if carriers > 1 {
            found.push(Finding::new(
                &node.span,
                key,
                "both ends carry the payload",
                "leave it on one end; the other may be fixed, anchor, moving or free",
            ));
        } else if root.get("payload").is_none() {
            found.push(Finding::new(
                &node.span,
                key,
                "the end carries a payload, and the case has none",
                "add a table [payload] with its mass, or make the end `free`",
            ));
        } else if letter == "a"
            && ends(root).all(|(l, end)| l == "a" || kind(end) != Some("payload"))
        {
            found.push(Finding::new(
                &node.span,
                key,
                "is `payload`, and the payload hangs at end B",
                "list the sections from the other end, and swap the tables of the ends",
            ));
        }
    }
    let both_kinds_known = ends(root).filter(|(_, end)| kind(end).is_some()).count() == 2;
    let payload = root
        .get("payload")
        .filter(|_| carriers == 0 && both_kinds_known);
    found.extend(payload.map(|node| {
        let remedy = "set the kind of the end that carries it to \"payload\", or remove [payload]";
        Finding::new(&node.span, "payload", "no end carries the payload", remedy)
    }));
    found
}

fn length(root: &Node) -> Option<f64> {
    let each: Option<Vec<f64>> = sections(root)
        .into_iter()
        .map(|(_, section)| {
            section
                .get("length_m")?
                .number()
                .filter(|length| *length > 0.0)
        })
        .collect();
    each.map(|lengths| lengths.iter().sum())
}

/// Two given positions must not be farther apart than the line can stretch.
fn reach(root: &Node) -> Option<Finding> {
    let length = length(root).filter(|length| *length > 0.0)?;
    let a = root.find(&["ends", "a", "position_m"])?.numbers()?;
    let node = root.find(&["ends", "b", "position_m"])?;
    let b = node.numbers()?;
    if a.len() != 3 || b.len() != 3 {
        return None;
    }
    let apart = a
        .iter()
        .zip(&b)
        .map(|(p, q)| (p - q).powi(2))
        .sum::<f64>()
        .sqrt();
    (apart > MOST_STRETCH * length).then(|| {
        let problem = format!(
            "the end is off the line's reach: the ends are {} apart and the line is {} long",
            quantity(rounded(apart), "m"),
            quantity(rounded(length), "m"),
        );
        let remedy = format!(
            "move the ends to within {} of each other, or make the line longer",
            quantity(rounded(MOST_STRETCH * length), "m"),
        );
        Finding::new(&node.span, "ends.b.position_m", problem, remedy)
    })
}

/// Lengths in messages are told to the millimetre.
fn rounded(metres: f64) -> f64 {
    (metres * 1e3).round() / 1e3
}

/// Floats, bodies and buoyancy modules sit on a section that exists, and inside it.
fn on_stretches(root: &Node, table: &str) -> Vec<Finding> {
    let items = root.get(table).map_or(&[] as &[Node], Node::items);
    let lines = sections(root);
    let mut found = Vec::new();
    for (name, item) in element_names(items).into_iter().zip(items) {
        let Some((node, section)) = item
            .get("section")
            .and_then(|node| Some((node, node.text()?)))
        else {
            continue;
        };
        let Some((_, on)) = lines.iter().find(|(known, _)| known == section) else {
            let known: Vec<&str> = lines.iter().map(|(name, _)| name.as_str()).collect();
            let (problem, remedy) = unknown_name(section, &known, "section");
            found.push(Finding::new(
                &node.span,
                format!("{table}.{name}.section"),
                problem,
                remedy,
            ));
            continue;
        };
        let length = on.get("length_m").and_then(Node::number);
        let name = format!("{table}.{name}");
        found.extend(place(item, &name, section, length));
        found.extend(stretch(item, &name, section, length));
    }
    found
}

/// The place of a body: inside its section.
fn place(item: &Node, name: &str, section: &str, length: Option<f64>) -> Option<Finding> {
    let node = item.get("at_m")?;
    let (at, length) = (node.number()?, length.filter(|length| *length > 0.0)?);
    (at > length).then(|| {
        let problem = format!("it hangs beyond its section: at {}", quantity(at, "m"));
        let inside = format!("section \"{section}\" is {} long", quantity(length, "m"));
        Finding::new(&node.span, format!("{name}.at_m"), problem, inside)
    })
}

/// The stretch a group of floats sits on: not empty, and inside its section.
fn stretch(item: &Node, name: &str, section: &str, length: Option<f64>) -> Option<Finding> {
    let length = length.filter(|length| *length > 0.0)?;
    let from = item.get("from_m").and_then(Node::number).unwrap_or(0.0);
    let to = item.get("to_m").and_then(Node::number);
    let inside = format!("section \"{section}\" is {} long", quantity(length, "m"));
    if let Some((to, node)) = to.zip(item.get("to_m")).filter(|(to, _)| *to > length) {
        let problem = format!("they reach beyond their section: {}", quantity(to, "m"));
        return Some(Finding::new(
            &node.span,
            format!("{name}.to_m"),
            problem,
            inside,
        ));
    }
    let end = to.unwrap_or(length);
    if from >= end {
        let key = if item.get("from_m").is_some() {
            "from_m"
        } else {
            "to_m"
        };
        let span = item.get(key).map_or(&item.span, |node| &node.span);
        let problem = format!(
            "the stretch is empty: it begins at {} and ends at {}",
            quantity(from, "m"),
            quantity(end, "m")
        );
        let remedy = format!("let it begin before it ends; {inside}");
        return Some(Finding::new(span, format!("{name}.{key}"), problem, remedy));
    }
    None
}

/// An equilibrium needs an end that is held.
fn nothing_holds(root: &Node) -> Option<Finding> {
    let (_, b) = ends(root).find(|(letter, _)| *letter == "b")?;
    let loose = ends(root).all(|(_, end)| matches!(kind(end), Some("payload" | "free")));
    let shape = root
        .find(&["start", "shape"])
        .map_or(Some("equilibrium"), Node::text)?;
    let method = root
        .find(&["solver", "method"])
        .map_or(Some("alpha"), Node::text)?;
    let needed = shape == "equilibrium" || matches!(method, "static" | "quasi");
    (loose && needed).then(|| {
        let span = b.get("kind").map_or(&b.span, |node| &node.span);
        let remedy = "hold one end (fixed, anchor or moving), or let a dynamic run begin with start.shape = \"straight\"";
        Finding::new(span, "ends.b.kind", "nothing holds the line, so it has no equilibrium", remedy)
    })
}
