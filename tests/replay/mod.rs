//! Floor 10: recordings.

mod bisect;
mod damage;
mod faults;
mod game;
mod hash_log;
mod heavy;
mod seek;

use verlock::particle::ParticleSpec;
use verlock::replay::{Recorder, Replay, Simulation, VerifyError, verify};
use verlock::world::{Action, Command, World};
use verlock::{Vec3, real};

use crate::support::worlds::{actions, command, particle, small};

/// The commands of a tick of the recording that is tested here: none, one or three.
fn commands(tick: u64) -> Vec<Command> {
    let all = actions();
    let index = usize::try_from(tick).expect("a small number");
    match tick % 3 {
        0 => vec![],
        1 => vec![command(0, all[index % all.len()])],
        _ => {
            let impulse = Vec3::new(real!("0.5"), real!("1"), real!("-0.5"));
            let token = tick << 32;
            vec![
                command(0, Action::Impulse { particle: particle(4), impulse }),
                command(1, Action::SpawnParticle { token, spec: ParticleSpec::at(Vec3::Y) }),
                Command { player: 9, sequence: 0, action: all[index % all.len()] },
            ]
        }
    }
}

/// Records some ticks of [`small`].
fn record(ticks: u64, interval: u32) -> Recorder<World> {
    let mut recorder = Recorder::new(small(), interval);
    for _ in 0..ticks {
        let tick = recorder.simulation().tick();
        recorder.step(&commands(tick));
    }
    recorder
}

/// A recording verifies, tick by tick, and tells what was recorded.
#[test]
fn a_recording_verifies() {
    let bytes = record(20, 6).replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    assert_eq!((replay.name(), replay.version()), (World::NAME, World::VERSION));
    assert_eq!((replay.first_tick(), replay.len()), (2, 20));
    assert_eq!(replay.start_bytes(), small().save());
    assert_eq!(replay.keyframe_ticks().collect::<Vec<_>>(), [8, 14, 20]);
    let inputs: usize = (2..22).map(|tick| commands(tick).len()).sum();
    assert_eq!(replay.input_count(), inputs as u64);
    let mut world = small();
    let mut ticks = vec![];
    verify::<World>(&replay, |stepped| {
        let tick = world.tick();
        ticks.push(tick);
        world.step(&commands(tick));
        assert_eq!(stepped.save(), world.save(), "tick {tick}");
        assert_eq!(stepped.events(), world.events(), "tick {tick}");
        assert_eq!(replay.hash_after(tick), Some(world.hash()), "tick {tick}");
    })
    .expect("the same on every tick");
    assert!(ticks.into_iter().eq(2..22));
    assert_eq!((replay.hash_after(1), replay.hash_after(22)), (None, None));
}

/// The order in which commands arrive is not recorded.
#[test]
fn the_order_of_commands_is_not_recorded() {
    let recorded = record(20, 6).replay();
    let mut recorder = Recorder::new(small(), 6);
    for tick in 2..22 {
        let mut commands = commands(tick);
        commands.reverse();
        recorder.step(&commands);
    }
    assert!(recorder.replay() == recorded);
}

/// A recording can be looked at while it goes on: it is the recording of fewer ticks.
#[test]
fn a_recording_can_go_on() {
    let mut recorder = record(8, 3);
    assert!(recorder.replay() == record(8, 3).replay());
    recorder.step(&commands(10));
    assert!(recorder.replay() == record(9, 3).replay());
    let world = recorder.into_simulation();
    assert_eq!(world.tick(), 11);
}

/// A state can be kept at any recorded tick, now or later; it is not kept twice.
#[test]
fn keyframes_are_kept_on_request() {
    let mut recorder = record(4, 3);
    let early = recorder.simulation().clone();
    recorder.step(&commands(6));
    recorder.step(&commands(7));
    recorder.keyframe();
    recorder.keyframe(); // the one of the interval, once more
    assert!(recorder.keyframe_of(&early) && recorder.keyframe_of(&small()));
    let mut late = recorder.simulation().clone();
    late.step(&[]);
    assert!(!recorder.keyframe_of(&late), "not recorded yet");
    let bytes = recorder.replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    assert_eq!(replay.keyframe_ticks().collect::<Vec<_>>(), [5, 6, 8]);
    assert_eq!(replay.stored_ticks().collect::<Vec<_>>(), [2, 5, 6, 8]);
    assert_eq!(replay.stored_bytes(2), Some(&small().save()[..]));
    assert_eq!(replay.stored_bytes(6), Some(&early.save()[..]));
    assert_eq!((replay.stored_bytes(1), replay.stored_bytes(7)), (None, None));
    assert_eq!(verify::<World>(&replay, |_| ()), Ok(()));
    assert!(!Recorder::new(early, 0).keyframe_of(&late));
}

/// Nothing recorded is nothing proven.
#[test]
fn an_empty_recording_does_not_verify() {
    let bytes = record(0, 3).replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    assert!(replay.is_empty());
    let ticks = verify::<World>(&replay, |_| unreachable!("there is no tick"));
    assert_eq!(ticks, Err(VerifyError::Empty));
}
