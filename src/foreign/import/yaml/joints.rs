//! Joints of the floating platform in the IEA ontology: places by name, on the axes of members too.

use std::collections::HashMap;

use super::mapping::Mapping;
use super::tree::{YamlNode, shortened};
use crate::import::fault::Fault;
use crate::import::mooring::Given;

/// Joints on members that lie on each other's axes, at most.
const GREATEST_DEPTH: usize = 16;
/// The greatest angle \[rad\] that a file without version gives: two turns, rounded up.
const GREATEST_RADIANS: f64 = 6.3;

/// A joint on the axis of a member.
#[derive(Debug, Clone)]
struct AxialJoint<'d> {
    member: Mapping<'d>,
    joint: Mapping<'d>,
}

/// The joints of a platform by their names.
#[derive(Debug, Clone, Default)]
pub struct PlatformJoints<'d> {
    joints: HashMap<&'d str, Mapping<'d>>,
    axial: HashMap<&'d str, AxialJoint<'d>>,
    /// Whether angles are in radians: in files before version 2.
    pub in_radians: bool,
    /// Whether a joint has cylindrical coordinates.
    pub has_angles: bool,
}

impl<'d> PlatformJoints<'d> {
    /// The joints of `components: floating_platform`, if there is one.
    pub fn of_components(
        root: &Mapping<'d>,
        components: &Mapping<'d>,
        faults: &mut Vec<Fault>,
    ) -> Self {
        let mut all = Self::default();
        let Some(platform) = components.optional_mapping("floating_platform") else {
            return all;
        };
        let has_joints = platform.get("joints").is_some();
        let rows = match has_joints {
            true => platform.mappings("joints", "joint", faults),
            false => Vec::new(),
        };
        for row in rows {
            let named = |node: YamlNode<'d>| node.text();
            if let Some(name) = row.get("name").and_then(named) {
                all.joints.insert(name, row);
            }
        }
        let members = platform.get("members").and_then(|list| list.items());
        for (number, node) in members.unwrap_or_default().into_iter().enumerate() {
            let path = format!("{}[{}]", platform.key("members"), number + 1);
            let member = Mapping { node, path };
            let axial = member.get("axial_joints").and_then(|list| list.items());
            for node in axial.unwrap_or_default() {
                let Some(name) = node.get("name").and_then(|name| name.text()) else {
                    continue;
                };
                let path = format!("{}.axial_joints.{}", member.path, shortened(name));
                let joint = Mapping { node, path };
                let member = member.clone();
                all.axial.insert(name, AxialJoint { member, joint });
            }
        }
        all.angles(root);
        all
    }

    /// In which unit angles are: version 2 has degrees, files before it radians.
    fn angles(&mut self, root: &Mapping<'d>) {
        let angle = |row: &Mapping<'d>| {
            let place = row.get("location").filter(|_| is_cylindrical(row))?;
            place.items()?.get(1)?.number()
        };
        let angles: Vec<f64> = self.joints.values().filter_map(angle).collect();
        self.has_angles = !angles.is_empty();
        let version = root.get("windIO_version").and_then(|node| node.text());
        let major = version.and_then(|text| text.split('.').next()?.trim().parse::<u32>().ok());
        self.in_radians = match major {
            Some(major) => major < 2,
            None => angles.iter().all(|angle| angle.abs() < GREATEST_RADIANS),
        };
    }

    /// The place \[m\] of a joint.
    pub fn place(
        &self,
        name: &Given<String>,
        key: &str,
        faults: &mut Vec<Fault>,
    ) -> Option<[Given<f64>; 3]> {
        self.place_within(name, key, GREATEST_DEPTH, faults)
    }

    fn place_within(
        &self,
        name: &Given<String>,
        key: &str,
        depth: usize,
        faults: &mut Vec<Fault>,
    ) -> Option<[Given<f64>; 3]> {
        if depth == 0 {
            let problem = format!("the joint `{}` lies on itself", shortened(&name.value));
            let remedy = "give one of the members two joints with a location";
            faults.push(Fault::new(name.span.clone(), key, problem, remedy));
            return None;
        }
        if let Some(row) = self.joints.get(name.value.as_str()) {
            return self.by_location(row, faults);
        }
        if let Some(axial) = self.axial.get(name.value.as_str()) {
            return self.on_axis(axial, depth, faults);
        }
        let problem = format!("there is no joint `{}`", shortened(&name.value));
        let mut names: Vec<String> = self.joints.keys().map(|&name| name.to_owned()).collect();
        names.extend(self.axial.keys().map(|&name| name.to_owned()));
        names.sort();
        let remedy = match names.is_empty() {
            true => "give the `location` of the node, or joints in `components: floating_platform`"
                .to_owned(),
            false => super::mapping::listed("joint", &names),
        };
        faults.push(Fault::new(name.span.clone(), key, problem, remedy));
        None
    }

    fn by_location(&self, row: &Mapping<'d>, faults: &mut Vec<Fault>) -> Option<[Given<f64>; 3]> {
        let relative = row
            .get("relative")
            .filter(|node| node.text() != Some("none"));
        if let Some(node) = relative {
            let problem = "a joint relative to another is not read";
            faults.push(row.fault(&node, "relative", problem, "give its location itself"));
            return None;
        }
        let [first, second, z] = row.place("location", faults)?;
        if !is_cylindrical(row) {
            return Some([first, second, z]);
        }
        let angle = match self.in_radians {
            true => second.value,
            false => second.value.to_radians(),
        };
        let (sin, cos) = angle.sin_cos();
        let radius = first.value;
        let x = Given::new(radius * cos, first.span);
        let y = Given::new(radius * sin, second.span);
        Some([x, y, z])
    }

    fn on_axis(
        &self,
        axial: &AxialJoint<'d>,
        depth: usize,
        faults: &mut Vec<Fault>,
    ) -> Option<[Given<f64>; 3]> {
        let share = axial.joint.number("grid", faults);
        let ends = ["joint1", "joint2"].map(|key| {
            let name = axial.member.word(key, "name a joint", faults)?;
            self.place_within(&name, &axial.member.key(key), depth - 1, faults)
        });
        let [Some(from), Some(to)] = ends else {
            return None;
        };
        let share = share?;
        let mut on_axis = from.into_iter().zip(to).map(|(from, to)| {
            let value = from.value + share.value * (to.value - from.value);
            Given::new(value, share.span.clone())
        });
        Some([on_axis.next()?, on_axis.next()?, on_axis.next()?])
    }
}

/// Whether a joint is at radius, angle and height.
fn is_cylindrical(row: &Mapping<'_>) -> bool {
    let text = row.get("cylindrical").and_then(|node| node.text());
    text.is_some_and(|text| {
        ["true", "yes", "on"]
            .iter()
            .any(|one| text.eq_ignore_ascii_case(one))
    })
}
