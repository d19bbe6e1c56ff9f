//! A system at rest in tables: lines, points, bodies and their stiffness; what is to be noted.

use super::displaced_twice::displaced_twice;
use seacable_display::table::{Align, Cell, Column, NumberFormat, Table};
use seacable_engine::scene::steep_waves;
use seacable_numerics::V3;
use seacable_systems::system::analysis::clearance::curves;
use seacable_systems::system::bounds::Contact;
use seacable_systems::system::line_at_rest::LineNote;
use seacable_systems::system::loads;
use seacable_systems::system::loads_without_effect::loads_without_effect;
use seacable_systems::system::motion::responses::{MUCH_BEYOND, wave_response};
use seacable_systems::system::network::{Body, Held};
use seacable_systems::system::potential_flow::wave_loads::energy_above;
use seacable_systems::system::stability::{Stability, stability as rests};
use seacable_systems::system::{SolvedSystem, SystemFile};

const NEWTONS: NumberFormat = NumberFormat::Si("N");
const METRES: NumberFormat = NumberFormat::Decimals(3, "m");
const DEGREES: NumberFormat = NumberFormat::Decimals(2, "deg");
const SHORT: NumberFormat = NumberFormat::Digits(2, "m");
const SMALL_ANGLE: NumberFormat = NumberFormat::Digits(2, "deg");

/// A line with its number.
type Numbered = usize;

/// The system in a sentence: how it rests, how exactly, at what cost.
#[must_use]
pub fn summary(solved: &SolvedSystem) -> String {
    let (network, rest) = (&solved.network, &solved.rest);
    if network.lines.is_empty() {
        return format!(
            "{} bodies at rest without lines. {} Forces out of balance {}; {} steps.",
            network.bodies.len(),
            stability(solved),
            NEWTONS.write(rest.residual),
            rest.steps,
        ) + &in_motion(solved);
    }
    let share = rest.residual / rest.balance.tension.max(f64::MIN_POSITIVE);
    format!(
        "{} lines, {} points, {} bodies at rest: {}. {} Forces out of balance {}, {share:.1e} of the greatest tension; {} steps, {} evaluations of all lines.",
        network.lines.len(),
        network.points.len(),
        network.bodies.len(),
        if solved.is_discretised() {
            "lines in a current or with bending stiffness are divided into segments, others exact catenaries"
        } else {
            "exact elastic catenaries in still water"
        },
        stability(solved),
        NEWTONS.write(rest.residual),
        rest.steps,
        rest.evaluations,
    ) + &in_motion(solved)
}

/// The run in time that begins here, in a sentence; nothing where the file has none.
fn in_motion(solved: &SolvedSystem) -> String {
    solved
        .file
        .solver
        .as_ref()
        .map_or_else(String::new, |solver| {
            format!(
                " This is where it starts: `R` on the screen or `seacable run` computes it in motion for {} s.",
                solver.duration_s
            )
        })
}

/// What the lines gained and lost, in a sentence; nothing where they are new.
#[must_use]
pub fn ageing(solved: &SolvedSystem) -> Option<String> {
    let age = solved.age.as_ref()?;
    let plural = |count: usize| if count == 1 { "" } else { "s" };
    Some(format!(
        "Lines after {} years: marine growth up to {:.1} mm thick, loss of diameter up to {:.2} mm; their depths settled to {:.1e} m in {} round{}.",
        age.years,
        1e3 * age.growth_m,
        1e3 * age.loss_m,
        age.moved_m,
        age.rounds,
        plural(age.rounds),
    ))
}

fn stability(solved: &SolvedSystem) -> String {
    match &solved.stability {
        Stability::Stable => "The equilibrium is stable.".to_owned(),
        Stability::Neutral(name) => {
            // With bodies held the energy is convex: states of the same energy have the same tensions.
            let turns = solved.network.bodies.iter().any(Body::turns);
            let same = match turns {
                true => "",
                false => "; the tensions are the same all along",
            };
            format!("The equilibrium is neutral: nothing resists a small motion in {name}{same}.")
        }
        Stability::Unstable(name) => format!("The equilibrium is unstable: it leaves in {name}."),
    }
}

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
            None => {}
        }
        if let Some(share) = greatest_share(solved, index).filter(|share| *share > 1.0) {
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
    found.extend(on_waves(solved));
    found.extend(loads_without_effect(solved));
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
    let how = match rests(&solved.network, left) {
        Stability::Unstable(name) => format!(", in {name}"),
        Stability::Stable | Stability::Neutral(_) => String::new(),
    };
    Some(format!(
        "The equilibrium next to the poses given is unstable{how}: this one is where the system comes to when it is let go near it."
    ))
}

/// Keys of motion that have no effect: of a file that is not computed in time, or after its end.
fn unused_motion(solved: &SolvedSystem) -> Vec<String> {
    let end = solved.file.solver.as_ref().map(|solver| solver.duration_s);
    let mut found = Vec::new();
    let network = &solved.network;
    let moved = network.points.iter().filter(|point| point.motion.is_some());
    let moved = moved.map(|point| &point.name);
    let bodies = network.bodies.iter().filter(|body| body.motion.is_some());
    if end.is_none() {
        for name in moved.chain(bodies.map(|body| &body.name)) {
            found.push(format!(
                "{name} does not move: the file has no table [solver] with a `duration_s`."
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

/// Waves that nothing is computed in, that break, that a table of responses does not cover, or that are missing.
fn on_waves(solved: &SolvedSystem) -> Vec<String> {
    let file = &solved.file;
    let Some(sea) = &solved.network.sea else {
        return loads_without_waves(file);
    };
    let mut found = Vec::new();
    if file.solver.is_none() {
        found.push(
            "The waves have no effect at rest: add a table [solver] with a `duration_s`."
                .to_owned(),
        );
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

/// The greatest share of its breaking load that a line carries; nothing where no section states one.
fn greatest_share(solved: &SolvedSystem, line: usize) -> Option<f64> {
    loads::share_of_breaking_load(&solved.network, &solved.rest, line)
}

/// Elevation of a force above the horizontal \[deg\]; nothing without force.
fn elevation(force: &V3) -> Option<f64> {
    let horizontal = force.xy().norm();
    (force.norm() > 0.0).then(|| force.z.atan2(horizontal).to_degrees())
}

/// The lines: tensions and angles at both ends, length on the bed, uplift of an end that is held, share of breaking load.
#[must_use]
pub fn lines(solved: &SolvedSystem) -> Table {
    let network = &solved.network;
    let numbers: Vec<Numbered> = (0..network.lines.len()).collect();
    let at_rest = |k: &Numbered| &solved.rest.balance.lines[*k];
    let name = |point: usize| network.points[point].name.as_str();
    let table = Table::of("Lines at rest", &numbers)
        .text("line", |k| format!("{} {}", k + 1, network.lines[*k].name))
        .text("from", |k| name(network.lines[*k].from))
        .text("to", |k| name(network.lines[*k].to))
        .number("tension at from", NEWTONS, |k| at_rest(k).tensions()[0])
        .number("angle", DEGREES, |k| elevation(&at_rest(k).force_a))
        .number("tension at to", NEWTONS, |k| at_rest(k).tensions()[1])
        .number("angle", DEGREES, |k| elevation(&at_rest(k).force_b))
        .number("on the bed", METRES, |k| at_rest(k).on_bed())
        .number("error", NEWTONS, |k| solved.errors.lines[*k]);
    let has_breaks = numbers.iter().any(|k| greatest_share(solved, *k).is_some());
    let table = if has_breaks {
        table.number("of breaking load", NumberFormat::Percent, |k| {
            greatest_share(solved, *k)
        })
    } else {
        table
    };
    table.build().noted(vec![
        "Angles of the pull of a line on its end above the horizontal.".to_owned(),
    ])
}

/// The lines beside a view on a narrow screen: tensions, length on the bed, share of breaking load.
#[must_use]
pub fn lines_beside(solved: &SolvedSystem) -> Table {
    let network = &solved.network;
    let numbers: Vec<Numbered> = (0..network.lines.len()).collect();
    let at_rest = |k: &Numbered| &solved.rest.balance.lines[*k];
    Table::of("Lines at rest", &numbers)
        .text("line", |k| format!("{} {}", k + 1, network.lines[*k].name))
        .number("at from", NEWTONS, |k| at_rest(k).tensions()[0])
        .number("at to", NEWTONS, |k| at_rest(k).tensions()[1])
        .number("on bed", METRES, |k| at_rest(k).on_bed())
        .number("of break", NumberFormat::Percent, |k| {
            greatest_share(solved, *k)
        })
        .number("error", NEWTONS, |k| solved.errors.lines[*k])
        .build()
}

/// The points: what holds them, where they are, and the force that holds or bears them.
#[must_use]
pub fn points(solved: &SolvedSystem) -> Table {
    let network = &solved.network;
    let rest = &solved.rest;
    let numbers: Vec<usize> = (0..network.points.len()).collect();
    let place = |k: &usize| rest.placement.points[*k];
    let pulls = loads::pulls(network, rest);
    let finer = solved.errors.finer();
    let finer_pulls = finer.map(|finer| loads::pulls(&finer.network, &finer.rest));
    let force = balanced(solved);
    Table::of("Points", &numbers)
        .text("point", |k| network.points[*k].name.as_str())
        .text("held", |k| held(solved, *k))
        .number("x", METRES, |k| place(k).x)
        .number("y", METRES, |k| place(k).y)
        .number("z", METRES, |k| place(k).z)
        .number("pull of the lines", NEWTONS, |k| force(pulls[*k].norm()))
        .number("upwards", NEWTONS, |k| force(pulls[*k].z))
        .when(solved.is_discretised(), |table| {
            table
                .number("error of place", SHORT, |k| solved.errors.points[*k])
                .number("error of pull", NEWTONS, |k| {
                    let change = pulls[*k] - finer_pulls.as_ref()?[*k];
                    Some(finer?.error(change.norm()) + solved.rest.residual)
                })
        })
        .build()
}

/// A force as it is shown: what the search leaves out of balance, or rounding, is nothing.
fn balanced(solved: &SolvedSystem) -> impl Fn(f64) -> f64 + '_ {
    let rounding = 1e-12 * solved.rest.balance.tension;
    let least = solved.rest.residual.max(rounding);
    move |force| if force.abs() <= least { 0.0 } else { force }
}

fn held(solved: &SolvedSystem, point: usize) -> String {
    match &solved.network.points[point].held {
        Held::At(_) => "fixed".to_owned(),
        Held::On(body, _) => format!("on {}", solved.network.bodies[*body].name),
        Held::Free(_) if solved.is_afloat(point) => "afloat".to_owned(),
        Held::Free(_) => match solved.rest.contact(point) {
            Contact::None | Contact::Pin => "free",
            Contact::Bed => "on the bed",
            Contact::Surface => "afloat",
        }
        .to_owned(),
    }
}

/// What holds a body, in a word.
#[must_use]
pub fn hold_of(body: &Body) -> &'static str {
    match (body.free, body.pinned) {
        (true, _) => "free",
        (false, true) => "pinned",
        (false, false) => "held",
    }
}

/// The bodies: pose, force of the lines, and of their pins where any is pinned.
#[must_use]
pub fn bodies(solved: &SolvedSystem) -> Table {
    let network = &solved.network;
    let numbers: Vec<usize> = (0..network.bodies.len()).collect();
    let pose = |k: &usize| &solved.rest.placement.bodies[*k];
    let angle = |k: &usize, axis: usize| pose(k).angles()[axis].to_degrees();
    let loads: Vec<(V3, V3)> = numbers
        .iter()
        .map(|k| loads::on_body(network, &solved.rest, *k))
        .collect();
    let force = balanced(solved);
    let table = Table::of("Bodies", &numbers)
        .text("body", |k| network.bodies[*k].name.as_str())
        .text("held", |k| hold_of(&network.bodies[*k]))
        .number("x", METRES, |k| pose(k).origin.x)
        .number("y", METRES, |k| pose(k).origin.y)
        .number("z", METRES, |k| pose(k).origin.z)
        .number("roll", DEGREES, |k| angle(k, 0))
        .number("pitch", DEGREES, |k| angle(k, 1))
        .number("yaw", DEGREES, |k| angle(k, 2))
        .number("lines x", NEWTONS, |k| force(loads[*k].0.x))
        .number("lines y", NEWTONS, |k| force(loads[*k].0.y))
        .number("lines z", NEWTONS, |k| force(loads[*k].0.z))
        .when(solved.is_discretised(), |table| {
            let error = |k: &usize| solved.errors.bodies[*k];
            table
                .number("error of place", SHORT, move |k| {
                    error(k).map(|[place, _]| place)
                })
                .number("error of angles", SMALL_ANGLE, move |k| {
                    error(k).map(|[_, turn]| turn.to_degrees())
                })
        });
    if !network.bodies.iter().any(|body| body.pinned) {
        return table.build();
    }
    let pin = |k: &usize, axis: usize| {
        let at_pin = loads::of_pin(network, &solved.rest, *k);
        at_pin.map_or(f64::NAN, |at_pin| force(at_pin[axis]))
    };
    table
        .number("pin x", NEWTONS, |k| pin(k, 0))
        .number("pin y", NEWTONS, |k| pin(k, 1))
        .number("pin z", NEWTONS, |k| pin(k, 2))
        .build()
}

/// The stiffness of the lines on a body, six by six.
#[must_use]
pub fn stiffness(solved: &SolvedSystem, body: usize) -> Table {
    const NAMES: [&str; 6] = ["surge", "sway", "heave", "roll", "pitch", "yaw"];
    let name = &solved.network.bodies[body].name;
    let matrix = &solved.stiffness[body];
    let greatest = |rows: std::ops::Range<usize>, columns: std::ops::Range<usize>| {
        let inner = rows.flat_map(|i| columns.clone().map(move |j| (i, j)));
        inner.map(|at| matrix[at].abs()).fold(0.0, f64::max)
    };
    let block = |k: usize| if k < 3 { 0..3 } else { 3..6 };
    let cell = |i: usize, j: usize| {
        let value = matrix[(i, j)];
        // What is rounding beside the others of its block is shown as nothing.
        if value.abs() <= 1e-9 * greatest(block(i), block(j)) {
            return Cell::plain("0");
        }
        Cell::plain(format!("{value:.4e}"))
    };
    let mut columns = vec![Column {
        head: "force by motion".to_owned(),
        align: Align::Left,
    }];
    columns.extend(NAMES.iter().map(|name| Column {
        head: (*name).to_owned(),
        align: Align::Right,
    }));
    let rows = (0..6).map(|i| {
        let mut row = vec![Cell::plain(NAMES[i])];
        row.extend((0..6).map(|j| cell(i, j)));
        row
    });
    Table {
        title: format!("Stiffness of the lines on {name}, about its origin [N/m, N, N m]"),
        columns,
        rows: rows.collect(),
        notes: vec![
            "Exact: the tangent of the whole system condensed onto the body; axes of the earth."
                .to_owned(),
        ],
    }
}
