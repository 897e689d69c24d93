//! Seams: compares the steps across the border of a tile with the steps inside it.

use image::DynamicImage;

/// One step of 8-bit values (255), in 16-bit values (65,535).
const LEVEL: f64 = 257.0;
/// The number of other places at which a tile is cut, to compare with its border.
const CUTS: usize = 24;
/// If this number of other lines have steps nearly as large as the largest step across the border, the border has the
/// largest one by chance. For example, pieces of parquet meet at the border in the same way as inside.
const RIVALS: usize = 3;
/// A step counts as nearly as large from this share on. In parquet with 4 × 4 pieces, the next three lines had 0.98,
/// 0.95 and 0.89. The steps of a seam are larger than others by more than that.
const NEARLY: f64 = 0.88;

/// The steps of a tile from each px to the next, the largest of all channels. After the last px of a row or column comes its first.
#[derive(Debug)]
pub struct Steps {
    /// The steps to the right of each column, from top to bottom; then the steps below each row, from left to right.
    lines: [Vec<Vec<u16>>; 2],
    /// The number of steps of each size.
    counts: Vec<u32>,
}

impl Steps {
    /// The steps of a picture.
    #[must_use]
    pub fn of(picture: &DynamicImage) -> Self {
        let rgba = picture.to_rgba16();
        let [width, height] = [rgba.width() as usize, rgba.height() as usize];
        let px: Vec<[u16; 4]> = rgba.pixels().map(|px| px.0).collect();
        let step = |a: [usize; 2], b: [usize; 2]| {
            let [a, b] = [a, b].map(|[x, y]| px[y % height * width + x % width]);
            (0..4).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap_or(0)
        };
        let columns = (0..width).map(|x| (0..height).map(|y| step([x, y], [x + 1, y])).collect());
        let rows = (0..height).map(|y| (0..width).map(|x| step([x, y], [x, y + 1])).collect());
        let lines: [Vec<Vec<u16>>; 2] = [columns.collect(), rows.collect()];
        let mut counts = vec![0; 1 << 16];
        lines.iter().flatten().flatten().for_each(|step| counts[usize::from(*step)] += 1);
        Self { lines, counts }
    }

    /// The 98th percentile across the border ÷ that inside, and the largest step across ÷ the largest inside, for the
    /// tile as it is.
    #[must_use]
    pub fn ratios(&self) -> [f64; 2] {
        self.ratios_of_cut([0, 0])
    }

    /// The ratios of the tile, when it begins at another px. Steps below one 8-bit value are ignored. Steps between
    /// rounded values have an error of up to one level, and many steps of a map are only a few levels. Therefore the
    /// percentile across is reduced by one level.
    fn ratios_of_cut(&self, first: [usize; 2]) -> [f64; 2] {
        let border = [0, 1].map(|axis| {
            let lines = &self.lines[axis];
            &lines[(first[axis] + lines.len() - 1) % lines.len()]
        });
        let mut across: Vec<u16> = border.into_iter().flatten().copied().collect();
        across.sort_unstable();
        let mut counts = self.counts.clone();
        across.iter().for_each(|step| counts[usize::from(*step)] -= 1);
        let ratio = |share, off: f64| {
            (percentile(&across, share) - off).max(LEVEL) / percentile_of_counts(&counts, share).max(LEVEL)
        };
        [ratio(0.98, LEVEL), ratio(1.0, 0.0)]
    }

    /// The ratios of the border, or 1 where a cut at another place has larger ones. Few spots lie across the border,
    /// and some cuts meet more spots than others; a seam, however, is in no other cut.
    #[must_use]
    pub fn ratios_beyond_chance(&self) -> [f64; 2] {
        let found = self.ratios();
        let is_chance = |cut: usize| {
            let other = self.ratios_of_cut([0, 1].map(|axis| cut * self.lines[axis].len() / (CUTS + 1)));
            other[0] >= found[0] && other[1] >= found[1]
        };
        let most = if found[0] > 1.3 && (1..=CUTS).any(is_chance) { 1.0 } else { found[0] };
        [most, if found[1] > 1.0 && self.rivals() >= RIVALS { 1.0 } else { found[1] }]
    }

    /// The number of lines between columns and between rows, without the border, whose largest step is nearly that of
    /// the border.
    fn rivals(&self) -> usize {
        let largest = |line: &Vec<u16>| f64::from(line.iter().copied().max().unwrap_or(0));
        let border = self.lines.iter().filter_map(|lines| lines.last()).map(largest).fold(0.0, f64::max);
        let inside = self.lines.iter().flat_map(|lines| &lines[..lines.len() - 1]);
        inside.filter(|line| largest(line) >= NEARLY * border).count()
    }

    /// The ranks of the 98th percentile of the steps across the right and the lower border, among those of all columns
    /// and rows: 0 = the least, 1 = the largest, ½ among equals. A tile without a seam can be cut anywhere.
    #[must_use]
    pub fn ranks(&self) -> [f64; 2] {
        [0, 1].map(|axis| {
            let figure = |line: &Vec<u16>| {
                let mut steps = line.clone();
                steps.sort_unstable();
                percentile(&steps, 0.98)
            };
            let mut figures: Vec<f64> = self.lines[axis].iter().map(figure).collect();
            let border = figures.pop().unwrap_or(0.0);
            let rank = |inner: &f64| match *inner {
                inner if inner < border => 1.0,
                inner if inner > border => 0.0,
                _ => 0.5,
            };
            figures.iter().map(rank).sum::<f64>() / figures.len() as f64
        })
    }
}

/// The index of a percentile among `count` sorted values.
fn place(count: usize, share: f64) -> usize {
    ((count - 1) as f64 * share).round() as usize
}

fn percentile(sorted: &[u16], share: f64) -> f64 {
    f64::from(sorted[place(sorted.len(), share)])
}

/// The percentile of values, each of which occurs as often as `counts` says.
fn percentile_of_counts(counts: &[u32], share: f64) -> f64 {
    let place = place(counts.iter().map(|count| *count as usize).sum(), share);
    let mut before = 0;
    let found = counts.iter().position(|count| {
        before += *count as usize;
        before > place
    });
    found.unwrap_or(0) as f64
}
