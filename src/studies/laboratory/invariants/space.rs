//! A system mirrored, turned about the vertical, moved horizontally: every key that has a direction or a place.

use toml::{Table, Value};

use super::tree::{change, change_each, change_vector, listed, named, number, numbers, put, word};
use crate::numerics::V3;

/// Where a system lies: first mirrored in the plane of x and z, then turned, then moved.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Space {
    /// Whether y is turned round.
    pub(super) mirrored: bool,
    /// About the vertical \[rad\].
    pub(super) turn: f64,
    /// Along x and y \[m\].
    pub(super) shift: [f64; 2],
}

impl Space {
    /// A direction there.
    pub(super) fn direction(&self, of: V3) -> V3 {
        let y = if self.mirrored { -of.y } else { of.y };
        if self.turn == 0.0 {
            return V3::new(of.x, y, of.z);
        }
        let (sin, cos) = self.turn.sin_cos();
        V3::new(cos * of.x - sin * y, sin * of.x + cos * y, of.z)
    }

    /// A place there.
    pub(super) fn place(&self, of: V3) -> V3 {
        self.direction(of) + V3::new(self.shift[0], self.shift[1], 0.0)
    }

    /// A moment there: mirrored, it turns the other way.
    fn moment(&self, of: V3) -> V3 {
        let turned = self.direction(of);
        if self.mirrored { -turned } else { turned }
    }

    /// A direction by its angle from x towards y \[deg\].
    fn azimuth(&self, of: f64) -> f64 {
        let mirrored = if self.mirrored { -of } else { of };
        let turned = mirrored + self.turn.to_degrees();
        if turned > 360.0 {
            turned - 360.0
        } else {
            turned
        }
    }

    /// The vector in the frame of a body that is mirrored with the system.
    fn within(&self, of: V3) -> V3 {
        let y = if self.mirrored { -of.y } else { of.y };
        V3::new(of.x, y, of.z)
    }

    /// A turn about the x or z axis of a body: mirrored, it turns the other way.
    fn roll(&self, of: f64) -> f64 {
        if self.mirrored { -of } else { of }
    }

    /// Puts a system there.
    pub(super) fn apply(&self, file: &mut Table) {
        for kind in ["current", "wind"] {
            if let Some(table) = file.get_mut(kind).and_then(Value::as_table_mut) {
                change_each(table, "direction_deg", |of| self.azimuth(of));
            }
        }
        for waves in listed(file, "waves") {
            let direction = number(waves, "direction_deg").unwrap_or(0.0);
            put(waves, "direction_deg", self.azimuth(direction));
        }
        for (_, point) in named(file, "points") {
            self.point(point);
        }
        for (_, body) in named(file, "bodies") {
            self.body(body);
        }
        for (_, rod) in named(file, "rods") {
            if !rod.contains_key("pinned_to") {
                change_vector(rod, "end_a_m", |place| self.place(place));
                change_vector(rod, "end_b_m", |place| self.place(place));
            }
            change_vector(rod, "load_n", |load| self.direction(load));
        }
        for line in listed(file, "lines") {
            for end in ["a", "b"] {
                if line.contains_key(&format!("clamp_{end}_elevation_deg")) {
                    let key = format!("clamp_{end}_azimuth_deg");
                    let azimuth = number(line, &key).unwrap_or(0.0);
                    put(line, &key, self.azimuth(azimuth));
                }
            }
        }
        self.slope(file);
        self.bed(file);
    }

    fn point(&self, point: &mut Table) {
        if word(point, "kind") == Some("body") {
            change_vector(point, "position_m", |place| self.within(place));
            return;
        }
        change_vector(point, "position_m", |place| self.place(place));
        change_vector(point, "load_n", |load| self.direction(load));
        change_vector(point, "amplitude_m", |by| self.direction(by));
        self.table_of_places(point);
    }

    /// The columns of x and y of a motion by table.
    fn table_of_places(&self, table: &mut Table) {
        let (x, y) = (numbers(table, "table_x_m"), numbers(table, "table_y_m"));
        if x.is_empty() && y.is_empty() {
            return;
        }
        let rows = x.len().max(y.len());
        let at = |column: &[f64], row: usize| column.get(row).copied().unwrap_or(0.0);
        let moved = (0..rows).map(|row| self.direction(V3::new(at(&x, row), at(&y, row), 0.0)));
        let moved: Vec<V3> = moved.collect();
        put(table, "table_x_m", column(&moved, 0));
        put(table, "table_y_m", column(&moved, 1));
    }

    fn body(&self, body: &mut Table) {
        let carried = body.contains_key("pinned_to");
        let at = match numbers(body, "position_m")[..] {
            [x, y, z] => V3::new(x, y, z),
            _ => V3::zeros(),
        };
        let to = if carried {
            self.within(at)
        } else {
            self.place(at)
        };
        put(body, "position_m", vec![to.x, to.y, to.z]);
        change(body, "roll_deg", |roll| self.roll(roll));
        let yaw = number(body, "yaw_deg").unwrap_or(0.0);
        put(
            body,
            "yaw_deg",
            if carried {
                self.roll(yaw)
            } else {
                self.azimuth(yaw)
            },
        );
        for key in ["load_n", "amplitude_m", "start_offset_m"] {
            change_vector(body, key, |by| self.direction(by));
        }
        change_vector(body, "moment_n_m", |of| self.moment(of));
        for key in ["amplitude_deg", "start_offset_deg"] {
            change_vector(body, key, |of| {
                V3::new(self.roll(of.x), of.y, self.roll(of.z))
            });
        }
        for key in [
            "centre_of_gravity_m",
            "centre_of_buoyancy_m",
            "centre_of_added_mass_m",
            "centre_of_drag_m",
            "response_at_m",
        ] {
            change_vector(body, key, |of| self.within(of));
        }
        self.table_of_places(body);
        for key in ["table_roll_deg", "table_yaw_deg"] {
            change_each(body, key, |of| self.roll(of));
        }
        if self.mirrored {
            self.mirror_loads(body);
        }
        for member in listed(body, "members") {
            change_vector(member, "from_m", |of| self.within(of));
            change_vector(member, "to_m", |of| self.within(of));
            change_each(member, "repeat_at_deg", |of| self.roll(of));
        }
    }

    /// Loads by heading, which mirrored are those of the other side.
    fn mirror_loads(&self, body: &mut Table) {
        for kind in ["wind_loads", "current_loads"] {
            for row in listed(body, kind) {
                for key in ["sway_n_s2_per_m2", "yaw_n_s2_per_m"] {
                    change(row, key, |of| -of);
                }
                change(row, "heading_deg", |of| -of);
            }
            if let Some(Value::Array(rows)) = body.get_mut(kind) {
                rows.reverse();
            }
        }
    }

    /// A bed that slopes evenly.
    fn slope(&self, file: &mut Table) {
        let bed = file.get_mut("seabed").and_then(Value::as_table_mut);
        let Some(bed) = bed.filter(|bed| bed.contains_key("slope_deg")) else {
            return;
        };
        let azimuth = number(bed, "slope_azimuth_deg").unwrap_or(0.0);
        put(bed, "slope_azimuth_deg", self.azimuth(azimuth));
        let at = match numbers(bed, "depth_at_m")[..] {
            [x, y] => V3::new(x, y, 0.0),
            _ => V3::zeros(),
        };
        let to = self.place(at);
        put(bed, "depth_at_m", vec![to.x, to.y]);
    }

    /// A grid of depths, which is an inclined plane where it is turned.
    fn bed(&self, file: &mut Table) {
        let Some(Value::Table(bed)) = file.get("seabed") else {
            return;
        };
        let Some(name) = word(bed, "depth_file").map(str::to_owned) else {
            return;
        };
        let Some(grid) = file.get_mut("files").and_then(Value::as_table_mut) else {
            return;
        };
        let Some(Value::Table(grid)) = grid.get_mut(&name) else {
            return;
        };
        let Some(plane) = word(grid, "text").and_then(super::drawn::Plane::read) else {
            return;
        };
        let down = self.direction(V3::new(plane.by_x, plane.by_y, 0.0));
        let [x, y] = self.shift;
        let moved = super::drawn::Plane {
            depth: plane.depth - down.x * x - down.y * y,
            by_x: down.x,
            by_y: down.y,
        };
        put(grid, "text", moved.text());
    }
}

fn column(places: &[V3], axis: usize) -> Vec<f64> {
    places.iter().map(|place| place[axis]).collect()
}
