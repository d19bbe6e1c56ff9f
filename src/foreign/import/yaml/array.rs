//! The table `array` of a RAFT design: floating turbines with their places, headings and moorings, and the lines that they share.

use std::path::Path;

use super::mapping::Mapping;
use super::raft::{self, RaftMooring};
use super::tree::YamlNode;
use crate::import::fault::Fault;
use crate::import::mooring::{
    Attachment, Given, Hold, Mooring, MooringBody, MooringLine, MooringPoint,
};

/// Lines that an array may have at most.
const GREATEST_COUNT: usize = 20_000;

/// A row of the array.
#[derive(Debug, Clone)]
struct Turbine {
    /// Its number, from 1.
    number: usize,
    /// Which of the moorings is its own; 0 for none.
    mooring: usize,
    /// x and y \[m\].
    place: [Given<f64>; 2],
    /// By which its mooring is turned \[deg\].
    heading: Given<f64>,
}

/// Reads the turbines, their moorings and the lines between them.
pub fn read(
    root: &Mapping<'_>,
    text: &str,
    folder: &Path,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let Some(array) = root.mapping("array", "give `keys` and `data`", faults) else {
        return;
    };
    let before = faults.len();
    let turbines = turbines(&array, faults);
    if faults.len() > before {
        return;
    }
    mooring.turbines = turbines.len();
    mooring.bodies = turbines.iter().map(body).collect();
    if let Some(shared) = root.get("array_mooring") {
        shared_lines(root, &shared, text, folder, mooring, faults);
    }
    let owns = turbines.iter().any(|turbine| turbine.mooring > 0);
    if owns {
        own_moorings(root, &array, &turbines, mooring, faults);
    } else if root.get("array_mooring").is_none() {
        let remedy = "give a mooringID of 1 or more, or an `array_mooring` with the file of lines that turbines share";
        let problem =
            "no turbine of the array has a mooring of its own, and there is no `array_mooring`";
        faults.push(Fault::new(array.node.key_span(), "array", problem, remedy));
    }
}

/// The keys that are read, as columns of an array.
const WANTED: [&str; 4] = ["mooringID", "x_location", "y_location", "heading_adjust"];
/// What an array has.
const TABLE: &str = "give `keys: [turbineID, platformID, mooringID, x_location, y_location, heading_adjust]` and rows of `data`";

/// The columns of a row: of the mooring, x, y, the heading, and how many there are.
struct ArrayColumns {
    wanted: [usize; 4],
    count: usize,
}

/// The rows of the array.
fn turbines(array: &Mapping<'_>, faults: &mut Vec<Fault>) -> Vec<Turbine> {
    let keys = array.required("keys", TABLE, faults);
    let data = array.required("data", TABLE, faults);
    let (Some(keys), Some(data)) = (keys, data) else {
        return Vec::new();
    };
    let (Some(keys), Some(rows)) = (keys.items(), data.items()) else {
        let problem = "`keys` and `data` are no lists";
        faults.push(Fault::new(array.node.key_span(), "array", problem, TABLE));
        return Vec::new();
    };
    if rows.is_empty() {
        let problem = "the array has no rows";
        faults.push(Fault::new(data.key_span(), "array.data", problem, TABLE));
    }
    let Some(columns) = columns(array, &keys, faults) else {
        return Vec::new();
    };
    let numbered = rows.iter().enumerate();
    numbered
        .filter_map(|(number, row)| turbine(array, number + 1, row, &columns, faults))
        .collect()
}

/// Where the keys that are read stand.
fn columns(
    array: &Mapping<'_>,
    keys: &[YamlNode<'_>],
    faults: &mut Vec<Fault>,
) -> Option<ArrayColumns> {
    let found = WANTED.map(|name| {
        let column = keys.iter().position(|key| key.text() == Some(name));
        if column.is_none() {
            let problem = format!("`{name}` is not among the keys");
            let span = array.node.key_span();
            faults.push(Fault::new(span, "array.keys", problem, TABLE));
        }
        column
    });
    let [Some(mooring), Some(x), Some(y), Some(heading)] = found else {
        return None;
    };
    Some(ArrayColumns {
        wanted: [mooring, x, y, heading],
        count: keys.len(),
    })
}

/// A row of the array.
fn turbine(
    array: &Mapping<'_>,
    number: usize,
    row: &YamlNode<'_>,
    columns: &ArrayColumns,
    faults: &mut Vec<Fault>,
) -> Option<Turbine> {
    let key = format!("data[{number}]");
    let cells = row.items().unwrap_or_default();
    if cells.len() != columns.count {
        let problem = format!(
            "the row has {} values for {} keys",
            cells.len(),
            columns.count
        );
        faults.push(array.fault(row, &key, problem, "give a value for each key"));
        return None;
    }
    let read = columns.wanted.map(|column| {
        let node = cells.get(column)?;
        array.number_of(node, &key, faults)
    });
    let [Some(mooring), Some(x), Some(y), Some(heading)] = read else {
        return None;
    };
    let Some(mooring) = whole(&mooring) else {
        let problem = format!("`{}` is not the number of a mooring", mooring.value);
        let remedy = "give 0 for none, or the number of one of the moorings";
        faults.push(Fault::new(mooring.span, array.key(&key), problem, remedy));
        return None;
    };
    Some(Turbine {
        number,
        mooring,
        place: [x, y],
        heading,
    })
}

/// A whole number below a million.
fn whole(given: &Given<f64>) -> Option<usize> {
    let is_whole = given.value.fract() == 0.0 && (0.0..1e6).contains(&given.value);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole and in range"
    )]
    is_whole.then_some(given.value as usize)
}

/// The platform of a turbine. RAFT turns the points on it and not the platform.
fn body(turbine: &Turbine) -> MooringBody {
    let span = turbine.place[0].span.clone();
    let none = || Given::new(0.0, span.clone());
    let [x, y] = turbine.place.clone();
    MooringBody {
        id: turbine.number.to_string(),
        span: span.clone(),
        hold: Given::new(Hold::Coupled, span.clone()),
        place: [x, y, none()],
        angles: [none(), none(), none()],
        mass: none(),
        centre: Given::new([0.0; 3], span.clone()),
        inertia: Given::new([0.0; 3], span.clone()),
        volume: none(),
        drag_area: Given::new([0.0; 6], span.clone()),
        added_mass: Given::new([0.0; 3], span.clone()),
        waterplane: Given::new([0.0; 3], span.clone()),
        loads: Vec::new(),
    }
}

/// The lines of `array_mooring`, from its file.
fn shared_lines(
    root: &Mapping<'_>,
    shared: &YamlNode<'_>,
    text: &str,
    folder: &Path,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let Some(table) = Mapping::of_node(*shared, root.key("array_mooring"), faults) else {
        return;
    };
    if let Some(depths) = table.get("bathymetry") {
        let problem = "a bed with depths by a file is not read from a design";
        let remedy = "leave it out for a bed at `water_depth`, or write a case with `depth_file`";
        faults.push(table.fault(&depths, "bathymetry", problem, remedy));
    }
    let remedy = "name the file of MoorDyn that has the lines between turbines";
    if let Some(file) = table.word("file", remedy, faults) {
        raft::beside(&file, &table.key("file"), text, folder, mooring, faults);
    }
}

/// The moorings of the turbines that have one of their own, each in its place.
fn own_moorings(
    root: &Mapping<'_>,
    array: &Mapping<'_>,
    turbines: &[Turbine],
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let tables = tables(root, faults);
    let mut systems: Vec<Option<RaftMooring>> = vec![None; tables.len()];
    let mut count = mooring.lines.len();
    for turbine in turbines.iter().filter(|turbine| turbine.mooring > 0) {
        let index = turbine.mooring - 1;
        let (Some(table), Some(system)) = (tables.get(index), systems.get_mut(index)) else {
            let problem = format!("there is no mooring {}", turbine.mooring);
            let remedy = format!("the design has {}", tables.len());
            let key = array.key(&format!("data[{}]", turbine.number));
            let span = turbine.place[0].span.clone();
            faults.push(Fault::new(span, key, problem, remedy));
            continue;
        };
        let system = match system {
            Some(system) => system,
            None => {
                let read = raft::system(table, mooring, faults);
                let types = mooring.line_types.len();
                mooring.line_types.extend(read.line_types.iter().cloned());
                let mut read = read;
                for line in &mut read.lines {
                    line.of_type.value += types;
                }
                system.insert(read)
            }
        };
        count += system.lines.len();
        if count > GREATEST_COUNT {
            let problem = format!("the array has more than {GREATEST_COUNT} lines");
            let span = array.node.key_span();
            faults.push(Fault::new(span, "array", problem, "give a part of it"));
            return;
        }
        place(turbine, system, mooring);
    }
}

/// The moorings that numbers refer to.
fn tables<'d>(root: &Mapping<'d>, faults: &mut Vec<Fault>) -> Vec<Mapping<'d>> {
    if root.get("moorings").is_some() {
        return root.mappings("moorings", "mooring", faults);
    }
    let remedy = "turbines with a mooringID have a `mooring`, or a list of `moorings`";
    root.mapping("mooring", remedy, faults)
        .into_iter()
        .collect()
}

/// Adds the mooring of a turbine: turned about its platform, and moved with it.
fn place(turbine: &Turbine, system: &RaftMooring, mooring: &mut Mooring) {
    let first = mooring.points.len();
    let prefix = |name: &str| format!("t{}-{name}", turbine.number);
    let (sin, cos) = turbine.heading.value.to_radians().sin_cos();
    let [x0, y0] = [turbine.place[0].value, turbine.place[1].value];
    for point in &system.points {
        let [x, y, z] = point.place.clone();
        let turned = [cos * x.value - sin * y.value, sin * x.value + cos * y.value];
        let is_on_platform = raft::is_on_platform(point);
        let moved = match is_on_platform {
            true => turned,
            false => [x0 + turned[0], y0 + turned[1]],
        };
        let hold = match is_on_platform {
            true => Hold::Body(turbine.number - 1),
            false => point.hold.value.clone(),
        };
        mooring.points.push(MooringPoint {
            id: prefix(&point.id),
            hold: Given::new(hold, point.hold.span.clone()),
            place: [
                Given::new(moved[0], x.span),
                Given::new(moved[1], y.span),
                z,
            ],
            ..point.clone()
        });
    }
    for line in &system.lines {
        let ends = line.ends.clone().map(|end| match end.value {
            Attachment::Point(point) => Given::new(Attachment::Point(first + point), end.span),
            Attachment::Rod(..) | Attachment::Inside(_) => end,
        });
        mooring.lines.push(MooringLine {
            id: prefix(&line.id),
            ends,
            ..line.clone()
        });
    }
}
