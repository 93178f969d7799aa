//! Bodies of meshes: how far cloth stretches, what wind and time do to it, whether plants stand.

use verlock::body::{Assembly, Cloth, Plant, Rope};
use verlock::constraint::Distance;
use verlock::geometry::{Grid, TriangleMesh};
use verlock::math::{Factor, Unit};
use verlock::particle::ParticleId;
use verlock::scene::Obj;
use verlock::world::Action;
use verlock::{Real, Vec3, World, WorldBuilder, WorldConfig, real};

use crate::support::alloc::peak;
use crate::support::blueprint::act;
use crate::support::fixture::{Fixture, read};

/// 100 x 100 particles 0.02 m apart, hanging from its first row.
fn square(cloth: Cloth) -> Assembly {
    let edge = real!("1.98");
    let edge_u = Vec3::new(edge, Real::ZERO, Real::ZERO);
    let edge_v = Vec3::new(Real::ZERO, -edge, Real::ZERO);
    let grid = Grid { corner: Vec3::ZERO, edge_u, edge_v, columns: 100, rows: 100 };
    let mesh = TriangleMesh::grid(&grid).expect("a mesh");
    cloth.of(&mesh, |vertex| vertex < 100).expect("a cloth")
}

fn world(assembly: &Assembly, config: WorldConfig) -> World {
    let mut builder = WorldBuilder::new(config).expect("the configuration is valid");
    builder.assemble(assembly).expect("there is room");
    builder.build()
}

/// The greatest strain of what is rigid and no rope.
fn worst_edge(world: &World) -> f64 {
    let edges = world.distances().filter(|(_, edge)| {
        edge.slack == Real::ZERO && edge.stiffness == Distance::default().stiffness
    });
    let strains = edges.map(|(_, edge)| {
        let [a, b] = [edge.a, edge.b].map(|end| world.position(end).expect("alive"));
        a.distance(b).to_f64() / edge.rest_length.to_f64() - 1.0
    });
    strains.fold(0.0, f64::max)
}

fn run(world: &mut World, ticks: u32) {
    for tick in 0..ticks {
        assert_eq!(world.step(&[]), [], "tick {tick}");
    }
}

/// With the defaults, at 4 x 1; without attachments the figure in the documentation.
#[test]
fn a_hanging_cloth_keeps_its_length() {
    let ticks = if cfg!(debug_assertions) { 100 } else { 600 };
    let mut hanging = world(&square(Cloth::default()), WorldConfig::default());
    run(&mut hanging, ticks);
    let held = worst_edge(&hanging);
    let loose = Cloth { attachments: false, ..Cloth::default() };
    let mut hanging = world(&square(loose), WorldConfig::default());
    run(&mut hanging, ticks);
    let loose = worst_edge(&hanging);
    println!("worst edge {held:.4}, without attachments {loose:.4}");
    assert!(held < 0.05, "{held}");
    assert!(loose > 0.5, "{loose}");
}

/// A curtain in the wind for half an hour: nothing happens but cloth, it stays where it hangs, and
/// takes no more memory from tick to tick.
#[test]
fn wind_blows_for_hours() {
    let ticks = if cfg!(debug_assertions) { 2_000 } else { 100_000 };
    let curtain = Obj::parse(&text("meshes/curtain.obj")).expect("a mesh").into_mesh();
    let drag = Factor::from_raw(1 << 16);
    let cloth = Cloth { drag, mass: real!("0.005"), ..Cloth::default() };
    let top = |vertex: u32| curtain.vertices()[vertex as usize].y == real!("2");
    let cloth = cloth.of(&curtain, top).expect("a cloth");
    let wind = Vec3::new(real!("1"), Real::ZERO, real!("4"));
    let mut world = world(&cloth, WorldConfig { wind, ..WorldConfig::default() });
    run(&mut world, 100);
    let ((), used) = peak(|| run(&mut world, ticks));
    assert!(used < 4096, "{used} bytes more");
    assert!(worst_edge(&world) < 0.25, "{}", worst_edge(&world));
    let far = |c: Real| c.to_f64().abs() > 3.0;
    let stray = world.particles().ids().filter_map(|id| world.position(id));
    assert_eq!(stray.filter(|at| far(at.x) || far(at.y) || far(at.z)).count(), 0);
}

/// A plant bends in a gust and stands again where it stood.
#[test]
fn a_plant_springs_back() {
    let mesh = Obj::parse(&text("meshes/plant.obj")).expect("a mesh").into_mesh();
    let rooted = |vertex: u32| mesh.vertices()[vertex as usize].y == Real::ZERO;
    let plant = Plant::default().of(&mesh, rooted).expect("a plant");
    let config = WorldConfig { damping: real!("2"), ..WorldConfig::default() };
    let mut world = world(&plant, config);
    run(&mut world, 400);
    let tip = tip(&world);
    let place = |world: &World| world.position(tip).expect("alive");
    let rest = place(&world);
    let gust = Action::SetWind { wind: Vec3::new(real!("25"), Real::ZERO, Real::ZERO) };
    act(&mut world, &[gust]);
    run(&mut world, 60);
    let bent = place(&world).distance(rest).to_f64();
    act(&mut world, &[Action::SetWind { wind: Vec3::ZERO }]);
    run(&mut world, 600);
    let back = place(&world).distance(rest).to_f64();
    assert!(bent > 0.003 && back < bent / 20.0, "bent by {bent}, back within {back}");
}

/// The highest particle.
fn tip(world: &World) -> ParticleId {
    let height = |id: &ParticleId| world.position(*id).map(|at| at.y);
    world.particles().ids().max_by_key(height).expect("a plant")
}

/// What hangs between two pins keeps its length; without attachments it stretches further.
#[test]
fn a_rope_hangs() {
    let tenth = real!("0.1");
    let at = |k: i64| Vec3::new(Real::from_raw(k * tenth.raw()), Real::ZERO, Real::ZERO);
    let points: Vec<_> = (0..60).map(at).collect();
    let sag = |attachments| {
        let rope = Rope { attachments, ..Rope::default() };
        let rope = rope.along(&points, |place| place == 0).expect("a rope");
        let mut world = world(&rope, WorldConfig::default());
        run(&mut world, 600);
        worst_edge(&world)
    };
    let (held, loose) = (sag(true), sag(false));
    assert!(held < 0.06 && 3.0 * held < loose, "{held}, {loose} without attachments");
}

/// A rod through a wall (the essay's third figure): every tick of one relaxation shrinks the error,
/// and the rest is finished in the next ones.
#[test]
fn a_rod_leaves_the_wall_in_a_few_ticks() {
    let scene = Fixture::read("rod").scene;
    let mut world = scene.build().expect("a world");
    let error = |world: &World| {
        let (_, rod) = world.distances().next().expect("the rod");
        let [a, b] = [rod.a, rod.b].map(|end| world.position(end).expect("alive"));
        let behind = (-a.x.to_f64()).max(-b.x.to_f64()).max(0.0);
        behind + (a.distance(b).to_f64() / rod.rest_length.to_f64() - 1.0).abs()
    };
    let mut errors = vec![error(&world)];
    for _ in 0..4 {
        world.step(&[]);
        errors.push(error(&world));
    }
    assert!(errors[0] > 0.5, "{errors:?}");
    assert!(errors[1] < errors[0] / 2.0 && errors[4] < errors[0] / 50.0, "{errors:?}");
}

fn text(name: &str) -> String {
    String::from_utf8(read(name)).expect("a text")
}

/// Bodies refuse by themselves what no world would take.
#[test]
fn numbers_out_of_range_are_refused() {
    let grid = Grid { corner: Vec3::ZERO, edge_u: Vec3::X, edge_v: Vec3::Y, columns: 2, rows: 2 };
    let mesh = TriangleMesh::grid(&grid).expect("a mesh");
    let (none, too_stiff) = (Real::ZERO, Unit::from_raw(3 << 29));
    let cloth = |cloth: Cloth| cloth.of(&mesh, |_| true).expect_err("a wrong number").to_string();
    let rope = |rope: Rope, points| rope.along(points, |_| true).expect_err("likewise").to_string();
    let usual = Cloth::default();
    assert_eq!(cloth(Cloth { mass: none, ..usual }), "mass is 0, allowed 0.001 to 1000000");
    assert_eq!(cloth(Cloth { stiffness: too_stiff, ..usual }), "stiffness is 1.5, allowed 0 to 1");
    let drag = Factor::from_raw(-1 << 16);
    assert_eq!(cloth(Cloth { drag, ..usual }), "drag is -1, allowed 0 to 1000");
    let bent = Rope { bending: too_stiff, ..Rope::default() };
    assert_eq!(rope(bent, &[Vec3::ZERO, Vec3::X]), "bending is 1.5, allowed 0 to 1");
    let ends = rope(Rope::default(), &[Vec3::X, Vec3::X]);
    assert_eq!(ends, "rest_length: the ends coincide");
    let plant = Plant { compliance: too_stiff, ..Plant::default() };
    let plant = plant.of(&mesh, |_| true).expect_err("likewise").to_string();
    assert_eq!(plant, "compliance is 1.5, allowed 0 to 1");
}
