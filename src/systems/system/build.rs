//! A system file in SI, its repeats written out.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use nalgebra::{Matrix6, Rotation3, UnitQuaternion, Vector6};

use super::bed::Bed;
use super::clamps;
use super::discretised::{DiscretisedLine, LineForm};
use super::initial::{BodyInitial, PointInitial};
use super::model::{
    BodyInputs, BodyKind, HeadingLoadInputs, LineInputs, MemberInputs, PointInputs, PointKind,
    StartPlacement, SystemFile,
};
use super::motion::broken_names::is_between;
use super::motion::inputs::{body_motion, point_motion};
use super::motion::payout_inputs::payouts;
use super::motion::responses::{responses, wave_response};
use super::network::{
    Body, BodyFoot, BodyOnLine, FreePoint, HeadingLoads, Held, Line, Member, Network, Point,
    ReleaseCondition, StatedSection, WEIGHTLESS, reversed, weight, weighted,
};
use super::parts::{Part, is_crossed, parts};
use super::point_on_bed::BearingArea;
use super::pose::{Pose, cross};
use super::potential_flow::{PotentialFlow, RadiationTable, responses::excitation};
use super::rods;
use crate::case::{FrictionLaw, Material, Seabed, Start, WaterSurface, current_grid, depth_grid};
use crate::numerics::{M3, V3};
use crate::physics::sea::Sea;
use crate::physics::{CurrentGrid, Suction};
use crate::scene::{Hydrodynamics, current_profile, sea};
use crate::statics::catenary::SectionProperties;
use crate::work_log::{self, Task};

/// The parts of lines that differ from what the file states, by the name of line or copy.
pub type AgedParts = BTreeMap<String, Vec<Part>>;

/// The system that a file states, which the checks passed, with lines of other parts where they aged. Lines without a closed form are
/// divided into segments.
///
/// # Errors
/// The name of a line that has no element, and why.
pub fn build(given: &SystemFile, aged: &AgedParts) -> Result<Network, (String, String)> {
    work_log::log(Task::Build, &given.about.title);
    let file = &rods::written_out(given);
    let mut network = Network {
        gravity: file.environment.gravity_m_per_s2,
        density: file.environment.water_density_kg_per_m3,
        crossed: is_crossed(file),
        bed: bed_of(file),
        current: file
            .current
            .as_ref()
            .map(|given| current_profile(Some(given), &file.files)),
        current_over_time: current_over_time(file),
        wind: file.wind.as_ref().map_or_else(V3::zeros, |wind| {
            let (sin, cos) = wind.direction_deg.to_radians().sin_cos();
            V3::new(cos, sin, 0.0) * wind.speed_m_per_s
        }),
        ..Network::default()
    };
    let sea = sea_of(file);
    network.bodies = bodies((given, file), &network, sea.as_ref());
    network.sea = sea;
    let over = |name: &String| file.points.get(name)?.position_m;
    let gauge = file.waves.iter().find_map(|waves| {
        let over = waves.gauge_over.as_ref().and_then(over);
        waves.gauge_m.or(over.map(|[x, y, _]| [x, y]))
    });
    network.records_uplift = file.output.uplift;
    network.records_forces = file.output.forces == Some(true);
    network.records_energy = file.output.energy;
    network.gauge = gauge.map_or_else(V3::zeros, |[x, y]| V3::new(x, y, 0.0));
    let mut builder = Builder {
        file,
        aged,
        network,
        numbers: BTreeMap::new(),
    };
    for line in &file.lines {
        builder.repeated(line)?;
    }
    // Points without lines: loads and weights with nothing to hold them are refused, others say where something is.
    let ends = file.line_ends();
    for name in file
        .points
        .keys()
        .filter(|name| !ends.contains(name.as_str()))
    {
        builder.point(name, 0.0, V3::zeros());
    }
    let mut network = builder.network;
    clamps::let_spin(&mut network);
    clamps::keep_from_spinning(&mut network);
    network.payouts = payouts(file, &network);
    Ok(network)
}

/// Divides all lines of a system that was built of this file into segments, as in motion; those that are stay as they are.
///
/// # Errors
/// The name of a line that has no element, and why.
pub fn divide(
    network: &mut Network,
    file: &SystemFile,
    aged: &AgedParts,
) -> Result<(), (String, String)> {
    let mut lines = network.lines.iter_mut();
    for given in &file.lines {
        let new = parts(file, given);
        for &angle in angles(&given.repeat_at_deg) {
            let Some(line) = lines.next() else {
                return Ok(());
            };
            let parts = aged.get(&line.name).unwrap_or(&new);
            let divided = match line.discretised.take() {
                Some(divided) => divided.with_element(),
                None => DiscretisedLine::divided(file, &turned_clamps(given, angle), parts),
            };
            let divided = divided.map_err(|why| (line.name.clone(), why))?;
            line.discretised = Some(divided);
            line.closed_where_known = false;
        }
    }
    Ok(())
}

/// A line whose clamps turn with its copy.
fn turned_clamps(line: &LineInputs, angle: f64) -> LineInputs {
    LineInputs {
        clamp_a_azimuth_deg: line.clamp_a_azimuth_deg + angle,
        clamp_b_azimuth_deg: line.clamp_b_azimuth_deg + angle,
        ..line.clone()
    }
}

/// The sea bed of a file.
fn bed_of(file: &SystemFile) -> Option<Bed> {
    let given = file.seabed.as_ref()?;
    // Its file was read with the system.
    let grid = depth_grid(given.depths(), &file.files).ok().flatten();
    let plane = given.plane().map(|(z, normal)| Bed::Plane(z, normal));
    let plain = plane.unwrap_or(Bed::Level(-given.depth_m));
    Some(grid.map_or(plain, Bed::Grid))
}

/// The current of a file, where it changes with time.
fn current_over_time(file: &SystemFile) -> Option<Arc<CurrentGrid>> {
    // Its file was read with the system.
    let grid = current_grid(file.current.as_ref()?, &file.files).ok()?;
    grid.filter(|grid| grid.varies_in_time())
}

/// The bodies of a file, in these waves; `file` has its rods written out as bodies.
fn bodies(
    (given, file): (&SystemFile, &SystemFile),
    network: &Network,
    sea: Option<&Sea>,
) -> Vec<Body> {
    let built = file.bodies.iter().map(|(name, body)| {
        let rod = given.rods.get(name);
        let spins_about = rod.map(|_| V3::x());
        let built = self::body(name, body, network);
        let [x, y, z] = rod.map_or([0.0; 3], |rod| rod.start_turn_deg.map(f64::to_radians));
        // Its files were read with the system.
        let moved = sea.filter(|_| body.kind == BodyKind::Moved);
        let response = moved.map(|sea| wave_response(file, body, sea));
        let response = response.and_then(Result::ok).flatten();
        let flow = PotentialFlow::of_body(file, body).ok().flatten();
        let slow = flow.as_ref().and_then(|flow| flow.radiation.as_deref());
        let mut built = Body {
            spins_about,
            initial: BodyInitial {
                placed: given.places(name),
                turn: UnitQuaternion::from_euler_angles(x, y, z),
                ..built.initial
            },
            motion: response.map(|found| found.motion).or(built.motion),
            added_mass: slow.map_or(built.added_mass, RadiationTable::slow),
            slip_speed: file.seabed.as_ref().and_then(Seabed::slip_speed),
            ..built
        };
        let floating = sea.filter(|_| built.free);
        let responses = floating.and_then(|sea| {
            let raos = responses(file, body)?;
            let radiation = flow.as_ref().and_then(|flow| flow.radiation.as_deref());
            excitation((network, &built), &raos, radiation, sea)
        });
        built.potential_flow = match responses {
            Some(excitation) => Some(Arc::new(PotentialFlow {
                excitation: Some(Arc::new(excitation)),
                ..flow.unwrap_or_default()
            })),
            None => flow.map(Arc::new),
        };
        built
    });
    let mut built: Vec<Body> = built.collect();
    carry(file, &mut built);
    built
}

/// Puts bodies that are pinned to others where these have them.
fn carry(file: &SystemFile, bodies: &mut [Body]) {
    for number in 0..bodies.len() {
        let to = file.bodies.get(&bodies[number].name);
        let Some(to) = to.and_then(|given| given.pinned_to.as_ref()) else {
            continue;
        };
        let Some(carrier) = bodies.iter().position(|body| body.name == *to) else {
            continue;
        };
        let (on, own) = (bodies[carrier].pose, bodies[number].pose);
        bodies[number].carrier = Some((carrier, own.origin));
        bodies[number].pose = Pose {
            origin: on.origin + on.arm(&own.origin),
            rotation: on.rotation * own.rotation,
        };
    }
}

/// The waves of a system; nothing without any.
#[must_use]
pub fn sea_of(file: &SystemFile) -> Option<Sea> {
    let bed = file.seabed.as_ref().map(|bed| bed.depth_m);
    let found = sea(&file.waves, bed, file.environment.gravity_m_per_s2);
    // What waves lack is refused with the file.
    found.ok().filter(|sea| !sea.fields().is_empty())
}

impl SystemFile {
    /// Whether a part that is free or pinned begins a run in time where the file puts it.
    #[must_use]
    pub fn places(&self, part: &str) -> bool {
        let named = self.start.parts.as_ref();
        self.start.placement == StartPlacement::Given
            && !is_between(part)
            && named.is_none_or(|names| names.iter().any(|name| name == part))
    }

    /// The points that lines end at.
    #[must_use]
    pub fn line_ends(&self) -> BTreeSet<&str> {
        let ends = self.lines.iter().flat_map(|line| [&line.from, &line.to]);
        ends.map(String::as_str).collect()
    }
}

struct Builder<'a> {
    file: &'a SystemFile,
    aged: &'a AgedParts,
    network: Network,
    /// Points by the name that they have in the system.
    numbers: BTreeMap<String, usize>,
}

impl Builder<'_> {
    /// A line with all its copies.
    fn repeated(&mut self, line: &LineInputs) -> Result<(), (String, String)> {
        let new = parts(self.file, line);
        let [x, y] = line.repeat_about_m;
        let axis = V3::new(x, y, 0.0);
        for &angle in angles(&line.repeat_at_deg) {
            let from = self.point(&line.from, angle, axis);
            let to = self.point(&line.to, angle, axis);
            let name = copy_name(&line.name, angle);
            let parts = self.aged.get(&name).unwrap_or(&new);
            let turned = turned_clamps(line, angle);
            let discretised = DiscretisedLine::where_needed(self.file, &turned, parts);
            let discretised = discretised.map_err(|why| (name.clone(), why))?;
            let built = self.line(line, parts, name, (from, to));
            let clamps = clamps::on_bodies(&self.network, (line, parts), angle, [from, to]);
            let form = LineForm::of_parts(self.file, &turned, parts);
            self.network.lines.push(Line {
                discretised,
                clamps,
                closed_where_known: form == LineForm::ClosedWhereKnown,
                ..built
            });
        }
        Ok(())
    }

    /// The copy of a point at an angle; a point on the axis is its own copy.
    fn point(&mut self, given_name: &str, angle: f64, axis: V3) -> usize {
        let given = &self.file.points[given_name];
        let on_axis = turned(given, angle, axis).is_none_or(|(place, here)| place == here);
        let name = if on_axis {
            given_name.to_owned()
        } else {
            copy_name(given_name, angle)
        };
        if let Some(number) = self.numbers.get(&name) {
            return *number;
        }
        let place = turned(given, angle, axis).map(|(place, _)| place);
        let number = self.network.points.len();
        let held = self.held(given, place, self.file.places(given_name));
        let motion = (given.kind == PointKind::Moved)
            .then(|| point_motion(given, &self.file.files, place.unwrap_or_default()));
        let suction = self.suction(given);
        if let (Held::On(body, at), Some(bearing)) = (&held, self.bearing(given)) {
            self.network.bodies[*body].feet.push(BodyFoot {
                point: number,
                at: *at,
                bears: FreePoint {
                    friction: given.bed_friction,
                    slip_speed: self.file.seabed.as_ref().and_then(Seabed::slip_speed),
                    bearing: Some(bearing),
                    suction,
                    ..FreePoint::default()
                },
            });
        }
        self.network.points.push(Point {
            name: name.clone(),
            held,
            motion,
        });
        self.numbers.insert(name, number);
        number
    }

    fn held(&self, given: &PointInputs, place: Option<V3>, placed: bool) -> Held {
        let Network {
            density, gravity, ..
        } = self.network;
        let Hydrodynamics {
            drag_area,
            added_mass,
        } = given.hydrodynamics(density);
        match given.kind {
            PointKind::Fixed | PointKind::Moved => Held::At(place.unwrap_or_default()),
            PointKind::Body => {
                let body = given
                    .body
                    .as_deref()
                    .and_then(|name| self.network.body(name));
                Held::On(body.unwrap_or_default(), place.unwrap_or_default())
            }
            PointKind::Free => Held::Free(FreePoint {
                weight: given.mass_kg * gravity,
                buoyancy: density * given.displaced_m3(density) * gravity,
                always_wet: given.water_surface == WaterSurface::Ignored,
                moving_mass: added_mass.add_scalar(given.mass_kg),
                added_mass,
                drag_area,
                load: given.load_with_lift(density, gravity).into(),
                friction: given.bed_friction,
                slip_speed: self.file.seabed.as_ref().and_then(Seabed::slip_speed),
                below: given.bottom_m,
                bearing: self.bearing(given),
                suction: self.suction(given),
                start: place,
                initial: PointInitial {
                    placed,
                    offset: V3::from(given.start_offset_m),
                    velocity: V3::from(given.start_velocity_m_per_s),
                    from_rest: 0.0,
                },
            }),
        }
    }

    fn suction(&self, point: &PointInputs) -> Option<Suction> {
        let acts = self.file.seabed.is_some() && point.breakout_n > 0.0;
        acts.then_some(Suction {
            greatest: point.breakout_n,
            distance: point.breakout_distance_m,
        })
    }

    fn bearing(&self, point: &PointInputs) -> Option<BearingArea> {
        let (area, bed) = point.bed_area_m2.zip(self.file.seabed.as_ref())?;
        let grip = bed.grip_stiffness_n_per_m3;
        Some(BearingArea {
            area,
            stiffness: bed.stiffness_n_per_m3,
            damping: bed.damping_n_s_per_m3,
            grip: grip.unwrap_or(bed.stiffness_n_per_m3),
        })
    }

    fn line(
        &self,
        line: &LineInputs,
        parts: &[Part],
        name: String,
        (from, to): (usize, usize),
    ) -> Line {
        // As its closed form has it: of one material from place to place.
        let bears = self.file.seabed.is_some() && line.bed_contact;
        let uniform = parts.iter();
        let uniform: Vec<Part> = uniform
            .flat_map(|part| part.uniform(&self.file.environment, bears))
            .collect();
        let sections: Vec<SectionProperties> = uniform
            .iter()
            .map(|part| SectionProperties {
                length_m: part.length_m,
                weight_n_per_m: self.wet_weight(&part.material),
                ea_n: part.material.representative_ea_n().unwrap_or(f64::INFINITY),
                clump_n: wet_mass(part) * self.network.gravity,
            })
            .collect();
        let displaced: Vec<f64> = uniform.iter().map(|part| self.displaced(part)).collect();
        let own_weight = weight(&sections);
        let sections = weighted(sections, WEIGHTLESS);
        let [friction, friction_lateral] = match &self.file.seabed {
            Some(bed) if bed.friction_law == FrictionLaw::Zhu2017 => [0.0; 2],
            _ => self.file.friction_under(line),
        };
        Line {
            name,
            from,
            to,
            reversed: reversed(&sections),
            added_weight: weight(&sections) - own_weight,
            sections,
            parts: parts.iter().map(stated).collect(),
            bodies: bodies_on(parts),
            friction,
            friction_lateral,
            still_water: line.still_water,
            bed_contact: line.bed_contact,
            releases: [
                ReleaseCondition {
                    time: line.release_a_s,
                    tension: line.release_a_n,
                },
                ReleaseCondition {
                    time: line.release_b_s,
                    tension: line.release_b_n,
                },
            ],
            start: line.start.clone().filter(Start::is_off_rest),
            discretised: None,
            clamps: [None; 2],
            closed_where_known: false,
            displaced_reversed: displaced.iter().rev().copied().collect(),
            displaced,
        }
    }

    /// Weight of the water that a part displaces per unstretched length \[N/m\].
    fn displaced(&self, part: &Part) -> f64 {
        let in_air = part.material.mass_kg_per_m * self.network.gravity;
        (in_air - self.wet_weight(&part.material)).max(0.0)
    }

    fn wet_weight(&self, material: &Material) -> f64 {
        let displaced = self.network.density * area(material);
        let mass = material
            .wet_weight_kg_per_m
            .unwrap_or(material.mass_kg_per_m - displaced);
        mass * self.network.gravity
    }
}

/// Weight in water of the bodies on a part, as mass \[kg\].
fn wet_mass(part: &Part) -> f64 {
    let clumps = part.clumps.iter();
    clumps.fold(0.0, |sum, clump| sum + clump.wet_mass_kg)
}

fn stated(part: &Part) -> StatedSection {
    StatedSection {
        name: part.section.clone(),
        length_m: part.length_m,
        break_load: part.material.break_load_n,
    }
}

/// The bodies with names on the parts of a line.
fn bodies_on(parts: &[Part]) -> Vec<BodyOnLine> {
    let mut found = Vec::new();
    let mut arc = 0.0;
    for part in parts {
        let clumps = part.clumps.iter();
        found.extend(clumps.map(|clump| BodyOnLine {
            name: Some(clump.name.clone()).filter(|name| !name.is_empty()),
            arc_m: arc + clump.at_m,
        }));
        arc += part.length_m;
    }
    found
}

fn area(material: &Material) -> f64 {
    0.25 * std::f64::consts::PI * material.diameter_m * material.diameter_m
}

/// The place of a point turned about the axis, and as it is given; nothing where none is given.
fn turned(point: &PointInputs, angle: f64, axis: V3) -> Option<(V3, V3)> {
    let here = V3::from(point.position_m?);
    let about = match point.kind {
        PointKind::Body => V3::zeros(),
        PointKind::Fixed | PointKind::Moved | PointKind::Free => axis,
    };
    if angle == 0.0 {
        return Some((here, here));
    }
    let turn = Rotation3::from_axis_angle(&V3::z_axis(), angle.to_radians());
    let arm = here - about;
    if arm.x == 0.0 && arm.y == 0.0 {
        return Some((here, here));
    }
    Some((about + turn * arm, here))
}

/// The angles of copies \[deg\]: 0 without repeats.
#[must_use]
pub fn angles(repeat_at_deg: &[f64]) -> &[f64] {
    match repeat_at_deg {
        [] => &[0.0],
        angles => angles,
    }
}

/// The name of a copy: `mooring@120`; the one that is not turned keeps its own.
#[must_use]
pub fn copy_name(name: &str, angle: f64) -> String {
    if angle == 0.0 {
        name.to_owned()
    } else {
        format!("{name}@{angle}")
    }
}

fn body(name: &str, given: &BodyInputs, network: &Network) -> Body {
    let [roll, pitch, yaw] = [given.roll_deg, given.pitch_deg, given.yaw_deg].map(f64::to_radians);
    let mass = given.mass_kg.unwrap_or(0.0);
    let origin = V3::from(given.position_m.unwrap_or_default());
    let pose = Pose::new(origin, roll, pitch, yaw);
    Body {
        name: name.to_owned(),
        motion: is_moved(given).then(|| body_motion(given)),
        pose,
        free: given.kind == BodyKind::Free,
        pinned: given.kind == BodyKind::Pinned,
        carrier: None,
        mass,
        weight: mass * network.gravity,
        centre_of_gravity: V3::from(given.centre_of_gravity_m),
        inertia: inertia(&given.inertia_kg_m2),
        buoyancy: network.density * given.volume_m3 * network.gravity,
        centre_of_buoyancy: V3::from(given.centre_of_buoyancy_m),
        waterplane: matrix(&given.waterplane_stiffness),
        added_mass: added_mass(given),
        centre_of_added_mass: given.centre_of_added_mass_m.map(V3::from),
        damping: matrix(&given.damping),
        quadratic_damping: matrix(&given.quadratic_damping),
        load: V3::from(given.load_n),
        moment: V3::from(given.moment_n_m),
        bottom: given.bottom_m,
        bed_friction: given.bed_friction,
        slip_speed: None,
        feet: Vec::new(),
        members: given.members.iter().flat_map(members).collect(),
        drag_area: V3::from(given.drag_area_m2),
        centre_of_drag: V3::from(given.centre_of_drag_m),
        drag_length: given.drag_length_m,
        wind_loads: heading_loads(&given.wind_loads),
        current_loads: heading_loads(&given.current_loads),
        drift_loads: drift_loads(given),
        initial: BodyInitial {
            offset: V3::from(given.start_offset_m),
            angles: V3::from(given.start_offset_deg.map(f64::to_radians)),
            velocity: V3::from(given.start_velocity_m_per_s),
            angular_velocity: V3::from(given.start_angular_velocity_deg_per_s.map(f64::to_radians)),
            ..BodyInitial::default()
        },
        potential_flow: None,
        spins_about: None,
    }
}

/// Its added mass about its origin.
fn added_mass(given: &BodyInputs) -> Matrix6<f64> {
    let about_centre = matrix(&given.added_mass);
    let centre = given.centre_of_added_mass_m.map(V3::from);
    centre.map_or(about_centre, |centre| moved_mass(&about_centre, &centre))
}

/// A mass matrix about a place of a body, about its origin.
#[must_use]
pub fn moved_mass(mass: &Matrix6<f64>, place: &V3) -> Matrix6<f64> {
    // The velocity of the place by those of the origin and of the rotation.
    let mut there = Matrix6::identity();
    there.fixed_view_mut::<3, 3>(0, 3).copy_from(&-cross(place));
    there.transpose() * mass * there
}

/// Whether a body follows a prescribed motion; of one that is pinned its origin does.
fn is_moved(given: &BodyInputs) -> bool {
    let has_motion = || given.amplitude_m != [0.0; 3] || !given.table_time_s.is_empty();
    given.kind == BodyKind::Moved || given.kind == BodyKind::Pinned && has_motion()
}

/// A member and its copies about the z axis of its body.
fn members(given: &MemberInputs) -> Vec<Member> {
    let turned = |angle: &f64| {
        let turn = Rotation3::from_axis_angle(&V3::z_axis(), angle.to_radians());
        let radius = 0.5 * given.diameter_m;
        Member {
            from: turn * V3::from(given.from_m),
            to: turn * V3::from(given.to_m),
            radius: (radius, given.to_diameter_m.map_or(radius, |end| 0.5 * end)),
            drag: given.drag_normal,
            added_mass: given.added_mass_normal,
            drag_ends: [given.drag_end, given.to_drag_end.unwrap_or(given.drag_end)],
            added_mass_ends: [
                given.added_mass_end,
                given.to_added_mass_end.unwrap_or(given.added_mass_end),
            ],
            drag_only: given.drag_only,
        }
    };
    angles(&given.repeat_at_deg).iter().map(turned).collect()
}

fn heading_loads(rows: &[HeadingLoadInputs]) -> Option<HeadingLoads> {
    let loads = |row: &HeadingLoadInputs| {
        [
            row.surge_n_s2_per_m2,
            row.sway_n_s2_per_m2,
            row.yaw_n_s2_per_m,
        ]
    };
    (!rows.is_empty()).then(|| HeadingLoads {
        headings: rows.iter().map(|r| r.heading_deg.to_radians()).collect(),
        loads: rows.iter().map(loads).collect(),
    })
}

fn drift_loads(given: &BodyInputs) -> Option<(HeadingLoads, V3)> {
    let rows = &given.drift_loads;
    let (sin, cos) = given.drift_towards_deg.to_radians().sin_cos();
    (!rows.is_empty()).then(|| {
        let loads = HeadingLoads {
            headings: rows.iter().map(|r| r.heading_deg.to_radians()).collect(),
            loads: rows
                .iter()
                .map(|r| [r.surge_n, r.sway_n, r.yaw_n_m])
                .collect(),
        };
        (loads, V3::new(cos, sin, 0.0))
    })
}

/// 36 numbers row by row, a diagonal of six, or nothing: zeros.
#[must_use]
pub fn matrix(numbers: &[f64]) -> Matrix6<f64> {
    match numbers.len() {
        36 => Matrix6::from_row_slice(numbers),
        6 => Matrix6::from_diagonal(&Vector6::from_row_slice(numbers)),
        _ => Matrix6::zeros(),
    }
}

/// Ixx, Iyy, Izz, and Ixy, Ixz, Iyz where they are given.
fn inertia(numbers: &[f64]) -> M3 {
    let at = |k: usize| numbers.get(k).copied().unwrap_or(0.0);
    let (xy, xz, yz) = (at(3), at(4), at(5));
    M3::new(at(0), xy, xz, xy, at(1), yz, xz, yz, at(2))
}
