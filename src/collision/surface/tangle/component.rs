//! One part of an overlap.

use alloc::vec;
use alloc::vec::Vec;

use super::contour::{Contour, Knot};
use super::groups::Groups;
use super::inside::inside;
use super::view::View;
use super::way::{Way, length, reach};
use crate::collision::surface::feet::normal_of;
use crate::collision::surface::proximity::scaled;
use crate::collision::{Contact, FeatureId, FeatureKind};
use crate::geometry::{Aabb, Surface};
use crate::math::wide::{dot_wide, sub};
use crate::math::{UnitVec3, Vec3};

/// Lines and vertices that are joined.
#[derive(Default)]
pub(super) struct Component {
    /// Sorted by features, at least one.
    pub(super) knots: Vec<Knot>,
    /// The vertices of A inside B, and of B inside A.
    inside: [Vec<(u32, Vec3)>; 2],
    /// The faces of A and of B that its lines go through, sorted.
    pub(super) rims: [Vec<u32>; 2],
    /// Twice the area of its lines.
    area: [i128; 3],
    /// The largest of those of its single lines.
    largest: u128,
    /// How long its lines are.
    length: u128,
    /// Whether some of them have ends.
    is_open: bool,
    /// How far beside its place B was looked at.
    shift: Vec3,
}

/// The components of an overlap, in the order of their lowest knots.
pub(super) fn components<A: Surface, B: Surface>(
    a: &View<A>,
    b: &View<B>,
    contour: &Contour,
) -> Vec<Component> {
    let Contour { knots, links, .. } = contour;
    let mut groups = Groups::new(knots.len());
    for link in links {
        groups.join(link.knots[0], link.knots[1]);
    }
    let lines: Vec<_> = (0..).take(knots.len()).map(|knot| groups.root(knot)).collect();
    let of_a = inside((a, b, 0), knots, &mut groups);
    let of_b = inside((b, a, 1), knots, &mut groups);
    let mut components: Vec<Component> = Vec::new();
    // The lowest number of every group is a knot.
    let mut places = vec![0; knots.len()];
    for (number, knot) in (0..).zip(knots) {
        let root = groups.root(number);
        if root == number {
            places[root as usize] = components.len();
            components.push(Component { shift: b.shift, ..Component::default() });
        }
        components[places[root as usize]].knots.push(*knot);
    }
    let mut place = |number: u32| places[groups.root(number) as usize];
    // Lines run along the product of normals: turned with one surface, not with both.
    let way = if a.is_turned == b.is_turned { 1 } else { -1 };
    let is_end = ends(contour);
    for (line, area) in areas(contour, &lines, &is_end) {
        components[place(line)].add(area.map(|c| way * c));
    }
    for (number, _) in (0..).zip(&is_end).filter(|(_, is_end)| **is_end) {
        components[place(number)].is_open = true;
    }
    for link in links {
        let component = &mut components[place(link.knots[0])];
        let [from, to] = link.knots.map(|knot| knots[knot as usize].position.raw());
        // Below 3 * 2^61, of less than 2^31.
        component.length += magnitude(sub(to, from).map(i128::from));
        for (rim, face) in component.rims.iter_mut().zip(link.faces) {
            rim.push(face);
        }
    }
    for (vertex, number) in of_a {
        components[place(number)].inside[0].push((vertex, a.position(vertex)));
    }
    for (vertex, number) in of_b {
        components[place(number)].inside[1].push((vertex, b.surface.position(vertex)));
    }
    for rim in components.iter_mut().flat_map(|component| &mut component.rims) {
        rim.sort_unstable();
        rim.dedup();
    }
    components
}

/// Which knots are ends of lines.
fn ends(contour: &Contour) -> Vec<bool> {
    let mut is_end = vec![false; contour.knots.len()];
    for knot in contour.links.iter().flat_map(|link| link.knots) {
        is_end[knot as usize] ^= true;
    }
    is_end
}

/// Twice the area of every line, which is named by its lowest knot. `lines` tells that of each
/// knot.
///
/// The area of an open line is that which the chord between its ends closes: from an end, the chord
/// adds nothing.
fn areas(contour: &Contour, lines: &[u32], is_end: &[bool]) -> Vec<(u32, [i128; 3])> {
    let rank = |knot: u32| (!is_end[knot as usize], contour.knots[knot as usize].position);
    let mut origins: Vec<_> = (0..).take(lines.len()).collect();
    for (knot, &line) in (0..).zip(lines) {
        let origin = &mut origins[line as usize];
        *origin = core::cmp::min_by_key(*origin, knot, |&knot| rank(knot));
    }
    let mut areas = vec![[0; 3]; lines.len()];
    for link in &contour.links {
        let line = lines[link.knots[0] as usize] as usize;
        let term = contour.area(*link, contour.knots[origins[line] as usize].position);
        areas[line] = [0, 1, 2].map(|k| areas[line][k] + term[k]);
    }
    let is_line = |(number, _): &(u32, _)| lines[*number as usize] == *number;
    (0..).zip(areas).filter(is_line).collect()
}

/// The sum of the components.
fn magnitude(v: [i128; 3]) -> u128 {
    v.iter().map(|c| c.unsigned_abs()).sum()
}

impl Component {
    fn add(&mut self, area: [i128; 3]) {
        self.area = [0, 1, 2].map(|k| self.area[k] + area[k]);
        self.largest = self.largest.max(magnitude(area));
    }

    /// The box around it.
    pub(super) fn bounds(&self) -> Aabb {
        let vertices = self.inside.iter().flatten().map(|&(_, position)| position);
        let points = vertices.chain(self.knots.iter().map(|knot| knot.position));
        points.fold(Aabb::of_point(self.origin()), Aabb::with)
    }

    /// What lengths are measured from: it has a knot.
    pub(super) fn origin(&self) -> Vec3 {
        self.knots.first().map_or(Vec3::ZERO, |knot| knot.position)
    }

    /// The direction of its area; none where the areas of the lines at which one goes into the
    /// other and comes out again cancel out, and none of lines so straight that their rounding
    /// tells it.
    pub(super) fn normal(&self) -> Option<UnitVec3> {
        let area = magnitude(self.area);
        let is_through = area * 8 < self.largest || area < self.length * 16;
        if is_through { None } else { UnitVec3::normalize_wide(self.area) }
    }

    /// Whether a hollow of one surface cuts holes into faces of the other, and nothing else: what
    /// is around them is inside, but no edge leads there from here. `normal` is the direction of
    /// the area.
    pub(super) fn hides<A: Surface, B: Surface>(
        &self,
        (a, b): (&View<A>, &View<B>),
        normal: UnitVec3,
    ) -> bool {
        // What cuts out something that is inside leads B against the normal of its face. What is
        // bent and open may be bent either way.
        let along = |outward: UnitVec3| dot_wide(outward.raw(), normal.raw());
        let is_around_a = |&face: &u32| normal_of(a, face).is_some_and(|n| along(n) < 0);
        let is_around_b = |&face: &u32| normal_of(b, face).is_some_and(|n| along(n) > 0);
        let [of_a, of_b] = &self.rims;
        !self.is_open
            && (self.is_cut_in_faces(0) && of_a.iter().all(is_around_a)
                || self.is_cut_in_faces(1) && of_b.iter().all(is_around_b))
    }

    /// Whether no edge of A (0) or of B (1) goes in or out, and no vertex is inside.
    pub(super) fn is_cut_in_faces(&self, k: usize) -> bool {
        let is_face = |knot: &Knot| knot.features[k].kind() == FeatureKind::Face;
        self.inside[k].is_empty() && self.knots.iter().all(is_face)
    }

    /// A point of A (0) or of B (1), whatever things are called: of the vertices inside of the
    /// other one, or else of the knots, the first by place.
    pub(super) fn sample(&self, k: usize) -> Vec3 {
        let vertex = self.inside[k].iter().map(|&(_, position)| position).min();
        let knot = self.knots.iter().min_by_key(|knot| knot.position);
        vertex.or(knot.map(|knot| self.place(k, knot))).unwrap_or(Vec3::ZERO)
    }

    /// Where a knot is on A, and where on B.
    fn place(&self, k: usize, knot: &Knot) -> Vec3 {
        if k == 0 { knot.position } else { knot.position - self.shift }
    }

    /// Its vertices and edges, sorted.
    pub(super) fn features(&self) -> Vec<(u32, FeatureId)> {
        let knots = self.knots.iter().flat_map(|knot| (0..).zip(knot.features));
        let mut features: Vec<_> =
            knots.filter(|(_, feature)| feature.kind() != FeatureKind::Face).collect();
        for (k, inside) in (0..).zip(&self.inside) {
            features.extend(inside.iter().map(|(vertex, _)| (k, FeatureId::vertex(*vertex))));
        }
        features.sort_unstable();
        features
    }

    /// How far B must move along a direction until what it has inside A is before what A has
    /// inside B.
    pub(super) fn way(&self, normal: UnitVec3) -> Way {
        let ends = |k: usize| {
            let vertices = self.inside[k].iter().map(|&(_, position)| position);
            let points = vertices.chain(self.knots.iter().map(move |knot| self.place(k, knot)));
            points.map(|point| reach(normal, point, self.origin()))
        };
        let (highest, lowest) = (ends(0).max().unwrap_or(0), ends(1).min().unwrap_or(0));
        Way { normal, depth: length(highest - lowest), levels: Some([highest, lowest]) }
    }

    /// Contacts at the vertices inside and at the knots, but for those less than half as deep as
    /// the deepest, which would only let it tip.
    pub(super) fn contacts(&self, way: &Way) -> Vec<Contact> {
        let Some(first) = self.knots.first() else { return Vec::new() };
        let [of_a, of_b] = &self.inside;
        let knots = self.knots.iter().map(|knot| {
            let sides = [0, 1].map(|k| self.contact(way, k, knot.features, self.place(k, knot)));
            if sides[1].separation < sides[0].separation { sides[1] } else { sides[0] }
        });
        let vertices_a = of_a.iter().map(|&(vertex, position)| {
            self.contact(way, 0, [FeatureId::vertex(vertex), first.features[1]], position)
        });
        let vertices_b = of_b.iter().map(|&(vertex, position)| {
            self.contact(way, 1, [first.features[0], FeatureId::vertex(vertex)], position)
        });
        let all = knots.chain(vertices_a).chain(vertices_b);
        all.filter(|contact| -contact.separation.raw() >= way.depth.raw() / 2).collect()
    }

    /// At a point of A or of B: the point of the other is where it begins along the normal, which
    /// is on it if it is flat there.
    fn contact(&self, way: &Way, k: usize, features: [FeatureId; 2], point: Vec3) -> Contact {
        let separation = match way.levels {
            None => -way.depth,
            Some([highest, lowest]) => {
                let reach = reach(way.normal, point, self.origin());
                length(if k == 0 { lowest - reach } else { reach - highest })
            }
        };
        let way = Vec3::from_raw(scaled(way.normal, separation));
        let (on_a, on_b) = if k == 0 { (point, point + way) } else { (point - way, point) };
        Contact { features, on_a, on_b, separation }
    }
}
