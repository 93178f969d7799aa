//! Which neighbours a cell of an octree must be compared with.

use verlock::geometry::Aabb;
use verlock::math::Pcg;
use verlock::{Real, Vec3, real};

use super::{BruteForce, Pair, Partition};
use verlock::partition::Orthtree;

/// A cube by its middle and half its edge.
type Cube = (Vec3, Real);

fn bounds(&(middle, half): &Cube) -> Aabb {
    let half = Vec3::new(half, half, half);
    Aabb::new(middle - half, middle + half)
}

/// A naive octree: cells by the power of two of their edge, and no tree.
fn cell((middle, half): &Cube) -> (u32, [i64; 3]) {
    let edge = (2 * half.raw()).unsigned_abs().next_power_of_two().trailing_zeros();
    (edge, middle.raw().map(|c| c >> edge))
}

/// The pairs that touch and that a rule finds: it says whether a cell looks at its neighbour at
/// this offset, for one of the same size and for what is inside.
fn found(cubes: &[Cube], looks: impl Fn([i64; 3], bool) -> bool) -> Vec<Pair> {
    let sees = |a: &Cube, b: &Cube| {
        let ((edge_a, cell_a), (edge_b, cell_b)) = (cell(a), cell(b));
        if edge_a < edge_b {
            return false;
        }
        let offset = [0, 1, 2].map(|k| (cell_b[k] >> (edge_a - edge_b)) - cell_a[k]);
        offset.iter().all(|way| way.abs() <= 1) && looks(offset, edge_a == edge_b)
    };
    let mut pairs = vec![];
    for (i, a) in (0..).zip(cubes) {
        for (j, b) in (0..).zip(cubes).skip(i as usize + 1) {
            if bounds(a).overlaps(&bounds(b)) && (sees(a, b) || sees(b, a)) {
                pairs.push([i, j]);
            }
        }
    }
    pairs
}

/// The classic rule, whichever half is taken for the positive one.
fn classic(cubes: &[Cube]) -> Vec<Pair> {
    found(cubes, |offset, _| offset >= [0; 3])
}

fn no_negative(cubes: &[Cube]) -> Vec<Pair> {
    found(cubes, |offset, _| offset.iter().all(|&way| way >= 0))
}

fn corrected(cubes: &[Cube]) -> Vec<Pair> {
    found(cubes, |offset, same| !same || offset >= [0; 3])
}

fn given(mut partition: impl Partition, cubes: &[Cube]) -> Vec<Pair> {
    for (id, cube) in (0..).zip(cubes) {
        partition.insert(id, bounds(cube).into()).expect("inserted");
    }
    partition.pairs().to_vec()
}

fn octree(cubes: &[Cube]) -> Vec<Pair> {
    given(Orthtree::<3>::new().objects_min(0), cubes)
}

/// Across levels: the larger cube has its neighbour in front of it, the smaller one behind, and
/// neither looks back.
#[test]
fn the_classic_rule_misses_smaller_cells() {
    let large = (Vec3::new(real!("1.1"), real!("0.5"), real!("0.5")), real!("0.5"));
    let small = (Vec3::new(real!("0.9"), real!("0.5"), real!("0.5")), real!("0.1"));
    let cubes = [large, small];
    assert_eq!(cell(&large).1, [1, 0, 0]);
    assert_eq!(cell(&small).0 + 2, cell(&large).0);
    assert_eq!(classic(&cubes), Vec::<Pair>::new());
    assert_eq!(corrected(&cubes), [[0, 1]]);
    assert_eq!(octree(&cubes), [[0, 1]]);
}

/// On one level: neighbours that are further along one axis and less far along another.
#[test]
fn no_negative_offset_misses_diagonals() {
    let one = (Vec3::new(real!("0.9"), real!("1.1"), real!("0.5")), real!("0.5"));
    let two = (Vec3::new(real!("1.1"), real!("0.9"), real!("0.5")), real!("0.5"));
    let cubes = [one, two];
    assert_eq!((cell(&one).1, cell(&two).1), ([0, 1, 0], [1, 0, 0]));
    assert_eq!(no_negative(&cubes), Vec::<Pair>::new());
    assert_eq!(classic(&cubes), [[0, 1]]);
    assert_eq!(octree(&cubes), [[0, 1]]);
}

/// Many cubes of many sizes: how many pairs each rule misses.
#[test]
fn the_corrected_rule_misses_nothing() {
    let mut draw = Pcg::new(5, 5);
    let mut missed = [0; 3];
    for _ in 0..40 {
        let cubes: Vec<Cube> = (0..60)
            .map(|_| {
                let middle = [(); 3].map(|()| draw.real(real!("-4"), real!("4")));
                (Vec3::from_raw(middle.map(Real::raw)), draw.real(real!("0.05"), real!("1")))
            })
            .collect();
        let all = given(BruteForce::new(), &cubes);
        assert_eq!(octree(&cubes), all);
        let rules = [classic(&cubes), no_negative(&cubes), corrected(&cubes)];
        for (missed, rule) in missed.iter_mut().zip(rules) {
            *missed += all.len() - rule.len();
        }
    }
    assert!(missed[0] > 100 && missed[1] > 100, "{missed:?}");
    assert_eq!(missed[2], 0);
}
