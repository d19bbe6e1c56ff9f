//! Points, bodies, rods and lines of a system as rows.

use std::collections::BTreeMap;

use super::sheet::{BodyRow, RodRow, RodTypeRow, Sheet, SheetPoint};
use super::target::{ExportOptions, Target, Unsayable};
use super::{lines, materials, sea};
use crate::numerics::V3;
use crate::system::SolvedSystem;
use crate::system::build::angles;
use crate::system::model::{BodyInputs, BodyKind, LineInputs, PointKind, RodInputs};
use crate::system::network::Held;
use crate::system::parts::sections;

/// What a vector has along each axis, where that is the same.
pub(super) fn alike(value: &V3) -> Option<f64> {
    (value.x == value.y && value.y == value.z).then_some(value.x)
}

/// Segments of a rod.
const ROD_SEGMENTS: usize = 10;
/// Digits of places at rest behind the point.
const AT_REST: f64 = 1e6;

/// The rows of a system; what cannot be said is added to `refused`.
pub fn sheet(
    solved: &SolvedSystem,
    target: Target,
    options: ExportOptions,
    refused: &mut Vec<Unsayable>,
) -> Sheet {
    let mut sheet = Sheet {
        title: solved.file.about.title.clone(),
        ..Sheet::default()
    };
    let mut writer = Writer {
        solved,
        target,
        options,
        sheet: &mut sheet,
        bodies: BTreeMap::new(),
        rods: BTreeMap::new(),
        attachments: vec![None; solved.network.points.len()],
        types: Vec::new(),
    };
    writer.number_bodies();
    writer.types(refused);
    writer.lines();
    writer.turning_rods();
    if target == Target::MoorDyn {
        let step = step(solved, &sheet);
        sea::options(solved, step, &mut sheet);
    } else if solved.network.crossed && sea::rises_out(solved) {
        sheet.remarks.push(
            "MAP++ weighs what is above the water as under water, here it has its weight in air (environment.water_surface)."
                .to_owned(),
        );
    }
    if has_own_start(solved) {
        sheet.remarks.push(
            "Offsets, velocities and shapes of lines at the start are not in the file.".to_owned(),
        );
    }
    if solved
        .file
        .bodies
        .values()
        .any(|body| matches!(body.kind, BodyKind::Moved | BodyKind::Pinned))
        || solved
            .file
            .points
            .values()
            .any(|point| point.kind == PointKind::Moved)
    {
        sheet
            .remarks
            .push("The file does not say how coupled parts move.".to_owned());
    }
    sheet
}

/// Whether parts begin with an offset or a velocity, some of them where the file puts them, or lines in a shape of their own.
fn has_own_start(solved: &SolvedSystem) -> bool {
    let network = &solved.network;
    let mut points = network.free_points();
    let mut bodies = network.initial_of_bodies();
    solved.file.start.parts.is_some()
        || network.lines.iter().any(|line| line.start.is_some())
        || points.any(|point| point.initial.is_pushed())
        || bodies.any(|(_, initial)| initial.is_pushed())
}

/// A stable step of RK4 \[s\], of two digits: the fastest mode of a segment, with its damping.
fn step(solved: &SolvedSystem, sheet: &Sheet) -> f64 {
    let steps = sheet.lines.iter().filter_map(|line| {
        let of = sheet.types.iter().find(|of| of.name == line.of_type)?;
        let material = solved.file.materials.get(&line.of_type)?;
        let ea = material
            .dynamic_ea_n
            .or_else(|| material.representative_ea_n())?;
        let segment = line.length / line.segments as f64;
        let frequency = 2.0 / segment * (ea / of.mass).sqrt();
        let critical = segment * (ea * of.mass).sqrt();
        let ratio = match (material.axial_damping_n_s, material.axial_damping_ratio) {
            (Some(damping), _) => damping / critical,
            (None, ratio) => ratio.unwrap_or(0.0),
        };
        Some(1.0 / (frequency * (1.0 + ratio)))
    });
    let longest = steps.fold(0.05, f64::min).max(1e-7);
    let digit = 10f64.powf(longest.log10().floor() - 1.0);
    (longest / digit).floor() * digit
}

/// Where a line type comes from: a material, and the friction where types have it.
struct TypeOf {
    material: String,
    friction: f64,
    name: String,
}

struct Writer<'a> {
    solved: &'a SolvedSystem,
    target: Target,
    options: ExportOptions,
    sheet: &'a mut Sheet,
    /// Numbers of the bodies that turn by their places in the network.
    bodies: BTreeMap<usize, usize>,
    /// Numbers of the rods by name.
    rods: BTreeMap<String, usize>,
    /// What lines that end at each point of the network are attached to.
    attachments: Vec<Option<String>>,
    types: Vec<TypeOf>,
}

impl Writer<'_> {
    /// Bodies that turn, in the order in which points name them.
    fn number_bodies(&mut self) {
        if self.target == Target::MapPlusPlus {
            return;
        }
        let network = &self.solved.network;
        let of_points = network.points.iter().filter_map(|point| match point.held {
            Held::On(body, _) => Some(body),
            _ => None,
        });
        for body in of_points.chain(0..network.bodies.len()) {
            let name = &network.bodies[body].name;
            let inputs = self.solved.file.bodies.get(name);
            let turns =
                |inputs: &&BodyInputs| matches!(inputs.kind, BodyKind::Free | BodyKind::Pinned);
            if let Some(inputs) = inputs.filter(turns)
                && !self.bodies.contains_key(&body)
            {
                let number = self.sheet.bodies.len() + 1;
                self.bodies.insert(body, number);
                let row = self.body(body, inputs);
                self.sheet.bodies.push(row);
                self.members(number, inputs);
            }
        }
    }

    fn body(&self, number: usize, inputs: &BodyInputs) -> BodyRow {
        let density = self.solved.file.environment.water_density_kg_per_m3;
        let given = &self.solved.network.bodies[number].pose;
        let (place, pose) = match self.options.at_rest {
            true => {
                let pose = &self.solved.rest.placement.bodies[number];
                (pose.origin.map(rounded).into(), pose)
            }
            false => (inputs.position_m.unwrap_or(given.origin.into()), given),
        };
        let angles = pose
            .angles_roll_first()
            .map(|angle| rounded(angle.to_degrees()) + 0.0);
        let three = |of: &[f64]| std::array::from_fn(|k| of.get(k).copied().unwrap_or(0.0));
        let displaced = density * inputs.volume_m3;
        let added: [f64; 3] = three(&inputs.added_mass);
        let about: [f64; 3] = three(inputs.quadratic_damping.get(3..).unwrap_or(&[]));
        let area = inputs.drag_area_m2;
        let by_density = |damping: f64| match density > 0.0 {
            true => 2.0 * damping / density,
            false => 0.0,
        };
        BodyRow {
            hold: match inputs.kind {
                // `MoorDyn` has no pin of a body but that of one whose origin it is given.
                BodyKind::Pinned => "CoupledPinned",
                _ => "Free",
            },
            place,
            angles,
            mass: inputs.mass_kg.unwrap_or(0.0),
            centre: inputs.centre_of_gravity_m,
            inertia: three(&inputs.inertia_kg_m2),
            volume: inputs.volume_m3,
            drag_area: [
                area[0],
                area[1],
                area[2],
                by_density(about[0]),
                by_density(about[1]),
                by_density(about[2]),
            ],
            added_mass: added.map(|mass| {
                if displaced > 0.0 {
                    mass / displaced
                } else {
                    0.0
                }
            }),
        }
    }

    /// Members of a free body as rods without mass, which is in that of the body.
    fn members(&mut self, body: usize, inputs: &BodyInputs) {
        for member in &inputs.members {
            let of_type = self.rod_type(RodTypeRow {
                diameter: member.diameter_m,
                drag: member.drag_normal,
                added_mass: member.added_mass_normal,
                drag_end: member.drag_end,
                added_mass_end: member.added_mass_end,
                ..RodTypeRow::default()
            });
            self.sheet.rods.push(RodRow {
                of_type,
                hold: format!("Body{body}"),
                ends: [member.from_m, member.to_m],
                segments: ROD_SEGMENTS,
            });
        }
    }

    /// The name of a rod type with the properties of one without a name.
    fn rod_type(&mut self, mut wanted: RodTypeRow) -> String {
        for known in &self.sheet.rod_types {
            wanted.name.clone_from(&known.name);
            if *known == wanted {
                return wanted.name;
            }
        }
        wanted.name = format!("rod{}", self.sheet.rod_types.len() + 1);
        let name = wanted.name.clone();
        self.sheet.rod_types.push(wanted);
        name
    }

    /// What a line that ends at a point of the network is attached to. Points are written in the order in which lines name them.
    fn attachment(&mut self, number: usize) -> String {
        if let Some(known) = &self.attachments[number] {
            return known.clone();
        }
        let attachment = match self.rod_end(number) {
            Some(end) => end,
            None => {
                let row = self.point(number);
                self.sheet.points.push(row);
                self.sheet.points.len().to_string()
            }
        };
        self.attachments[number] = Some(attachment.clone());
        attachment
    }

    /// What an end of a line is attached to: where it is clamped at a held point or on a body, a rod of no segments in the direction of the
    /// clamp. `index` is the number of the line in the network.
    fn end(&mut self, (line, index): (&LineInputs, usize), end: usize) -> String {
        let built = &self.solved.network.lines[index];
        let number = [built.from, built.to][end];
        let elevation = [line.clamp_a_elevation_deg, line.clamp_b_elevation_deg][end];
        let Some(elevation) = elevation.filter(|_| self.target == Target::MoorDyn) else {
            return self.attachment(number);
        };
        if let Some(end) = self.clamp_on_body(index, end, number) {
            return end;
        }
        let point = &self.solved.network.points[number];
        let (Held::At(place), Some(inputs)) =
            (&point.held, self.solved.file.points.get(&point.name))
        else {
            return self.attachment(number);
        };
        let azimuth = [line.clamp_a_azimuth_deg, line.clamp_b_azimuth_deg][end];
        let (up, turn) = (elevation.to_radians(), azimuth.to_radians());
        let along = V3::new(up.cos() * turn.cos(), up.cos() * turn.sin(), up.sin());
        let hold = match inputs.kind {
            PointKind::Moved => "Coupled",
            _ => "Fixed",
        };
        let ends = [*place, place + along].map(Into::into);
        self.clamp(hold, ends, end)
    }

    /// A rod of no segments that holds the direction of a line at its end.
    fn clamp(&mut self, hold: &str, ends: [[f64; 3]; 2], end: usize) -> String {
        let rod = lines::rod_without_length(hold, ends, self.sheet);
        // The line leaves the rod at its end B, and enters it at its end A.
        format!("R{rod}{}", ["B", "A"][end])
    }

    /// The same on a body: in the frame of one that is written, else where that body has it. Rods hold the lines at their ends themselves.
    fn clamp_on_body(&mut self, index: usize, end: usize, number: usize) -> Option<String> {
        let network = &self.solved.network;
        let Held::On(body, place) = &network.points[number].held else {
            return None;
        };
        let along = network.lines[index].clamps[end]?;
        if self.rod_end(number).is_some() {
            return None;
        }
        if let Some(written) = self.bodies.get(body) {
            let ends = [*place, place + along].map(Into::into);
            return Some(self.clamp(&format!("Body{written}"), ends, end));
        }
        let pose = &self.solved.rest.placement.bodies[*body];
        let there = pose.origin + pose.arm(place);
        let ends = [there, there + pose.arm(&along)].map(Into::into);
        Some(self.clamp("Coupled", ends, end))
    }

    /// A point at the end of a rod: `R1A`.
    fn rod_end(&mut self, number: usize) -> Option<String> {
        if self.target == Target::MapPlusPlus {
            return None;
        }
        let name = &self.solved.network.points[number].name;
        let rods = self.solved.file.rods.iter();
        let (rod, inputs, end) = rods
            .flat_map(|(rod, inputs)| [(rod, inputs, "a"), (rod, inputs, "b")])
            .find(|(rod, _, end)| *name == format!("{rod}-{end}"))?;
        let (rod, end) = (rod.clone(), end.to_uppercase());
        let number = self.number_of_rod(&rod, inputs);
        Some(format!("R{number}{end}"))
    }

    /// The number of a rod, whose row is written the first time.
    fn number_of_rod(&mut self, rod: &str, inputs: &RodInputs) -> usize {
        if let Some(number) = self.rods.get(rod) {
            return *number;
        }
        let row = self.rod(inputs);
        self.sheet.rods.push(row);
        self.rods.insert(rod.to_owned(), self.sheet.rods.len());
        self.sheet.rods.len()
    }

    /// The rods that turn without a line that ends at them.
    fn turning_rods(&mut self) {
        if self.target == Target::MapPlusPlus {
            return;
        }
        let solved = self.solved;
        let turns = |inputs: &RodInputs| matches!(inputs.kind, BodyKind::Free | BodyKind::Pinned);
        for (name, inputs) in solved.file.rods.iter().filter(|(_, inputs)| turns(inputs)) {
            self.number_of_rod(name, inputs);
        }
    }

    fn rod(&mut self, inputs: &RodInputs) -> RodRow {
        let long = (V3::from(inputs.end_b_m) - V3::from(inputs.end_a_m)).norm();
        let of_type = self.rod_type(RodTypeRow {
            diameter: inputs.diameter_m,
            mass: inputs.mass_kg / long,
            drag: inputs.drag_normal,
            added_mass: inputs.added_mass_normal,
            drag_end: inputs.drag_end,
            added_mass_end: inputs.added_mass_end,
            ..RodTypeRow::default()
        });
        let given = [inputs.end_a_m, inputs.end_b_m];
        let (hold, ends) = match inputs.kind {
            BodyKind::Held => ("Fixed".to_owned(), given),
            BodyKind::Free => ("Free".to_owned(), given),
            BodyKind::Moved => ("Coupled".to_owned(), given),
            BodyKind::Pinned => match &inputs.pinned_to {
                Some(body) => self.pin_on(body, given),
                None => ("Pinned".to_owned(), given),
            },
        };
        RodRow {
            of_type,
            hold,
            ends,
            segments: ROD_SEGMENTS,
        }
    }

    /// The word for the pin of a rod on a body, and its ends: in the frame of a body that is written, else where that body has them.
    fn pin_on(&self, body: &str, ends: [[f64; 3]; 2]) -> (String, [[f64; 3]; 2]) {
        let network = &self.solved.network;
        let Some(number) = network.body(body) else {
            return ("Pinned".to_owned(), ends);
        };
        if let Some(written) = self.bodies.get(&number) {
            return (format!("Body{written}Pinned"), ends);
        }
        let pose = &network.bodies[number].pose;
        let there = ends.map(|end| (pose.origin + pose.arm(&V3::from(end))).into());
        let word = match network.bodies[number].motion {
            Some(_) => "CoupledPinned",
            None => "Pinned",
        };
        (word.to_owned(), there)
    }

    fn point(&self, number: usize) -> SheetPoint {
        let network = &self.solved.network;
        let point = &network.points[number];
        let original = point.name.split('@').next().unwrap_or(&point.name);
        let inputs = self.solved.file.points.get(original);
        let rests = self.solved.rest.placement.points[number];
        let mut row = SheetPoint {
            hold: String::new(),
            place: rests.into(),
            mass: 0.0,
            volume: 0.0,
            drag_area: 0.0,
            added_mass: 0.0,
            load: [0.0; 3],
        };
        match &point.held {
            Held::At(place) => {
                let is_moved = inputs.is_some_and(|inputs| inputs.kind == PointKind::Moved);
                row.hold = if is_moved { "Coupled" } else { "Fixed" }.to_owned();
                row.place = (*place).into();
            }
            Held::On(body, place) => match self.bodies.get(body) {
                Some(number) => {
                    row.hold = format!("Body{number}");
                    row.place = (*place).into();
                }
                None => row.hold = "Coupled".to_owned(),
            },
            Held::Free(free) => {
                row.hold = "Free".to_owned();
                let start = free.start.filter(|_| !self.options.at_rest);
                row.place = start.unwrap_or_else(|| rests.map(rounded)).into();
                let density = self.solved.file.environment.water_density_kg_per_m3;
                if let Some(inputs) = inputs {
                    row.mass = inputs.mass_kg;
                    row.volume = inputs.displaced_m3(density);
                    let of = inputs.hydrodynamics(density);
                    row.drag_area = alike(&of.drag_area).unwrap_or_default();
                    row.load = inputs.load_with_lift(density, self.solved.network.gravity);
                    let displaced = density * row.volume;
                    row.added_mass = match displaced > 0.0 {
                        true => alike(&of.added_mass).unwrap_or_default() / displaced,
                        false => 0.0,
                    };
                }
            }
        }
        row
    }

    /// The line types in the order in which lines name them.
    fn types(&mut self, refused: &mut Vec<Unsayable>) {
        let file = &self.solved.file;
        let density = file.environment.water_density_kg_per_m3;
        for line in &file.lines {
            let friction = self.friction(line);
            for section in sections(line) {
                let known = |of: &&TypeOf| of.material == section.material;
                let same = self.types.iter().filter(known);
                if same.clone().any(|of| of.friction == friction) {
                    continue;
                }
                let name = match same.count() {
                    0 => section.material.clone(),
                    count => format!("{}-{}", section.material, count + 1),
                };
                let material = &file.materials[&section.material];
                let row = materials::line_type(
                    (&name, material),
                    (density, friction),
                    self.target,
                    self.sheet,
                    refused,
                );
                self.sheet.types.push(row);
                self.types.push(TypeOf {
                    material: section.material,
                    friction,
                    name,
                });
            }
        }
    }

    /// Friction of a line where types have it, 0 elsewhere.
    fn friction(&self, line: &LineInputs) -> f64 {
        match self.target {
            Target::MoorDyn => 0.0,
            Target::MapPlusPlus => self.solved.file.friction_under(line)[0],
        }
    }

    fn lines(&mut self) {
        let mut index = 0;
        for line in &self.solved.file.lines {
            for _ in angles(&line.repeat_at_deg) {
                let mut attachments = vec![self.end((line, index), 0)];
                let of = (self.solved, index, line);
                attachments.extend(lines::joints(of, self.target, self.sheet));
                attachments.push(self.end((line, index), 1));
                let friction = self.friction(line);
                let all = &self.types;
                let type_of = |material: &str| {
                    let found = all
                        .iter()
                        .find(|of| of.material == material && of.friction == friction);
                    found.map_or_else(|| material.to_owned(), |of| of.name.clone())
                };
                let of = (self.solved, line);
                lines::write(of, &attachments, &type_of, self.target, self.sheet);
                index += 1;
            }
        }
    }
}

/// A coordinate at rest.
fn rounded(value: f64) -> f64 {
    (value * AT_REST).round() / AT_REST
}
