//! The picture of a chart as it was drawn last: most keys change nothing on a chart, and curves of thousands of points are reduced to
//! dots in every frame otherwise.

use std::cell::RefCell;
use std::sync::Arc;

use crate::chart::{self, Chart, Glyphs, Picture};

/// A picture, and all that it depends on. It is no part of the state: copies are without, and all are equal.
#[derive(Debug, Default)]
pub(super) struct PictureMemo(RefCell<Option<Drawn>>);

#[derive(Debug)]
struct Drawn {
    chart: Chart,
    glyphs: Glyphs,
    picture: Arc<Picture>,
}

impl PictureMemo {
    /// The picture of a chart in so many columns and rows.
    pub(super) fn picture(
        &self,
        chart: &Chart,
        size: (usize, usize),
        glyphs: Glyphs,
    ) -> Arc<Picture> {
        let mut last = self.0.borrow_mut();
        let known = last.as_ref().filter(|last| {
            let same_size = (last.picture.width, last.picture.height) == size;
            same_size && last.glyphs == glyphs && last.chart == *chart
        });
        if let Some(known) = known {
            return Arc::clone(&known.picture);
        }
        let picture = Arc::new(chart::draw(chart, size.0, size.1, glyphs));
        *last = Some(Drawn {
            chart: chart.clone(),
            glyphs,
            picture: Arc::clone(&picture),
        });
        picture
    }
}

impl Clone for PictureMemo {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for PictureMemo {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Series;

    #[test]
    fn a_picture_is_drawn_anew_when_anything_changes_that_it_depends_on() {
        let memo = PictureMemo::default();
        let chart = |y: f64| Chart {
            series: vec![Series::new("s", 0, vec![(0.0, y), (1.0, 2.0)])],
            ..Chart::default()
        };
        let first = memo.picture(&chart(0.0), (40, 12), Glyphs::Braille);
        assert!(Arc::ptr_eq(
            &first,
            &memo.picture(&chart(0.0), (40, 12), Glyphs::Braille)
        ));
        for (y, size, glyphs) in [
            (1.0, (40, 12), Glyphs::Braille),
            (1.0, (41, 12), Glyphs::Braille),
            (1.0, (41, 12), Glyphs::Ascii),
        ] {
            let picture = memo.picture(&chart(y), size, glyphs);
            assert_eq!(*picture, chart::draw(&chart(y), size.0, size.1, glyphs));
        }
    }
}
