// Rapier 2D for the benchmark, behind the C interface of rapier.h: worlds are created body by body,
// stepped, and read in the order of creation. Everything else has Rapier's defaults.

use rapier2d::prelude::*;
use std::alloc::{GlobalAlloc, Layout, System};
use std::slice;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

// An allocator that counts, because Rapier does not report its memory. There is one thread only, so
// that a load and a store suffice instead of an atomic addition.
struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);

fn count(more: usize, less: usize) {
    HELD.store(HELD.load(Relaxed).wrapping_add(more).wrapping_sub(less), Relaxed);
}

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        count(0, layout.size());
        unsafe { System.dealloc(block, layout) }
    }
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size, layout.size());
        unsafe { System.realloc(block, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

pub struct World {
    physics: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
}

/// rapier_body of rapier.h.
#[repr(C)]
pub struct Body {
    kind: i32, // 0 static, 1 kinematic, 2 dynamic
    x: f32,
    y: f32,
    angle: f32,
    vx: f32,
    vy: f32,
    angular_velocity: f32,
    gravity_scale: f32,
    linear_damping: f32,
    angular_damping: f32,
    fixed_rotation: bool,
    may_sleep: bool,
}

/// rapier_shape of rapier.h.
#[repr(C)]
pub struct Shape {
    x: f32,
    y: f32,
    angle: f32,
    density: f32,
    friction: f32,
    restitution: f32,
    category: u32,
    mask: u32,
    sensor: bool,
}

/// rapier_state of rapier.h.
#[repr(C)]
pub struct State {
    x: f32,
    y: f32,
    cosine: f32,
    sine: f32,
    vx: f32,
    vy: f32,
    angular_velocity: f32,
    mass: f32,
    inertia: f32,
    awake: bool,
}

#[unsafe(no_mangle)]
pub extern "C" fn rapier_create(gx: f32, gy: f32, time_step: f32, length_scale: f32) -> *mut World {
    let mut physics = PhysicsWorld::new();
    physics.gravity = Vector::new(gx, gy);
    physics.integration_parameters.dt = time_step;
    physics.integration_parameters.length_unit = length_scale;
    Box::into_raw(Box::new(World { physics, bodies: Vec::new() }))
}

/// # Safety
/// `world` is one of rapier_create and not used afterwards.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_destroy(world: *mut World) {
    drop(unsafe { Box::from_raw(world) });
}

// `world` and `body` must be valid pointers, as in all functions below.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_add_body(world: *mut World, body: *const Body) {
    let (world, body) = unsafe { (&mut *world, &*body) };
    let mut builder = match body.kind {
        0 => RigidBodyBuilder::fixed(),
        1 => RigidBodyBuilder::kinematic_velocity_based(),
        _ => RigidBodyBuilder::dynamic(),
    }
    .translation(Vector::new(body.x, body.y))
    .rotation(body.angle)
    .linvel(Vector::new(body.vx, body.vy))
    .angvel(body.angular_velocity)
    .gravity_scale(body.gravity_scale)
    .linear_damping(body.linear_damping)
    .angular_damping(body.angular_damping)
    .can_sleep(body.may_sleep);
    if body.fixed_rotation {
        builder = builder.lock_rotations();
    }
    let handle = world.physics.insert_body(builder);
    world.bodies.push(handle);
}

// Friction is combined as the geometric mean and restitution as the maximum, as in the other
// engines.
fn add(world: &mut World, collider: ColliderBuilder, shape: &Shape) {
    let groups = InteractionGroups::new(
        Group::from_bits_retain(shape.category),
        Group::from_bits_retain(shape.mask),
        InteractionTestMode::And,
    );
    let collider = collider
        .translation(Vector::new(shape.x, shape.y))
        .rotation(shape.angle)
        .density(shape.density)
        .friction(shape.friction)
        .friction_combine_rule(CoefficientCombineRule::GeometricMean)
        .restitution(shape.restitution)
        .restitution_combine_rule(CoefficientCombineRule::Max)
        .collision_groups(groups)
        .sensor(shape.sensor);
    world.physics.insert_collider(collider, world.bodies.last().copied());
}

/// # Safety
/// See rapier_add_body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_add_circle(world: *mut World, shape: *const Shape, radius: f32) {
    let (world, shape) = unsafe { (&mut *world, &*shape) };
    add(world, ColliderBuilder::ball(radius), shape);
}

/// # Safety
/// See rapier_add_body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_add_box(world: *mut World, shape: *const Shape, hx: f32, hy: f32) {
    let (world, shape) = unsafe { (&mut *world, &*shape) };
    add(world, ColliderBuilder::cuboid(hx, hy), shape);
}

/// # Safety
/// See rapier_add_body; `xy` holds `count` pairs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_add_line(
    world: *mut World,
    shape: *const Shape,
    xy: *const f32,
    count: usize,
) {
    let (world, shape) = unsafe { (&mut *world, &*shape) };
    let xy = unsafe { slice::from_raw_parts(xy, 2 * count) };
    let points = xy.chunks_exact(2).map(|p| Vector::new(p[0], p[1])).collect();
    add(world, ColliderBuilder::oriented_polyline(points, None), shape);
}

/// # Safety
/// See rapier_add_body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_step(world: *mut World) {
    unsafe { &mut *world }.physics.step();
}

/// # Safety
/// See rapier_add_body; `out` has room for every body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn rapier_read(world: *const World, out: *mut State) {
    let world = unsafe { &*world };
    let out = unsafe { slice::from_raw_parts_mut(out, world.bodies.len()) };
    for (state, handle) in out.iter_mut().zip(&world.bodies) {
        let body = &world.physics.bodies[*handle];
        let axis = *body.rotation() * Vector::new(1.0, 0.0);
        let dynamic = body.is_dynamic();
        let mass = &body.mass_properties().local_mprops;
        *state = State {
            x: body.translation().x,
            y: body.translation().y,
            cosine: axis.x,
            sine: axis.y,
            vx: body.linvel().x,
            vy: body.linvel().y,
            angular_velocity: body.angvel(),
            mass: if dynamic { body.mass() } else { 0.0 },
            inertia: if dynamic { mass.principal_inertia() } else { 0.0 },
            awake: !body.is_sleeping(),
        };
    }
}

// The bytes that all worlds hold at present.
#[unsafe(no_mangle)]
pub extern "C" fn rapier_bytes() -> usize {
    HELD.load(Relaxed)
}
