//! What must hold of cameras, shapes and palettes.

use verlock::Vec3;
use verlock::math::Pcg;
use verlock::world::{DrawSink as _, Shade};

use super::bounds::{Bounds, all_corners};
use super::camera::{Camera, Lens};
use super::canvas::{Canvas, PIXEL, Spot};
use super::colour::{BACKGROUND, Rgb};
use super::painter::{Painter, Style};
use super::palette::{COLOURS_MAX, Palette};
use super::picture::Picture;
use super::view::View;

const RED: Rgb = Rgb([255, 0, 0]);
const GREEN: Rgb = Rgb([0, 255, 0]);

fn spot(x: i64, y: i64, near: i64) -> Spot {
    Spot { x, y, near }
}

fn pixel(picture: &Picture, x: usize, y: usize) -> Rgb {
    let at = 3 * (y * picture.width as usize + x);
    Rgb([picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]])
}

/// Triangles around a point cover what the polygon of their outer corners does: there is no gap
/// between them, and no sample belongs to two, since the order in which they come is the same.
#[test]
fn neighbours_leave_no_gap_and_do_not_overlap() {
    let mut random = Pcg::new(1, 1);
    let mut draw = |low: i64, span: u32| low + i64::from(random.below(span));
    for _ in 0..50 {
        let outer = [
            spot(draw(0, 900), draw(0, 900), 5),
            spot(draw(3000, 1000), draw(0, 900), 5),
            spot(draw(3000, 1200), draw(3000, 1200), 5),
            spot(draw(-90, 990), draw(3000, 1000), 5),
        ];
        let middle = spot(draw(1500, 1000), draw(1500, 1000), 5);
        let colours = [[9; 3], [60; 3], [120; 3], [200; 3]].map(Rgb);
        let fan = |order: [usize; 4], colours: [Rgb; 4]| {
            let mut canvas = Canvas::new(64, 64);
            for side in order {
                let corners = [outer[side], outer[(side + 1) % 4], middle];
                canvas.polygon(&corners, colours[side]);
            }
            canvas.paint()
        };
        let mut whole = Canvas::new(64, 64);
        whole.polygon(&outer, RED);
        assert!(fan([0, 1, 2, 3], [RED; 4]) == whole.paint(), "{outer:?} {middle:?}");
        assert!(fan([0, 1, 2, 3], colours) == fan([3, 1, 0, 2], colours), "{outer:?} {middle:?}");
    }
}

/// A square fills its pixels and no other; half of a pixel is half of its colour.
#[test]
fn coverage_is_area() {
    let mut canvas = Canvas::new(16, 16);
    let [left, right] = [2 * PIXEL, 5 * PIXEL + PIXEL / 2];
    let corners = [(left, left), (right, left), (right, right), (left, right)];
    canvas.polygon(&corners.map(|(x, y)| spot(x, y, 1)), RED);
    let picture = canvas.paint();
    assert_eq!(pixel(&picture, 2, 2), RED);
    assert_eq!(pixel(&picture, 1, 2), BACKGROUND);
    assert_eq!(pixel(&picture, 5, 3), BACKGROUND.mix(RED, 128));
    assert_eq!(pixel(&picture, 5, 5), BACKGROUND.mix(RED, 64));
}

/// Where two polygons cross, each hides the other where it is nearer.
#[test]
fn nearness_decides_for_every_sample() {
    let mut pictures = vec![];
    for order in [[0, 1], [1, 0]] {
        let mut canvas = Canvas::new(32, 32);
        for index in order {
            let [left, right] = [[1000, 9000], [9000, 1000]][index];
            let corners = [(0, 0, left), (2048, 0, right), (2048, 2048, right), (0, 2048, left)];
            canvas.polygon(&corners.map(|(x, y, near)| spot(x, y, near)), [RED, GREEN][index]);
        }
        pictures.push(canvas.paint());
    }
    assert!(pictures[0] == pictures[1]);
    assert_eq!([pixel(&pictures[0], 8, 9), pixel(&pictures[0], 24, 9)], [GREEN, RED]);
}

/// The angle of view is the one between the upper and the lower border.
#[test]
fn lenses_have_their_angle() {
    // Half the height, in screen units, over the tangents of 2.5, 22.5, 45 and 60 degrees.
    for (angle, expected) in [(5, 351_802), (45, 37_082), (90, 15_360), (120, 8_868)] {
        let focal = Lens::new(640, 480, angle).focal();
        assert!((focal - expected).abs() <= 1, "{angle}: {focal}, not {expected}");
    }
}

/// Right is right, up is up, twice as far is half as large, and where the world is does not matter.
#[test]
fn cameras_are_right_handed() {
    let lens = Lens::new(200, 100, 90);
    for origin in [Vec3::ZERO, Vec3::from_ints(1_000_000_000, -1_000_000_000, 1)] {
        let eye = origin + Vec3::from_ints(0, 0, 10);
        let camera = Camera::looking(eye, origin, lens).expect("two points");
        let place = |x, y, z| {
            let view = camera.view((origin + Vec3::from_ints(x, y, z)).raw()).expect("near");
            let Spot { x, y, near } = camera.spot(view, 0);
            assert!(near > 0);
            [x - 100 * PIXEL, y - 50 * PIXEL]
        };
        assert_eq!(place(0, 0, 0), [0, 0]);
        assert_eq!(place(10, 5, 0), [50 * PIXEL, -25 * PIXEL]);
        assert_eq!(place(10, 5, -10), [25 * PIXEL, -25 * PIXEL / 2]);
    }
    assert!(Camera::looking(Vec3::X, Vec3::X, lens).is_none());
}

/// A fitted camera sees the whole box in the middle, and no nearer one does, whatever its size.
#[test]
fn fitted_cameras_see_everything() {
    let lens = Lens::new(640, 480, 32);
    for view in [View::Front, View::Side, View::Top, View::Iso] {
        for size in [[1, 1, 1], [1 << 24, 1 << 25, 1 << 20], [1 << 59, 1 << 60, 1 << 40]] {
            let corners = [size.map(|c: i64| -c), size];
            let camera = Camera::fitted(view.direction(), &all_corners(corners), lens);
            let mut reach = [0; 2];
            let mut ends = [[i64::MAX, i64::MIN]; 2];
            for point in all_corners(corners) {
                let seen = camera.view(point).expect("inside");
                assert!(camera.frustum().contains(seen), "{view:?} {size:?}");
                let spot = camera.spot(seen, 0);
                let place = [spot.x - 320 * PIXEL, spot.y - 240 * PIXEL];
                for axis in 0..2 {
                    reach[axis] = reach[axis].max(place[axis].abs());
                    let [low, high] = ends[axis];
                    ends[axis] = [low.min(place[axis]), high.max(place[axis])];
                }
            }
            let limits = [320 * PIXEL * 13 / 16, 240 * PIXEL * 13 / 16];
            let slack = if size[0] == 1 { limits[1] / 2 } else { 3 };
            assert!(reach[0] <= limits[0] + slack && reach[1] <= limits[1] + slack, "{reach:?}");
            let touches = reach[0] >= limits[0] - slack || reach[1] >= limits[1] - slack;
            assert!(touches, "{view:?} {size:?}: {reach:?} of {limits:?}");
            let is_centred = ends.iter().all(|[low, high]| (low + high).abs() <= 2 * slack);
            assert!(is_centred, "{view:?} {size:?}: {ends:?}");
        }
    }
}

/// What is left of triangles and lines is inside of the frustum, and what is inside is left whole.
#[test]
fn clipping_keeps_what_is_inside() {
    let lens = Lens::new(64, 48, 120);
    let frustum = Camera::looking(Vec3::Z, Vec3::ZERO, lens).expect("two points").frustum();
    let contains = |[x, y, ahead]: [i64; 3]| {
        let [width, height] = lens.half();
        let seen = |c: i64, half: i64| c.abs() * lens.focal() <= 2 * half * ahead;
        ahead >= 1 << 18 && seen(x, width) && seen(y, height)
    };
    let mut random = Pcg::new(2, 2);
    let mut draw = || {
        // From near the eye to as far as a view goes.
        let limit = 1u32 << (16 + random.below(15));
        [0; 3].map(|_| (i64::from(random.below(limit)) - i64::from(limit / 2)) << 9)
    };
    let mut cut = 0;
    for _ in 0..10_000 {
        let corners = [draw(), draw(), draw()];
        let polygon = frustum.clip_triangle(corners);
        // A corner is rounded: what is a unit nearer to the middle is inside.
        let inward = |[x, y, ahead]: [i64; 3]| [x - 2 * x.signum(), y - 2 * y.signum(), ahead + 2];
        assert!(polygon.iter().all(|&corner| contains(inward(corner))), "{corners:?}");
        assert!(polygon.len() <= 8 && polygon.len() != 1);
        cut += usize::from(polygon.len() > 3);
        assert!(corners.iter().all(|&corner| frustum.contains(corner) == contains(corner)));
        if corners.iter().all(|&corner| contains(corner)) {
            assert_eq!(polygon, corners);
        }
        if let Some(ends) = frustum.clip_line([corners[0], corners[1]]) {
            assert!(ends.iter().all(|&end| contains(inward(end))), "{corners:?}");
        }
    }
    assert!(cut > 500, "only {cut} were cut to more corners");
}

/// Few colours stay as they are; of many, none moves far.
#[test]
fn palettes_stand_for_all_colours() {
    let few: Vec<_> = (0..u8::MAX).map(|red| Rgb([red, 7, 255])).collect();
    assert_eq!(few.len(), COLOURS_MAX);
    let palette = Palette::new(few.repeat(3));
    assert!(few.iter().all(|&c| palette.colours[usize::from(palette.index(c))] == c));

    let many = (0..16).flat_map(|r| (0..256u16).map(move |gb| [r, gb.to_le_bytes()[0]]));
    let many: Vec<_> = many.map(|[r, gb]| Rgb([r, gb / 16, gb % 16].map(|c| c * 17))).collect();
    let palette = Palette::new(many.clone());
    assert_eq!(palette.colours.len(), COLOURS_MAX);
    for colour in many {
        let found = palette.colours[usize::from(palette.index(colour))];
        let far = colour.0.iter().zip(found.0).map(|(a, b)| a.abs_diff(b)).max();
        assert!(far <= Some(32), "{found:?} for {colour:?}");
    }
    assert!(Palette::new(vec![]).colours.is_empty());
}

/// A face has a front and a back, is lit from the left and above, and hides what is behind it.
#[test]
fn faces_have_two_sides() {
    let camera = Camera::looking(Vec3::from_ints(0, 0, 4), Vec3::ZERO, Lens::new(64, 64, 60));
    let style = Style {
        camera: camera.expect("two points"),
        size: [64, 64],
        bounds: Bounds::default(),
        grid: false,
    };
    // Around the middle of the picture, front to the camera.
    let front = [(-2, -2, 0), (2, -2, 0), (0, 3, 0)].map(|(x, y, z)| Vec3::from_ints(x, y, z));
    let [a, b, c] = front;
    let shaded = |corners: [Vec3; 3], point: Vec3, shade: Shade| {
        let mut painter = Painter::new(&style, &|_| {});
        painter.point(point, shade);
        painter.triangle(corners, Shade::Face);
        pixel(&painter.finish(), 32, 32)
    };
    let seen = |corners, point| shaded(corners, point, Shade::Pinned);
    let behind = -Vec3::Z;
    // Contacts only are seen through it.
    assert_ne!(shaded(front, behind, Shade::Contact), seen(front, behind));
    let is_red = |Rgb([r, g, b]): Rgb| r > g.max(b);
    assert!(is_red(seen(front, behind)) && !is_red(seen([a, c, b], behind)));
    assert_eq!(seen(front, behind), seen([b, c, a], behind));
    assert_ne!(seen(front, Vec3::Z), seen(front, behind));

    let tilt = |left: i32, up: i32| {
        let [a, b, c] = front.map(|corner| {
            // Lower on the side that it is to face.
            let [x, y, _] = corner.raw();
            corner + Vec3::from_raw([0, 0, i64::from(left) * x / 2 - i64::from(up) * y / 2])
        });
        let Rgb(colour) = seen([a, b, c], Vec3::from_ints(0, 0, -3));
        colour.map(u32::from).iter().sum::<u32>()
    };
    assert!(tilt(1, 0) > tilt(-1, 0) && tilt(0, 1) > tilt(0, -1));
    let degenerate = seen([a, a, c], Vec3::from_ints(0, 0, 9));
    assert_eq!(degenerate, BACKGROUND);
}
