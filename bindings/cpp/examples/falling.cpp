// falling.cpp: a game loop without a window: a ball falls onto hills, in pictures that come at
// uneven times. Each picture shows where the ball is between the last two steps.
#include <thud/thud.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

struct game {
    // It outlives the world, which calls it.
    struct {
        void operator()(thud_result, const char *message) {
            std::fprintf(stderr, "%s\n", message);
        }
    } log;
    thud::world world;
    thud::body ball;
    int hits = 0;

    bool begin() {
        thud::world_def def = thud::default_world_def();
        thud::connect(def, log);
        world = thud::world(def);

        std::vector<thud::pos> points;
        for (int x = -20; x <= 20; x++) {
            points.push_back({static_cast<double>(x), std::sin(0.5 * x)});
        }
        thud::terrain hills{};
        hills.kind = THUD_TERRAIN_IRREGULAR;
        hills.points = points.data();
        hills.count = static_cast<int>(points.size());
        auto ground = world.create_body();
        bool made = bool(ground->create_terrain(hills));

        thud::body_def moving = thud::default_body_def();
        moving.kind = THUD_BODY_DYNAMIC;
        moving.position = {0.5, 6};
        thud::shape_def bouncy = thud::default_shape_def();
        bouncy.restitution = 0.6f;
        ball = *world.create_body(moving);
        // Whatever failed before is refused here, too.
        return made && ball.create_circle({0, 0}, 0.5f, bouncy);
    }

    // A picture, `seconds` after the one before.
    bool picture(double time, double seconds) {
        auto progress = world.advance(seconds);
        for (const thud::hit_event &hit : world.events().hit) {
            std::printf("         hit at %.1f lengths a second\n", static_cast<double>(hit.speed));
            hits++;
        }
        thud::pose pose =
            world.poses({0, 0}, progress->alpha)[static_cast<std::size_t>(ball.slot())];
        std::printf("%5.3f s  x %.2f  y %.2f\n", time, static_cast<double>(pose.x),
                    static_cast<double>(pose.y));
        return bool(progress);
    }
};

} // namespace

int main() {
    game play;
    if (!play.begin()) {
        return 1;
    }
    // From 144 pictures a second down to 20, as on a display that cannot keep up.
    const double lengths[] = {1.0 / 144, 1.0 / 60, 1.0 / 30, 1.0 / 20};
    double time = 0;
    for (int number = 0; number < 80; number++) {
        double seconds = lengths[number % 4];
        time += seconds;
        if (!play.picture(time, seconds)) {
            return 1;
        }
    }
    return play.hits == 0;
}
