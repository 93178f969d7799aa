//! What a tree promises of itself.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use core::ops::Range;

use super::Bvh;
use super::build::LANES;
use super::volume::Volume;
use crate::geometry::Triangle;
use crate::math::Vec3;
use crate::store::slot_index;

/// What is wrong with a tree. Nodes are counted from the root, 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum BvhFault {
    /// A node has no children or too many, or they are not where they belong.
    Node {
        /// The node.
        node: u32,
    },
    /// A face is in no leaf, or in two.
    Face {
        /// The face.
        face: u32,
    },
    /// A volume does not hold a corner of a face below it.
    Volume {
        /// The node that has it.
        node: u32,
        /// Its place among the volumes of the node.
        lane: u32,
    },
}

impl<V: Volume> Bvh<V> {
    /// Checks that every face is in one leaf, and that every volume holds every corner of the faces
    /// below it, exactly. O(n log n).
    ///
    /// # Errors
    /// [`BvhFault`]: there is a bug in this library.
    pub fn validate(&self) -> Result<(), BvhFault> {
        let ranges = self.ranges()?;
        let mut is_seen = vec![false; self.mesh.faces().len()];
        for &face in &self.shape.faces {
            let is_seen = is_seen.get_mut(face as usize).ok_or(BvhFault::Face { face })?;
            if core::mem::replace(is_seen, true) {
                return Err(BvhFault::Face { face });
            }
        }
        if let Some((face, _)) = (0..).zip(is_seen).find(|(_, is_seen)| !is_seen) {
            return Err(BvhFault::Face { face });
        }
        for (node, link) in (0..).zip(&self.shape.links) {
            let volumes = &self.volumes[node as usize];
            for (lane, (volume, place)) in (0..).zip(volumes.iter().zip(link.below())) {
                let faces = if link.is_leaf { place..place + 1 } else { ranges[place].clone() };
                let holds = |corner: &Vec3| {
                    let cell = self.cells.of_point(*corner);
                    self.cells.holds(&cell, *corner) && volume.contains(&cell)
                };
                if !self.triangles[faces].iter().flat_map(Triangle::corners).all(holds) {
                    return Err(BvhFault::Volume { node, lane });
                }
            }
        }
        Ok(())
    }
}

impl<V: Volume> Bvh<V> {
    /// The places of the faces below every node, if they are those of the tree: each node is a
    /// child of one other, the root of none, and the faces of children follow one another.
    fn ranges(&self) -> Result<Vec<Range<usize>>, BvhFault> {
        let (links, count) = (&self.shape.links, self.triangles.len());
        let mut ranges = vec![0..0; links.len()];
        let mut is_child = vec![false; links.len()];
        for (place, link) in links.iter().enumerate().rev() {
            let fault = BvhFault::Node { node: slot_index(place) };
            let below = link.below();
            let end = if link.is_leaf { count } else { links.len() };
            let is_behind = link.is_leaf || below.start > place;
            if below.is_empty() || below.len() > LANES || below.end > end || !is_behind {
                return Err(fault);
            }
            let range = if link.is_leaf {
                below
            } else {
                let parts = &ranges[below.clone()];
                let follow = parts.windows(2).all(|pair| pair[0].end == pair[1].start);
                let is_twice =
                    is_child[below].iter_mut().any(|seen| core::mem::replace(seen, true));
                if is_twice || !follow {
                    return Err(fault);
                }
                parts[0].start..parts[parts.len() - 1].end
            };
            ranges[place] = range;
        }
        let is_whole = ranges.first() == Some(&(0..count)) && self.shape.faces.len() == count;
        let lost = is_child.iter().skip(1).position(|is_child| !is_child);
        match (is_whole, lost) {
            (true, None) => Ok(ranges),
            _ => Err(BvhFault::Node { node: 0 }),
        }
    }
}

impl fmt::Display for BvhFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Node { node } => write!(f, "node {node} has wrong children"),
            Self::Face { face } => write!(f, "face {face} is not in one leaf"),
            Self::Volume { node, lane } => {
                write!(f, "volume {lane} of node {node} does not hold its faces")
            }
        }
    }
}

impl core::error::Error for BvhFault {}

#[cfg(test)]
mod tests {
    use alloc::sync::Arc;
    use alloc::vec::Vec;

    use super::super::{CellBox, CellCylinder, CellSphere};
    use super::*;
    use crate::geometry::{Grid, TriangleMesh};

    /// A sheet that is tilted against the axes.
    fn tree<V: Volume>() -> Bvh<V> {
        let grid = Grid {
            corner: Vec3::ZERO,
            edge_u: Vec3::from_ints(9, 2, 1),
            edge_v: Vec3::from_ints(-1, 3, 8),
            columns: 10,
            rows: 10,
        };
        Bvh::new(Arc::new(TriangleMesh::grid(&grid).expect("a mesh")))
    }

    /// What is found when something is wrong.
    fn fault(change: impl FnOnce(&mut Bvh<CellBox>)) -> BvhFault {
        let mut tree = tree();
        tree.validate().expect("sound");
        change(&mut tree);
        tree.validate().expect_err("broken")
    }

    #[test]
    fn wrong_shapes_are_noticed() {
        let leaf = |tree: &Bvh<CellBox>| tree.shape.links.iter().position(|link| link.is_leaf);
        let root = BvhFault::Node { node: 0 };
        assert_eq!(fault(|tree| tree.shape.links[0].len = 0), root);
        assert_eq!(fault(|tree| tree.shape.links[0].len = 5), root);
        assert_eq!(fault(|tree| tree.shape.links[0].len = 3), root);
        assert_eq!(fault(|tree| tree.shape.links[0].first = 0), root);
        assert_eq!(fault(|tree| tree.shape.links[0].first = u32::MAX - 3), root);
        assert_eq!(fault(|tree| tree.shape.links[0].is_leaf = true), root);
        let last = slot_index(tree::<CellBox>().nodes());
        let twice = fault(|tree| tree.shape.links.push(tree.shape.links[1]));
        assert_eq!(twice, BvhFault::Node { node: last });
        let shifted = fault(|tree| {
            let leaf = leaf(tree).expect("a leaf");
            tree.shape.links[leaf].first ^= 4;
        });
        assert!(matches!(shifted, BvhFault::Node { .. }), "{shifted}");
    }

    #[test]
    fn lost_faces_are_noticed() {
        assert_eq!(fault(|tree| tree.shape.faces[0] = 500), BvhFault::Face { face: 500 });
        let first = tree::<CellBox>().shape.faces[0];
        assert_eq!(fault(|tree| tree.shape.faces[1] = first), BvhFault::Face { face: first });
        assert_eq!(fault(|tree| tree.shape.faces.truncate(161)), BvhFault::Node { node: 0 });
    }

    /// Every volume in turn is replaced by that of a single corner.
    fn volumes_are_checked<V: Volume>() {
        let sound = tree::<V>();
        let corner = sound.cells.of_point(sound.mesh.vertices()[0]);
        let mut seen = 0;
        for (node, link) in (0..).zip(&sound.shape.links) {
            for (lane, _) in (0..).zip(link.below()) {
                let mut tree = sound.clone();
                tree.volumes[node as usize][lane as usize] = V::around(&[corner]);
                assert_eq!(tree.validate(), Err(BvhFault::Volume { node, lane }));
                seen += 1;
            }
        }
        assert!(seen > 162, "only {seen} volumes");
    }

    #[test]
    fn wrong_volumes_are_noticed() {
        volumes_are_checked::<CellBox>();
        volumes_are_checked::<CellSphere>();
        volumes_are_checked::<CellCylinder>();
    }

    /// A point that leaves by one raw unit is outside.
    #[test]
    fn moved_corners_are_noticed() {
        let sound = tree::<CellBox>();
        let (mut noticed, ulp) = (0, Vec3::from_raw([1, 0, 0]));
        for place in 0..sound.triangles.len() {
            let mut tree = sound.clone();
            let corners = tree.triangles[place].corners().map(|corner| corner + ulp);
            tree.triangles[place] = Triangle::between(corners);
            noticed += u32::from(tree.validate().is_err());
        }
        assert_eq!(noticed, 162);
        let names: Vec<_> = [BvhFault::Node { node: 1 }, BvhFault::Face { face: 1 }]
            .iter()
            .map(alloc::string::ToString::to_string)
            .collect();
        assert_eq!(names, ["node 1 has wrong children", "face 1 is not in one leaf"]);
    }
}
