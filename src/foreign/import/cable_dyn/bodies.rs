//! The table BODIES: rigid bodies and buoys.

use std::f64::consts::PI;

use super::unmodelled;
use crate::import::fault::Fault;
use crate::import::index::Index;
use crate::import::listing::listed;
use crate::import::moordyn::line_types::unique;
use crate::import::moordyn::parts;
use crate::import::moordyn::sections::SectionBlock;
use crate::import::moordyn::table::{HeaderColumn, SectionTable, TableRow};
use crate::import::mooring::{Given, Hold, Mooring, MooringBody};

const COLUMNS: [HeaderColumn; 18] = [
    ("ID", &["#", "Name", "Body"]),
    ("Type", &["Attachment"]),
    ("X", &["X0"]),
    ("Y", &["Y0"]),
    ("Z", &["Z0"]),
    ("Roll", &["r0"]),
    ("Pitch", &["p0"]),
    ("Yaw", &["y0"]),
    ("Mass", &["M"]),
    ("Vol", &["V", "Volume"]),
    ("C33", &[]),
    ("C44", &[]),
    ("C55", &[]),
    ("CdA", &[]),
    ("Ca", &[]),
    ("Ixx", &[]),
    ("Iyy", &[]),
    ("Izz", &[]),
];

/// Columns that every row has.
const NEEDED: usize = 15;

/// Reads the bodies. Those that are points without directions (`Point3`) are returned by their places in the list.
pub fn read_bodies(
    block: &SectionBlock<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) -> Vec<usize> {
    let mut rows = block.rows.iter().filter(|row| !row.is_blank());
    let of_moordyn = rows
        .next()
        .is_some_and(|row| !row.words().iter().any(|word| word.is("C33")));
    if of_moordyn {
        parts::read_bodies(block, mooring, faults);
        return Vec::new();
    }
    let table = SectionTable::of_block(block, &COLUMNS, NEEDED, faults);
    let mut found = table.read(faults, body);
    unique(&mut found, |(one, _)| (&one.id, &one.span), "body", faults);
    let mut points = Vec::new();
    for (number, (body, is_point)) in found.into_iter().enumerate() {
        points.extend(is_point.then_some(number));
        mooring.bodies.push(body);
    }
    mooring.remarks.extend(at_the_surface(&mooring.bodies));
    points
}

/// A body, and whether it is a point.
fn body(row: &TableRow<'_, '_>) -> Result<(MooringBody, bool), Fault> {
    let word = row.words[1];
    let is_point = word.is("Point3");
    let hold = if is_point || word.is("Rigid6") || word.is("Free") {
        Hold::Free
    } else if word.is("Coupled") || word.is("Vessel") {
        Hold::Coupled
    } else if word.is("Fixed") {
        Hold::Fixed
    } else {
        let problem = format!("`{}` is not a type of body", word.text);
        return Err(row.fault(1, problem, "it is Rigid6, Point3, or Coupled (Vessel)"));
    };
    let inertia = match row.words.len() >= COLUMNS.len() {
        true => {
            let [x, y, z] = [
                row.not_negative(15)?,
                row.not_negative(16)?,
                row.not_negative(17)?,
            ];
            Given::new([x.value, y.value, z.value], x.span)
        }
        false => Given::new([0.0; 3], row.row.span()),
    };
    let stiffness = [
        row.not_negative(10)?,
        row.not_negative(11)?,
        row.not_negative(12)?,
    ];
    let (drag, added) = (row.not_negative(13)?, row.not_negative(14)?);
    let area = drag.value;
    let body = MooringBody {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: Given::new(hold, word.span()),
        place: row.triple(2)?,
        angles: row.triple(5)?,
        mass: row.not_negative(8)?,
        centre: Given::new([0.0; 3], row.row.span()),
        inertia,
        volume: row.not_negative(9)?,
        drag_area: Given::new([area, area, area, 0.0, 0.0, 0.0], drag.span),
        added_mass: Given::new([added.value; 3], added.span),
        waterplane: Given::new(
            stiffness.each_ref().map(|given| given.value),
            stiffness[0].span.clone(),
        ),
        loads: Vec::new(),
    };
    Ok((body, is_point))
}

/// What is said of bodies that lie in the surface, where `CableDyn` has them wet as a sphere is.
fn at_the_surface(bodies: &[MooringBody]) -> Option<String> {
    let pierces = |body: &&MooringBody| {
        let radius = (0.75 * body.volume.value / PI).cbrt();
        let is_hull = body.waterplane.value != [0.0; 3];
        !is_hull && body.hold.value.turns() && body.place[2].value > -radius && radius > 0.0
    };
    let found: Vec<&str> = bodies
        .iter()
        .filter(pierces)
        .map(|body| body.id.as_str())
        .collect();
    (!found.is_empty()).then(|| {
        format!(
            "Bodies {} begin in the surface: here all of their volume counts as under water, in CableDyn that of a sphere as far as it is.",
            listed(&found)
        )
    })
}

/// Turns bodies that are points (`Point3`) into the free point that is on each.
pub fn on_one_point(mooring: &mut Mooring, points: &[usize], faults: &mut Vec<Fault>) {
    for &number in points {
        let body = mooring.bodies[number].clone();
        let here = |hold: &Hold| *hold == Hold::Body(number);
        let mut on = (0..mooring.points.len()).filter(|k| here(&mooring.points[*k].hold.value));
        let (Some(point), None) = (on.next(), on.next()) else {
            faults.push(Fault::new(
                body.span.clone(),
                "BODIES, Type",
                "a body `Point3` has one point on it",
                "give one point `Body` with its number, or make the body Rigid6",
            ));
            continue;
        };
        if body.waterplane.value != [0.0; 3] {
            let what = "the water-plane stiffness of a point".to_owned();
            let span = body.waterplane.span.clone();
            mooring
                .unmodelled
                .push(unmodelled("", span, "BODIES, C33", what));
        }
        let point = &mut mooring.points[point];
        for (axis, place) in point.place.iter_mut().enumerate() {
            place.value += body.place[axis].value;
        }
        point.hold.value = Hold::Free;
        point.mass = body.mass.clone();
        point.volume = body.volume.clone();
        point.drag_area = Given::new(body.drag_area.value[0], body.drag_area.span.clone());
        point.added_mass = Given::new(body.added_mass.value[0], body.added_mass.span.clone());
    }
    without(mooring, points);
}

/// Takes these bodies out of the list.
fn without(mooring: &mut Mooring, gone: &[usize]) {
    if gone.is_empty() {
        return;
    }
    let kept = (0..mooring.bodies.len()).filter(|number| !gone.contains(number));
    let kept: Vec<usize> = kept.collect();
    let now = |hold: &mut Hold| renumber(hold, &kept);
    mooring
        .points
        .iter_mut()
        .for_each(|point| now(&mut point.hold.value));
    mooring
        .rods
        .iter_mut()
        .for_each(|rod| now(&mut rod.hold.value));
    let mut number = 0;
    mooring.bodies.retain(|_| {
        number += 1;
        !gone.contains(&(number - 1))
    });
}

/// The place of a body in the list of those that are kept.
fn renumber(hold: &mut Hold, kept: &[usize]) {
    match hold {
        Hold::Body(body) => {
            if let Ok(now) = kept.binary_search(body) {
                *body = now;
            }
        }
        Hold::Pinned(of) => renumber(of, kept),
        Hold::Free | Hold::Fixed | Hold::Coupled => {}
    }
}

/// Bodies by their identifiers.
pub fn index(mooring: &Mooring) -> Index {
    Index::of_identifiers(mooring.bodies.iter().map(|body| body.id.as_str()))
}
