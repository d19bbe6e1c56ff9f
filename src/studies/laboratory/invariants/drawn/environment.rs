//! What a random system stands in: water, bed, current, waves, and its materials and settings.

use super::{DURATION_S, DrawnSystemWriter};

impl DrawnSystemWriter<'_> {
    /// Water, bed, current, waves, three materials, settings.
    pub(super) fn head(&mut self) {
        self.plane.depth = self.random.between(40.0, 400.0);
        self.put(format_args!("[system]\ntitle = \"random\"\n"));
        if self.random.chance(0.1) {
            self.put(format_args!("[environment]\nwater_surface = \"crossed\"\n"));
        }
        if self.moves {
            self.put(format_args!("[solver]\nduration_s = {DURATION_S:?}\n"));
        }
        self.bed = self.random.chance(0.75);
        if self.bed {
            self.seabed();
        }
        self.current = self.random.chance(0.55);
        if self.current {
            let (speed, towards) = (
                self.random.between(0.1, 1.2),
                self.random.between(-180.0, 180.0),
            );
            if self.random.chance(0.5) {
                let (low, depth) = (speed * self.random.uniform(), self.plane.depth);
                self.put(format_args!(
                    "[current]\nspeed_m_per_s = [{speed:?}, {low:?}]\ndirection_deg = [{towards:?}, {towards:?}]\ndepth_m = [0.0, {depth:?}]\n"
                ));
            } else {
                self.put(format_args!(
                    "[current]\nspeed_m_per_s = {speed:?}\ndirection_deg = {towards:?}\n"
                ));
            }
        }
        if self.moves && self.random.chance(0.4) {
            self.waves();
        }
        for k in 0..3 {
            self.material(k);
        }
    }

    fn seabed(&mut self) {
        let (stiffness, damping) = (self.random.power(4.3, 5.3), self.random.power(3.0, 4.5));
        let depth = self.plane.depth;
        self.put(format_args!(
            "[seabed]\ndepth_m = {depth:?}\nstiffness_n_per_m3 = {stiffness:?}\ndamping_n_s_per_m3 = {damping:?}\n"
        ));
        if self.random.chance(0.15) {
            (self.plane.by_x, self.plane.by_y) = (
                self.random.between(-0.03, 0.03),
                self.random.between(-0.03, 0.03),
            );
            let plane = self.plane.text();
            self.put(format_args!(
                "depth_file = \"plane.csv\"\n[files.\"plane.csv\"]\ntext = {plane:?}\n"
            ));
        } else if self.random.chance(0.4) {
            let friction = self.random.between(0.1, 1.0);
            self.put(format_args!("friction = {friction:?}\n"));
        }
    }

    fn waves(&mut self) {
        let towards = self.random.between(-180.0, 180.0);
        let (height, period) = (
            self.random.between(0.5, 5.0),
            self.random.between(6.0, 14.0),
        );
        if self.random.chance(0.5) {
            self.put(format_args!(
                "[[waves]]\nkind = \"regular\"\nheight_m = {height:?}\nperiod_s = {period:?}\ndirection_deg = {towards:?}\nramp_s = 3.0\n"
            ));
        } else {
            let seed = self.random.whole(1, 1000);
            self.put(format_args!(
                "[[waves]]\nkind = \"irregular\"\nsignificant_height_m = {height:?}\npeak_period_s = {period:?}\ncomponents = 12\nseed = {seed}\ndirection_deg = {towards:?}\nramp_s = 3.0\n"
            ));
        }
    }

    /// From a floating rope to chain; a rope with a table, or one that bends.
    pub(super) fn material(&mut self, k: usize) {
        let diameter = self.random.power(-1.7, -0.7);
        let mass = 805.0 * diameter * diameter * self.random.between(0.85, 7.0);
        let ea = self.random.power(6.5, 9.0);
        let (normal, along, damping) = (
            self.random.between(0.5, 2.0),
            self.random.between(0.0, 0.3),
            self.random.between(0.05, 0.5),
        );
        self.put(format_args!(
            "[materials.m{k}]\ndiameter_m = {diameter:?}\nmass_kg_per_m = {mass:?}\ndrag_normal = {normal:?}\n\
             drag_tangential = {along:?}\nadded_mass_normal = 1.0\naxial_damping_ratio = {damping:?}\n"
        ));
        if self.random.chance(0.12) {
            let (low, high) = (0.02 * ea, 0.02 * ea * self.random.between(2.2, 4.0));
            let most = high + (high - low) * 2.0;
            self.put(format_args!(
                "strain = [0.0, 0.02, 0.04, 0.08]\ntension_n = [0.0, {low:?}, {high:?}, {most:?}]\n"
            ));
            return;
        }
        self.put(format_args!("ea_n = {ea:?}\n"));
        if self.random.chance(0.12) {
            let stiffness = ea * diameter * diameter * self.random.power(-3.0, -1.3);
            self.put(format_args!("ei_n_m2 = {stiffness:?}\n"));
        }
    }
}
