//! Static analysis of a ship in tables and a chart: equilibrium headings, dynamic stability, loads, mooring line.

use std::f64::consts::PI;

use nalgebra::Complex;

use seacable_base::number::{digits, si};
use seacable_display::chart::{Axis, Chart, LimitLine, ReferenceLine, Series};
use seacable_display::table::{Align, Cell, CellStyle, NumberFormat, Table};
use seacable_systems::ship::loads::PlanarLoad;
use seacable_systems::ship::mooring::MooringSolution;
use seacable_systems::ship::stability::{DynamicStability, PlanarDynamics};
use seacable_systems::ship::yaw_equilibria::YawStability;
use seacable_systems::ship::{MooredEquilibrium, StaticAnalysis};

/// Points of a curve over all headings.
const POINTS: u32 = 720;

const DEGREES: NumberFormat = NumberFormat::With(degrees);
const SECONDS: NumberFormat = NumberFormat::Si("s");
const FORCE: NumberFormat = NumberFormat::Si("N");
const MOMENT: NumberFormat = NumberFormat::Si("N m");
const STIFFNESS: NumberFormat = NumberFormat::Si("N/m");

/// An angle \[rad\] as text: `-12.3 deg`.
fn degrees(radians: f64) -> String {
    format!("{} deg", digits(radians.to_degrees(), 5))
}

/// Moment about the mooring point against heading, of each load and in total, with every equilibrium marked.
#[must_use]
pub fn moments(statics: &StaticAnalysis) -> Chart {
    let loads = &statics.loads;
    let curve = |label: &str, slot: usize, moment: &dyn Fn(f64) -> f64| {
        let heading = |i: u32| -PI + 2.0 * PI * f64::from(i) / f64::from(POINTS);
        let points = (0..=POINTS).map(|i| (heading(i).to_degrees(), moment(heading(i))));
        Series::new(label, slot, points.collect())
    };
    let mut series = vec![curve("total", 0, &|heading| loads.moment(heading).0)];
    series.extend(loads.each.iter().enumerate().map(|(i, load)| {
        curve(load.name, i + 1, &|heading| {
            let (value, _) = load.at(heading);
            value[2] - value[1] * loads.arm
        })
    }));
    let title = "Moment about the mooring point; zero at equilibrium";
    let heading = Axis::new("heading", "deg").over((-180.0, 180.0));
    Chart {
        limits: marks(statics),
        ..Chart::new(title, heading, Axis::new("moment", "N m"), series)
    }
}

fn marks(statics: &StaticAnalysis) -> Vec<ReferenceLine> {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    let headings = equilibria.iter().map(|one| {
        let heading = LimitLine::Vertical(one.yaw.heading.to_degrees());
        ReferenceLine::new(one.yaw.stability.label(), heading)
    });
    std::iter::once(ReferenceLine::new("", LimitLine::Horizontal(0.0)))
        .chain(headings)
        .collect()
}

/// The equilibrium headings with their stability and mooring line.
#[must_use]
pub fn headings(statics: &StaticAnalysis) -> Table {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    Table::of_records("Equilibrium headings (eqs. 1 and 2)", equilibria)
        .number("heading", DEGREES, |one| one.yaw.heading)
        .cell("static stability", Align::Left, |one| static_stability(one.yaw.stability))
        .cell("dynamic stability", Align::Left, |one| dynamic_stability(one.dynamic_stability()))
        .number("yaw stiffness", NumberFormat::Si("N m/rad"), |one| one.yaw.yaw_stiffness)
        .number("pull", FORCE, |one| one.yaw.pull)
        .number("bow towards", DEGREES, |one| one.yaw.force_direction)
        .number("bow from anchor", NumberFormat::Si("m"), |one| Some(line(one)?.distance))
        .number("stiffness along", STIFFNESS, |one| Some(line(one)?.stiffness_along))
        .number("stiffness across", STIFFNESS, |one| Some(line(one)?.stiffness_across))
        .build()
        .noted(heading_warnings(statics))
        .noted([
            "Headings of the bow, from +x towards +y. The list is complete: between neighbouring roots the moment about the mooring point keeps its sign, by a bound of its second derivative.",
            "Static stability: the stiffness of the mooring line along and across, and -dM/dpsi in yaw, are all positive. Dynamic stability, which excludes fishtailing, needs [hull] and [mooring].",
        ])
}

/// The solved mooring line of an equilibrium.
fn line(one: &MooredEquilibrium) -> Option<&MooringSolution> {
    one.line.as_ref()?.as_ref().ok()
}

fn heading_warnings(statics: &StaticAnalysis) -> Vec<String> {
    let equilibria = match &statics.equilibria {
        Ok(equilibria) => equilibria,
        Err(error) => return vec![format!("No equilibrium heading: {error}.")],
    };
    if statics.ship.mooring.is_none() {
        return vec!["No mooring line is given.".to_owned()];
    }
    let warning = |one: &MooredEquilibrium| {
        let error = one.line.as_ref()?.as_ref().err()?;
        Some(format!(
            "WARNING: at {}: {error}.",
            degrees(one.yaw.heading)
        ))
    };
    equilibria.iter().filter_map(warning).collect()
}

fn static_stability(stability: YawStability) -> Cell {
    let ink = match stability {
        YawStability::Stable => CellStyle::Good,
        YawStability::Unstable => CellStyle::Dim,
        YawStability::SemiStable | YawStability::Neutral => CellStyle::Warn,
    };
    Cell::new(stability.label(), ink)
}

fn dynamic_stability(stability: Option<DynamicStability>) -> Cell {
    let Some(stability) = stability else {
        return Cell::none();
    };
    let ink = match stability {
        DynamicStability::Stable { .. } => CellStyle::Good,
        DynamicStability::Neutral => CellStyle::Warn,
        DynamicStability::Divergence { .. } | DynamicStability::Fishtailing { .. } => {
            CellStyle::Bad
        }
    };
    Cell::new(stability.label(), ink)
}

/// Eigenvalues and stability about every equilibrium; absent without hull and mooring.
#[must_use]
pub fn eigenvalues(statics: &StaticAnalysis) -> Option<Table> {
    let equilibria = statics.equilibria.as_ref().ok()?;
    equilibria.iter().find(|one| one.dynamics.is_some())?;
    let times = |one: &MooredEquilibrium| one.dynamic_stability().map(DynamicStability::times);
    let roots = |one: &MooredEquilibrium| {
        let roots = one.dynamics.as_ref().and_then(PlanarDynamics::eigenvalues);
        roots.map_or_else(|| "-".to_owned(), |roots| complex(&roots))
    };
    let table = Table::of_records("Dynamic stability of each heading (eq. 4 in the horizontal plane)", equilibria)
        .number("heading", DEGREES, |one| one.yaw.heading)
        .cell("dynamic stability", Align::Left, |one| dynamic_stability(one.dynamic_stability()))
        .number("period", SECONDS, |one| times(one)?.0)
        .number("half or double", SECONDS, |one| times(one)?.1)
        .text("eigenvalues [1/s]", roots)
        .build()
        .noted([
            "Surge, sway and yaw linearised: mass and added mass, damping of the hull and of wind and current on the moving ship, stiffness of the line and of loads that vary with the heading. The period, and the time to half or double the amplitude, are those of the mode that grows fastest or decays slowest; without period it is overdamped.",
            "Fishtailing: oscillations that grow until nonlinearity limits them. Damping by the yaw rate in the current is not in the coefficients; hull.damping_si gives it.",
        ]);
    Some(table)
}

/// Eigenvalues as text, a conjugate pair once.
fn complex(roots: &[Complex<f64>]) -> String {
    let upper = roots.iter().filter(|root| root.im >= 0.0).map(|root| {
        if root.im > 1e-9 * root.norm() {
            format!("{} ± {}i", digits(root.re, 3), digits(root.im, 3))
        } else {
            digits(root.re, 3)
        }
    });
    upper.collect::<Vec<_>>().join(", ")
}

/// Environmental loads at the governing equilibrium.
#[must_use]
pub fn loads(statics: &StaticAnalysis) -> Option<Table> {
    let heading = statics.governing()?.yaw.heading;
    let loads = &statics.loads;
    let each = loads
        .each
        .iter()
        .map(|load| (load.name, load.at(heading).0));
    let total = ("total", loads.total(heading).0);
    let rows: Vec<(&str, PlanarLoad)> = each.chain([total]).collect();
    // At equilibrium the total moment vanishes but for rounding.
    let rounding = 1e-6 * loads.moment_bound();
    let about_mooring = |(name, load): &(&str, PlanarLoad)| {
        let moment = load[2] - load[1] * loads.arm;
        let vanishes = *name == "total" && moment.abs() < rounding;
        if vanishes { 0.0 } else { moment }
    };
    let table = Table::of_records(
        format!("Environmental loads at {}", degrees(heading)),
        &rows,
    )
    .text("load", |row| row.0)
    .number("surge", FORCE, |row| row.1[0])
    .number("sway", FORCE, |row| row.1[1])
    .number("yaw, about the centre", MOMENT, |row| row.1[2])
    .number("yaw, about the mooring", MOMENT, about_mooring)
    .build()
    .noted([format!(
        "The mooring point is {} forward of the ship's centre.",
        si(loads.arm, "m")
    )]);
    Some(table)
}

/// The mooring line at the governing equilibrium.
#[must_use]
pub fn mooring(statics: &StaticAnalysis) -> Option<Table> {
    let equilibrium = statics.governing()?;
    let line = line(equilibrium)?;
    let [bow, centre] = equilibrium.positions(statics.loads.arm)?;
    let position = |(x, y): (f64, f64)| format!("x {} m, y {} m", digits(x, 4), digits(y, 4));
    let facts = [
        ("horizontal pull", si(equilibrium.yaw.pull, "N")),
        ("tension at the fairlead", si(line.tension, "N")),
        ("angle below the horizontal", degrees(line.angle)),
        ("length on the seabed", si(line.grounded_length, "m")),
        ("mooring point from the anchor", position(bow)),
        ("ship's centre from the anchor", position(centre)),
    ];
    let uplift = (line.anchor_uplift > 0.0).then(|| {
        format!(
            "WARNING: vertical force on the anchor: {}; a drag anchor may drag.",
            si(line.anchor_uplift, "N")
        )
    });
    let title = format!("Mooring line at {}", degrees(equilibrium.yaw.heading));
    let table = Table::of_records(title, &facts)
        .text("quantity", |fact| fact.0)
        .text("value", |fact| fact.1.clone())
        .build()
        .noted(uplift);
    Some(table)
}
