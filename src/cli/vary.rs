//! `seacable study vary`: a sweep whose page has a row for every point.

use std::process::ExitCode;

use super::{CommandError, sweep, sweep_args::SweepArgs};

use seacable_report::sweep::SweepPage;

pub(super) fn vary(args: &SweepArgs) -> Result<ExitCode, CommandError> {
    if args.vary.is_empty() && args.resume.is_none() {
        let what = "Nothing is varied: give --vary KEY=A..B/N or --vary KEY=a,b,c, such as current.speed_m_per_s=0.2..0.8/4.";
        return Err(CommandError::Usage(what.to_owned()));
    }
    sweep::sweep(args, SweepPage::Variation)
}
