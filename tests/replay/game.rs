//! A game around a world is recorded like a world.

use serde::{Deserialize, Serialize};

use verlock::Hash;
use verlock::Vec3;
use verlock::math::Real;
use verlock::replay::{DivergenceKind, Recorder, Replay, Simulation, VerifyError, seek, verify};
use verlock::snapshot::{DecodeError, DecodeReason};
use verlock::world::{Action, Command, World};

use crate::support::container::Parts;
use crate::support::worlds::{particle, small};

/// One player's stick and button.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
struct Stick {
    player: u8,
    sideways: i8,
    fire: bool,
}

/// Its own state is a score, which the world knows nothing of.
struct Game {
    score: u64,
    world: World,
}

impl Simulation for Game {
    type Input = Stick;
    const NAME: [u8; 16] = *b"verlock.testgame";
    const VERSION: u32 = 3;

    fn tick(&self) -> u64 {
        self.world.tick()
    }

    fn step(&mut self, inputs: &[Stick]) {
        assert!(inputs.is_sorted());
        let command = |(sequence, stick): (u32, &Stick)| {
            let impulse = Vec3::new(i32::from(stick.sideways).into(), Real::ZERO, Real::ZERO);
            let action = Action::Impulse { particle: particle(4), impulse };
            Command { player: stick.player.into(), sequence, action }
        };
        let commands: Vec<_> = (0..).zip(inputs).map(command).collect();
        self.world.step(&commands);
        self.score += inputs.iter().filter(|stick| stick.fire).count() as u64;
    }

    fn hash(&self) -> Hash {
        let parts = [&self.score.to_le_bytes()[..], &self.world.hash().to_bytes()];
        Hash::of(&parts.concat())
    }

    fn save_into(&self, out: &mut Vec<u8>) {
        out.extend(self.score.to_le_bytes());
        self.world.save_into(out);
    }

    fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        let truncated = DecodeError { offset: bytes.len() as u64, reason: DecodeReason::Truncated };
        let (score, world) = bytes.split_first_chunk().ok_or(truncated)?;
        let world = World::load(world).map_err(|e| DecodeError { offset: e.offset + 8, ..e })?;
        Ok(Self { score: u64::from_le_bytes(*score), world })
    }
}

pub(super) fn record() -> Recorder<impl Simulation> {
    let mut recorder = Recorder::new(Game { score: 0, world: small() }, 4);
    for tick in 0..10 {
        let stick = |player: u8| Stick { player, sideways: 3 - tick, fire: tick % 2 == 0 };
        recorder.step(&[stick(2), stick(1)]);
    }
    recorder
}

/// A game is recorded, verified and gone through like a world.
#[test]
fn a_game_is_recorded() {
    let bytes = record().replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    let mut scores = vec![];
    verify::<Game>(&replay, |game| scores.push(game.score)).expect("the same on every tick");
    assert_eq!(scores, [2, 2, 4, 4, 6, 6, 8, 8, 10, 10]);
    assert_eq!(replay.input_count(), 20);
    let game: Game = seek(&replay, 11).expect("a recorded tick");
    assert_eq!((game.tick(), game.score), (11, 10));
}

/// An input that only the game understands is verified like any other.
#[test]
fn a_changed_score_diverges() {
    let mut parts = Parts::of(&record().replay());
    let start = parts.section(2);
    start[0] ^= 1;
    let bytes = parts.file();
    let replay = Replay::parse(&bytes).expect("sound hashes");
    let error = verify::<Game>(&replay, |_| ()).expect_err("another score");
    let VerifyError::Diverged(divergence) = error else { unreachable!("{error}") };
    assert_eq!((divergence.tick, divergence.kind), (2, DivergenceKind::State));
}

/// A recording of another game, or of other rules of the same, proves nothing.
#[test]
fn another_game_is_refused() {
    let bytes = record().replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    let other = |replay: &Replay<'_>| {
        let reason = DecodeReason::Simulation { name: replay.name(), version: replay.version() };
        let (_, info) = replay.sections().next().expect("the first section");
        DecodeError { offset: info.offset, reason }
    };
    assert_eq!(verify::<World>(&replay, |_| ()), Err(VerifyError::Decode(other(&replay))));
    for at in [0, 15, 16] {
        let mut parts = Parts::of(&bytes);
        parts.section(1)[at] ^= 1;
        let bytes = parts.file();
        let replay = Replay::parse(&bytes).expect("sound hashes");
        let other = other(&replay);
        assert_eq!(verify::<Game>(&replay, |_| ()), Err(VerifyError::Decode(other)));
        assert_eq!(seek::<Game>(&replay, 4).err(), Some(other));
    }
}
