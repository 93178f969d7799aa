//! The test of Devillers and Guigue as it is usually written: `f64`, nested branches, no box first.
//!
//! Pairs in one plane are not part of the comparison: they count as apart.

type Point = [f64; 3];
type Corners = [Point; 3];

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Both triangles turned and mirrored: the intervals on the common line overlap.
fn decide(p1: Point, q1: Point, r1: Point, p2: Point, q2: Point, r2: Point) -> bool {
    let normal = cross(sub(p2, q1), sub(p1, q1));
    if dot(sub(q2, q1), normal) > 0.0 {
        return false;
    }
    let normal = cross(sub(p2, p1), sub(r1, p1));
    dot(sub(r2, p1), normal) <= 0.0
}

/// Turns and mirrors the second triangle by the sides of its corners.
fn turn_second(p1: Point, q1: Point, r1: Point, [p2, q2, r2]: Corners, d: [f64; 3]) -> bool {
    let [dp, dq, dr] = d;
    if dp > 0.0 {
        if dq > 0.0 {
            decide(p1, r1, q1, r2, p2, q2)
        } else if dr > 0.0 {
            decide(p1, r1, q1, q2, r2, p2)
        } else {
            decide(p1, q1, r1, p2, q2, r2)
        }
    } else if dp < 0.0 {
        if dq < 0.0 {
            decide(p1, q1, r1, r2, p2, q2)
        } else if dr < 0.0 {
            decide(p1, q1, r1, q2, r2, p2)
        } else {
            decide(p1, r1, q1, p2, q2, r2)
        }
    } else if dq < 0.0 {
        if dr >= 0.0 { decide(p1, r1, q1, q2, r2, p2) } else { decide(p1, q1, r1, p2, q2, r2) }
    } else if dq > 0.0 {
        if dr > 0.0 { decide(p1, r1, q1, p2, q2, r2) } else { decide(p1, q1, r1, q2, r2, p2) }
    } else if dr > 0.0 {
        decide(p1, q1, r1, r2, p2, q2)
    } else if dr < 0.0 {
        decide(p1, r1, q1, r2, p2, q2)
    } else {
        false
    }
}

/// Whether two triangles meet, but for rounding.
pub fn overlap(&[p1, q1, r1]: &Corners, &[p2, q2, r2]: &Corners) -> bool {
    let normal = cross(sub(p2, r2), sub(q2, r2));
    let [dp1, dq1, dr1] = [p1, q1, r1].map(|p| dot(sub(p, r2), normal));
    if dp1 * dq1 > 0.0 && dp1 * dr1 > 0.0 {
        return false;
    }
    let normal = cross(sub(q1, p1), sub(r1, p1));
    let d = [p2, q2, r2].map(|p| dot(sub(p, r1), normal));
    if d[0] * d[1] > 0.0 && d[0] * d[2] > 0.0 {
        return false;
    }
    let (second, mirrored) = ([p2, q2, r2], [p2, r2, q2]);
    let swapped = [d[0], d[2], d[1]];
    if dp1 > 0.0 {
        if dq1 > 0.0 {
            turn_second(r1, p1, q1, mirrored, swapped)
        } else if dr1 > 0.0 {
            turn_second(q1, r1, p1, mirrored, swapped)
        } else {
            turn_second(p1, q1, r1, second, d)
        }
    } else if dp1 < 0.0 {
        if dq1 < 0.0 {
            turn_second(r1, p1, q1, second, d)
        } else if dr1 < 0.0 {
            turn_second(q1, r1, p1, second, d)
        } else {
            turn_second(p1, q1, r1, mirrored, swapped)
        }
    } else if dq1 < 0.0 {
        if dr1 >= 0.0 {
            turn_second(q1, r1, p1, mirrored, swapped)
        } else {
            turn_second(p1, q1, r1, second, d)
        }
    } else if dq1 > 0.0 {
        if dr1 > 0.0 {
            turn_second(p1, q1, r1, mirrored, swapped)
        } else {
            turn_second(q1, r1, p1, second, d)
        }
    } else if dr1 > 0.0 {
        turn_second(r1, p1, q1, second, d)
    } else if dr1 < 0.0 {
        turn_second(r1, p1, q1, mirrored, swapped)
    } else {
        false
    }
}
