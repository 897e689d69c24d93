//! Few colours for pictures with many: the median cut.
//!
//! P. Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982.

use std::ops::Range;

/// At most `most` colours near those of `rgb`, three bytes a px. The box of colours in which its largest width times √px is largest is
/// cut at the median of that width, until there are enough boxes; each gives the mean of its px.
#[must_use]
pub fn median_cut(rgb: &[u8], most: usize) -> Vec<[u8; 3]> {
    let mut px: Vec<[u8; 3]> = rgb.chunks_exact(3).map(|px| [px[0], px[1], px[2]]).collect();
    if px.is_empty() || most == 0 {
        return Vec::new();
    }
    let mut boxes: Vec<Range<usize>> = std::iter::once(0..px.len()).collect();
    while boxes.len() < most {
        let widest = boxes.iter().enumerate().max_by_key(|(at, part)| {
            let (_, width) = widest_channel(&px[(*part).clone()]);
            // Of equal ones the first.
            (width as u64 * (part.len() as f64).sqrt() as u64, usize::MAX - at)
        });
        let Some((at, part)) = widest.map(|(at, part)| (at, part.clone())) else { break };
        let (channel, width) = widest_channel(&px[part.clone()]);
        if width == 0 {
            break;
        }
        let inside = &mut px[part.clone()];
        inside.sort_unstable_by_key(|px| (px[channel], *px));
        // Equal values stay together, so that both halves are smaller.
        let median = inside[inside.len() / 2][channel].max(inside[0][channel] + 1);
        let cut = part.start + inside.partition_point(|px| px[channel] < median);
        boxes[at] = part.start..cut;
        boxes.push(cut..part.end);
    }
    let mut colours: Vec<[u8; 3]> = boxes.into_iter().map(|part| mean(&px[part])).collect();
    colours.sort_unstable();
    colours.dedup();
    colours
}

/// The channel in which these colours differ most, and by how much.
fn widest_channel(px: &[[u8; 3]]) -> (usize, u8) {
    let width = |channel: usize| {
        let values = px.iter().map(|px| px[channel]);
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    let widths = [0, 1, 2].map(|channel| (channel, width(channel)));
    widths.into_iter().fold(widths[0], |best, next| if next.1 > best.1 { next } else { best })
}

fn mean(px: &[[u8; 3]]) -> [u8; 3] {
    let count = px.len() as u64;
    [0, 1, 2].map(|channel| {
        let sum: u64 = px.iter().map(|px| u64::from(px[channel])).sum();
        ((sum + count / 2) / count) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_and_each_of_many_has_a_near_one() {
        let few = [[9, 9, 9], [200, 10, 10], [200, 10, 90]];
        let mut kept = median_cut(&few.concat().repeat(40), 8);
        kept.sort_unstable();
        assert_eq!(kept, few);
        let many: Vec<u8> = (0..=255).flat_map(|value| [value, 255 - value, 128]).collect();
        let found = median_cut(&many, 32);
        assert_eq!(found.len(), 32);
        for px in many.chunks_exact(3) {
            let far = |colour: &[u8; 3]| colour[0].abs_diff(px[0]).max(colour[1].abs_diff(px[1]));
            assert!(found.iter().map(far).min() <= Some(8), "{px:?}");
        }
        assert_eq!(median_cut(&[], 8), Vec::<[u8; 3]>::new());
    }
}
