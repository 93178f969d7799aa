//! Sets of colliders, against asking them one by one.

use std::sync::Arc;

use verlock::Vec3;
use verlock::collision::{
    Cast, Collider, ColliderError, ColliderId, Colliders, Filter, Layers, MeshShape, Shape, cast,
    cast_segment, closest_points, overlap,
};
use verlock::geometry::{HalfSpace, Segment, Sphere, TriangleMesh};
use verlock::math::{Pcg, Real, UnitVec3};
use verlock::store::Handle;

use super::{Draw, KINDS};

type Members = Vec<(ColliderId, Collider)>;

/// A few metres.
const METRES: (i64, i64) = (1 << 12, 1 << 12);

/// A set that saw some coming and going, and what is in it. How large shapes are, see `Draw`; they
/// are within four times as much.
fn crowd(seed: u64, half_spaces: bool, (unit, most): (i64, i64)) -> (Colliders, Members, Draw) {
    let mut draw = Draw { rng: Pcg::new(seed, 40), unit, most };
    let mut set = Colliders::new();
    let mut all = Members::new();
    for step in 0..120 {
        let kind = usize::from(!half_spaces) + draw.below(7 - i64::from(!half_spaces)) as usize;
        let at = draw.way(4 * most);
        let Some(shape) = draw.shape(kind, at) else { continue };
        let layers = Layers { on: 1 << draw.below(3), mask: draw.rng.next_u32() | 1 };
        let collider = Collider { shape: shape.clone(), layers, user_data: step };
        match draw.below(5) {
            0 if !all.is_empty() => {
                let (id, _) = all.swap_remove(draw.below(all.len() as i64 - 1) as usize);
                assert!(set.remove(id).is_some() && set.remove(id).is_none());
                assert_eq!(set.set_shape(id, shape), Err(ColliderError::UnknownId));
            }
            1 if !all.is_empty() => {
                let place = draw.below(all.len() as i64 - 1) as usize;
                set.set_shape(all[place].0, shape.clone()).expect("in range");
                all[place].1.shape = shape;
            }
            _ => all.push((set.insert(collider.clone()).expect("in range"), collider)),
        }
    }
    all.sort_by_key(|&(id, _)| id);
    assert_eq!(set.len(), all.len());
    let ids = |id: &(ColliderId, &Collider)| (id.0, id.1.user_data);
    let expected: Vec<_> = all.iter().map(|(id, c)| (*id, c.user_data)).collect();
    assert_eq!(set.iter().map(|entry| ids(&entry)).collect::<Vec<_>>(), expected);
    (set, all, draw)
}

#[test]
fn a_set_answers_as_its_members_would() {
    let mut answers = [0; 4];
    for seed in 0..6 {
        let (set, all, mut draw) = crowd(seed, seed % 2 == 0, METRES);
        let odd = |id: ColliderId, _: &Collider| id.0.index % 2 == 1;
        let some = Filter { layers: Layers { on: 1, mask: 3 }, predicate: &odd };
        for round in 0..30 {
            let filter = if round % 2 == 0 { &Filter::ALL } else { &some };
            let counts = |(id, c): &&(ColliderId, Collider)| {
                round % 2 == 0 || (c.layers.on & 3 != 0 && c.layers.mask & 1 != 0 && odd(*id, c))
            };
            let at = draw.way(1 << 14);
            let Some(shape) = draw.shape(round % KINDS.len(), at) else { continue };
            let motion = draw.way(1 << 14);
            let members = || all.iter().filter(counts);

            let mut hits: Vec<_> = members()
                .filter_map(|(id, c)| Some((*id, cast(&shape, motion, &c.shape)?)))
                .collect();
            hits.sort_by_key(|(id, hit)| (hit.time, *id));
            assert_eq!(set.cast(&shape, motion, filter), hits);

            let segment = Segment::new([at, at + motion]).expect("in range");
            let mut crossed: Vec<_> = members()
                .filter_map(|(id, c)| Some((*id, cast_segment(&segment, &c.shape)?)))
                .collect();
            crossed.sort_by_key(|(id, hit)| (hit.time, *id));
            assert_eq!(set.cast_segment(&segment, filter), crossed);

            let over = |other: &Shape| overlap(&shape, other);
            let ids: Vec<_> = members().filter(|(_, c)| over(&c.shape)).map(|m| m.0).collect();
            assert_eq!(set.overlaps(&shape, filter), ids);
            let holds: Vec<_> =
                members().filter(|(_, c)| c.shape.contains(at)).map(|m| m.0).collect();
            assert_eq!(set.at_point(at, filter), holds);

            let reach = Real::from_raw(1 << 25);
            let mut near: Vec<_> = members()
                .map(|(id, c)| (*id, closest_points(&shape, &c.shape)))
                .filter(|(_, c)| c.is_none_or(|c| c.distance <= reach))
                .collect();
            near.sort_by_key(|(id, c)| (c.map_or(Real::ZERO, |c| c.distance), *id));
            assert_eq!(set.closest(&shape, reach, filter), near);
            for (answers, len) in
                answers.iter_mut().zip([hits.len(), crossed.len(), ids.len(), near.len()])
            {
                *answers += len;
            }
        }
    }
    assert!(answers.iter().all(|&n| n > 100), "{answers:?}");
}

/// The first hit is the first of all hits: also of several at one time, from within, and of shapes
/// of any size.
#[test]
fn first_hits_are_the_first_of_all() {
    let (mut hits, mut ties, mut later) = (0, 0, 0);
    let mut count = |all: &[(ColliderId, Cast)]| {
        hits += usize::from(!all.is_empty());
        ties += usize::from(all.len() > 1 && all[0].1.time == all[1].1.time);
        later += usize::from(all.first().is_some_and(|hit| hit.1.touch.is_some()));
    };
    for (seed, class) in
        (10..).zip([METRES, METRES, (1, 4), (1, 12), (1, 1 << 28), (1 << 9, 1 << 29)])
    {
        let (set, _, mut draw) = crowd(seed, seed % 3 == 0, class);
        let odd = |id: ColliderId, _: &Collider| id.0.index % 2 == 1;
        let some = Filter { layers: Layers { on: 1, mask: 3 }, predicate: &odd };
        for round in 0..120 {
            let filter = if round % 2 == 0 { &Filter::ALL } else { &some };
            let at = draw.way(4 * class.1);
            let motion = draw.way(3 * class.1);
            if let Some(shape) = draw.shape(round % KINDS.len(), at) {
                let all = set.cast(&shape, motion, filter);
                assert_eq!(set.cast_first(&shape, motion, filter), all.first().copied());
                count(&all);
            }
            let segment = Segment::new([at, at + motion]).expect("in range");
            let all = set.cast_segment(&segment, filter);
            assert_eq!(set.cast_segment_first(&segment, filter), all.first().copied());
            count(&all);
        }
    }
    assert!(hits > 300 && ties > 50 && later > 50, "{hits} {ties} {later}");
}

/// What may touch is what boxes and layers say, whatever changed since it was last asked.
#[test]
fn pairs_are_those_of_boxes_and_layers() {
    let mut found = 0;
    for seed in 20..26 {
        let (mut set, mut all, mut draw) = crowd(seed, seed % 2 == 0, METRES);
        for round in 0..6 {
            let margin = Real::from_raw([-1, 0, 1, 1 << 20, 1 << 26][round % 5]);
            let pairs = set.pairs(margin);
            let expected = brute_pairs(&all, margin.max(Real::ZERO));
            assert_eq!(pairs, expected);
            found += pairs.len();
            let touch = |[a, b]: [usize; 2]| overlap(&all[a].1.shape, &all[b].1.shape);
            for (a, b) in (0..all.len()).flat_map(|b| (0..b).map(move |a| (a, b))) {
                let may_meet = all[a].1.layers.may_meet(all[b].1.layers);
                let is_listed = pairs.binary_search(&[all[a].0, all[b].0]).is_ok();
                assert!(is_listed || !may_meet || !touch([a, b]), "{a} {b}");
            }
            // One goes, one moves, one changes its layers.
            let mut place = || draw.below(all.len() as i64 - 2) as usize;
            let (gone, moved, shown) = (place(), place(), place());
            set.remove(all.remove(gone).0).expect("was there");
            all[shown].1.layers = Layers { on: 1 << draw.below(3), ..Layers::ALL };
            set.set_layers(all[shown].0, all[shown].1.layers).expect("is there");
            let at = draw.way(1 << 14);
            if let Some(shape) = draw.shape(1 + round % 6, at) {
                set.set_shape(all[moved].0, shape.clone()).expect("in range");
                all[moved].1.shape = shape;
            }
        }
    }
    assert!(found > 1000, "{found}");
    assert!(Colliders::new().pairs(Real::ONE).is_empty());
}

/// Every two that may touch, by looking at every two.
fn brute_pairs(all: &Members, margin: Real) -> Vec<[ColliderId; 2]> {
    let near = |a: &Shape, b: &Shape| {
        let (Some(a), Some(b)) = (a.bounds(), b.bounds()) else { return true };
        let [a, b] = [a, b].map(|bounds| [bounds.min().raw(), bounds.max().raw()]);
        (0..3).all(|k| b[0][k] - a[1][k] <= margin.raw() && a[0][k] - b[1][k] <= margin.raw())
    };
    let mut pairs = vec![];
    for (place, (id, a)) in all.iter().enumerate() {
        for (other, b) in &all[place + 1..] {
            let layers = [a.layers, b.layers];
            let agree = |[a, b]: [Layers; 2]| a.on & b.mask != 0 && b.on & a.mask != 0;
            if agree(layers) && near(&a.shape, &b.shape) {
                pairs.push([*id, *other]);
            }
        }
    }
    pairs
}

/// What a collider has to do with is changed where it is; who is unknown changes nothing.
#[test]
fn layers_and_user_data_are_changed() {
    let ball = |x: i32| Sphere::new(Vec3::from_ints(x, 0, 0), Real::ONE).expect("legal");
    let mut set = Colliders::new();
    let [gone, id] = [0, 1].map(|x| set.insert(ball(x).into()).expect("room"));
    assert!(set.remove(gone).is_some());
    let layers = Layers { on: 4, mask: 2 };
    assert_eq!(set.set_layers(gone, layers), Err(ColliderError::UnknownId));
    assert_eq!(set.set_user_data(gone, 9), Err(ColliderError::UnknownId));
    let never = ColliderId(Handle::new(7, 1));
    assert_eq!(set.set_layers(never, layers), Err(ColliderError::UnknownId));
    let known = |set: &Colliders| set.get(id).map(|c| (c.layers, c.user_data));
    assert_eq!(known(&set), Some((Layers::ALL, 0)));

    let probe: Shape = ball(1).into();
    let fours = Filter { layers: Layers { on: 2, mask: 4 }, ..Filter::ALL };
    let ones = Filter { layers: Layers { on: 2, mask: 1 }, ..Filter::ALL };
    assert_eq!(set.set_layers(id, layers), Ok(()));
    assert_eq!(set.set_user_data(id, 9), Ok(()));
    assert_eq!(known(&set), Some((layers, 9)));
    assert_eq!(set.overlaps(&probe, &fours), [id]);
    assert_eq!(set.overlaps(&probe, &ones), []);
}

/// A set is what is in it, not how that came about.
#[test]
fn history_does_not_matter() {
    let ball = |x: i32| Sphere::new(Vec3::from_ints(x, 0, 0), Real::ONE).expect("legal");
    let floor = HalfSpace::new(Vec3::ZERO, UnitVec3::Y).expect("legal");
    let mut set = Colliders::new();
    let ids = [0, 3, 6].map(|x| set.insert(ball(x).into()).expect("room"));
    let probe = ball(3).into();
    assert_eq!(set.overlaps(&probe, &Filter::ALL), [ids[1]]);
    // From a shape with a box to one without, and back.
    set.set_shape(ids[0], floor).expect("legal");
    assert_eq!(set.overlaps(&probe, &Filter::ALL), ids[..2]);
    set.set_shape(ids[0], floor).expect("legal");
    set.set_shape(ids[0], ball(4)).expect("legal");
    assert_eq!(set.overlaps(&probe, &Filter::ALL), ids[..2]);
    assert!(set.remove(ids[1]).is_some());
    assert_eq!(set.overlaps(&probe, &Filter::ALL), ids[..1]);
    let heir = set.insert(ball(3).into()).expect("room");
    assert_eq!(heir.0, Handle::new(ids[1].0.index, 3));
    assert!(set.get(ids[1]).is_none() && set.get(heir).is_some());
}

/// What is refused changes nothing.
#[test]
fn what_is_out_of_range_is_refused() {
    let mut set = Colliders::new();
    let edge = Vec3::from_raw([1 << 60, 0, 0]);
    let beyond = Sphere::new(edge, Real::ONE).expect("a legal ball");
    assert_eq!(set.insert(beyond.into()), Err(ColliderError::OutOfRange));
    assert!(set.is_empty());
    let id = set.insert(Sphere::new(edge, Real::ZERO).expect("legal").into()).expect("in range");
    assert_eq!(id.0, Handle::new(0, 1));
    assert_eq!(set.set_shape(id, beyond), Err(ColliderError::OutOfRange));
    assert_eq!(set.at_point(edge, &Filter::ALL), [id]);
    assert_eq!(set.at_point(Vec3::from_raw([i64::MAX; 3]), &Filter::ALL), []);
    let floor = HalfSpace::new(Vec3::ZERO, UnitVec3::Y).expect("legal");
    set.set_shape(id, floor).expect("legal");
    assert_eq!(set.set_shape(id, beyond), Err(ColliderError::OutOfRange));
    assert_eq!(set.overlaps(&beyond.into(), &Filter::ALL), [id]);
    assert_eq!(ColliderError::OutOfRange.to_string(), "collider is out of range");
}

/// Of two hits at a time the first counts, also where a mesh is searched part by part, and large
/// balls are told to touch a little early.
#[test]
fn ties_are_told_early_too() {
    let raw = |x: i64, y: i64, z: i64| Vec3::from_raw([x, y, z]);
    let wall = |x: i64| {
        let [low, high] = [-1 << 39, 1 << 40];
        [raw(x, low, low), raw(x, high, low), raw(x, low, high)]
    };
    let radius = Real::from_raw(32_768 << 24);
    let ball: Shape = Sphere::new(Vec3::ZERO, radius).expect("legal").into();
    for off in [0, 1, 500, 1023] {
        let x = (1 << 39) + (1 << 40) + off;
        let aside = wall(1 << 38).map(|p| p + raw(0, 1 << 42, 0));
        let mesh = |faces: &[[Vec3; 3]]| {
            let corners = faces.iter().flatten().copied();
            let names = (0..faces.len() as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]);
            MeshShape::new(Arc::new(TriangleMesh::new(corners, names).expect("a mesh")))
        };
        let mut set = Colliders::new();
        for faces in [&[wall(x)][..], &[wall(x), aside]] {
            set.insert(mesh(faces).into()).expect("in range");
        }
        let motion = raw(1 << 41, 0, 0);
        let all = set.cast(&ball, motion, &Filter::ALL);
        assert_eq!(set.cast_first(&ball, motion, &Filter::ALL), all.first().copied(), "{off}");
        assert_eq!(all.len(), 2);
    }
}
