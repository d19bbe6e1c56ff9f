//! Quick looks in the frequency domain at the seas of a sweep: the same loads and checks as by runs in time, and how far they differ.
//!
//! A sea has one look, whatever its seeds: no sample is drawn. Its numerical error is that of the mesh, from half the segments; what is
//! not linear is in neither, and shows where a sea is run in time as well ([`Difference`]).

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::fatigue::{FatiguePlace, SeaFatigue};
use super::loads::{Extreme, PlaceLoads};
use super::records::RecordedSeries;
use super::subject::subject;
use super::{
    OneSea, SeaDamage, SeaGroup, SeaQuestion, SeaResults, StoredLoadCase, checked,
    nothing_recorded, seas,
};
use crate::case::{ChannelQuantity, CheckKind, GreatestMethod};
use crate::checks::resolved::Check;
use crate::checks::utilisation::Estimate;
use crate::fatigue::spectral::TensionMoments;
use crate::kinds::FileType;
use crate::study::points::{BaseCase, Setting, side_by_side};
use crate::study::vary::Variation;
use crate::study::vary::system::solve;
use crate::system::motion::frequency::{QuickChannel, QuickLook, quick_look, quick_look_at_line};
use crate::system::rest::UnsolvedSystem;

/// Directions in plan along which an offset is looked for.
const DIRECTIONS: usize = 72;
/// Seconds of a year of 365.25 days.
const YEAR: f64 = 31_557_600.0;

/// A look at a sea.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaLook {
    /// With the segments of the file.
    pub fine: QuickLook,
    /// With half of them; nothing where errors are not estimated.
    pub coarse: Option<QuickLook>,
    /// Seconds of one core for all of it, the file read and brought to rest.
    pub cost_s: f64,
}

/// What became of the look at a sea: the look, or why there is none.
pub type SeaLookOutcome = Result<SeaLook, String>;

/// What looks at the seas of a sweep find.
#[derive(Debug, Clone, PartialEq)]
pub struct QuickSeas {
    /// Loads and checks, sea by sea.
    pub results: SeaResults,
    /// Why a sea has no look.
    pub without: Vec<(usize, String)>,
    /// What the looks cannot see, each once with its seas.
    pub warnings: Vec<(String, Vec<usize>)>,
    /// Seconds of one core that they took.
    pub cost_s: f64,
    /// Frequencies of one sea, and turns of drag and response, at most.
    pub work: (usize, usize),
}

/// A load by a quick look beside that of runs in time.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The sea.
    pub sea: usize,
    /// By the quick look.
    pub quick: PlaceLoads,
    /// By the runs.
    pub in_time: PlaceLoads,
}

/// Looks at each sea of a variation side by side on the caller's threads; nothing of those that did not begin once `cancel` is
/// set. `told` hears how many are done, of how many.
pub fn look_at_seas(
    variation: &Variation,
    question: &SeaQuestion,
    cancel: &AtomicBool,
    told: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Option<SeaLookOutcome>> {
    let all = seas(variation, &question.scene);
    let one = |sea: SeaGroup| {
        let settings = &variation.points[sea.load_cases[0]].settings;
        match FileType::of_text(&variation.base.text) {
            FileType::System => of_system(&variation.base, settings),
            _ => of_line(&variation.base, settings),
        }
    };
    side_by_side(all, cancel, one, |done, of, _, _| told(done, of))
}

fn of_system(base: &BaseCase, settings: &[Setting]) -> SeaLookOutcome {
    let clock = Instant::now();
    let solved = solve(base, settings)?;
    let estimates = solved.file.in_time().is_some_and(|s| s.error_estimate);
    SeaLook::with_estimates(clock, estimates, |coarsening| {
        quick_look(&solved, coarsening)
    })
}

fn of_line(base: &BaseCase, settings: &[Setting]) -> SeaLookOutcome {
    let clock = Instant::now();
    let case = base.request(settings)?.case;
    let estimates = case.solver.error_estimate;
    SeaLook::with_estimates(clock, estimates, |coarsening| {
        quick_look_at_line(&case, coarsening)
    })
}

impl SeaLook {
    fn with_estimates(
        clock: Instant,
        estimates: bool,
        look: impl Fn(usize) -> Result<QuickLook, UnsolvedSystem>,
    ) -> SeaLookOutcome {
        let said = |why: UnsolvedSystem| format!("{}; {}", why.problem, why.remedy);
        let fine = look(1).map_err(said)?;
        let coarse = estimates.then(|| look(2)).transpose().map_err(said)?;
        Ok(Self {
            fine,
            coarse,
            cost_s: clock.elapsed().as_secs_f64(),
        })
    }
}

impl QuickSeas {
    /// Of the looks at the seas of a variation.
    #[must_use]
    pub fn of_looks(
        variation: &Variation,
        looks: &[Option<SeaLookOutcome>],
        question: &SeaQuestion,
    ) -> Self {
        let seas = seas(variation, &question.scene);
        let (mut without, mut warnings) = (Vec::new(), Vec::<(String, Vec<usize>)>::new());
        let (mut cost_s, mut work) = (0.0, (0, 0));
        let mut each = Vec::with_capacity(seas.len());
        for (number, sea) in seas.iter().enumerate() {
            let look = match looks.get(number) {
                Some(Some(Ok(look))) => look,
                Some(Some(Err(why))) => {
                    without.push((number, why.clone()));
                    each.push(question.no_look(number, sea));
                    continue;
                }
                _ => {
                    each.push(question.no_look(number, sea));
                    continue;
                }
            };
            cost_s += look.cost_s;
            for one in std::iter::once(&look.fine).chain(&look.coarse) {
                work = (work.0.max(one.omegas.len()), work.1.max(one.turns));
            }
            for warning in &look.fine.warnings {
                match warnings.iter_mut().find(|(known, _)| known == warning) {
                    Some((_, seas)) => seas.push(number),
                    None => warnings.push((warning.clone(), vec![number])),
                }
            }
            each.push(question.one_look(number, sea, look));
        }
        Self {
            results: SeaResults::together(seas, each, question),
            without,
            warnings,
            cost_s,
            work,
        }
    }

    /// The seas worth running in time as well: that of the greatest share of a limit, or of the greatest tension, and others evenly
    /// through the order of their tensions.
    #[must_use]
    pub fn sampled(&self, count: usize) -> Vec<usize> {
        let greatest = |sea: usize| {
            let loads = self.results.loads[sea].iter();
            let tensions = loads.filter(|loads| loads.series == RecordedSeries::Tension);
            tensions
                .map(|loads| loads.greatest.estimate.value)
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let looked = (0..self.results.seas.len()).filter(|sea| greatest(*sea).is_finite());
        let mut order: Vec<usize> = looked.collect();
        order.sort_by(|a, b| greatest(*b).total_cmp(&greatest(*a)));
        let rows = self.results.checks.iter().flat_map(|check| &check.rows);
        let governs = rows
            .filter(|row| row.sea.is_some())
            .max_by(|a, b| a.used.value.total_cmp(&b.used.value));
        if let Some(place) = governs
            .and_then(|row| row.sea)
            .and_then(|sea| order.iter().position(|known| *known == sea))
        {
            let first = order.remove(place);
            order.insert(0, first);
        }
        let count = count.min(order.len());
        let place = |k: usize| k * (order.len() - 1) / (count - 1).max(1);
        let mut chosen: Vec<usize> = (0..count).map(|k| order[place(k)]).collect();
        chosen.sort_unstable();
        chosen.dedup();
        chosen
    }

    /// How the loads of a sea differ from those of its runs in time.
    #[must_use]
    pub fn differences(
        &self,
        sea: usize,
        runs: &[Option<StoredLoadCase>],
        question: &SeaQuestion,
    ) -> Vec<Difference> {
        let in_time = question.one(sea, &self.results.seas[sea], runs).loads;
        let pairs = self.results.loads[sea].iter().filter_map(|quick| {
            let same =
                |loads: &&PlaceLoads| (loads.series, &loads.place) == (quick.series, &quick.place);
            Some(Difference {
                sea,
                quick: quick.clone(),
                in_time: in_time.iter().find(same)?.clone(),
            })
        });
        pairs.collect()
    }
}

impl SeaQuestion {
    fn no_look(&self, number: usize, sea: &SeaGroup) -> OneSea {
        let why = format!("sea {} has no quick look", number + 1);
        let rows = self.checks.iter().map(|check| {
            let is_for = checked::is_for(check, sea.condition, &self.scene);
            is_for.then(|| Err(why.clone())).into_iter().collect()
        });
        OneSea {
            loads: Vec::new(),
            without: sea.load_cases.len(),
            rows: rows.collect(),
            fatigue: vec![SeaFatigue::new(); self.checks.len()],
        }
    }

    fn one_look(&self, number: usize, sea: &SeaGroup, look: &SeaLook) -> OneSea {
        let loads = self.quick_loads(sea, look);
        let (mut rows, mut fatigue) = (Vec::new(), Vec::new());
        for check in &self.checks {
            let is_for = checked::is_for(check, sea.condition, &self.scene);
            let mut own = self.rows(check, (number, sea), &loads, &[]);
            let damages = match is_for && check.kind == CheckKind::Fatigue {
                true => self.quick_fatigue(check, look),
                false => SeaFatigue::new(),
            };
            if is_for && check.kind == CheckKind::Fatigue && damages.is_empty() {
                own.push(Err(nothing_recorded(check, RecordedSeries::Tension)));
            }
            rows.push(own);
            fatigue.push(damages);
        }
        OneSea {
            loads,
            without: 0,
            rows,
            fatigue,
        }
    }

    /// Loads of tensions, and of what checks ask for.
    fn quick_loads(&self, sea: &SeaGroup, look: &SeaLook) -> Vec<PlaceLoads> {
        let is_asked = |series: RecordedSeries| {
            let mut kinds = self.checks.iter().map(|check| checked::series(check.kind));
            series == RecordedSeries::Tension || kinds.any(|of| of.contains(&series))
        };
        let asked = RecordedSeries::ALL
            .into_iter()
            .filter(|series| is_asked(*series));
        let hours = self.statistics.hours;
        let loads = asked.flat_map(|series| {
            let places = look.fine.channels.iter();
            let places =
                places.filter(move |channel| quantity(series) == Some(channel.id.quantity));
            places.filter_map(move |channel| {
                let place = channel.id.place.as_str();
                let fine = SeriesNumbers::of_look(&look.fine, series, place, hours)?;
                let coarse = look.coarse.as_ref();
                let coarse =
                    coarse.map(|coarse| SeriesNumbers::of_look(coarse, series, place, hours));
                Some(place_loads(
                    (series, place),
                    sea,
                    &fine,
                    coarse.flatten().as_ref(),
                ))
            })
        });
        loads.collect()
    }

    /// Damage by the moments of the spectra of the tensions.
    fn quick_fatigue(&self, check: &Check, look: &SeaLook) -> SeaFatigue {
        let tensions = look.fine.channels.iter().filter(|channel| {
            channel.id.quantity == ChannelQuantity::Tension
                && check.holds_for(subject(&channel.id.place))
        });
        let damage = |channel: &QuickChannel| {
            let fine = self.damage(check, channel)?;
            let coarse = look.coarse.as_ref();
            let coarse = coarse.and_then(|coarse| {
                let same = coarse.channels.iter().find(|one| one.id == channel.id)?;
                self.damage(check, same).ok()
            });
            Ok(SeaDamage {
                per_year: fine,
                numerical: coarse.map(|coarse| (fine - coarse).abs()),
                sample: Some(0.0),
            })
        };
        let named = tensions.map(|channel| {
            let place = FatiguePlace::recorded(&channel.id.place);
            (place, damage(channel))
        });
        named.collect()
    }

    /// Damage of a year \[-\].
    fn damage(&self, check: &Check, channel: &QuickChannel) -> Result<f64, String> {
        if check.is_along() {
            return Err("quick looks have fatigue where tensions are recorded, not along lines or by cross-sections".to_owned());
        }
        if !self.scene.is_random {
            return Err("quick looks have fatigue in random seas alone".to_owned());
        }
        let place = channel.id.place.as_str();
        let (diameters, strengths) = (&self.scene.diameters, &self.scene.strengths);
        let diameter = diameters.get(place).copied();
        let component = check.component(diameter, strengths.get(place).copied())?;
        let [m0, m1, m2, m4] = channel.moments;
        if m0 == 0.0 {
            return Ok(0.0);
        }
        let by = |moment: f64, order: i32| moment / TAU.powi(order);
        let moments = TensionMoments::new(m0, by(m1, 1), by(m2, 2), by(m4, 4));
        let moments = moments.map_err(|error| error.to_string())?;
        let refused = |error: crate::fatigue::spectral::SpectralError| error.to_string();
        let rate = match moments.dirlik(&component, channel.mean).map_err(refused)? {
            Some(rate) => rate,
            None => moments
                .narrow_band(&component, channel.mean)
                .map_err(refused)?,
        };
        Ok(rate * YEAR)
    }
}

/// The channels whose places a series has; none of what is along lines.
const fn quantity(series: RecordedSeries) -> Option<ChannelQuantity> {
    match series {
        RecordedSeries::Tension => Some(ChannelQuantity::Tension),
        RecordedSeries::Uplift => Some(ChannelQuantity::Uplift),
        RecordedSeries::Offset => Some(ChannelQuantity::X),
        RecordedSeries::Height => Some(ChannelQuantity::Z),
        RecordedSeries::BedClearance => None,
    }
}

/// What a look says of a series at a place.
struct SeriesNumbers {
    mean: f64,
    deviation: f64,
    greatest: f64,
    least: f64,
}

impl SeriesNumbers {
    fn of_look(look: &QuickLook, series: RecordedSeries, place: &str, hours: f64) -> Option<Self> {
        let find = |quantity: ChannelQuantity| {
            let mut channels = look.channels.iter();
            channels.find(|channel| channel.id.quantity == quantity && channel.id.place == place)
        };
        let channel = find(quantity(series)?)?;
        if series == RecordedSeries::Offset {
            return Some(Self::offset(
                channel,
                find(ChannelQuantity::Y)?,
                look,
                hours,
            ));
        }
        Some(Self {
            mean: channel.mean,
            deviation: channel.deviation(),
            greatest: channel.most_probable(hours, 1.0),
            least: channel.most_probable(hours, -1.0),
        })
    }

    /// Of a horizontal distance from the place at the start: the greatest along any direction.
    fn offset(x: &QuickChannel, y: &QuickChannel, look: &QuickLook, hours: f64) -> Self {
        let mean = (x.mean - x.at_start).hypot(y.mean - y.at_start);
        let along = (0..DIRECTIONS).map(|k| {
            let (sin, cos) = (TAU * k as f64 / DIRECTIONS as f64).sin_cos();
            let mixed = x.mixed(y, [cos, sin], &look.omegas);
            let start = cos * x.at_start + sin * y.at_start;
            (mixed.most_probable(hours, 1.0) - start, mixed.deviation())
        });
        let none = (f64::NEG_INFINITY, 0.0);
        let (greatest, deviation) = along.fold(none, |a, b| if b.0 > a.0 { b } else { a });
        Self {
            mean,
            deviation,
            greatest,
            least: 0.0,
        }
    }
}

/// Loads with the error of the mesh: three times what Richardson's extrapolation of second order gives.
fn place_loads(
    (series, place): (RecordedSeries, &str),
    sea: &SeaGroup,
    fine: &SeriesNumbers,
    coarse: Option<&SeriesNumbers>,
) -> PlaceLoads {
    let estimate = |of: fn(&SeriesNumbers) -> f64| Estimate {
        value: of(fine),
        numerical: coarse.map(|coarse| (of(fine) - of(coarse)).abs()),
        sample: None,
    };
    let extreme = |of: fn(&SeriesNumbers) -> f64| Extreme {
        estimate: estimate(of),
        method: GreatestMethod::Spectrum,
        seen: of(fine),
        load_case: sea.load_cases[0],
        time: None,
    };
    PlaceLoads {
        series,
        place: place.to_owned(),
        mean: estimate(|numbers| numbers.mean),
        deviation: fine.deviation,
        greatest: extreme(|numbers| numbers.greatest),
        least: extreme(|numbers| numbers.least),
        duration: 0.0,
    }
}
