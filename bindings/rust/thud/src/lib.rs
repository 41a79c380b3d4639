//! Rigid bodies in two dimensions, for games: the C engine, with its bits, for safe Rust.
//!
//! Names: `thud_body_set_velocity(world, body, ...)` is `world.body_set_velocity(body, ...)`,
//! `thud_world_get_stats` is `world.stats()`, and a function without a world keeps its name:
//! `thud::geometry_overlap`. Types are `thud::BodyDef` for `thud_body_def`, and enumerators
//! `thud::BODY_DYNAMIC`. What each does, units, ranges and errors stand in the headers of C.
//!
//! Handles are small and copied freely; one whose object was destroyed is refused. A call that the
//! engine refuses returns an [`Error`] with the engine's reason, and has changed nothing. Poses and
//! events are slices of the world's own memory, and the borrow checker ends them with its next call.
//!
//! A [`World`] may be sent to another thread, and is used by one at a time. A closure that panics
//! inside a call of C ends the program.
//!
//! What takes pointers is not offered to safe code: [`sys`] is the whole interface of C, and
//! [`World::raw`] the pointer that it takes.

use std::cell::RefCell;
use std::ffi::{c_char, c_int, c_void, CStr};
use std::fmt;
use std::marker::PhantomData;
use std::ptr::NonNull;
use std::sync::OnceLock;
use std::time::Instant;

pub use thud_sys as sys;

mod calls;
pub use calls::*;

pub type Result<T> = std::result::Result<T, Error>;

/// A call that the engine refused; it has changed nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    /// [`ERROR_INVALID`] and so on.
    pub code: Code,
    /// The engine's reason, with a value and its range.
    pub message: String,
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

/// The settings of a new world: `WorldDef::default().gravity((0.0, -10.0))`.
#[derive(Clone, Default)]
pub struct WorldDef(sys::thud_world_def);

/// A clock for [`WorldDef::clock`]: the seconds since its first reading.
pub fn monotonic() -> f64 {
    static BEGIN: OnceLock<Instant> = OnceLock::new();
    BEGIN.get_or_init(Instant::now).elapsed().as_secs_f64()
}

/// The context is the address of a function.
unsafe extern "C" fn read_clock(context: *mut c_void) -> f64 {
    std::mem::transmute::<*mut c_void, fn() -> f64>(context)()
}

impl WorldDef {
    /// Times the stages of each step by this clock, in seconds: [`monotonic`], or one of your own. A
    /// `time_budget` needs it. It is read several times a step, by the thread that steps.
    #[must_use]
    pub fn clock(mut self, clock: fn() -> f64) -> Self {
        self.0.clock = Some(read_clock);
        self.0.clock_context = clock as *mut c_void;
        self
    }

    #[must_use]
    pub fn quality(mut self, quality: &'static Quality) -> Self {
        self.0.quality = &quality.0;
        self
    }
}

/// A quality of the engine, of [`quality`].
#[repr(transparent)]
pub struct Quality(sys::thud_quality);

/// A line of ground.
#[derive(Clone)]
pub struct Terrain<'points> {
    raw: sys::thud_terrain,
    points: PhantomData<&'points [Pos]>,
}

impl<'points> Terrain<'points> {
    fn new(kind: TerrainKind, points: &'points [Pos]) -> Self {
        let raw = sys::thud_terrain {
            kind,
            slope: 0.0,
            x0: 0.0,
            spacing: 0.0,
            points: points.as_ptr(),
            count: count(points.len()),
        };
        Self { raw, points: PhantomData }
    }

    /// A straight line without ends: height = slope * x.
    #[must_use]
    pub fn flat(slope: f64) -> Terrain<'static> {
        let mut made = Terrain::new(TERRAIN_FLAT, &[]);
        made.raw.slope = slope;
        made
    }

    /// The heights of these points, at x0, x0 + spacing and so on.
    #[must_use]
    pub fn uniform(x0: f64, spacing: f64, points: &'points [Pos]) -> Self {
        let mut made = Self::new(TERRAIN_UNIFORM, points);
        (made.raw.x0, made.raw.spacing) = (x0, spacing);
        made
    }

    /// Points with strictly increasing x.
    #[must_use]
    pub fn irregular(points: &'points [Pos]) -> Self {
        Self::new(TERRAIN_IRREGULAR, points)
    }
}

/// The whole state of a world, for [`World::restore`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Snapshot(Vec<u8>);

impl Snapshot {
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    /// # Safety
    ///
    /// The bytes are those of a snapshot: the engine checks that they fit, but changed ones may make it
    /// access memory that is not its own.
    #[must_use]
    pub unsafe fn from_bytes(bytes: Vec<u8>) -> Self {
        Self(bytes)
    }
}

type Prologue = Box<dyn FnMut(&Contact, &mut ContactSettings) -> bool + Send>;
type Epilogue = Box<dyn FnMut(&Contact) + Send>;

#[derive(Default)]
struct Listeners {
    prologue: Option<Prologue>,
    epilogue: Option<Epilogue>,
}

/// A world with its bodies, shapes and joints.
pub struct World {
    raw: NonNull<sys::thud_world>,
    message: Box<RefCell<String>>,
    listeners: Box<Listeners>,
}

// All that a world has is its own, and closures that it keeps are Send.
unsafe impl Send for World {}

impl Drop for World {
    fn drop(&mut self) {
        unsafe { sys::thud_world_destroy(self.raw.as_ptr()) }
    }
}

unsafe extern "C" fn keep_message(code: sys::thud_result, message: *const c_char, context: *mut c_void) {
    // With THUD_OK the engine warns of a call that succeeded.
    if code != sys::THUD_OK {
        let kept = &*context.cast::<RefCell<String>>();
        *kept.borrow_mut() = CStr::from_ptr(message).to_string_lossy().into_owned();
    }
}

unsafe extern "C" fn prologue(
    _: *mut sys::thud_world,
    contact: *const Contact,
    settings: *mut ContactSettings,
    context: *mut c_void,
) -> bool {
    let listeners = &mut *context.cast::<Listeners>();
    listeners.prologue.as_mut().map_or(true, |call| call(&*contact, &mut *settings))
}

unsafe extern "C" fn epilogue(_: *mut sys::thud_world, contact: *const Contact, context: *mut c_void) {
    if let Some(call) = (*context.cast::<Listeners>()).epilogue.as_mut() {
        call(&*contact);
    }
}

impl World {
    /// # Errors
    ///
    /// A setting is out of range, or there is no memory.
    pub fn new(def: &WorldDef) -> Result<Self> {
        let message = Box::new(RefCell::new(String::new()));
        let mut def = def.0;
        def.log = Some(keep_message);
        def.log_context = std::ptr::from_ref(&*message).cast_mut().cast();
        let mut raw = std::ptr::null_mut();
        let code = unsafe { sys::thud_world_create(&def, &mut raw) };
        match NonNull::new(raw) {
            Some(raw) => Ok(Self { raw, message, listeners: Box::default() }),
            None => Err(Error { code, message: message.take() }),
        }
    }

    /// The world for calls of [`sys`].
    #[must_use]
    pub fn raw(&self) -> *mut sys::thud_world {
        self.raw.as_ptr()
    }

    fn check(&self, code: sys::thud_result) -> Result<()> {
        if code == sys::THUD_OK {
            return Ok(());
        }
        Err(Error { code, message: self.message.take() })
    }

    /// The poses of all bodies by slot ([`slot`]) between the last two steps, x and y relative to
    /// `origin`; NaN where a slot has no body.
    ///
    /// They end with the world's next call:
    ///
    /// ```compile_fail,E0499
    /// let mut world = thud::World::new(&thud::WorldDef::default()).unwrap();
    /// let poses = world.poses((0.0, 0.0), 1.0).unwrap();
    /// world.step().unwrap();
    /// assert!(poses.is_empty());
    /// ```
    ///
    /// # Errors
    ///
    /// `alpha` is not in [0, 1], the origin is out of range, or there is no memory.
    pub fn poses(&mut self, origin: impl Into<Pos>, alpha: f64) -> Result<&[Pose]> {
        let (mut data, mut number) = (std::ptr::null(), 0);
        let code = unsafe { sys::thud_world_get_poses(self.raw(), origin.into(), alpha, &mut data, &mut number) };
        self.check(code)?;
        Ok(unsafe { slice(data, number) })
    }

    #[must_use]
    pub fn events(&self) -> Events<'_> {
        let mut out = std::mem::MaybeUninit::zeroed();
        unsafe {
            sys::thud_world_get_events(self.raw(), out.as_mut_ptr());
            Events::of(&out.assume_init())
        }
    }

    /// The first shape on the way from `origin` by this displacement.
    ///
    /// # Errors
    ///
    /// A value is out of range.
    pub fn cast_ray(
        &mut self,
        origin: impl Into<Pos>,
        by: impl Into<Pos>,
        filter: Option<&QueryFilter>,
    ) -> Result<Option<RayHit>> {
        let by = by.into();
        let filter = filter.map_or(std::ptr::null(), |one| one);
        let ray = sys::thud_ray { origin: origin.into(), dx: by.x, dy: by.y, filter };
        let (mut hit, mut out) = (false, zeroed());
        self.check(unsafe { sys::thud_world_cast_ray(self.raw(), &ray, &mut hit, &mut out) })?;
        Ok(hit.then_some(out))
    }

    /// # Errors
    ///
    /// There is no memory.
    pub fn snapshot(&self) -> Result<Snapshot> {
        let mut size = 0;
        self.check(unsafe { sys::thud_world_get_snapshot_size(self.raw(), &mut size) })?;
        let mut bytes = vec![0u8; size];
        self.check(unsafe { sys::thud_world_snapshot(self.raw(), bytes.as_mut_ptr().cast(), size, &mut size) })?;
        Ok(Snapshot(bytes))
    }

    /// # Errors
    ///
    /// The snapshot is of a world with other settings, or there is no memory.
    pub fn restore(&mut self, snapshot: &Snapshot) -> Result<()> {
        let bytes = snapshot.bytes();
        self.check(unsafe { sys::thud_world_restore(self.raw(), bytes.as_ptr().cast(), bytes.len()) })
    }

    /// A call before each contact is solved, which may change its surface for this step, or return false
    /// to ignore it; and one after. None: none.
    ///
    /// # Errors
    ///
    /// There is no memory.
    pub fn set_listeners(&mut self, before: Option<Prologue>, after: Option<Epilogue>) -> Result<()> {
        let mut listeners = Box::new(Listeners { prologue: before, epilogue: after });
        let mut given: sys::thud_listeners = unsafe { std::mem::zeroed() };
        given.prologue = listeners.prologue.as_ref().map(|_| prologue as sys::thud_prologue_fn);
        given.epilogue = listeners.epilogue.as_ref().map(|_| epilogue as sys::thud_epilogue_fn);
        given.context = std::ptr::from_mut(&mut *listeners).cast();
        self.check(unsafe { sys::thud_world_set_listeners(self.raw(), &given) })?;
        self.listeners = listeners;
        Ok(())
    }
}

/// The index of a body in [`World::poses`].
#[must_use]
pub fn slot(body: BodyId) -> usize {
    (body.index1 as usize).wrapping_sub(1)
}

// ---- of which calls.rs is made ----

/// A size as C takes it; one that it could not hold is refused there as negative.
fn count(size: usize) -> c_int {
    c_int::try_from(size).unwrap_or(-1)
}

fn context<F>(closure: &mut F) -> *mut c_void {
    std::ptr::from_mut(closure).cast()
}

fn check(code: sys::thud_result) -> Result<()> {
    if code == sys::THUD_OK {
        return Ok(());
    }
    let text = unsafe { CStr::from_ptr(sys::thud_result_text(code)) };
    Err(Error { code, message: text.to_string_lossy().into_owned() })
}

/// Called for numbers, bool and structs of these alone, whose bits may all be zero.
fn zeroed<T: Copy>() -> T {
    unsafe { std::mem::zeroed() }
}

unsafe fn slice<'a, T>(data: *const T, number: c_int) -> &'a [T] {
    match usize::try_from(number) {
        Ok(size) if size > 0 => std::slice::from_raw_parts(data, size),
        _ => &[],
    }
}

/// `call` writes to an array with room for so many, and to the number of all.
fn list<T: Copy>(
    room: usize,
    mut call: impl FnMut(*mut T, c_int, *mut c_int) -> sys::thud_result,
) -> (sys::thud_result, Vec<T>) {
    let mut out = vec![zeroed::<T>(); room];
    loop {
        let mut number = 0;
        let code = call(out.as_mut_ptr(), count(out.len()), &mut number);
        let all = usize::try_from(number).unwrap_or(0);
        if code != sys::THUD_OK || all <= out.len() {
            out.truncate(all);
            return (code, out);
        }
        out.resize(all, zeroed());
    }
}
