//! Speed against error of a scene at rest: its closed form, and its lines in segments, each of several meshes beside the finest.
//!
//! The reference is the scene with all lines in many times its segments; its own error is its whole difference from half of them, so that no
//! order is presumed. An error is the greater of two shares: of tensions and other forces by the greatest tension, of places by the length of the longest line.

mod answer;
mod scene;
mod view;

use std::sync::atomic::{AtomicBool, Ordering};

pub use answer::{RestAnswer, RestErrors, RestResult};
pub use scene::{SceneAtRest, Way};
pub use view::{chart, recommended_table, results_table, table};

use super::{SettingName, SpeedError};

/// Segments of the points by those of the scene.
const MESHES: [f64; 6] = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0];
/// Those of the reference, if its nodes can be afforded or it comes to rest; else the next.
const REFERENCES: [usize; 3] = [16, 8, 4];
/// Segments that a reference may have in all.
const MOST_SEGMENTS: usize = 40_000;
/// The reference has at least so many times the segments of a point.
const APART: f64 = 4.0;
/// A setting is recommended for an accuracy where the reference itself errs by less than this share of it.
const KNOWN: f64 = 0.5;

/// A way to solve a scene on one mesh.
#[derive(Debug, Clone)]
pub struct RestPoint {
    /// The way, and its mesh in words.
    pub name: SettingName,
    /// Segments of every part of the scene that is divided by itself; nothing where none is.
    pub segments: Vec<usize>,
    /// Its answer, the cheapest of its repeats, or why there is none.
    pub answer: Result<RestAnswer, String>,
    /// Its errors against the reference; absent without an answer.
    pub errors: Option<RestErrors>,
}

/// The results.
#[derive(Debug, Clone)]
pub struct RestStudy {
    /// The points, way by way, the coarsest mesh first.
    pub points: Vec<RestPoint>,
    /// What they are held against, with its own errors.
    pub reference: RestPoint,
    /// What was left out and why, in words.
    pub left_out: Vec<String>,
    /// Whether closed forms lie on a bed that does not yield, segments on one that does.
    pub rigid_bed: bool,
}

/// Computes a scene at rest in every way, each point the cheapest of so many repeats, and tells of each before it begins: its number, how many
/// there are, its name.
///
/// # Errors
/// [`SpeedError`] where no reference comes to rest or the user stops it.
pub fn compute<S: SceneAtRest>(
    scene: &S,
    repeats: usize,
    cancel: &AtomicBool,
    progress: &mut dyn FnMut(usize, usize, &str),
) -> Result<RestStudy, SpeedError> {
    let meshes = Meshes::of_scene(scene);
    let ways = scene.ways();
    let planned = |finest: usize| -> Vec<(Way, Vec<usize>)> {
        let each = ways
            .iter()
            .flat_map(|way| meshes.of_way(scene, *way, finest));
        each.collect()
    };
    let total = planned(REFERENCES[0]).len() + 2;
    let mut told = 0;
    let mut point = |way: Way, segments: &[usize], repeats: usize| {
        let name = name(way, segments);
        told += 1;
        progress(told.min(total), total, &name.to_string());
        let answer = cheapest(scene, way, segments, repeats, cancel);
        match cancel.load(Ordering::Relaxed) {
            true => Err(SpeedError::Stopped),
            false => Ok(RestPoint {
                name,
                segments: segments.to_vec(),
                answer,
                errors: None,
            }),
        }
    };
    let Reference {
        by,
        mut fine,
        coarse,
    } = meshes.reference(&mut point)?;
    fine.errors = errors(&coarse, &fine);
    let mut points = Vec::with_capacity(total);
    for (way, segments) in planned(by) {
        let mut found = point(way, &segments, repeats)?;
        found.errors = errors(&found, &fine);
        points.push(found);
    }
    Ok(RestStudy {
        points,
        reference: fine,
        left_out: scene.left_out(),
        rigid_bed: scene.has_bed() && ways.iter().any(|way| *way != Way::Segments),
    })
}

/// What points are held against.
struct Reference {
    /// Its segments by those of the scene.
    by: usize,
    fine: RestPoint,
    /// The same on half the segments.
    coarse: RestPoint,
}

/// The meshes of a scene.
struct Meshes {
    own: Vec<usize>,
    fewest: Vec<usize>,
}

impl Meshes {
    fn of_scene(scene: &impl SceneAtRest) -> Self {
        let divided = scene.divided();
        Self {
            own: divided.segments(),
            fewest: divided.fewest(),
        }
    }

    /// So many times the segments of the scene.
    fn times(&self, by: f64) -> Vec<usize> {
        let pairs = self.own.iter().zip(&self.fewest);
        let times = pairs.map(|(own, fewest)| ((*own as f64 * by).ceil() as usize).max(*fewest));
        times.collect()
    }

    /// The meshes on which a way is computed beside a reference of so many times the segments of the scene: one without segments of a way that
    /// has none.
    fn of_way<S: SceneAtRest>(&self, scene: &S, way: Way, finest: usize) -> Vec<(Way, Vec<usize>)> {
        if !scene.has_mesh(way) {
            return vec![(way, Vec::new())];
        }
        let meshes = MESHES.into_iter().filter(|by| by * APART <= finest as f64);
        let mut meshes: Vec<_> = meshes.map(|by| (way, self.times(by))).collect();
        meshes.dedup();
        meshes
    }

    /// Segments of references by those of the scene, the finest first; the coarsest in any case.
    fn affordable(&self) -> impl Iterator<Item = usize> {
        let own: usize = self.own.iter().sum();
        let last = REFERENCES[REFERENCES.len() - 1];
        let is_affordable = move |by: &usize| *by == last || by * own <= MOST_SEGMENTS;
        REFERENCES.into_iter().filter(is_affordable)
    }

    /// The finest reference that comes to rest.
    fn reference(
        &self,
        point: &mut impl FnMut(Way, &[usize], usize) -> Result<RestPoint, SpeedError>,
    ) -> Result<Reference, SpeedError> {
        let mut refused = SpeedError::Static;
        for by in self.affordable() {
            let mut pair = Vec::with_capacity(2);
            for share in [1.0, 0.5] {
                let found = point(Way::Segments, &self.times(share * by as f64), 1)?;
                match &found.answer {
                    Ok(_) => pair.push(found),
                    Err(why) => {
                        refused = SpeedError::Reference {
                            setting: found.name.to_string(),
                            why: why.clone(),
                        };
                        break;
                    }
                }
            }
            if let Ok([fine, coarse]) = <[RestPoint; 2]>::try_from(pair) {
                return Ok(Reference { by, fine, coarse });
            }
        }
        Err(refused)
    }
}

/// A way on a mesh, in words.
fn name(way: Way, segments: &[usize]) -> SettingName {
    SettingName {
        solver: way.words().to_owned(),
        setting: mesh_words(segments),
    }
}

fn mesh_words(segments: &[usize]) -> String {
    /// Numbers of segments that are listed.
    const LISTED: usize = 4;
    match segments {
        [] => String::new(),
        [only] => format!("{only} segments"),
        [first, others @ ..] if others.iter().all(|other| other == first) => {
            format!("{first} segments each")
        }
        few if few.len() <= LISTED => {
            let each: Vec<String> = few.iter().map(ToString::to_string).collect();
            format!("{} segments", each.join(" + "))
        }
        many => format!("{} segments in all", many.iter().sum::<usize>()),
    }
}

/// The answer of a way on a mesh, of several the one that took the least CPU time.
fn cheapest<S: SceneAtRest>(
    scene: &S,
    way: Way,
    segments: &[usize],
    repeats: usize,
    cancel: &AtomicBool,
) -> Result<RestAnswer, String> {
    let mut best = scene.answer(way, segments, cancel)?;
    for _ in 1..repeats {
        if cancel.load(Ordering::Relaxed) {
            break;
        }
        let again = scene.answer(way, segments, cancel)?;
        if again.cpu_s < best.cpu_s {
            best = again;
        }
    }
    Ok(best)
}

fn errors(of: &RestPoint, reference: &RestPoint) -> Option<RestErrors> {
    let (of, reference) = (of.answer.as_ref().ok()?, reference.answer.as_ref().ok()?);
    Some(of.errors(reference))
}

impl RestStudy {
    /// The cheapest point that is as accurate as asked, and of which all finer meshes are too; none where none is, or where the reference itself
    /// is not known so well.
    #[must_use]
    pub fn recommended(&self, accuracy: f64) -> Option<&RestPoint> {
        let own = self.reference.errors?.greatest();
        if own > KNOWN * accuracy {
            return None;
        }
        let is_within = |point: &RestPoint| {
            point
                .errors
                .is_some_and(|errors| errors.greatest() <= accuracy)
        };
        let points = self.points.iter().enumerate();
        let stays = points.filter(|(number, point)| {
            let finer = self.points[*number..].iter();
            let mut finer = finer.filter(|finer| finer.name.solver == point.name.solver);
            finer.all(is_within)
        });
        let cpu = |point: &RestPoint| point.answer.as_ref().map_or(f64::INFINITY, |a| a.cpu_s);
        let stays = stays.map(|(_, point)| point);
        stays.min_by(|a, b| cpu(a).total_cmp(&cpu(b)))
    }
}
