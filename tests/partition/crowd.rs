//! Boxes of all sizes and in all places, and what happens to them.

use verlock::geometry::Aabb;
use verlock::math::Pcg;
use verlock::partition::{Object, Partition};
use verlock::{Real, Vec3};

const ONE: i64 = Real::ONE.raw();
const LIMIT: i64 = Object::COORDINATE_MAX;
/// No more objects at a time.
const OBJECTS_MAX: u32 = 64;

/// A tick's worth of changes.
pub enum Change {
    Insert(u32, Object),
    Update(u32, Object),
    Remove(u32),
}

/// Objects that come, move and go.
pub struct Crowd {
    draw: Pcg,
    /// By id, with the way in a tick.
    objects: Vec<Option<(Object, Vec3)>>,
}

impl Crowd {
    pub fn new(seed: u64) -> Self {
        Self { draw: Pcg::new(seed, 3), objects: vec![None; OBJECTS_MAX as usize] }
    }

    fn below(&mut self, n: u32) -> u32 {
        self.draw.below(n)
    }

    fn within(&mut self, reach: i64) -> i64 {
        self.draw.real(Real::from_raw(-reach), Real::from_raw(reach + 1)).raw()
    }

    /// What happens in a tick: often little, at times everything moves.
    pub fn tick(&mut self) -> Vec<Change> {
        let mut changes = vec![];
        let some = [0, 1, 2, 5, 64][self.below(5) as usize];
        for _ in 0..some {
            let id = self.below(OBJECTS_MAX);
            changes.extend(self.change(id));
        }
        if self.below(3) == 0 {
            changes.extend((0..OBJECTS_MAX).filter_map(|id| self.go(id)));
        }
        changes
    }

    /// Something comes, goes or jumps.
    fn change(&mut self, id: u32) -> Option<Change> {
        if self.objects[id as usize].is_some() {
            return match self.below(4) {
                0 => {
                    self.objects[id as usize] = None;
                    Some(Change::Remove(id))
                }
                1 => {
                    let object = self.object();
                    self.objects[id as usize].as_mut()?.0 = object;
                    Some(Change::Update(id, object))
                }
                _ => self.go(id),
            };
        }
        let object = self.object();
        let way = [0, ONE / 100, ONE / 10, ONE][self.below(4) as usize];
        let way = Vec3::from_raw([(); 3].map(|()| self.within(way)));
        self.objects[id as usize] = Some((object, way));
        Some(Change::Insert(id, object))
    }

    /// An object goes on, if it stays in the world.
    fn go(&mut self, id: u32) -> Option<Change> {
        let (object, way) = self.objects[id as usize].as_mut()?;
        let [low, high] = [object.bounds.min() + *way, object.bounds.max() + *way];
        let inside = |corner: Vec3| corner.raw().iter().all(|c| c.abs() <= LIMIT);
        if *way == Vec3::ZERO || !inside(low) || !inside(high) {
            return None;
        }
        *object = Aabb::new(low, high).into();
        Some(Change::Update(id, *object))
    }

    /// Any object.
    fn object(&mut self) -> Object {
        let bounds = self.bounds();
        let mut object = Object::from(bounds);
        match self.below(8) {
            0 => object.centre = bounds.min(),
            1 => object.centre = bounds.max(),
            2 => object.centre = Vec3::from_raw([(); 3].map(|()| self.within(LIMIT))),
            _ => {}
        }
        object
    }

    /// Any box.
    pub fn bounds(&mut self) -> Aabb {
        let kind = self.below(10);
        match kind {
            // They touch exactly, at faces, edges and corners.
            0 | 1 => {
                let corner = [(); 3].map(|()| i64::from(self.below(5)) * ONE);
                span(corner, [ONE; 3])
            }
            // Across the middle of the world.
            2 | 3 => self.near([0; 3], 6 * ONE, 2 * ONE),
            // One inside the other; points among them.
            4 => {
                let size = ONE >> (2 * self.below(14));
                span([-size; 3], [2 * size; 3])
            }
            // All of the world along some axes.
            5 => {
                let far = [(); 3].map(|()| [1, ONE, LIMIT][self.below(3) as usize]);
                span(far.map(|c| -c), far.map(|c| 2 * c))
            }
            // Always the same.
            6 => span([ONE; 3], [ONE / 2; 3]),
            // Far from the origin, and at the edges of the world.
            7 => self.near([1 << 59, -(1 << 59), 1 << 59], 6 * ONE, 2 * ONE),
            8 => {
                let corner = [(); 3].map(|()| [-LIMIT, LIMIT - ONE][self.below(2) as usize]);
                span(corner, [ONE; 3])
            }
            // Any size anywhere.
            _ => {
                let [reach, size] = [(); 2].map(|()| 1 << self.below(60));
                self.near([0; 3], reach, size)
            }
        }
    }

    fn near(&mut self, middle: [i64; 3], reach: i64, size: i64) -> Aabb {
        let corner = middle.map(|c| c + self.within(reach));
        span(corner, [(); 3].map(|()| self.within(size)))
    }
}

/// The box from a corner, so long, cut off at the edge of the world.
fn span(corner: [i64; 3], edges: [i64; 3]) -> Aabb {
    let inside = |c: i64| c.clamp(-LIMIT, LIMIT);
    let end = [0, 1, 2].map(|k| inside(corner[k].saturating_add(edges[k])));
    Aabb::new(Vec3::from_raw(corner.map(inside)), Vec3::from_raw(end))
}

/// Tells a partition what happened.
pub fn apply(partition: &mut dyn Partition, changes: &[Change]) {
    for change in changes {
        let told = match *change {
            Change::Insert(id, object) => partition.insert(id, object),
            Change::Update(id, object) => partition.update(id, object),
            Change::Remove(id) => partition.remove(id),
        };
        told.expect("a sound change");
    }
}
