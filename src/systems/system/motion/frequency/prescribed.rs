//! Prescribed motion: complex displacements of the joints at each frequency of it.

use super::{Amplitude, Complex};
use crate::numerics::V3;
use crate::physics::motion::MotionPath;
use crate::physics::sea::Harmonic;
use crate::system::motion::joints::Role;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::pose_motion::PoseMotion;
use crate::system::motion::system_state::SystemState;

/// What is prescribed of a system about its mean position.
#[derive(Clone, Copy)]
pub(super) struct Prescribed<'a> {
    pub(super) system: &'a MovingSystem,
    pub(super) mean: &'a SystemState,
}

impl Prescribed<'_> {
    /// The prescribed displacements in a component of the waves, by its number among all, of bodies with responses.
    pub(super) fn by_waves(&self, number: usize) -> Vec<Amplitude> {
        self.given(|path| match path {
            MotionPath::Sum(sum) if self.is_by_responses(path) => sum.terms.get(number).copied(),
            _ => None,
        })
    }

    /// Frequencies of motions that are prescribed apart from the waves, each with the displacements; harmonics of one frequency together.
    pub(super) fn by_themselves(&self) -> Vec<(f64, Vec<Amplitude>)> {
        let own = |path: &MotionPath| match path {
            MotionPath::Sum(sum) if !self.is_by_responses(path) => sum.terms.clone(),
            MotionPath::Harmonic(swing) if swing.omega > 0.0 => vec![swing.harmonic()],
            MotionPath::Harmonic(_)
            | MotionPath::Still
            | MotionPath::Table(_)
            | MotionPath::Piecewise(_)
            | MotionPath::Sum(_) => Vec::new(),
        };
        let mut frequencies: Vec<f64> = self.paths().flat_map(own).map(|term| term.omega).collect();
        frequencies.sort_by(f64::total_cmp);
        frequencies.dedup();
        let each = frequencies.into_iter().map(|omega| {
            let of = |path: &MotionPath| {
                let terms = own(path).into_iter().filter(|term| term.omega == omega);
                terms.reduce(|sum, term| Harmonic {
                    omega,
                    cosine: sum.cosine + term.cosine,
                    sine: sum.sine + term.sine,
                })
            };
            (omega, self.given(of))
        });
        each.collect()
    }

    /// Whether a motion has a term for every component of the waves: it is that of responses to them.
    fn is_by_responses(&self, path: &MotionPath) -> bool {
        let MotionPath::Sum(sum) = path else {
            return false;
        };
        let sea = self.system.network.sea.as_ref();
        let waves = sea.map_or_else(Vec::new, |sea| sea.at_point(&V3::zeros()));
        let pairs = sum.terms.iter().zip(&waves);
        !waves.is_empty()
            && sum.terms.len() == waves.len()
            && pairs
                .into_iter()
                .all(|(term, wave)| term.omega == wave.omega)
    }

    fn paths(&self) -> impl Iterator<Item = &MotionPath> {
        let network = &self.system.network;
        let points = network
            .points
            .iter()
            .filter_map(|point| point.motion.as_ref());
        let bodies = network.bodies.iter().filter(|body| !body.free);
        let bodies = bodies.filter_map(|body| body.motion.as_ref());
        let parts = bodies.flat_map(|motion| [&motion.place, &motion.angles]);
        points.chain(parts).map(|motion| &motion.course)
    }

    /// Displacements of the joints by one harmonic of each of their motions.
    fn given(&self, of: impl Fn(&MotionPath) -> Option<Harmonic>) -> Vec<Amplitude> {
        let MovingSystem {
            network, joints, ..
        } = self.system;
        let mut given = vec![Amplitude::zeros(); self.mean.joints.x.len()];
        for (point, joint) in network.points.iter().zip(&joints.points) {
            if let Some(term) = point.motion.as_ref().and_then(|motion| of(&motion.course)) {
                given[*joint] = amplitude(&term);
            }
        }
        for (number, body) in network.bodies.iter().enumerate() {
            let Some(motion) = body.motion.as_ref().filter(|_| !body.free) else {
                continue;
            };
            if let Some(term) = of(&motion.place.course) {
                given[joints.bodies[number]] = amplitude(&term);
            }
            if let Some(term) = of(&motion.angles.course) {
                given[joints.rotations[number]] = turned(motion, &amplitude(&term));
            }
        }
        self.carry(&mut given);
        given
    }

    /// Displacements of what is on bodies that are prescribed.
    fn carry(&self, given: &mut [Amplitude]) {
        let joints = &self.system.joints;
        for joint in 0..joints.roles.len() {
            let on = match joints.roles[joint] {
                Role::OnBody(body, at) => Some((body, at)),
                Role::Origin(body) => self.system.network.bodies[body].carrier,
                _ => None,
            };
            let Some((body, at)) =
                on.filter(|(body, _)| !self.system.network.bodies[*body].turns())
            else {
                continue;
            };
            let pose = self.system.body(self.mean, body).pose;
            let turned = pose
                .rotation
                .to_rotation_matrix()
                .matrix()
                .map(Complex::from)
                * given[joints.rotations[body]];
            given[joint] =
                given[joints.bodies[body]] + turned.cross(&pose.arm(&at).map(Complex::from));
        }
    }
}

/// `cosine cos + sine sin` as an amplitude by `exp(i omega t)`.
fn amplitude(term: &Harmonic) -> Amplitude {
    term.cosine
        .zip_map(&term.sine, |cosine, sine| Complex::new(cosine, -sine))
}

/// Small changes of roll, pitch and yaw as a rotation vector along the axes of the body: see [`PoseMotion::at`].
fn turned(motion: &PoseMotion, angles: &Amplitude) -> Amplitude {
    let mean = motion.angles.position;
    let (sr, cr) = mean.x.sin_cos();
    let (sp, cp) = mean.y.sin_cos();
    let [roll, pitch, yaw] = [angles[0], angles[1], angles[2]];
    Amplitude::new(
        roll - yaw * sp,
        pitch * cr + yaw * (sr * cp),
        yaw * (cr * cp) - pitch * sr,
    )
}
