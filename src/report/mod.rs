//! What every view shares: tables, charts and the wording of numbers, as plain text.

use seacable_base::number;
use seacable_display::{chart, plain, table};

pub mod audit;
pub mod comparison;
pub mod document;
pub mod effects;
pub mod figures;
pub mod limits;
pub mod line_types;
pub mod modes;
pub mod nodes;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod physics;
pub mod quick_look;
pub mod record_statistics;
pub mod response;
pub mod ropeway;
pub mod rules;
pub mod run_json;
pub mod sea;
pub mod seas;
pub mod section;
pub mod ship;
pub mod subject;
pub mod sweep;
pub mod system;
pub mod text;
pub mod validation;
pub mod variation;
pub mod verdict;
pub mod window;
