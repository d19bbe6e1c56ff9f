//! What lines of an array of `FAModel` are of: line types, connectors, and configurations of sections.

use std::ops::Range;

use super::mapping::{Lookup, Mapping, find, listed};
use super::system::Named;
use super::tree::shortened;
use crate::import::fault::Fault;
use crate::import::mooring::{
    Damping, Given, Hold, Mass, MooringLineType, MooringPoint, Stiffness,
};

/// A piece of a line of one type.
#[derive(Debug, Clone)]
pub struct LinePiece {
    /// Its row.
    pub span: Range<usize>,
    /// Its type, by its place in the list.
    pub of_type: Given<usize>,
    /// Its length without tension \[m\].
    pub length: Given<f64>,
    /// The connector behind it, by its place in the list.
    pub connector: Option<usize>,
}

/// A configuration of a line, from its anchor to its fairlead.
#[derive(Debug, Clone)]
pub struct LineConfig {
    /// Horizontal distance of anchor and fairlead \[m\].
    pub span: Given<f64>,
    /// Its sections, one at least.
    pub sections: Vec<LinePiece>,
}

/// A connector between sections.
#[derive(Debug, Clone)]
struct Connector {
    mass: Given<f64>,
    volume: Given<f64>,
    drag_area: Given<f64>,
}

/// The parts that an array is of.
#[derive(Debug, Clone)]
pub struct ArrayParts {
    /// Line types.
    pub types: Named<MooringLineType>,
    connectors: Named<Connector>,
    configs: Named<LineConfig>,
}

impl ArrayParts {
    /// Reads the tables of an array.
    pub fn read(root: &Mapping<'_>, faults: &mut Vec<Fault>) -> Self {
        let types = table(root, "mooring_line_types", faults, line_type);
        let connectors = match root.get("mooring_connector_types") {
            Some(_) => table(root, "mooring_connector_types", faults, |row, _, faults| {
                Some(Connector {
                    mass: row.or_zero("m", faults)?,
                    volume: row.or_zero("v", faults)?,
                    drag_area: row.or_zero("CdA", faults)?,
                })
            }),
            None => Named {
                names: Vec::new(),
                entries: Vec::new(),
            },
        };
        let configs = table(root, "mooring_line_configs", faults, |row, _, faults| {
            config(row, &types.names, &connectors.names, faults)
        });
        Self {
            types,
            connectors,
            configs,
        }
    }

    /// A configuration by its name; nothing where it is faulty or not there.
    pub fn config(&self, name: &Given<String>, faults: &mut Vec<Fault>) -> Option<&LineConfig> {
        let key = "mooring_systems.data.MooringConfigID".to_owned();
        if !self.configs.names.contains(&name.value)
            && faults.iter().any(|one| one.span == name.span)
        {
            return None;
        }
        let found = find(
            name,
            &Lookup::of_names(&self.configs.names),
            "configuration",
            key,
            faults,
        )?;
        self.configs.entries.get(found.value)?.as_ref()
    }

    /// A point with the mass, volume and drag of a connector.
    #[must_use]
    pub fn connector(&self, connector: Option<usize>, point: MooringPoint) -> MooringPoint {
        let found = connector.and_then(|number| self.connectors.entries.get(number)?.as_ref());
        let Some(found) = found else {
            return point;
        };
        MooringPoint {
            mass: found.mass.clone(),
            volume: found.volume.clone(),
            drag_area: found.drag_area.clone(),
            ..point
        }
    }

    /// A point of nothing but rope.
    #[must_use]
    pub fn no_connector(span: &Range<usize>) -> MooringPoint {
        let none = || Given::new(0.0, span.clone());
        MooringPoint {
            id: String::new(),
            span: span.clone(),
            hold: Given::new(Hold::Free, span.clone()),
            place: [none(), none(), none()],
            mass: none(),
            volume: none(),
            drag_area: none(),
            added_mass: none(),
            load: [none(), none(), none()],
        }
    }
}

/// The entries of a mapping by their keys.
fn table<T>(
    root: &Mapping<'_>,
    key: &str,
    faults: &mut Vec<Fault>,
    mut read: impl FnMut(&Mapping<'_>, &str, &mut Vec<Fault>) -> Option<T>,
) -> Named<T> {
    let mut named = Named {
        names: Vec::new(),
        entries: Vec::new(),
    };
    let Some(table) = root.mapping(key, "an array of FAModel has this table", faults) else {
        return named;
    };
    for (name, node) in table.node.entries().unwrap_or_default() {
        let row = Mapping::of_node(node, table.key(&shortened(name)), faults);
        named.names.push(name.to_owned());
        named
            .entries
            .push(row.and_then(|row| read(&row, name, faults)));
    }
    named
}

fn line_type(row: &Mapping<'_>, name: &str, faults: &mut Vec<Fault>) -> Option<MooringLineType> {
    let diameter = row.positive("d_vol", faults);
    let mass = row.not_negative("m", faults);
    let stiffness = row.positive("EA", faults);
    let load = row.or_zero("MBL", faults);
    let coefficients = ["Cd", "CdAx", "Ca", "CaAx"].map(|key| row.or_zero(key, faults));
    let [Some(cd), Some(cd_ax), Some(ca), Some(ca_ax)] = coefficients else {
        return None;
    };
    let (mass, stiffness) = (mass?, stiffness?);
    let none = || Given::new(0.0, row.node.span());
    Some(MooringLineType {
        name: name.to_owned(),
        span: row.node.key_span(),
        diameter: diameter?,
        mass: Given::new(Mass::InAir(mass.value), mass.span),
        stiffness: Given::new(Stiffness::Constant(stiffness.value), stiffness.span),
        damping: Given::new(Damping::Coefficient(0.0), row.node.span()),
        bending: none(),
        drag_normal: cd,
        drag_tangential: cd_ax,
        added_mass_normal: ca,
        added_mass_tangential: ca_ax,
        friction: None,
        break_load: Some(load?).filter(|load| load.value > 0.0),
    })
}

/// What the sections of a configuration are.
const PIECES: &str = "each is `- connectorType: NAME`, or `- type: NAME` with a `length`";

/// A fault where a configuration is given by half.
fn refuse_half(row: &Mapping<'_>, faults: &mut Vec<Fault>) {
    let symmetric = row.get("symmetric");
    if let Some(symmetric) = symmetric.filter(|node| node.text() != Some("False")) {
        let problem = "configurations that are given by half (symmetric) are not read";
        faults.push(row.fault(&symmetric, "symmetric", problem, "write out all sections"));
    }
}

/// A configuration: connectors and sections in turn, from the anchor on.
fn config(
    row: &Mapping<'_>,
    types: &[String],
    connectors: &[String],
    faults: &mut Vec<Fault>,
) -> Option<LineConfig> {
    let span = row.positive("span", faults);
    refuse_half(row, faults);
    let list = row.required("sections", PIECES, faults)?;
    let items = list.items().unwrap_or_default();
    let mut sections: Vec<LinePiece> = Vec::new();
    let mut is_valid = true;
    for (number, node) in items.into_iter().enumerate() {
        let path = format!("{}[{}]", row.key("sections"), number + 1);
        let Some(item) = Mapping::of_node(node, path, faults) else {
            is_valid = false;
            continue;
        };
        if item.get("connectorType").is_some() {
            let name = item.word("connectorType", PIECES, faults)?;
            let key = item.key("connectorType");
            let connector = find(
                &name,
                &Lookup::of_names(connectors),
                "connector type",
                key,
                faults,
            );
            is_valid &= connector.is_some();
            // One before the first section is at the anchor, which holds it.
            if let Some(section) = sections.last_mut() {
                section.connector = connector.map(|found| found.value);
            }
        } else if item.get("type").is_some() {
            let section = section(&item, types, faults);
            is_valid &= section.is_some();
            sections.extend(section);
        } else {
            is_valid = false;
            let problem = "this is neither a connector nor a section of a line type";
            let span = item.node.span();
            faults.push(Fault::new(span, item.path.clone(), problem, PIECES));
        }
    }
    if sections.is_empty() && is_valid {
        let problem = "the configuration has no section with a length";
        faults.push(Fault::new(
            list.key_span(),
            row.key("sections"),
            problem,
            listed("line type", types),
        ));
    }
    (is_valid && !sections.is_empty()).then_some(LineConfig {
        span: span?,
        sections,
    })
}

fn section(item: &Mapping<'_>, types: &[String], faults: &mut Vec<Fault>) -> Option<LinePiece> {
    let name = item.word("type", "name a line type", faults);
    let of_type = name.and_then(|name| {
        find(
            &name,
            &Lookup::of_names(types),
            "line type",
            item.key("type"),
            faults,
        )
    });
    let length = item.positive("length", faults);
    Some(LinePiece {
        span: item.node.span(),
        of_type: of_type?,
        length: length?,
        connector: None,
    })
}
