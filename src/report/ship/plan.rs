//! Plan view of a ship: its anchor, every equilibrium position, and the directions of wind, current and waves.

use seacable_display::chart::{Axis, Chart, Outline, Series, extent};
use seacable_systems::ship::loads::EnvironmentalLoad;
use seacable_systems::ship::yaw_equilibria::YawStability;
use seacable_systems::ship::{MooredEquilibrium, StaticAnalysis};

/// Breadth of the drawn outline as a fraction of the length.
const BREADTH: f64 = 0.18;

/// Tails and heads of the arrows of the flows, as fractions of the radius of the picture.
const TAIL: f64 = 1.35;
const HEAD: f64 = 1.02;

/// The ship at every equilibrium, in metres from the anchor, +x to the right; all but the chosen one dimmed.
#[must_use]
pub fn chart(statics: &StaticAnalysis, chosen: usize) -> Chart {
    let equilibria = statics.equilibria.as_deref().unwrap_or_default();
    let mut series = Vec::new();
    for (i, equilibrium) in equilibria.iter().enumerate() {
        let label = format!(
            "{} {:.1} deg {}",
            i + 1,
            equilibrium.yaw.heading.to_degrees(),
            stability(equilibrium)
        );
        series.push(Series {
            dimmed: i != chosen,
            ..Series::new(&label, i, ship(statics, equilibrium))
        });
    }
    let frame = DrawnExtent::of_ships(&series, statics.ship.ship.length_m);
    let anchor = cross(0.04 * frame.radius);
    series.push(Series::new("anchor", equilibria.len(), anchor));
    for (i, load) in statics.loads.each.iter().enumerate() {
        let aside = (i as f64 - 1.0) * 0.14 * frame.radius;
        let points = frame.arrow(load.towards, aside);
        series.push(Series::new(name(load), equilibria.len() + 1 + i, points));
    }
    let room = 1.42 * frame.radius;
    let axis = |name: &str, middle: f64| Axis::new(name, "m").over((middle - room, middle + room));
    let (x, y) = (axis("x", frame.middle.0), axis("y", frame.middle.1));
    Chart {
        equal_scale: true,
        ..Chart::new("Plan view; the anchor at the origin", x, y, series)
    }
}

/// Label of the flow of a load.
#[must_use]
pub fn name(load: &EnvironmentalLoad) -> &'static str {
    if load.name == "drift" {
        "waves"
    } else {
        load.name
    }
}

/// Label of the stability of an equilibrium: dynamic where it is known and statically stable.
#[must_use]
pub fn stability(equilibrium: &MooredEquilibrium) -> &'static str {
    match (equilibrium.yaw.stability, equilibrium.dynamic_stability()) {
        (YawStability::Stable, Some(dynamic_stability)) => dynamic_stability.label(),
        (stability, _) => stability.label(),
    }
}

/// A circle around everything drawn.
struct DrawnExtent {
    middle: (f64, f64),
    radius: f64,
}

impl DrawnExtent {
    fn of_ships(ships: &[Series], length: f64) -> Self {
        let points = || ships.iter().flat_map(|one| &one.points);
        let (x, y) = (
            extent(points().map(|p| p.0)).unwrap_or((0.0, 0.0)),
            extent(points().map(|p| p.1)).unwrap_or((0.0, 0.0)),
        );
        Self {
            middle: (0.5 * (x.0 + x.1), 0.5 * (y.0 + y.1)),
            radius: (0.5 * (x.1 - x.0).hypot(y.1 - y.0)).max(length),
        }
    }

    /// An arrow on the upstream side of a flow, in its direction.
    fn arrow(&self, towards: f64, aside: f64) -> Outline {
        let (sin, cos) = towards.sin_cos();
        let place = |along: f64, across: f64| {
            let across = across + aside;
            (
                self.middle.0 + along * cos - across * sin,
                self.middle.1 + along * sin + across * cos,
            )
        };
        let (tail, head) = (-TAIL * self.radius, -HEAD * self.radius);
        let barb = 0.3 * (head - tail);
        vec![
            place(tail, 0.0),
            place(head, 0.0),
            (f64::NAN, f64::NAN),
            place(head - barb, 0.5 * barb),
            place(head, 0.0),
            place(head - barb, -0.5 * barb),
        ]
    }
}

/// Position of the mooring point; a ship's length from the anchor without a mooring solution.
fn bow(statics: &StaticAnalysis, equilibrium: &MooredEquilibrium) -> (f64, f64) {
    let solved = equilibrium.positions(statics.loads.arm);
    solved.map(|[bow, _]| bow).unwrap_or_else(|| {
        let (sin, cos) = equilibrium.yaw.force_direction.sin_cos();
        let length = statics.ship.ship.length_m;
        (length * cos, length * sin)
    })
}

/// The mooring line and the outline of the ship.
fn ship(statics: &StaticAnalysis, equilibrium: &MooredEquilibrium) -> Outline {
    let length = statics.ship.ship.length_m;
    let bow = bow(statics, equilibrium);
    let (sin, cos) = equilibrium.yaw.heading.sin_cos();
    let place = |(forward, port): (f64, f64)| {
        // From the mooring point, forward.
        let x = forward * length - statics.loads.arm;
        let y = port * length;
        (bow.0 + x * cos - y * sin, bow.1 + x * sin + y * cos)
    };
    let half = 0.5 * BREADTH;
    let outline = [
        (0.5, 0.0),
        (0.3, half),
        (-0.5, half),
        (-0.5, -half),
        (0.3, -half),
        (0.5, 0.0),
    ];
    let mut points = vec![(0.0, 0.0), bow, (f64::NAN, f64::NAN)];
    points.extend(outline.map(place));
    points
}

fn cross(size: f64) -> Outline {
    vec![
        (-size, 0.0),
        (size, 0.0),
        (f64::NAN, f64::NAN),
        (0.0, -size),
        (0.0, size),
    ]
}
