//! Moving boxes: the dynamic tree beside parry's, used as rapier uses it.
//!
//! Unit boxes fly through a room and bounce at its walls, the same for both. A tick tells the tree
//! all new boxes and asks for the pairs; moving the boxes is not timed. parry gets them as
//! rapier's broad phase gives them to it (`insert_or_update_partially` with a margin of 1 cm,
//! `optimize_incremental`, `refit`, and the pairs of which one box changed), without the hash map
//! in which rapier keeps the pairs that did not change; and without margin, all pairs each tick,
//! which are the pairs that verlock gives, though unsorted. verlock is held against the quicker of
//! both.

use std::time::{Duration, Instant};

use parry3d::bounding_volume::Aabb as PeerBox;
use parry3d::math::Vector;
use parry3d::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use verlock::Vec3;
use verlock::geometry::Aabb;
use verlock::math::Pcg;
use verlock::partition::{DynamicTree, Pair, Partition};

use crate::clock::rounds;

/// Raw steps of a unit of this scene, 2^-12 m: then `f32` is exact for both.
const UNIT: i64 = 1 << 12;
const TICKS: u32 = 64;
/// As rapier has it.
const MARGIN: f32 = 1e-2;

/// Prints all measurements.
pub fn run() {
    let game = [70, 680]; // 1 to 10 m/s at 60 Hz
    compare("10,000 boxes, 1-10 m/s", &Scene::new(10_000, 30, game));
    let fast = game.map(|speed| speed * 4);
    compare("10,000 boxes, 4-40 m/s", &Scene::new(10_000, 30, fast));
    let some = Scene { moving: 100, ..Scene::new(10_000, 30, game) };
    compare("100 of 10,000 boxes, 1-10 m/s", &some);
    compare("100,000 boxes, 1-10 m/s", &Scene::new(100_000, 64, game));
}

/// Unit boxes in a room.
#[derive(Clone)]
struct Scene {
    /// Lowest corners and ways in a tick, in units.
    boxes: Vec<[[i64; 3]; 2]>,
    /// So many of them move.
    moving: usize,
    room: i64,
}

impl Scene {
    fn new(count: usize, metres: u32, [slowest, fastest]: [u32; 2]) -> Self {
        let mut draw = Pcg::new(1, 1);
        let room = metres * 4096;
        let mut one = || {
            let place = [(); 3].map(|()| i64::from(draw.below(room)));
            // A direction out of a cube is good enough.
            let way = [(); 3].map(|()| i64::from(draw.below(2001)) - 1000);
            let length = way.map(|c| c * c).iter().sum::<i64>().isqrt().max(1);
            let speed = i64::from(slowest + draw.below(fastest - slowest));
            [place, way.map(|c| c * speed / length)]
        };
        let boxes = (0..count).map(|_| one()).collect();
        Self { boxes, moving: count, room: i64::from(room) }
    }

    fn step(&mut self) {
        for [place, way] in &mut self.boxes[..self.moving] {
            for k in 0..3 {
                if !(0..self.room).contains(&(place[k] + way[k])) {
                    way[k] = -way[k];
                }
                place[k] = (place[k] + way[k]).clamp(0, self.room);
            }
        }
    }

    fn ours(&self) -> Vec<Aabb> {
        let corner = |place: [i64; 3]| Vec3::from_raw(place.map(|c| c * UNIT));
        let one =
            |[place, _]: &[[i64; 3]; 2]| Aabb::new(corner(*place), corner(place.map(|c| c + UNIT)));
        self.boxes.iter().map(one).collect()
    }

    fn peers(&self) -> Vec<PeerBox> {
        let corner = |place: [i64; 3]| {
            let [x, y, z] = place.map(|c| c as f32 / UNIT as f32);
            Vector::new(x, y, z)
        };
        let one = |[place, _]: &[[i64; 3]; 2]| {
            PeerBox::new(corner(*place), corner(place.map(|c| c + UNIT)))
        };
        self.boxes.iter().map(one).collect()
    }
}

/// What a side does in a tick, given the boxes that moved: it leaves pairs.
trait Side {
    fn tick(&mut self, scene: &Scene) -> Duration;
}

/// Any of our partitions.
struct Ours<P> {
    partition: P,
    pairs: Vec<Pair>,
}

impl<P: Partition> Ours<P> {
    fn new(mut partition: P, scene: &Scene) -> Self {
        for (id, bounds) in (0..).zip(scene.ours()) {
            partition.insert(id, bounds.into()).expect("a sound box");
        }
        Self { partition, pairs: vec![] }
    }
}

impl<P: Partition> Side for Ours<P> {
    fn tick(&mut self, scene: &Scene) -> Duration {
        let boxes = scene.ours();
        let clock = Instant::now();
        for (id, bounds) in (0..).zip(&boxes[..scene.moving]) {
            self.partition.update(id, (*bounds).into()).expect("a sound box");
        }
        let pairs = self.partition.pairs();
        let time = clock.elapsed();
        self.pairs.clear();
        self.pairs.extend_from_slice(pairs);
        time
    }
}

/// parry's tree; `MARGIN` or none.
struct Peer<const DETECTS: bool> {
    tree: Bvh,
    work: BvhWorkspace,
    pairs: Vec<Pair>,
}

impl<const DETECTS: bool> Peer<DETECTS> {
    fn new(scene: &Scene) -> Self {
        let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &scene.peers());
        Self { tree, work: BvhWorkspace::default(), pairs: vec![] }
    }
}

impl<const DETECTS: bool> Side for Peer<DETECTS> {
    fn tick(&mut self, scene: &Scene) -> Duration {
        let boxes = scene.peers();
        let clock = Instant::now();
        let margin = if DETECTS { MARGIN } else { 0.0 };
        for (id, bounds) in (0..).zip(&boxes[..scene.moving]) {
            self.tree.insert_or_update_partially(*bounds, id, margin);
        }
        self.tree.optimize_incremental(&mut self.work);
        self.tree.refit(&mut self.work);
        self.pairs.clear();
        let pairs = &mut self.pairs;
        self.tree.traverse_bvtt_single_tree::<DETECTS>(&mut self.work, &mut |a, b| {
            pairs.push([a.min(b), a.max(b)]);
        });
        clock.elapsed()
    }
}

/// Mean and longest time of a tick in the quickest round.
fn measure(side: &mut impl Side, scene: &Scene) -> [Duration; 2] {
    // A round of many boxes takes long enough.
    let rounds = if scene.boxes.len() > 10_000 { 1 } else { rounds().min(5) };
    let mut scene = scene.clone();
    let mut round = || {
        let times = [(); TICKS as usize].map(|()| {
            scene.step();
            side.tick(&scene)
        });
        [times.iter().sum::<Duration>() / TICKS, times.into_iter().max().unwrap_or_default()]
    };
    (0..rounds).map(|_| round()).min().unwrap_or_default()
}

fn compare(name: &str, scene: &Scene) {
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    let mut ours = Ours::new(DynamicTree::new(), scene);
    let mut rapier = Peer::<true>::new(scene);
    let mut exact = Peer::<false>::new(scene);
    let times =
        [measure(&mut ours, scene), measure(&mut rapier, scene), measure(&mut exact, scene)];
    exact.pairs.sort_unstable();
    assert!(ours.pairs == exact.pairs, "{} and {}", ours.pairs.len(), exact.pairs.len());
    println!("{name}: {} pairs", ours.pairs.len());
    let names = ["verlock", "parry, margin", "parry, exact"];
    for (name, [mean, longest]) in names.into_iter().zip(times) {
        println!("{name:<24} {:>7.3} ms a tick, the longest {:.3}", ms(mean), ms(longest));
    }
    let [ours, peers] = [times[0][0], times[1][0].min(times[2][0])].map(ms);
    println!("verlock: parry * {:.2}", ours / peers);
}
