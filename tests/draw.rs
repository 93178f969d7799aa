//! What a renderer is told.

use std::fmt;

use verlock::constraint::Distance;
use verlock::math::{Factor, UnitVec3};
use verlock::particle::ParticleSpec;
use verlock::world::{
    Action, Detail, DrawOptions, DrawSink, ObjectId, Shade, World, WorldBuilder, WorldConfig,
};
use verlock::{Real, Vec3, real};

use crate::support::worlds::{command, distance, face, half_space, particle, small};

/// What came, in the order in which it came.
#[derive(Default, Debug, PartialEq)]
struct Told(Vec<Item>);

#[derive(Debug, PartialEq)]
enum Item {
    Plane(Vec3, UnitVec3, Shade),
    Triangle([Vec3; 3], Shade),
    Line([Vec3; 2], Shade),
    Point(Vec3, Shade),
    Label(Vec3, String),
}

impl DrawSink for Told {
    fn plane(&mut self, point: Vec3, normal: UnitVec3, shade: Shade) {
        self.0.push(Item::Plane(point, normal, shade));
    }

    fn triangle(&mut self, corners: [Vec3; 3], shade: Shade) {
        self.0.push(Item::Triangle(corners, shade));
    }

    fn line(&mut self, ends: [Vec3; 2], shade: Shade) {
        self.0.push(Item::Line(ends, shade));
    }

    fn point(&mut self, at: Vec3, shade: Shade) {
        self.0.push(Item::Point(at, shade));
    }

    fn label(&mut self, at: Vec3, text: fmt::Arguments<'_>) {
        self.0.push(Item::Label(at, text.to_string()));
    }
}

/// A sink that takes nothing.
struct Nothing;

impl DrawSink for Nothing {}

fn told(world: &World, options: DrawOptions) -> Vec<Item> {
    let mut told = Told::default();
    world.draw(&mut told, options);
    told.0
}

/// Half-spaces, faces, distances, particles and labels come in this order, each in order of the
/// slots; free slots are passed over, and what is disabled is told to be.
#[test]
fn objects_come_in_order() {
    let mut world = small();
    let disable = |object| command(0, Action::SetEnabled { object, enabled: false });
    world.step(&[
        disable(ObjectId::Particle(particle(4))),
        disable(ObjectId::Distance(distance(2))),
    ]);
    let slope = world.half_space(half_space(1)).expect("the slope");
    let at = |slot| world.position(particle(slot)).expect("a particle");
    let strain = |a: u32, b: u32| {
        let excess = at(a).distance(at(b)).raw() - Real::ONE.raw();
        Shade::Distance { strain: Factor::from_ratio(excess, Real::ONE.raw()).expect("small") }
    };
    let mut expected = vec![
        Item::Plane(slope.point, slope.normal, Shade::HalfSpace),
        Item::Triangle([at(1), at(2), at(5)], Shade::Face),
        Item::Line([at(0), at(1)], strain(0, 1)),
        Item::Line([at(1), at(2)], Shade::Disabled),
        Item::Point(at(0), Shade::Pinned),
        Item::Point(at(1), Shade::Particle),
        Item::Point(at(2), Shade::Particle),
        Item::Point(at(4), Shade::Disabled),
        Item::Point(at(5), Shade::Particle),
    ];
    let slots = [0, 1, 2, 4, 5];
    expected.extend(slots.map(|slot| Item::Label(at(slot), slot.to_string())));
    let all = DrawOptions { distances: Detail::All, particles: Detail::All, labels: true };
    assert_eq!(told(&world, all), expected);
    let none = DrawOptions { distances: Detail::None, particles: Detail::None, labels: false };
    assert_eq!(told(&world, none), expected[..2]);
}

/// By default what a face covers is left out, but for pinned corners, and broken links too; a
/// disabled face covers nothing, and is not told.
#[test]
fn faces_cover_their_corners() {
    let mut world = small();
    let count = |world: &World| {
        let items = told(world, DrawOptions::default());
        let lines = items.iter().filter(|item| matches!(item, Item::Line(..))).count();
        let points = items.iter().filter_map(|item| match item {
            Item::Point(_, shade) => Some(*shade),
            _ => None,
        });
        (lines, points.collect::<Vec<_>>())
    };
    let enable = |object, enabled| command(0, Action::SetEnabled { object, enabled });
    // The corners are particles 1, 2 and 5; 0 is pinned, and 4 is free. Both links end at 1.
    let [pinned, free] = [Shade::Pinned, Shade::Particle];
    assert_eq!(count(&world), (0, vec![pinned, free]));
    let pin = Action::SetPinned { particle: particle(1), pinned: true };
    world.step(&[command(0, pin)]);
    assert_eq!(count(&world), (0, vec![pinned, pinned, free]));
    world.step(&[enable(ObjectId::Face(face(1)), false)]);
    assert_eq!(count(&world), (2, vec![pinned, pinned, free, free, free]));
    world.step(&[enable(ObjectId::Distance(distance(2)), false)]);
    assert_eq!(count(&world).0, 1);
    let items = told(&world, DrawOptions::default());
    assert!(!items.iter().any(|item| matches!(item, Item::Triangle(..))));
}

/// Drawing changes nothing, whoever draws.
#[test]
fn drawing_changes_nothing() {
    let world = small();
    let hash = world.hash();
    let sink: &mut dyn DrawSink = &mut Nothing;
    world.draw(sink, DrawOptions::default());
    assert_eq!(world.hash(), hash);
}

/// Strain is the change of length as a share of the rest length, but for slack; what is too much
/// stops at the end of the type.
#[test]
fn strain_is_relative() {
    let cases = [
        ("1", "2", "0", "-0.5"),
        ("2", "2", "0", "0"),
        ("3", "2", "0", "0.5"),
        ("0", "2", "0", "-1"),
        ("1", "2", "0.75", "-0.125"),
        ("1", "2", "1.5", "0"),
        ("3", "2", "1.5", "0.5"),
        ("60000000000", "0.0000001", "0", "32767.9999847412109375"),
    ];
    for (length, rest_length, slack, expected) in cases {
        let length = Real::parse(length).expect("a decimal");
        let mut builder = WorldBuilder::new(WorldConfig::default()).expect("a configuration");
        let ends = [Vec3::ZERO, Vec3::new(length, Real::ZERO, Real::ZERO)];
        let [a, b] = ends.map(|end| builder.particle(&ParticleSpec::at(end)).expect("an end"));
        let rest_length = Real::parse(rest_length).expect("a decimal");
        let slack = Real::parse(slack).expect("a decimal");
        let distance = Distance { slack, ..Distance::new(a, b, rest_length) };
        builder.distance(&distance).expect("a distance");
        let strain = Factor::parse(expected).expect("a decimal");
        let items = told(&builder.build(), DrawOptions::default());
        assert_eq!(items[0], Item::Line(ends, Shade::Distance { strain }));
    }
    assert_eq!(real!("0.0000001").raw(), 2, "a short rest length");
}
