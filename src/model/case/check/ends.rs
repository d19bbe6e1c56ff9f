//! The ends: what holds them, what moves them, whether the line reaches, and that something holds it.

use super::line::length;
use crate::case::diagnostic::Finding;
use crate::case::fields::quantity;
use crate::case::model::{CaseKeys, EndKeys, EndKind, Method, MotionName, StartShape};

/// Ends held farther apart than this multiple of the unstretched length are out of reach: no cable
/// material stretches by half its length.
const MOST_STRETCH: f64 = 1.5;

/// Checks of the ends.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let mut found: Vec<Finding> = case.each_end().flat_map(held).collect();
    for end in case.each_end() {
        found.extend(motion(case, end));
        found.extend(clamp(end));
    }
    found.extend(carrier(case));
    found.extend(reach(case));
    found.extend(nothing_holds(case));
    found
}

fn is_held(end: &EndKeys<'_>) -> bool {
    end.kind.get().is_some_and(|kind| kind.is_held())
}

/// Held ends need a position, moving ends a period; what is not held cannot be let go.
fn held(end: &EndKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if is_held(end) {
        found.extend(end.position_m.if_missing("add `position_m = [x, y, z]` in m, z up from still water: what is held must be held somewhere"));
    } else if end.kind.get().is_some() {
        let remedy = "hold it (fixed, anchor or moving), or remove the key; a payload is cut off by payload.release_s";
        found.extend(
            end.release_s
                .if_given("has no effect: nothing holds the end", remedy),
        );
    }
    if end.kind.is(&EndKind::Moving) && end.motion.is(&MotionName::Harmonic) {
        let remedy = "add `period_s = ...` in s: a moving end needs the period of its motion";
        found.extend(end.period_s.if_missing(remedy));
    }
    found
}

/// What the motion of an end needs, by its kind.
fn motion(case: &CaseKeys<'_>, end: &EndKeys<'_>) -> Vec<Finding> {
    let Some(motion) = end.motion.given() else {
        return Vec::new();
    };
    let needed = |name: &str, given: bool, what: &str| {
        (!given).then(|| {
            let missing = end
                .motion
                .finding("is missing", format!("add `{name} = ...`: {what}"));
            Finding {
                key: end.place.key(name),
                ..missing
            }
        })
    };
    let file = |what: &str| needed("motion_file", end.motion_file.is_given(), what);
    let found = match motion {
        MotionName::Harmonic => [None, None],
        MotionName::Table => [
            file("the CSV file beside the case with time_s,x_m,y_m,z_m"),
            None,
        ],
        MotionName::Irregular => [
            needed(
                "rms_m",
                end.rms_m.is_given(),
                "the root mean squares along x, y, z in m",
            ),
            needed(
                "peak_period_s",
                end.peak_period_s.is_given(),
                "the period of the spectrum's peak in s",
            ),
        ],
        MotionName::Vessel => [
            file("the CSV file beside the case with the vessel's responses"),
            case.place.node.get("waves").is_none().then(|| {
                end.motion.finding(
                    "a vessel moves in waves, and the case has none",
                    "add [waves]",
                )
            }),
        ],
    };
    found.into_iter().flatten().collect()
}

/// The direction of a clamp that is none.
fn clamp(end: &EndKeys<'_>) -> Option<Finding> {
    let idle = !end.clamp_elevation_deg.is_given() && !end.clamp_azimuth_deg.is(&0.0);
    let remedy = "add `clamp_elevation_deg = ...`, the angle above the horizontal, or remove it";
    let found = end
        .clamp_azimuth_deg
        .if_given("has no effect: the end is hinged", remedy);
    found.filter(|_| idle)
}

/// There is a payload exactly when one end carries it, and that is end B.
fn carrier(case: &CaseKeys<'_>) -> Vec<Finding> {
    let Some(ends) = &case.ends else {
        return Vec::new();
    };
    let carries = |end: &&EndKeys<'_>| end.kind.is(&EndKind::Payload);
    let (a, b) = (ends.a.as_ref(), ends.b.as_ref());
    let payload = case.place.node.get("payload");
    let mut carriers = [a, b].into_iter().flatten().filter(carries);
    let Some(first) = carriers.next() else {
        let kinds_known = [a, b]
            .iter()
            .flatten()
            .filter(|end| end.kind.get().is_some())
            .count()
            == 2;
        let idle = payload.filter(|_| kinds_known);
        return idle
            .map(|node| {
                let remedy =
                    "set the kind of the end that carries it to \"payload\", or remove [payload]";
                Finding::new(&node.span, "payload", "no end carries the payload", remedy)
            })
            .into_iter()
            .collect();
    };
    let second = carriers.next();
    let mut found = Vec::new();
    if payload.is_none() {
        found.push(first.kind.finding(
            "the end carries a payload, and the case has none",
            "add a table [payload] with its mass, or make the end `free`",
        ));
    } else if second.is_none() && a.filter(carries).is_some() {
        found.push(first.kind.finding(
            "is `payload`, and the payload hangs at end B",
            "list the sections from the other end, and swap the tables of the ends",
        ));
    }
    found.extend(second.map(|end| {
        end.kind.finding(
            "both ends carry the payload",
            "leave it on one end; the other may be fixed, anchor, moving or free",
        )
    }));
    found
}

/// Two given positions must not be farther apart than the line can stretch.
fn reach(case: &CaseKeys<'_>) -> Option<Finding> {
    let length = length(case).filter(|length| *length > 0.0)?;
    let ends = case.ends.as_ref()?;
    let (a, b) = (&ends.a.as_ref()?.position_m, &ends.b.as_ref()?.position_m);
    let squares = a.get()?.iter().zip(b.get()?).map(|(p, q)| (p - q).powi(2));
    let apart = squares.sum::<f64>().sqrt();
    (apart > MOST_STRETCH * length).then(|| {
        let problem = format!(
            "the end is off the line's reach: the ends are {} apart and the line is {} long",
            rounded(apart),
            rounded(length),
        );
        let remedy = format!(
            "move the ends to within {} of each other, or make the line longer",
            rounded(MOST_STRETCH * length),
        );
        b.finding(problem, remedy)
    })
}

/// A length to the millimetre.
fn rounded(metres: f64) -> String {
    quantity((metres * 1e3).round() / 1e3, "m")
}

/// An equilibrium needs an end that is held.
fn nothing_holds(case: &CaseKeys<'_>) -> Option<Finding> {
    let b = case.ends.as_ref()?.b.as_ref()?;
    let loose =
        |end: &EndKeys<'_>| matches!(end.kind.get(), Some(EndKind::Payload | EndKind::Free));
    let shape = case
        .start
        .as_ref()
        .map_or(Some(StartShape::Equilibrium), |start| start.shape.value())?;
    let method = case
        .solver
        .as_ref()
        .map_or(Some(Method::Alpha), |solver| solver.method.value())?;
    let needed =
        shape == StartShape::Equilibrium || matches!(method, Method::Static | Method::Quasi);
    (needed && case.each_end().all(loose)).then(|| {
        let remedy = "hold one end (fixed, anchor or moving), or let a dynamic run begin with start.shape = \"straight\"";
        b.kind.finding("nothing holds the line, so it has no equilibrium", remedy)
    })
}
