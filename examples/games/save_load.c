/* save_load.c: balls are thrown until no crate is left on the ledge. In the middle of a throw the
 * game is saved to a file and loaded into a new world; both continue, and end with the same bits.
 */
#include <stdio.h>
#include <thud/thud_all.h>

enum { CRATES = 12, BALLS = 12, PAUSE = 150 }; /* PAUSE: steps between two throws */
enum { CRATE = 2, FLOOR = 4, BALL = 8 };       /* categories */

typedef struct game {
    thud_world *world;
    thud_body_id crates[CRATES];
    int left, steps;
} game;

static void set_up(game *g) {
    thud_body_options crate = {.kind = THUD_BODY_DYNAMIC, .category = CRATE},
                      floor = {.sensor = true, .category = FLOOR};
    thud_body_make(g->world, thud_aabb_at(12, 2, 2, 0.5), NULL);
    thud_body_make(g->world, thud_aabb_at(0, -3, 100, 1), &floor);
    for (; g->left < CRATES; g->left++) {
        thud_geometry box = thud_obb_at(11 + g->left % 3, 3 + g->left / 3, 0.45, 0.5, 0);
        g->crates[g->left] = thud_body_make(g->world, box, &crate);
    }
}

/* Throws a ball so that it reaches the highest crate after a second. */
static void throw_ball(game *g) {
    thud_pos target = {0, -1e9};
    for (int i = 0; i < CRATES; i++) {
        thud_pos at = thud_position_of(g->world, g->crates[i]);
        if (thud_body_is_valid(g->world, g->crates[i]) && at.y > target.y)
            target = at;
    }
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC,
                              .category = BALL,
                              .density = 2,
                              .velocity = {target.x, target.y - 2 + 5}};
    thud_body_make(g->world, thud_circle_at(0, 2, 0.4), &ball);
}

/* Plays until the step of this number, or until no crate is left. */
static void play(game *g, int steps) {
    for (; g->left > 0 && g->steps < steps; g->steps++) {
        if (g->steps % PAUSE == 0)
            throw_ball(g);
        thud_world_step(g->world);
        for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, FLOOR, CRATE, &m);
             g->left--)
            thud_body_destroy(g->world, m.b.body);
        for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, FLOOR, BALL, &m);)
            thud_body_destroy(g->world, m.b.body);
    }
}

/* Plays a game to its end, prints the result, and returns the world's hash. */
static uint64_t finish(game *g) {
    play(g, PAUSE * BALLS);
    uint64_t hash = thud_hash_of(g->world);
    printf("%d crates left after %d steps, hash %016llx\n", g->left, g->steps,
           (unsigned long long)hash);
    thud_world_destroy(g->world);
    return hash;
}

int main(void) {
    game played = {0}, loaded = {0};
    played.world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    set_up(&played);
    play(&played, 2 * PAUSE + 20);
    thud_world_save(played.world, "save_load.thud", &played, sizeof played);
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    if (thud_world_load(world, "save_load.thud", &loaded, sizeof loaded) != THUD_OK)
        return 1;
    loaded.world = world; /* the file has the address of the world that was saved */
    remove("save_load.thud");
    return finish(&played) != finish(&loaded) || loaded.left > 0;
}
