// test_cpp.cpp: what thud.hpp adds to the headers of C: owners, results, spans and callbacks, and
// the golden hashes of scenes that are built with it. Run in the project's folder.
#include <thud/thud.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

static int failures;

static void expect(bool holds, const char *what, int line) {
    if (!holds) {
        std::fprintf(stderr, "line %d: does not hold: %s\n", line, what);
        failures++;
    }
}
#define EXPECT(...) expect(bool(__VA_ARGS__), #__VA_ARGS__, __LINE__)

static thud::body dynamic(thud::world_ref world, double x, double y) {
    thud::body_def def = thud::default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = {x, y};
    return *world.create_body(def);
}

static thud::body fixed(thud::world_ref world, double x, double y) {
    thud::body_def def = thud::default_body_def();
    def.position = {x, y};
    return *world.create_body(def);
}

// ---- golden hashes, of scenes as demo/scenes builds them ----

static thud::world tall_stack() {
    thud::world world(thud::default_world_def());
    EXPECT(fixed(world, 0, -1).create_aabb({0, 0}, {20, 1}));
    for (int row = 0; row < 30; row++) {
        EXPECT(dynamic(world, 0, row + 0.5).create_obb({0, 0}, {0.5f, 0.5f}, 0));
    }
    return world;
}

static thud::world heavy_on_light() {
    thud::world world(thud::default_world_def());
    EXPECT(fixed(world, 0, -1).create_aabb({0, 0}, {24, 1}));
    const int below[] = {1, 10};
    for (int group = 0; group < 2; group++) {
        for (int power = 0; power < 5; power++) {
            for (int row = 0; row <= below[group]; row++) {
                thud::shape_def def = thud::default_shape_def();
                def.density = row == below[group] ? std::pow(10.0f, float(power + 1)) : 1;
                double x = (power + 0.5 + group * 5 - 5) * 4;
                EXPECT(dynamic(world, x, row + 0.5).create_obb({0, 0}, {0.5f, 0.5f}, 0, def));
            }
        }
    }
    return world;
}

static thud::world cradle() {
    thud::world_def weightless = thud::default_world_def();
    weightless.gravity = {0, 0};
    thud::world world(weightless);
    thud::shape_def bouncy = thud::default_shape_def();
    bouncy.friction = 0;
    bouncy.restitution = 1;
    EXPECT(fixed(world, -15.5, 0).create_aabb({0, 0}, {1, 8}, bouncy));
    EXPECT(fixed(world, 15.5, 0).create_aabb({0, 0}, {1, 8}, bouncy));
    for (int row = 1; row <= 3; row++) {
        for (int i = 0; i < 5; i++) {
            bool flying = i < row;
            thud::body_def def = thud::default_body_def();
            def.kind = THUD_BODY_DYNAMIC;
            def.position = {i - 2.0 - 6 * flying, 4.0 * (2 - row)};
            def.velocity = {flying ? 5.0f : 0.0f, 0};
            def.may_sleep = false;
            EXPECT(world.create_body(def)->create_circle({0, 0}, 0.5f, bouncy));
        }
    }
    return world;
}

static void expect_golden(const char *name, thud::world world) {
    char row[64], wanted[64];
    for (int i = 0; i < 120; i++) {
        EXPECT(world.step());
    }
    std::snprintf(wanted, sizeof wanted, "%-16s %016llx\n", name,
                  static_cast<unsigned long long>(world.hash()));
    std::FILE *file = std::fopen("tests/golden/hashes.txt", "r");
    bool found = false;
    while (file && std::fgets(row, sizeof row, file)) {
        found = found || std::strcmp(row, wanted) == 0;
    }
    if (file) {
        std::fclose(file);
    }
    expect(found, name, __LINE__);
}

// ---- owners and results ----

static void worlds_are_moved_and_freed() {
    int blocks = 0;
    struct {
        int *blocks;
        void *allocate(std::size_t bytes) {
            ++*blocks;
            return ::operator new(bytes, std::align_val_t(64));
        }
        void release(void *memory, std::size_t) {
            *blocks -= memory != nullptr;
            ::operator delete(memory, std::align_val_t(64));
        }
    } counted{&blocks};
    thud::world_def def = thud::default_world_def();
    thud::connect(def.allocator, counted);
    {
        thud::world first(def);
        EXPECT(first && blocks > 0);
        thud_world *was = first.get();
        thud::world second(std::move(first));
        EXPECT(!first && second.get() == was);
        first = std::move(second);
        EXPECT(!second && first.get() == was);
        int of_one = blocks;
        auto other = thud::world::create(def);
        EXPECT(other && blocks > of_one);
        first = std::move(*other);
        EXPECT(blocks == of_one && first.get() != was);
    }
    EXPECT(blocks == 0);
    thud::world kept(def);
    thud_world *released = kept.release();
    EXPECT(!kept && blocks > 0);
    thud_world_destroy(released);
    EXPECT(blocks == 0);
}

static void refused_calls_have_a_code_and_are_harmless() {
    char message[128] = "";
    auto log = [&message](thud_result, const char *text) {
        std::snprintf(message, sizeof message, "%s", text);
    };
    thud::world_def def = thud::default_world_def();
    thud::connect(def, log);
    thud::world_def wrong = def;
    wrong.time_step = 2;
    auto refused = thud::world::create(wrong);
    EXPECT(!refused && refused.code == THUD_ERROR_INVALID && !refused.value);
    EXPECT(std::strstr(message, "time_step is 2"));
    EXPECT(std::strcmp(refused.text(), thud_result_text(THUD_ERROR_INVALID)) == 0);
    EXPECT(refused->create_body()->create_circle({0, 0}, 1).code == THUD_ERROR_NULL);
    EXPECT(thud::world().step().code == THUD_ERROR_NULL);

    thud::world world(def);
    thud::shape_def rough = thud::default_shape_def();
    rough.friction = -1;
    thud::body ball = dynamic(world, 0, 5);
    auto shape = ball.create_circle({0, 0}, 1, rough);
    EXPECT(!shape && shape->slot() == -1 && std::strstr(message, "friction is -1"));
    EXPECT(shape->set_friction(1).code == THUD_ERROR_STALE);
    EXPECT(ball.get_state()->position.y == 5);
    EXPECT(ball.is_valid() && world.at(ball.id) == ball && ball != thud::body());
    EXPECT(ball.destroy() && !ball.is_valid());
    thud::result<thud::body_state> state = ball.get_state();
    EXPECT(state.code == THUD_ERROR_STALE && state->position.y == 0 && state->gravity_scale == 0);
    EXPECT(ball.position().y == 0);
    message[0] = 0;
    EXPECT(world.set_log(nullptr));
    EXPECT(!ball.set_awake(true) && message[0] == 0);
}

// ---- spans ----

static void poses_and_events_are_views() {
    thud::world world(thud::default_world_def());
    thud::terrain flat{};
    EXPECT(fixed(world, 0, 0).create_terrain(flat));
    thud::body ball = dynamic(world, 0, 2);
    EXPECT(ball.create_circle({0, 0}, 0.5f));
    int begun = 0;
    float speed = 0;
    for (int i = 0; i < 60; i++) {
        auto progress = world.advance(1.0 / 60);
        EXPECT(progress && progress->steps == 1);
        thud::event_lists events = world.events();
        begun += static_cast<int>(events.begin.size());
        for (const thud::hit_event &hit : events.hit) {
            speed = hit.speed;
        }
    }
    EXPECT(begun == 1 && std::abs(speed - 5.5f) < 0.2f);
    thud::span<const thud::pose> poses = world.poses();
    EXPECT(poses.size() == 2 && poses[std::size_t(ball.slot())].y == float(ball.position().y));
    EXPECT(poses.data() == world.get_poses()->data());
    EXPECT(!world.get_poses({0, 0}, 2) && world.poses({0, 0}, 2).empty());

    // Lists: as many as there is room for, and the number of all.
    std::vector<thud::body_id> all(5);
    EXPECT(*world.get_bodies(all) == 2 && world.at(all[1]) == ball);
    std::array<thud::body_id, 1> one;
    EXPECT(*world.get_bodies(one) == 2 && world.at(one[0]) != ball);
    EXPECT(*world.get_bodies({}) == 2);
}

static void inputs_are_spans_and_objects() {
    thud::world world(thud::default_world_def());
    EXPECT(world.set_quality(thud_quality_high) && world.set_quality(&thud_quality_draft));
    EXPECT(world.set_quality(nullptr).code == THUD_ERROR_NULL);
    thud::shape box = *fixed(world, 0, 0).create_aabb({0, 0}, {1, 1});
    thud::ray rays[] = {{{0, 5}, 0, -9, nullptr}, {{3, 5}, 0, -9, nullptr}};
    thud::ray_hit hits[2] = {};
    EXPECT(world.cast_rays(rays, hits) && world.at(hits[0].shape) == box &&
           hits[1].shape.index1 == 0);
    EXPECT(world.cast_rays(rays, {hits, 1}).code == THUD_ERROR_INVALID);
    auto hit = world.cast_ray(rays[0]);
    EXPECT(hit && *hit && (*hit)->point.y == 1);
    EXPECT(world.cast_ray(rays[1]) && !*world.cast_ray(rays[1]));
    EXPECT(*box.get_body() == *world.at(box.id).get_body());

    auto [lower, upper] = *box.get_bounds();
    EXPECT(lower.x <= -1 && upper.y >= 1);
    auto [sine, cosine] = *thud::sincos(0);
    EXPECT(sine == 0 && cosine == 1);
    auto met = thud::geometry_cast_ray(thud::circle_at(0, 0, 1), {0, 3, 0, -4});
    EXPECT(met && met->fraction == 0.5 && met->ny == 1);
    EXPECT(!thud::geometry_cast_ray(thud::circle_at(9, 0, 1), {0, 3, 0, -4}));
    EXPECT(*thud::volume_contains(thud::aabb_at(0, 0, 2, 2), thud::circle_at(0, 0, 1)));

    std::size_t size = *world.get_snapshot_size();
    std::vector<unsigned char> snapshot(size);
    EXPECT(*world.snapshot(snapshot) == size);
    std::uint64_t before = world.hash();
    thud::body falling = dynamic(world, 9, 9);
    EXPECT(world.step() && world.hash() != before);
    EXPECT(world.restore(snapshot) && world.hash() == before && !falling.is_valid());
}

static void joints_hold() {
    thud::world world(thud::default_world_def());
    thud::body post = fixed(world, 0, 5), door = dynamic(world, 1, 5);
    EXPECT(door.create_obb({0, 0}, {1, 0.1f}, 0));
    thud::joint hinge = world.make_joint(world.hinge_at(post, door, {0, 5}));
    EXPECT(hinge.is_valid());
    for (int i = 0; i < 30; i++) {
        EXPECT(world.step());
    }
    EXPECT(hinge.get_state()->gap < 0.01 && door.position().y < 4.9);
}

// ---- callbacks ----

static void callbacks_are_objects() {
    thud::world world(thud::default_world_def());
    EXPECT(fixed(world, 0, -1).create_aabb({0, 0}, {9, 1}));
    thud::body ball = dynamic(world, 0, 0.6);
    EXPECT(ball.create_circle({0, 0}, 0.5f));

    int seen = 0;
    EXPECT(world.overlap_aabb({-9, -9}, {9, 9}, nullptr, [&seen](thud::shape_id) {
        seen++;
        return true;
    }));
    EXPECT(seen == 2);

    struct {
        int before_count = 0, prologues = 0, epilogues = 0;
        thud::body_id touched{};
        void before(thud::world_ref world) {
            before_count += world.step().code == THUD_ERROR_LOCKED;
        }
        bool prologue(thud::world_ref, const thud::contact &, thud::contact_settings &surface) {
            surface.restitution = 0;
            prologues++;
            return true;
        }
        void epilogue_all(thud::world_ref, thud::span<const thud::contact> contacts) {
            epilogues += static_cast<int>(contacts.size());
            touched = contacts.empty() ? touched : contacts[0].body_b;
        }
    } game;
    thud::listeners listeners{};
    thud::connect(listeners, game);
    EXPECT(!listeners.epilogue && !listeners.prologue_all && listeners.prologue);
    EXPECT(world.set_listeners(listeners));
    thud::step_calls calls{};
    thud::connect(calls, game);
    EXPECT(!calls.after);
    for (int i = 0; i < 30; i++) {
        EXPECT(world.advance_with(1.0 / 60, 1, calls));
    }
    EXPECT(game.before_count == 30 && game.prologues > 10 && game.epilogues > 10);
    EXPECT(world.at(game.touched) == ball);

    // A callable that is kept is not copied: it is the one that counts.
    auto told = [count = 0](thud::world_ref, const thud::contact &, int side) mutable {
        count += side == 1;
        return count;
    };
    auto counting = [&told, total = &seen](thud::world_ref w, const thud::contact &c, int side) {
        *total = told(w, c, side);
    };
    EXPECT(ball.set_epilogue(counting));
    EXPECT(world.step());
    EXPECT(seen == 1);
    EXPECT(ball.set_epilogue(nullptr));
    EXPECT(world.step());
    EXPECT(seen == 1);
}

// Functions of a class with members of the names of callbacks, which a derived class inherits.
struct base_calls {
    int befores = 0, afters = 0;
    void before(int) = delete;
    void before(thud::world_ref) {
        befores++;
    }
    template <class W> void after(W) {
        afters++;
    }
};

static void callbacks_may_be_overloaded_or_templates() {
    thud::world world(thud::default_world_def());
    struct : base_calls {
    } game;
    struct final_calls final : base_calls {
        using base_calls::after;
        void before(thud::world_ref) {
            befores++;
        }
    } last;
    thud::step_calls calls{}, last_calls{};
    thud::connect(calls, game);
    thud::connect(last_calls, last);
    EXPECT(calls.before && calls.after && last_calls.before && !last_calls.after);
    EXPECT(world.advance_with(1.0 / 60, 1, calls) && world.advance_with(1.0 / 60, 1, last_calls));
    EXPECT(game.befores == 1 && game.afters == 1 && last.befores == 1 && last.afters == 0);
}

// ---- what else owns ----

static void pools_and_rollbacks_are_freed() {
    auto pool = thud::threads::create(2);
    EXPECT(pool);
    thud::world_def def = thud::default_world_def();
    def.job_system = pool->job_system();
    EXPECT(def.job_system.workers > 1 && !thud::threads::create(-1));
    thud::world world(def);
    thud::rollback_options options{};
    options.players = 1;
    options.depth = 4;
    options.step = [](thud_world *stepped, const std::uint64_t *, void *) {
        return thud_world_step(stepped);
    };
    auto rollback = thud::rollback::create(world, options);
    EXPECT(rollback && rollback->input(0, 0, 7));
    auto made = rollback->advance();
    EXPECT(made && *made && rollback->progress().steps == 1 && world.stats().steps == 1);
}

int main() {
    expect_golden("tall_stack", tall_stack());
    expect_golden("heavy_on_light", heavy_on_light());
    expect_golden("cradle", cradle());
    worlds_are_moved_and_freed();
    refused_calls_have_a_code_and_are_harmless();
    poses_and_events_are_views();
    inputs_are_spans_and_objects();
    joints_hold();
    callbacks_are_objects();
    callbacks_may_be_overloaded_or_templates();
    pools_and_rollbacks_are_freed();
    return failures != 0;
}
