/* save_load.c: throw balls until no crate is left on the ledge. In the middle of a throw the game
 * is saved to a file and loaded into a new world, and both go on alike, to the last bit. Nothing is
 * kept beside the world: its lists and statistics tell what the game must know. */
#include <stdio.h>
#include <stdlib.h>
#include <thud/thud.h>
#include <thud/thud_edits.h>
#include <thud/thud_lists.h>
#include <thud/thud_snapshot.h>

enum { CRATE = 1, CRATES = 12, BALLS = 12, BODIES = CRATES + BALLS + 2 };
enum { PAUSE = 150 }; /* steps from throw to throw */

static void add_box(thud_world *world, thud_body_kind kind, double x, double y, float half_x,
                    float half_y, bool sensor) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape box = {thud_obb_at(0, 0, half_x, half_y, 0), &shape_def};
    body_def.kind = kind;
    body_def.position = (thud_pos){x, y};
    body_def.user_data = kind == THUD_DYNAMIC ? CRATE : 0;
    shape_def.sensor = sensor;
    thud_body_create_with_shapes(world, &body_def, &box, 1, NULL, NULL);
}

static void throw_ball(thud_world *world, thud_pos target) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape ball = {thud_circle_at(0, 0, 0.4), &shape_def};
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){0, 2};
    body_def.velocity = (thud_vec2){target.x, target.y - 2 + 5}; /* there in a second */
    shape_def.density = 2;
    thud_body_create_with_shapes(world, &body_def, &ball, 1, NULL, NULL);
}

static int count_crates(const thud_world *world, thud_pos *highest) {
    thud_body_id bodies[BODIES];
    int count = 0, crates = 0;
    *highest = (thud_pos){0, -1e9};
    thud_world_bodies(world, bodies, BODIES, &count);
    for (int i = 0; i < count; i++) {
        thud_body_state state;
        thud_body_get(world, bodies[i], &state);
        if (state.user_data == CRATE) {
            crates++;
            if (state.position.y > highest->y)
                *highest = state.position;
        }
    }
    return crates;
}

/* One step. False: the game is over. */
static bool play(thud_world *world) {
    thud_pos highest;
    uint64_t step = thud_world_stats(world).steps;
    if (count_crates(world, &highest) == 0 || step == PAUSE * BALLS)
        return false;
    if (step % PAUSE == 0)
        throw_ball(world, highest);
    thud_world_step(world);
    thud_events events = thud_world_events(world);
    for (int i = 0; i < events.sensor_begin_count; i++) {
        thud_pair pair; /* a is the floor */
        thud_pair_get(world, events.sensor_begin[i].shape_a, events.sensor_begin[i].shape_b, &pair);
        thud_body_destroy(world, pair.b.body);
    }
    return true;
}

static bool save(const thud_world *world, FILE *file) {
    size_t bytes = 0;
    thud_world_snapshot_size(world, &bytes);
    void *buffer = malloc(bytes);
    bool done = buffer && thud_world_snapshot(world, buffer, bytes, NULL) == THUD_OK &&
                fwrite(&bytes, sizeof bytes, 1, file) == 1 && fwrite(buffer, bytes, 1, file) == 1;
    free(buffer);
    return done;
}

static bool load(thud_world *world, FILE *file) {
    size_t bytes;
    if (fread(&bytes, sizeof bytes, 1, file) != 1)
        return false;
    void *buffer = malloc(bytes);
    bool done = buffer && fread(buffer, bytes, 1, file) == 1 &&
                thud_world_restore(world, buffer, bytes) == THUD_OK;
    free(buffer);
    return done;
}

/* Its hash; 0 where crates are left. */
static uint64_t finish(thud_world *world) {
    while (play(world))
        continue;
    thud_pos highest;
    int left = count_crates(world, &highest), steps = (int)thud_world_stats(world).steps;
    uint64_t hash = thud_world_hash(world);
    printf("%d crates left after %d steps, hash %016llx\n", left, steps, (unsigned long long)hash);
    thud_world_destroy(world);
    return left ? 0 : hash;
}

int main(void) {
    thud_world *played, *loaded;
    thud_world_def world_def = thud_default_world_def();
    FILE *file = tmpfile();
    if (!file || thud_world_create(&world_def, &played) != THUD_OK ||
        thud_world_create(&world_def, &loaded) != THUD_OK)
        return 1;
    add_box(played, THUD_STATIC, 12, 2, 2, 0.5f, false);
    add_box(played, THUD_STATIC, 0, -3, 100, 1, true);
    for (int i = 0; i < CRATES; i++)
        add_box(played, THUD_DYNAMIC, 11 + i % 3, 3 + i / 3, 0.45f, 0.5f, false);
    for (int i = 0; i < 2 * PAUSE + 20; i++)
        play(played);
    if (!save(played, file))
        return 1;
    rewind(file);
    if (!load(loaded, file))
        return 1;
    fclose(file);
    uint64_t hash = finish(played);
    return hash == 0 || finish(loaded) != hash;
}
