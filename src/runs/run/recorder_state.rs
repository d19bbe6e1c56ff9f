//! What a run has recorded up to a checkpoint, but for the rows, which its files hold.

use serde::{Deserialize, Serialize};

use super::Profile;
use super::channel_statistics::ChannelSummary;
use super::energy_balance::EnergyBalance;
use super::late_samples::LateSamples;
use super::response::ResponseSums;
use super::step_interval::LatestSteps;
use super::touchdown_speed::TouchdownSpeed;
use crate::fatigue::spot::SpotCounter;

/// What is recorded so far.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RecorderState {
    /// Interval of the rows of the record \[s\].
    pub output_interval_s: f64,
    /// Rows of the record so far.
    pub rows: u64,
    /// Greatest value of every channel so far and its time \[s\].
    pub peaks: Vec<(f64, f64)>,
    /// Smallest value of every channel so far and its time \[s\].
    pub troughs: Vec<(f64, f64)>,
    /// Statistics of the channels so far.
    pub summaries: Vec<ChannelSummary>,
    /// The latest steps, between which rows and statistics are interpolated.
    pub latest: LatestSteps,
    /// Cycles counted along the lines so far, where checks count them.
    pub fatigue: Vec<SpotCounter>,
    /// The channels shortly before the end, as far as it is reached.
    pub late: LateSamples,
    /// Energy balance so far, where one is stated.
    pub energy: Option<EnergyBalance>,
    /// Sums over the displacements, where the case asks for them.
    pub response: Option<ResponseSums>,
    /// Touchdown of the lines on the bed so far.
    pub touchdown: Vec<TouchdownSpeed>,
    /// The lines node by node, with their envelopes.
    pub profiles: Vec<Profile>,
}

impl RecorderState {
    /// Time of the last step \[s\].
    #[must_use]
    pub fn time(&self) -> Option<f64> {
        self.latest.latest().map(|step| step.time)
    }

    /// Checks that it is of so many channels, and of lines with profiles like these.
    ///
    /// # Errors
    /// What does not agree, in words.
    pub fn check(&self, channels: usize, profiles: &[Profile]) -> Result<(), String> {
        let sizes = [
            ("greatest values", self.peaks.len()),
            ("smallest values", self.troughs.len()),
        ];
        if let Some((what, found)) = sizes.into_iter().find(|(_, found)| *found != channels) {
            return Err(format!("it has {found} {what} instead of {channels}"));
        }
        let nodes: usize = profiles.iter().map(|profile| profile.arc.len()).sum();
        let alike = |(own, other): (&Profile, &Profile)| own.is_like(other);
        let touchdown = self.touchdown.iter().zip(profiles);
        let mut lands = touchdown.map(|(t, profile)| t.fits(profile.arc.len()));
        let parts = [
            (
                "latest steps",
                self.time().is_some() && self.latest.fits(channels, nodes),
            ),
            (
                "profile",
                self.profiles.len() == profiles.len()
                    && self.profiles.iter().zip(profiles).all(alike),
            ),
            ("touchdown", lands.all(|fits| fits)),
            ("last samples", self.late.fits(channels)),
            (
                "response",
                self.response.as_ref().is_none_or(|r| r.fits(nodes)),
            ),
        ];
        match parts.into_iter().find(|(_, fits)| !fits) {
            Some((what, _)) => Err(format!("its {what} cannot be that of this line")),
            None => Ok(()),
        }
    }
}
