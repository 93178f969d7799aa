//! Objects that come, move and go, in every partition.

use verlock::geometry::{Aabb, TriangleMesh};
use verlock::math::Vec3;
use verlock::partition::{
    BruteForce, Bsp, DynamicTree, ID_MAX, Object, Orthtree, Partition, PartitionError,
};

use super::draw::Draw;

/// Few ids, so that they meet again.
const IDS: usize = 24;

/// A kilometre, raw.
const FAR: i64 = 1000 << 24;

/// All partitions give the pairs, queries and errors that brute force gives, and what they take for
/// granted holds. True if there were pairs.
pub fn broad_phase(bytes: &[u8]) -> bool {
    let draw = &mut Draw::new(bytes);
    let mut partitions = all(draw);
    let mut had_pairs = false;
    while !draw.is_done() {
        let change = Change::draw(draw);
        let region = bounds(draw);
        let is_asked = draw.below(4) == 0;
        let mut wanted = None;
        for partition in &mut partitions {
            let told = change.tell(&mut **partition);
            assert_eq!(partition.validate(), Ok(()));
            let mut ids = vec![];
            partition.query(&region, &mut ids);
            let pairs = if is_asked { partition.pairs().to_vec() } else { vec![] };
            assert_eq!(partition.validate(), Ok(()));
            let given = (told, ids, pairs, partition.len());
            assert_eq!(*wanted.get_or_insert_with(|| given.clone()), given);
        }
        had_pairs |= wanted.is_some_and(|(_, _, pairs, _)| !pairs.is_empty());
    }
    had_pairs
}

/// The oracle first. Walls, levels and counts are drawn.
fn all(draw: &mut Draw<'_>) -> [Box<dyn Partition>; 6] {
    let walls = (0..draw.below(8) * 3).map(|_| bounds(draw).min());
    let walls: Vec<Vec3> = walls.collect();
    let faces = (0..).step_by(3).take(walls.len() / 3).map(|first| [first, first + 1, first + 2]);
    let bsp = match TriangleMesh::new(walls.iter().copied(), faces) {
        Ok(mesh) => Bsp::<3>::new().walls(&mesh),
        Err(_) => Bsp::<3>::new(),
    };
    let [depth, least] = [61, 6].map(|n| u32::try_from(draw.below(n)).expect("a small number"));
    [
        Box::new(BruteForce::new()),
        Box::new(DynamicTree::new()),
        Box::new(Orthtree::<3>::new().depth(60 - depth).objects_min(least)),
        Box::new(Orthtree::<2>::new().depth(60 - depth).objects_min(least)),
        Box::new(bsp),
        Box::new(Bsp::<2>::new()),
    ]
}

/// Something that is told to a partition.
enum Change {
    Insert(u32, Object),
    Update(u32, Object),
    Remove(u32),
}

impl Change {
    fn draw(draw: &mut Draw<'_>) -> Self {
        let id = u32::try_from(draw.below(IDS)).expect("a small number");
        let id = if draw.below(64) == 63 { ID_MAX + 1 } else { id };
        match draw.below(5) {
            0 => Self::Remove(id),
            1 | 2 => Self::Insert(id, object(draw)),
            _ => Self::Update(id, object(draw)),
        }
    }

    fn tell(&self, partition: &mut dyn Partition) -> Result<(), PartitionError> {
        match *self {
            Self::Insert(id, object) => partition.insert(id, object),
            Self::Update(id, object) => partition.update(id, object),
            Self::Remove(id) => partition.remove(id),
        }
    }
}

fn object(draw: &mut Draw<'_>) -> Object {
    let object = Object::from(bounds(draw));
    let centre = if draw.below(8) == 7 { draw.vector(FAR) } else { object.centre };
    Object { centre, ..object }
}

/// Mostly a few eighths of a metre near the origin, where boxes touch exactly.
fn bounds(draw: &mut Draw<'_>) -> Aabb {
    if draw.below(16) == 15 {
        return Aabb::new(draw.vector(FAR), draw.vector(FAR));
    }
    let mut eighths = |n: usize| i64::try_from(draw.below(n)).expect("a small number") << 21;
    let corner = [(); 3].map(|()| eighths(32) - eighths(16));
    let edge = [(); 3].map(|()| eighths(10));
    let end = [0, 1, 2].map(|k| corner[k] + edge[k]);
    Aabb::new(Vec3::from_raw(corner), Vec3::from_raw(end))
}
