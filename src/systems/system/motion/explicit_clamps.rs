//! The frequency of bodies that turn against the clamps of lines on them, which limits explicit steps beside that of the lines.

use super::body_equation::MovingBody;
use super::moving_system::MovingSystem;

impl MovingSystem {
    /// A bound of the square of the greatest frequency of the clamps by themselves \[1/s²\]: the bend between a clamp and its segment, of the
    /// stiffness k \[N m\], against the turns of its body and the displacements of both nodes of the segment, of length l and masses m,
    /// is at most `k (1/I + 2/(m0 l²) + 2/(m1 l²))`, with 1/I the sum of those of the body about all axes. The clamps of a body share it.
    pub(super) fn frequency_squared_of_clamps(&self) -> f64 {
        let lines = (0..self.scenes.len()).flat_map(|line| [(line, 0), (line, 1)]);
        let on = |(line, end)| Some(self.clamp_on(line, end)?.0);
        let clamps = lines.filter_map(|clamp| Some((clamp, on(clamp)?)));
        let clamps: Vec<_> = clamps
            .filter(|(_, body)| self.network.bodies[*body].turns())
            .collect();
        let count = |body: usize| clamps.iter().filter(|(_, on)| *on == body).count() as f64;
        let squares = clamps.iter().filter_map(|((line, end), body)| {
            let own = self.bend_at_clamp(*line, *end, self.turning_mobility(*body))?;
            Some(count(*body) * own)
        });
        squares.fold(0.0, f64::max)
    }

    /// The bound for one clamp on a body of this mobility; nothing at a hinge.
    fn bend_at_clamp(&self, line: usize, end: usize, mobility: f64) -> Option<f64> {
        let scene = &self.scenes[line];
        let (_, k) = scene.elements.flexure.as_ref()?.clamps[end]?;
        let segment = end * (scene.line.segments.len() - 1);
        let length = scene.line.segments[segment].axial.length;
        let masses = &scene.line.mass[segment..segment + 2];
        let nodes: f64 = masses
            .iter()
            .map(|mass| 2.0 / (mass * length * length))
            .sum();
        Some(k * (mobility + nodes))
    }

    /// Angular acceleration by a moment in any direction, at most \[1/(kg m²)\].
    fn turning_mobility(&self, body: usize) -> f64 {
        let given = &self.network.bodies[body];
        let mass = MovingBody::new(&self.network, body, &given.pose).mass;
        let inverse = match given.pinned {
            true => mass.fixed_view::<3, 3>(3, 3).try_inverse(),
            false => mass
                .try_inverse()
                .map(|inverse| inverse.fixed_view::<3, 3>(3, 3).into_owned()),
        };
        inverse.map_or(f64::INFINITY, |inverse| inverse.trace())
    }
}
