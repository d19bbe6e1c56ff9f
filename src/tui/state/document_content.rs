//! What a file of each kind holds.

use super::{
    document_kind::DocumentKind,
    line::LineView,
    modes::{ModesOf, ModesView},
    ropeway::RopewayView,
    runs_view::RunsView,
    section::SectionView,
    ship::ShipView,
    sweeps::SweepsView,
    system::SystemView,
};
use crate::case::Attachment;
use crate::kinds::FileType;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The kinds of file, with the result of the text.
#[derive(Debug, Clone)]
pub enum DocumentContent {
    /// A line case.
    Line(Box<LineView>),
    /// A cross-section.
    Section(Box<SectionView>),
    /// A ropeway.
    Ropeway(Box<RopewayView>),
    /// A ship.
    Ship(Box<ShipView>),
    /// A system of lines.
    System(Box<SystemView>),
}

impl DocumentContent {
    /// What the screen needs of it.
    #[must_use]
    pub fn kind(&self) -> &dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_ref(),
            Self::Section(section) => section.as_ref(),
            Self::Ropeway(ropeway) => ropeway.as_ref(),
            Self::Ship(ship) => ship.as_ref(),
            Self::System(system) => system.as_ref(),
        }
    }

    /// The kind of file.
    #[must_use]
    pub const fn file_type(&self) -> FileType {
        match self {
            Self::Line(_) => FileType::Line,
            Self::Section(_) => FileType::Section,
            Self::Ropeway(_) => FileType::Ropeway,
            Self::Ship(_) => FileType::Ship,
            Self::System(_) => FileType::System,
        }
    }

    /// The runs, to be changed, where it has any.
    pub(super) fn runs_view_mut(&mut self) -> Option<&mut RunsView> {
        match self {
            Self::Line(line) => Some(&mut line.runs_view),
            Self::System(system) if system.has_runs() => Some(&mut system.runs_view),
            _ => None,
        }
    }

    /// The sweeps of its load cases, where its kind has any.
    #[must_use]
    pub const fn sweeps(&self) -> Option<&SweepsView> {
        match self {
            Self::Line(line) => Some(&line.sweeps),
            Self::System(system) => Some(&system.sweeps),
            _ => None,
        }
    }

    /// The same, to be changed.
    pub const fn sweeps_mut(&mut self) -> Option<&mut SweepsView> {
        match self {
            Self::Line(line) => Some(&mut line.sweeps),
            Self::System(system) => Some(&mut system.sweeps),
            _ => None,
        }
    }

    /// The natural modes, where its kind has any.
    #[must_use]
    pub const fn modes(&self) -> Option<&ModesView> {
        match self {
            Self::Line(line) => Some(&line.modes),
            Self::System(system) => Some(&system.modes),
            _ => None,
        }
    }

    /// The same, to be changed.
    pub const fn modes_mut(&mut self) -> Option<&mut ModesView> {
        match self {
            Self::Line(line) => Some(&mut line.modes),
            Self::System(system) => Some(&mut system.modes),
            _ => None,
        }
    }

    /// What its natural modes are of.
    pub(crate) fn of_modes(&self) -> Option<ModesOf> {
        match self {
            Self::Line(line) => Some(ModesOf::Line(Box::new(line.case.clone()))),
            Self::System(system) => Some(ModesOf::System(Arc::clone(&system.solved))),
            _ => None,
        }
    }

    /// The files that it names, with what was parsed of them.
    #[must_use]
    pub fn files(&self) -> BTreeMap<String, Attachment> {
        match self {
            Self::Line(line) => line.case.files.clone(),
            Self::System(system) => system.solved.file.files.clone(),
            _ => BTreeMap::new(),
        }
    }

    /// What the screen needs of it, to be changed.
    pub fn kind_mut(&mut self) -> &mut dyn DocumentKind {
        match self {
            Self::Line(line) => line.as_mut(),
            Self::Section(section) => section.as_mut(),
            Self::Ropeway(ropeway) => ropeway.as_mut(),
            Self::Ship(ship) => ship.as_mut(),
            Self::System(system) => system.as_mut(),
        }
    }

    /// Replaces the result by that of a newer text of the same kind; what the user looks at stays.
    pub(super) fn renew(&mut self, newer: Self) {
        match (self, newer) {
            (Self::Line(line), Self::Line(newer)) => line.renew(*newer),
            (Self::Section(section), Self::Section(newer)) => section.renew(*newer),
            (Self::Ropeway(ropeway), Self::Ropeway(newer)) => ropeway.renew(*newer),
            (Self::Ship(ship), Self::Ship(newer)) => ship.renew(*newer),
            (Self::System(system), Self::System(newer)) => system.renew(*newer),
            _ => {}
        }
    }
}
