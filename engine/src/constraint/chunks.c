/* chunks.c: see chunks.h. */
#include "constraint/chunks.h"

#include <string.h>

/* ---- which slots a worker has ---- */

/* The workers' ranges begin and end at multiples of so many awake slots, 8 or 1 KiB of velocities.
 * The larger unit is used where every worker has UNITS_MIN of them on average. Chosen. */
enum { SLOTS_UNIT = 512, SLOTS_UNIT_SMALL = 64, UNITS_MIN = 4 };

int td_body_chunk(const thud_world *w, int workers) {
    int slots = w->body_of.count;
    return slots >= workers * UNITS_MIN * SLOTS_UNIT ? SLOTS_UNIT : SLOTS_UNIT_SMALL;
}

/* A boundary between the ranges of two workers is moved to the begin or end of its place (a range
 * of awake slots, lanes.h) if that gives no more than this fraction, a twelfth, of a worker's
 * blocks to the other. If two workers shared a place they would write the same cache lines, since
 * the blocks of a place are in the order in which their contacts began, whatever their bodies.
 * Chosen. */
enum { UNEVEN = 12 };

/* The awake slots of a place. */
static int slots_of_place(const thud_world *w, int place) {
    return td_max_int(0, td_min_int(w->body_of.count - place * TD_PLACE_SLOTS, TD_PLACE_SLOTS));
}

/* Counts the blocks of each place, in scratch.order (int). Returns how many these are. */
static int count_by_place(thud_world *w) {
    int *blocks = w->scratch.order.data, sum = 0;
    memset(blocks, 0, (size_t)w->scratch.order.count * sizeof *blocks);
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        if (run->bin < TD_PLACED_COLOURS) {
            blocks[run->place] += run->count;
            sum += run->count;
        }
    }
    return sum;
}

/* Sets scratch.bounds: worker i has the awake slots from bounds[i] to bounds[i + 1] - 1. Each gets
 * about as many blocks of places as the others; in a world without such blocks, as many slots.
 * Where few bodies touch, all these blocks are of the first place (td_lanes_place), and all
 * boundaries lie within it. */
static void set_bounds(thud_world *w, int workers) {
    const int *blocks = w->scratch.order.data;
    int *bounds = w->scratch.bounds.data, slots = w->body_of.count;
    int sum = count_by_place(w), unit = td_body_chunk(w, workers), place = 0, before = 0;
    bounds[0] = 0;
    for (int i = 1; i < workers; i++) {
        int bound = (int)((int64_t)slots * i / workers), wanted = (int)((int64_t)sum * i / workers);
        if (sum > 0) {
            while (before + blocks[place] < wanted) {
                before += blocks[place++];
            }
            int within = wanted - before, slack = sum / workers / UNEVEN;
            within = within <= slack ? 0 : blocks[place] - within <= slack ? blocks[place] : within;
            bound = place * TD_PLACE_SLOTS + (int)((int64_t)slots_of_place(w, place) * within /
                                                   td_max_int(1, blocks[place]));
        }
        bounds[i] = td_max_int(bounds[i - 1], (bound + unit / 2) / unit * unit);
    }
    bounds[workers] = slots;
}

void td_share_bodies(const thud_world *w, int workers, int shares[THUD_WORKERS_MAX + 1]) {
    const int *bounds = w->scratch.bounds.data;
    int slots = w->body_of.count, unit = td_body_chunk(w, workers), slots_max = 0;
    for (int i = 0; i < workers; i++) {
        slots_max = td_max_int(slots_max, bounds[i + 1] - bounds[i]);
        shares[i] = td_min_int(bounds[i], slots) / unit;
    }
    shares[workers] = (slots + unit - 1) / unit;
    /* Where a worker would get over 5/4 of an even share of the slots, they are divided evenly. */
    if ((int64_t)slots_max * workers * 4 > (int64_t)slots * 5) {
        td_share_evenly(shares[workers], workers, shares);
    }
}

/* ---- chunks ---- */

/* The index, in the run, of the first block of a worker's share: a multiple of TD_CHUNK_UNIT, or
 * the end of the run. A run that is too short to be divided belongs to one worker as a whole. */
static int share_begins(const thud_world *w, const td_run *run, int worker, int workers) {
    int count = run->count;
    if (worker == 0 || worker == workers || td_run_is_single(run)) {
        return worker == 0 ? 0 : count;
    }
    if (run->bin >= TD_PLACED_COLOURS) {
        int even = ((count - 1) / workers / TD_CHUNK_UNIT + 1) * TD_CHUNK_UNIT;
        return td_min_int(worker * td_max_int(even, TD_CHUNK_BLOCKS_MIN), count);
    }
    int slots = td_max_int(1, slots_of_place(w, run->place));
    int bound = *TD_AT(int, &w->scratch.bounds, worker) - run->place * TD_PLACE_SLOTS;
    bound = td_max_int(0, td_min_int(bound, slots));
    if (count < 2 * TD_CHUNK_BLOCKS_MIN) {
        return 2 * bound < slots ? 0 : count;
    }
    int begin = (int)((int64_t)count * bound / slots);
    int rounded = (begin + TD_CHUNK_UNIT / 2) / TD_CHUNK_UNIT * TD_CHUNK_UNIT;
    return bound == slots ? count : td_min_int(rounded, count);
}

/* Appends the blocks of a run from `first` to the one before `end` as chunks of a worker's share,
 * of at most `size` blocks. There is room for them. */
static void add_chunks(thud_world *w, int run, int first, int end, int size, int worker) {
    for (; first < end; first += size) {
        int blocks = TD_AT(td_run, &w->scratch.runs, run)->first;
        TD_PUSH(td_chunk, &w->scratch.chunks) = (td_chunk){.run = run,
                                                           .first = blocks + first,
                                                           .count = td_min_int(size, end - first),
                                                           .worker = worker};
    }
}

/* ---- phases ---- */

static const td_chunk *chunk_at(const thud_world *w, int index) {
    return TD_AT(td_chunk, &w->scratch.chunks, index);
}

static const td_run *run_of_chunk(const thud_world *w, int chunk) {
    return TD_AT(td_run, &w->scratch.runs, chunk_at(w, chunk)->run);
}

/* The index after the last of the chunks from `first` on that workers may run at the same time. */
static int end_of_colour(const thud_world *w, int first) {
    const td_run *run = run_of_chunk(w, first);
    int end = first + 1;
    while (end < w->scratch.chunks.count && !td_run_is_single(run) &&
           run_of_chunk(w, end)->bin == run->bin && !td_run_is_single(run_of_chunk(w, end))) {
        end++;
    }
    return end;
}

/* Sorts the chunks of a phase, from `first` on, by worker (sets their elements of
 * scratch.chunk_order), and joins those of a worker to parts of at most TD_CHUNK_BLOCKS blocks:
 * claiming a part costs some 60 ns, about as much as two blocks (measured with two processors). */
static void share_chunks(thud_world *w, td_phase *phase, int first, int count, int workers) {
    int *order = w->scratch.chunk_order.data, at = first;
    for (int k = 0; k < workers; k++) {
        int blocks = TD_CHUNK_BLOCKS; /* blocks in the present part; it begins as full, so that the
                                         first chunk begins a new part */
        for (int i = first; i < first + count; i++) {
            const td_chunk *chunk = chunk_at(w, i);
            if (chunk->worker != k) {
                continue;
            }
            blocks += chunk->count;
            if (blocks > TD_CHUNK_BLOCKS) {
                *td_part_first(w, phase->first + phase->parts++) = at;
                blocks = chunk->count;
            }
            order[at++] = i;
        }
        phase->shares[k + 1] = phase->parts;
    }
}

/* Begins a phase (the work between two barriers of the workers) of a single part. The part belongs
 * to the first worker, but another one that is free earlier takes it. */
static void give_to_one(thud_world *w, td_phase *phase, int first, int workers) {
    *td_part_first(w, phase->first) = first;
    phase->parts = 1;
    for (int k = 0; k < workers; k++) {
        phase->shares[k + 1] = 1;
    }
}

/* Lists the phases of the step: the pieces of work between two barriers, at which the workers wait
 * for each other. False when memory is short. */
static bool list_phases(thud_world *w, int workers) {
    td_array *phases = &w->scratch.phases;
    int *order = w->scratch.chunk_order.data, chunks = w->scratch.chunks.count, parts = 0;
    bool single = false; /* the last phase is for one worker */
    phases->count = 0;
    for (int first = 0, count; first < chunks; first += count) {
        count = end_of_colour(w, first) - first;
        if (count > 1 || !single) {
            if (!td_array_reserve(&w->memory, phases, phases->count + 1)) {
                return false;
            }
            td_phase *phase = &TD_PUSH(td_phase, phases);
            *phase = (td_phase){.first = parts};
            if (count > 1) {
                share_chunks(w, phase, first, count, workers);
            } else {
                give_to_one(w, phase, first, workers);
            }
            parts += phase->parts;
        }
        single = count == 1;
        if (single) {
            order[first] = first;
        }
    }
    *td_part_first(w, parts) = chunks;
    return true;
}

/* Divides all runs among several workers. False when memory is short. */
static bool cut_for_workers(thud_world *w, int workers) {
    int places = 1 + w->placed_bins.count / TD_PLACED_COLOURS;
    if (!td_array_reserve(&w->memory, &w->scratch.chunk_order,
                          2 * w->scratch.chunks.capacity + 1) ||
        !td_array_reserve(&w->memory, &w->scratch.order, places) ||
        !td_array_reserve(&w->memory, &w->scratch.bounds, THUD_WORKERS_MAX + 1)) {
        return false;
    }
    w->scratch.order.count = places;
    set_bounds(w, workers);
    for (int i = 0; i < w->scratch.runs.count; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        int size = td_run_is_single(run) ? run->count : TD_CHUNK_BLOCKS;
        for (int k = 0; k < workers; k++) {
            add_chunks(w, i, share_begins(w, run, k, workers), share_begins(w, run, k + 1, workers),
                       size, k);
        }
    }
    return list_phases(w, workers);
}

bool td_chunks_cut(thud_world *w) {
    int workers = TD_HAS_THREADS ? td_max_int(1, w->def.job_system.workers) : 1;
    int runs = w->scratch.runs.count;
    int chunks_max = runs;
    if (workers > 1) {
        chunks_max = runs * workers + w->scratch.blocks.count / TD_CHUNK_BLOCKS;
    }
    if (!td_array_reserve(&w->memory, &w->scratch.chunks, chunks_max)) {
        return false;
    }
    w->scratch.chunks.count = 0;
    if (workers > 1) {
        return cut_for_workers(w, workers);
    }
    for (int i = 0; i < runs; i++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, i);
        TD_PUSH(td_chunk, &w->scratch.chunks) =
            (td_chunk){.run = i, .first = run->first, .count = run->count};
    }
    return true;
}

void td_phase_run(const thud_world *w, const td_phase *phase, int part, td_chunk_fn *run,
                  void *work) {
    const int *order = w->scratch.chunk_order.data;
    const int *first = td_part_first(w, phase->first + part);
    for (int i = first[0]; i < first[1]; i++) {
        run(work, order[i]);
    }
}
