//! A tree of boxes that objects may leave a little before it changes.

mod build;
mod coarse;
mod meet;
mod tree;

use alloc::vec::Vec;

use super::roster::Roster;
use super::{Object, Pair, Partition, PartitionError};
use crate::geometry::Aabb;
use crate::math::Vec3;

use build::Leaf;
use coarse::Coarse;
use meet::Stacks;
use tree::{Place, Tree};

/// A fat box reaches as far ahead as the object moves in so many ticks. More of them make the tree
/// change less often, and more candidates that do not touch.
const HORIZON: i64 = 8;

/// A fat box is larger by this part of the object's edge on either side, for what turns or
/// trembles.
const MARGIN_PART: i64 = 16;

/// A thin object's edge counts as this part of the longest one: what is thin may lie beside many.
const THIN_PART: i64 = 8;

/// A tree in which a leaf came to hang deeper is built afresh: leaves that are hung up in order, or
/// all at one place, would make a list of it. What is just built is not as deep.
const DEPTH_MAX: u32 = 128;

/// Queries may look at so many changed objects one by one.
const BACKLOG_MAX: usize = 32;

/// The default: a tree of boxes, and a list of *candidates* that outlives the tick.
///
/// A leaf is a *fat* box, which reaches ahead of the object's motion. While objects stay in their
/// fat boxes, the tree stays as it is, and so do the candidates, all pairs of objects whose fat
/// boxes touch: their tight boxes are compared in one go, in order, so that nothing needs sorting.
/// An object that left its fat box gets another one and its leaf another place; when that happened
/// to many, or the tree became deep, it is built afresh. None of this reaches a result.
///
/// With n objects, c candidates and k objects that left their fat boxes,
/// [`update`](Partition::update) takes O(1), [`pairs`](Partition::pairs) O(c + k log n), or
/// O((n + c) log n) when k is a good part of n. A [`query`](Partition::query) takes O(log n) and
/// something for each box that it touches.
#[derive(Clone, Debug, Default)]
pub struct DynamicTree {
    roster: Roster,
    /// By id. Of what is not stale: the box of its leaf, which contains the tight box.
    fat: Vec<Aabb>,
    /// By id: the way between the last two positions.
    motions: Vec<Vec3>,
    tree: Tree,
    /// What coarse boxes are seen from.
    origin: Vec3,
    /// If listed, all pairs of leaves whose coarse boxes touch, sorted. Some may be gone from the
    /// tree.
    candidates: Vec<Pair>,
    /// Whether the candidates are those of the tree: they are not before pairs are asked for.
    is_listed: bool,
    /// Room for as many pairs as there are candidates.
    pairs: Vec<Pair>,
    /// Leaves that were hung up one by one since the tree was built.
    hung: u32,
    work: Work,
}

/// Kept for its room.
#[derive(Clone, Debug, Default)]
struct Work {
    leaves: Vec<Leaf>,
    stacks: Stacks,
    new: Vec<Pair>,
}

impl DynamicTree {
    /// Without objects.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Catches up with all changes if a query would look at too many of them one by one: at a few
    /// times the root of how many objects there are. So a change costs about O(sqrt n) for n
    /// objects, however many touch: candidates are not listed before pairs are asked for.
    pub(crate) fn keep_up(&mut self) {
        let [changed, all] = [self.roster.stale().len(), self.roster.len() as usize];
        if changed > BACKLOG_MAX && changed * changed / 16 > all {
            self.catch_up();
            self.is_listed = false;
            self.candidates.clear();
            self.roster.settle();
        }
    }

    /// Catches up with all changes, and lists the candidates.
    fn settle(&mut self) {
        if !self.is_listed {
            self.rebuild();
            self.list();
        } else if self.roster.stale().is_empty() {
            return;
        } else if self.catch_up() {
            self.list_changed();
        } else {
            self.list();
        }
        self.roster.settle();
    }

    /// Catches up with all changes but in the candidates; whether leaves were hung up one by one.
    fn catch_up(&mut self) -> bool {
        let [changed, all] = [self.roster.stale().len(), self.roster.len() as usize];
        let are_few = changed * 8 < all && self.hung as usize + changed <= all;
        let is_rehung = are_few && self.rehang();
        if !is_rehung {
            self.rebuild();
        }
        is_rehung
    }

    /// Gives every object a new fat box, and builds the tree from them.
    fn rebuild(&mut self) {
        let Self { roster, fat, motions, tree, work, .. } = self;
        self.origin = middle_of(roster);
        self.hung = 0;
        work.leaves.clear();
        for id in roster.ids() {
            let bounds = fatten(roster.bounds(id), motions[id as usize]);
            fat[id as usize] = bounds;
            work.leaves.push(Leaf { bounds: Coarse::new(&bounds, self.origin), id });
        }
        tree.build(roster.slots(), &mut work.leaves);
    }

    /// Hangs up the stale objects anew; gives up if the tree becomes too deep.
    fn rehang(&mut self) -> bool {
        let Self { roster, fat, motions, tree, .. } = self;
        tree.places.resize(roster.slots(), Place::NOWHERE);
        for &id in roster.stale() {
            tree.remove(id);
            if roster.contains(id) {
                let bounds = fatten(roster.bounds(id), motions[id as usize]);
                fat[id as usize] = bounds;
                self.hung += 1;
                if tree.insert(id, &Coarse::new(&bounds, self.origin)) > DEPTH_MAX {
                    return false;
                }
            }
        }
        true
    }

    /// Finds all candidates; the tree must be just built.
    fn list(&mut self) {
        let Self { tree, candidates, work, .. } = self;
        candidates.clear();
        tree.meet(&mut work.stacks, |a, b| candidates.push([a.min(b), a.max(b)]));
        candidates.sort_unstable();
        self.is_listed = true;
    }

    /// Finds those of the stale objects anew.
    fn list_changed(&mut self) {
        let Self { roster, fat, tree, candidates, work, .. } = self;
        candidates.retain(|&[a, b]| !roster.is_stale(a) && !roster.is_stale(b));
        work.new.clear();
        for &a in roster.stale().iter().filter(|&&id| roster.contains(id)) {
            let region = Coarse::new(&fat[a as usize], self.origin);
            tree.query(&region, &mut work.stacks.single, |b| {
                // Of two stale ones the higher finds the lower.
                if a > b || (a < b && !roster.is_stale(b)) {
                    work.new.push([a.min(b), a.max(b)]);
                }
            });
        }
        work.new.sort_unstable();
        merge(candidates, &work.new);
    }
}

/// Puts one sorted list into another, from behind.
fn merge(into: &mut Vec<Pair>, new: &[Pair]) {
    let mut old = into.len();
    into.extend_from_slice(new);
    let mut end = into.len();
    for &pair in new.iter().rev() {
        while old > 0 && into[old - 1] > pair {
            (old, end) = (old - 1, end - 1);
            into[end] = into[old];
        }
        end -= 1;
        into[end] = pair;
    }
}

/// The box that an object is not expected to leave soon. Coordinates are within
/// 2^60 + 2^61 + 2^57, below 2^62.
fn fatten(tight: &Aabb, motion: Vec3) -> Aabb {
    let [low, high, motion] = [tight.min(), tight.max(), motion].map(Vec3::raw);
    let edges = [0, 1, 2].map(|k| high[k] - low[k]); // at most 2^61
    let longest = edges[0].max(edges[1]).max(edges[2]);
    // What moves by half its size would have left by the time after next.
    if motion.into_iter().any(|way| way.abs() > longest / 2) {
        return *tight;
    }
    let margin = edges.map(|edge| edge.max(longest / THIN_PART) / MARGIN_PART);
    let reach = motion.map(|way| way.clamp(-longest / HORIZON, longest / HORIZON) * HORIZON);
    let ahead =
        |k: usize| [low[k] - margin[k] + reach[k].min(0), high[k] + margin[k] + reach[k].max(0)];
    let ahead = [ahead(0), ahead(1), ahead(2)];
    Aabb::new(
        Vec3::from_raw(ahead.map(|[low, _]| low)),
        Vec3::from_raw(ahead.map(|[_, high]| high)),
    )
}

/// The median of a few lowest corners, along each axis: what lies far out does not move it.
fn middle_of(roster: &Roster) -> Vec3 {
    const SAMPLE: usize = 64;
    let stride = (roster.len() as usize / SAMPLE).max(1);
    let sample: Vec<_> = roster.ids().step_by(stride).collect();
    if sample.is_empty() {
        return Vec3::ZERO;
    }
    Vec3::from_raw([0, 1, 2].map(|k| {
        let mut along: Vec<_> = sample.iter().map(|&id| roster.bounds(id).min().raw()[k]).collect();
        let half = along.len() / 2;
        *along.select_nth_unstable(half).1
    }))
}

impl Partition for DynamicTree {
    fn insert(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        self.roster.insert(id, object)?;
        self.fat.resize(self.roster.slots(), object.bounds);
        self.motions.resize(self.roster.slots(), Vec3::ZERO);
        self.motions[id as usize] = Vec3::ZERO;
        Ok(())
    }

    #[inline]
    fn update(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        let before = self.roster.update(id, object)?;
        let [from, to] = [&before, &object.bounds];
        self.motions[id as usize] = to.min() - from.min();
        if !self.fat[id as usize].contains(to) {
            self.roster.mark(id);
        }
        Ok(())
    }

    fn remove(&mut self, id: u32) -> Result<(), PartitionError> {
        self.roster.remove(id)
    }

    fn object(&self, id: u32) -> Option<Object> {
        self.roster.object(id)
    }

    fn len(&self) -> u32 {
        self.roster.len()
    }

    fn pairs(&mut self) -> &[Pair] {
        self.settle();
        let Self { roster, candidates, pairs, .. } = self;
        pairs.resize(pairs.len().max(candidates.len()), [0; 2]);
        let mut found = 0;
        for &pair in &*candidates {
            pairs[found] = pair;
            found += usize::from(roster.touch(pair));
        }
        &pairs[..found]
    }

    fn query(&self, region: &Aabb, ids: &mut Vec<u32>) {
        ids.clear();
        let coarse = Coarse::new(region, self.origin);
        self.tree.query(&coarse, &mut Vec::new(), |id| {
            if !self.roster.is_stale(id) && self.roster.bounds(id).overlaps(region) {
                ids.push(id);
            }
        });
        self.roster.complete(region, ids);
    }

    fn validate(&self) -> Result<(), &'static str> {
        self.roster.validate()?;
        let settled = |id: &u32| !self.roster.is_stale(*id);
        let mut ids = self.roster.ids().filter(settled);
        if !ids.all(|id| self.fat[id as usize].contains(self.roster.bounds(id))) {
            return Err("dynamic tree: a tight box that left its fat one");
        }
        let coarse = |id: u32| Coarse::new(&self.fat[id as usize], self.origin);
        self.tree.validate(coarse)?;
        let hung = |id: u32| self.tree.places[id as usize] != Place::NOWHERE;
        if !self.roster.ids().filter(settled).all(hung) {
            return Err("dynamic tree: an object without a leaf");
        }
        if !self.candidates.is_sorted_by(|a, b| a < b) {
            return Err("dynamic tree: candidates out of order");
        }
        let lives = |&id: &u32| self.roster.contains(id) || self.roster.is_stale(id);
        if !self.candidates.iter().all(|pair| pair[0] < pair[1] && pair.iter().all(lives)) {
            return Err("dynamic tree: a candidate that is not two objects");
        }
        if !self.is_listed {
            return Ok(());
        }
        let mut wanted = Vec::new();
        for a in self.roster.ids().filter(settled) {
            self.tree.query(&coarse(a), &mut Vec::new(), |b| {
                if a < b && !self.roster.is_stale(b) {
                    wanted.push([a, b]);
                }
            });
        }
        if wanted.iter().all(|pair| self.candidates.binary_search(pair).is_ok()) {
            Ok(())
        } else {
            Err("dynamic tree: leaves that touch and are no candidates")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::BruteForce;
    use super::*;

    fn cube(x: i32) -> Object {
        Aabb::new(Vec3::from_ints(x, 0, 0), Vec3::from_ints(x + 1, 1, 1)).into()
    }

    /// Cubes in a row, apart, caught up with.
    fn row(length: i32) -> DynamicTree {
        let mut tree = DynamicTree::new();
        for (id, x) in (0..).zip(0..length) {
            tree.insert(id, cube(2 * x)).expect("inserted");
        }
        tree.pairs();
        tree
    }

    fn depth(tree: &Tree, id: u32) -> u32 {
        let mut place = tree.places[id as usize];
        let mut depth = 0;
        while place.node != 0 {
            place = tree.nodes[place.node as usize].parent;
            depth += 1;
        }
        depth
    }

    /// Leaves that come in order, or all between the same others, do not make the tree a list.
    #[test]
    fn the_tree_stays_shallow() {
        for step in [2, 0] {
            let mut tree = row(1000);
            for tick in 0..7 {
                for id in tick * 120..(tick + 1) * 120 {
                    let place = 2000 + step * i32::try_from(id).unwrap_or(0);
                    tree.update(id, cube(place)).expect("updated");
                }
                tree.pairs();
                let deepest = (0..1000).map(|id| depth(&tree.tree, id)).max();
                assert!(deepest <= Some(DEPTH_MAX), "{deepest:?} in tick {tick}");
                assert_eq!(tree.validate(), Ok(()));
            }
        }
    }

    /// However many change, few are looked at one by one, and the rest is where it should be.
    #[test]
    fn queries_find_what_has_changed() {
        let mut tree = DynamicTree::new();
        let mut most = 0;
        for id in 0..3000 {
            let place = |id: u32| i32::try_from(id * 7 % 3000).unwrap_or(0);
            tree.insert(id, cube(2 * place(id))).expect("inserted");
            tree.keep_up();
            if id % 3 == 2 {
                tree.remove(id - 1).expect("removed");
                tree.keep_up();
                tree.update(id / 2 * 2 / 3 * 3, cube(2 * place(id + 1) + 1)).expect("updated");
                tree.keep_up();
            }
            most = most.max(tree.roster.stale().len());
        }
        assert_eq!(tree.validate(), Ok(()));
        assert!((32..=200).contains(&most), "{most}");
        assert!(tree.candidates.is_empty());
        let mut found = Vec::new();
        for x in 0..600 {
            let region =
                Aabb::new(Vec3::from_ints(10 * x, 0, 0), Vec3::from_ints(10 * x + 3, 1, 1));
            tree.query(&region, &mut found);
            let near = |&id: &u32| tree.object(id).is_some_and(|o| o.bounds.overlaps(&region));
            assert_eq!(found, (0..3000).filter(near).collect::<Vec<_>>());
        }
    }

    /// Also where nobody asked for them for long, or does now and then.
    #[test]
    fn pairs_are_found_after_many_changes() {
        let mut tree = DynamicTree::new();
        let mut brute = BruteForce::new();
        for id in 0..4000 {
            let object = cube(i32::try_from(id * 7 % 4000).unwrap_or(0));
            tree.insert(id, object).expect("inserted");
            brute.insert(id, object).expect("inserted");
        }
        for round in 0..4 {
            assert_eq!(tree.pairs(), brute.pairs());
            assert_eq!(tree.validate(), Ok(()));
            for id in 300 * round..300 * (round + 1) {
                tree.remove(id).expect("removed");
                brute.remove(id).expect("removed");
                tree.keep_up();
            }
            assert_eq!(tree.validate(), Ok(()));
        }
    }

    /// The centre is a matter of orthtrees.
    #[test]
    fn centres_do_not_matter() {
        let mut tree = DynamicTree::new();
        let centre = Vec3::from_raw([Object::COORDINATE_MAX; 3]);
        for (id, x) in (0..).zip(0..100) {
            tree.insert(id, Object { centre, ..cube(2 * x) }).expect("inserted");
        }
        assert!(tree.pairs().is_empty() && tree.candidates.is_empty());
    }

    /// Each thing that the tree takes for granted is missed when it does not hold.
    #[test]
    fn defects_are_found() {
        type Defect = fn(&mut DynamicTree);
        let defects: [(&str, Defect); 6] = [
            ("a tight box that left", |tree| tree.fat[3] = Aabb::of_point(Vec3::ZERO)),
            ("leaves that touch", |tree| tree.candidates.clear()),
            ("a candidate that is not", |tree| tree.candidates.push([8, 9])),
            ("a candidate that is not", |tree| tree.candidates.push([8, 7])),
            ("out of order", |tree| tree.candidates.insert(0, [5, 6])),
            ("tree: a", |tree| tree.tree.remove(3)),
        ];
        for (wanted, defect) in defects {
            let mut tree = DynamicTree::new();
            for id in 0..10 {
                tree.insert(id, cube(i32::try_from(id).unwrap_or(0))).expect("inserted");
            }
            tree.pairs();
            tree.remove(9).expect("removed");
            tree.pairs();
            assert_eq!(tree.validate(), Ok(()));
            defect(&mut tree);
            let told = tree.validate().expect_err(wanted);
            assert!(told.contains(wanted), "{told}, not {wanted}");
        }
    }
}
