//! Fairleads of a platform of `FAModel`: a radius and a height, or a list of places; in the array or in a file of the platform.

use std::ops::Range;
use std::path::Path;

use super::load;
use super::mapping::Mapping;
use super::tree::{YamlNode, shortened};
use crate::import::fault::{Fault, line_and_column};
use crate::import::moordyn::files::Files;
use crate::import::mooring::Given;
use crate::import::words::Word;

/// Where lines are attached to a platform.
#[derive(Debug, Clone)]
pub enum Fairleads {
    /// At a radius in the direction of the line, and a height \[m\].
    Radius([Given<f64>; 2]),
    /// At places about the platform \[m\], one a line.
    Places(Vec<[f64; 3]>, Range<usize>),
}

/// The fairleads of a kind of platform, by its number from 1.
pub fn fairleads(
    root: &Mapping<'_>,
    folder: &Path,
    kind: &Given<f64>,
    faults: &mut Vec<Fault>,
) -> Option<Fairleads> {
    let remedy = "a platform has `rFair` and `zFair`, or `fairleads`";
    if let Some(node) = root.get("platform") {
        return of_platform(&Mapping::of_node(node, "platform", faults)?, None, faults);
    }
    let list = root.required("platforms", remedy, faults)?;
    let items = list.items().unwrap_or_default();
    let found = items.iter().enumerate().find(|(number, _)| {
        #[expect(clippy::cast_precision_loss, reason = "a list in a file")]
        let from_one = (*number + 1) as f64;
        (from_one - kind.value).abs() < 0.5
    });
    let Some((number, node)) = found else {
        let problem = format!("there is no platform {}", kind.value);
        let remedy = format!("the list `platforms` has {}", items.len());
        faults.push(Fault::new(
            kind.span.clone(),
            "array.data.platformID",
            problem,
            remedy,
        ));
        return None;
    };
    let path = format!("platforms[{}]", number + 1);
    match node
        .scalar()
        .filter(|scalar| scalar.tag.as_deref() == Some("!include"))
    {
        Some(scalar) => included(&scalar.text, node, &path, folder, faults),
        None => of_platform(&Mapping::of_node(*node, path, faults)?, None, faults),
    }
}

/// The fairleads of a platform in a file of its own.
fn included(
    name: &str,
    node: &YamlNode<'_>,
    path: &str,
    folder: &Path,
    faults: &mut Vec<Fault>,
) -> Option<Fairleads> {
    let at = node.span();
    let text = match text_of_platform(name, &at, path, folder) {
        Ok(text) => text,
        Err(fault) => {
            faults.push(fault);
            return None;
        }
    };
    let outside = |fault: Fault| at_its_name(&fault, name, &text, &at);
    let document = match load::load(&text) {
        Ok((document, twice)) => {
            faults.extend(twice.into_iter().map(outside));
            document
        }
        Err(fault) => {
            faults.push(outside(Fault {
                key: path.to_owned(),
                ..fault
            }));
            return None;
        }
    };
    let Some(root) = document.root().filter(YamlNode::is_mapping) else {
        let problem = format!(
            "the file `{}` is no YAML file of a platform",
            shortened(name)
        );
        faults.push(Fault::new(
            at.clone(),
            path,
            problem,
            "it has keys such as rFair and zFair",
        ));
        return None;
    };
    let node = root
        .get("platform")
        .filter(YamlNode::is_mapping)
        .unwrap_or(root);
    let platform = Mapping {
        node,
        path: format!("{path} in {}", shortened(name)),
    };
    let mut inside = Vec::new();
    let read = of_platform(&platform, Some(&at), &mut inside);
    faults.extend(inside.into_iter().map(outside));
    read
}

/// The text of the file of a platform that is named at a place.
fn text_of_platform(
    name: &str,
    at: &Range<usize>,
    path: &str,
    folder: &Path,
) -> Result<String, Fault> {
    let word = Word {
        text: name,
        start: at.start,
    };
    let text = (Files { folder }).text(word, path);
    text.map_err(|fault| Fault {
        span: at.clone(),
        remedy: "put it there: it has the place of the fairleads (rFair, zFair)".to_owned(),
        ..fault
    })
}

/// A fault of an included file where that is named, with its row there in the words.
fn at_its_name(fault: &Fault, name: &str, text: &str, at: &Range<usize>) -> Fault {
    let (line, column) = line_and_column(text, fault.span.start);
    let problem = format!(
        "in `{}`, line {line}, column {column}: {}",
        shortened(name),
        fault.problem
    );
    Fault::new(at.clone(), &fault.key, problem, &fault.remedy)
}

/// The fairleads of a platform; `at` is where its file is named, if it has one of its own.
fn of_platform(
    platform: &Mapping<'_>,
    at: Option<&Range<usize>>,
    faults: &mut Vec<Fault>,
) -> Option<Fairleads> {
    let placed = |given: Given<f64>| match at {
        Some(at) => Given::new(given.value, at.clone()),
        None => given,
    };
    if platform.get("fairleads").is_none() {
        let radius = platform.not_negative("rFair", faults);
        let height = platform.number("zFair", faults);
        return Some(Fairleads::Radius([placed(radius?), placed(height?)]));
    }
    let mut places = Vec::new();
    for row in platform.mappings("fairleads", "fairlead", faults) {
        let [x, y, z] = row.place("r_rel", faults)?.map(|given| given.value);
        let Some(headings) = row.get("headings") else {
            places.push([x, y, z]);
            continue;
        };
        for heading in headings.items().unwrap_or_default() {
            let heading = row.number_of(&heading, "headings", faults)?;
            let (sin, cos) = (90.0 - heading.value).to_radians().sin_cos();
            places.push([cos * x - sin * y, sin * x + cos * y, z]);
        }
    }
    let span = at.cloned().unwrap_or_else(|| platform.node.key_span());
    Some(Fairleads::Places(places, span))
}
