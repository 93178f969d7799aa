//! Stepping a replay again.

use super::recorder::input_hash;
use super::{Divergence, DivergenceKind, Replay, Simulation, VerifyError};
use crate::particle::RangeError;
use crate::snapshot::{DecodeError, DecodeReason, Hash};

/// Steps a replay from its start and compares inputs, state and keyframes of every tick.
/// `on_tick` is called after every tick that came out the same.
///
/// # Errors
/// The first divergence, or why nothing could be proven.
pub fn verify<S: Simulation>(
    replay: &Replay<'_>,
    mut on_tick: impl FnMut(&S),
) -> Result<(), VerifyError> {
    if replay.is_empty() {
        return Err(VerifyError::Empty);
    }
    let mut simulation: S = replay.start()?;
    let mut from = 0;
    for index in 0..replay.len() {
        let record = replay.tick(index);
        let tick = replay.first_tick() + index;
        let same = |kind, recorded: u128, found: u128| {
            let (recorded, found) = (Hash(recorded), Hash(found));
            let divergence = Divergence { tick, kind, recorded, found };
            if recorded == found { Ok(()) } else { Err(VerifyError::Diverged(divergence)) }
        };
        let bytes = replay.input_bytes(index, from);
        let found = u128::from(input_hash(bytes));
        same(DivergenceKind::Inputs, u128::from(record.input_hash), found)?;
        simulation.step(&replay.inputs::<S>(index, from)?);
        from += bytes.len();
        let found = simulation.hash().0;
        same(DivergenceKind::State, record.state_hash, found)?;
        if let Some(keyframe) = replay.keyframe_at::<S>(tick + 1)? {
            #[cfg(not(planted))]
            same(DivergenceKind::Keyframe, keyframe.hash().0, found)?;
        }
        on_tick(&simulation);
    }
    Ok(())
}

/// The simulation just before a tick is stepped: from the last keyframe before it, then by
/// stepping: O(ticks before it) to find its inputs, and the steps from the keyframe. Only
/// [`verify`] compares keyframes with the recorded hashes.
///
/// # Errors
/// The tick is outside the recording (`OutOfRange`), or the file cannot be replayed.
pub fn seek<S: Simulation>(replay: &Replay<'_>, tick: u64) -> Result<S, DecodeError> {
    let last = replay.first_tick() + replay.len();
    if !(replay.first_tick()..=last).contains(&tick) {
        let error = RangeError::new("tick");
        return Err(DecodeError::new(0, DecodeReason::OutOfRange(error)));
    }
    let mut simulation = match replay.keyframe_before::<S>(tick)? {
        Some(keyframe) => keyframe,
        None => replay.start()?,
    };
    let done = simulation.tick() - replay.first_tick();
    let mut from = (0..done).map(|index| replay.tick(index).length as usize).sum();
    for index in done..tick - replay.first_tick() {
        simulation.step(&replay.inputs::<S>(index, from)?);
        from += replay.input_bytes(index, from).len();
    }
    Ok(simulation)
}
