// Made from the headers of thud by tools/bind_rust.py.

use std::ffi::c_int;

use thud_sys as sys;

use crate::{check, context, count, list, slice, zeroed, Quality, Result, Terrain, World, WorldDef};

pub use sys::thud_approach as Approach;
pub use sys::thud_approximate_kind as ApproximateKind;
pub use sys::thud_approximation as Approximation;
pub use sys::thud_body_def as BodyDef;
pub use sys::thud_body_id as BodyId;
pub use sys::thud_body_kind as BodyKind;
pub use sys::thud_body_options as BodyOptions;
pub use sys::thud_body_seen as BodySeen;
pub use sys::thud_body_state as BodyState;
pub use sys::thud_broadphase as Broadphase;
pub use sys::thud_broadphase_counts as BroadphaseCounts;
pub use sys::thud_call_value as CallValue;
pub use sys::thud_capsule as Capsule;
pub use sys::thud_closest as Closest;
pub use sys::thud_closest_hit as ClosestHit;
pub use sys::thud_contact as Contact;
pub use sys::thud_contact_answer as ContactAnswer;
pub use sys::thud_contact_event as ContactEvent;
pub use sys::thud_contact_part as ContactPart;
pub use sys::thud_contact_settings as ContactSettings;
pub use sys::thud_contacts as Contacts;
pub use sys::thud_cover as Cover;
pub use sys::thud_detection as Detection;
pub use sys::thud_direction as Direction;
pub use sys::thud_drive as Drive;
pub use sys::thud_drive_forces as DriveForces;
pub use sys::thud_event_pair as EventPair;
pub use sys::thud_explosion as Explosion;
pub use sys::thud_filter as Filter;
pub use sys::thud_foot as Foot;
pub use sys::thud_geometry as Geometry;
pub use sys::thud_half_plane as HalfPlane;
pub use sys::thud_hit_event as HitEvent;
pub use sys::thud_impulse_event as ImpulseEvent;
pub use sys::thud_island_solver as IslandSolver;
pub use sys::thud_joint_def as JointDef;
pub use sys::thud_joint_event as JointEvent;
pub use sys::thud_joint_frame as JointFrame;
pub use sys::thud_joint_id as JointId;
pub use sys::thud_joint_kind as JointKind;
pub use sys::thud_joint_state as JointState;
pub use sys::thud_manifold as Manifold;
pub use sys::thud_mass as Mass;
pub use sys::thud_measure as Measure;
pub use sys::thud_minkowski as Minkowski;
pub use sys::thud_motion as Motion;
pub use sys::thud_mover_hit as MoverHit;
pub use sys::thud_mover_report as MoverReport;
pub use sys::thud_one_way as OneWay;
pub use sys::thud_pair as Pair;
pub use sys::thud_pair_side as PairSide;
pub use sys::thud_player_progress as PlayerProgress;
pub use sys::thud_pos as Pos;
pub use sys::thud_pose as Pose;
pub use sys::thud_prediction as Prediction;
pub use sys::thud_query_filter as QueryFilter;
pub use sys::thud_ray_hit as RayHit;
pub use sys::thud_result as Code;
pub use sys::thud_rollback_difference as RollbackDifference;
pub use sys::thud_rollback_progress as RollbackProgress;
pub use sys::thud_rule as Rule;
pub use sys::thud_rule_kind as RuleKind;
pub use sys::thud_segment as Segment;
pub use sys::thud_shape_def as ShapeDef;
pub use sys::thud_shape_id as ShapeId;
pub use sys::thud_shape_kind as ShapeKind;
pub use sys::thud_shape_state as ShapeState;
pub use sys::thud_shared_stages as SharedStages;
pub use sys::thud_stage as Stage;
pub use sys::thud_stats as Stats;
pub use sys::thud_step_error as StepError;
pub use sys::thud_style as Style;
pub use sys::thud_terrain_kind as TerrainKind;
pub use sys::thud_terrain_sample as TerrainSample;
pub use sys::thud_uv as Uv;
pub use sys::thud_vec2 as Vec2;
pub use sys::thud_velocities as Velocities;
pub use sys::thud_volume as Volume;
pub use sys::thud_water as Water;

pub const OK: Code = sys::THUD_OK;
pub const ERROR_NULL: Code = sys::THUD_ERROR_NULL;
pub const ERROR_INVALID: Code = sys::THUD_ERROR_INVALID;
pub const ERROR_STALE: Code = sys::THUD_ERROR_STALE;
pub const ERROR_MEMORY: Code = sys::THUD_ERROR_MEMORY;
pub const ERROR_LOCKED: Code = sys::THUD_ERROR_LOCKED;
pub const STYLE_STATIC: Style = sys::THUD_STYLE_STATIC;
pub const STYLE_KINEMATIC: Style = sys::THUD_STYLE_KINEMATIC;
pub const STYLE_DYNAMIC: Style = sys::THUD_STYLE_DYNAMIC;
pub const STYLE_SLEEPING: Style = sys::THUD_STYLE_SLEEPING;
pub const STYLE_SENSOR: Style = sys::THUD_STYLE_SENSOR;
pub const STYLE_BOUNDS: Style = sys::THUD_STYLE_BOUNDS;
pub const STYLE_CELL: Style = sys::THUD_STYLE_CELL;
pub const STYLE_CONTACT: Style = sys::THUD_STYLE_CONTACT;
pub const STYLE_NORMAL: Style = sys::THUD_STYLE_NORMAL;
pub const STYLE_INTERVAL: Style = sys::THUD_STYLE_INTERVAL;
pub const STYLE_INTERVAL_OVERLAPPING: Style = sys::THUD_STYLE_INTERVAL_OVERLAPPING;
pub const STYLE_PAIR: Style = sys::THUD_STYLE_PAIR;
pub const STYLE_PAIR_TOUCHING: Style = sys::THUD_STYLE_PAIR_TOUCHING;
pub const STYLE_MOTION: Style = sys::THUD_STYLE_MOTION;
pub const STYLE_PAIR_CANDIDATE: Style = sys::THUD_STYLE_PAIR_CANDIDATE;
pub const STYLE_DIRECT: Style = sys::THUD_STYLE_DIRECT;
pub const STYLE_MANIFOLD: Style = sys::THUD_STYLE_MANIFOLD;
pub const STYLE_DEPTH: Style = sys::THUD_STYLE_DEPTH;
pub const STYLE_IMPULSE: Style = sys::THUD_STYLE_IMPULSE;
pub const STYLE_COLOUR: Style = sys::THUD_STYLE_COLOUR;
pub const STYLE_COLOUR_LAST: Style = sys::THUD_STYLE_COLOUR_LAST;
pub const STYLE_JOINT: Style = sys::THUD_STYLE_JOINT;
pub const STYLE_JOINT_AXIS: Style = sys::THUD_STYLE_JOINT_AXIS;
pub const STYLE_JOINT_LIMIT: Style = sys::THUD_STYLE_JOINT_LIMIT;
pub const STYLE_JOINT_FORCE: Style = sys::THUD_STYLE_JOINT_FORCE;
pub const SHAPE_CIRCLE: ShapeKind = sys::THUD_SHAPE_CIRCLE;
pub const SHAPE_AABB: ShapeKind = sys::THUD_SHAPE_AABB;
pub const SHAPE_OBB: ShapeKind = sys::THUD_SHAPE_OBB;
pub const SHAPE_TERRAIN: ShapeKind = sys::THUD_SHAPE_TERRAIN;
pub const TERRAIN_FLAT: TerrainKind = sys::THUD_TERRAIN_FLAT;
pub const TERRAIN_UNIFORM: TerrainKind = sys::THUD_TERRAIN_UNIFORM;
pub const TERRAIN_IRREGULAR: TerrainKind = sys::THUD_TERRAIN_IRREGULAR;
pub const BODY_STATIC: BodyKind = sys::THUD_BODY_STATIC;
pub const BODY_KINEMATIC: BodyKind = sys::THUD_BODY_KINEMATIC;
pub const BODY_DYNAMIC: BodyKind = sys::THUD_BODY_DYNAMIC;
pub const STAGE_CHANGES: Stage = sys::THUD_STAGE_CHANGES;
pub const STAGE_BROADPHASE: Stage = sys::THUD_STAGE_BROADPHASE;
pub const STAGE_NARROWPHASE: Stage = sys::THUD_STAGE_NARROWPHASE;
pub const STAGE_CONTACTS: Stage = sys::THUD_STAGE_CONTACTS;
pub const STAGE_SOLVE: Stage = sys::THUD_STAGE_SOLVE;
pub const STAGE_FINALIZE: Stage = sys::THUD_STAGE_FINALIZE;
pub const STAGE_CONTINUOUS: Stage = sys::THUD_STAGE_CONTINUOUS;
pub const STAGE_EVENTS: Stage = sys::THUD_STAGE_EVENTS;
pub const STAGE_SLEEP: Stage = sys::THUD_STAGE_SLEEP;
pub const APPROXIMATE_BOTH: ApproximateKind = sys::THUD_APPROXIMATE_BOTH;
pub const APPROXIMATE_CIRCLES: ApproximateKind = sys::THUD_APPROXIMATE_CIRCLES;
pub const APPROXIMATE_BOXES: ApproximateKind = sys::THUD_APPROXIMATE_BOXES;
pub const COVER_NONE: Cover = sys::THUD_COVER_NONE;
pub const COVER_STATIC: Cover = sys::THUD_COVER_STATIC;
pub const COVER_ALL: Cover = sys::THUD_COVER_ALL;
pub const JOINT_DISTANCE: JointKind = sys::THUD_JOINT_DISTANCE;
pub const JOINT_HINGE: JointKind = sys::THUD_JOINT_HINGE;
pub const JOINT_SLIDER: JointKind = sys::THUD_JOINT_SLIDER;
pub const JOINT_WELD: JointKind = sys::THUD_JOINT_WELD;
pub const JOINT_WHEEL: JointKind = sys::THUD_JOINT_WHEEL;
pub const JOINT_TARGET: JointKind = sys::THUD_JOINT_TARGET;
pub const JOINT_FILTER: JointKind = sys::THUD_JOINT_FILTER;
pub const JOINT_GEAR: JointKind = sys::THUD_JOINT_GEAR;
pub const DIRECTION_ALONG: Direction = sys::THUD_DIRECTION_ALONG;
pub const DIRECTION_ACROSS: Direction = sys::THUD_DIRECTION_ACROSS;
pub const DIRECTION_TURN: Direction = sys::THUD_DIRECTION_TURN;
pub const CONTACT_BODIES: ContactPart = sys::THUD_CONTACT_BODIES;
pub const CONTACT_POINT: ContactPart = sys::THUD_CONTACT_POINT;
pub const RULE_COLLIDE: RuleKind = sys::THUD_RULE_COLLIDE;
pub const RULE_IGNORE: RuleKind = sys::THUD_RULE_IGNORE;
pub const RULE_ONE_WAY: RuleKind = sys::THUD_RULE_ONE_WAY;

/// Objects of the engine for `Broadphase`.
pub mod broadphase {
    use thud_sys as sys;

    pub fn grid() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_grid }
    }

    pub fn sweep() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_sweep }
    }

    pub fn sweep_y() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_sweep_y }
    }

    pub fn sweep_widest() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_sweep_widest }
    }

    pub fn sweep_both() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_sweep_both }
    }

    pub fn all() -> &'static super::Broadphase {
        unsafe { &sys::thud_broadphase_all }
    }
}

/// Objects of the engine for `Detection`.
pub mod detection {
    use thud_sys as sys;

    pub fn overlap() -> &'static super::Detection {
        unsafe { &sys::thud_detection_overlap }
    }

    pub fn continuous() -> &'static super::Detection {
        unsafe { &sys::thud_detection_continuous }
    }

    pub fn bisect() -> &'static super::Detection {
        unsafe { &sys::thud_detection_bisect }
    }

    pub fn swept() -> &'static super::Detection {
        unsafe { &sys::thud_detection_swept }
    }
}

/// Objects of the engine for `SharedStages`.
pub mod shared_stages {
    use thud_sys as sys;

    pub fn stages_all() -> &'static super::SharedStages {
        unsafe { &sys::thud_shared_stages_all }
    }
}

/// Objects of the engine for `IslandSolver`.
pub mod island_solver {
    use thud_sys as sys;

    pub fn direct() -> &'static super::IslandSolver {
        unsafe { &sys::thud_islands_direct }
    }
}

/// Objects of the engine for `Quality`.
pub mod quality {
    use thud_sys as sys;

    pub fn draft() -> &'static super::Quality {
        unsafe { &*std::ptr::addr_of!(sys::thud_quality_draft).cast::<super::Quality>() }
    }

    pub fn default() -> &'static super::Quality {
        unsafe { &*std::ptr::addr_of!(sys::thud_quality_default).cast::<super::Quality>() }
    }

    pub fn high() -> &'static super::Quality {
        unsafe { &*std::ptr::addr_of!(sys::thud_quality_high).cast::<super::Quality>() }
    }

    pub fn exact() -> &'static super::Quality {
        unsafe { &*std::ptr::addr_of!(sys::thud_quality_exact).cast::<super::Quality>() }
    }
}

/// The events of the last step, or of all steps of the last advance; see thud_events.h.
#[derive(Clone, Copy, Debug)]
pub struct Events<'w> {
    pub begin: &'w [ContactEvent],
    pub end: &'w [ContactEvent],
    pub sensor_begin: &'w [ContactEvent],
    pub sensor_end: &'w [ContactEvent],
    pub sensor_begin_time: &'w [f32],
    pub sensor_end_time: &'w [f32],
    pub hit: &'w [HitEvent],
    pub quarantined: &'w [BodyId],
}

impl Events<'_> {
    pub(crate) unsafe fn of(of: &sys::thud_events) -> Self {
        Self {
            begin: slice(of.begin, of.begin_count),
            end: slice(of.end, of.end_count),
            sensor_begin: slice(of.sensor_begin, of.sensor_begin_count),
            sensor_end: slice(of.sensor_end, of.sensor_end_count),
            sensor_begin_time: slice(of.sensor_begin_time, of.sensor_begin_count),
            sensor_end_time: slice(of.sensor_end_time, of.sensor_end_count),
            hit: slice(of.hit, of.hit_count),
            quarantined: slice(of.quarantined, of.quarantined_count),
        }
    }
}

impl WorldDef {
    #[must_use]
    pub fn gravity(mut self, gravity: impl Into<Vec2>) -> Self {
        self.0.gravity = gravity.into();
        self
    }

    #[must_use]
    pub fn time_step(mut self, time_step: f64) -> Self {
        self.0.time_step = time_step;
        self
    }

    #[must_use]
    pub fn length_scale(mut self, length_scale: f32) -> Self {
        self.0.length_scale = length_scale;
        self
    }

    #[must_use]
    pub fn substeps(mut self, substeps: c_int) -> Self {
        self.0.substeps = substeps;
        self
    }

    #[must_use]
    pub fn contact_stiffness(mut self, contact_stiffness: f32) -> Self {
        self.0.contact_stiffness = contact_stiffness;
        self
    }

    #[must_use]
    pub fn contact_damping(mut self, contact_damping: f32) -> Self {
        self.0.contact_damping = contact_damping;
        self
    }

    #[must_use]
    pub fn push_speed(mut self, push_speed: f32) -> Self {
        self.0.push_speed = push_speed;
        self
    }

    #[must_use]
    pub fn restitution_threshold(mut self, restitution_threshold: f32) -> Self {
        self.0.restitution_threshold = restitution_threshold;
        self
    }

    #[must_use]
    pub fn hit_speed(mut self, hit_speed: f32) -> Self {
        self.0.hit_speed = hit_speed;
        self
    }

    #[must_use]
    pub fn maximum_speed(mut self, maximum_speed: f32) -> Self {
        self.0.maximum_speed = maximum_speed;
        self
    }

    #[must_use]
    pub fn sleeping(mut self, sleeping: bool) -> Self {
        self.0.sleeping = sleeping;
        self
    }

    #[must_use]
    pub fn contact_events(mut self, contact_events: bool) -> Self {
        self.0.contact_events = contact_events;
        self
    }

    #[must_use]
    pub fn max_error(mut self, max_error: f64) -> Self {
        self.0.max_error = max_error;
        self
    }

    #[must_use]
    pub fn time_budget(mut self, time_budget: f64) -> Self {
        self.0.time_budget = time_budget;
        self
    }

    #[must_use]
    pub fn detection(mut self, detection: &'static Detection) -> Self {
        self.0.detection = Some(detection);
        self
    }

    #[must_use]
    pub fn broadphase(mut self, broadphase: &'static Broadphase) -> Self {
        self.0.broadphase = Some(broadphase);
        self
    }

    #[must_use]
    pub fn cell_size(mut self, cell_size: f32) -> Self {
        self.0.cell_size = cell_size;
        self
    }
}

unsafe extern "C" fn overlap_fn<F: FnMut(ShapeId) -> bool>(shape: sys::thud_shape_id, context: *mut std::ffi::c_void) -> bool {
    (*context.cast::<F>())(shape)
}

pub fn sincos(angle: f64) -> Result<(f64, f64)> {
    let mut out_sine = zeroed::<f64>();
    let mut out_cosine = zeroed::<f64>();
    check(unsafe { sys::thud_sincos(angle, &mut out_sine, &mut out_cosine) })?;
    Ok((out_sine, out_cosine))
}

pub fn angle_of(sine: f64, cosine: f64) -> Result<f64> {
    let mut out_angle = zeroed::<f64>();
    check(unsafe { sys::thud_angle_of(sine, cosine, &mut out_angle) })?;
    Ok(out_angle)
}

pub fn geometry_check(shape: &Geometry) -> Result<()> {
    check(unsafe { sys::thud_geometry_check(shape) })?;
    Ok(())
}

#[must_use]
pub fn geometry_overlap(a: &Geometry, b: &Geometry) -> bool {
    unsafe { sys::thud_geometry_overlap(a, b) }
}

pub fn geometry_closest(a: &Geometry, b: &Geometry) -> Result<Closest> {
    let mut out = zeroed::<Closest>();
    check(unsafe { sys::thud_geometry_closest(a, b, &mut out) })?;
    Ok(out)
}

pub fn geometry_contacts(a: &Geometry, b: &Geometry, margin: f64) -> Result<Contacts> {
    let mut out = zeroed::<Contacts>();
    check(unsafe { sys::thud_geometry_contacts(a, b, margin, &mut out) })?;
    Ok(out)
}

#[must_use]
pub fn geometry_cast_ray(shape: &Geometry, ray: Segment) -> Option<(f64, f64, f64)> {
    let mut out_fraction = zeroed::<f64>();
    let mut out_nx = zeroed::<f64>();
    let mut out_ny = zeroed::<f64>();
    if unsafe { sys::thud_geometry_cast_ray(shape, ray, &mut out_fraction, &mut out_nx, &mut out_ny) } {
        Some((out_fraction, out_nx, out_ny))
    } else {
        None
    }
}

pub fn geometry_time_of_impact(a: &Geometry, motion_a: Motion, b: &Geometry, motion_b: Motion, target: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_geometry_time_of_impact(a, motion_a, b, motion_b, target, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn geometry_approach(a: &Geometry, motion_a: Motion, b: &Geometry, motion_b: Motion) -> Result<Approach> {
    let mut out = zeroed::<Approach>();
    check(unsafe { sys::thud_geometry_approach(a, motion_a, b, motion_b, &mut out) })?;
    Ok(out)
}

pub fn geometry_time_of_collision(a: &Geometry, motion_a: Motion, b: &Geometry, motion_b: Motion, tolerance: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_geometry_time_of_collision(a, motion_a, b, motion_b, tolerance, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

#[must_use]
pub fn geometry_is_bisectable(a: &Geometry, motion_a: Motion, b: &Geometry, motion_b: Motion) -> bool {
    unsafe { sys::thud_geometry_is_bisectable(a, motion_a, b, motion_b) }
}

pub fn terrain_check(terrain: &Terrain<'_>) -> Result<()> {
    check(unsafe { sys::thud_terrain_check(&terrain.raw) })?;
    Ok(())
}

pub fn terrain_sample_at(terrain: &Terrain<'_>, x: f64) -> Result<TerrainSample> {
    let mut out = zeroed::<TerrainSample>();
    check(unsafe { sys::thud_terrain_sample_at(&terrain.raw, x, &mut out) })?;
    Ok(out)
}

#[must_use]
pub fn terrain_segments(terrain: &Terrain<'_>, x_min: f64, x_max: f64) -> (c_int, c_int) {
    let mut out_first = zeroed::<c_int>();
    let mut out_last = zeroed::<c_int>();
    unsafe { sys::thud_terrain_segments(&terrain.raw, x_min, x_max, &mut out_first, &mut out_last) };
    (out_first, out_last)
}

#[must_use]
pub fn terrain_cast_ray(terrain: &Terrain<'_>, ray: Segment) -> Option<(f64, f64, f64)> {
    let mut out_fraction = zeroed::<f64>();
    let mut out_nx = zeroed::<f64>();
    let mut out_ny = zeroed::<f64>();
    if unsafe { sys::thud_terrain_cast_ray(&terrain.raw, ray, &mut out_fraction, &mut out_nx, &mut out_ny) } {
        Some((out_fraction, out_nx, out_ny))
    } else {
        None
    }
}

#[must_use]
pub fn terrain_overlap(terrain: &Terrain<'_>, shape: &Geometry) -> bool {
    unsafe { sys::thud_terrain_overlap(&terrain.raw, shape) }
}

pub fn terrain_closest(terrain: &Terrain<'_>, shape: &Geometry) -> Result<Closest> {
    let mut out = zeroed::<Closest>();
    check(unsafe { sys::thud_terrain_closest(&terrain.raw, shape, &mut out) })?;
    Ok(out)
}

pub fn terrain_contacts(terrain: &Terrain<'_>, shape: &Geometry, margin: f64) -> Result<Contacts> {
    let mut out = zeroed::<Contacts>();
    check(unsafe { sys::thud_terrain_contacts(&terrain.raw, shape, margin, &mut out) })?;
    Ok(out)
}

pub fn terrain_time_of_impact(terrain: &Terrain<'_>, shape: &Geometry, motion: Motion, target: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_terrain_time_of_impact(&terrain.raw, shape, motion, target, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn terrain_time_of_collision(terrain: &Terrain<'_>, shape: &Geometry, motion: Motion, tolerance: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_terrain_time_of_collision(&terrain.raw, shape, motion, tolerance, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn volume_check(volume: &Volume) -> Result<()> {
    check(unsafe { sys::thud_volume_check(volume) })?;
    Ok(())
}

pub fn volume_around_shape(kind: ShapeKind, shape: &Geometry) -> Result<Volume> {
    let mut out = zeroed::<Volume>();
    check(unsafe { sys::thud_volume_around_shape(kind, shape, &mut out) })?;
    Ok(out)
}

pub fn volume_around_motion(kind: ShapeKind, shape: &Geometry, motion: Motion) -> Result<Volume> {
    let mut out = zeroed::<Volume>();
    check(unsafe { sys::thud_volume_around_motion(kind, shape, motion, &mut out) })?;
    Ok(out)
}

pub fn volume_around_points(kind: ShapeKind, points: &[Pos]) -> Result<Volume> {
    let mut out = zeroed::<Volume>();
    check(unsafe { sys::thud_volume_around_points(kind, points.as_ptr(), count(points.len()), &mut out) })?;
    Ok(out)
}

pub fn volume_around_terrain(kind: ShapeKind, terrain: &Terrain<'_>, x_min: f64, x_max: f64) -> Result<Volume> {
    let mut out = zeroed::<Volume>();
    check(unsafe { sys::thud_volume_around_terrain(kind, &terrain.raw, x_min, x_max, &mut out) })?;
    Ok(out)
}

pub fn volume_merge(kind: ShapeKind, a: &Volume, b: &Volume) -> Result<Volume> {
    let mut out = zeroed::<Volume>();
    check(unsafe { sys::thud_volume_merge(kind, a, b, &mut out) })?;
    Ok(out)
}

pub fn volumes_overlap(a: &Volume, b: &Volume) -> Result<bool> {
    let mut out_overlap = zeroed::<bool>();
    check(unsafe { sys::thud_volumes_overlap(a, b, &mut out_overlap) })?;
    Ok(out_overlap)
}

pub fn volume_contains_point(volume: &Volume, x: f64, y: f64) -> Result<bool> {
    let mut out_inside = zeroed::<bool>();
    check(unsafe { sys::thud_volume_contains_point(volume, x, y, &mut out_inside) })?;
    Ok(out_inside)
}

pub fn volume_contains(outer: &Volume, inner: &Volume) -> Result<bool> {
    let mut out_inside = zeroed::<bool>();
    check(unsafe { sys::thud_volume_contains(outer, inner, &mut out_inside) })?;
    Ok(out_inside)
}

pub fn terrain_texture_at(sample: &TerrainSample, vertices: &[Uv]) -> Result<Uv> {
    let mut out = zeroed::<Uv>();
    check(unsafe { sys::thud_terrain_texture_at(sample, vertices.as_ptr(), count(vertices.len()), &mut out) })?;
    Ok(out)
}

pub fn terrain_place_foot(terrain: &Terrain<'_>, x: f64, width: f64) -> Result<Foot> {
    let mut out = zeroed::<Foot>();
    check(unsafe { sys::thud_terrain_place_foot(&terrain.raw, x, width, &mut out) })?;
    Ok(out)
}

pub fn capsule_check(capsule: &Capsule) -> Result<()> {
    check(unsafe { sys::thud_capsule_check(capsule) })?;
    Ok(())
}

pub fn capsule_of_motion(circle: &Geometry, motion: Motion) -> Result<Capsule> {
    let mut out = zeroed::<Capsule>();
    check(unsafe { sys::thud_capsule_of_motion(circle, motion, &mut out) })?;
    Ok(out)
}

pub fn capsule_closest(a: &Capsule, b: &Geometry) -> Result<Closest> {
    let mut out = zeroed::<Closest>();
    check(unsafe { sys::thud_capsule_closest(a, b, &mut out) })?;
    Ok(out)
}

pub fn capsules_closest(a: &Capsule, b: &Capsule) -> Result<Closest> {
    let mut out = zeroed::<Closest>();
    check(unsafe { sys::thud_capsules_closest(a, b, &mut out) })?;
    Ok(out)
}

pub fn terrain_capsule_closest(terrain: &Terrain<'_>, capsule: &Capsule) -> Result<Closest> {
    let mut out = zeroed::<Closest>();
    check(unsafe { sys::thud_terrain_capsule_closest(&terrain.raw, capsule, &mut out) })?;
    Ok(out)
}

pub fn capsule_time_of_impact(a: &Capsule, motion_a: Motion, b: &Geometry, motion_b: Motion, target: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_capsule_time_of_impact(a, motion_a, b, motion_b, target, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn capsules_time_of_impact(a: &Capsule, motion_a: Motion, b: &Capsule, motion_b: Motion, target: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_capsules_time_of_impact(a, motion_a, b, motion_b, target, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn terrain_capsule_time_of_impact(terrain: &Terrain<'_>, capsule: &Capsule, motion: Motion, target: f64) -> Result<Option<f64>> {
    let mut found = false;
    let mut out_time = zeroed::<f64>();
    check(unsafe { sys::thud_terrain_capsule_time_of_impact(&terrain.raw, capsule, motion, target, &mut found, &mut out_time) })?;
    Ok(found.then_some(out_time))
}

pub fn geometry_area_below(shape: &Geometry, below: HalfPlane) -> Result<(f64, f64, f64)> {
    let mut out_area = zeroed::<f64>();
    let mut out_center_x = zeroed::<f64>();
    let mut out_center_y = zeroed::<f64>();
    check(unsafe { sys::thud_geometry_area_below(shape, below, &mut out_area, &mut out_center_x, &mut out_center_y) })?;
    Ok((out_area, out_center_x, out_center_y))
}

#[must_use]
pub fn default_joint_def(kind: JointKind) -> JointDef {
    unsafe { sys::thud_default_joint_def(kind) }
}

pub fn minkowski_sum(a: &Geometry, b: &Geometry) -> Result<Minkowski> {
    let mut out = zeroed::<Minkowski>();
    check(unsafe { sys::thud_minkowski_sum(a, b, &mut out) })?;
    Ok(out)
}

pub fn minkowski_contains(sum: &Minkowski, x: f64, y: f64) -> Result<bool> {
    let mut out_inside = zeroed::<bool>();
    check(unsafe { sys::thud_minkowski_contains(sum, x, y, &mut out_inside) })?;
    Ok(out_inside)
}

pub fn minkowski_distance(sum: &Minkowski, x: f64, y: f64) -> Result<(f64, f64, f64)> {
    let mut out_distance = zeroed::<f64>();
    let mut out_nx = zeroed::<f64>();
    let mut out_ny = zeroed::<f64>();
    check(unsafe { sys::thud_minkowski_distance(sum, x, y, &mut out_distance, &mut out_nx, &mut out_ny) })?;
    Ok((out_distance, out_nx, out_ny))
}

pub fn minkowski_cast(sum: &Minkowski, path: Segment) -> Result<Option<(f64, f64, f64)>> {
    let mut found = false;
    let mut out_fraction = zeroed::<f64>();
    let mut out_nx = zeroed::<f64>();
    let mut out_ny = zeroed::<f64>();
    check(unsafe { sys::thud_minkowski_cast(sum, path, &mut found, &mut out_fraction, &mut out_nx, &mut out_ny) })?;
    Ok(found.then_some((out_fraction, out_nx, out_ny)))
}

#[must_use]
pub fn version() -> c_int {
    unsafe { sys::thud_version() }
}

impl World {
    pub fn overlap_shape<F: FnMut(ShapeId) -> bool>(&mut self, center: impl Into<Pos>, shape: Geometry, filter: Option<&QueryFilter>, mut r#fn: F) -> Result<()> {
        self.check(unsafe { sys::thud_world_overlap_shape(self.raw(), center.into(), shape, filter.map_or(std::ptr::null(), |one| one), Some(overlap_fn::<F>), context(&mut r#fn)) })?;
        Ok(())
    }

    pub fn overlap_aabb<F: FnMut(ShapeId) -> bool>(&mut self, lower: impl Into<Pos>, upper: impl Into<Pos>, filter: Option<&QueryFilter>, mut r#fn: F) -> Result<()> {
        self.check(unsafe { sys::thud_world_overlap_aabb(self.raw(), lower.into(), upper.into(), filter.map_or(std::ptr::null(), |one| one), Some(overlap_fn::<F>), context(&mut r#fn)) })?;
        Ok(())
    }

    pub fn closest(&mut self, point: impl Into<Pos>, max_distance: f64, filter: Option<&QueryFilter>) -> Result<Option<ClosestHit>> {
        let mut found = false;
        let mut out = zeroed::<ClosestHit>();
        self.check(unsafe { sys::thud_world_closest(self.raw(), point.into(), max_distance, filter.map_or(std::ptr::null(), |one| one), &mut found, &mut out) })?;
        Ok(found.then_some(out))
    }

    pub fn body_volume(&mut self, id: BodyId, kind: ShapeKind, origin: impl Into<Pos>) -> Result<Volume> {
        let mut out = zeroed::<Volume>();
        self.check(unsafe { sys::thud_body_get_volume(self.raw(), id, kind, origin.into(), &mut out) })?;
        Ok(out)
    }

    pub fn body_contacts(&mut self, id: BodyId) -> Result<Vec<Manifold>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_body_get_contacts(self.raw(), id, out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn shape_set_heights(&mut self, id: ShapeId, first: c_int, heights: &[f64]) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_heights(self.raw(), id, first, heights.as_ptr(), count(heights.len())) })?;
        Ok(())
    }

    pub fn shape_dig(&mut self, id: ShapeId, center: impl Into<Pos>, radius: f64) -> Result<()> {
        self.check(unsafe { sys::thud_shape_dig(self.raw(), id, center.into(), radius) })?;
        Ok(())
    }

    pub fn shape_raise(&mut self, id: ShapeId, x: f64, radius: f64, height: f64) -> Result<()> {
        self.check(unsafe { sys::thud_shape_raise(self.raw(), id, x, radius, height) })?;
        Ok(())
    }

    pub fn shape_replace_range(&mut self, id: ShapeId, x0: f64, x1: f64, points: &[Pos]) -> Result<()> {
        self.check(unsafe { sys::thud_shape_replace_range(self.raw(), id, x0, x1, points.as_ptr(), count(points.len())) })?;
        Ok(())
    }

    pub fn step(&mut self) -> Result<()> {
        self.check(unsafe { sys::thud_world_step(self.raw()) })?;
        Ok(())
    }

    pub fn advance(&mut self, elapsed: f64, max_steps: c_int) -> Result<(c_int, f64)> {
        let mut out_steps = zeroed::<c_int>();
        let mut out_alpha = zeroed::<f64>();
        self.check(unsafe { sys::thud_world_advance(self.raw(), elapsed, max_steps, &mut out_steps, &mut out_alpha) })?;
        Ok((out_steps, out_alpha))
    }

    pub fn set_gravity(&mut self, gravity: impl Into<Vec2>) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_gravity(self.raw(), gravity.into()) })?;
        Ok(())
    }

    pub fn set_time_step(&mut self, time_step: f64) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_time_step(self.raw(), time_step) })?;
        Ok(())
    }

    pub fn set_max_error(&mut self, max_error: f64) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_max_error(self.raw(), max_error) })?;
        Ok(())
    }

    pub fn set_quality(&mut self, quality: &Quality) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_quality(self.raw(), &quality.0) })?;
        Ok(())
    }

    pub fn set_sleeping(&mut self, sleeping: bool) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_sleeping(self.raw(), sleeping) })?;
        Ok(())
    }

    pub fn body_create(&mut self, def: &BodyDef) -> Result<BodyId> {
        let mut out = zeroed::<BodyId>();
        self.check(unsafe { sys::thud_body_create(self.raw(), def, &mut out) })?;
        Ok(out)
    }

    pub fn body_destroy(&mut self, id: BodyId) -> Result<()> {
        self.check(unsafe { sys::thud_body_destroy(self.raw(), id) })?;
        Ok(())
    }

    #[must_use]
    pub fn body_is_valid(&self, id: BodyId) -> bool {
        unsafe { sys::thud_body_is_valid(self.raw(), id) }
    }

    pub fn body_state(&self, id: BodyId) -> Result<BodyState> {
        let mut out = zeroed::<BodyState>();
        self.check(unsafe { sys::thud_body_get_state(self.raw(), id, &mut out) })?;
        Ok(out)
    }

    pub fn body_set_transform(&mut self, id: BodyId, position: impl Into<Pos>, angle: f64) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_transform(self.raw(), id, position.into(), angle) })?;
        Ok(())
    }

    pub fn body_set_velocity(&mut self, id: BodyId, velocity: impl Into<Vec2>, angular_velocity: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_velocity(self.raw(), id, velocity.into(), angular_velocity) })?;
        Ok(())
    }

    pub fn body_apply_impulse(&mut self, id: BodyId, impulse: impl Into<Vec2>, point: impl Into<Pos>) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_impulse(self.raw(), id, impulse.into(), point.into()) })?;
        Ok(())
    }

    pub fn body_apply_center_force(&mut self, id: BodyId, force: impl Into<Vec2>) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_center_force(self.raw(), id, force.into()) })?;
        Ok(())
    }

    pub fn body_apply_torque(&mut self, id: BodyId, torque: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_torque(self.raw(), id, torque) })?;
        Ok(())
    }

    pub fn body_set_awake(&mut self, id: BodyId, awake: bool) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_awake(self.raw(), id, awake) })?;
        Ok(())
    }

    pub fn body_set_enabled(&mut self, id: BodyId, enabled: bool) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_enabled(self.raw(), id, enabled) })?;
        Ok(())
    }

    pub fn body_set_user_data(&mut self, id: BodyId, user_data: u64) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_user_data(self.raw(), id, user_data) })?;
        Ok(())
    }

    pub fn body_shapes(&self, id: BodyId) -> Result<Vec<ShapeId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_body_get_shapes(self.raw(), id, out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn shape_create_circle(&mut self, id: BodyId, def: &ShapeDef, offset: impl Into<Vec2>, radius: f32) -> Result<ShapeId> {
        let mut out = zeroed::<ShapeId>();
        self.check(unsafe { sys::thud_shape_create_circle(self.raw(), id, def, offset.into(), radius, &mut out) })?;
        Ok(out)
    }

    pub fn shape_create_aabb(&mut self, id: BodyId, def: &ShapeDef, offset: impl Into<Vec2>, half_extents: impl Into<Vec2>) -> Result<ShapeId> {
        let mut out = zeroed::<ShapeId>();
        self.check(unsafe { sys::thud_shape_create_aabb(self.raw(), id, def, offset.into(), half_extents.into(), &mut out) })?;
        Ok(out)
    }

    pub fn shape_create_obb(&mut self, id: BodyId, def: &ShapeDef, offset: impl Into<Vec2>, half_extents: impl Into<Vec2>, angle: f64) -> Result<ShapeId> {
        let mut out = zeroed::<ShapeId>();
        self.check(unsafe { sys::thud_shape_create_obb(self.raw(), id, def, offset.into(), half_extents.into(), angle, &mut out) })?;
        Ok(out)
    }

    pub fn shape_create_terrain(&mut self, id: BodyId, def: &ShapeDef, terrain: &Terrain<'_>) -> Result<ShapeId> {
        let mut out = zeroed::<ShapeId>();
        self.check(unsafe { sys::thud_shape_create_terrain(self.raw(), id, def, &terrain.raw, &mut out) })?;
        Ok(out)
    }

    pub fn shape_destroy(&mut self, id: ShapeId) -> Result<()> {
        self.check(unsafe { sys::thud_shape_destroy(self.raw(), id) })?;
        Ok(())
    }

    #[must_use]
    pub fn shape_is_valid(&self, id: ShapeId) -> bool {
        unsafe { sys::thud_shape_is_valid(self.raw(), id) }
    }

    pub fn shape_state(&self, id: ShapeId) -> Result<ShapeState> {
        let mut out = zeroed::<ShapeState>();
        self.check(unsafe { sys::thud_shape_get_state(self.raw(), id, &mut out) })?;
        Ok(out)
    }

    pub fn stats(&self) -> Result<Stats> {
        let mut out = zeroed::<Stats>();
        self.check(unsafe { sys::thud_world_get_stats(self.raw(), &mut out) })?;
        Ok(out)
    }

    pub fn bisection_limit(&mut self) -> Result<f64> {
        let mut out_speed = zeroed::<f64>();
        self.check(unsafe { sys::thud_world_get_bisection_limit(self.raw(), &mut out_speed) })?;
        Ok(out_speed)
    }

    pub fn use_step_error(&mut self) -> Result<()> {
        self.check(unsafe { sys::thud_world_use_step_error(self.raw()) })?;
        Ok(())
    }

    pub fn step_error(&self) -> Result<StepError> {
        let mut out = zeroed::<StepError>();
        self.check(unsafe { sys::thud_world_get_step_error(self.raw(), &mut out) })?;
        Ok(out)
    }

    pub fn measure(&self) -> Result<Measure> {
        let mut out = zeroed::<Measure>();
        self.check(unsafe { sys::thud_world_get_measure(self.raw(), &mut out) })?;
        Ok(out)
    }

    pub fn hash(&self) -> Result<u64> {
        let mut out = zeroed::<u64>();
        self.check(unsafe { sys::thud_world_get_hash(self.raw(), &mut out) })?;
        Ok(out)
    }

    pub fn shape_cast_ray(&mut self, id: ShapeId, origin: impl Into<Pos>, dx: f64, dy: f64) -> Result<Option<RayHit>> {
        let mut found = false;
        let mut out = zeroed::<RayHit>();
        self.check(unsafe { sys::thud_shape_cast_ray(self.raw(), id, origin.into(), dx, dy, &mut found, &mut out) })?;
        Ok(found.then_some(out))
    }

    pub fn shape_contains_point(&mut self, id: ShapeId, point: impl Into<Pos>) -> Result<bool> {
        let mut out_inside = zeroed::<bool>();
        self.check(unsafe { sys::thud_shape_contains_point(self.raw(), id, point.into(), &mut out_inside) })?;
        Ok(out_inside)
    }

    pub fn shape_closest_point(&mut self, id: ShapeId, point: impl Into<Pos>) -> Result<ClosestHit> {
        let mut out = zeroed::<ClosestHit>();
        self.check(unsafe { sys::thud_shape_closest_point(self.raw(), id, point.into(), &mut out) })?;
        Ok(out)
    }

    pub fn shape_bounds(&mut self, id: ShapeId) -> Result<(Pos, Pos)> {
        let mut out_lower = zeroed::<Pos>();
        let mut out_upper = zeroed::<Pos>();
        self.check(unsafe { sys::thud_shape_get_bounds(self.raw(), id, &mut out_lower, &mut out_upper) })?;
        Ok((out_lower, out_upper))
    }

    pub fn shape_set_filter(&mut self, id: ShapeId, filter: Filter) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_filter(self.raw(), id, filter) })?;
        Ok(())
    }

    pub fn shape_set_friction(&mut self, id: ShapeId, friction: f32) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_friction(self.raw(), id, friction) })?;
        Ok(())
    }

    pub fn shape_set_restitution(&mut self, id: ShapeId, restitution: f32) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_restitution(self.raw(), id, restitution) })?;
        Ok(())
    }

    pub fn shape_set_surface_speed(&mut self, id: ShapeId, surface_speed: f32) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_surface_speed(self.raw(), id, surface_speed) })?;
        Ok(())
    }

    pub fn shape_set_density(&mut self, id: ShapeId, density: f32) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_density(self.raw(), id, density) })?;
        Ok(())
    }

    pub fn shape_set_sensor(&mut self, id: ShapeId, sensor: bool) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_sensor(self.raw(), id, sensor) })?;
        Ok(())
    }

    pub fn shape_set_radius(&mut self, id: ShapeId, radius: f32) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_radius(self.raw(), id, radius) })?;
        Ok(())
    }

    pub fn shape_set_half_extents(&mut self, id: ShapeId, half_extents: impl Into<Vec2>) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_half_extents(self.raw(), id, half_extents.into()) })?;
        Ok(())
    }

    pub fn shape_set_events(&mut self, id: ShapeId, events: bool) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_events(self.raw(), id, events) })?;
        Ok(())
    }

    pub fn shape_set_user_data(&mut self, id: ShapeId, user_data: u64) -> Result<()> {
        self.check(unsafe { sys::thud_shape_set_user_data(self.raw(), id, user_data) })?;
        Ok(())
    }

    pub fn body_set_kind(&mut self, id: BodyId, kind: BodyKind) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_kind(self.raw(), id, kind) })?;
        Ok(())
    }

    pub fn body_set_damping(&mut self, id: BodyId, linear: f32, angular: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_damping(self.raw(), id, linear, angular) })?;
        Ok(())
    }

    pub fn body_set_gravity_scale(&mut self, id: BodyId, gravity_scale: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_gravity_scale(self.raw(), id, gravity_scale) })?;
        Ok(())
    }

    pub fn body_set_fixed_rotation(&mut self, id: BodyId, fixed: bool) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_fixed_rotation(self.raw(), id, fixed) })?;
        Ok(())
    }

    pub fn body_set_detection(&mut self, id: BodyId, detection: Option<&'static Detection>) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_detection(self.raw(), id, detection) })?;
        Ok(())
    }

    pub fn body_set_may_sleep(&mut self, id: BodyId, may_sleep: bool) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_may_sleep(self.raw(), id, may_sleep) })?;
        Ok(())
    }

    pub fn body_set_mass(&mut self, id: BodyId, mass: Option<&Mass>) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_mass(self.raw(), id, mass.map_or(std::ptr::null(), |one| one)) })?;
        Ok(())
    }

    pub fn body_apply_force(&mut self, id: BodyId, force: impl Into<Vec2>, point: impl Into<Pos>) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_force(self.raw(), id, force.into(), point.into()) })?;
        Ok(())
    }

    pub fn body_apply_center_impulse(&mut self, id: BodyId, impulse: impl Into<Vec2>) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_center_impulse(self.raw(), id, impulse.into()) })?;
        Ok(())
    }

    pub fn body_apply_angular_impulse(&mut self, id: BodyId, impulse: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_angular_impulse(self.raw(), id, impulse) })?;
        Ok(())
    }

    pub fn body_set_target(&mut self, id: BodyId, position: impl Into<Pos>, angle: f64) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_target(self.raw(), id, position.into(), angle) })?;
        Ok(())
    }

    pub fn body_velocity_at(&self, id: BodyId, point: impl Into<Pos>) -> Result<Vec2> {
        let mut out = zeroed::<Vec2>();
        self.check(unsafe { sys::thud_body_get_velocity_at(self.raw(), id, point.into(), &mut out) })?;
        Ok(out)
    }

    pub fn body_world_point(&self, id: BodyId, point: impl Into<Vec2>) -> Result<Pos> {
        let mut out = zeroed::<Pos>();
        self.check(unsafe { sys::thud_body_get_world_point(self.raw(), id, point.into(), &mut out) })?;
        Ok(out)
    }

    pub fn body_local_point(&self, id: BodyId, point: impl Into<Pos>) -> Result<Vec2> {
        let mut out = zeroed::<Vec2>();
        self.check(unsafe { sys::thud_body_get_local_point(self.raw(), id, point.into(), &mut out) })?;
        Ok(out)
    }

    pub fn body_world_vector(&self, id: BodyId, vector: impl Into<Vec2>) -> Result<Vec2> {
        let mut out = zeroed::<Vec2>();
        self.check(unsafe { sys::thud_body_get_world_vector(self.raw(), id, vector.into(), &mut out) })?;
        Ok(out)
    }

    pub fn body_local_vector(&self, id: BodyId, vector: impl Into<Vec2>) -> Result<Vec2> {
        let mut out = zeroed::<Vec2>();
        self.check(unsafe { sys::thud_body_get_local_vector(self.raw(), id, vector.into(), &mut out) })?;
        Ok(out)
    }

    pub fn explode(&mut self, explosion: &Explosion) -> Result<c_int> {
        let mut out_pushed = zeroed::<c_int>();
        self.check(unsafe { sys::thud_world_explode(self.raw(), explosion, &mut out_pushed) })?;
        Ok(out_pushed)
    }

    pub fn body_apply_wind(&mut self, id: BodyId, wind: impl Into<Vec2>, density: f32, drag: f32, lift: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_wind(self.raw(), id, wind.into(), density, drag, lift) })?;
        Ok(())
    }

    pub fn body_apply_buoyancy(&mut self, id: BodyId, water: &Water) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_buoyancy(self.raw(), id, water) })?;
        Ok(())
    }

    pub fn body_apply_rolling_resistance(&mut self, id: BodyId, coefficient: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_rolling_resistance(self.raw(), id, coefficient) })?;
        Ok(())
    }

    pub fn body_apply_grip(&mut self, id: BodyId, point: impl Into<Vec2>, axis: impl Into<Vec2>, speed: f32, max_force: f32) -> Result<()> {
        self.check(unsafe { sys::thud_body_apply_grip(self.raw(), id, point.into(), axis.into(), speed, max_force) })?;
        Ok(())
    }

    pub fn joint_create(&mut self, def: &JointDef) -> Result<JointId> {
        let mut out = zeroed::<JointId>();
        self.check(unsafe { sys::thud_joint_create(self.raw(), def, &mut out) })?;
        Ok(out)
    }

    pub fn joint_destroy(&mut self, id: JointId) -> Result<()> {
        self.check(unsafe { sys::thud_joint_destroy(self.raw(), id) })?;
        Ok(())
    }

    #[must_use]
    pub fn joint_is_valid(&self, id: JointId) -> bool {
        unsafe { sys::thud_joint_is_valid(self.raw(), id) }
    }

    pub fn joint_state(&self, id: JointId) -> Result<JointState> {
        let mut out = zeroed::<JointState>();
        self.check(unsafe { sys::thud_joint_get_state(self.raw(), id, &mut out) })?;
        Ok(out)
    }

    pub fn joint_def(&self, id: JointId) -> Result<JointDef> {
        let mut out = zeroed::<JointDef>();
        self.check(unsafe { sys::thud_joint_get_def(self.raw(), id, &mut out) })?;
        Ok(out)
    }

    pub fn joint_set_drive(&mut self, id: JointId, direction: Direction, drive: &Drive) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_drive(self.raw(), id, direction, drive) })?;
        Ok(())
    }

    pub fn joint_set_length(&mut self, id: JointId, length: f32) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_length(self.raw(), id, length) })?;
        Ok(())
    }

    pub fn joint_set_enabled(&mut self, id: JointId, enabled: bool) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_enabled(self.raw(), id, enabled) })?;
        Ok(())
    }

    pub fn joint_set_frame(&mut self, id: JointId, side: c_int, frame: JointFrame) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_frame(self.raw(), id, side, frame) })?;
        Ok(())
    }

    pub fn joint_set_breaking(&mut self, id: JointId, force: f32, torque: f32, only_reports: bool) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_breaking(self.raw(), id, force, torque, only_reports) })?;
        Ok(())
    }

    pub fn joint_set_user_data(&mut self, id: JointId, user_data: u64) -> Result<()> {
        self.check(unsafe { sys::thud_joint_set_user_data(self.raw(), id, user_data) })?;
        Ok(())
    }

    pub fn joint_events(&self) -> Result<&[JointEvent]> {
        let (mut data, mut data_count) = (std::ptr::null(), 0);
        self.check(unsafe { sys::thud_world_get_joint_events(self.raw(), &mut data, &mut data_count) })?;
        Ok(unsafe { slice(data, data_count) })
    }

    pub fn joints(&self) -> Result<Vec<JointId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_world_get_joints(self.raw(), out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn body_joints(&self, id: BodyId) -> Result<Vec<JointId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_body_get_joints(self.raw(), id, out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn use_joints(&mut self) -> Result<()> {
        self.check(unsafe { sys::thud_world_use_joints(self.raw()) })?;
        Ok(())
    }

    #[must_use]
    pub fn hinge_at(&self, body_a: BodyId, body_b: BodyId, point: impl Into<Pos>) -> JointDef {
        unsafe { sys::thud_hinge_at(self.raw(), body_a, body_b, point.into()) }
    }

    #[must_use]
    pub fn weld_at(&self, body_a: BodyId, body_b: BodyId, point: impl Into<Pos>) -> JointDef {
        unsafe { sys::thud_weld_at(self.raw(), body_a, body_b, point.into()) }
    }

    #[must_use]
    pub fn slider_at(&self, body_a: BodyId, body_b: BodyId, point: impl Into<Pos>, axis: impl Into<Vec2>) -> JointDef {
        unsafe { sys::thud_slider_at(self.raw(), body_a, body_b, point.into(), axis.into()) }
    }

    #[must_use]
    pub fn wheel_at(&self, body_a: BodyId, body_b: BodyId, point: impl Into<Pos>, axis: impl Into<Vec2>) -> JointDef {
        unsafe { sys::thud_wheel_at(self.raw(), body_a, body_b, point.into(), axis.into()) }
    }

    #[must_use]
    pub fn target_at(&self, body_a: BodyId, body_b: BodyId, point: impl Into<Pos>) -> JointDef {
        unsafe { sys::thud_target_at(self.raw(), body_a, body_b, point.into()) }
    }

    #[must_use]
    pub fn rod_at(&self, body_a: BodyId, body_b: BodyId, from: impl Into<Pos>, to: impl Into<Pos>) -> JointDef {
        unsafe { sys::thud_rod_at(self.raw(), body_a, body_b, from.into(), to.into()) }
    }

    #[must_use]
    pub fn rope_at(&self, body_a: BodyId, body_b: BodyId, from: impl Into<Pos>, to: impl Into<Pos>, length: f32) -> JointDef {
        unsafe { sys::thud_rope_at(self.raw(), body_a, body_b, from.into(), to.into(), length) }
    }

    #[must_use]
    pub fn joint_make(&mut self, def: JointDef) -> JointId {
        unsafe { sys::thud_joint_make(self.raw(), def) }
    }

    pub fn bodies(&self) -> Result<Vec<BodyId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_world_get_bodies(self.raw(), out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn awake_bodies(&self) -> Result<Vec<BodyId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_world_get_awake_bodies(self.raw(), out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn shapes(&self) -> Result<Vec<ShapeId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_world_get_shapes(self.raw(), out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn slot_counts(&self) -> Result<(c_int, c_int)> {
        let mut out_bodies = zeroed::<c_int>();
        let mut out_shapes = zeroed::<c_int>();
        self.check(unsafe { sys::thud_world_get_slot_counts(self.raw(), &mut out_bodies, &mut out_shapes) })?;
        Ok((out_bodies, out_shapes))
    }

    pub fn body_at(&self, slot: c_int) -> Result<BodyId> {
        let mut out = zeroed::<BodyId>();
        self.check(unsafe { sys::thud_world_get_body_at(self.raw(), slot, &mut out) })?;
        Ok(out)
    }

    pub fn shape_at(&self, slot: c_int) -> Result<ShapeId> {
        let mut out = zeroed::<ShapeId>();
        self.check(unsafe { sys::thud_world_get_shape_at(self.raw(), slot, &mut out) })?;
        Ok(out)
    }

    pub fn moved_bodies(&self, seen: &mut [BodySeen]) -> Result<Vec<BodyId>> {
        let (code, list) = list(seen.len(), |out, room, number| unsafe { sys::thud_world_get_moved_bodies(self.raw(), seen.as_mut_ptr(), count(seen.len()), out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn shape_sensor_overlaps(&self, id: ShapeId) -> Result<Vec<ShapeId>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_shape_get_sensor_overlaps(self.raw(), id, out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn pair(&self, shape_a: ShapeId, shape_b: ShapeId) -> Result<Pair> {
        let mut out = zeroed::<Pair>();
        self.check(unsafe { sys::thud_world_get_pair(self.raw(), shape_a, shape_b, &mut out) })?;
        Ok(out)
    }

    #[must_use]
    pub fn next_event_pair(&self, first: u32, second: u32, pair: &mut EventPair) -> bool {
        unsafe { sys::thud_world_next_event_pair(self.raw(), first, second, pair) }
    }

    pub fn body_set_locks(&mut self, id: BodyId, x: bool, y: bool) -> Result<()> {
        self.check(unsafe { sys::thud_body_set_locks(self.raw(), id, x, y) })?;
        Ok(())
    }

    pub fn body_locks(&self, id: BodyId) -> Result<(bool, bool)> {
        let mut out_x = zeroed::<bool>();
        let mut out_y = zeroed::<bool>();
        self.check(unsafe { sys::thud_body_get_locks(self.raw(), id, &mut out_x, &mut out_y) })?;
        Ok((out_x, out_y))
    }

    #[must_use]
    pub fn body_make(&mut self, shape: Geometry, options: Option<&BodyOptions>) -> BodyId {
        unsafe { sys::thud_body_make(self.raw(), shape, options.map_or(std::ptr::null(), |one| one)) }
    }

    pub fn extrapolate(&self, bodies: &[BodyId], seconds: f64) -> Result<Vec<Prediction>> {
        let mut out = vec![zeroed::<Prediction>(); bodies.len()];
        self.check(unsafe { sys::thud_world_extrapolate(self.raw(), bodies.as_ptr(), count(bodies.len()), seconds, out.as_mut_ptr()) })?;
        Ok(out)
    }

    pub fn extrapolate_awake(&self, seconds: f64) -> Result<Vec<Prediction>> {
        let (code, list) = list(16, |out, room, number| unsafe { sys::thud_world_extrapolate_awake(self.raw(), seconds, out, room, number) });
        self.check(code)?;
        Ok(list)
    }

    pub fn predict(&mut self, bodies: &[BodyId], seconds: f64) -> Result<Vec<Prediction>> {
        let mut out = vec![zeroed::<Prediction>(); bodies.len()];
        self.check(unsafe { sys::thud_world_predict(self.raw(), bodies.as_ptr(), count(bodies.len()), seconds, out.as_mut_ptr()) })?;
        Ok(out)
    }

    pub fn body_position(&self, id: BodyId) -> Result<Pos> {
        let mut out_position = zeroed::<Pos>();
        self.check(unsafe { sys::thud_body_get_position(self.raw(), id, &mut out_position) })?;
        Ok(out_position)
    }

    pub fn body_rotation(&self, id: BodyId) -> Result<(f64, f32, f32)> {
        let mut out_angle = zeroed::<f64>();
        let mut out_cosine = zeroed::<f32>();
        let mut out_sine = zeroed::<f32>();
        self.check(unsafe { sys::thud_body_get_rotation(self.raw(), id, &mut out_angle, &mut out_cosine, &mut out_sine) })?;
        Ok((out_angle, out_cosine, out_sine))
    }

    pub fn body_velocity(&self, id: BodyId) -> Result<(Vec2, f32)> {
        let mut out_velocity = zeroed::<Vec2>();
        let mut out_angular_velocity = zeroed::<f32>();
        self.check(unsafe { sys::thud_body_get_velocity(self.raw(), id, &mut out_velocity, &mut out_angular_velocity) })?;
        Ok((out_velocity, out_angular_velocity))
    }

    pub fn body_user_data(&self, id: BodyId) -> Result<u64> {
        let mut out_user_data = zeroed::<u64>();
        self.check(unsafe { sys::thud_body_get_user_data(self.raw(), id, &mut out_user_data) })?;
        Ok(out_user_data)
    }

    pub fn shape_user_data(&self, id: ShapeId) -> Result<u64> {
        let mut out_user_data = zeroed::<u64>();
        self.check(unsafe { sys::thud_shape_get_user_data(self.raw(), id, &mut out_user_data) })?;
        Ok(out_user_data)
    }

    pub fn shape_body(&self, id: ShapeId) -> Result<BodyId> {
        let mut out_body = zeroed::<BodyId>();
        self.check(unsafe { sys::thud_shape_get_body(self.raw(), id, &mut out_body) })?;
        Ok(out_body)
    }

    pub fn broadphase_counts(&self) -> Result<BroadphaseCounts> {
        let mut out = zeroed::<BroadphaseCounts>();
        self.check(unsafe { sys::thud_world_get_broadphase_counts(self.raw(), &mut out) })?;
        Ok(out)
    }

    pub fn set_rule(&mut self, first: u32, second: u32, rule: Option<&Rule>) -> Result<()> {
        self.check(unsafe { sys::thud_world_set_rule(self.raw(), first, second, rule.map_or(std::ptr::null(), |one| one)) })?;
        Ok(())
    }

    pub fn rule(&self, first: u32, second: u32) -> Result<(Rule, bool, bool)> {
        let mut out = zeroed::<Rule>();
        let mut out_is_set = zeroed::<bool>();
        let mut out_reversed = zeroed::<bool>();
        self.check(unsafe { sys::thud_world_get_rule(self.raw(), first, second, &mut out, &mut out_is_set, &mut out_reversed) })?;
        Ok((out, out_is_set, out_reversed))
    }

    pub fn use_rules(&mut self) -> Result<()> {
        self.check(unsafe { sys::thud_world_use_rules(self.raw()) })?;
        Ok(())
    }

    pub fn impulse_events(&self) -> Result<&[ImpulseEvent]> {
        let (mut data, mut data_count) = (std::ptr::null(), 0);
        self.check(unsafe { sys::thud_world_get_impulse_events(self.raw(), &mut data, &mut data_count) })?;
        Ok(unsafe { slice(data, data_count) })
    }

    pub fn snapshot_size(&self) -> Result<usize> {
        let mut out_bytes = zeroed::<usize>();
        self.check(unsafe { sys::thud_world_get_snapshot_size(self.raw(), &mut out_bytes) })?;
        Ok(out_bytes)
    }

    pub fn shape_friction_at(&self, id: ShapeId, x: f64) -> Result<f32> {
        let mut out = zeroed::<f32>();
        self.check(unsafe { sys::thud_shape_get_friction_at(self.raw(), id, x, &mut out) })?;
        Ok(out)
    }

    pub fn use_textures(&mut self) -> Result<()> {
        self.check(unsafe { sys::thud_world_use_textures(self.raw()) })?;
        Ok(())
    }
}
