//! What a reader must know of a system at rest beside its numbers.

use super::analysis::clearance::curves;
use super::displaced_twice::displaced_twice;
use super::line_at_rest::LineNote;
use super::loads::share_of_breaking_load;
use super::loads_without_effect::loads_without_effect;
use super::motion::responses::{MUCH_BEYOND, wave_response};
use super::off_nodes::off_nodes;
use super::potential_flow::wave_loads::energy_above;
use super::stability::{Stability, stability};
use super::{SolvedSystem, SystemFile};
use crate::case::Start;
use crate::scene::steep_waves;

/// What a reader must know beside the numbers.
#[must_use]
pub fn warnings(solved: &SolvedSystem) -> Vec<String> {
    let mut found = Vec::new();
    found.extend(solved.dropped.iter().map(|name| {
        format!("Nothing holds {name}: it is held where the file puts it, and let go there when it is computed in motion.")
    }));
    for (index, line) in solved.network.lines.iter().enumerate() {
        let at_rest = &solved.rest.balance.lines[index];
        match at_rest.note {
            Some(LineNote::WithoutFriction) => found.push(format!(
                "Line {} lies on the bed between two suspended parts: it is taken without friction, which there depends on how it was laid.",
                line.name
            )),
            Some(LineNote::ShapeUndetermined) => found.push(format!(
                "Line {} is weightless and slack: its shape is not determined, it pulls on nothing.",
                line.name
            )),
            Some(LineNote::NoEquilibrium) => found.push(format!(
                "Line {} has no equilibrium between its ends: it bears on nothing before it begins in the shape that it starts in.",
                line.name
            )),
            None => {}
        }
        if let Some(share) = share_of_breaking_load(&solved.network, &solved.rest, index)
            .filter(|share| *share > 1.0)
        {
            found.push(format!(
                "Line {} carries {:.0} % of its breaking load.",
                line.name,
                100.0 * share
            ));
        }
    }
    found.extend(friction_at_rest(solved));
    found.extend(left_unstable(solved));
    found.extend(displaced_twice(solved));
    found.extend(solved.errors.missing().map(|why| {
        format!("The errors by the mesh are not known: with twice the segments, {why}.")
    }));
    found.extend(unused_motion(solved));
    found.extend(unused_searches(solved));
    found.extend(on_waves(solved));
    found.extend(loads_without_effect(solved));
    found.extend(off_nodes(solved));
    found.extend(afloat(solved));
    found.extend(far_tilted(solved));
    found.extend(above_water(solved));
    found.extend(beyond_tables(solved));
    found
}

/// Lines that are stretched beyond the last row of the table of their material.
fn beyond_tables(solved: &SolvedSystem) -> Vec<String> {
    let mut found = Vec::new();
    let at_rest = solved.rest.balance.lines.iter();
    for (line, at_rest) in solved.network.lines.iter().zip(at_rest) {
        let tensions = at_rest.tensions();
        let greatest = tensions.into_iter().fold(0.0, f64::max);
        let tables = line.discretised.iter().flat_map(|line| {
            let materials = line.case().materials.values();
            materials.filter_map(|material| material.tension_n.as_ref()?.last().copied())
        });
        let least = tables.fold(f64::INFINITY, f64::min);
        if greatest > least {
            found.push(format!(
                "Line {} carries {:.4} kN, more than the last row of a table of its stiffness, {:.4} kN: beyond it the table goes on straight.",
                line.name,
                greatest / 1e3,
                least / 1e3
            ));
        }
    }
    found
}

/// The rule by which friction acts on lines that lie on the bed at rest, where there are any.
fn friction_at_rest(solved: &SolvedSystem) -> Option<String> {
    let lines = solved.network.lines.iter().zip(&solved.rest.balance.lines);
    let mut rough = lines.filter(|(line, at_rest)| {
        line.friction > 0.0
            && at_rest.on_bed() > 0.0
            && at_rest.note != Some(LineNote::WithoutFriction)
    });
    rough.next().map(|_| {
        "Friction on the bed is that of lines laid straight and then pulled: it takes tension off from the end that is pulled towards \
         the end that is held, from both towards the middle where neither is held, and not at all between two held ends."
            .to_owned()
    })
}

/// The unstable equilibrium that the search came to first.
fn left_unstable(solved: &SolvedSystem) -> Option<String> {
    let left = solved.rest.left.as_ref()?;
    let how = match stability(&solved.network, left) {
        Stability::Unstable(name) => format!(", in {name}"),
        Stability::Stable | Stability::Neutral(_) => String::new(),
    };
    Some(format!(
        "The equilibrium next to the poses given is unstable{how}: this one is where the system comes to when it is let go near it."
    ))
}

/// What makes a run in time of a system at rest.
const IN_TIME: &str = "a table [solver] with a `duration_s` and another method than `static` computes the system in time";

/// Keys of motion that have no effect: of a file that is not computed in time, or after its end.
fn unused_motion(solved: &SolvedSystem) -> Vec<String> {
    let end = solved.file.in_time().map(|solver| solver.duration_s);
    let mut found = Vec::new();
    let network = &solved.network;
    let moved = network.points.iter().filter(|point| point.motion.is_some());
    let moved = moved.map(|point| &point.name);
    let bodies = network.bodies.iter().filter(|body| body.motion.is_some());
    if end.is_none() {
        found.extend(unused_steps(&solved.file));
        for name in moved.chain(bodies.map(|body| &body.name)) {
            found.push(format!("{name} does not move: {IN_TIME}."));
        }
        for line in network.lines.iter().filter(|line| line.start.is_some()) {
            let name = &line.name;
            found.push(format!(
                "Line {name} is at rest: how it starts is of a run in time; {IN_TIME}."
            ));
        }
    }
    for line in &solved.file.lines {
        let by_tension = [line.release_a_n, line.release_b_n, line.break_n];
        let by_time = [line.release_a_s, line.release_b_s, line.break_s];
        let late = |time: &f64| end.is_none_or(|end| *time > end);
        let never = end.is_none() && by_tension.iter().any(Option::is_some);
        if never || by_time.iter().flatten().any(late) {
            found.push(format!(
                "Line {} is not released or broken as it states: the run ends before, or there is none.",
                line.name
            ));
        }
    }
    found
}

/// Where the search for the equilibrium of a line begins that has one alone.
fn unused_searches(solved: &SolvedSystem) -> Vec<String> {
    let (lines, network) = (&solved.file.lines, &solved.network);
    let searched = lines.iter().filter(|line| {
        let start = line.start.as_ref();
        start.is_some_and(Start::begins_search)
    });
    let is_closed = |name: &str| {
        let mut lines = network.lines.iter();
        lines.any(|line| line.name == name && line.discretised.is_none())
    };
    let closed = searched.filter(|line| is_closed(&line.name));
    let remark = |name: &str| {
        format!(
            "Line {name} has one equilibrium between its ends, its closed form: where its search begins has no effect."
        )
    };
    closed.map(|line| remark(&line.name)).collect()
}

/// Steps that a system at rest does not take.
fn unused_steps(file: &SystemFile) -> Vec<String> {
    let Some(solver) = &file.solver else {
        return Vec::new();
    };
    let given = [
        ("time_step_s", solver.time_step_s),
        ("longest_step_s", solver.longest_step_s),
    ];
    let given = given.into_iter().filter(|(_, step)| step.is_some());
    given
        .map(|(key, _)| {
            format!("`solver.{key}` has no effect: the method `static` takes no steps.")
        })
        .collect()
}

/// Waves that nothing is computed in, that break, that a table of responses does not cover, or that are missing.
fn on_waves(solved: &SolvedSystem) -> Vec<String> {
    let file = &solved.file;
    let Some(sea) = &solved.network.sea else {
        return loads_without_waves(file);
    };
    let mut found = Vec::new();
    if file.in_time().is_none() {
        found.push(format!("The waves have no effect at rest: {IN_TIME}."));
    }
    let bed = file.seabed.as_ref().map(|bed| bed.depth_m);
    let gravity = file.environment.gravity_m_per_s2;
    let steep = file
        .waves
        .iter()
        .filter_map(|waves| steep_waves(waves, bed, gravity));
    found.extend(steep);
    for (name, body) in &file.bodies {
        let flow = solved.network.body(name);
        let flow = flow.and_then(|number| solved.network.bodies[number].potential_flow.as_ref());
        let above = flow.map_or(0.0, |flow| energy_above(flow, sea));
        if above > MUCH_BEYOND {
            found.push(format!(
                "Body {name}: {:.0} % of the energy of the waves lies above the frequencies of its loads, and has none.",
                100.0 * above
            ));
        }
        let response = wave_response(file, body, sea).ok().flatten();
        if let Some(found_beyond) = response.filter(|found| found.energy_beyond > MUCH_BEYOND) {
            found.push(format!(
                "Body {name}: {:.0} % of the energy of the waves lies beyond the periods of its responses; the last ones hold there.",
                100.0 * found_beyond.energy_beyond
            ));
        }
    }
    found
}

/// Files of loads by waves, of which there are none.
fn loads_without_waves(file: &SystemFile) -> Vec<String> {
    let mut found = Vec::new();
    for (name, body) in &file.bodies {
        let named = [
            ("excitation_file", &body.excitation_file),
            ("drift_file", &body.drift_file),
        ];
        for (key, _) in named.iter().filter(|(_, file)| file.is_some()) {
            found.push(format!(
                "Body {name}: {key} has no effect without [[waves]]."
            ));
        }
    }
    found
}

/// Lines that rise out of the water, where they count as under water.
fn above_water(solved: &SolvedSystem) -> Vec<String> {
    if solved.network.density <= 0.0 || solved.network.crossed {
        return Vec::new();
    }
    let curves = curves(&solved.network, &solved.rest);
    let mut found = Vec::new();
    for (line, curve) in solved.network.lines.iter().zip(&curves) {
        let high = curve.iter().map(|place| place.z).fold(f64::MIN, f64::max);
        if high > 0.05 {
            found.push(format!(
                "Line {} rises {high:.1} m above the water and counts as under water there; environment.water_surface = \"crossed\" gives it its weight in air.",
                line.name
            ));
        }
    }
    found
}

/// Tilt of a body from the pose given beyond which its water-plane says little \[rad\].
const FAR_TILTED: f64 = 0.35;

/// Free bodies that tilted so far that their water-plane does not hold.
fn far_tilted(solved: &SolvedSystem) -> Vec<String> {
    let poses = &solved.rest.placement.bodies;
    let bodies = solved.network.bodies.iter().zip(poses);
    let free = bodies.filter(|(body, _)| body.turns() && body.waterplane.amax() > 0.0);
    let tilts = free.map(|(body, pose)| (body, body.tilt(pose)));
    tilts
        .filter(|(_, tilt)| *tilt > FAR_TILTED)
        .map(|(body, tilt)| {
            format!(
                "Body {} rests tilted by {:.0} deg from the pose given, for which its water-plane holds: give a pose nearer to where it rests, or members.",
                body.name,
                tilt.to_degrees()
            )
        })
        .collect()
}

/// Points that float at the surface.
fn afloat(solved: &SolvedSystem) -> Vec<String> {
    let numbered = solved.network.points.iter().enumerate();
    let floating = numbered.filter(|(index, _)| solved.is_afloat(*index));
    floating
        .map(|(_, point)| {
            format!(
                "Point {} floats at the surface, part of its volume out of the water.",
                point.name
            )
        })
        .collect()
}
