//! What triangles have in common that lie in one plane, or of which one is a segment or a point.

use super::Corners;
use super::flat::{axis_of, orient};
use super::intersection::{Feature, Intersection, IntersectionPoint};
use super::point::{Owner, Pair, ends};

/// Points of both triangles, each once unless a triangle is flat. Every corner of what is common is
/// among them: it is a corner of one triangle, or edges cross there, or an edge and a face.
#[derive(Default)]
struct Points {
    all: [Option<IntersectionPoint>; Self::MAX],
    len: usize,
}

/// See [`intersection_triangle_triangle`](super::intersection_triangle_triangle).
pub(super) fn intersection(a: &Corners, b: &Corners) -> Option<Intersection> {
    let pair = Pair::new(a, b);
    let mut points = Points::default();
    for corner in 0..3 {
        points.extend(pair.corner(Owner::A, corner));
        // A corner of both has been taken.
        let of_b = pair.corner(Owner::B, corner);
        points.extend(of_b.filter(|point| !matches!(point.on_a, Feature::Vertex(_))));
    }
    for edge_a in 0..3 {
        for edge_b in 0..3 {
            points.extend(pair.edges_crossing(edge_a, edge_b));
        }
    }
    let flat = [a, b].map(|corners| axis_of(corners).is_none());
    if flat == [false; 2] {
        return points.around();
    }
    for owner in [Owner::A, Owner::B] {
        let through = (0..3).filter(|&edge| pierces(&pair, owner, edge));
        points.extend(through.map(|edge| pair.crossing(owner, [edge, (edge + 1) % 3])));
    }
    points.along([a, b].map(inside))
}

/// The corner strictly between the others, if the triangle is flat.
fn inside(corners: &Corners) -> Option<u8> {
    let mut order: [u8; 3] = [0, 1, 2];
    order.sort_unstable_by_key(|&corner| corners[usize::from(corner)]);
    let [first, middle, last] = order.map(|corner| corners[usize::from(corner)]);
    (axis_of(corners).is_none() && first != middle && middle != last).then_some(order[1])
}

/// Whether the inside of an edge crosses that of the other triangle's face.
fn pierces(pair: &Pair<'_>, owner: Owner, edge: u8) -> bool {
    let [own, other] = pair.seen_by(owner);
    let [from, to] = ends(own, edge);
    let [a, b, c] = *other;
    let [below, above] = [from, to].map(|end| orient(a, b, c, end));
    let turns = [0, 1, 2].map(|k| orient(from, to, other[k], other[(k + 1) % 3]));
    below * above < 0 && (turns == [1; 3] || turns == [-1; 3])
}

impl Points {
    /// Six corners, nine crossings of edges, three edges through a face.
    const MAX: usize = 18;

    fn extend(&mut self, points: impl IntoIterator<Item = IntersectionPoint>) {
        for point in points {
            self.all[self.len] = Some(point);
            self.len += 1;
        }
    }

    fn iter(&self) -> impl Iterator<Item = IntersectionPoint> {
        self.all.iter().flatten().copied()
    }

    /// What is common, when all points lie on one line. No end of it is a corner `inside`, unless
    /// another point is there too: such a corner may be rounded past an end.
    fn along(&self, inside: [Option<u8>; 2]) -> Option<Intersection> {
        let is_inside = |point: &IntersectionPoint| {
            let names = [point.on_a, point.on_b];
            let is = |k: usize| inside[k].map(Feature::Vertex) == Some(names[k]);
            let is_end = |k: usize| matches!(names[k], Feature::Vertex(_)) && !is(k);
            (is(0) || is(1)) && !is_end(0) && !is_end(1)
        };
        let ends = || self.iter().filter(|point| !is_inside(point));
        let places = || ends().map(|point| point.position);
        // Of the points in one place, the first.
        let first_at = |place| self.iter().filter(|point| point.position == place).min();
        let (Some(first), Some(last)) = (places().min(), places().max()) else {
            return self.iter().min().map(|point| Intersection::between(point, point));
        };
        Some(Intersection::between(first_at(first)?, first_at(last)?))
    }

    /// What is common to two triangles of one plane that are not flat: at most 6 points.
    fn around(&self) -> Option<Intersection> {
        if self.len <= 2 {
            return self.along([None; 2]);
        }
        let mut ring = [self.iter().next()?; 6];
        let mut len = 1;
        // Along every side of the polygon runs an edge, which holds the points at both its ends.
        while len < self.len.min(6) {
            let placed = &ring[..len];
            let beside = |point: &IntersectionPoint| {
                !placed.contains(point) && lines(point) & lines(&placed[len - 1]) != 0
            };
            ring[len] = self.iter().find(beside)?;
            len += 1;
        }
        // Places may coincide: then only all of them tell where to begin, and which way to go.
        let way = |first, step| [0, 1, 2, 3, 4, 5].map(|at| ring[(first + at * step) % len]);
        let ways = (0..len).flat_map(|first| [1, len - 1].map(|step| way(first, step)));
        let ring = ways.min_by_key(|way| way.map(|point| point.position))?;
        Some(Intersection::polygon(&ring[..len]))
    }
}

/// The edges that hold a point, as bits: those of the first triangle, then of the second.
fn lines(point: &IntersectionPoint) -> u8 {
    let edges = |feature| match feature {
        Feature::Vertex(corner) => 1 << corner | 1 << ((corner + 2) % 3),
        Feature::Edge(edge) => 1 << edge,
        Feature::Face => 0,
    };
    edges(point.on_a) | edges(point.on_b) << 3
}
