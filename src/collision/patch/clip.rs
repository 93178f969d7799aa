//! The polygon that two outlines have in common.

use super::outline::{Outline, Plane, Table, after, sides};
use super::{Contacts, Seam};
use crate::collision::width::Width;
use crate::collision::{Contact, FeatureId};
use crate::math::wide::{add, round_div_magnitude, sub};

/// The corners of what two outlines have in common, at most the margin apart.
pub(in crate::collision) fn clip<W: Width>(seam: &Seam, [a, b]: [&Outline; 2]) -> Contacts {
    let normal = seam.normal;
    let mut contacts = Contacts::new();
    let mut keep = |contact: Contact| {
        if contact.separation.raw() <= seam.margin {
            contacts.push(contact);
        }
    };
    let corners: [&[_]; 2] = [&a.corners, &b.corners];
    let over_a = Table::new::<W>(corners[0], normal, corners[1]);
    let mut is_within = false;
    let plane = Plane::<W>::new(a, normal);
    if let Some(plane) = &plane {
        is_within = true;
        for (j, corner) in corners[1].iter().enumerate() {
            if over_a.row(j).iter().any(|&volume| volume < 0) {
                is_within = false;
                continue;
            }
            let separation = plane.height(corner.at);
            keep(seam.above::<W>([a.face, corner.name], corner.at, separation));
        }
    }
    if is_within {
        return contacts;
    }
    let over_b = Table::new::<W>(corners[1], -normal, corners[0]);
    if let Some(plane) = Plane::<W>::new(b, -normal) {
        for (i, corner) in corners[0].iter().enumerate() {
            if over_b.row(i).iter().any(|&volume| volume <= 0) {
                continue;
            }
            let separation = plane.height(corner.at);
            let on_b = add(corner.at, W::scale(normal.raw(), separation));
            keep(seam.contact::<W>([corner.name, b.face], [corner.at, on_b], separation));
        }
    }
    let level = plane.filter(Plane::is_level);
    for_crossings([&over_a, &over_b], corners.map(<[_]>::len), |[i, j], across_a, across_b| {
        let ends = |k: usize, i: usize| [i, after(i, corners[k].len())].map(|i| corners[k][i].at);
        let features = [corners[0][i].edge, corners[1][j].edge].map(FeatureId::edge);
        let on_b = between::<W>(ends(1, j), across_a);
        keep(if let Some(plane) = &level {
            seam.above::<W>(features, on_b, plane.height(on_b))
        } else {
            let on_a = between::<W>(ends(0, i), across_b);
            let separation = W::round(W::along(normal, sub(on_b, on_a)));
            seam.contact::<W>(features, [on_a, on_b], separation)
        });
    });
    contacts
}

/// Calls `found` with the sides of A and B that cross, with the volumes of the ends of B's side
/// across that of A, and with those of A's ends across that of B.
#[inline]
fn for_crossings(
    [over_a, over_b]: [&Table; 2],
    corners: [usize; 2],
    mut found: impl FnMut([usize; 2], [i128; 2], [i128; 2]),
) {
    for j in 0..sides(corners[1]) {
        let rows_a = [over_a.row(j), over_a.row(after(j, corners[1]))];
        for i in 0..sides(corners[0]) {
            let across_a = rows_a.map(|row| row[i]);
            if (across_a[0] < 0) == (across_a[1] < 0) {
                continue;
            }
            let across_b = [over_b.row(i)[j], over_b.row(after(i, corners[0]))[j]];
            if (across_b[0] > 0) != (across_b[1] > 0) {
                found([i, j], across_a, across_b);
            }
        }
    }
}

/// The point of a segment where a linear function is 0 that has these values at its ends, not both
/// on one side. From the end inside, so that it does not depend on which end comes first.
///
/// The share errs by less than 2^-30, so the point by less than a unit while the segment is shorter
/// than 64 m, and by a quarter of a millimetre where it is as long as may be.
#[inline]
pub(in crate::collision) fn between<W: Width>(ends: [[i64; 3]; 2], inside: [i128; 2]) -> [i64; 3] {
    let (from, to) = if inside[0] > inside[1] { (0, 1) } else { (1, 0) };
    let (near, far) = (inside[from].unsigned_abs(), inside[to].unsigned_abs());
    // Magnitudes are below 2^127, and one is above 0.
    let whole = near + far;
    let surplus = (u128::BITS - whole.leading_zeros()).saturating_sub(33);
    // Of 33 bits.
    let (near, whole) = ((near >> surplus) as u64, (whole >> surplus) as u64);
    // At most 2^30.
    let share = round_div_magnitude(near << 30, whole).cast_signed();
    add(ends[from], W::scale(sub(ends[to], ends[from]), share))
}
