use super::*;

/// A field drawn in text: `#` is 1, `.` 0, digits tenths.
fn drawn(edges: Edges, rows: &[&str]) -> Field {
    let value = |c: char| match c {
        '#' => 1.0,
        c => c.to_digit(10).unwrap_or(0) as f32 / 10.0,
    };
    let values = rows.iter().flat_map(|row| row.chars().map(value)).collect();
    Field { width: rows[0].len(), height: rows.len(), cell: [1.0, 1.0], edges, values }
}

/// (area, touches, endless) of the regions on the field's own grid.
fn seen(field: &Field) -> Vec<(f64, bool, bool)> {
    let all = regions(field, 0.5, 1);
    all.iter().map(|region| (region.moments.area, region.touches, region.endless)).collect()
}

#[test]
fn single_cells_are_diamonds_and_corners_do_not_join() {
    let field = drawn(Edges::Closed, &["......", ".#..#.", "..#...", "......"]);
    // The mean at each saddle is 0.5, which is not above the level.
    assert_eq!(seen(&field), [(0.5, false, false); 3]);
    let field = drawn(Edges::Closed, &[".....", ".#2..", ".2#..", "....."]);
    assert_eq!(seen(&field).len(), 1);
}

#[test]
fn a_fork_that_closes_further_down_is_one_region() {
    let field = drawn(Edges::Closed, &[".......", ".#.#.#.", ".#.#.#.", ".#####.", "......."]);
    assert_eq!(seen(&field).len(), 1);
    let field = drawn(Edges::Closed, &[".....", ".###.", ".#.#.", ".###.", "....."]);
    // A square of side 3 without its four corners and without a diamond in the middle.
    assert_eq!(seen(&field), [(9.0 - 0.5 - 0.5, false, false)]);
}

#[test]
fn the_field_is_mirrored_at_the_border() {
    let field = drawn(Edges::Closed, &["##..", "##..", "....", "...#"]);
    // A square of side 2 without a rounded corner; a square of side 1 without one.
    assert_eq!(seen(&field), [(4.0 - 0.125, true, false), (1.0 - 0.125, true, false)]);
    assert_eq!(seen(&drawn(Edges::Closed, &["#"])), [(1.0, true, false)]);
    assert_eq!(seen(&drawn(Edges::Wrap, &["##", "##"])), [(4.0, false, true)]);
    assert_eq!(seen(&drawn(Edges::Closed, &["#.#", "#.#"])), [(2.0, true, false); 2]);
}

#[test]
fn on_a_tile_four_corners_are_one_spot() {
    let field = drawn(Edges::Wrap, &["#...#", ".....", ".....", ".....", "#...#"]);
    let found = spots(&field, 0.5);
    assert_eq!(found.len(), 1);
    assert!(found[0].whole && !found[0].endless);
    assert!((found[0].ellipse.aspect() - 1.0).abs() < 1e-3);
    // Its centre is the tile's corner, folded to either side of it.
    assert!(found[0].ellipse.center.iter().all(|x| x.min(5.0 - x).abs() < 1e-3));
    assert_eq!(seen(&field), [(3.5, false, false)]);
}

#[test]
fn a_stripe_round_the_tile_is_endless() {
    assert_eq!(seen(&drawn(Edges::Wrap, &["....", "####", "....", "...."])), [(4.0, false, true)]);
    // Down one column and back up across the border, shifted: it meets itself only after two rounds.
    let steps = drawn(Edges::Wrap, &["##....", ".##...", "..##..", "...##.", "....##", "#....#"]);
    assert_eq!(seen(&steps).len(), 1);
    assert!(seen(&steps)[0].2);
    assert_eq!(seen(&drawn(Edges::Closed, &["....", "####", "....", "...."])), [(4.0, true, false)]);
}

#[test]
fn specks_are_counted_and_left_out() {
    let field = drawn(
        Edges::Closed,
        &["..........", ".####.....", ".####..#..", ".####.....", ".####.....", "..........", "....6....."],
    );
    let census = census(&field, 0.5);
    assert_eq!((census.spots.len(), census.specks), (1, 2));
    // Between the cells the smooth surface overshoots a little.
    assert!((1.0..1.4).contains(&census.spots[0].peak));
}

#[test]
fn an_empty_field_and_nan_have_no_spots() {
    assert!(spots(&Field::flat(20, 20, Edges::Closed, 0.2), 0.5).is_empty());
    assert!(spots(&Field::flat(20, 20, Edges::Wrap, f32::NAN), 0.5).is_empty());
    assert!(spots(&Field::flat(0, 0, Edges::Closed, 1.0), 0.5).is_empty());
}

#[test]
fn a_mark_across_all_bands_of_rows_is_one_region() {
    for (edges, endless) in [(Edges::Closed, false), (Edges::Wrap, true)] {
        // Long enough for several bands of rows at any number of nodes a cell.
        let bar = |[x, _]: [f64; 2]| if (100.0..140.0).contains(&x) { 1.0 } else { 0.0 };
        let field = Field::from_fn([300, 3000], [1.0, 1.0], edges, bar);
        let spots = spots(&field, 0.5);
        assert_eq!(spots.len(), 1, "{edges:?}");
        assert!((spots[0].ellipse.area() / (40.0 * 3000.0) - 1.0).abs() < 1e-3, "{edges:?} {spots:?}");
        assert_eq!((spots[0].endless, spots[0].whole), (endless, false), "{edges:?}");
    }
}

#[test]
fn rough_spots_stand_where_exact_ones_do() {
    // Gaussian spots of 12 cells and more at half their peak, at all places within a cell.
    let radius = |column: f64| 2.0 + 0.25 * column;
    let place = |k: usize| [16.0 + 20.0 * (k % 6) as f64 + 0.17 * k as f64, 16.0 + 20.0 * (k / 6) as f64];
    let bell = |[x, y]: [f64; 2]| {
        let one = |k: usize| {
            let [dx, dy] = [x - place(k)[0], y - place(k)[1]];
            let r = radius((k % 6) as f64);
            libm::exp(-libm::log(2.0) * (1.5 * dx * dx + dy * dy / 1.5) / (r * r))
        };
        (0..36).map(one).sum::<f64>() as f32
    };
    let field = Field::from_fn([140, 136], [1.0; 2], Edges::Closed, bell);
    let (exact, rough) = (spots(&field, 0.5), rough_spots_of_at_least(&field, 0.5, f64::INFINITY));
    assert_eq!((exact.len(), rough.len()), (36, 36));
    let mut worst = [0.0_f64; 2];
    for exact in &exact {
        let radius = (exact.ellipse.area() / PI).sqrt();
        let off = |rough: &Spot| {
            let way = [0, 1].map(|axis| exact.ellipse.center[axis] - rough.ellipse.center[axis]);
            (way[0] * way[0] + way[1] * way[1]).sqrt() / radius
        };
        let rough = rough.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("a spot");
        let by_area = (rough.ellipse.area() / exact.ellipse.area() - 1.0).abs();
        worst = [worst[0].max(off(rough)), worst[1].max(by_area)];
    }
    assert!(worst[0] < 0.01 && worst[1] < 0.06, "{worst:?}");
}
