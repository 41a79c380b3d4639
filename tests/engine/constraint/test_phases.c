/* test_phases.c: how the blocks of a step are divided among workers: colours of kinematic bodies,
 * chunks, and phases between which workers wait for each other. */
#include "engine_support.h"

#include "constraint/lanes.h"

#include "build_thud.h"
#include "scenes.h"

#include <thud/thud_testing.h>

/* Calls the task once: the first worker to arrive runs all chunks. */
static void alone(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)workers, (void)context;
    task(argument);
}

/* A scene of so many bodies after some steps, in a world with so many workers. */
static thud_world *world_of(const char *name, int size, int steps, int workers) {
    scene s;
    thud_world *world;
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    def.job_system = (thud_job_system){.run = alone, .workers = workers};
    assert_true(scenes_fill(scenes_find(name), size, &s));
    OK(scene_build_thud(&s, &def, &world, NULL, NULL));
    scene_free(&s);
    for (int i = 0; i < steps; i++) {
        OK(thud_world_step(world));
    }
    return world;
}

static td_block *block_of(const thud_world *w, int index) {
    return *TD_AT(td_block *, &w->scratch.blocks, index);
}

/* Whether a lane of a block has a kinematic body. */
static bool is_kinematic(const thud_world *w, const td_block *block, int lane) {
    const td_constraint *c = td_constraint_at(w, block->constraint[lane]);
    return td_body_at(w, c->body[0])->kind == THUD_BODY_KINEMATIC ||
           td_body_at(w, c->body[1])->kind == THUD_BODY_KINEMATIC;
}

static void pairs_of_kinematic_bodies_keep_no_other_runs_from_workers(void **state) {
    (void)state;
    thud_world *w = world_of("tumbler", 500, 120, 2);
    int lanes = 0, own_runs = 0;
    for (int r = 0; r < w->scratch.runs.count; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        own_runs += td_run_is_single(run);
        for (int i = run->first; i < run->first + run->count; i++) {
            for (int lane = 0; lane < block_of(w, i)->used; lane++) {
                bool kinematic = is_kinematic(w, block_of(w, i), lane);
                assert_int_equal(kinematic, td_run_is_single(run));
                lanes += kinematic;
            }
        }
    }
    assert_true(lanes > 20);
    assert_in_range(own_runs, 1, w->scratch.runs.count / 2);
    thud_world_destroy(w);
}

/* Checks the chunks of a run, the first of which is `chunk`. Returns how many there are. */
static int check_chunks(const thud_world *w, const td_run *run, int chunk, int workers) {
    int count = 0, most = 0;
    for (int blocks = 0; blocks < run->count; count++) {
        const td_chunk *c = TD_AT(td_chunk, &w->scratch.chunks, chunk + count);
        assert_ptr_equal(TD_AT(td_run, &w->scratch.runs, c->run), run);
        assert_int_equal(c->first, run->first + blocks);
        assert_int_equal(blocks % TD_CHUNK_UNIT, 0);
        assert_in_range(c->count, 1, TD_CHUNK_BLOCKS);
        most = td_max_int(most, c->count);
        blocks += c->count;
    }
    /* A worker that takes its share of the chunks, rounded up, has not much more than its share of
     * the blocks: a unit more for each chunk. */
    int own = (count + workers - 1) / workers;
    int least = td_max_int(run->count / workers + own * TD_CHUNK_UNIT, TD_CHUNK_BLOCKS_MIN);
    assert_in_range(own * most, 1, least);
    return count;
}

static void runs_are_divided_evenly_among_workers(void **state) {
    (void)state;
    const int workers[] = {2, 3, 5, THUD_WORKERS_MAX};
    for (size_t k = 0; k < sizeof workers / sizeof *workers; k++) {
        thud_world *w = world_of("pyramid", 60, 10, workers[k]);
        int chunk = 0, divided = 0;
        for (int r = 0; r < w->scratch.runs.count; r++) {
            const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
            assert_false(td_run_is_single(run));
            int count = check_chunks(w, run, chunk, workers[k]);
            divided += count >= td_min_int(workers[k], run->count / TD_CHUNK_BLOCKS_MIN);
            chunk += count;
        }
        assert_int_equal(chunk, w->scratch.chunks.count);
        assert_int_equal(divided, w->scratch.runs.count);
        thud_world_destroy(w);
    }
}

/* Whether workers may run these two chunks at the same time. */
static bool is_shared(const thud_world *w, int chunk, int other) {
    const td_run *a =
        TD_AT(td_run, &w->scratch.runs, TD_AT(td_chunk, &w->scratch.chunks, chunk)->run);
    const td_run *b =
        TD_AT(td_run, &w->scratch.runs, TD_AT(td_chunk, &w->scratch.chunks, other)->run);
    return a->bin == b->bin && !td_run_is_single(a) && !td_run_is_single(b);
}

/* Phases follow each other without a gap. The parts of a phase share no moving body, and two
 * single parts do not follow each other. */
static void small_colours_that_follow_each_other_are_one_phase(void **state) {
    (void)state;
    thud_world *w = world_of("tumbler", 1500, 120, 2);
    int joined = 0;
    bool single = false;
    for (int first = 0; first < w->scratch.chunks.count;) {
        td_phase phase = td_phase_from(w, first);
        assert_int_equal(phase.first, first);
        assert_in_range(phase.end, first + 1, w->scratch.chunks.count);
        assert_false(single && phase.parts == 1);
        single = phase.parts == 1;
        assert_int_equal(td_phase_step(&phase) * phase.parts, phase.end - first);
        for (int i = first + 1; i < phase.end; i++) {
            assert_int_equal(is_shared(w, first, i), !single);
            joined += single;
        }
        first = phase.end;
    }
    assert_true(joined > 1);
    thud_world_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_of_kinematic_bodies_keep_no_other_runs_from_workers),
        cmocka_unit_test(runs_are_divided_evenly_among_workers),
        cmocka_unit_test(small_colours_that_follow_each_other_are_one_phase),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
