//! What stepping a replay again proves.

use std::ops::Add;

use verlock::World;
use verlock::replay::{Divergence, DivergenceKind, Replay, VerifyError, seek, verify};
use verlock::snapshot::{Difference, Snapshot, diff};

use crate::count::counted;

/// No more differences are told of one replay.
const DIFFERENCES_MAX: usize = 20;

/// What stepping a replay again proves.
#[derive(Debug)]
pub(crate) enum Verdict {
    /// Every tick came out the same.
    Verified(Compared),
    /// A tick came out differently.
    Diverged(Divergence, Compared, Vec<Difference>),
    /// Nothing, and why.
    Unproven(VerifyError),
}

/// How much came out the same.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Compared {
    pub(crate) ticks: u64,
    /// In the last state that was compared.
    pub(crate) particles: u64,
    /// Distance constraints in the last state that was compared.
    pub(crate) constraints: u64,
    /// The particles of all states.
    pub(crate) particle_states: u64,
    /// The distance constraints of all states.
    pub(crate) constraint_states: u64,
}

impl Verdict {
    /// Steps a replay again; `on_tick` is called after every tick that came out the same.
    pub(crate) fn of(bytes: &[u8], mut on_tick: impl FnMut(&Replay<'_>)) -> Self {
        let replay = match Replay::parse(bytes) {
            Ok(replay) => replay,
            Err(error) => return Self::Unproven(error.into()),
        };
        let mut compared = Compared::default();
        let verified = verify(&replay, |world| {
            compared.note(world);
            on_tick(&replay);
        });
        match verified {
            Ok(()) => Self::Verified(compared),
            Err(VerifyError::Diverged(divergence)) => {
                let differences = differences(&replay, &divergence).unwrap_or_default();
                Self::Diverged(divergence, compared, differences)
            }
            Err(error) => Self::Unproven(error),
        }
    }

    pub(crate) fn compared(&self) -> Compared {
        match self {
            Self::Verified(compared) | Self::Diverged(_, compared, _) => *compared,
            Self::Unproven(_) => Compared::default(),
        }
    }
}

impl Compared {
    fn note(&mut self, world: &World) {
        self.ticks += 1;
        self.particles = world.particles().len() as u64;
        self.constraints = world.distances().count() as u64;
        self.particle_states += self.particles;
        self.constraint_states += self.constraints;
    }
}

impl Compared {
    /// The sums, for people.
    pub(crate) fn line(&self) -> String {
        let ticks = counted(self.ticks, "tick");
        let particles = counted(self.particle_states, "particle state");
        let constraints = counted(self.constraint_states, "constraint state");
        format!("{ticks}, {particles}, {constraints}")
    }
}

impl Add for Compared {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            ticks: self.ticks + other.ticks,
            particles: self.particles + other.particles,
            constraints: self.constraints + other.constraints,
            particle_states: self.particle_states + other.particle_states,
            constraint_states: self.constraint_states + other.constraint_states,
        }
    }
}

/// What differs between the keyframe after the tick, if there is one, and what was found.
fn differences(replay: &Replay<'_>, divergence: &Divergence) -> Option<Vec<Difference>> {
    let after = divergence.tick.checked_add(1)?;
    let stepped = divergence.kind != DivergenceKind::Inputs;
    if !stepped || !replay.keyframe_ticks().any(|keyframe| keyframe == after) {
        return None;
    }
    // Seeking starts at the keyframe itself.
    let recorded: World = seek(replay, after).ok()?;
    let mut found: World = seek(replay, divergence.tick).ok()?;
    found.step(&replay.inputs_at::<World>(divergence.tick).ok()?);
    let (recorded, found) = (recorded.save(), found.save());
    let (recorded, found) = (Snapshot::parse(&recorded).ok()?, Snapshot::parse(&found).ok()?);
    Some(diff(&recorded, &found).take(DIFFERENCES_MAX).collect())
}
