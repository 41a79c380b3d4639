// thud.hpp: thud for C++17: worlds that free themselves, handles whose operations are members,
// spans of poses and events without a copy, and callbacks that are objects of yours. Nothing is
// compiled but inline calls of the C functions: a program links what it calls, and nothing here
// allocates memory.
//
// Names: thud_body_set_velocity(world, body, ...) is body.set_velocity(...), thud_world_step is
// world.step(), thud_body_create is world.create_body(), and a function without a world keeps its
// name: thud::geometry_overlap. A struct or enum thud_x is thud::x, and enumerators keep their
// names. Units, ranges and errors stand at the C function. A def has its defaults where it is left
// out.
//
// Inputs: a `const T *` of C is an `in<T>`, which takes an object, a pointer or nullptr; a pointer
// and its count are one span, which takes arrays, std::vector and the like.
//
// Results: a call that can fail returns a result<...>. It converts to bool (explicitly); `code` and
// text() say why, and *result is its value, all zero after a failure. So a call on a body that
// could not be created is refused as THUD_ERROR_STALE or THUD_ERROR_NULL, and does no harm. A call
// that may find nothing has a std::optional. With THUD_EXCEPTIONS defined before the include, a
// call that fails throws thud::error. Files with and without it may be linked to one program.
//
// Callbacks: a callable (a lambda) is passed by reference, and called through a function made for
// its type. Calls that keep it (set_...) take no temporary: it must live as long as it may be
// called. An exception that leaves a callback ends the program. connect() fills a struct of
// callbacks, such as thud::listeners, from the members of an object that have the names of its
// fields. They may be overloaded; one that is private, or takes other parameters, does not compile.
// Of a class that is final, or a union, private, overloaded and template members are passed over.
//
// Threads: as in C, one world is used by one thread at a time.
#ifndef THUD_HPP
#define THUD_HPP

// Beside the engine in one file, thud.h is all headers.
#include "thud.h"
#ifndef THUD_ALL_H
#include "thud_all.h"
#endif

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#ifdef THUD_EXCEPTIONS
#include <exception>
#endif

// What creates something: a compiler warns if its result is not used, unless a failure is thrown.
#ifdef THUD_EXCEPTIONS
#define THUD_CREATES
#else
#define THUD_CREATES [[nodiscard]]
#endif

// Parameters have the names that they have in C, which may be names of types here.
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#endif

namespace thud {

// Of different names, so that each file has calls of its own kind.
#ifdef THUD_EXCEPTIONS
inline namespace throwing {
#else
inline namespace returning {
#endif

// ---- made from bindings/api.json by tools/bind_cpp.py: aliases ----

using vec2 = thud_vec2;
using pos = thud_pos;
using broadphase = thud_broadphase;
using detection = thud_detection;
using body_id = thud_body_id;
using shape_id = thud_shape_id;
using debug_draw = thud_debug_draw;
using contact_event = thud_contact_event;
using hit_event = thud_hit_event;
using events = thud_events;
using allocator = thud_allocator;
using shared_stages = thud_shared_stages;
using job_system = thud_job_system;
using island_solver = thud_island_solver;
using quality = thud_quality;
using geometry = thud_geometry;
using segment = thud_segment;
using motion = thud_motion;
using closest = thud_closest;
using contacts = thud_contacts;
using approach = thud_approach;
using terrain = thud_terrain;
using terrain_sample = thud_terrain_sample;
using query_filter = thud_query_filter;
using ray = thud_ray;
using shape_cast = thud_shape_cast;
using ray_hit = thud_ray_hit;
using closest_hit = thud_closest_hit;
using manifold = thud_manifold;
using uv = thud_uv;
using foot = thud_foot;
using contact = thud_contact;
using contact_settings = thud_contact_settings;
using parts = thud_parts;
using world_def = thud_world_def;
using step_calls = thud_step_calls;
using body_def = thud_body_def;
using body_state = thud_body_state;
using filter = thud_filter;
using shape_def = thud_shape_def;
using shape_state = thud_shape_state;
using pose = thud_pose;
using stats = thud_stats;
using step_error = thud_step_error;
using measure = thud_measure;
using approximate_options = thud_approximate_options;
using approximation = thud_approximation;
using capsule = thud_capsule;
using body_shape = thud_body_shape;
using mass = thud_mass;
using explosion = thud_explosion;
using water = thud_water;
using half_plane = thud_half_plane;
using joint_id = thud_joint_id;
using drive = thud_drive;
using joint_frame = thud_joint_frame;
using joint_def = thud_joint_def;
using drive_forces = thud_drive_forces;
using joint_state = thud_joint_state;
using joint_event = thud_joint_event;
using contact_answer = thud_contact_answer;
using listeners = thud_listeners;
using velocities = thud_velocities;
using body_seen = thud_body_seen;
using pair_side = thud_pair_side;
using pair = thud_pair;
using event_pair = thud_event_pair;
using body_options = thud_body_options;
using minkowski = thud_minkowski;
using mover_hit = thud_mover_hit;
using one_way = thud_one_way;
using mover = thud_mover;
using mover_report = thud_mover_report;
using prediction = thud_prediction;
using step_settings = thud_step_settings;
using broadphase_counts = thud_broadphase_counts;
using recorder = thud_recorder;
using recorder_options = thud_recorder_options;
using player = thud_player;
using call_value = thud_call_value;
using played_call = thud_played_call;
using player_options = thud_player_options;
using player_progress = thud_player_progress;
using rollback_options = thud_rollback_options;
using rollback_progress = thud_rollback_progress;
using rollback_difference = thud_rollback_difference;
using rule = thud_rule;
using impulse_event = thud_impulse_event;
using texture = thud_texture;
using style = thud_style;
using shape_kind = thud_shape_kind;
using terrain_kind = thud_terrain_kind;
using body_kind = thud_body_kind;
using stage = thud_stage;
using approximate_kind = thud_approximate_kind;
using cover = thud_cover;
using joint_kind = thud_joint_kind;
using direction = thud_direction;
using contact_part = thud_contact_part;
using rule_kind = thud_rule_kind;
using volume = thud_volume;
// ---- end ----

// ---- spans, inputs and results ----

// Elements in a row that belong to someone else: of a world, until its next call.
template <class T> class span {
    T *data_ = nullptr;
    std::size_t size_ = 0;

  public:
    using element_type = T;
    using value_type = std::remove_cv_t<T>;
    using iterator = T *;

    constexpr span() noexcept = default;
    constexpr span(T *data, std::size_t size) noexcept : data_(data), size_(data ? size : 0) {
    }
    // An array, or whatever has data() and size().
    template <class C, class = std::enable_if_t<
                           std::is_convertible_v<decltype(std::data(std::declval<C &>())), T *>>>
    constexpr span(C &&elements) noexcept : data_(std::data(elements)), size_(std::size(elements)) {
    }

    constexpr T *data() const noexcept {
        return data_;
    }
    constexpr std::size_t size() const noexcept {
        return size_;
    }
    constexpr bool empty() const noexcept {
        return size_ == 0;
    }
    constexpr T *begin() const noexcept {
        return data_;
    }
    constexpr T *end() const noexcept {
        return data_ + size_;
    }
    constexpr T &operator[](std::size_t index) const noexcept {
        return data_[index];
    }
};

// An input that may be an object, a pointer to one, or nullptr where C takes null.
template <class T> class in {
    const T *pointer_;

  public:
    constexpr in(std::nullptr_t) noexcept : pointer_(nullptr) {
    }
    constexpr in(const T *pointer) noexcept : pointer_(pointer) {
    }
    constexpr in(const T &object) noexcept : pointer_(&object) {
    }
    constexpr const T *get() const noexcept {
        return pointer_;
    }
};

// Bytes to read, as thud_bytes: of any container or array of plain elements.
class const_bytes {
    thud_bytes bytes_ = {nullptr, 0};

  public:
    constexpr const_bytes() noexcept = default;
    constexpr const_bytes(const void *data, std::size_t count) noexcept : bytes_{data, count} {
    }
    template <class C, class T = std::remove_pointer_t<decltype(std::data(std::declval<C &>()))>,
              class = std::enable_if_t<!std::is_void_v<T>>>
    constexpr const_bytes(const C &of) noexcept : bytes_{std::data(of), std::size(of) * sizeof(T)} {
        static_assert(std::is_trivially_copyable_v<T>);
    }
    constexpr const void *data() const noexcept {
        return bytes_.data;
    }
    constexpr std::size_t size() const noexcept {
        return bytes_.count;
    }
    constexpr operator thud_bytes() const noexcept {
        return bytes_;
    }
};

// Bytes to write.
class bytes {
    void *data_ = nullptr;
    std::size_t size_ = 0;

  public:
    constexpr bytes() noexcept = default;
    constexpr bytes(void *data, std::size_t size) noexcept : data_(data), size_(size) {
    }
    template <class C, class T = std::remove_pointer_t<decltype(std::data(std::declval<C &>()))>,
              class = std::enable_if_t<!std::is_void_v<T>>>
    constexpr bytes(C &of) noexcept : data_(std::data(of)), size_(std::size(of) * sizeof(T)) {
        static_assert(std::is_trivially_copyable_v<T>);
    }
    constexpr void *data() const noexcept {
        return data_;
    }
    constexpr std::size_t size() const noexcept {
        return size_;
    }
};

namespace detail {
struct unwritten {};
} // namespace detail

// What a call that can fail returns: THUD_OK and a value, or an error and a value of zeros.
template <class T = void> struct result {
    thud_result code;
    T value;

    result() noexcept : code(THUD_OK), value() {
    }
    result(thud_result of, T made) noexcept : code(of), value(std::move(made)) {
    }
    // Of a call of C that is about to write the value, for settle().
    explicit result(detail::unwritten) noexcept {
    }
    // After the call, which writes nothing where it fails.
    void settle(thud_result of) {
        code = of;
        if (of != THUD_OK) {
            value = T();
        }
    }
    explicit operator bool() const noexcept {
        return code == THUD_OK;
    }
    // A short English sentence; the log of the world (thud_world_def.log) is told more.
    const char *text() const noexcept {
        return thud_result_text(code);
    }
    T &operator*() & noexcept {
        return value;
    }
    const T &operator*() const & noexcept {
        return value;
    }
    T &&operator*() && noexcept {
        return std::move(value);
    }
    T *operator->() noexcept {
        return &value;
    }
    const T *operator->() const noexcept {
        return &value;
    }
};

template <> struct result<void> {
    thud_result code = THUD_OK;

    explicit operator bool() const noexcept {
        return code == THUD_OK;
    }
    const char *text() const noexcept {
        return thud_result_text(code);
    }
};

#ifdef THUD_EXCEPTIONS
// A call that the engine refused; it has changed nothing.
class error : public std::exception {
  public:
    thud_result code;

    explicit error(thud_result of) noexcept : code(of) {
    }
    const char *what() const noexcept override {
        return thud_result_text(code);
    }
};
#endif

namespace detail {

inline thud_result check(thud_result code) {
#ifdef THUD_EXCEPTIONS
    if (code != THUD_OK) {
        throw error(code);
    }
#endif
    return code;
}

// A size as C takes it; one that it could not hold is refused there as negative.
inline int count(std::size_t size) noexcept {
    constexpr std::size_t max = static_cast<std::size_t>((std::numeric_limits<int>::max)());
    return size > max ? -1 : static_cast<int>(size);
}

// The address of a callable as the context of a callback.
template <class F> void *context(F &callable) noexcept {
    static_assert(std::is_class_v<F>, "pass a lambda or another object, not a function");
    return const_cast<void *>(static_cast<const void *>(std::addressof(callable)));
}

} // namespace detail

// ---- made from bindings/api.json by tools/bind_cpp.py: classes ----

class world;
struct body;
struct shape;
struct joint;

// Of thud_sincos.
struct sincos_values {
    double sine;
    double cosine;
};

// Of thud_geometry_cast_ray.
struct geometry_cast_ray_values {
    double fraction;
    double nx;
    double ny;
};

// Of thud_terrain_segments.
struct terrain_segments_values {
    int first;
    int last;
};

// Of thud_terrain_cast_ray.
struct terrain_cast_ray_values {
    double fraction;
    double nx;
    double ny;
};

// Of thud_world_advance.
struct world_advance_values {
    int steps;
    double alpha;
};

// Of thud_world_advance_with.
struct world_advance_with_values {
    int steps;
    double alpha;
};

// Of thud_shape_get_bounds.
struct shape_bounds_values {
    thud_pos lower;
    thud_pos upper;
};

// Of thud_geometry_area_below.
struct geometry_area_below_values {
    double area;
    double center_x;
    double center_y;
};

// Of thud_world_get_slot_counts.
struct world_slot_counts_values {
    int bodies;
    int shapes;
};

// Of thud_body_get_locks.
struct body_locks_values {
    bool x;
    bool y;
};

// Of thud_minkowski_distance.
struct minkowski_distance_values {
    double distance;
    double nx;
    double ny;
};

// Of thud_minkowski_cast.
struct minkowski_cast_values {
    double fraction;
    double nx;
    double ny;
};

// Of thud_body_get_rotation.
struct body_rotation_values {
    double angle;
    float cosine;
    float sine;
};

// Of thud_body_get_velocity.
struct body_velocity_values {
    thud_vec2 velocity;
    float angular_velocity;
};

// Of thud_world_get_rule.
struct world_rule_values {
    thud_rule value;
    bool is_set;
    bool reversed;
};

// thud_events as spans.
struct event_lists {
    span<const thud_contact_event> begin;
    span<const thud_contact_event> end;
    span<const thud_contact_event> sensor_begin;
    span<const thud_contact_event> sensor_end;
    span<const float> sensor_begin_time;
    span<const float> sensor_end_time;
    span<const thud_hit_event> hit;
    span<const thud_body_id> quarantined;

    explicit event_lists(const thud_events &of) noexcept
        : begin(of.begin, static_cast<std::size_t>(of.begin_count)),
          end(of.end, static_cast<std::size_t>(of.end_count)),
          sensor_begin(of.sensor_begin, static_cast<std::size_t>(of.sensor_begin_count)),
          sensor_end(of.sensor_end, static_cast<std::size_t>(of.sensor_end_count)),
          sensor_begin_time(of.sensor_begin_time, static_cast<std::size_t>(of.sensor_begin_count)),
          sensor_end_time(of.sensor_end_time, static_cast<std::size_t>(of.sensor_end_count)),
          hit(of.hit, static_cast<std::size_t>(of.hit_count)),
          quarantined(of.quarantined, static_cast<std::size_t>(of.quarantined_count)) {
    }
};

// A body of a world, by its handle: small, copied freely, and no owner. One that was destroyed is
// refused as THUD_ERROR_STALE.
struct body {
    thud_world *world = nullptr;
    thud_body_id id{};

    operator thud_body_id() const noexcept {
        return id;
    }
    // The index of its slot in arrays of the world, or -1 of the null handle.
    int slot() const noexcept {
        return static_cast<int>(id.index1) - 1;
    }
    friend bool operator==(const body &a, const body &b) noexcept {
        return a.world == b.world && a.id.index1 == b.id.index1 &&
               a.id.generation == b.id.generation;
    }
    friend bool operator!=(const body &a, const body &b) noexcept {
        return !(a == b);
    }

    result<thud_volume> get_volume(thud_shape_kind kind, thud_pos origin) const;
    result<int> get_contacts(span<thud_manifold> out) const;
    result<> destroy() const;
    bool is_valid() const;
    result<thud_body_state> get_state() const;
    result<> set_transform(thud_pos position, double angle) const;
    result<> set_velocity(thud_vec2 velocity, float angular_velocity) const;
    result<> apply_impulse(thud_vec2 impulse, thud_pos point) const;
    result<> apply_center_force(thud_vec2 force) const;
    result<> apply_torque(float torque) const;
    result<> set_awake(bool awake) const;
    result<> set_enabled(bool enabled) const;
    result<> set_user_data(uint64_t user_data) const;
    result<int> get_shapes(span<thud_shape_id> out) const;
    THUD_CREATES result<shape> create_circle(
        thud_vec2 offset, float radius, in<thud_shape_def> def = thud_default_shape_def()) const;
    THUD_CREATES result<shape> create_aabb(thud_vec2 offset, thud_vec2 half_extents,
                                           in<thud_shape_def> def = thud_default_shape_def()) const;
    THUD_CREATES result<shape> create_obb(thud_vec2 offset, thud_vec2 half_extents, double angle,
                                          in<thud_shape_def> def = thud_default_shape_def()) const;
    THUD_CREATES result<shape> create_terrain(
        in<thud_terrain> terrain, in<thud_shape_def> def = thud_default_shape_def()) const;
    result<> set_kind(thud_body_kind kind) const;
    result<> set_damping(float linear, float angular) const;
    result<> set_gravity_scale(float gravity_scale) const;
    result<> set_fixed_rotation(bool fixed) const;
    result<> set_detection(in<thud_detection> detection) const;
    result<> set_may_sleep(bool may_sleep) const;
    result<> set_mass(in<thud_mass> mass) const;
    result<> apply_force(thud_vec2 force, thud_pos point) const;
    result<> apply_center_impulse(thud_vec2 impulse) const;
    result<> apply_angular_impulse(float impulse) const;
    result<> set_target(thud_pos position, double angle) const;
    result<thud_vec2> get_velocity_at(thud_pos point) const;
    result<thud_pos> get_world_point(thud_vec2 point) const;
    result<thud_vec2> get_local_point(thud_pos point) const;
    result<thud_vec2> get_world_vector(thud_vec2 vector) const;
    result<thud_vec2> get_local_vector(thud_vec2 vector) const;
    result<> apply_wind(thud_vec2 wind, float density, float drag, float lift) const;
    result<> apply_buoyancy(in<thud_water> water) const;
    result<> apply_rolling_resistance(float coefficient) const;
    result<> apply_grip(thud_vec2 point, thud_vec2 axis, float speed, float max_force) const;
    result<int> get_joints(span<thud_joint_id> out) const;
    template <class F> result<> set_epilogue(F &epilogue) const;
    template <class F> result<> set_epilogue(const F &&) const = delete;
    result<> set_epilogue(std::nullptr_t) const;
    result<> set_locks(bool x, bool y) const;
    result<body_locks_values> get_locks() const;
    result<thud_pos> get_position() const;
    result<body_rotation_values> get_rotation() const;
    result<body_velocity_values> get_velocity() const;
    result<uint64_t> get_user_data() const;
    thud_pos position() const;
    thud_vec2 velocity() const;
};

// A shape of a world, by its handle: small, copied freely, and no owner. One that was destroyed is
// refused as THUD_ERROR_STALE.
struct shape {
    thud_world *world = nullptr;
    thud_shape_id id{};

    operator thud_shape_id() const noexcept {
        return id;
    }
    // The index of its slot in arrays of the world, or -1 of the null handle.
    int slot() const noexcept {
        return static_cast<int>(id.index1) - 1;
    }
    friend bool operator==(const shape &a, const shape &b) noexcept {
        return a.world == b.world && a.id.index1 == b.id.index1 &&
               a.id.generation == b.id.generation;
    }
    friend bool operator!=(const shape &a, const shape &b) noexcept {
        return !(a == b);
    }

    result<> set_heights(int first, span<const double> heights) const;
    result<> dig(thud_pos center, double radius) const;
    result<> raise(double x, double radius, double height) const;
    result<> replace_range(double x0, double x1, span<const thud_pos> points) const;
    result<> destroy() const;
    bool is_valid() const;
    result<thud_shape_state> get_state() const;
    result<thud_terrain> get_terrain() const;
    result<std::optional<thud_ray_hit>> cast_ray(thud_pos origin, double dx, double dy) const;
    result<bool> contains_point(thud_pos point) const;
    result<thud_closest_hit> closest_point(thud_pos point) const;
    result<shape_bounds_values> get_bounds() const;
    result<> set_filter(thud_filter filter) const;
    result<> set_friction(float friction) const;
    result<> set_restitution(float restitution) const;
    result<> set_surface_speed(float surface_speed) const;
    result<> set_density(float density) const;
    result<> set_sensor(bool sensor) const;
    result<> set_radius(float radius) const;
    result<> set_half_extents(thud_vec2 half_extents) const;
    result<> set_events(bool events) const;
    result<> set_user_data(uint64_t user_data) const;
    result<int> get_sensor_overlaps(span<thud_shape_id> out) const;
    result<uint64_t> get_user_data() const;
    result<body> get_body() const;
    result<> set_texture(in<thud_texture> texture) const;
    result<thud_texture> get_texture() const;
    result<float> get_friction_at(double x) const;
};

// A joint of a world, by its handle: small, copied freely, and no owner. One that was destroyed is
// refused as THUD_ERROR_STALE.
struct joint {
    thud_world *world = nullptr;
    thud_joint_id id{};

    operator thud_joint_id() const noexcept {
        return id;
    }
    // The index of its slot in arrays of the world, or -1 of the null handle.
    int slot() const noexcept {
        return static_cast<int>(id.index1) - 1;
    }
    friend bool operator==(const joint &a, const joint &b) noexcept {
        return a.world == b.world && a.id.index1 == b.id.index1 &&
               a.id.generation == b.id.generation;
    }
    friend bool operator!=(const joint &a, const joint &b) noexcept {
        return !(a == b);
    }

    result<> destroy() const;
    bool is_valid() const;
    result<thud_joint_state> get_state() const;
    result<thud_joint_def> get_def() const;
    result<> set_drive(thud_direction direction, in<thud_drive> drive) const;
    result<> set_length(float length) const;
    result<> set_enabled(bool enabled) const;
    result<> set_frame(int side, thud_joint_frame frame) const;
    result<> set_breaking(float force, float torque, bool only_reports) const;
    result<> set_user_data(uint64_t user_data) const;
};

// A world that belongs to someone else, as callbacks get it.
class world_ref {
  protected:
    thud_world *world_ = nullptr;

  public:
    world_ref() noexcept = default;
    world_ref(thud_world *world) noexcept : world_(world) {
    }
    thud_world *get() const noexcept {
        return world_;
    }
    explicit operator bool() const noexcept {
        return world_ != nullptr;
    }
    // The object of a handle.
    thud::body at(thud_body_id id) const noexcept {
        return {world_, id};
    }
    thud::shape at(thud_shape_id id) const noexcept {
        return {world_, id};
    }
    thud::joint at(thud_joint_id id) const noexcept {
        return {world_, id};
    }

    result<> draw(in<thud_debug_draw> draw);
    result<thud_events> get_events() const;
    event_lists events() const;
    result<std::optional<thud_ray_hit>> cast_ray(in<thud_ray> ray);
    result<int> cast_ray_all(in<thud_ray> ray, span<thud_ray_hit> out);
    result<std::optional<thud_ray_hit>> cast_shape(in<thud_shape_cast> cast);
    result<int> cast_shape_all(in<thud_shape_cast> cast, span<thud_ray_hit> out);
    template <class F>
    result<> overlap_shape(thud_pos center, thud_geometry shape, in<thud_query_filter> filter,
                           F &&fn);
    template <class F>
    result<> overlap_aabb(thud_pos lower, thud_pos upper, in<thud_query_filter> filter, F &&fn);
    result<std::optional<thud_closest_hit>> closest(thud_pos point, double max_distance,
                                                    in<thud_query_filter> filter = nullptr);
    result<> step();
    result<world_advance_values> advance(double elapsed, int max_steps = 4);
    result<world_advance_with_values> advance_with(double elapsed, int max_steps,
                                                   in<thud_step_calls> calls = nullptr);
    template <class F> result<> set_log(F &log);
    template <class F> result<> set_log(const F &&) = delete;
    result<> set_log(std::nullptr_t);
    result<> set_gravity(thud_vec2 gravity);
    result<> set_time_step(double time_step);
    result<> set_max_error(double max_error);
    result<> set_quality(in<thud_quality> quality);
    result<> set_sleeping(bool sleeping);
    THUD_CREATES result<body> create_body(in<thud_body_def> def = thud_default_body_def());
    result<span<const thud_pose>> get_poses(thud_pos origin = {}, double alpha = 1.0);
    span<const thud_pose> poses(thud_pos origin = {}, double alpha = 1.0);
    result<thud_stats> get_stats() const;
    thud_stats stats() const;
    result<double> get_bisection_limit();
    result<> use_step_error();
    result<thud_step_error> get_step_error() const;
    thud_step_error step_error() const;
    result<thud_measure> get_measure() const;
    thud_measure measure() const;
    result<uint64_t> get_hash() const;
    uint64_t hash() const;
    template <class F> result<> cast_ray_each(in<thud_ray> ray, F &&fn);
    template <class F> result<> cast_shape_each(in<thud_shape_cast> cast, F &&fn);
    result<> cast_rays(span<const thud_ray> rays, span<thud_ray_hit> out_hits);
    result<> cast_shapes(span<const thud_shape_cast> casts, span<thud_ray_hit> out_hits);
    THUD_CREATES result<body> create_body_with_shapes(
        span<const thud_body_shape> shapes, span<thud_shape_id> out_shape_ids,
        in<thud_body_def> def = thud_default_body_def());
    result<int> explode(in<thud_explosion> explosion);
    THUD_CREATES result<joint> create_joint(in<thud_joint_def> def);
    result<span<const thud_joint_event>> get_joint_events() const;
    span<const thud_joint_event> joint_events() const;
    result<int> get_joints(span<thud_joint_id> out) const;
    result<> use_joints();
    thud_joint_def hinge_at(thud_body_id body_a, thud_body_id body_b, thud_pos point) const;
    thud_joint_def weld_at(thud_body_id body_a, thud_body_id body_b, thud_pos point) const;
    thud_joint_def slider_at(thud_body_id body_a, thud_body_id body_b, thud_pos point,
                             thud_vec2 axis) const;
    thud_joint_def wheel_at(thud_body_id body_a, thud_body_id body_b, thud_pos point,
                            thud_vec2 axis) const;
    thud_joint_def target_at(thud_body_id body_a, thud_body_id body_b, thud_pos point) const;
    thud_joint_def rod_at(thud_body_id body_a, thud_body_id body_b, thud_pos from,
                          thud_pos to) const;
    thud_joint_def rope_at(thud_body_id body_a, thud_body_id body_b, thud_pos from, thud_pos to,
                           float length) const;
    joint make_joint(thud_joint_def def);
    result<> set_listeners(in<thud_listeners> listeners);
    template <class F> result<> set_category_epilogue(uint32_t categories, F &epilogue);
    template <class F> result<> set_category_epilogue(uint32_t categories, const F &&) = delete;
    result<> set_category_epilogue(uint32_t categories, std::nullptr_t);
    result<> decide_contact(in<thud_contact> contact, in<thud_velocities> a, in<thud_velocities> b);
    result<int> get_bodies(span<thud_body_id> out) const;
    result<int> get_awake_bodies(span<thud_body_id> out) const;
    result<int> get_shapes(span<thud_shape_id> out) const;
    result<world_slot_counts_values> get_slot_counts() const;
    result<body> get_body_at(int slot) const;
    result<shape> get_shape_at(int slot) const;
    result<int> get_moved_bodies(span<thud_body_seen> seen, span<thud_body_id> out) const;
    result<thud_pair> get_pair(thud_shape_id shape_a, thud_shape_id shape_b) const;
    bool next_event_pair(uint32_t first, uint32_t second, thud_event_pair &pair) const;
    body make_body(thud_geometry shape, in<thud_body_options> options = nullptr);
    result<thud_mover_report> mover_move(thud_mover &mover, thud_vec2 velocity, double dt);
    result<size_t> pack(const_bytes base, const_bytes snapshot, bytes buffer) const;
    result<size_t> unpack(const_bytes base, const_bytes packed, bytes buffer) const;
    result<> extrapolate(span<const thud_body_id> bodies, double seconds,
                         span<thud_prediction> out) const;
    result<int> extrapolate_awake(double seconds, span<thud_prediction> out) const;
    result<> predict(span<const thud_body_id> bodies, double seconds, span<thud_prediction> out);
    result<thud_step_settings> get_step_settings() const;
    result<thud_broadphase_counts> get_broadphase_counts() const;
    result<> set_rule(uint32_t first, uint32_t second, in<thud_rule> rule);
    result<world_rule_values> get_rule(uint32_t first, uint32_t second) const;
    result<> use_rules();
    template <class F> result<> set_filter(F &filter);
    template <class F> result<> set_filter(const F &&) = delete;
    result<> set_filter(std::nullptr_t);
    result<span<const thud_impulse_event>> get_impulse_events() const;
    span<const thud_impulse_event> impulse_events() const;
    result<size_t> get_snapshot_size() const;
    result<size_t> snapshot(bytes buffer) const;
    result<> restore(const_bytes buffer);
    result<> save(const char *path, const_bytes own);
    result<> load(const char *path, bytes own);
    result<> use_textures();
};

// A world that is destroyed with this object. One that could not be created is false, and refuses
// every call as THUD_ERROR_NULL.
class world : public world_ref {
  public:
    world(std::nullptr_t = nullptr) noexcept {
    }
    explicit world(thud_world *owned) noexcept : world_ref(owned) {
    }
    explicit world(const thud_world_def &def) {
        detail::check(thud_world_create(&def, &world_));
    }
    THUD_CREATES static result<world> create(in<thud_world_def> def) {
        thud_world *made = nullptr;
        thud_result code = detail::check(thud_world_create(def.get(), &made));
        return {code, world(made)};
    }
    world(const world &) = delete;
    world(world &&other) noexcept : world_ref(std::exchange(other.world_, nullptr)) {
    }
    world &operator=(world other) noexcept {
        std::swap(world_, other.world_);
        return *this;
    }
    ~world() {
        thud_world_destroy(world_);
    }
    // The world, which is from now on the caller's to destroy.
    thud_world *release() noexcept {
        return std::exchange(world_, nullptr);
    }
};

// Networked play; destroyed with this object, which its world outlives.
class rollback {
    thud_rollback *rollback_ = nullptr;

  public:
    rollback() noexcept = default;
    THUD_CREATES static result<rollback> create(world_ref world,
                                                in<thud_rollback_options> options) {
        result<rollback> made;
        made.code =
            detail::check(thud_rollback_create(world.get(), options.get(), &made->rollback_));
        return made;
    }
    rollback(const rollback &) = delete;
    rollback(rollback &&other) noexcept : rollback_(std::exchange(other.rollback_, nullptr)) {
    }
    rollback &operator=(rollback other) noexcept {
        std::swap(rollback_, other.rollback_);
        return *this;
    }
    ~rollback() {
        thud_rollback_destroy(rollback_);
    }
    thud_rollback *get() const noexcept {
        return rollback_;
    }
    explicit operator bool() const noexcept {
        return rollback_ != nullptr;
    }

    result<> input(int player, int64_t step, uint64_t input);
    result<bool> advance();
    result<> settle();
    result<thud_rollback_progress> get_progress() const;
    thud_rollback_progress progress() const;
    result<uint64_t> get_state(int64_t step, void *out_state);
    result<size_t> report(int64_t step, bytes buffer);
    result<thud_rollback_difference> compare(const_bytes report);
    result<int64_t> get_lead(int player) const;
    result<> set_lead(int player, int64_t lead);
    result<> leave(int player, int64_t step);
    result<> enter(int player, int64_t step);
    result<size_t> snapshot(bytes buffer);
    result<> restore(const_bytes buffer);
};

// A pool of threads, which outlives the worlds that use it.
class threads {
    thud_threads *threads_ = nullptr;

  public:
    threads() noexcept = default;
    THUD_CREATES static result<threads> create(int workers,
                                               in<thud_allocator> allocator = nullptr) {
        result<threads> made;
        made.code = detail::check(thud_threads_create(workers, allocator.get(), &made->threads_));
        return made;
    }
    threads(const threads &) = delete;
    threads(threads &&other) noexcept : threads_(std::exchange(other.threads_, nullptr)) {
    }
    threads &operator=(threads other) noexcept {
        std::swap(threads_, other.threads_);
        return *this;
    }
    ~threads() {
        thud_threads_destroy(threads_);
    }
    thud_threads *get() const noexcept {
        return threads_;
    }
    explicit operator bool() const noexcept {
        return threads_ != nullptr;
    }

    result<thud_job_system> get_job_system();
    thud_job_system job_system();
};

namespace detail {

template <class F>
void call_log_fn(thud_result result, const char *message, void *context) noexcept {
    return (*static_cast<F *>(context))(result, message);
}

template <class F> bool call_overlap_fn(thud_shape_id shape, void *context) noexcept {
    return (*static_cast<F *>(context))(shape);
}

template <class F> double call_cast_fn(const thud_ray_hit *hit, void *context) noexcept {
    return (*static_cast<F *>(context))(*hit);
}

template <class F>
void call_object_epilogue_fn(thud_world *world, const thud_contact *contact, int side,
                             void *context) noexcept {
    return (*static_cast<F *>(context))(world_ref(world), *contact, side);
}

template <class F>
bool call_filter_fn(const thud_world *world, thud_shape_id shape_a, thud_shape_id shape_b,
                    void *context) noexcept {
    return (*static_cast<F *>(context))(static_cast<const world_ref &>(
                                            world_ref(const_cast<thud_world *>(world))),
                                        shape_a, shape_b);
}

// has_NAME(): whether a class has a member of this name. A class that derives from it and from one
// that has the name as well finds it in both, also where it is overloaded, a template or private.
// None derives from a union or a final class: there a public member that is not overloaded is
// found.
template <class C>
constexpr bool may_be_base = !std::is_final<C>::value && !std::is_union<C>::value;
#define THUD_HAS(NAME)                                                                        \
    struct named_##NAME {                                                                     \
        int NAME;                                                                             \
    };                                                                                        \
    template <class C> struct both_##NAME : C, named_##NAME {};                               \
    template <class C, class = void> struct lacks_##NAME : std::false_type {};                \
    template <class C>                                                                        \
    struct lacks_##NAME<C, std::void_t<decltype(&both_##NAME<C>::NAME)>> : std::true_type {}; \
    template <class C, class = void> struct shows_##NAME : std::false_type {};                \
    template <class C>                                                                        \
    struct shows_##NAME<C, std::void_t<decltype(&C::NAME)>> : std::true_type {};              \
    template <class C> constexpr bool has_##NAME() {                                          \
        using plain = std::remove_cv_t<C>;                                                    \
        if constexpr (may_be_base<plain>)                                                     \
            return !lacks_##NAME<plain>::value;                                               \
        else                                                                                  \
            return shows_##NAME<plain>::value;                                                \
    }
THUD_HAS(circle)
THUD_HAS(box)
THUD_HAS(line)
THUD_HAS(point)
THUD_HAS(allocate)
THUD_HAS(release)
THUD_HAS(run)
THUD_HAS(before)
THUD_HAS(after)
THUD_HAS(prologue)
THUD_HAS(epilogue)
THUD_HAS(prologue_all)
THUD_HAS(epilogue_all)
THUD_HAS(pass)
#undef THUD_HAS

} // namespace detail

// Callbacks that are the members of an object of the same names; the object outlives their use.
template <class C> void connect(thud_debug_draw &callbacks, C &object) noexcept {
    static_assert(detail::has_circle<C>() || detail::has_box<C>() || detail::has_line<C>() ||
                      detail::has_point<C>(),
                  "no member has the name of a callback");
    if constexpr (detail::has_circle<C>()) {
        callbacks.circle = [](thud_vec2 a0, float a1, float a2, float a3, thud_style a4, int a5,
                              void *context) noexcept -> void {
            return static_cast<C *>(context)->circle(a0, a1, a2, a3, a4, a5);
        };
    }
    if constexpr (detail::has_box<C>()) {
        callbacks.box = [](thud_vec2 a0, thud_vec2 a1, float a2, float a3, thud_style a4, int a5,
                           void *context) noexcept -> void {
            return static_cast<C *>(context)->box(a0, a1, a2, a3, a4, a5);
        };
    }
    if constexpr (detail::has_line<C>()) {
        callbacks.line = [](thud_vec2 a0, thud_vec2 a1, thud_style a2,
                            void *context) noexcept -> void {
            return static_cast<C *>(context)->line(a0, a1, a2);
        };
    }
    if constexpr (detail::has_point<C>()) {
        callbacks.point = [](thud_vec2 a0, thud_style a1, void *context) noexcept -> void {
            return static_cast<C *>(context)->point(a0, a1);
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_debug_draw &, const C &&) = delete;

template <class C> void connect(thud_allocator &callbacks, C &object) noexcept {
    static_assert(detail::has_allocate<C>() || detail::has_release<C>(),
                  "no member has the name of a callback");
    if constexpr (detail::has_allocate<C>()) {
        callbacks.allocate = [](size_t a0, void *context) noexcept -> void * {
            return static_cast<C *>(context)->allocate(a0);
        };
    }
    if constexpr (detail::has_release<C>()) {
        callbacks.release = [](void *a0, size_t a1, void *context) noexcept -> void {
            return static_cast<C *>(context)->release(a0, a1);
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_allocator &, const C &&) = delete;

template <class C> void connect(thud_job_system &callbacks, C &object) noexcept {
    static_assert(detail::has_run<C>(), "no member has the name of a callback");
    if constexpr (detail::has_run<C>()) {
        callbacks.run = [](thud_task_fn *task, void *argument, int workers,
                           void *context) noexcept -> void {
            return static_cast<C *>(context)->run(task, argument, workers);
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_job_system &, const C &&) = delete;

template <class C> void connect(thud_step_calls &callbacks, C &object) noexcept {
    static_assert(detail::has_before<C>() || detail::has_after<C>(),
                  "no member has the name of a callback");
    if constexpr (detail::has_before<C>()) {
        callbacks.before = [](thud_world *world, void *context) noexcept -> void {
            return static_cast<C *>(context)->before(world_ref(world));
        };
    }
    if constexpr (detail::has_after<C>()) {
        callbacks.after = [](thud_world *world, void *context) noexcept -> void {
            return static_cast<C *>(context)->after(world_ref(world));
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_step_calls &, const C &&) = delete;

template <class C> void connect(thud_listeners &callbacks, C &object) noexcept {
    static_assert(detail::has_prologue<C>() || detail::has_epilogue<C>() ||
                      detail::has_prologue_all<C>() || detail::has_epilogue_all<C>(),
                  "no member has the name of a callback");
    if constexpr (detail::has_prologue<C>()) {
        callbacks.prologue = [](thud_world *world, const thud_contact *contact,
                                thud_contact_settings *settings, void *context) noexcept -> bool {
            return static_cast<C *>(context)->prologue(world_ref(world), *contact, *settings);
        };
    }
    if constexpr (detail::has_epilogue<C>()) {
        callbacks.epilogue = [](thud_world *world, const thud_contact *contact,
                                void *context) noexcept -> void {
            return static_cast<C *>(context)->epilogue(world_ref(world), *contact);
        };
    }
    if constexpr (detail::has_prologue_all<C>()) {
        callbacks.prologue_all = [](thud_world *world, const thud_contact *contacts,
                                    thud_contact_answer *answers, int count,
                                    void *context) noexcept -> void {
            return static_cast<C *>(context)->prologue_all(
                world_ref(world),
                span<const thud_contact>(contacts, static_cast<std::size_t>(count)),
                span<thud_contact_answer>(answers, static_cast<std::size_t>(count)));
        };
    }
    if constexpr (detail::has_epilogue_all<C>()) {
        callbacks.epilogue_all = [](thud_world *world, const thud_contact *contacts, int count,
                                    void *context) noexcept -> void {
            return static_cast<C *>(context)->epilogue_all(
                world_ref(world),
                span<const thud_contact>(contacts, static_cast<std::size_t>(count)));
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_listeners &, const C &&) = delete;

template <class C> void connect(thud_mover &callbacks, C &object) noexcept {
    static_assert(detail::has_pass<C>(), "no member has the name of a callback");
    if constexpr (detail::has_pass<C>()) {
        callbacks.pass = [](const thud_mover *mover, const thud_mover_hit *hit, thud_vec2 velocity,
                            void *context) noexcept -> bool {
            return static_cast<C *>(context)->pass(*mover, *hit, velocity);
        };
    }
    callbacks.context = detail::context(object);
}
template <class C> void connect(thud_mover &, const C &&) = delete;

// A log for a world that is created, as world.set_log() sets it later.
template <class F> void connect(thud_world_def &def, F &log) noexcept {
    def.log = detail::call_log_fn<F>;
    def.log_context = detail::context(log);
}
template <class F> void connect(thud_world_def &, const F &&) = delete;

inline const char *result_text(thud_result result) {
    return thud_result_text(result);
}

inline result<sincos_values> sincos(double angle) {
    result<sincos_values> made{detail::unwritten()};
    made.settle(detail::check(thud_sincos(angle, &made.value.sine, &made.value.cosine)));
    return made;
}

inline result<double> angle_of(double sine, double cosine) {
    result<double> made{detail::unwritten()};
    made.settle(detail::check(thud_angle_of(sine, cosine, &made.value)));
    return made;
}

inline const char *broadphase_name(in<thud_broadphase> broadphase) {
    return thud_broadphase_name(broadphase.get());
}

inline const char *detection_name(in<thud_detection> detection) {
    return thud_detection_name(detection.get());
}

inline result<> world_ref::draw(in<thud_debug_draw> draw) {
    return {detail::check(thud_world_draw(world_, draw.get()))};
}

inline result<thud_events> world_ref::get_events() const {
    result<thud_events> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_events(world_, &made.value)));
    return made;
}

inline event_lists world_ref::events() const {
    return event_lists(thud_events_of(world_));
}

inline void log_to_stderr(thud_result result, const char *message, void *context) {
    thud_log_to_stderr(result, message, context);
}

inline thud_geometry circle_at(double x, double y, double radius) {
    return thud_circle_at(x, y, radius);
}

inline thud_geometry aabb_at(double x, double y, double half_x, double half_y) {
    return thud_aabb_at(x, y, half_x, half_y);
}

inline thud_geometry obb_at(double x, double y, double half_x, double half_y, double angle) {
    return thud_obb_at(x, y, half_x, half_y, angle);
}

inline result<> geometry_check(in<thud_geometry> shape) {
    return {detail::check(thud_geometry_check(shape.get()))};
}

inline bool geometry_overlap(in<thud_geometry> a, in<thud_geometry> b) {
    return thud_geometry_overlap(a.get(), b.get());
}

inline result<thud_closest> geometry_closest(in<thud_geometry> a, in<thud_geometry> b) {
    result<thud_closest> made{detail::unwritten()};
    made.settle(detail::check(thud_geometry_closest(a.get(), b.get(), &made.value)));
    return made;
}

inline result<thud_contacts> geometry_contacts(in<thud_geometry> a, in<thud_geometry> b,
                                               double margin) {
    result<thud_contacts> made{detail::unwritten()};
    made.settle(detail::check(thud_geometry_contacts(a.get(), b.get(), margin, &made.value)));
    return made;
}

inline std::optional<geometry_cast_ray_values> geometry_cast_ray(in<thud_geometry> shape,
                                                                 thud_segment ray) {
    geometry_cast_ray_values made;
    if (!thud_geometry_cast_ray(shape.get(), ray, &made.fraction, &made.nx, &made.ny)) {
        return std::nullopt;
    }
    return made;
}

inline result<std::optional<double>> geometry_time_of_impact(in<thud_geometry> a,
                                                             thud_motion motion_a,
                                                             in<thud_geometry> b,
                                                             thud_motion motion_b, double target) {
    double made;
    bool found = false;
    thud_result code = detail::check(
        thud_geometry_time_of_impact(a.get(), motion_a, b.get(), motion_b, target, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<thud_approach> geometry_approach(in<thud_geometry> a, thud_motion motion_a,
                                               in<thud_geometry> b, thud_motion motion_b) {
    result<thud_approach> made{detail::unwritten()};
    made.settle(
        detail::check(thud_geometry_approach(a.get(), motion_a, b.get(), motion_b, &made.value)));
    return made;
}

inline result<std::optional<double>> geometry_time_of_collision(in<thud_geometry> a,
                                                                thud_motion motion_a,
                                                                in<thud_geometry> b,
                                                                thud_motion motion_b,
                                                                double tolerance) {
    double made;
    bool found = false;
    thud_result code =
        detail::check(thud_geometry_time_of_collision(a.get(), motion_a, b.get(), motion_b,
                                                      tolerance, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline bool geometry_is_bisectable(in<thud_geometry> a, thud_motion motion_a, in<thud_geometry> b,
                                   thud_motion motion_b) {
    return thud_geometry_is_bisectable(a.get(), motion_a, b.get(), motion_b);
}

inline result<> terrain_check(in<thud_terrain> terrain) {
    return {detail::check(thud_terrain_check(terrain.get()))};
}

inline result<thud_terrain_sample> terrain_sample_at(in<thud_terrain> terrain, double x) {
    result<thud_terrain_sample> made{detail::unwritten()};
    made.settle(detail::check(thud_terrain_sample_at(terrain.get(), x, &made.value)));
    return made;
}

inline terrain_segments_values terrain_segments(in<thud_terrain> terrain, double x_min,
                                                double x_max) {
    terrain_segments_values made{};
    thud_terrain_segments(terrain.get(), x_min, x_max, &made.first, &made.last);
    return made;
}

inline std::optional<terrain_cast_ray_values> terrain_cast_ray(in<thud_terrain> terrain,
                                                               thud_segment ray) {
    terrain_cast_ray_values made;
    if (!thud_terrain_cast_ray(terrain.get(), ray, &made.fraction, &made.nx, &made.ny)) {
        return std::nullopt;
    }
    return made;
}

inline bool terrain_overlap(in<thud_terrain> terrain, in<thud_geometry> shape) {
    return thud_terrain_overlap(terrain.get(), shape.get());
}

inline result<thud_closest> terrain_closest(in<thud_terrain> terrain, in<thud_geometry> shape) {
    result<thud_closest> made{detail::unwritten()};
    made.settle(detail::check(thud_terrain_closest(terrain.get(), shape.get(), &made.value)));
    return made;
}

inline result<thud_contacts> terrain_contacts(in<thud_terrain> terrain, in<thud_geometry> shape,
                                              double margin) {
    result<thud_contacts> made{detail::unwritten()};
    made.settle(
        detail::check(thud_terrain_contacts(terrain.get(), shape.get(), margin, &made.value)));
    return made;
}

inline result<std::optional<double>> terrain_time_of_impact(in<thud_terrain> terrain,
                                                            in<thud_geometry> shape,
                                                            thud_motion motion, double target) {
    double made;
    bool found = false;
    thud_result code = detail::check(
        thud_terrain_time_of_impact(terrain.get(), shape.get(), motion, target, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<std::optional<double>> terrain_time_of_collision(in<thud_terrain> terrain,
                                                               in<thud_geometry> shape,
                                                               thud_motion motion,
                                                               double tolerance) {
    double made;
    bool found = false;
    thud_result code =
        detail::check(thud_terrain_time_of_collision(terrain.get(), shape.get(), motion, tolerance,
                                                     &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<> volume_check(in<thud_volume> volume) {
    return {detail::check(thud_volume_check(volume.get()))};
}

inline result<thud_volume> volume_around_shape(thud_shape_kind kind, in<thud_geometry> shape) {
    result<thud_volume> made{detail::unwritten()};
    made.settle(detail::check(thud_volume_around_shape(kind, shape.get(), &made.value)));
    return made;
}

inline result<thud_volume> volume_around_motion(thud_shape_kind kind, in<thud_geometry> shape,
                                                thud_motion motion) {
    result<thud_volume> made{detail::unwritten()};
    made.settle(detail::check(thud_volume_around_motion(kind, shape.get(), motion, &made.value)));
    return made;
}

inline result<thud_volume> volume_around_points(thud_shape_kind kind, span<const thud_pos> points) {
    result<thud_volume> made{detail::unwritten()};
    made.settle(detail::check(
        thud_volume_around_points(kind, points.data(), detail::count(points.size()), &made.value)));
    return made;
}

inline result<thud_volume> volume_around_terrain(thud_shape_kind kind, in<thud_terrain> terrain,
                                                 double x_min, double x_max) {
    result<thud_volume> made{detail::unwritten()};
    made.settle(
        detail::check(thud_volume_around_terrain(kind, terrain.get(), x_min, x_max, &made.value)));
    return made;
}

inline result<thud_volume> volume_merge(thud_shape_kind kind, in<thud_volume> a,
                                        in<thud_volume> b) {
    result<thud_volume> made{detail::unwritten()};
    made.settle(detail::check(thud_volume_merge(kind, a.get(), b.get(), &made.value)));
    return made;
}

inline result<bool> volumes_overlap(in<thud_volume> a, in<thud_volume> b) {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_volumes_overlap(a.get(), b.get(), &made.value)));
    return made;
}

inline result<bool> volume_contains_point(in<thud_volume> volume, double x, double y) {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_volume_contains_point(volume.get(), x, y, &made.value)));
    return made;
}

inline result<bool> volume_contains(in<thud_volume> outer, in<thud_volume> inner) {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_volume_contains(outer.get(), inner.get(), &made.value)));
    return made;
}

inline thud_query_filter default_query_filter() {
    return thud_default_query_filter();
}

inline result<std::optional<thud_ray_hit>> world_ref::cast_ray(in<thud_ray> ray) {
    thud_ray_hit made;
    bool found = false;
    thud_result code = detail::check(thud_world_cast_ray(world_, ray.get(), &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<int> world_ref::cast_ray_all(in<thud_ray> ray, span<thud_ray_hit> out) {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(thud_world_cast_ray_all(world_, ray.get(), out.data(),
                                                      detail::count(out.size()), &made.value)));
    return made;
}

inline result<std::optional<thud_ray_hit>> world_ref::cast_shape(in<thud_shape_cast> cast) {
    thud_ray_hit made;
    bool found = false;
    thud_result code = detail::check(thud_world_cast_shape(world_, cast.get(), &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<int> world_ref::cast_shape_all(in<thud_shape_cast> cast, span<thud_ray_hit> out) {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(thud_world_cast_shape_all(world_, cast.get(), out.data(),
                                                        detail::count(out.size()), &made.value)));
    return made;
}

template <class F>
result<> world_ref::overlap_shape(thud_pos center, thud_geometry shape,
                                  in<thud_query_filter> filter, F &&fn) {
    return {
        detail::check(thud_world_overlap_shape(world_, center, shape, filter.get(),
                                               detail::call_overlap_fn<std::remove_reference_t<F>>,
                                               detail::context(fn)))};
}

template <class F>
result<> world_ref::overlap_aabb(thud_pos lower, thud_pos upper, in<thud_query_filter> filter,
                                 F &&fn) {
    return {
        detail::check(thud_world_overlap_aabb(world_, lower, upper, filter.get(),
                                              detail::call_overlap_fn<std::remove_reference_t<F>>,
                                              detail::context(fn)))};
}

inline result<std::optional<thud_closest_hit>> world_ref::closest(thud_pos point,
                                                                  double max_distance,
                                                                  in<thud_query_filter> filter) {
    thud_closest_hit made;
    bool found = false;
    thud_result code =
        detail::check(thud_world_closest(world_, point, max_distance, filter.get(), &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<thud_volume> body::get_volume(thud_shape_kind kind, thud_pos origin) const {
    result<thud_volume> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_volume(world, id, kind, origin, &made.value)));
    return made;
}

inline result<int> body::get_contacts(span<thud_manifold> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_body_get_contacts(world, id, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<thud_uv> terrain_texture_at(in<thud_terrain_sample> sample,
                                          span<const thud_uv> vertices) {
    result<thud_uv> made{detail::unwritten()};
    made.settle(
        detail::check(thud_terrain_texture_at(sample.get(), vertices.data(),
                                              detail::count(vertices.size()), &made.value)));
    return made;
}

inline result<thud_foot> terrain_place_foot(in<thud_terrain> terrain, double x, double width) {
    result<thud_foot> made{detail::unwritten()};
    made.settle(detail::check(thud_terrain_place_foot(terrain.get(), x, width, &made.value)));
    return made;
}

inline result<> shape::set_heights(int first, span<const double> heights) const {
    return {detail::check(
        thud_shape_set_heights(world, id, first, heights.data(), detail::count(heights.size())))};
}

inline result<> shape::dig(thud_pos center, double radius) const {
    return {detail::check(thud_shape_dig(world, id, center, radius))};
}

inline result<> shape::raise(double x, double radius, double height) const {
    return {detail::check(thud_shape_raise(world, id, x, radius, height))};
}

inline result<> shape::replace_range(double x0, double x1, span<const thud_pos> points) const {
    return {detail::check(
        thud_shape_replace_range(world, id, x0, x1, points.data(), detail::count(points.size())))};
}

inline thud_world_def default_world_def() {
    return thud_default_world_def();
}

inline thud_world_def default_world_def_of(in<thud_quality> quality) {
    return thud_default_world_def_of(quality.get());
}

inline thud_world_def default_small_world_def(in<thud_quality> quality) {
    return thud_default_small_world_def(quality.get());
}

inline result<> world_ref::step() {
    return {detail::check(thud_world_step(world_))};
}

inline result<world_advance_values> world_ref::advance(double elapsed, int max_steps) {
    result<world_advance_values> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_advance(world_, elapsed, max_steps, &made.value.steps, &made.value.alpha)));
    return made;
}

inline result<world_advance_with_values> world_ref::advance_with(double elapsed, int max_steps,
                                                                 in<thud_step_calls> calls) {
    result<world_advance_with_values> made{detail::unwritten()};
    made.settle(detail::check(thud_world_advance_with(world_, elapsed, max_steps, calls.get(),
                                                      &made.value.steps, &made.value.alpha)));
    return made;
}

template <class F> result<> world_ref::set_log(F &log) {
    return {
        detail::check(thud_world_set_log(world_, detail::call_log_fn<F>, detail::context(log)))};
}

inline result<> world_ref::set_log(std::nullptr_t) {
    return {detail::check(thud_world_set_log(world_, nullptr, nullptr))};
}

inline result<> world_ref::set_gravity(thud_vec2 gravity) {
    return {detail::check(thud_world_set_gravity(world_, gravity))};
}

inline result<> world_ref::set_time_step(double time_step) {
    return {detail::check(thud_world_set_time_step(world_, time_step))};
}

inline result<> world_ref::set_max_error(double max_error) {
    return {detail::check(thud_world_set_max_error(world_, max_error))};
}

inline result<> world_ref::set_quality(in<thud_quality> quality) {
    return {detail::check(thud_world_set_quality(world_, quality.get()))};
}

inline result<> world_ref::set_sleeping(bool sleeping) {
    return {detail::check(thud_world_set_sleeping(world_, sleeping))};
}

inline thud_body_def default_body_def() {
    return thud_default_body_def();
}

inline result<body> world_ref::create_body(in<thud_body_def> def) {
    thud_body_id made{};
    thud_result code = detail::check(thud_body_create(world_, def.get(), &made));
    return {code, {world_, made}};
}

inline result<> body::destroy() const {
    return {detail::check(thud_body_destroy(world, id))};
}

inline bool body::is_valid() const {
    return thud_body_is_valid(world, id);
}

inline result<thud_body_state> body::get_state() const {
    result<thud_body_state> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_state(world, id, &made.value)));
    return made;
}

inline result<> body::set_transform(thud_pos position, double angle) const {
    return {detail::check(thud_body_set_transform(world, id, position, angle))};
}

inline result<> body::set_velocity(thud_vec2 velocity, float angular_velocity) const {
    return {detail::check(thud_body_set_velocity(world, id, velocity, angular_velocity))};
}

inline result<> body::apply_impulse(thud_vec2 impulse, thud_pos point) const {
    return {detail::check(thud_body_apply_impulse(world, id, impulse, point))};
}

inline result<> body::apply_center_force(thud_vec2 force) const {
    return {detail::check(thud_body_apply_center_force(world, id, force))};
}

inline result<> body::apply_torque(float torque) const {
    return {detail::check(thud_body_apply_torque(world, id, torque))};
}

inline result<> body::set_awake(bool awake) const {
    return {detail::check(thud_body_set_awake(world, id, awake))};
}

inline result<> body::set_enabled(bool enabled) const {
    return {detail::check(thud_body_set_enabled(world, id, enabled))};
}

inline result<> body::set_user_data(uint64_t user_data) const {
    return {detail::check(thud_body_set_user_data(world, id, user_data))};
}

inline result<int> body::get_shapes(span<thud_shape_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_body_get_shapes(world, id, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline thud_shape_def default_shape_def() {
    return thud_default_shape_def();
}

inline result<shape> body::create_circle(thud_vec2 offset, float radius,
                                         in<thud_shape_def> def) const {
    thud_shape_id made{};
    thud_result code =
        detail::check(thud_shape_create_circle(world, id, def.get(), offset, radius, &made));
    return {code, {world, made}};
}

inline result<shape> body::create_aabb(thud_vec2 offset, thud_vec2 half_extents,
                                       in<thud_shape_def> def) const {
    thud_shape_id made{};
    thud_result code =
        detail::check(thud_shape_create_aabb(world, id, def.get(), offset, half_extents, &made));
    return {code, {world, made}};
}

inline result<shape> body::create_obb(thud_vec2 offset, thud_vec2 half_extents, double angle,
                                      in<thud_shape_def> def) const {
    thud_shape_id made{};
    thud_result code = detail::check(
        thud_shape_create_obb(world, id, def.get(), offset, half_extents, angle, &made));
    return {code, {world, made}};
}

inline result<shape> body::create_terrain(in<thud_terrain> terrain, in<thud_shape_def> def) const {
    thud_shape_id made{};
    thud_result code =
        detail::check(thud_shape_create_terrain(world, id, def.get(), terrain.get(), &made));
    return {code, {world, made}};
}

inline result<> shape::destroy() const {
    return {detail::check(thud_shape_destroy(world, id))};
}

inline bool shape::is_valid() const {
    return thud_shape_is_valid(world, id);
}

inline result<thud_shape_state> shape::get_state() const {
    result<thud_shape_state> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_get_state(world, id, &made.value)));
    return made;
}

inline result<thud_terrain> shape::get_terrain() const {
    result<thud_terrain> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_get_terrain(world, id, &made.value)));
    return made;
}

inline result<span<const thud_pose>> world_ref::get_poses(thud_pos origin, double alpha) {
    const thud_pose *data = nullptr;
    int count = 0;
    thud_result code = detail::check(thud_world_get_poses(world_, origin, alpha, &data, &count));
    return {code, {data, static_cast<std::size_t>(count)}};
}

inline span<const thud_pose> world_ref::poses(thud_pos origin, double alpha) {
    int count = 0;
    const thud_pose *data = thud_poses_of(world_, origin, alpha, &count);
    return {data, static_cast<std::size_t>(count)};
}

inline const char *stage_name(thud_stage stage) {
    return thud_stage_name(stage);
}

inline result<thud_stats> world_ref::get_stats() const {
    result<thud_stats> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_stats(world_, &made.value)));
    return made;
}

inline thud_stats world_ref::stats() const {
    return thud_stats_of(world_);
}

inline result<double> world_ref::get_bisection_limit() {
    result<double> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_bisection_limit(world_, &made.value)));
    return made;
}

inline result<> world_ref::use_step_error() {
    return {detail::check(thud_world_use_step_error(world_))};
}

inline result<thud_step_error> world_ref::get_step_error() const {
    result<thud_step_error> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_step_error(world_, &made.value)));
    return made;
}

inline thud_step_error world_ref::step_error() const {
    return thud_step_error_of(world_);
}

inline result<thud_measure> world_ref::get_measure() const {
    result<thud_measure> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_measure(world_, &made.value)));
    return made;
}

inline thud_measure world_ref::measure() const {
    return thud_measure_of(world_);
}

inline result<uint64_t> world_ref::get_hash() const {
    result<uint64_t> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_hash(world_, &made.value)));
    return made;
}

inline uint64_t world_ref::hash() const {
    return thud_hash_of(world_);
}

inline result<const char *> polygon_check(span<const thud_pos> points) {
    result<const char *> made{detail::unwritten()};
    made.settle(detail::check(
        thud_polygon_check(points.data(), detail::count(points.size()), &made.value)));
    return made;
}

inline result<thud_approximation> approximate(span<const thud_pos> points,
                                              in<thud_approximate_options> options,
                                              thud_geometry *out_shapes) {
    result<thud_approximation> made{detail::unwritten()};
    made.settle(detail::check(thud_approximate(points.data(), detail::count(points.size()),
                                               options.get(), out_shapes, &made.value)));
    return made;
}

inline result<> capsule_check(in<thud_capsule> capsule) {
    return {detail::check(thud_capsule_check(capsule.get()))};
}

inline result<thud_capsule> capsule_of_motion(in<thud_geometry> circle, thud_motion motion) {
    result<thud_capsule> made{detail::unwritten()};
    made.settle(detail::check(thud_capsule_of_motion(circle.get(), motion, &made.value)));
    return made;
}

inline result<thud_closest> capsule_closest(in<thud_capsule> a, in<thud_geometry> b) {
    result<thud_closest> made{detail::unwritten()};
    made.settle(detail::check(thud_capsule_closest(a.get(), b.get(), &made.value)));
    return made;
}

inline result<thud_closest> capsules_closest(in<thud_capsule> a, in<thud_capsule> b) {
    result<thud_closest> made{detail::unwritten()};
    made.settle(detail::check(thud_capsules_closest(a.get(), b.get(), &made.value)));
    return made;
}

inline result<thud_closest> terrain_capsule_closest(in<thud_terrain> terrain,
                                                    in<thud_capsule> capsule) {
    result<thud_closest> made{detail::unwritten()};
    made.settle(
        detail::check(thud_terrain_capsule_closest(terrain.get(), capsule.get(), &made.value)));
    return made;
}

inline result<std::optional<double>> capsule_time_of_impact(in<thud_capsule> a,
                                                            thud_motion motion_a,
                                                            in<thud_geometry> b,
                                                            thud_motion motion_b, double target) {
    double made;
    bool found = false;
    thud_result code = detail::check(
        thud_capsule_time_of_impact(a.get(), motion_a, b.get(), motion_b, target, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<std::optional<double>> capsules_time_of_impact(in<thud_capsule> a,
                                                             thud_motion motion_a,
                                                             in<thud_capsule> b,
                                                             thud_motion motion_b, double target) {
    double made;
    bool found = false;
    thud_result code = detail::check(
        thud_capsules_time_of_impact(a.get(), motion_a, b.get(), motion_b, target, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<std::optional<double>> terrain_capsule_time_of_impact(in<thud_terrain> terrain,
                                                                    in<thud_capsule> capsule,
                                                                    thud_motion motion,
                                                                    double target) {
    double made;
    bool found = false;
    thud_result code =
        detail::check(thud_terrain_capsule_time_of_impact(terrain.get(), capsule.get(), motion,
                                                          target, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

template <class F> result<> world_ref::cast_ray_each(in<thud_ray> ray, F &&fn) {
    return {detail::check(thud_world_cast_ray_each(world_, ray.get(),
                                                   detail::call_cast_fn<std::remove_reference_t<F>>,
                                                   detail::context(fn)))};
}

template <class F> result<> world_ref::cast_shape_each(in<thud_shape_cast> cast, F &&fn) {
    return {
        detail::check(thud_world_cast_shape_each(world_, cast.get(),
                                                 detail::call_cast_fn<std::remove_reference_t<F>>,
                                                 detail::context(fn)))};
}

inline result<> world_ref::cast_rays(span<const thud_ray> rays, span<thud_ray_hit> out_hits) {
    if (!out_hits.empty() && out_hits.size() < rays.size()) {
        return {detail::check(THUD_ERROR_INVALID)};
    }
    return {detail::check(
        thud_world_cast_rays(world_, rays.data(), detail::count(rays.size()), out_hits.data()))};
}

inline result<> world_ref::cast_shapes(span<const thud_shape_cast> casts,
                                       span<thud_ray_hit> out_hits) {
    if (!out_hits.empty() && out_hits.size() < casts.size()) {
        return {detail::check(THUD_ERROR_INVALID)};
    }
    return {detail::check(thud_world_cast_shapes(world_, casts.data(), detail::count(casts.size()),
                                                 out_hits.data()))};
}

inline result<std::optional<thud_ray_hit>> shape::cast_ray(thud_pos origin, double dx,
                                                           double dy) const {
    thud_ray_hit made;
    bool found = false;
    thud_result code = detail::check(thud_shape_cast_ray(world, id, origin, dx, dy, &found, &made));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline result<bool> shape::contains_point(thud_pos point) const {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_contains_point(world, id, point, &made.value)));
    return made;
}

inline result<thud_closest_hit> shape::closest_point(thud_pos point) const {
    result<thud_closest_hit> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_closest_point(world, id, point, &made.value)));
    return made;
}

inline result<shape_bounds_values> shape::get_bounds() const {
    result<shape_bounds_values> made{detail::unwritten()};
    made.settle(
        detail::check(thud_shape_get_bounds(world, id, &made.value.lower, &made.value.upper)));
    return made;
}

inline result<body> world_ref::create_body_with_shapes(span<const thud_body_shape> shapes,
                                                       span<thud_shape_id> out_shape_ids,
                                                       in<thud_body_def> def) {
    if (!out_shape_ids.empty() && out_shape_ids.size() < shapes.size()) {
        return {detail::check(THUD_ERROR_INVALID), {}};
    }
    thud_body_id made{};
    thud_result code = detail::check(thud_body_create_with_shapes(world_, def.get(), shapes.data(),
                                                                  detail::count(shapes.size()),
                                                                  &made, out_shape_ids.data()));
    return {code, {world_, made}};
}

inline result<> shape::set_filter(thud_filter filter) const {
    return {detail::check(thud_shape_set_filter(world, id, filter))};
}

inline result<> shape::set_friction(float friction) const {
    return {detail::check(thud_shape_set_friction(world, id, friction))};
}

inline result<> shape::set_restitution(float restitution) const {
    return {detail::check(thud_shape_set_restitution(world, id, restitution))};
}

inline result<> shape::set_surface_speed(float surface_speed) const {
    return {detail::check(thud_shape_set_surface_speed(world, id, surface_speed))};
}

inline result<> shape::set_density(float density) const {
    return {detail::check(thud_shape_set_density(world, id, density))};
}

inline result<> shape::set_sensor(bool sensor) const {
    return {detail::check(thud_shape_set_sensor(world, id, sensor))};
}

inline result<> shape::set_radius(float radius) const {
    return {detail::check(thud_shape_set_radius(world, id, radius))};
}

inline result<> shape::set_half_extents(thud_vec2 half_extents) const {
    return {detail::check(thud_shape_set_half_extents(world, id, half_extents))};
}

inline result<> shape::set_events(bool events) const {
    return {detail::check(thud_shape_set_events(world, id, events))};
}

inline result<> shape::set_user_data(uint64_t user_data) const {
    return {detail::check(thud_shape_set_user_data(world, id, user_data))};
}

inline result<> body::set_kind(thud_body_kind kind) const {
    return {detail::check(thud_body_set_kind(world, id, kind))};
}

inline result<> body::set_damping(float linear, float angular) const {
    return {detail::check(thud_body_set_damping(world, id, linear, angular))};
}

inline result<> body::set_gravity_scale(float gravity_scale) const {
    return {detail::check(thud_body_set_gravity_scale(world, id, gravity_scale))};
}

inline result<> body::set_fixed_rotation(bool fixed) const {
    return {detail::check(thud_body_set_fixed_rotation(world, id, fixed))};
}

inline result<> body::set_detection(in<thud_detection> detection) const {
    return {detail::check(thud_body_set_detection(world, id, detection.get()))};
}

inline result<> body::set_may_sleep(bool may_sleep) const {
    return {detail::check(thud_body_set_may_sleep(world, id, may_sleep))};
}

inline result<> body::set_mass(in<thud_mass> mass) const {
    return {detail::check(thud_body_set_mass(world, id, mass.get()))};
}

inline result<> body::apply_force(thud_vec2 force, thud_pos point) const {
    return {detail::check(thud_body_apply_force(world, id, force, point))};
}

inline result<> body::apply_center_impulse(thud_vec2 impulse) const {
    return {detail::check(thud_body_apply_center_impulse(world, id, impulse))};
}

inline result<> body::apply_angular_impulse(float impulse) const {
    return {detail::check(thud_body_apply_angular_impulse(world, id, impulse))};
}

inline result<> body::set_target(thud_pos position, double angle) const {
    return {detail::check(thud_body_set_target(world, id, position, angle))};
}

inline result<thud_vec2> body::get_velocity_at(thud_pos point) const {
    result<thud_vec2> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_velocity_at(world, id, point, &made.value)));
    return made;
}

inline result<thud_pos> body::get_world_point(thud_vec2 point) const {
    result<thud_pos> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_world_point(world, id, point, &made.value)));
    return made;
}

inline result<thud_vec2> body::get_local_point(thud_pos point) const {
    result<thud_vec2> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_local_point(world, id, point, &made.value)));
    return made;
}

inline result<thud_vec2> body::get_world_vector(thud_vec2 vector) const {
    result<thud_vec2> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_world_vector(world, id, vector, &made.value)));
    return made;
}

inline result<thud_vec2> body::get_local_vector(thud_vec2 vector) const {
    result<thud_vec2> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_local_vector(world, id, vector, &made.value)));
    return made;
}

inline thud_explosion default_explosion() {
    return thud_default_explosion();
}

inline result<int> world_ref::explode(in<thud_explosion> explosion) {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(thud_world_explode(world_, explosion.get(), &made.value)));
    return made;
}

inline result<> body::apply_wind(thud_vec2 wind, float density, float drag, float lift) const {
    return {detail::check(thud_body_apply_wind(world, id, wind, density, drag, lift))};
}

inline thud_water default_water() {
    return thud_default_water();
}

inline result<> body::apply_buoyancy(in<thud_water> water) const {
    return {detail::check(thud_body_apply_buoyancy(world, id, water.get()))};
}

inline result<geometry_area_below_values> geometry_area_below(in<thud_geometry> shape,
                                                              thud_half_plane below) {
    result<geometry_area_below_values> made{detail::unwritten()};
    made.settle(
        detail::check(thud_geometry_area_below(shape.get(), below, &made.value.area,
                                               &made.value.center_x, &made.value.center_y)));
    return made;
}

inline result<> body::apply_rolling_resistance(float coefficient) const {
    return {detail::check(thud_body_apply_rolling_resistance(world, id, coefficient))};
}

inline result<> body::apply_grip(thud_vec2 point, thud_vec2 axis, float speed,
                                 float max_force) const {
    return {detail::check(thud_body_apply_grip(world, id, point, axis, speed, max_force))};
}

inline thud_joint_def default_joint_def(thud_joint_kind kind) {
    return thud_default_joint_def(kind);
}

inline result<joint> world_ref::create_joint(in<thud_joint_def> def) {
    thud_joint_id made{};
    thud_result code = detail::check(thud_joint_create(world_, def.get(), &made));
    return {code, {world_, made}};
}

inline result<> joint::destroy() const {
    return {detail::check(thud_joint_destroy(world, id))};
}

inline bool joint::is_valid() const {
    return thud_joint_is_valid(world, id);
}

inline result<thud_joint_state> joint::get_state() const {
    result<thud_joint_state> made{detail::unwritten()};
    made.settle(detail::check(thud_joint_get_state(world, id, &made.value)));
    return made;
}

inline result<thud_joint_def> joint::get_def() const {
    result<thud_joint_def> made{detail::unwritten()};
    made.settle(detail::check(thud_joint_get_def(world, id, &made.value)));
    return made;
}

inline result<> joint::set_drive(thud_direction direction, in<thud_drive> drive) const {
    return {detail::check(thud_joint_set_drive(world, id, direction, drive.get()))};
}

inline result<> joint::set_length(float length) const {
    return {detail::check(thud_joint_set_length(world, id, length))};
}

inline result<> joint::set_enabled(bool enabled) const {
    return {detail::check(thud_joint_set_enabled(world, id, enabled))};
}

inline result<> joint::set_frame(int side, thud_joint_frame frame) const {
    return {detail::check(thud_joint_set_frame(world, id, side, frame))};
}

inline result<> joint::set_breaking(float force, float torque, bool only_reports) const {
    return {detail::check(thud_joint_set_breaking(world, id, force, torque, only_reports))};
}

inline result<> joint::set_user_data(uint64_t user_data) const {
    return {detail::check(thud_joint_set_user_data(world, id, user_data))};
}

inline result<span<const thud_joint_event>> world_ref::get_joint_events() const {
    const thud_joint_event *data = nullptr;
    int count = 0;
    thud_result code = detail::check(thud_world_get_joint_events(world_, &data, &count));
    return {code, {data, static_cast<std::size_t>(count)}};
}

inline span<const thud_joint_event> world_ref::joint_events() const {
    int count = 0;
    const thud_joint_event *data = thud_joint_events_of(world_, &count);
    return {data, static_cast<std::size_t>(count)};
}

inline result<int> world_ref::get_joints(span<thud_joint_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_get_joints(world_, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<int> body::get_joints(span<thud_joint_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_body_get_joints(world, id, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<> world_ref::use_joints() {
    return {detail::check(thud_world_use_joints(world_))};
}

inline thud_joint_def world_ref::hinge_at(thud_body_id body_a, thud_body_id body_b,
                                          thud_pos point) const {
    return thud_hinge_at(world_, body_a, body_b, point);
}

inline thud_joint_def world_ref::weld_at(thud_body_id body_a, thud_body_id body_b,
                                         thud_pos point) const {
    return thud_weld_at(world_, body_a, body_b, point);
}

inline thud_joint_def world_ref::slider_at(thud_body_id body_a, thud_body_id body_b, thud_pos point,
                                           thud_vec2 axis) const {
    return thud_slider_at(world_, body_a, body_b, point, axis);
}

inline thud_joint_def world_ref::wheel_at(thud_body_id body_a, thud_body_id body_b, thud_pos point,
                                          thud_vec2 axis) const {
    return thud_wheel_at(world_, body_a, body_b, point, axis);
}

inline thud_joint_def world_ref::target_at(thud_body_id body_a, thud_body_id body_b,
                                           thud_pos point) const {
    return thud_target_at(world_, body_a, body_b, point);
}

inline thud_joint_def world_ref::rod_at(thud_body_id body_a, thud_body_id body_b, thud_pos from,
                                        thud_pos to) const {
    return thud_rod_at(world_, body_a, body_b, from, to);
}

inline thud_joint_def world_ref::rope_at(thud_body_id body_a, thud_body_id body_b, thud_pos from,
                                         thud_pos to, float length) const {
    return thud_rope_at(world_, body_a, body_b, from, to, length);
}

inline joint world_ref::make_joint(thud_joint_def def) {
    return {world_, thud_joint_make(world_, def)};
}

inline result<> world_ref::set_listeners(in<thud_listeners> listeners) {
    return {detail::check(thud_world_set_listeners(world_, listeners.get()))};
}

template <class F> result<> body::set_epilogue(F &epilogue) const {
    return {detail::check(thud_body_set_epilogue(world, id, detail::call_object_epilogue_fn<F>,
                                                 detail::context(epilogue)))};
}

inline result<> body::set_epilogue(std::nullptr_t) const {
    return {detail::check(thud_body_set_epilogue(world, id, nullptr, nullptr))};
}

template <class F> result<> world_ref::set_category_epilogue(uint32_t categories, F &epilogue) {
    return {detail::check(thud_world_set_category_epilogue(world_, categories,
                                                           detail::call_object_epilogue_fn<F>,
                                                           detail::context(epilogue)))};
}

inline result<> world_ref::set_category_epilogue(uint32_t categories, std::nullptr_t) {
    return {detail::check(thud_world_set_category_epilogue(world_, categories, nullptr, nullptr))};
}

inline result<> world_ref::decide_contact(in<thud_contact> contact, in<thud_velocities> a,
                                          in<thud_velocities> b) {
    return {detail::check(thud_contact_decide(world_, contact.get(), a.get(), b.get()))};
}

inline result<int> world_ref::get_bodies(span<thud_body_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_get_bodies(world_, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<int> world_ref::get_awake_bodies(span<thud_body_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_get_awake_bodies(world_, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<int> world_ref::get_shapes(span<thud_shape_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_get_shapes(world_, out.data(), detail::count(out.size()), &made.value)));
    return made;
}

inline result<world_slot_counts_values> world_ref::get_slot_counts() const {
    result<world_slot_counts_values> made{detail::unwritten()};
    made.settle(
        detail::check(thud_world_get_slot_counts(world_, &made.value.bodies, &made.value.shapes)));
    return made;
}

inline result<body> world_ref::get_body_at(int slot) const {
    thud_body_id made{};
    thud_result code = detail::check(thud_world_get_body_at(world_, slot, &made));
    return {code, {world_, made}};
}

inline result<shape> world_ref::get_shape_at(int slot) const {
    thud_shape_id made{};
    thud_result code = detail::check(thud_world_get_shape_at(world_, slot, &made));
    return {code, {world_, made}};
}

inline result<int> world_ref::get_moved_bodies(span<thud_body_seen> seen,
                                               span<thud_body_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_moved_bodies(world_, seen.data(),
                                                          detail::count(seen.size()), out.data(),
                                                          detail::count(out.size()), &made.value)));
    return made;
}

inline result<int> shape::get_sensor_overlaps(span<thud_shape_id> out) const {
    result<int> made{detail::unwritten()};
    made.settle(
        detail::check(thud_shape_get_sensor_overlaps(world, id, out.data(),
                                                     detail::count(out.size()), &made.value)));
    return made;
}

inline result<thud_pair> world_ref::get_pair(thud_shape_id shape_a, thud_shape_id shape_b) const {
    result<thud_pair> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_pair(world_, shape_a, shape_b, &made.value)));
    return made;
}

inline bool world_ref::next_event_pair(uint32_t first, uint32_t second,
                                       thud_event_pair &pair) const {
    return thud_world_next_event_pair(world_, first, second, &pair);
}

inline result<> body::set_locks(bool x, bool y) const {
    return {detail::check(thud_body_set_locks(world, id, x, y))};
}

inline result<body_locks_values> body::get_locks() const {
    result<body_locks_values> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_locks(world, id, &made.value.x, &made.value.y)));
    return made;
}

inline world make_world(thud_vec2 gravity, in<thud_quality> quality) {
    return world(thud_world_make(gravity, quality.get()));
}

inline body world_ref::make_body(thud_geometry shape, in<thud_body_options> options) {
    return {world_, thud_body_make(world_, shape, options.get())};
}

inline result<thud_minkowski> minkowski_sum(in<thud_geometry> a, in<thud_geometry> b) {
    result<thud_minkowski> made{detail::unwritten()};
    made.settle(detail::check(thud_minkowski_sum(a.get(), b.get(), &made.value)));
    return made;
}

inline result<bool> minkowski_contains(in<thud_minkowski> sum, double x, double y) {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_minkowski_contains(sum.get(), x, y, &made.value)));
    return made;
}

inline result<minkowski_distance_values> minkowski_distance(in<thud_minkowski> sum, double x,
                                                            double y) {
    result<minkowski_distance_values> made{detail::unwritten()};
    made.settle(detail::check(thud_minkowski_distance(sum.get(), x, y, &made.value.distance,
                                                      &made.value.nx, &made.value.ny)));
    return made;
}

inline result<std::optional<minkowski_cast_values>> minkowski_cast(in<thud_minkowski> sum,
                                                                   thud_segment path) {
    minkowski_cast_values made;
    bool found = false;
    thud_result code = detail::check(
        thud_minkowski_cast(sum.get(), path, &found, &made.fraction, &made.nx, &made.ny));
    if (!found) {
        return {code, std::nullopt};
    }
    return {code, made};
}

inline bool mover_passes_one_way(in<thud_mover> mover, in<thud_mover_hit> hit, thud_vec2 velocity,
                                 void *context) {
    return thud_mover_passes_one_way(mover.get(), hit.get(), velocity, context);
}

inline thud_mover default_mover(thud_geometry shape) {
    return thud_default_mover(shape);
}

inline result<thud_mover_report> world_ref::mover_move(thud_mover &mover, thud_vec2 velocity,
                                                       double dt) {
    result<thud_mover_report> made{detail::unwritten()};
    made.settle(detail::check(thud_mover_move(world_, &mover, velocity, dt, &made.value)));
    return made;
}

inline result<size_t> world_ref::pack(const_bytes base, const_bytes snapshot, bytes buffer) const {
    result<size_t> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_pack(world_, base, snapshot, buffer.data(), buffer.size(), &made.value)));
    return made;
}

inline result<size_t> world_ref::unpack(const_bytes base, const_bytes packed, bytes buffer) const {
    result<size_t> made{detail::unwritten()};
    made.settle(detail::check(
        thud_world_unpack(world_, base, packed, buffer.data(), buffer.size(), &made.value)));
    return made;
}

inline result<> world_ref::extrapolate(span<const thud_body_id> bodies, double seconds,
                                       span<thud_prediction> out) const {
    if (!out.empty() && out.size() < bodies.size()) {
        return {detail::check(THUD_ERROR_INVALID)};
    }
    return {
        detail::check(thud_world_extrapolate(world_, bodies.data(), detail::count(bodies.size()),
                                             seconds, out.data()))};
}

inline result<int> world_ref::extrapolate_awake(double seconds, span<thud_prediction> out) const {
    result<int> made{detail::unwritten()};
    made.settle(
        detail::check(thud_world_extrapolate_awake(world_, seconds, out.data(),
                                                   detail::count(out.size()), &made.value)));
    return made;
}

inline result<> world_ref::predict(span<const thud_body_id> bodies, double seconds,
                                   span<thud_prediction> out) {
    if (!out.empty() && out.size() < bodies.size()) {
        return {detail::check(THUD_ERROR_INVALID)};
    }
    return {detail::check(thud_world_predict(world_, bodies.data(), detail::count(bodies.size()),
                                             seconds, out.data()))};
}

inline result<thud_pos> body::get_position() const {
    result<thud_pos> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_position(world, id, &made.value)));
    return made;
}

inline result<body_rotation_values> body::get_rotation() const {
    result<body_rotation_values> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_rotation(world, id, &made.value.angle,
                                                     &made.value.cosine, &made.value.sine)));
    return made;
}

inline result<body_velocity_values> body::get_velocity() const {
    result<body_velocity_values> made{detail::unwritten()};
    made.settle(detail::check(
        thud_body_get_velocity(world, id, &made.value.velocity, &made.value.angular_velocity)));
    return made;
}

inline result<uint64_t> body::get_user_data() const {
    result<uint64_t> made{detail::unwritten()};
    made.settle(detail::check(thud_body_get_user_data(world, id, &made.value)));
    return made;
}

inline result<uint64_t> shape::get_user_data() const {
    result<uint64_t> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_get_user_data(world, id, &made.value)));
    return made;
}

inline result<body> shape::get_body() const {
    thud_body_id made{};
    thud_result code = detail::check(thud_shape_get_body(world, id, &made));
    return {code, {world, made}};
}

inline thud_pos body::position() const {
    return thud_position_of(world, id);
}

inline thud_vec2 body::velocity() const {
    return thud_velocity_of(world, id);
}

inline result<thud_step_settings> world_ref::get_step_settings() const {
    result<thud_step_settings> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_step_settings(world_, &made.value)));
    return made;
}

inline result<thud_broadphase_counts> world_ref::get_broadphase_counts() const {
    result<thud_broadphase_counts> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_broadphase_counts(world_, &made.value)));
    return made;
}

inline result<> rollback::input(int player, int64_t step, uint64_t input) {
    return {detail::check(thud_rollback_input(get(), player, step, input))};
}

inline result<bool> rollback::advance() {
    result<bool> made{detail::unwritten()};
    made.settle(detail::check(thud_rollback_advance(get(), &made.value)));
    return made;
}

inline result<> rollback::settle() {
    return {detail::check(thud_rollback_settle(get()))};
}

inline result<thud_rollback_progress> rollback::get_progress() const {
    result<thud_rollback_progress> made{detail::unwritten()};
    made.settle(detail::check(thud_rollback_get_progress(get(), &made.value)));
    return made;
}

inline thud_rollback_progress rollback::progress() const {
    return thud_progress_of(get());
}

inline result<uint64_t> rollback::get_state(int64_t step, void *out_state) {
    result<uint64_t> made{detail::unwritten()};
    made.settle(detail::check(thud_rollback_get_state(get(), step, &made.value, out_state)));
    return made;
}

inline result<size_t> rollback::report(int64_t step, bytes buffer) {
    result<size_t> made{detail::unwritten()};
    made.settle(detail::check(
        thud_rollback_report(get(), step, buffer.data(), buffer.size(), &made.value)));
    return made;
}

inline result<thud_rollback_difference> rollback::compare(const_bytes report) {
    result<thud_rollback_difference> made{detail::unwritten()};
    made.settle(
        detail::check(thud_rollback_compare(get(), report.data(), report.size(), &made.value)));
    return made;
}

inline result<int64_t> rollback::get_lead(int player) const {
    result<int64_t> made{detail::unwritten()};
    made.settle(detail::check(thud_rollback_get_lead(get(), player, &made.value)));
    return made;
}

inline result<> rollback::set_lead(int player, int64_t lead) {
    return {detail::check(thud_rollback_set_lead(get(), player, lead))};
}

inline result<> rollback::leave(int player, int64_t step) {
    return {detail::check(thud_rollback_leave(get(), player, step))};
}

inline result<> rollback::enter(int player, int64_t step) {
    return {detail::check(thud_rollback_enter(get(), player, step))};
}

inline result<size_t> rollback::snapshot(bytes buffer) {
    result<size_t> made{detail::unwritten()};
    made.settle(
        detail::check(thud_rollback_snapshot(get(), buffer.data(), buffer.size(), &made.value)));
    return made;
}

inline result<> rollback::restore(const_bytes buffer) {
    return {detail::check(thud_rollback_restore(get(), buffer.data(), buffer.size()))};
}

inline thud_rule default_rule() {
    return thud_default_rule();
}

inline result<> world_ref::set_rule(uint32_t first, uint32_t second, in<thud_rule> rule) {
    return {detail::check(thud_world_set_rule(world_, first, second, rule.get()))};
}

inline result<world_rule_values> world_ref::get_rule(uint32_t first, uint32_t second) const {
    result<world_rule_values> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_rule(world_, first, second, &made.value.value,
                                                  &made.value.is_set, &made.value.reversed)));
    return made;
}

inline result<> world_ref::use_rules() {
    return {detail::check(thud_world_use_rules(world_))};
}

template <class F> result<> world_ref::set_filter(F &filter) {
    return {detail::check(
        thud_world_set_filter(world_, detail::call_filter_fn<F>, detail::context(filter)))};
}

inline result<> world_ref::set_filter(std::nullptr_t) {
    return {detail::check(thud_world_set_filter(world_, nullptr, nullptr))};
}

inline result<span<const thud_impulse_event>> world_ref::get_impulse_events() const {
    const thud_impulse_event *data = nullptr;
    int count = 0;
    thud_result code = detail::check(thud_world_get_impulse_events(world_, &data, &count));
    return {code, {data, static_cast<std::size_t>(count)}};
}

inline span<const thud_impulse_event> world_ref::impulse_events() const {
    int count = 0;
    const thud_impulse_event *data = thud_impulse_events_of(world_, &count);
    return {data, static_cast<std::size_t>(count)};
}

inline result<size_t> world_ref::get_snapshot_size() const {
    result<size_t> made{detail::unwritten()};
    made.settle(detail::check(thud_world_get_snapshot_size(world_, &made.value)));
    return made;
}

inline result<size_t> world_ref::snapshot(bytes buffer) const {
    result<size_t> made{detail::unwritten()};
    made.settle(
        detail::check(thud_world_snapshot(world_, buffer.data(), buffer.size(), &made.value)));
    return made;
}

inline result<> world_ref::restore(const_bytes buffer) {
    return {detail::check(thud_world_restore(world_, buffer.data(), buffer.size()))};
}

inline result<> world_ref::save(const char *path, const_bytes own) {
    return {detail::check(thud_world_save(world_, path, own.data(), own.size()))};
}

inline result<> world_ref::load(const char *path, bytes own) {
    return {detail::check(thud_world_load(world_, path, own.data(), own.size()))};
}

inline result<> world_def_set_baseline_simd(thud_world_def &def, bool baseline_simd) {
    return {detail::check(thud_world_def_set_baseline_simd(&def, baseline_simd))};
}

inline result<float> texture_friction_at(in<thud_texture> texture, in<thud_terrain_sample> sample) {
    result<float> made{detail::unwritten()};
    made.settle(detail::check(thud_texture_friction_at(texture.get(), sample.get(), &made.value)));
    return made;
}

inline result<> shape::set_texture(in<thud_texture> texture) const {
    return {detail::check(thud_shape_set_texture(world, id, texture.get()))};
}

inline result<thud_texture> shape::get_texture() const {
    result<thud_texture> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_get_texture(world, id, &made.value)));
    return made;
}

inline result<float> shape::get_friction_at(double x) const {
    result<float> made{detail::unwritten()};
    made.settle(detail::check(thud_shape_get_friction_at(world, id, x, &made.value)));
    return made;
}

inline result<> world_ref::use_textures() {
    return {detail::check(thud_world_use_textures(world_))};
}

inline result<thud_job_system> threads::get_job_system() {
    result<thud_job_system> made{detail::unwritten()};
    made.settle(detail::check(thud_threads_get_job_system(get(), &made.value)));
    return made;
}

inline thud_job_system threads::job_system() {
    return thud_job_system_of(get());
}

inline int version() {
    return thud_version();
}

// ---- end ----

} // inline namespace
} // namespace thud

#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif
#undef THUD_CREATES

#endif
