//! A system at rest in tables: lines, points, bodies and their stiffness.

use seacable_display::table::{Align, Cell, Column, NumberFormat, Table};
use seacable_numerics::V3;
use seacable_systems::system::SolvedSystem;
use seacable_systems::system::bounds::Contact;
use seacable_systems::system::loads;
use seacable_systems::system::network::{Body, Held};
use seacable_systems::system::stability::Stability;

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
        match (solved.is_discretised(), solved.file.is_run_at_rest()) {
            (true, true) => "lines are divided into segments",
            (true, false) =>
                "lines in a current or with bending stiffness are divided into segments, others exact catenaries",
            (false, _) => "exact elastic catenaries in still water",
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
        .in_time()
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
    let table = Table::of_records("Lines at rest", &numbers)
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
    Table::of_records("Lines at rest", &numbers)
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
    Table::of_records("Points", &numbers)
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
    let table = Table::of_records("Bodies", &numbers)
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
