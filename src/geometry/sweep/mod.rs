//! When moving vertices, edges and faces first touch: never late.
//!
//! Tight inclusion (Wang et al., *A Large-scale Benchmark and an Inclusion-based Algorithm for
//! Continuous Collision Detection*, ACM TOG 40(5), 2021), in integers and without an epsilon:
//!
//! ```text
//! F(t, u, v) = A(t) + u B(t) + v C(t)   from a point of one feature to a point of the other
//! open = { all (t, u, v) }              boxes, in the order in which they begin
//! take the earliest box:
//!     as small as can be, or too many boxes: it begins when they may touch
//!     halve it along the axis that changes F most; keep what of the halves F may be 0 in
//! none left: they do not touch
//! ```
//! F is affine in each of t, u and v, so that the component of F along any direction is between its
//! values at the 8 corners of a box, and the box is done with if these are on one side of 0. Any
//! direction will do: here x, y and z, and with the velocity V the three that set t, u and v apart,
//! `B x C`, `C x V` and `V x B`. Along each of these F nearly depends on one axis alone, and where
//! it may be 0 is not all of that axis: boxes shrink as in Newton's method, by many halves at once.
//!
//! Boxes are taken in the order of time: whenever the search ends, nothing touches before.

mod capsules;
mod cell;
mod motion;
mod relation;
mod row;
mod search;
mod triangles;

pub use motion::Motion;
pub(crate) use motion::{back_off, fall};

use super::Sphere;
use super::triangle::is_in_range;
use crate::math::{Real, Unit, Vec3};
use relation::Relation;

/// How closely moving features are looked at.
///
/// ```
/// use verlock::geometry::sweep::{Motion, Sweep};
/// use verlock::math::Unit;
/// use verlock::{Vec3, real};
///
/// let floor = [Vec3::ZERO, Vec3::X, Vec3::Z].map(Motion::rest);
/// let inside = (Vec3::X + Vec3::Z) * real!("0.2");
/// let fall = |from| Motion::new(from + Vec3::from_ints(0, 3, 0), from - Vec3::Y);
/// let impact = Sweep::default().vertex_face(fall(inside), floor);
/// assert_eq!(impact.map(|impact| impact.time), Unit::from_ratio(3, 4).ok());
///
/// let beside = Sweep::default().vertex_face(fall(inside + Vec3::X), floor);
/// assert_eq!(beside, None);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Sweep {
    /// Features that come as close as this touch, metres: 0 unless told otherwise, at most
    /// [`Sphere::RADIUS_MAX`]; what is outside of that is taken for the nearest that is not.
    ///
    /// No such pair is missed; up to `sqrt 3` times as far apart they may be taken to touch too.
    /// Between meshes every pair costs that is so near before the first contact: a gap as wide as
    /// many faces makes that slow.
    pub gap: Real,
    /// After so many boxes, and as many again at the first time that is possible, a search ends
    /// with what it knows: usually 4,096, while most need none and few 50. Fewer make times too
    /// early where features nearly touch for long or move in one plane, and contacts of some that
    /// only come near.
    pub work_max: u32,
}

/// That two moving features may touch, and not before when.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Impact {
    /// They do not touch before, as a fraction of the step in 0..=1. Usually it is the time of the
    /// first contact rounded down to 2^-30. It is less where `is_cut`, and where they come nearer
    /// before than can be told apart, even if they never touch: about 2^-30 of their sizes and
    /// ways.
    pub time: Unit,
    /// Where, rounded likewise: the weights of the second and the third corner of a face; or how
    /// far along edge A and along edge B.
    pub weights: [Unit; 2],
    /// Whether the search ended before it was certain.
    pub is_cut: bool,
}

impl Default for Sweep {
    fn default() -> Self {
        Self { gap: Real::ZERO, work_max: 4096 }
    }
}

impl Sweep {
    /// When a vertex touches a face; `None` proves that it does not. Exact, O(`work_max`).
    ///
    /// Corners may coincide or lie on one line, now or later. A coordinate beyond
    /// [`Triangle::COORDINATE_MAX`](super::Triangle::COORDINATE_MAX) proves nothing: then the time
    /// is 0.
    #[must_use]
    pub fn vertex_face(&self, vertex: Motion<Vec3>, face: [Motion<Vec3>; 3]) -> Option<Impact> {
        self.vertex_face_until(Unit::ONE, vertex, face)
    }

    /// When two edges touch; `None` proves that they do not. Otherwise like
    /// [`vertex_face`](Self::vertex_face).
    #[must_use]
    pub fn edge_edge(&self, a: [Motion<Vec3>; 2], b: [Motion<Vec3>; 2]) -> Option<Impact> {
        self.edge_edge_until(Unit::ONE, a, b)
    }

    /// As [`vertex_face`](Self::vertex_face), but `None` also if not before `until`, nor then.
    #[inline]
    pub(crate) fn vertex_face_until(
        &self,
        until: Unit,
        vertex: Motion<Vec3>,
        face: [Motion<Vec3>; 3],
    ) -> Option<Impact> {
        let [a, b, c] = face;
        if ![vertex, a, b, c].iter().all(Motion::is_in_range) {
            return Some(Impact::UNKNOWN);
        }
        search::search(&Relation::vertex_face(vertex, face, self.gap())?, self.work_max, until)
    }

    /// As [`edge_edge`](Self::edge_edge), but `None` also if not before `until`, nor then.
    #[inline]
    pub(crate) fn edge_edge_until(
        &self,
        until: Unit,
        a: [Motion<Vec3>; 2],
        b: [Motion<Vec3>; 2],
    ) -> Option<Impact> {
        if !a.iter().chain(&b).all(Motion::is_in_range) {
            return Some(Impact::UNKNOWN);
        }
        search::search(&Relation::edge_edge(a, b, self.gap())?, self.work_max, until)
    }

    /// Raw, at most 2^39.
    pub(super) fn gap(&self) -> i64 {
        self.gap.raw().clamp(0, Sphere::RADIUS_MAX.raw())
    }
}

impl Impact {
    /// Of what nothing is known.
    const UNKNOWN: Self = Self { time: Unit::ZERO, weights: [Unit::ZERO; 2], is_cut: true };

    /// Of what touches already.
    pub(crate) const AT_ONCE: Self = Self { is_cut: false, ..Self::UNKNOWN };
}

impl Motion<Vec3> {
    fn is_in_range(&self) -> bool {
        is_in_range(self.start) && is_in_range(self.end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Pcg;

    /// A limit only leaves out what is later, whatever the work; what is cut may be told otherwise,
    /// but not later.
    #[test]
    fn limits_leave_out_what_is_later() {
        let mut rng = Pcg::new(1, 50);
        let (mut kept, mut left_out) = (0, 0);
        for round in 0..2_000 {
            let scale = 1 << rng.below(20);
            let mut near = |most: u32| [(); 3].map(|()| i64::from(rng.below(most)) * scale);
            // Every other one does not turn.
            let ways = [near(9), near(9)];
            let corners = [0, 1, 2, 3].map(|corner| {
                let (start, own) = (near(7), near(9));
                let way = if round % 2 == 0 { ways[usize::from(corner > 0)] } else { own };
                let end = [0, 1, 2].map(|k| start[k] + way[k] - 4 * scale);
                Motion::new(Vec3::from_raw(start), Vec3::from_raw(end))
            });
            let [p, q, r, s] = corners;
            for work_max in [0, 1, 2, 9, 100, 4096] {
                let sweep = Sweep { work_max, ..Sweep::default() };
                let find = |until| {
                    if round % 4 < 2 {
                        sweep.vertex_face_until(until, p, [q, r, s])
                    } else {
                        sweep.edge_edge_until(until, [p, q], [r, s])
                    }
                };
                let found = find(Unit::ONE);
                let time = found.map_or(1 << 30, |found| found.time.raw());
                for until in [0, time - 1, time, time + 1, (1 << 30) / 3, (1 << 30) - 1] {
                    let until = Unit::from_raw(until.clamp(0, 1 << 30));
                    let expected = found.filter(|found| found.time <= until);
                    let within = find(until);
                    let is_right = match (within, expected) {
                        (Some(within), Some(expected)) if !expected.is_cut => {
                            within.time == expected.time
                                || within.is_cut && within.time < expected.time
                        }
                        (Some(within), Some(_)) => within.time <= until,
                        // What is cut may prove to be nothing where less is looked at.
                        (only, other) => only.or(other).is_none_or(|found| found.is_cut),
                    };
                    assert!(is_right, "{sweep:?} {corners:?} {until}: {found:?}, but {within:?}");
                    kept += u32::from(expected.is_some());
                    left_out += u32::from(expected.is_none() && found.is_some());
                }
            }
        }
        assert!(kept > 1_000 && left_out > 1_000, "{kept} {left_out}");
    }
}
