//! The case file: what the user says, in TOML, with the unit of every number in its key.
//!
//! [`model`] holds the words, as plain data; [`fields`] knows every key with unit, range, default
//! and help; [`parse`] and [`load`] check a file against both and tell all that is wrong at once,
//! each a [`Diagnostic`] with file, line, column, key and remedy; [`edit`] sets
//! single values and keeps the rest of the file; [`channels`](mod@channels) names what a run of the
//! case records, [`LineQuantity`] the quantities of the whole line.

pub mod attachments;
mod carried_text;
mod channel_id;
pub mod channels;
mod check;
mod current_file;
mod current_formats;
mod depth_file;
mod depth_formats;
mod digest;
pub mod edit;
pub mod edited;
mod effective_inputs;
mod file;
pub mod file_kind;
pub mod judging_rows;
pub mod kind;
mod line_quantity;
mod load_case_file;
pub mod load_cases;
pub mod model;
#[cfg(test)]
mod near_keys;
mod placed_words;
mod quantity_id;
mod read;
pub mod read_file;
mod replaced_value;
mod rows;
pub mod rule_sets;
mod section_text;
pub mod shipped;
mod study_point;
mod subject;
mod value_range;
mod warm_start;
mod write;

use seacable_keys::size;
pub use seacable_keys::{diagnostic, fields, parameters, schema, structure, tree};

pub use attachments::stand_alone;
pub use carried_text::CarriedText;
pub use channel_id::{ChannelId, ChannelNameError, ChannelQuantity};
pub use channels::{ChannelLocation, ChannelSpec, LineEnd, channels};
pub use current_file::{current_grid, read_current};
pub use depth_file::depth_grid;
pub use diagnostic::{Diagnostic, Excerpt, Finding, render_all};
pub use digest::{TextDigest, digests};
pub use edited::EditedKey;
pub use effective_inputs::{EffectiveInput, NO_INPUTS, effective_inputs};
pub use kind::LoadedFile;
pub use line_quantity::{EnergyQuantity, LineQuantity, STEADY};
pub use model::*;
pub use quantity_id::{CurveMeasure, QuantityId};
pub use read::{
    LoadedCase, diagnose, load, load_from, parse, parse_beside, parse_keys, parse_of,
    parse_sharing, parse_stored, text_of_line, tree_of,
};
pub use read_file::ReadFile;
pub use replaced_value::{Origin, ReplacedValue, YOURS};
pub use rows::{FieldLister, FieldRow};
pub use section_text::SectionText;
pub use study_point::stands_at;
pub use subject::{ModePlane, Subject};
pub use value_range::{RangeError, Spacing, ValueRange};
pub use write::write;

// What another kind of file needs to be read, checked and complained about in the same way.
pub use check::{
    BedShapeKeys, CheckedSection, FrictionKeys, drag_twice, increasing, of_attachments, of_checks,
    of_companions, of_current, of_gauge, of_line_start, of_load_cases, of_longest_step,
    of_material, of_published_curves, of_result, of_studies, of_study, of_study_point, of_trials,
    of_waves, of_window, takes_values, too_many_rows, too_many_steps, two_others,
};
pub use fields::{is_name, join, nearest, split};

pub use seacable_keys::check::{unknown, unknown_name, used_twice};
pub use tree::{TomlEntry, TomlNode};
