//! Machines that flip a bit: the tick and the field are found from two recordings.

use verlock::Hash;
use verlock::math::Pcg;
use verlock::replay::{Cause, Recorder, Replay, Simulation, bisect_replays, seek};
use verlock::snapshot::{DecodeError, Difference, Section, Snapshot, Values, diff};
use verlock::world::{Command, World};

use crate::support::container::Parts;
use crate::support::fixture::{EMULATED, Fixture};
use crate::support::spot::Spot;

const FAULTS: u32 = if EMULATED { 10 } else { 200 };

/// Ticks of which a scene is stepped, and of scenes whose snapshots are longer than `LARGE`.
const TICKS: [u64; 2] = [150, 5];
const LARGE: usize = 100 << 10;

/// Ticks that are recorded after the fault.
const AFTER: u64 = 3;

/// What a fault may hit: a section, and in it the fields whose names begin like this.
const TARGETS: [(Section, &[&str]); 6] = [
    (Section::Position, &[""]),
    (Section::Displacement, &[""]),
    (Section::Particle, &["mass"]),
    (Section::Distance, &["rest_length"]),
    (Section::World, &["random."]),
    (Section::World, &["tick_rate", "substeps", "iterations", "gravity.", "damping", "displ"]),
];

/// A machine on which a world becomes another one at a tick.
struct Machine {
    world: World,
    fault: Option<(u64, World)>,
}

impl Simulation for Machine {
    type Input = Command;
    const NAME: [u8; 16] = World::NAME;
    const VERSION: u32 = World::VERSION;

    fn tick(&self) -> u64 {
        self.world.tick()
    }

    fn step(&mut self, inputs: &[Command]) {
        self.world.step(inputs);
        if let Some((_, faulty)) = self.fault.take_if(|(tick, _)| *tick == self.world.tick()) {
            self.world = faulty;
        }
    }

    fn hash(&self) -> Hash {
        self.world.hash()
    }

    fn save_into(&self, out: &mut Vec<u8>) {
        self.world.save_into(out);
    }

    fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        World::load(bytes).map(|world| Self { world, fault: None })
    }
}

/// A scene and its worlds at its first ticks.
struct Run {
    fixture: Fixture,
    worlds: Vec<World>,
}

impl Run {
    fn of(fixture: Fixture) -> Self {
        let mut world = fixture.scene.build().expect("a good scene");
        let ticks = TICKS[usize::from(world.save().len() > LARGE)].min(fixture.scene.ticks());
        let mut worlds = vec![world.clone()];
        for _ in 0..ticks {
            world.step(&fixture.scene.commands(&world));
            worlds.push(world.clone());
        }
        Self { fixture, worlds }
    }
}

/// A bit of a field of a world.
struct Fault {
    tick: u64,
    /// Which of the targets it is.
    target: usize,
    spot: Spot,
    /// The field with and without it.
    bits: [u64; 2],
    /// The world with it.
    bytes: Vec<u8>,
}

impl Fault {
    /// A random one; `None` if the world has nothing of the kind that was drawn.
    fn draw(random: &mut Pcg, run: &Run) -> Option<Self> {
        let mut below = |n: usize| random.below(u32::try_from(n).expect("few")) as usize;
        let tick = 1 + below(run.worlds.len() - 1);
        let parts = Parts::of(&run.worlds[tick].save());
        let target = below(TARGETS.len());
        let (section, names) = TARGETS[target];
        let named = |spot: &Spot| names.iter().any(|name| spot.field.name.starts_with(name));
        let mut spots = Spot::of(&parts, section);
        spots.retain(|spot| named(spot) && spot.is_alive(&parts));
        if spots.is_empty() {
            return None;
        }
        let spot = spots.swap_remove(below(spots.len()));
        let good = spot.read(&parts);
        let bad = good ^ 1 << below(8 * spot.field.kind.width() as usize);
        let bytes = spot.with(&parts, bad).file();
        Some(Self { tick: tick as u64, target, spot, bits: [good, bad], bytes })
    }

    /// Records the scene on a sound and on a faulty machine. Both keep the state of the tick in
    /// which they notice that their hashes differ, as games do that exchange them.
    fn record(&self, run: &Run, begin: u64, faulty: World) -> [Vec<u8>; 2] {
        let start = &run.worlds[usize::try_from(begin).expect("a tick")];
        let machine = Machine { world: start.clone(), fault: Some((self.tick, faulty)) };
        let mut sound = Recorder::new(start.clone(), 2);
        let mut faulty = Recorder::new(machine, 2);
        let mut noticed = false;
        for _ in begin..self.tick + AFTER {
            let commands = run.fixture.scene.commands(sound.simulation());
            if sound.step(&commands) != faulty.step(&commands) && !noticed {
                sound.keyframe();
                faulty.keyframe();
                noticed = true;
            }
        }
        [sound.replay(), faulty.replay()]
    }

    /// The two recordings name the tick and, in the state of that tick, this field and its bits.
    fn is_named(&self, name: &str, begin: u64, recordings: &[Vec<u8>; 2]) {
        let Self { tick, spot, bits, .. } = self;
        let [a, b] = recordings.each_ref().map(|bytes| Replay::parse(bytes).expect("a replay"));
        let found = bisect_replays(&a, &b);
        let at = format!("{name}, tick {tick}: {spot}");
        assert_eq!((found.inputs, found.stored), (None, None), "{at}");
        assert_eq!(found.compared, tick + AFTER - begin + 1, "{at}");
        let parting = found.state.expect("a difference");
        let expected = (*tick, Some(tick - 1), Cause::Step);
        assert_eq!((parting.tick, parting.before, parting.cause), expected, "{at}");

        let states = [&a, &b].map(|replay| replay.stored_bytes(*tick).expect("a keyframe"));
        let states = states.map(|bytes| Snapshot::parse(bytes).expect("a sound snapshot"));
        assert_eq!(states.each_ref().map(Snapshot::hash), parting.hashes, "{at}");
        let differences: Vec<_> = diff(&states[0], &states[1]).collect();
        let [Difference { section, values: Values::Field { index, field, a: good, b: bad } }] =
            differences[..]
        else {
            unreachable!("{at}: {differences:?}");
        };
        let expected = (spot.section, spot.index as u64, spot.field.name);
        assert_eq!((section, index, field), expected, "{at}");
        assert_eq!([good.raw, bad.raw], *bits, "{at}");

        // From the keyframe on, what the faulty machine had can be had here.
        let last = tick + AFTER;
        let world: World = seek(&b, last).expect("a recorded tick");
        assert_eq!(Some(world.hash()), b.hash_after(last - 1), "{at}");
    }
}

/// One flipped bit in a position, displacement, mass, rest length, in the random generator or the
/// configuration of any scene at any tick: tick, section, object, field and both raw values are
/// named. Faults that leave a range are drawn again: loading refuses them.
#[test]
fn every_flipped_bit_is_named() {
    let runs: Vec<Run> = Fixture::all().into_iter().map(Run::of).collect();
    let mut random = Pcg::new(200, 1);
    let (mut named, mut refused, mut hit) = (0, 0, [0; TARGETS.len()]);
    while named < FAULTS {
        let run = &runs[random.below(u32::try_from(runs.len()).expect("few")) as usize];
        let Some(fault) = Fault::draw(&mut random, run) else { continue };
        let begin = fault.tick.saturating_sub(1 + u64::from(random.below(3)));
        let Ok(faulty) = World::load(&fault.bytes) else {
            refused += 1;
            continue;
        };
        let recordings = fault.record(run, begin, faulty);
        fault.is_named(&run.fixture.name, begin, &recordings);
        named += 1;
        hit[fault.target] += 1;
    }
    println!("{named} faults named, {refused} refused; by target {hit:?}");
    assert!(EMULATED || hit.iter().all(|&count| count >= 10), "{hit:?}");
}
