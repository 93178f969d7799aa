//! One part of an overlap.

use alloc::vec;
use alloc::vec::Vec;

use super::contour::{Contour, Knot};
use super::groups::Groups;
use super::inside::inside;
use crate::collision::surface::proximity::scaled;
use crate::collision::{Contact, FeatureId, FeatureKind};
use crate::geometry::{Aabb, Surface};
use crate::math::wide::{dot_wide, round_shift_wide, sub, to_i64};
use crate::math::{Real, UnitVec3, Vec3};

/// Lines and vertices that are joined.
#[derive(Default)]
pub(super) struct Component {
    knots: Vec<Knot>,
    /// The vertices of A inside B, and of B inside A.
    inside: [Vec<(u32, Vec3)>; 2],
    /// Twice the area of its lines.
    area: [i128; 3],
    /// The largest of those of its single lines.
    largest: u128,
}

/// The components of an overlap, in the order of their lowest knots.
pub(super) fn components<A: Surface, B: Surface>(
    a: &A,
    b: &B,
    contour: &Contour,
) -> Vec<Component> {
    let Contour { knots, links } = contour;
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
            components.push(Component::default());
        }
        components[places[root as usize]].knots.push(*knot);
    }
    let mut place = |number: u32| places[groups.root(number) as usize];
    for (line, area) in areas(contour, &lines) {
        components[place(line)].add(area);
    }
    for (vertex, number) in of_a {
        components[place(number)].inside[0].push((vertex, a.position(vertex)));
    }
    for (vertex, number) in of_b {
        components[place(number)].inside[1].push((vertex, b.position(vertex)));
    }
    components
}

/// Twice the area of every line, which is named by its lowest knot. `lines` tells that of each
/// knot.
fn areas(contour: &Contour, lines: &[u32]) -> Vec<(u32, [i128; 3])> {
    let mut areas = vec![[0; 3]; lines.len()];
    for link in &contour.links {
        let line = lines[link.knots[0] as usize] as usize;
        let term = contour.area(*link, contour.knots[line].position);
        areas[line] = [0, 1, 2].map(|k| areas[line][k] + term[k]);
    }
    let is_line = |(number, _): &(u32, _)| lines[*number as usize] == *number;
    (0..).zip(areas).filter(is_line).collect()
}

fn magnitude(area: [i128; 3]) -> u128 {
    area.iter().map(|c| c.unsigned_abs()).sum()
}

impl Component {
    fn add(&mut self, area: [i128; 3]) {
        self.area = [0, 1, 2].map(|k| self.area[k] + area[k]);
        self.largest = self.largest.max(magnitude(area));
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

    /// The direction in which to move B, and how far.
    ///
    /// Where one has gone right through the other, the areas of the lines where it goes in and out
    /// cancel out: then it is the shortest way out of the boxes around both.
    pub(super) fn way_out(&self, bounds: [Aabb; 2]) -> (UnitVec3, Real) {
        if magnitude(self.area) * 8 >= self.largest
            && let Some(normal) = UnitVec3::normalize_wide(self.area)
        {
            return (normal, self.depth(normal));
        }
        let [a, b] = bounds.map(|bounds| [bounds.min().raw(), bounds.max().raw()]);
        let axes = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z];
        let ways =
            (0..3).flat_map(|k| [(a[1][k] - b[0][k], axes[k]), (b[1][k] - a[0][k], -axes[k])]);
        // The first of the shortest.
        let (depth, normal) = ways.min_by_key(|(depth, _)| *depth).unwrap_or((0, UnitVec3::Y));
        (normal, Real::from_raw(depth))
    }

    /// How far B must move until what it has inside A is before what A has inside B.
    fn depth(&self, normal: UnitVec3) -> Real {
        let origin = self.knots[0].position.raw();
        let reach = |point: &Vec3| dot_wide(normal.raw(), sub(point.raw(), origin));
        let ends = |k: usize| {
            let vertices = self.inside[k].iter().map(|(_, position)| position);
            vertices.chain(self.knots.iter().map(|knot| &knot.position)).map(reach)
        };
        let (highest, lowest) = (ends(0).max().unwrap_or(0), ends(1).min().unwrap_or(0));
        Real::from_raw(to_i64(round_shift_wide(highest - lowest, 30)))
    }

    /// Contacts at all knots and vertices, which are as deep as one another.
    pub(super) fn contacts(&self, normal: UnitVec3, depth: Real) -> Vec<Contact> {
        let Some(first) = self.knots.first() else { return Vec::new() };
        let way = Vec3::from_raw(scaled(normal, depth));
        let contact = |features: [FeatureId; 2], on_a: Vec3| Contact {
            features,
            on_a,
            on_b: on_a - way,
            separation: -depth,
        };
        let mut contacts: Vec<_> =
            self.knots.iter().map(|knot| contact(knot.features, knot.position)).collect();
        let [of_a, of_b] = &self.inside;
        contacts.extend(of_a.iter().map(|&(vertex, position)| {
            contact([FeatureId::vertex(vertex), first.features[1]], position)
        }));
        contacts.extend(of_b.iter().map(|&(vertex, position)| {
            contact([first.features[0], FeatureId::vertex(vertex)], position + way)
        }));
        contacts.sort_unstable_by_key(|contact| contact.features);
        contacts.dedup_by_key(|contact| contact.features);
        contacts
    }
}
