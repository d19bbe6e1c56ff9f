//! A ship at rest in tables.

use nalgebra::Complex;

use crate::report::number::{digits, si};
use crate::report::table::{Cell, CellInk, Column, Table};
use crate::ship::loads::PlanarLoad;
use crate::ship::mooring::MooringSolution;
use crate::ship::stability::{self, DynamicStability};
use crate::ship::yaw_equilibria::YawStability;
use crate::ship::{Equilibrium, StaticAnalysis};

/// The headings in balance.
#[must_use]
pub fn headings(statics: &StaticAnalysis) -> Table {
    let mut notes = vec![
        "Headings are where the bow points, from +x towards +y. All zeros of the moment about the mooring point are here: between them the moment is proven to keep its sign, by a bound of its second derivative.".to_owned(),
        "The eigenvalues of the stiffness at the mooring point are those of the line along and across, and -dM/dpsi in yaw; at rest the ship stays where all are positive. Whether it also stays once it moves is told by the small motions, which need [hull] and [mooring]: a ship that fishtails swings further and further.".to_owned(),
    ];
    let rows = match &statics.equilibria {
        Ok(equilibria) => equilibria
            .iter()
            .map(|one| heading_row(statics, one))
            .collect(),
        Err(why) => {
            notes.insert(0, format!("No heading in balance: {why}."));
            Vec::new()
        }
    };
    Table {
        title: "Headings in balance (eqs. 1 and 2)".to_owned(),
        columns: vec![
            Column::decimal("heading"),
            Column::left("at rest"),
            Column::left("small motions"),
            Column::decimal("yaw stiffness"),
            Column::decimal("pull"),
            Column::decimal("drifts towards"),
            Column::decimal("bow from anchor"),
            Column::decimal("line along"),
            Column::decimal("line across"),
        ],
        rows,
        notes,
    }
}

fn heading_row(statics: &StaticAnalysis, one: &Equilibrium) -> Vec<Cell> {
    let balance = &one.yaw;
    let ink = match balance.stability {
        YawStability::Stable => CellInk::Good,
        YawStability::Unstable => CellInk::Dim,
        YawStability::OneSided | YawStability::Indifferent => CellInk::Warn,
    };
    let mut cells = vec![
        Cell::plain(degrees(balance.heading)),
        Cell::new(balance.stability.label(), ink),
        fate_cell(one.dynamic_stability()),
        Cell::plain(si(balance.yaw_stiffness, "N m/rad")),
        Cell::plain(si(balance.pull, "N")),
        Cell::plain(degrees(balance.force_direction)),
    ];
    match &one.reach {
        Some(Ok(reach)) => cells.extend([
            Cell::plain(si(reach.distance, "m")),
            Cell::plain(si(reach.along, "N/m")),
            Cell::plain(si(reach.across, "N/m")),
        ]),
        Some(Err(why)) => cells.push(Cell::new(why.to_string(), CellInk::Bad)),
        None if statics.ship.mooring.is_none() => cells.push(Cell::plain("no mooring line given")),
        None => {}
    }
    cells
}

fn fate_cell(dynamic_stability: Option<DynamicStability>) -> Cell {
    let ink = match dynamic_stability {
        None => CellInk::Dim,
        Some(DynamicStability::Stable { .. }) => CellInk::Good,
        Some(DynamicStability::Neutral) => CellInk::Warn,
        Some(DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. }) => {
            CellInk::Bad
        }
    };
    Cell::new(dynamic_stability.map_or("-", DynamicStability::label), ink)
}

/// What becomes of small motions about every heading; absent without hull and mooring.
#[must_use]
pub fn small_motions(statics: &StaticAnalysis) -> Option<Table> {
    let equilibria = statics.equilibria.as_ref().ok()?;
    if !equilibria.iter().any(|one| one.planar.is_some()) {
        return None;
    }
    let row = |one: &Equilibrium| {
        let dynamic_stability = one.dynamic_stability();
        let (period, time) = dynamic_stability.map_or((None, None), DynamicStability::times);
        let seconds =
            |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| si(value, "s"));
        let roots = one
            .planar
            .as_ref()
            .and_then(stability::PlanarDynamics::eigenvalues);
        vec![
            Cell::plain(degrees(one.yaw.heading)),
            fate_cell(dynamic_stability),
            Cell::plain(seconds(period)),
            Cell::plain(seconds(time)),
            Cell::plain(roots.map_or_else(|| "-".to_owned(), |list| words_of(&list))),
        ]
    };
    Some(Table {
        title: "Small motions about each heading (eq. 4 in the plane)".to_owned(),
        columns: vec![
            Column::decimal("heading"),
            Column::left("small motions"),
            Column::decimal("period"),
            Column::decimal("half or double"),
            Column::left("eigenvalues [1/s]"),
        ],
        rows: equilibria.iter().map(row).collect(),
        notes: vec![
            "Surge, sway and yaw linearised: mass and added mass, damping of the hull and of wind and current on the moving ship, stiffness of the line and of loads that turn with the ship. The period is that of the motion that grows fastest or dies last, beside its time to half or to double the amplitude; no period: it creeps.".to_owned(),
            "Fishtailing: swings that grow until what is not linear holds them. What turning alone makes of the current is not in the coefficients; hull.damping_si has it.".to_owned(),
        ],
    })
}

/// Eigenvalues in words, a pair once.
fn words_of(list: &[Complex<f64>]) -> String {
    let told = list.iter().filter(|l| l.im >= 0.0).map(|l| {
        if l.im > 1e-9 * l.norm() {
            format!("{} ± {}i", digits(l.re, 3), digits(l.im, 3))
        } else {
            digits(l.re, 3)
        }
    });
    told.collect::<Vec<_>>().join(", ")
}

/// What acts on the ship at its heading.
#[must_use]
pub fn loads(statics: &StaticAnalysis) -> Option<Table> {
    let equilibrium = statics.governing()?;
    let heading = equilibrium.yaw.heading;
    let arm = statics.loads.arm;
    let row = |name: &str, load: PlanarLoad| {
        vec![
            Cell::plain(name),
            Cell::plain(si(load[0], "N")),
            Cell::plain(si(load[1], "N")),
            Cell::plain(si(load[2], "N m")),
            Cell::plain(si(load[2] - load[1] * arm, "N m")),
        ]
    };
    let mut rows: Vec<Vec<Cell>> = statics
        .loads
        .each
        .iter()
        .map(|load| row(load.name, load.at(heading).0))
        .collect();
    let (total, _) = statics.loads.total(heading);
    let mut last = row("together", total);
    // The total vanishes but for rounding.
    let nothing = 1e-6 * statics.loads.moment_bound();
    if let Some(cell) = last.last_mut()
        && (total[2] - total[1] * arm).abs() < nothing
    {
        *cell = Cell::plain("0 N m");
    }
    rows.push(last);
    Some(Table {
        title: format!("What acts on the ship at {}", degrees(heading)),
        columns: vec![
            Column::left("load"),
            Column::decimal("forward"),
            Column::decimal("to port"),
            Column::decimal("yaw, about the centre"),
            Column::decimal("yaw, about the mooring"),
        ],
        rows,
        notes: vec![format!(
            "The mooring holds the ship {} forward of its centre.",
            si(arm, "m")
        )],
    })
}

/// The mooring line at the ship's heading.
#[must_use]
pub fn mooring(statics: &StaticAnalysis) -> Option<Table> {
    let equilibrium = statics.governing()?;
    let reach = equilibrium.reach.as_ref()?.as_ref().ok()?;
    let [bow, centre] = equilibrium.offset(statics.loads.arm)?;
    let place = |(x, y): (f64, f64)| format!("x {} m, y {} m", digits(x, 4), digits(y, 4));
    let fact = |name: &str, value: String| vec![Cell::plain(name), Cell::plain(value)];
    Some(Table {
        title: format!("The mooring line at {}", degrees(equilibrium.yaw.heading)),
        columns: vec![Column::left("quantity"), Column::left("value")],
        rows: vec![
            fact("horizontal pull", si(equilibrium.yaw.pull, "N")),
            fact("tension at the ship", si(reach.tension, "N")),
            fact("angle below the horizontal", degrees(reach.angle)),
            fact("length on the bed", si(reach.grounded_length, "m")),
            fact("mooring point from the anchor", place(bow)),
            fact("ship's centre from the anchor", place(centre)),
        ],
        notes: lifted(reach),
    })
}

fn lifted(reach: &MooringSolution) -> Vec<String> {
    if reach.anchor_uplift > 0.0 {
        return vec![format!(
            "WARNING: the line lifts its anchor with {}; an anchor that is lifted may drag.",
            si(reach.anchor_uplift, "N")
        )];
    }
    Vec::new()
}

/// An angle for people: `-12.3 deg`.
pub(super) fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 5))
}
