//! The channels that a run of a case records, in their order: which quantity, at which place.

use super::channel_id::{ChannelId, ChannelQuantity};
use super::{Case, DynamicStiffness, End, EndKind, Material, Method, Seabed, Section};

/// A channel of a case: what identifies it, and where on the line it is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChannelSpec {
    /// What identifies it.
    pub id: ChannelId,
    /// Where it is read.
    pub site: ChannelLocation,
}

/// Where on the line a channel is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChannelLocation {
    /// A joint: 0 at end A, then after each section, the last at end B.
    Joint(usize),
    /// An end of the line.
    End(LineEnd),
    /// A body attached to the line, by its number in the case.
    Body(usize),
    /// The body that travels along the line.
    Traveller,
    /// The first or last segment of a section, by its number.
    Section(usize, LineEnd),
    /// The gauge of the waves.
    Gauge,
    /// The whole line.
    Line,
}

/// One of the two ends of the line or of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineEnd {
    /// Where arc length is zero.
    A,
    /// Where arc length is greatest.
    B,
}

/// The channels of a case, in their order.
#[must_use]
pub fn channels(case: &Case) -> Vec<ChannelSpec> {
    RecordingConditions::of_case(case).channels()
}

/// What of a case decides which channels its run records.
pub(crate) struct RecordingConditions<'a> {
    /// Ends A and B.
    pub(crate) ends: [RecordedEnd<'a>; 2],
    /// Sections from A to B.
    pub(crate) sections: Vec<RecordedSection<'a>>,
    /// Whether the payload at end B is a rigid body that rotates.
    pub(crate) rotates: bool,
    /// Bodies attached to the line.
    pub(crate) bodies: Vec<&'a str>,
    /// The body that travels along the line.
    pub(crate) traveller: Option<&'a str>,
    /// Whether there is a sea bed.
    pub(crate) bed: bool,
    /// Whether it has friction that holds at rest, in a run in time.
    pub(crate) grips: bool,
    /// Whether there are waves.
    pub(crate) waves: bool,
    /// What the case says of it.
    pub(crate) output: RecordedOutput,
}

/// What a file asks for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RecordedOutput {
    /// Whether it asks for the energy.
    pub(crate) energy: bool,
    /// Whether it asks for the upward pull on held ends.
    pub(crate) uplift: bool,
    /// Whether forces on held ends are recorded.
    pub(crate) forces: bool,
}

/// A section of the line.
#[derive(Clone, Copy)]
pub(crate) struct RecordedSection<'a> {
    /// Its name.
    pub(crate) name: &'a str,
    /// Whether it has dynamic stiffness.
    pub(crate) dynamic_stiffness: bool,
    /// Whether it is a pipe with a bore.
    pub(crate) bore: bool,
    /// Whether it has bending stiffness.
    pub(crate) bends: bool,
}

/// An end of the line.
#[derive(Clone, Copy)]
pub(crate) struct RecordedEnd<'a> {
    /// Its name.
    pub(crate) name: &'a str,
    /// Its kind.
    pub(crate) kind: EndKind,
    /// Whether it is released at some time; it then counts as free.
    pub(crate) released: bool,
    /// Whether its direction is held.
    pub(crate) clamped: bool,
}

impl<'a> RecordingConditions<'a> {
    fn of_case(case: &'a Case) -> Self {
        let end = |end: &'a End| RecordedEnd {
            name: &end.name,
            kind: end.kind,
            released: end.release_s.is_some(),
            clamped: end.clamp_elevation_deg.is_some(),
        };
        let section = |section: &'a Section| {
            let material = case.materials.get(&section.material);
            let is_dynamic = |m: &Material| m.dynamic_stiffness != DynamicStiffness::None;
            RecordedSection {
                name: &section.name,
                dynamic_stiffness: material.is_some_and(is_dynamic),
                bore: material.is_some_and(|m| m.bore.is_some()),
                bends: material.is_some_and(|m| m.ei_n_m2 > 0.0),
            }
        };
        Self {
            ends: [end(&case.ends.a), end(&case.ends.b)],
            sections: case.line.iter().map(section).collect(),
            rotates: case.payload.as_ref().is_some_and(|p| p.rotation.is_some()),
            bodies: case
                .clumps
                .iter()
                .map(|clump| clump.name.as_str())
                .collect(),
            traveller: case.traveller.as_ref().map(|t| t.name.as_str()),
            bed: case.seabed.is_some(),
            grips: case.solver.method != Method::Static
                && case.seabed.as_ref().is_some_and(Seabed::grips),
            waves: case.waves.is_some(),
            output: RecordedOutput {
                energy: case.output.energy,
                uplift: case.output.uplift,
                forces: case.output.forces != Some(false),
            },
        }
    }

    /// The channels in their order: tensions at the joints from A to B, position of every end that moves and speed of
    /// every end that is free (of a rigid payload: of its centre of gravity, and its tilt), position of every attached
    /// body, position, arc length and tension of the traveller, force on every held end, force of the bed on loose ends
    /// and bodies and the speed at which these land, length of line on the bed and of what slides over it, height of the waves, energy, curvature and
    /// bending moment at clamped ends, dynamic stiffness at both ends of every section that has it, tension of the wall at
    /// both ends of every section that is a pipe.
    pub(crate) fn channels(&self) -> Vec<ChannelSpec> {
        let mut list = self.joint_tensions();
        self.add_motion(&mut list);
        self.add_forces(&mut list);
        if self.bed {
            add(
                &mut list,
                &[ChannelQuantity::OnBed],
                "line",
                ChannelLocation::Line,
            );
        }
        if self.grips {
            let sliding = [ChannelQuantity::Sliding];
            add(&mut list, &sliding, "line", ChannelLocation::Line);
        }
        if self.waves {
            let elevation = [ChannelQuantity::WaveElevation];
            add(&mut list, &elevation, "gauge", ChannelLocation::Gauge);
        }
        if self.output.energy {
            let energy = [ChannelQuantity::Energy];
            add(&mut list, &energy, "line", ChannelLocation::Line);
        }
        self.add_bending(&mut list);
        self.add_dynamic_stiffness(&mut list);
        for (index, section) in self.sections.iter().enumerate().filter(|(_, s)| s.bore) {
            let wall = ChannelQuantity::WallTension;
            add_at_both_ends(&mut list, wall, (index, section.name));
        }
        list
    }

    /// Both ends with their locations.
    fn located_ends(&self) -> [(&RecordedEnd<'a>, ChannelLocation); 2] {
        let [a, b] = &self.ends;
        [
            (a, ChannelLocation::End(LineEnd::A)),
            (b, ChannelLocation::End(LineEnd::B)),
        ]
    }

    /// Positions, speeds and tilt of what moves.
    fn add_motion(&self, list: &mut Vec<ChannelSpec>) {
        use ChannelQuantity as Q;
        for (end, site) in self.located_ends() {
            if end.is_loose() || end.kind == EndKind::Moving {
                add(list, &Q::POSITION, end.name, site);
            }
            if end.is_loose() {
                add(list, &[Q::Speed], end.name, site);
            }
        }
        let [_, (b, site)] = self.located_ends();
        if self.rotates && b.kind == EndKind::Payload {
            add(list, &[Q::Tilt], b.name, site);
        }
        for (index, name) in self.bodies.iter().enumerate() {
            add(list, &Q::POSITION, name, ChannelLocation::Body(index));
        }
        if let Some(name) = self.traveller {
            let quantities = [&Q::POSITION[..], &[Q::Arc, Q::Tension]].concat();
            add(list, &quantities, name, ChannelLocation::Traveller);
        }
    }

    /// Forces on held ends, and of the bed on what is loose.
    fn add_forces(&self, list: &mut Vec<ChannelSpec>) {
        use ChannelQuantity as Q;
        for (end, site) in self.located_ends() {
            if end.kind.is_held() && self.output.uplift {
                add(list, &[Q::Uplift], end.name, site);
            }
            if end.kind.is_held() && self.output.forces {
                add(list, &Q::FORCE, end.name, site);
            }
        }
        if !self.bed {
            return;
        }
        for (end, site) in self.located_ends() {
            if end.is_loose() {
                add(list, &[Q::BedForce], end.name, site);
            }
            if end.kind == EndKind::Payload {
                add(list, &[Q::LandingSpeed], end.name, site);
            }
        }
        for (index, name) in self.bodies.iter().enumerate() {
            let quantities = [Q::BedForce, Q::LandingSpeed];
            add(list, &quantities, name, ChannelLocation::Body(index));
        }
    }

    /// Curvature and bending moment at clamped ends of sections that bend.
    fn add_bending(&self, list: &mut Vec<ChannelSpec>) {
        let sections = [self.sections.first(), self.sections.last()];
        for ((end, site), section) in self.located_ends().into_iter().zip(sections) {
            if end.clamped && end.kind.is_held() && section.is_some_and(|section| section.bends) {
                add(list, &ChannelQuantity::BENDING, end.name, site);
            }
        }
    }

    /// Dynamic stiffness at both ends of the sections that have it.
    fn add_dynamic_stiffness(&self, list: &mut Vec<ChannelSpec>) {
        for (index, section) in self.sections.iter().enumerate() {
            if section.dynamic_stiffness {
                for quantity in ChannelQuantity::ROPE {
                    add_at_both_ends(list, quantity, (index, section.name));
                }
            }
        }
    }

    /// Tensions at the joints between ends and sections, from A to B.
    fn joint_tensions(&self) -> Vec<ChannelSpec> {
        let [a, b] = self.ends.map(|end| end.name);
        let sections: Vec<&str> = self.sections.iter().map(|section| section.name).collect();
        let names = [&[a], &sections[..], &[b]].concat();
        let joints = names.windows(2).enumerate();
        let tension = |(joint, pair): (usize, &[&str])| ChannelSpec {
            id: ChannelQuantity::Tension.at(format!("{}|{}", pair[0], pair[1])),
            site: ChannelLocation::Joint(joint),
        };
        joints.map(tension).collect()
    }
}

impl RecordedEnd<'_> {
    /// Whether nothing holds it, at least from some time on.
    fn is_loose(&self) -> bool {
        self.released || !self.kind.is_held()
    }
}

/// Adds channels of a quantity at both ends of a section, by its number and name.
fn add_at_both_ends(
    list: &mut Vec<ChannelSpec>,
    quantity: ChannelQuantity,
    (index, name): (usize, &str),
) {
    for (letter, end) in [("a", LineEnd::A), ("b", LineEnd::B)] {
        let site = ChannelLocation::Section(index, end);
        add(list, &[quantity], &format!("{name}.{letter}"), site);
    }
}

/// Adds channels of these quantities at a place.
fn add(
    list: &mut Vec<ChannelSpec>,
    quantities: &[ChannelQuantity],
    place: &str,
    site: ChannelLocation,
) {
    let all = quantities.iter();
    list.extend(all.map(|quantity| ChannelSpec {
        id: quantity.at(place),
        site,
    }));
}
