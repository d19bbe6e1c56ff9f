//! What readers of a sea keep from one reading to the next. None of it is part of a state: readings are the same without it.

use super::phasors::{Anchored, FieldPhasors, Kept, PlacePhasors, TimePhasors};
use super::sea_state::Sea;
use super::waves::WaterMotion;
use crate::numerics::V3;

/// A sea at a time.
#[derive(Debug)]
pub struct SeaClock {
    t: f64,
    fields: Vec<TimePhasors>,
}

impl Default for SeaClock {
    fn default() -> Self {
        Self {
            t: f64::NAN,
            fields: Vec::new(),
        }
    }
}

impl SeaClock {
    /// Moves it to a time \[s\]. Allocates at the first call only.
    pub fn move_to(&mut self, sea: &Sea, t: f64) {
        self.t = t;
        self.fields
            .resize_with(sea.fields().len(), TimePhasors::default);
        for (field, phasors) in sea.fields().iter().zip(&mut self.fields) {
            field.move_to(t, phasors);
        }
    }
}

/// Places that a sea is read at again and again.
#[derive(Debug, Default)]
pub struct KeptPlaces(Vec<Vec<PlacePhasors>>);

impl KeptPlaces {
    /// The phasors of a place by its number, for so many fields. Allocates where it is read for the first time only.
    pub(super) fn at<'a>(&'a mut self, clock: &'a SeaClock, number: usize) -> KeptPlace<'a> {
        if self.0.len() <= number {
            self.0.resize_with(number + 1, Vec::new);
        }
        let fields = &mut self.0[number];
        fields.resize_with(clock.fields.len(), PlacePhasors::default);
        KeptPlace { clock, fields }
    }
}

/// What is kept of a place, at a time.
pub(super) struct KeptPlace<'a> {
    clock: &'a SeaClock,
    fields: &'a mut [PlacePhasors],
}

impl FieldPhasors for KeptPlace<'_> {
    fn of_field(&mut self, field: usize) -> impl Anchored {
        Kept {
            time: &self.clock.fields[field],
            place: &mut self.fields[field],
        }
    }
}

/// A sea that is read at places by their numbers.
#[derive(Debug)]
pub enum SeaReader<'a> {
    /// At a time \[s\], once.
    Once(&'a Sea, f64),
    /// At the time of a clock, with what is kept of the places.
    Again(&'a Sea, &'a SeaClock, &'a mut KeptPlaces),
}

impl SeaReader<'_> {
    /// As [`Sea::flow`]; the same bits either way.
    pub fn flow(&mut self, number: usize, place: &V3, surface: bool) -> WaterMotion {
        match self {
            Self::Once(sea, t) => sea.flow(*t, place, surface),
            Self::Again(sea, clock, kept) => {
                sea.flow_by(clock.t, place, surface, &mut kept.at(clock, number))
            }
        }
    }
}

/// What a state keeps of its readings. A copy begins without, and states are compared without.
#[derive(Debug, Default)]
pub struct KeptWaves {
    /// The time of the last reading.
    pub clock: SeaClock,
    /// Its places.
    pub places: KeptPlaces,
}

impl Clone for KeptWaves {
    fn clone(&self) -> Self {
        Self::default()
    }

    fn clone_from(&mut self, _: &Self) {}
}

impl PartialEq for KeptWaves {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
