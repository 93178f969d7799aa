//! Any two triangles: whether and where they meet.

use verlock::Vec3;
use verlock::geometry::{
    Aabb, Triangle, intersection_triangle_triangle, overlap_triangle_triangle,
};

use super::draw::Draw;
use super::oracle;

type Corners = [[i64; 3]; 3];

/// The orders of three corners.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];

/// Coordinates are within this: the oracle multiplies four differences of them, in 128 bits.
const FAR: i64 = 1 << 28;

/// They meet where the oracle says, in any order of corners and wherever they are; and what they
/// have in common is in both. True if they meet.
pub fn triangle_triangle(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let unit = [1, FAR / 16][draw.below(2)];
    let grid = 1 + draw.below(15);
    let corner = |draw: &mut Draw<'_>| {
        [(); 3].map(|()| match draw.below(8) {
            0 => draw.any::<i64>() % FAR,
            _ => unit * draw.below(grid + 1) as i64,
        })
    };
    let mut pair = [[[0; 3]; 3]; 2];
    for at in 0..6 {
        // Now and then one of the corners so far again.
        let again = draw.below(8) == 0 && at > 0;
        let from = if again { draw.below(at) } else { at };
        pair[at / 3][at % 3] = if again { pair[from / 3][from % 3] } else { corner(&mut draw) };
    }
    let expected = oracle::overlap(&pair[0].map(wide), &pair[1].map(wide));
    // The larger, the wider the numbers of the test.
    let scale = draw.below(12);
    let pair = pair.map(|corners| corners.map(|p| p.map(|c| c << scale)));
    let way = [(); 3].map(|()| draw.any::<i64>() >> 5);
    for [order_a, order_b] in ORDERS.map(|a| ORDERS.map(|b| [a, b])).concat() {
        let [a, b] = [order_a.map(|k| pair[0][k]), order_b.map(|k| pair[1][k])].map(triangle);
        assert_eq!(overlap_triangle_triangle(&a, &b), expected, "{a:?} {b:?}");
        assert_eq!(overlap_triangle_triangle(&b, &a), expected, "{b:?} {a:?}");
    }
    let moved = pair.map(|corners| corners.map(|p| [0, 1, 2].map(|k| p[k] + way[k])));
    let [here, there] = [pair, moved].map(|pair| places(pair.map(triangle)));
    assert_eq!(here.is_empty(), !expected, "{pair:?}");
    let way = Vec3::from_raw(way);
    assert!(here.iter().map(|&place| place + way).eq(there), "{pair:?} moves {way:?}");
    expected
}

fn wide(point: [i64; 3]) -> [i128; 3] {
    point.map(i128::from)
}

fn triangle(corners: Corners) -> Triangle {
    Triangle::new(corners.map(Vec3::from_raw)).expect("in range")
}

/// The corners of what two triangles have in common: in the boxes of both.
fn places([a, b]: [Triangle; 2]) -> Vec<Vec3> {
    let found = intersection_triangle_triangle(&a, &b);
    let points = found.iter().flat_map(|found| found.points());
    let places: Vec<_> = points.map(|point| point.position).collect();
    let inside = |place: &Vec3| {
        let place = Aabb::of_point(*place);
        [a, b].iter().all(|triangle| triangle.bounds().contains(&place))
    };
    assert!(places.iter().all(inside), "{a:?} {b:?}: {places:?}");
    places
}
