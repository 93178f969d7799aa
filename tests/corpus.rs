//! What the fuzzers start from keeps the laws that they assert, without a fuzzer.
//!
//! `BLESS=1` says of the committed files of another `SIM_VERSION` that they are of this one, and
//! writes into sound replays what stepping them gives now.

#[path = "../fuzz/src/laws/mod.rs"]
#[allow(unreachable_pub, reason = "public in the library that the fuzz targets share")]
pub mod laws;

use std::env;
use std::fs;
use std::panic::catch_unwind;
use std::path::PathBuf;

use verlock::SIM_VERSION;
use verlock::replay::Replay;

use laws::container::restamp;

/// The files of a target's corpus, sorted.
fn files(target: &str) -> Vec<PathBuf> {
    let folder = [env!("CARGO_MANIFEST_DIR"), "fuzz", "corpus", target].iter().collect::<PathBuf>();
    let entries = fs::read_dir(&folder).expect("the corpus is committed");
    let mut files: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.sort();
    files
}

/// Every file keeps the law. Fewer files than `least`, or fewer accepted ones, would mean that
/// something was lost, or that the decoder no longer lets the corpus in.
fn keeps(target: &str, law: fn(&[u8]) -> bool, [least, accepted]: [usize; 2]) {
    let files = files(target);
    let let_in = files.iter().filter(|path| {
        let name = path.display().to_string();
        let bytes = fs::read(path).expect(&name);
        catch_unwind(|| law(&bytes)).expect(&name)
    });
    let found = [files.len(), let_in.count()];
    assert!(found[0] >= least && found[1] >= accepted, "{found:?} of [{least}, {accepted}]");
}

/// Brings files of another version of the simulation up to date, if that is asked for.
fn bless(target: &str) {
    if env::var_os("BLESS").is_none() {
        return;
    }
    assert!(env::var_os("CI").is_none(), "nothing is blessed where CI is set");
    for path in files(target) {
        let mut bytes = fs::read(&path).expect("a file");
        let stamp = bytes.get(12..16);
        let old = stamp.is_some_and(|stamp| stamp != SIM_VERSION.to_le_bytes());
        if old || Replay::parse(&bytes).is_ok() {
            restamp(&mut bytes);
            fs::write(&path, bytes).expect("written");
        }
    }
}

#[test]
fn snapshots_keep_their_laws() {
    bless("snapshot_decode");
    keeps("snapshot_decode", laws::snapshot, [40, 30]);
}

#[test]
fn replays_keep_their_laws() {
    bless("replay_decode");
    keeps("replay_decode", laws::replay, [40, 10]);
}

#[test]
fn scenes_keep_their_laws() {
    keeps("scene_parse", laws::scene, [45, 20]);
}

#[test]
fn meshes_keep_their_laws() {
    keeps("obj_parse", laws::obj, [75, 18]);
}

#[test]
fn hierarchies_keep_their_laws() {
    keeps("bvh", laws::bvh, [32, 25]);
}

#[test]
fn relaxations_keep_their_laws() {
    keeps("relax", laws::relax, [60, 25]);
}

#[test]
fn commands_keep_their_laws() {
    keeps("commands", laws::commands, [55, 40]);
}

#[test]
fn pairs_of_triangles_keep_their_laws() {
    keeps("triangle_triangle", laws::triangle_triangle, [20, 10]);
}

#[test]
fn times_of_impact_keep_their_laws() {
    keeps("toi", laws::toi, [20, 10]);
}

#[test]
fn manifolds_keep_their_laws() {
    keeps("manifold", laws::manifold, [10, 5]);
}

#[test]
fn broad_phases_keep_their_laws() {
    keeps("broad_phase", laws::broad_phase, [15, 10]);
}

#[test]
fn hulls_keep_their_laws() {
    keeps("hull", laws::hull, [12, 10]);
}
