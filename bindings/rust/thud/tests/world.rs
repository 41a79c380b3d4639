//! What the crate adds to the engine: results, borrowed views, owners and closures, and the golden
//! hashes of scenes that are built with it.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

use thud::{BodyDef, BodyId, Pos, ShapeDef, Terrain, World, WorldDef};

fn fixed(world: &mut World, x: f64, y: f64) -> BodyId {
    world.body_create(&BodyDef { position: Pos { x, y }, ..Default::default() }).unwrap()
}

fn dynamic(world: &mut World, x: f64, y: f64) -> BodyId {
    let def = BodyDef { kind: thud::BODY_DYNAMIC, position: Pos { x, y }, ..Default::default() };
    world.body_create(&def).unwrap()
}

fn falling() -> (World, BodyId) {
    let mut world = World::new(&WorldDef::default()).unwrap();
    let ground = fixed(&mut world, 0.0, 0.0);
    world.shape_create_terrain(ground, &ShapeDef::default(), &Terrain::flat(0.0)).unwrap();
    let ball = dynamic(&mut world, 0.0, 5.0);
    world.shape_create_circle(ball, &ShapeDef::default(), (0.0, 0.0), 0.5).unwrap();
    (world, ball)
}

fn tall_stack() -> World {
    let mut world = World::new(&WorldDef::default()).unwrap();
    let floor = fixed(&mut world, 0.0, -1.0);
    world.shape_create_aabb(floor, &ShapeDef::default(), (0.0, 0.0), (20.0, 1.0)).unwrap();
    for row in 0..30 {
        let body = dynamic(&mut world, 0.0, f64::from(row) + 0.5);
        world.shape_create_obb(body, &ShapeDef::default(), (0.0, 0.0), (0.5, 0.5), 0.0).unwrap();
    }
    world
}

fn heavy_on_light() -> World {
    let mut world = World::new(&WorldDef::default()).unwrap();
    let floor = fixed(&mut world, 0.0, -1.0);
    world.shape_create_aabb(floor, &ShapeDef::default(), (0.0, 0.0), (24.0, 1.0)).unwrap();
    for (group, below) in [1, 10].into_iter().enumerate() {
        for power in 0..5 {
            for row in 0..=below {
                let x = (f64::from(power) + 0.5 + group as f64 * 5.0 - 5.0) * 4.0;
                let body = dynamic(&mut world, x, f64::from(row) + 0.5);
                let density = if row == below { 10f32.powi(power + 1) } else { 1.0 };
                let def = ShapeDef { density, ..Default::default() };
                world.shape_create_obb(body, &def, (0.0, 0.0), (0.5, 0.5), 0.0).unwrap();
            }
        }
    }
    world
}

fn cradle() -> World {
    let mut world = World::new(&WorldDef::default().gravity((0.0, 0.0))).unwrap();
    let bouncy = ShapeDef { friction: 0.0, restitution: 1.0, ..Default::default() };
    for x in [-15.5, 15.5] {
        let wall = fixed(&mut world, x, 0.0);
        world.shape_create_aabb(wall, &bouncy, (0.0, 0.0), (1.0, 8.0)).unwrap();
    }
    for row in 1..=3 {
        for i in 0..5 {
            let flies = i < row;
            let body = world
                .body_create(&BodyDef {
                    kind: thud::BODY_DYNAMIC,
                    position: (f64::from(i) - 2.0 - if flies { 6.0 } else { 0.0 }, f64::from(4 * (2 - row))).into(),
                    velocity: (if flies { 5.0 } else { 0.0 }, 0.0).into(),
                    may_sleep: false,
                    ..Default::default()
                })
                .unwrap();
            world.shape_create_circle(body, &bouncy, (0.0, 0.0), 0.5).unwrap();
        }
    }
    world
}

#[test]
fn golden_hashes_are_those_of_c() {
    let path = std::env::var("THUD_PROJECT").unwrap_or_else(|_| format!("{}/../../..", env!("CARGO_MANIFEST_DIR")));
    let rows = std::fs::read_to_string(path + "/tests/golden/hashes.txt").unwrap();
    let scenes: [(&str, fn() -> World); 3] =
        [("tall_stack", tall_stack), ("heavy_on_light", heavy_on_light), ("cradle", cradle)];
    for (name, make) in scenes {
        let mut world = make();
        for _ in 0..120 {
            world.step().unwrap();
        }
        let row = format!("{name:<16} {:016x}", world.hash().unwrap());
        assert!(rows.lines().any(|line| line == row), "{row}");
    }
}

#[test]
fn refused_calls_have_the_reason_and_change_nothing() {
    let (mut world, ball) = falling();
    let before = world.snapshot().unwrap();
    let rough = ShapeDef { friction: -1.0, ..Default::default() };
    let error = world.shape_create_circle(ball, &rough, (0.0, 0.0), 0.5).unwrap_err();
    assert_eq!(error.code, thud::ERROR_INVALID);
    assert!(error.to_string().contains("friction is -1, not in [0, 1000000]"), "{error}");
    assert!(world.body_set_velocity(ball, (f32::NAN, 0.0), 0.0).is_err());
    assert_eq!(world.snapshot().unwrap(), before);
    world.body_destroy(ball).unwrap();
    assert!(!world.body_is_valid(ball));
    assert_eq!(world.body_state(ball).unwrap_err().code, thud::ERROR_STALE);
    let error = World::new(&WorldDef::default().time_step(2.0)).err().unwrap();
    assert!(error.message.contains("time_step is 2"), "{error}");
    let nothing = thud::Geometry { kind: 99, x: 0.0, y: 0.0, c: 1.0, s: 0.0, hx: 1.0, hy: 1.0 };
    assert_eq!(thud::geometry_check(&nothing).unwrap_err().code, thud::ERROR_INVALID);
}

#[test]
fn objects_of_the_engine_are_settings() {
    let def = WorldDef::default().quality(thud::quality::high()).detection(thud::detection::swept());
    let mut world = World::new(&def.broadphase(thud::broadphase::sweep())).unwrap();
    world.step().unwrap();
    assert_eq!(world.stats().unwrap().substeps, 8);
    world.set_quality(thud::quality::default()).unwrap();
    world.step().unwrap();
    assert_eq!(world.stats().unwrap().substeps, 4);
    let body = dynamic(&mut world, 0.0, 0.0);
    world.body_set_detection(body, Some(thud::detection::bisect())).unwrap();
    world.body_set_detection(body, None).unwrap();
}

#[test]
fn poses_and_events_are_borrowed() {
    let (mut world, ball) = falling();
    let (mut begun, mut speed) = (0, 0.0);
    for _ in 0..120 {
        assert_eq!(world.advance(1.0 / 60.0, 4).unwrap().0, 1);
        let events = world.events();
        begun += events.begin.len();
        speed = events.hit.first().map_or(speed, |hit| hit.speed);
    }
    assert_eq!(begun, 1);
    assert!((speed - 9.5f32).abs() < 0.2);
    let place = world.body_position(ball).unwrap();
    let poses = world.poses((0.0, 0.0), 1.0).unwrap();
    assert_eq!(poses.len(), 2);
    assert_eq!(poses[thud::slot(ball)].y, place.y as f32);
    let address = poses.as_ptr();
    assert_eq!(world.poses((0.0, 0.0), 1.0).unwrap().as_ptr(), address);
    assert!(world.poses((0.0, 0.0), 2.0).is_err());
}

#[test]
fn outputs_are_tuples_options_and_lists() {
    let (mut world, ball) = falling();
    assert_eq!(thud::sincos(0.0).unwrap(), (0.0, 1.0));
    for i in 0..40 {
        dynamic(&mut world, f64::from(10 * i), 9.0);
    }
    let last = dynamic(&mut world, 0.0, 90.0);
    let bodies = world.bodies().unwrap();
    assert_eq!((bodies.len(), bodies[1], bodies[42]), (43, ball, last));
    let hit = world.cast_ray((0.0, 7.0), (0.0, -20.0), None).unwrap().unwrap();
    assert!((hit.point.y - 5.5).abs() < 1e-6);
    assert_eq!(world.shape_body(hit.shape).unwrap(), ball);
    assert!(world.cast_ray((0.0, 7.0), (0.0, 1.0), None).unwrap().is_none());
    let none = thud::QueryFilter { mask: 0, ..Default::default() };
    assert!(world.cast_ray((0.0, 7.0), (0.0, -20.0), Some(&none)).unwrap().is_none());
    let circle = thud::Geometry { kind: thud::SHAPE_CIRCLE, x: 0.0, y: 0.0, c: 1.0, s: 0.0, hx: 1.0, hy: 0.0 };
    let ray = thud::Segment { x: 0.0, y: 3.0, dx: 0.0, dy: -4.0 };
    assert_eq!(thud::geometry_cast_ray(&circle, ray), Some((0.5, 0.0, 1.0)));
    let predicted = world.extrapolate(&[ball, last], 0.0).unwrap();
    assert_eq!((predicted.len(), predicted[1].position.y), (2, 90.0));
}

#[test]
fn joints_hold() {
    let mut world = World::new(&WorldDef::default()).unwrap();
    let (post, door) = (fixed(&mut world, 0.0, 5.0), dynamic(&mut world, 1.0, 5.0));
    world.shape_create_obb(door, &ShapeDef::default(), (0.0, 0.0), (1.0, 0.1), 0.0).unwrap();
    let mut def = world.hinge_at(post, door, (0.0, 5.0));
    def.drive[thud::DIRECTION_TURN as usize].limited = true;
    let hinge = world.joint_create(&def).unwrap();
    for _ in 0..60 {
        world.step().unwrap();
    }
    let state = world.joint_state(hinge).unwrap();
    assert!(state.gap < 0.01 && state.value[thud::DIRECTION_TURN as usize].abs() < 0.05);
    assert_eq!(world.joints().unwrap(), [hinge]);
}

#[test]
fn snapshots_bring_back_the_bits() {
    let (mut world, _) = falling();
    let (kept, hash) = (world.snapshot().unwrap(), world.hash().unwrap());
    world.step().unwrap();
    assert_ne!(world.hash().unwrap(), hash);
    world.restore(&kept).unwrap();
    assert_eq!(world.hash().unwrap(), hash);
    let short = unsafe { thud::Snapshot::from_bytes(kept.bytes()[1..].to_vec()) };
    assert!(world.restore(&short).is_err());
}

#[test]
fn closures_are_called_and_freed() {
    let (mut world, ball) = falling();
    let mut seen = Vec::new();
    world
        .overlap_aabb((-9.0, -9.0), (9.0, 9.0), None, |shape| {
            seen.push(shape);
            true
        })
        .unwrap();
    assert_eq!(seen.len(), 2);

    let counts = Arc::new((AtomicUsize::new(0), AtomicUsize::new(0)));
    let (before, after) = (counts.clone(), counts.clone());
    world
        .set_listeners(
            Some(Box::new(move |_, settings| {
                settings.friction = 0.0;
                before.0.fetch_add(1, Ordering::Relaxed);
                true
            })),
            Some(Box::new(move |contact| {
                after.1.fetch_add(usize::from(contact.body_b == ball), Ordering::Relaxed);
            })),
        )
        .unwrap();
    for _ in 0..90 {
        world.step().unwrap();
    }
    let prologues = counts.0.load(Ordering::Relaxed);
    assert!(prologues > 10 && counts.1.load(Ordering::Relaxed) > 10);
    world.set_listeners(None, None).unwrap();
    assert_eq!(Arc::strong_count(&counts), 1);
    world.step().unwrap();
    assert_eq!(counts.0.load(Ordering::Relaxed), prologues);
}

#[test]
fn worlds_go_to_other_threads() {
    let worlds: Vec<_> = (0..4)
        .map(|_| {
            std::thread::spawn(|| {
                let (mut world, _) = falling();
                world.step().unwrap();
                world
            })
        })
        .map(|thread| thread.join().unwrap().hash().unwrap())
        .collect();
    assert!(worlds.iter().all(|hash| *hash == worlds[0]));
}

#[test]
fn a_clock_times_stages_and_keeps_to_a_budget() {
    /// Each reading is a second after the one before.
    fn slow() -> f64 {
        static READINGS: AtomicUsize = AtomicUsize::new(0);
        READINGS.fetch_add(1, Ordering::Relaxed) as f64
    }
    let mut world = World::new(&WorldDef::default().clock(slow).time_budget(0.01)).unwrap();
    dynamic(&mut world, 0.0, 5.0);
    for _ in 0..20 {
        world.step().unwrap();
    }
    let stats = world.stats().unwrap();
    assert!(stats.substeps == 1 && stats.step_seconds >= 5.0);
    let mut world = World::new(&WorldDef::default().clock(thud::monotonic).time_budget(1.0)).unwrap();
    dynamic(&mut world, 0.0, 5.0);
    world.step().unwrap();
    let stats = world.stats().unwrap();
    assert!(stats.substeps == 4 && stats.step_seconds > 0.0 && stats.step_seconds < 1.0);
    let refused = World::new(&WorldDef::default().time_budget(1.0)).err().unwrap();
    assert_eq!(refused.message, "world def: time_budget lacks a clock");
}
