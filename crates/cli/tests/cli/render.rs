use std::path::{Path, PathBuf};

use crate::bisect::faulty;
use crate::sandbox::Sandbox;

/// A picture, decoded: its sides and three bytes a pixel.
#[derive(PartialEq)]
struct Pixels {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

impl Pixels {
    fn of_png(file: &[u8]) -> Self {
        let decoder = png::Decoder::new(std::io::Cursor::new(file));
        let mut reader = decoder.read_info().expect("a PNG");
        let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut bytes).expect("an image");
        assert_eq!((info.color_type, info.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
        Self { width: info.width as usize, height: info.height as usize, bytes }
    }

    fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    fn pixel(&self, x: usize, y: usize) -> [u8; 3] {
        let at = 3 * (y * self.width + x);
        [self.bytes[at], self.bytes[at + 1], self.bytes[at + 2]]
    }

    /// The part of a size from a corner.
    fn part(&self, left: usize, top: usize, (width, height): (usize, usize)) -> Self {
        let rows = self.bytes.chunks_exact(3 * self.width).skip(top).take(height);
        let bytes = rows.flat_map(|row| &row[3 * left..3 * (left + width)]).copied().collect();
        Self { width, height, bytes }
    }

    /// The middle of the pixels of a colour that `is` tells.
    fn middle_of(&self, is: impl Fn([u8; 3]) -> bool) -> [usize; 2] {
        let all = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        let found: Vec<_> = all.filter(|&(x, y)| is(self.pixel(x, y))).collect();
        assert!(!found.is_empty(), "no pixel of this colour");
        let sum = found.iter().fold((0, 0), |sum, at| (sum.0 + at.0, sum.1 + at.1));
        [sum.0 / found.len(), sum.1 / found.len()]
    }
}

/// The frames of a film as a viewer shows them, and for how many hundredths of a second.
fn frames_of_gif(file: &[u8]) -> Vec<(Pixels, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(file).expect("a GIF");
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    let mut shown = vec![0; 3 * width * height];
    let mut frames = vec![];
    while let Some(frame) = decoder.read_next_frame().expect("a frame") {
        let columns = usize::from(frame.width);
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let x = usize::from(frame.left) + index % columns;
            let y = usize::from(frame.top) + index / columns;
            if pixel[3] > 0 {
                shown[3 * (y * width + x)..][..3].copy_from_slice(&pixel[..3]);
            }
        }
        frames.push((Pixels { width, height, bytes: shown.clone() }, frame.delay));
    }
    frames
}

pub(crate) fn fixture(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures").join(path)
}

/// A camera that does not depend on what is shown.
const CAMERA: [&str; 6] = ["--camera", "0.5,-0.5,5", "--target", "0.5,-0.5,0", "--size", "64x48"];

fn render(sandbox: &Sandbox, args: &[&str]) -> crate::sandbox::Outcome {
    sandbox.run(&[&["render"], args].concat())
}

/// The report tells what was written, and a picture has the size that was asked for.
#[test]
fn a_picture_is_told() {
    let sandbox = Sandbox::recorded("render-told");
    let report = render(&sandbox, &["a.ron", "-o", "a.png", "--tick", "3"]).expect(0);
    assert!(report.text().starts_with("a.png: tick 3, 640x480, pixels "), "{}", report.text());
    assert_eq!(Pixels::of_png(&sandbox.read("a.png")).size(), (640, 480));

    let args = ["a.replay", "-o", "b.PNG", "--size", "100x20", "--json"];
    let json = render(&sandbox, &args).expect(0).json();
    let pixels = Pixels::of_png(&sandbox.read("b.PNG"));
    assert_eq!(pixels.size(), (100, 20));
    let hash = verlock::Hash::of(&pixels.bytes).to_string();
    let file = &json["files"][0];
    assert_eq!((&file["path"], &file["pixels"]), (&"b.PNG".into(), &hash.into()));
    assert_eq!(
        (&file["ticks"][0], &file["width"], &file["height"]),
        (&6.into(), &100.into(), &20.into())
    );
}

/// The same worlds give the same bytes: again, and from a scene, a replay, a snapshot and stdin.
#[test]
fn same_worlds_same_bytes() {
    let sandbox = Sandbox::recorded("render-same");
    render(&sandbox, &["a.ron", "--tick", "6", "-o", "a.png"]).expect(0);
    let expected = sandbox.read("a.png");
    for file in ["a.ron", "a.replay", "a.snap"] {
        let outcome = render(&sandbox, &[file, "--tick", "6"]).expect(0);
        assert!(outcome.stdout == expected, "{file}");
        assert!(outcome.stderr.starts_with("-: tick 6, "), "{}", outcome.stderr);
    }
    let outcome = sandbox.run_with(&["render", "-"], &sandbox.read("a.snap")).expect(0);
    assert!(outcome.stdout == expected);
    let film = ["--every", "2", "--size", "64x48", "-o"];
    render(&sandbox, &[&["a.ron"], &film[..], &["a.gif"]].concat()).expect(0);
    render(&sandbox, &[&["a.replay"], &film[..], &["b.gif"]].concat()).expect(0);
    assert!(sandbox.read("a.gif") == sandbox.read("b.gif"));
}

/// Where a world stands does not matter: a scene and the same 10^9 m away look the same.
#[test]
fn far_worlds_look_the_same() {
    let sandbox = Sandbox::new("render-far");
    let picture = |name: &str| {
        let path = fixture(&format!("scenes/{name}.scene.ron"));
        let path = path.to_str().expect("UTF-8");
        render(&sandbox, &[path, "--tick", "90", "--size", "320x240"]).expect(0).stdout
    };
    assert!(picture("near") == picture("far"));
}

/// A sheet holds the frames in rows with two pixels between them, a folder each in a file, and a
/// film shows them one after another, for as long as their ticks take.
#[test]
fn several_frames() {
    let sandbox = Sandbox::recorded("render-several");
    let range = ["--from", "1", "--to", "6", "--every", "2"];
    let several = |output: &[&str]| {
        render(&sandbox, &[&["a.replay"], &range[..], &CAMERA[..], output].concat()).expect(0)
    };
    let report = several(&["-o", "frames/all"]);
    assert_eq!(report.text().lines().count(), 3, "{}", report.text());
    let frames = [1, 3, 5].map(|tick| {
        let tick = tick.to_string();
        let alone = [&["a.ron", "--tick", &tick], &CAMERA[..]].concat();
        let alone = render(&sandbox, &alone).expect(0).stdout;
        assert!(sandbox.read(&format!("frames/all/00000{tick}.png")) == alone, "tick {tick}");
        Pixels::of_png(&alone)
    });
    assert!(frames[0] != frames[1] && frames[1] != frames[2], "the rope moves");

    let report = several(&["-o", "sheet.png", "--sheet", "2"]);
    assert!(report.text().starts_with("sheet.png: every 2 ticks from 1 to 6, 130x98, pixels "));
    let sheet = Pixels::of_png(&sandbox.read("sheet.png"));
    assert_eq!(sheet.size(), (130, 98));
    for (frame, (left, top)) in frames.iter().zip([(0, 0), (66, 0), (0, 50)]) {
        assert!(sheet.part(left, top, (64, 48)) == *frame, "the frame at {left}, {top}");
    }

    let json = several(&["-o", "film.gif", "--json"]).json();
    assert_eq!(json["files"][0]["ticks"], serde_json::json!([1, 3, 5]));
    let shown = frames_of_gif(&sandbox.read("film.gif"));
    assert_eq!(shown.iter().map(|&(_, delay)| delay).collect::<Vec<_>>(), [3, 3, 4], "6/60 s");
    for ((shown, _), frame) in shown.iter().zip(&frames) {
        // Few colours: they all have their place in the palette.
        assert!(shown == frame);
    }
}

/// Up is up, right is right, and what is near is larger and hides what is far.
#[test]
fn pictures_are_the_right_way_round() {
    let sandbox = Sandbox::new("render-way");
    let scene = "(version: 1, particles: [
        (position: (1, 1, 0), pinned: true), (position: (-1, -1, 0)),
    ])";
    sandbox.write("two.ron", scene.as_bytes());
    let is_red = |[r, g, b]: [u8; 3]| r > g.max(b).saturating_add(50);
    let is_blue = |[r, g, b]: [u8; 3]| b > r.max(g).saturating_add(50);
    let picture = |view: &str| {
        let args = ["two.ron", "--view", view, "--size", "200x200", "--no-grid"];
        Pixels::of_png(&render(&sandbox, &args).expect(0).stdout)
    };
    let front = picture("front");
    let ([red_x, red_y], [blue_x, blue_y]) = (front.middle_of(is_red), front.middle_of(is_blue));
    assert!(red_x > 150 && red_y < 50 && blue_x < 50 && blue_y > 150);
    let top = picture("top");
    assert!(top.middle_of(is_red)[0] > 150 && top.middle_of(is_blue)[0] < 50);

    // Seen along the z axis, the nearer one alone, but for a rim of the larger, pinned one.
    let scene = scene.replace("(1, 1, 0)", "(0, 0, -8)").replace("(-1, -1, 0)", "(0, 0, 0)");
    sandbox.write("two.ron", scene.as_bytes());
    let args = ["two.ron", "--camera", "0,0,4", "--target", "0,0,0", "--size", "200x200"];
    let picture = Pixels::of_png(&render(&sandbox, &args).expect(0).stdout);
    assert!(is_blue(picture.pixel(100, 100)));
    let args = [&args[..], &["--force", "-o", "back.png"]].concat();
    let args: Vec<_> = args.into_iter().map(|a| if a == "0,0,4" { "0,0,-12" } else { a }).collect();
    render(&sandbox, &args).expect(0);
    assert!(is_red(Pixels::of_png(&sandbox.read("back.png")).pixel(100, 100)));
}

/// Each option changes the picture; a label for every particle is among them.
#[test]
fn options_are_heeded() {
    let sandbox = Sandbox::recorded("render-options");
    let plain = render(&sandbox, &["a.snap"]).expect(0).stdout;
    for options in [
        &["--no-grid"][..],
        &["--labels"],
        &["--fov", "60"],
        &["--view", "side"],
        &["--camera", "-1,2,3"],
        &["--camera", "-1,2,3", "--target", "-0.5,0,0"],
    ] {
        let picture = render(&sandbox, &[&["a.snap"], options].concat()).expect(0).stdout;
        assert!(picture != plain, "{options:?}");
    }
    // Nothing here is covered by faces.
    for option in ["--particles", "--constraints"] {
        assert!(render(&sandbox, &["a.snap", option]).expect(0).stdout == plain, "{option}");
    }
}

/// What is there stays, unless `--force` is given; of a folder nothing is written then.
#[test]
fn nothing_is_painted_over() {
    let sandbox = Sandbox::recorded("render-force");
    for file in ["a.png", "a.gif", "all/000004.png"] {
        sandbox.write(file, b"precious");
        let output = file.split('/').next().expect("a name");
        let args = ["a.replay", "--size", "16x16", "-o", output];
        render(&sandbox, &args).expect(2).says(&format!("{file}: exists"));
        assert_eq!(sandbox.read(file), b"precious");
        assert!(!sandbox.path("all/000000.png").exists());
        render(&sandbox, &[&args[..], &["--force"]].concat()).expect(0);
        assert_ne!(sandbox.read(file), b"precious");
    }
}

/// A world that is not the recorded one is painted, but not in silence.
#[test]
fn other_worlds_are_told() {
    let sandbox = faulty("render-other", "0");
    let note = "b.replay: tick 4: stepping again gives another state than recorded";
    let small = ["--size", "16x16", "--force", "-o", "b.png"];
    let paint = |args: &[&str]| render(&sandbox, &[&["b.replay"], args, &small].concat()).expect(0);
    paint(&["--tick", "4"]).says(note);
    paint(&["--sheet", "9"]).says(note);
    assert_eq!(paint(&["--tick", "4", "--json"]).json()["note"], note);
    assert_eq!(paint(&["--tick", "3", "--json"]).json()["note"], serde_json::Value::Null);
    assert_eq!(paint(&["--tick", "3"]).stderr, "");
    assert_eq!(paint(&["--sheet", "4", "--to", "3"]).stderr, "");
}

/// What makes no sense is 2, and what proves nothing is 3.
#[test]
fn bad_options_are_refused() {
    let sandbox = Sandbox::recorded("render-bad");
    for (args, why) in [
        (&["a.ron", "-o", "a.jpg"][..], "neither .png nor .gif"),
        (&["a.ron", "-o", "a.png", "--to", "3"], "several ticks need"),
        (&["a.ron", "-o", "a.gif", "--sheet", "2"], "a contact sheet is one .png"),
        (&["a.ron", "-o", "a.gif", "--from", "9"], "--from 9 is later than --to 6"),
        (&["a.replay", "--tick", "7"], "tick 7 is not in it"),
        (&["a.replay", "-o", "all", "--to", "7"], "tick 7 is not in it"),
        (&["a.snap", "-o", "all", "--from", "5"], "tick 5 is not in it"),
        (&["a.ron", "--camera", "1,2,3", "--target", "1,2,3"], "stands at what it looks at"),
        (&["a.ron", "--sheet", "1", "--to", "99999"], "too large a sheet"),
    ] {
        render(&sandbox, args).expect(2).says(why);
    }
    for args in [
        &["a.ron", "--size", "640"][..],
        &["a.ron", "--size", "15x640"],
        &["a.ron", "--size", "640x4097"],
        &["a.ron", "--every", "0", "-o", "all"],
        &["a.ron", "--tick", "1", "--from", "1"],
        &["a.ron", "--camera", "1,2"],
        &["a.ron", "--camera", "1,2,3,4"],
        &["a.ron", "--camera", "1,2,68719476737"],
        &["a.ron", "--target", "1,2,3"],
        &["a.ron", "--camera", "1,2,3", "--view", "top"],
        &["a.ron", "--fov", "121"],
    ] {
        let outcome = render(&sandbox, args).expect(2);
        assert!(outcome.stdout.is_empty(), "{args:?}");
    }
    sandbox.write("bad", b"(version: 1, colour: 3)");
    render(&sandbox, &["bad"]).expect(3).says("bad: ");
    assert!(!sandbox.path("all").exists());
}

/// The pictures of the README are what its commands paint, pixel by pixel.
#[test]
fn pictures_are_as_accepted() {
    let [bless, ci] = ["BLESS", "CI"].map(|name| std::env::var_os(name).is_some());
    assert!(!(bless && ci), "goldens are not accepted where CI is set");
    let root = fixture("..");
    let readme = std::fs::read_to_string(root.join("README.md")).expect("a text");
    let commands = readme.lines().filter_map(|line| line.strip_prefix("verlock "));
    let shown = commands.filter_map(|line| {
        let ways = [" -o docs/pictures/", " --render docs/pictures/"];
        ways.into_iter().find_map(|way| line.split_once(way))
    });
    let mut count = 0;
    for (args, name) in shown {
        let sandbox = Sandbox::new("render-golden");
        let way = if args.starts_with("render ") { "-o" } else { "--render" };
        let picture = sandbox.path("picture.png").display().to_string();
        let args: Vec<_> = args.split_whitespace().chain([way, &picture]).collect();
        let output = sandbox.command(&args).current_dir(&root).output();
        assert!(output.expect("the command to run").status.success(), "{name}");
        let found = sandbox.read("picture.png");
        let accepted = root.join("docs/pictures").join(name);
        if bless {
            std::fs::write(&accepted, &found).expect("a file to write");
        }
        let accepted = Pixels::of_png(&std::fs::read(&accepted).expect("an accepted picture"));
        let found = Pixels::of_png(&found);
        assert_eq!(accepted.size(), found.size(), "{name}");
        let differing = accepted.bytes.iter().zip(&found.bytes).filter(|(a, b)| a != b).count();
        assert_eq!(
            differing, 0,
            "{name}: so many bytes of its pixels differ; if this is meant:\n\
             BLESS=1 cargo test -p verlock-cli pictures_are_as_accepted"
        );
        count += 1;
    }
    assert!(count >= 3, "only {count} pictures were compared");
}
