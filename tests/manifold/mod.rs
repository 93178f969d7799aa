mod boxes;
mod draw;
mod exact;
mod golden;
mod laws;
mod pairs;
mod twin;

use verlock::Vec3;
use verlock::collision::{FeatureId, FeatureKind, Manifold};
use verlock::math::{Real, UnitVec3};

use twin::{Twin, V, dot, gap, gap_along, length, metres, plus, sub};

/// What a manifold may be wrong by, metres.
const TOLERANCE: f64 = 1e-4;

pub fn float(normal: UnitVec3) -> V {
    normal.raw().map(|c| c as f64 / f64::from(1 << 30))
}

/// Checks a manifold, or that there is none, against the twins. Returns how many contacts have
/// a point beside a shape: where the deepest corner has slipped past a side, which is rare.
pub fn check(found: Option<&Manifold>, [a, b]: [&Twin; 2], origin: Vec3, margin: Real) -> usize {
    let margin = margin.raw() as f64 / f64::from(1 << 24);
    let gap = gap(a, b);
    let Some(found) = found else {
        assert!(gap > margin - TOLERANCE, "missed a gap of {gap}");
        return 0;
    };
    let n = float(found.normal);
    let separation = found.separation().raw() as f64 / f64::from(1 << 24);
    if gap > 0.0 {
        let along = gap_along(n, a, b);
        assert!(along > -TOLERANCE, "{n:?} parts not what is apart by {gap}");
        assert!(separation > along - TOLERANCE, "{separation}, but {along} along {n:?}");
        assert!(separation < gap.max(margin) + TOLERANCE, "{separation}, but a gap of {gap}");
    } else {
        let off = (separation - gap).abs();
        assert!(off < TOLERANCE, "{separation}, but a gap of {gap}: {found:?} {a:?} {b:?}");
    }
    if separation < 0.0 {
        let left = twin::gap(a, &b.moved(n, -separation));
        assert!(left > -TOLERANCE, "{left} when moved by {separation} along {n:?}");
    }
    // What is apart near corners only may touch beside them.
    let outside = if gap > 0.0 { margin } else { 0.0 };
    check_contacts(found, [a, b], origin, [margin, outside].map(|most| most + TOLERANCE))
}

fn check_contacts(
    found: &Manifold,
    shapes: [&Twin; 2],
    origin: Vec3,
    [margin, most]: [f64; 2],
) -> usize {
    let mut strays = 0;
    let n = float(found.normal);
    let keys: Vec<_> = found.contacts().iter().map(|contact| contact.features).collect();
    assert!(keys.is_sorted_by(|a, b| a < b), "{keys:?}");
    // Four units, and a millionth of the size.
    let size = shapes.iter().flat_map(|shape| &shape.vertices).map(|&vertex| length(vertex));
    let fine = 3e-7 + 1e-8 * size.fold(1.0, f64::max);
    for contact in found.contacts() {
        let separation = contact.separation.raw() as f64 / f64::from(1 << 24);
        assert!(separation <= margin, "{contact:?} beyond {margin}");
        let points = [contact.on_a, contact.on_b].map(|point| metres(point, origin));
        let off = length(sub(plus(points[0], n, separation), points[1]));
        assert!(off < fine, "{contact:?}: {off} off the normal");
        for (shape, point) in shapes.into_iter().zip(points) {
            let point = Twin::bare(vec![point], vec![], 0.0);
            let outside = twin::gap(shape, &point);
            if outside >= most {
                strays += 1;
                let kinds = contact.features.map(FeatureId::kind);
                assert!(kinds.contains(&FeatureKind::Vertex), "{contact:?}: {outside} outside");
            }
        }
    }
    assert!((dot(n, n) - 1.0).abs() < 1e-6);
    strays
}
