//! Marching squares: how level lines lead through a square between four nodes.
//!
//! W. E. Lorensen, H. E. Cline, "Marching cubes", SIGGRAPH 1987, in the plane.

/// The lines through a square, each as the side by which it enters and the side by which it leaves. Corners are numbered clockwise from
/// the upper left one (y runs down), and side k lies between corners k and k + 1; what is `above` the level is on a line's right.
///
/// Of a square of which two opposite corners alone are above, `are_joined` says whether these are joined through its middle.
pub fn lines(above: [bool; 4], are_joined: impl FnOnce() -> bool) -> impl Iterator<Item = [usize; 2]> {
    let is_saddle = above[0] != above[1] && above[0] == above[2] && above[1] == above[3];
    // Round the corner that is below, which comes next, or round the one above.
    let step = is_saddle.then(|| if are_joined() { 1 } else { 3 });
    let enters = move |side: &usize| above[*side] && !above[(side + 1) % 4];
    let leaves = move |side: &usize| !above[*side] && above[(side + 1) % 4];
    (0..4).filter(enters).filter_map(move |side| {
        let end = match step {
            Some(step) => Some((side + step) % 4),
            None => (0..4).find(leaves),
        };
        Some([side, end?])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn through(above: [bool; 4], joined: bool) -> Vec<[usize; 2]> {
        lines(above, || joined).collect()
    }

    #[test]
    fn a_line_has_what_is_above_on_its_right() {
        assert!(through([true; 4], true).is_empty() && through([false; 4], true).is_empty());
        // Above is the left half: down, from the upper side to the lower one.
        assert_eq!(through([true, false, false, true], false), [[0, 2]]);
        // One corner is above, or below.
        assert_eq!(through([false, false, true, false], false), [[2, 1]]);
        assert_eq!(through([true, true, true, false], false), [[2, 3]]);
    }

    #[test]
    fn opposite_corners_are_joined_or_cut_off() {
        let saddle = [true, false, true, false];
        assert_eq!(through(saddle, true), [[0, 1], [2, 3]]);
        assert_eq!(through(saddle, false), [[0, 3], [2, 1]]);
    }
}
