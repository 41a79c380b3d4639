/* test_phases.c: how the blocks of a step are divided among workers: colours of kinematic bodies,
 * chunks, and phases between which workers wait for each other. */
#include "engine_support.h"

#include "constraint/chunks.h"

#include "build_thud.h"
#include "scenes.h"

#include <thud/thud_testing.h>

#include <stdlib.h>

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

static const td_chunk *chunk_at(const thud_world *w, int index) {
    return TD_AT(td_chunk, &w->scratch.chunks, index);
}

/* The chunk at this place of scratch.chunk_order. */
static int chunk_in(const thud_world *w, int place) {
    return *TD_AT(int, &w->scratch.chunk_order, place);
}

static const td_run *run_of(const thud_world *w, int chunk) {
    return TD_AT(td_run, &w->scratch.runs, chunk_at(w, chunk)->run);
}

/* Checks that the chunks from `chunk` on cover the run, and adds their blocks to those of their
 * workers. Returns how many chunks there are. */
static int check_chunks(const thud_world *w, int index, int chunk, int blocks_of[]) {
    const td_run *run = TD_AT(td_run, &w->scratch.runs, index);
    int count = 0, worker = 0;
    for (int blocks = 0; blocks < run->count; count++) {
        const td_chunk *c = chunk_at(w, chunk + count);
        assert_int_equal(c->run, index);
        assert_int_equal(c->first, run->first + blocks);
        assert_int_equal(blocks % TD_CHUNK_UNIT, 0);
        assert_in_range(c->count, 1, run->count - blocks);
        assert_in_range(c->count, 1, TD_CHUNK_BLOCKS);
        assert_in_range(c->worker, worker, w->def.job_system.workers - 1);
        worker = c->worker;
        blocks_of[worker] += c->count;
        blocks += c->count;
    }
    return count;
}

static void blocks_are_divided_evenly_among_workers(void **state) {
    (void)state;
    const int workers[] = {2, 3, 5, THUD_WORKERS_MAX};
    for (size_t k = 0; k < sizeof workers / sizeof *workers; k++) {
        thud_world *w = world_of("pyramid", 60, 10, workers[k]);
        int chunk = 0, blocks_of[THUD_WORKERS_MAX] = {0};
        for (int r = 0; r < w->scratch.runs.count; r++) {
            assert_false(td_run_is_single(TD_AT(td_run, &w->scratch.runs, r)));
            chunk += check_chunks(w, r, chunk, blocks_of);
        }
        assert_int_equal(chunk, w->scratch.chunks.count);
        for (int i = 0; i < workers[k] && workers[k] < THUD_WORKERS_MAX; i++) {
            int share = w->scratch.blocks.count / workers[k];
            assert_in_range(blocks_of[i], share * 4 / 5, share * 6 / 5);
        }
        thud_world_destroy(w);
    }
}

/* Small worlds, of 300 to 780 bodies: the ranges of many workers end within the last place, near
 * its end, where rounding a share to whole units must not lead past the run's last block. */
static void chunks_of_many_workers_cover_their_runs(void **state) {
    (void)state;
    for (int size = 24; size < 40; size++) {
        for (int workers = 8; workers <= THUD_WORKERS_MAX; workers += 4) {
            thud_world *w = world_of("pyramid", size, 2, workers);
            int chunk = 0, blocks_of[THUD_WORKERS_MAX] = {0};
            for (int r = 0; r < w->scratch.runs.count; r++) {
                chunk += check_chunks(w, r, chunk, blocks_of);
            }
            assert_int_equal(chunk, w->scratch.chunks.count);
            thud_world_destroy(w);
        }
    }
}

/* Parts follow each other without a gap, and so do phases. The chunks of a phase of several parts
 * share no moving body, and two phases of a single part do not follow each other. */
static void small_colours_that_follow_each_other_are_one_phase(void **state) {
    (void)state;
    thud_world *w = world_of("tumbler", 1500, 120, 2);
    int joined = 0, next = 0, next_part = 0;
    bool single = false;
    for (int i = 0; i < w->scratch.phases.count; i++) {
        const td_phase *phase = TD_AT(td_phase, &w->scratch.phases, i);
        assert_int_equal(phase->first, next_part);
        assert_false(single && phase->parts == 1);
        single = phase->parts == 1;
        const td_run *first = run_of(w, chunk_in(w, next));
        for (int end = next_part + phase->parts; next_part < end; next_part++) {
            assert_int_equal(*td_part_first(w, next_part), next);
            for (; next < *td_part_first(w, next_part + 1); next++) {
                const td_run *run = run_of(w, chunk_in(w, next));
                bool apart =
                    run->bin == first->bin && !td_run_is_single(run) && !td_run_is_single(first);
                assert_true(apart || single);
                joined += single && !apart;
            }
        }
    }
    assert_int_equal(next, w->scratch.chunks.count);
    assert_true(joined > 1);
    thud_world_destroy(w);
}

/* On terrain, where a colour has small chunks of five kinds of contacts. */
static void small_chunks_of_a_worker_are_one_part(void **state) {
    (void)state;
    thud_world *w = world_of("mixed_terrain", 4000, 200, 2);
    int several = 0;
    for (int i = 0; i < w->scratch.phases.count; i++) {
        const td_phase *phase = TD_AT(td_phase, &w->scratch.phases, i);
        for (int k = 0; k < phase->parts && phase->parts > 1; k++) {
            const int *first = td_part_first(w, phase->first + k);
            int blocks = 0;
            for (int c = first[0]; c < first[1]; c++) {
                blocks += chunk_at(w, chunk_in(w, c))->count;
            }
            assert_in_range(blocks, 1, TD_CHUNK_BLOCKS);
            several += first[1] > first[0] + 1;
        }
    }
    assert_true(several > 10);
    thud_world_destroy(w);
}

/* Sets the bit of a chunk that a phase has handed out. */
static void hand_out(void *handed, int chunk) {
    assert_false(((bool *)handed)[chunk]);
    ((bool *)handed)[chunk] = true;
}

static void a_phase_hands_out_each_chunk_once_and_first_to_its_worker(void **state) {
    (void)state;
    thud_world *w = world_of("circle_pit", 4000, 60, 3);
    bool *handed = calloc((size_t)w->scratch.chunks.count, sizeof *handed);
    assert_non_null(handed);
    for (int i = 0; i < w->scratch.phases.count; i++) {
        const td_phase *phase = TD_AT(td_phase, &w->scratch.phases, i);
        assert_int_equal(phase->shares[0], 0);
        assert_int_equal(phase->shares[3], phase->parts);
        for (int worker = 0; worker < 3; worker++) {
            for (int part = phase->shares[worker]; part < phase->shares[worker + 1]; part++) {
                const int *first = td_part_first(w, phase->first + part);
                for (int c = first[0]; c < first[1]; c++) {
                    assert_true(phase->parts == 1 || chunk_at(w, chunk_in(w, c))->worker == worker);
                }
                td_phase_run(w, phase, part, hand_out, handed);
            }
        }
    }
    for (int i = 0; i < w->scratch.chunks.count; i++) {
        assert_true(handed[i]);
    }
    free(handed);
    thud_world_destroy(w);
}

/* Whether the body of a lane's side is in another worker's range of awake slots. */
static bool is_foreign(const thud_world *w, uint32_t side, int worker) {
    const int *bounds = w->scratch.bounds.data;
    int slot = td_slot_of_side(side).at;
    return slot > 0 && (slot < bounds[worker] || slot >= bounds[worker + 1]);
}

/* Circles that have fallen among each other: without bins by place, a fifth of the bodies of each
 * worker's blocks are another worker's. */
static void workers_solve_blocks_of_their_own_bodies(void **state) {
    (void)state;
    thud_world *w = world_of("circle_pit", 10000, 200, 2);
    int foreign = 0, all = 0, shares[THUD_WORKERS_MAX + 1];
    for (int i = 0; i < w->scratch.chunks.count; i++) {
        const td_chunk *chunk = chunk_at(w, i);
        for (int b = chunk->first; b < chunk->first + chunk->count; b++) {
            const td_block *block = block_of(w, b);
            for (int lane = 0; lane < block->used; lane++) {
                foreign += is_foreign(w, block->a[lane], chunk->worker) +
                           is_foreign(w, block->b[lane], chunk->worker);
                all += (block->a[lane] > 0) + (block->b[lane] > 0);
            }
        }
    }
    assert_true(all > 20000);
    assert_in_range(foreign, 0, all / 20);
    td_share_bodies(w, 2, shares);
    const int *bounds = w->scratch.bounds.data;
    assert_int_equal(shares[1] * td_body_chunk(w, 2), bounds[1]);
    thud_world_destroy(w);
}

/* A few bodies in a heap among many that fly: the heap's blocks are not those of half the bodies,
 * so that the passes over bodies divide these evenly. */
static void bodies_are_divided_evenly_where_few_of_them_touch(void **state) {
    (void)state;
    thud_world *w = world_of("gas", 8000, 30, 2);
    int *bounds = w->scratch.bounds.data, shares[THUD_WORKERS_MAX + 1];
    bounds[1] = w->body_of.count / 8;
    td_share_bodies(w, 2, shares);
    assert_int_equal(shares[1], shares[2] / 2);
    assert_in_range(shares[2] * td_body_chunk(w, 2), w->body_of.count,
                    w->body_of.count + td_body_chunk(w, 2));
    thud_world_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pairs_of_kinematic_bodies_keep_no_other_runs_from_workers),
        cmocka_unit_test(blocks_are_divided_evenly_among_workers),
        cmocka_unit_test(chunks_of_many_workers_cover_their_runs),
        cmocka_unit_test(small_colours_that_follow_each_other_are_one_phase),
        cmocka_unit_test(small_chunks_of_a_worker_are_one_part),
        cmocka_unit_test(a_phase_hands_out_each_chunk_once_and_first_to_its_worker),
        cmocka_unit_test(workers_solve_blocks_of_their_own_bodies),
        cmocka_unit_test(bodies_are_divided_evenly_where_few_of_them_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
