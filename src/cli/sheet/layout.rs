//! The layout of a sheet: positions of pictures and names.

/// The space that one document needs.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Width and height of each of its pictures, px, at most the thumbnail's.
    pub picture: [usize; 2],
    /// Height of its name, px.
    pub name: usize,
}

/// The position of one document.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// Left edges of its pictures, px.
    pub pictures: Vec<usize>,
    /// Their upper edge.
    pub top: usize,
    /// Their width and height.
    pub size: [usize; 2],
    /// Upper edge of the text with the seed below each picture.
    pub seeds: usize,
    /// The upper left corner of its name.
    pub name: [usize; 2],
}

/// The positions of everything.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Width and height of the sheet, px.
    pub size: [usize; 2],
    /// One for each document.
    pub spots: Vec<Spot>,
}

/// The gap between documents, and around all of them, px.
fn gap(thumb: usize) -> usize {
    (thumb / 12).max(4)
}

/// The gap between the pictures of one document, px.
fn narrow_gap(thumb: usize) -> usize {
    (thumb / 48).max(2)
}

/// The gap between a picture and the text beneath it, px.
fn leading(thumb: usize) -> usize {
    thumb / 64
}

/// Width of a document with `seeds` pictures, px.
pub fn width(thumb: usize, seeds: usize) -> usize {
    seeds * thumb + (seeds - 1) * narrow_gap(thumb)
}

/// Default number of documents in a row: the sheet is then about 4 : 3.
pub fn columns(documents: usize, seeds: usize) -> usize {
    // A picture with its name is about 1.2 times as high as wide.
    let columns = (1.2 * 4.0 / 3.0 * documents as f64 / seeds as f64).sqrt().round() as usize;
    columns.clamp(1, documents.max(1))
}

impl Layout {
    /// Lays out documents of these `shapes`, `columns` in a row, each with `seeds` pictures and `under` px below them.
    /// A row is as high as its highest document.
    pub fn new(shapes: &[Shape], columns: usize, thumb: usize, seeds: usize, under: usize) -> Self {
        let columns = columns.min(shapes.len()).max(1);
        let gap = gap(thumb);
        let step = width(thumb, seeds) + gap;
        let mut spots = Vec::with_capacity(shapes.len());
        let mut top = gap;
        for row in shapes.chunks(columns) {
            let highest = row.iter().map(|shape| shape.picture[1]).max().unwrap_or(0);
            let written = top + highest + leading(thumb);
            for (column, shape) in row.iter().enumerate() {
                let left = gap + column * step;
                let picture = |index| left + index * (thumb + narrow_gap(thumb));
                spots.push(Spot {
                    pictures: (0..seeds).map(picture).collect(),
                    // The lower edges of all pictures in a row are aligned.
                    top: top + highest - shape.picture[1],
                    size: shape.picture,
                    seeds: written,
                    name: [left, written + under],
                });
            }
            let names = row.iter().map(|shape| shape.name).max().unwrap_or(0);
            top = written + under + names + gap;
        }
        Self { size: [gap + columns * step, top], spots }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shape() -> impl Strategy<Value = Shape> {
        (1..=64usize, 1..=64usize, 0..40usize)
            .prop_map(|(width, height, name)| Shape { picture: [width, height], name })
    }

    proptest! {
        #[test]
        fn nothing_overlaps_and_everything_is_on_the_sheet(
            shapes in prop::collection::vec(shape(), 1..20), columns in 1..8usize, seeds in 1..4usize, under in 0..12usize
        ) {
            let layout = Layout::new(&shapes, columns, 64, seeds, under);
            let mut boxes = Vec::new();
            for (spot, shape) in layout.spots.iter().zip(&shapes) {
                let [width, height] = spot.size;
                boxes.extend(spot.pictures.iter().map(|left| [*left, spot.top, left + width, spot.top + height + under]));
                let [left, top] = spot.name;
                boxes.push([left, top, left + super::width(64, seeds), top + shape.name]);
            }
            for (index, one) in boxes.iter().enumerate() {
                prop_assert!(one[2] < layout.size[0] && one[3] < layout.size[1]);
                for other in &boxes[..index] {
                    let apart = (0..2).any(|axis| one[axis] >= other[axis + 2] || other[axis] >= one[axis + 2]);
                    prop_assert!(apart, "{one:?} over {other:?}");
                }
            }
        }
    }

    #[test]
    fn a_sheet_is_slightly_wider_than_high() {
        assert_eq!([1, 2, 4, 12, 24].map(|documents| columns(documents, 1)), [1, 2, 3, 4, 6]);
        assert_eq!(columns(24, 3), 4);
        assert_eq!(columns(1, 50), 1);
    }
}
