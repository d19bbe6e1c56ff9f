//! `seacable laboratory`: what measures the program rather than a mooring.

mod accuracy;
pub(crate) mod args;
mod bars;
mod intervals;
mod invariants;
mod random_motion;
mod random_refusals;
mod random_systems;
mod refined_systems;
mod scenes;

use std::process::ExitCode;

use crate::CommandError;
use args::LaboratoryArgs;

pub(crate) use accuracy::accuracy;
pub(crate) use bars::bars;
pub(crate) use intervals::intervals;
pub(crate) use random_systems::systems;

pub(crate) fn laboratory(args: &LaboratoryArgs) -> Result<ExitCode, CommandError> {
    match args {
        LaboratoryArgs::Systems(args) => systems(args),
        LaboratoryArgs::Intervals(args) => intervals(args),
        LaboratoryArgs::Bars(args) => bars(args),
        LaboratoryArgs::Accuracy(args) => accuracy(args),
    }
}
