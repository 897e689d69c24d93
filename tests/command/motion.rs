//! `dapple film` through the real binary: the frames and their durations, and refused options.

use assert_cmd::Command;
use image::AnimationDecoder;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const SPOT: &str = r#"{"kind": "ellipse", "center": [24, 24], "radii": [7, 4], "angle": 30}"#;
const LINE: &str = r#"{"kind": "line", "from": [5, 20], "to": [40, 20], "width": 6}"#;

fn document(folder: &TempDir, name: &str, strokes: &str) -> PathBuf {
    let path = folder.path().join(format!("{name}.dapple"));
    let text = format!(
        r#"{{"format": "dapple", "version": 1, "size": [64, 48], "layers": [{{"strokes": [{strokes}]}}]}}"#
    );
    fs::write(&path, text).unwrap();
    path
}

fn dapple() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
}

fn film(file: &Path, output: &Path, options: &[&str]) -> assert_cmd::assert::Assert {
    dapple().arg("film").arg(file).arg("-o").arg(output).args(options).arg("--quiet").assert()
}

fn frames(folder: &Path) -> Vec<Vec<u8>> {
    let mut names: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    names.iter().map(|path| image::open(path).unwrap().into_rgb8().into_raw()).collect()
}

/// Type and data of each chunk of a PNG, parsed here.
fn chunks(png: &[u8]) -> Vec<(&[u8], &[u8])> {
    let mut rest = &png[8..];
    let mut chunks = Vec::new();
    while rest.len() >= 12 {
        let length = u32::from_be_bytes(rest[..4].try_into().unwrap()) as usize;
        chunks.push((&rest[4..8], &rest[8..8 + length]));
        rest = &rest[12 + length..];
    }
    chunks
}

/// Delays, hundredths of a second, of a GIF's frames, and whether it repeats; parsed here.
fn gif(bytes: &[u8]) -> (Vec<u16>, bool) {
    assert_eq!(&bytes[..6], b"GIF89a");
    let table = |flags: u8| if flags & 0x80 != 0 { 3 << ((flags & 7) + 1) } else { 0 };
    let mut at = 13 + table(bytes[10]);
    let (mut delays, mut again) = (Vec::new(), false);
    while bytes[at] != 0x3b {
        at += match bytes[at] {
            0x21 => {
                match bytes[at + 1] {
                    0xf9 => delays.push(u16::from_le_bytes([bytes[at + 4], bytes[at + 5]])),
                    0xff => again |= &bytes[at + 3..at + 14] == b"NETSCAPE2.0",
                    _ => {}
                }
                2
            }
            0x2c => 11 + table(bytes[at + 9]),
            other => panic!("a block of kind {other}"),
        };
        while bytes[at] != 0 {
            at += 1 + usize::from(bytes[at]);
        }
        at += 1;
    }
    (delays, again)
}

/// The frames of a GIF or an animated PNG, decoded by another library: red, green, blue for each px.
fn shown(frames: image::Frames) -> Vec<Vec<u8>> {
    let frames = frames.collect_frames().unwrap();
    frames
        .into_iter()
        .map(|frame| image::DynamicImage::ImageRgba8(frame.into_buffer()).into_rgb8().into_raw())
        .collect()
}

/// Decodes the frames of a GIF independently of the library that wrote it: LZW of variable width; transparent px keep
/// their colour (CompuServe 1990, appendix F).
fn painted(bytes: &[u8], over: Option<&[u8]>) -> Vec<Vec<u8>> {
    let word = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    let (width, height) = (word(6), word(8));
    let palette = &bytes[13..13 + (3 << ((bytes[10] & 7) + 1))];
    let mut at = 13 + palette.len();
    let mut canvas = over.map_or(vec![0; 3 * width * height], <[u8]>::to_vec);
    let (mut clear, mut frames) = (None, Vec::new());
    while bytes[at] != 0x3b {
        let (mut block, is_frame) = match bytes[at] {
            0x21 => (at + 2, None),
            _ => (at + 11, Some(at)),
        };
        if bytes[at..at + 2] == [0x21, 0xf9] {
            // Frames are not disposed of; the sixth byte is the transparent colour.
            assert_eq!(bytes[at + 3] >> 2 & 7, 1);
            clear = (bytes[at + 3] & 1 == 1).then_some(bytes[at + 6]);
        }
        let mut data = Vec::new();
        while bytes[block] != 0 {
            let length = usize::from(bytes[block]);
            data.extend_from_slice(&bytes[block + 1..block + 1 + length]);
            block += 1 + length;
        }
        if let Some(frame) = is_frame {
            assert_eq!(bytes[frame + 9], 0, "no palette of its own, not interlaced");
            let [left, top, across] = [1, 3, 5].map(|i| word(frame + i));
            for (i, index) in unpacked(&data, u32::from(bytes[frame + 10])).into_iter().enumerate() {
                if Some(index) != clear {
                    let px = 3 * ((top + i / across) * width + left + i % across);
                    canvas[px..px + 3].copy_from_slice(&palette[3 * usize::from(index)..][..3]);
                }
            }
            frames.push(canvas.clone());
        }
        at = block + 1;
    }
    frames
}

fn unpacked(data: &[u8], least: u32) -> Vec<u8> {
    let (clear, end) = (1_usize << least, (1_usize << least) + 1);
    let (mut table, mut width): (Vec<Vec<u8>>, u32) = (Vec::new(), least + 1);
    let (mut out, mut last): (Vec<u8>, Option<Vec<u8>>) = (Vec::new(), None);
    let mut bit = 0;
    loop {
        let code = (0..width as usize)
            .fold(0, |code, i| code | usize::from(data[(bit + i) / 8] >> ((bit + i) % 8) & 1) << i);
        bit += width as usize;
        if code == clear {
            table = (0..clear + 2).map(|value| vec![value as u8]).collect();
            (width, last) = (least + 1, None);
            continue;
        }
        if code == end {
            return out;
        }
        let entry = match (&last, table.get(code)) {
            (_, Some(entry)) => entry.clone(),
            (Some(last), None) => [&last[..], &last[..1]].concat(),
            (None, None) => panic!("a code before its entry"),
        };
        out.extend_from_slice(&entry);
        if let Some(last) = last.filter(|_| table.len() < 4096) {
            table.push([&last[..], &entry[..1]].concat());
        }
        if table.len() == 1 << width && width < 12 {
            width += 1;
        }
        last = Some(entry);
    }
}

const SHORT: [&str; 4] = ["--seconds", "1", "--fps", "8"];

#[test]
fn the_last_frame_is_the_settled_texture_and_the_first_is_not() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", SPOT);
    let (clip, picture) = (folder.path().join("clip"), folder.path().join("still.png"));
    film(&file, &clip, &SHORT).success();
    dapple().arg("grow").arg(&file).arg("-o").arg(&picture).assert().success();
    let frames = frames(&clip);
    assert_eq!(frames.len(), 8);
    let settled = image::open(picture).unwrap().into_rgb8().into_raw();
    assert!(frames[7] == settled && frames[0] != settled);
}

#[test]
fn frames_are_spaced_by_visible_change() {
    let folder = TempDir::new().unwrap();
    let (file, clip) = (document(&folder, "stripes", LINE), folder.path().join("clip"));
    film(&file, &clip, &SHORT).success();
    let frames = frames(&clip);
    let far = |pair: &[Vec<u8>]| -> f64 {
        let parts = pair[0].iter().zip(&pair[1]).map(|(a, b)| f64::from(a.abs_diff(*b)));
        parts.sum::<f64>() / pair[0].len() as f64
    };
    let ways: Vec<f64> = frames.windows(2).map(far).collect();
    let mean = ways.iter().sum::<f64>() / ways.len() as f64;
    assert!(mean > 1.0 && ways.iter().all(|way| *way < 3.0 * mean), "{ways:?}");
}

#[test]
fn patches_streaks_and_cracks_grow_from_their_starting_points() {
    let folder = TempDir::new().unwrap();
    let blot = r#"{"kind": "outline", "points": [[20,20],[34,16],[44,26],[40,38],[28,42],[18,32]]}"#;
    let colours = r##"{"stops": [{"at": 0, "colour": "#ffffff"}, {"at": 1, "colour": "#000000"}]}"##;
    for (system, stroke) in [("patches", blot), ("streaks", LINE), ("cracks", LINE)] {
        let (file, clip) = (folder.path().join(format!("{system}.dapple")), folder.path().join(system));
        let layer = format!(r#"{{"system": "{system}", "strokes": [{stroke}], "colours": {colours}}}"#);
        let text = format!(
            r#"{{"format": "dapple", "version": 2, "size": [160, 120], "edges": "wrap", "layers": [{layer}]}}"#
        );
        fs::write(&file, text).unwrap();
        film(&file, &clip, &SHORT).success();
        let ink = |frame: &Vec<u8>| frame.chunks(3).filter(|px| px[0] < 128).count();
        let ink: Vec<usize> = frames(&clip).iter().map(ink).collect();
        assert!(
            ink.is_sorted() && ink[0] < ink[7] / 3 && ink[3] > ink[0] && ink[7] > 1_000,
            "{system}: {ink:?}"
        );
    }
}

#[test]
fn the_same_document_gives_the_same_bytes_by_any_number_of_threads() {
    let folder = TempDir::new().unwrap();
    let file = document(&folder, "spots", SPOT);
    for ending in ["gif", "png"] {
        let clips = ["1", "3"].map(|threads| {
            let clip = folder.path().join(format!("{threads}.{ending}"));
            film(&file, &clip, &[&SHORT[..], &["--threads", threads]].concat()).success();
            fs::read(clip).unwrap()
        });
        assert!(clips[0] == clips[1], "{ending}");
    }
}

#[test]
fn a_gif_stores_the_duration_of_each_frame_and_whether_it_repeats() {
    let folder = TempDir::new().unwrap();
    let (file, clip) = (document(&folder, "spots", SPOT), folder.path().join("clip.gif"));
    film(&file, &clip, &[&SHORT[..], &["--hold", "2"]].concat()).success();
    let (delays, again) = gif(&fs::read(&clip).unwrap());
    assert_eq!((delays, again), (vec![13, 12, 13, 12, 13, 12, 13, 212], true));
    film(&file, &clip, &[&SHORT[..], &["--once", "--side", "32"]].concat()).success();
    let bytes = fs::read(&clip).unwrap();
    assert!(!gif(&bytes).1);
    assert_eq!([bytes[6], bytes[8]], [32, 24]);
}

#[test]
fn an_animated_png_stores_the_same_and_shows_its_first_frame_in_any_viewer() {
    let folder = TempDir::new().unwrap();
    let (file, clip, still) =
        (document(&folder, "spots", SPOT), folder.path().join("clip.png"), folder.path().join("clip"));
    film(&file, &clip, &[&SHORT[..], &["--hold", "1"]].concat()).success();
    film(&file, &still, &SHORT).success();
    let bytes = fs::read(&clip).unwrap();
    let control = |kind: &[u8]| -> Vec<Vec<u8>> {
        let chunks = chunks(&bytes).into_iter().filter(|(found, _)| *found == kind);
        chunks.map(|(_, data)| data.to_vec()).collect()
    };
    assert_eq!(control(b"acTL"), [[0, 0, 0, 8, 0, 0, 0, 0]]);
    let delays: Vec<[u16; 2]> = control(b"fcTL")
        .iter()
        .map(|data| [20, 22].map(|at| u16::from_be_bytes([data[at], data[at + 1]])))
        .collect();
    assert_eq!((delays.len(), delays[0], delays[7]), (8, [1, 8], [112, 100]));
    assert!(image::open(&clip).unwrap().into_rgb8().into_raw() == frames(&still)[0]);
}

#[test]
fn a_reader_decodes_the_frames_of_an_animated_png_px_for_px() {
    let folder = TempDir::new().unwrap();
    let (file, clip, still) =
        (document(&folder, "spots", SPOT), folder.path().join("clip.png"), folder.path().join("clip"));
    film(&file, &clip, &SHORT).success();
    film(&file, &still, &SHORT).success();
    let decoder =
        image::codecs::png::PngDecoder::new(std::io::Cursor::new(fs::read(&clip).unwrap())).unwrap();
    let seen = shown(decoder.apng().unwrap().into_frames());
    assert!(seen == frames(&still));
}

#[test]
fn a_reader_decodes_the_frames_of_a_gif_as_exactly_as_255_colours_allow() {
    let folder = TempDir::new().unwrap();
    let (file, clip, still) =
        (document(&folder, "spots", SPOT), folder.path().join("clip.gif"), folder.path().join("clip"));
    film(&file, &clip, &SHORT).success();
    film(&file, &still, &SHORT).success();
    let bytes = fs::read(&clip).unwrap();
    let (seen, frames) = (painted(&bytes, None), frames(&still));
    assert_eq!(seen.len(), frames.len());
    let palette = &bytes[13..13 + 3 * 255];
    // Green has the largest weight and blue the smallest.
    let far = |a: &[u8], b: &[u8]| -> i32 {
        let parts = a.iter().zip(b).map(|(a, b)| i32::from(*a) - i32::from(*b));
        parts.zip([3, 6, 1]).map(|(part, weight)| weight * part * part).sum()
    };
    for (seen, frame) in seen.iter().zip(&frames) {
        assert_eq!(seen.len(), frame.len());
        for (seen, wanted) in seen.chunks_exact(3).zip(frame.chunks_exact(3)) {
            let nearest = palette.chunks_exact(3).map(|colour| far(colour, wanted)).min().unwrap();
            assert_eq!(far(seen, wanted), nearest, "{seen:?} for {wanted:?}");
        }
        let off: f64 = seen.iter().zip(frame).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
        assert!(off < frame.len() as f64, "{} in the mean", off / frame.len() as f64);
    }
    // When the film repeats, nothing of its last frame is left.
    assert!(seen[0] != seen[7] && painted(&bytes, Some(&seen[7])) == seen);
}

#[cfg(unix)]
#[test]
fn an_interrupted_film_is_reported_and_leaves_nothing_behind() {
    for name in ["clip.gif", "clip.png", "clip"] {
        let folder = TempDir::new().unwrap();
        let file = document(&folder, "spots", SPOT);
        let output = folder.path().join(name);
        let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
            .arg("film")
            .arg(&file)
            .arg("-o")
            .arg(&output)
            .args(["--seconds", "100", "--fps", "50", "--side", "2000", "--quiet"])
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let names = || -> Vec<String> {
            let entries = fs::read_dir(folder.path()).unwrap();
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
        };
        // Frames are being written; the program must not have ended yet.
        while !names().iter().any(|name| name.ends_with(".part")) {
            assert_eq!(child.try_wait().unwrap(), None, "it ended before it could be interrupted");
            std::thread::yield_now();
        }
        let sent = std::process::Command::new("sh")
            .args(["-c", &format!("kill -INT {}", child.id())])
            .status()
            .unwrap();
        assert!(sent.success());
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), message.as_str()), (Some(130), "error: interrupted\n"), "{name}");
        assert_eq!(names(), ["spots.dapple"], "{name}");
    }
}

#[test]
fn a_morph_between_two_documents_is_smooth() {
    let folder = TempDir::new().unwrap();
    let a = document(&folder, "a", SPOT);
    let b = document(&folder, "b", &SPOT.replace("[7, 4]", "[4, 4]"));
    let clip = folder.path().join("clip");
    film(&a, &clip, &["--to", b.to_str().unwrap(), "--seconds", "2", "--fps", "10"]).success();
    let frames = frames(&clip);
    assert_eq!(frames.len(), 20);
    let far = |a: &[u8], b: &[u8]| -> u64 { a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum() };
    let all = far(&frames[0], &frames[19]);
    assert!(all > 0 && frames.windows(2).all(|pair| far(&pair[0], &pair[1]) < all), "a cut");
}

#[test]
fn a_film_from_thin_stripes_to_wide_ones_is_refused_with_the_remedy() {
    let folder = TempDir::new().unwrap();
    let of_duty = |duty: f64| {
        let path = folder.path().join(format!("{duty}.dapple"));
        let text = format!(
            r#"{{"format": "dapple", "version": 2, "size": [64, 48],
            "layers": [{{"system": "meinhardt-lines", "strokes": [{LINE}], "options": {{"duty": {duty}}}}}]}}"#
        );
        fs::write(&path, text).unwrap();
        path
    };
    let [thin, wide] = [0.3, 0.7].map(of_duty);
    let output = folder.path().join("a.gif");
    let refused = film(&thin, &output, &["--to", wide.to_str().unwrap()]).code(1);
    let message = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
    assert!(message.contains("give both a duty up to 0.5, or both from 0.5 on"), "{message}");
    assert!(!output.exists());
}

#[test]
fn an_impossible_film_is_refused_with_the_remedy_and_leaves_no_file() {
    let folder = TempDir::new().unwrap();
    let (spots, stripes) = (document(&folder, "spots", SPOT), document(&folder, "stripes", LINE));
    let full = folder.path().join("full");
    fs::create_dir(&full).unwrap();
    fs::write(full.join("mine.txt"), "keep").unwrap();
    let clip = folder.path().join("clip.gif");
    let refused = |output: &Path, options: &[&str], code: i32, word: &str| {
        let message = String::from_utf8(film(&spots, output, options).code(code).get_output().stderr.clone());
        let message = message.unwrap();
        assert!(message.contains(word), "{word} in {message}");
    };
    refused(&clip, &["--to", stripes.to_str().unwrap()], 1, "draw ellipses in both");
    refused(&clip, &["--fps", "60"], 2, "1 to 50");
    refused(&clip, &["--seconds", "0.05"], 2, "2 to 20000");
    refused(&folder.path().join("clip.mp4"), &[], 1, ".gif, .png, .apng");
    refused(&full, &[], 1, "not empty");
    refused(&spots, &[], 2, "twice");
    let mut left: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    left.sort();
    assert_eq!(left, ["full", "spots.dapple", "stripes.dapple"]);
}
