/* packed_known.c: predicts words of a snapshot from others, for packed.c. Much of a snapshot is
 * stored twice, or follows from the rest: proxies from poses, fat bounds from proxies, poses from
 * those of the base and the motion of the step, separations from motions. Each function here
 * repeats what the engine does, in the same operations, so that mostly the prediction is exact.
 * Where it is not (the snapshots are several steps apart, or an edit came between), the word costs
 * some bytes more.
 *
 * Predictions read the words of the snapshot that were packed before, and the base. Packed bytes
 * may be forged, so that an index in them can have any value: a record that does not exist reads as
 * 0. */
#include "sessions/packed.h"

#include "base/rotation.h"
#include "broadphase/grid.h"
#include "contact/pair_kinds.h"
#include "state/awake.h"

#include <math.h>
#include <string.h>

typedef td_packed_image image;
typedef td_packed_field field;

/* The sections of arrays. */
#define PART(name) (TD_SECTION_PARTS + TD_SNAPSHOT_##name)
#define AWAKE(name) (TD_SECTION_PARTS + TD_SNAPSHOT_AWAKE + TD_AWAKE_##name)

/* ---- reading ---- */

/* Copies `bytes` bytes at byte `at` of a record. Without the record: zeros. */
static void read(const image *i, int section, int32_t record, size_t at, void *to, size_t bytes) {
    const td_snapshot_section *s = &i->sections[section];
    uint64_t offset = (uint64_t)(uint32_t)record * s->stride + at;
    if (record >= 0 && i->bytes && offset + bytes <= s->bytes) {
        memcpy(to, i->bytes + i->at[section] + offset, bytes);
    } else {
        memset(to, 0, bytes);
    }
}

static uint32_t word_at(const image *i, int section, int32_t record, size_t at) {
    uint32_t word;
    read(i, section, record, at, &word, sizeof word);
    return word;
}

static int32_t int_at(const image *i, int section, int32_t record, size_t at) {
    return (int32_t)word_at(i, section, record, at);
}

static float float_at(const image *i, int section, int32_t record, size_t at) {
    float number;
    read(i, section, record, at, &number, sizeof number);
    return number;
}

static uint8_t byte_at(const image *i, int section, int32_t record, size_t at) {
    uint8_t byte;
    read(i, section, record, at, &byte, sizeof byte);
    return byte;
}

static int64_t long_at(const image *i, int section, int32_t record, size_t at) {
    int64_t number;
    read(i, section, record, at, &number, sizeof number);
    return number;
}

/* The bits of a float; 0 for NaN, of which processors compute different bits, so that packing and
 * unpacking would predict different words. */
static uint32_t bits_of(float number) {
    uint32_t bits;
    if (number != number) {
        return 0;
    }
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* Reads a field of a body's or shape's record. */
#define BODY(i, body, name) int_at(i, TD_SECTION_BODIES, body, offsetof(td_body, name))
#define BODY_FLOAT(i, body, name) float_at(i, TD_SECTION_BODIES, body, offsetof(td_body, name))
#define SHAPE(i, shape, name) int_at(i, TD_SECTION_SHAPES, shape, offsetof(td_shape, name))

static bool shape_turns(const image *i, int32_t shape) {
    return byte_at(i, TD_SECTION_SHAPES, shape, offsetof(td_shape, kind)) == THUD_SHAPE_OBB;
}

/* ---- motion ---- */

/* The motion of a body in the last step: x, y, angle; 0 for a body without an awake slot. */
static void motion_of(const image *i, int32_t body, float motion[3]) {
    int32_t slot = BODY(i, body, awake);
    memset(motion, 0, 3 * sizeof *motion);
    if (slot > 0) {
        read(i, AWAKE(delta), slot, 0, motion, 3 * sizeof *motion);
    }
}

/* Rounded to whole quanta as in finalize.c; 0 for a number of 2^51 or more, which this rounding
 * cannot represent. */
static uint64_t quanta_of(double quanta) {
    return quanta < 0x1p51 && quanta > -0x1p51 ? (uint64_t)td_round_increment(quanta) : 0;
}

static uint64_t length_quanta(const image *i, float length) {
    return quanta_of((double)length * i->to_fixed);
}

static uint32_t angle_quanta(float radians) {
    return (uint32_t)quanta_of((double)radians * (1.0 / TD_RADIANS_A_QUANTUM));
}

/* One word of a 64-bit number, whose two words are a column each. On little-endian machines the low
 * word is packed first, so that it is known when the high one is predicted: of all numbers with
 * that low word, the nearest to the prediction is taken. */
static uint32_t half_of(const field *f, int32_t record, uint64_t predicted) {
    const uint64_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    bool is_first = f->at % sizeof predicted == 0;
    if (is_first == (first == 1)) {
        return (uint32_t)predicted;
    }
    if (first == 1) {
        uint32_t low = word_at(&f->pair->now, f->section, record, f->at - sizeof low);
        predicted += (uint64_t)(int64_t)(int32_t)(low - (uint32_t)predicted);
    }
    return (uint32_t)(predicted >> 32);
}

/* Predicts a word of a body's pose: the pose of the base plus the motion of one step; cosine and
 * sine follow from the angle. */
static uint32_t pose_word(const field *f, int32_t body) {
    const image *now = &f->pair->now, *base = &f->pair->base;
    float motion[3], c, s;
    motion_of(now, body, motion);
    if (f->at < offsetof(td_pose, angle)) {
        size_t k = f->at / sizeof(int64_t);
        uint64_t was = (uint64_t)long_at(base, f->section, body, k * sizeof(int64_t));
        return half_of(f, body, was + length_quanta(now, motion[k]));
    }
    if (f->at == offsetof(td_pose, angle)) {
        return word_at(base, f->section, body, f->at) + angle_quanta(motion[2]);
    }
    td_angle_turn(word_at(now, f->section, body, offsetof(td_pose, angle)), &c, &s);
    return bits_of(f->at == offsetof(td_pose, c) ? c : s);
}

/* ---- shapes ---- */

/* Predicts a word of a shape's fat bounds: its tight bounds grown by its margin, as shape_place.c
 * computes them. */
static uint32_t fat_word(const field *f, int32_t shape) {
    const image *now = &f->pair->now;
    td_shape_proxy p;
    memset(&p, 0, sizeof p);
    read(now, f->section, shape, 0, &p, offsetof(td_shape_proxy, fat));
    float hx = p.half_x, hy = p.half_y;
    if (shape_turns(now, shape)) {
        float c = fabsf(p.c), s = fabsf(p.s);
        float x = c * hx + s * hy;
        hy = s * hx + c * hy;
        hx = x;
    }
    size_t k = (f->at - offsetof(td_shape_proxy, fat)) / sizeof(int32_t); /* min, min, max, max */
    float half = (k % 2 ? hy : hx) * (float)(TD_COARSE_ONE / now->head.length_scale);
    int32_t extent = half < 0x1p30f && half >= 0.0f ? (int32_t)half + 2 : 0;
    int32_t center = td_coarse(k % 2 ? p.center.y : p.center.x);
    uint32_t reach = (uint32_t)extent + (uint32_t)p.margin;
    return k < 2 ? (uint32_t)center - reach : (uint32_t)center + reach + 1;
}

static bool has_moved(const image *i, int32_t shape) {
    return byte_at(i, PART(MARKS), shape, 0) & TD_MARK_MOVED;
}

/* Predicts a word of a shape's proxy: half extents from the shape, cosine and sine from the body's
 * pose, the centre as the body's centre plus the shape's offset from it in the base. */
static uint32_t proxy_word(const field *f, int32_t shape) {
    const image *now = &f->pair->now, *base = &f->pair->base;
    int32_t body = SHAPE(now, shape, body);
    switch (f->at) {
    case offsetof(td_shape_proxy, c):
        return shape_turns(now, shape) ? word_at(now, PART(POSE), body, offsetof(td_pose, c))
                                       : bits_of(1.0f);
    case offsetof(td_shape_proxy, s):
        return shape_turns(now, shape) ? word_at(now, PART(POSE), body, offsetof(td_pose, s)) : 0;
    case offsetof(td_shape_proxy, half_x):
        return (uint32_t)SHAPE(now, shape, half_x);
    case offsetof(td_shape_proxy, half_y):
        return (uint32_t)(shape_turns(now, shape) ? SHAPE(now, shape, half_y)
                                                  : SHAPE(now, shape, half_x));
    default:
        break;
    }
    if (f->at >= offsetof(td_shape_proxy, fat)) {
        bool is_old = base->bytes && !has_moved(now, shape);
        return is_old ? word_at(base, f->section, shape, f->at) : fat_word(f, shape);
    }
    size_t at = f->at - f->at % sizeof(int64_t);
    uint64_t center = (uint64_t)long_at(now, PART(POSE), body, at);
    uint64_t arm = (uint64_t)long_at(base, f->section, shape, at) -
                   (uint64_t)long_at(base, PART(POSE), body, at);
    return half_of(f, shape, center + (base->bytes ? arm : 0));
}

/* Predicts a word of previous_fat: for a moved shape its fat bounds in the base, for another its
 * previous_fat in the base; without a base the present fat bounds. */
static uint32_t previous_fat_word(const field *f, int32_t shape) {
    const image *now = &f->pair->now, *base = &f->pair->base;
    size_t at = offsetof(td_shape_proxy, fat) + f->at;
    return !base->bytes            ? word_at(now, PART(PROXY), shape, at)
           : has_moved(now, shape) ? word_at(base, PART(PROXY), shape, at)
                                   : word_at(base, f->section, shape, f->at);
}

/* ---- proxy sets ---- */

static int32_t set_word(const field *f, int part, int32_t record) {
    int first = f->section - (f->section - PART(PROXY_SETS)) % TD_SNAPSHOT_PROXY_SET_PARTS;
    return int_at(&f->pair->now, first + part, record, 0);
}

/* Predicts a word of the arrays of a proxy set, which are copies of bounds and marks of shapes: see
 * wide_proxy_set.c, and store_anchors of grid.c. */
static uint32_t proxy_set_word(const field *f, int32_t record) {
    const image *now = &f->pair->now;
    int part = (f->section - PART(PROXY_SETS)) % TD_SNAPSHOT_PROXY_SET_PARTS;
    if (part == TD_SNAPSHOT_ANCHOR_X || part == TD_SNAPSHOT_ANCHOR_Y) {
        int axis = part - TD_SNAPSHOT_ANCHOR_X;
        return (uint32_t)td_middle(set_word(f, TD_SNAPSHOT_MIN_X + axis, record),
                                   set_word(f, TD_SNAPSHOT_MAX_X + axis, record));
    }
    int32_t shape = set_word(f, TD_SNAPSHOT_IDS, record);
    if (part == TD_SNAPSHOT_PLACES_MOVED) {
        return has_moved(now, shape) ? UINT32_MAX : 0;
    }
    /* The set has the bounds that shapes had before they moved. */
    size_t at = (size_t)(part - TD_SNAPSHOT_MIN_X) * sizeof(int32_t);
    return has_moved(now, shape)
               ? word_at(now, PART(PREVIOUS_FAT), shape, at)
               : word_at(now, PART(PROXY), shape, offsetof(td_shape_proxy, fat) + at);
}

/* ---- bodies, and arrays by awake slot ---- */

static float inverse_of(float number) {
    return number > 0.0f ? 1.0f / number : 0.0f;
}

static uint32_t body_word(const field *f, int32_t body) {
    const image *now = &f->pair->now;
    return f->at == offsetof(td_body, inv_mass) ? bits_of(inverse_of(BODY_FLOAT(now, body, mass)))
           : f->at == offsetof(td_body, inv_inertia)
               ? bits_of(inverse_of(BODY_FLOAT(now, body, inertia)))
               : (uint32_t)BODY(now, body, min_extent);
}

/* Predicts a word of the arrays by awake slot: those that awake.c sets from the body's record, and
 * delta, as velocity times time step. */
static uint32_t awake_word(const field *f, int32_t slot) {
    const image *now = &f->pair->now;
    int32_t body = int_at(now, AWAKE(body_of), slot, 0);
    switch (f->section) {
    case AWAKE(velocity):
        return (uint32_t)BODY(now, body, inv_mass);
    case AWAKE(delta): {
        double dt;
        read(now, TD_SECTION_FIELDS, 0, td_snapshot_field_at(offsetof(thud_world, def.time_step)),
             &dt, sizeof dt);
        return bits_of((float)((double)float_at(now, AWAKE(velocity), slot, f->at) * dt));
    }
    case AWAKE(reach):
        return word_at(now, TD_SECTION_BODIES, body, offsetof(td_body, min_extent) + f->at);
    case AWAKE(mass):
        return (uint32_t)BODY(now, body, mass);
    case AWAKE(inertia):
        return (uint32_t)BODY(now, body, inertia);
    default: /* gravity_mass */
        return bits_of(BODY_FLOAT(now, body, mass) * BODY_FLOAT(now, body, gravity_scale));
    }
}

/* ---- contacts ---- */

static uint32_t constraint_word(const field *f, int32_t constraint) {
    const image *now = &f->pair->now;
    size_t shape = f->at == offsetof(td_constraint, body) ? offsetof(td_constraint, shape_a)
                                                          : offsetof(td_constraint, shape_b);
    return (uint32_t)SHAPE(now, int_at(now, f->section, constraint, shape), body);
}

/* Eight lanes of a block. */
typedef struct lanes {
    const image *now, *base;
    const uint8_t *block; /* its first byte in the snapshot */
    int section;
    int32_t shape[2][TD_LANES]; /* rows shape_a and shape_b */
    int32_t slot[2][TD_LANES];  /* rows a and b, as awake slots; 0: static */
} lanes;

static void read_row(const lanes *l, size_t at, void *row) {
    memcpy(row, l->block + at, TD_LANES * sizeof(uint32_t));
}

static lanes lanes_of(const field *f, size_t first) {
    const td_snapshot_section *section = &f->pair->now.sections[f->section];
    lanes l = {&f->pair->now, &f->pair->base, NULL, f->section, {{0}}, {{0}}};
    l.block = l.now->bytes + l.now->at[f->section] + first / TD_LANES * section->stride;
    read_row(&l, offsetof(td_block, shape_a), l.shape[0]);
    read_row(&l, offsetof(td_block, shape_b), l.shape[1]);
    uint32_t sides[2][TD_LANES];
    read_row(&l, offsetof(td_block, a), sides[0]);
    read_row(&l, offsetof(td_block, b), sides[1]);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < TD_LANES; i++) {
            l.slot[k][i] = td_slot_of_side(sides[k][i]).at;
        }
    }
    return l;
}

/* The motion, in the last step, of the body on one side of a lane: x, y, angle. */
static void motion_at(const lanes *l, int side, int lane, float motion[3]) {
    memset(motion, 0, 3 * sizeof *motion);
    if (l->slot[side][lane] > 0) {
        read(l->now, AWAKE(delta), l->slot[side][lane], 0, motion, 3 * sizeof *motion);
    }
}

/* The centre, cosine and sine of a shape at the start of the step, from which its manifold was
 * computed. */
typedef struct start {
    int64_t x, y;
    float c, s, half_x;
} start;

static start start_of(const lanes *l, int side, int lane) {
    int32_t shape = l->shape[side][lane];
    float motion[3];
    td_shape_proxy p;
    motion_at(l, side, lane, motion);
    read(l->now, PART(PROXY), shape, 0, &p, offsetof(td_shape_proxy, half_y));
    start found = {.x = (int64_t)((uint64_t)p.center.x - length_quanta(l->now, motion[0])),
                   .y = (int64_t)((uint64_t)p.center.y - length_quanta(l->now, motion[1])),
                   .c = p.c,
                   .s = p.s,
                   .half_x = p.half_x};
    if (l->section != TD_SECTION_BLOCKS + TD_FORM_ONE && shape_turns(l->now, shape)) {
        int32_t body = SHAPE(l->now, shape, body);
        uint32_t angle = word_at(l->now, PART(POSE), body, offsetof(td_pose, angle));
        td_angle_turn(angle - angle_quanta(motion[2]), &found.c, &found.s);
    }
    return found;
}

/* The distance of b's centre from a's along an axis: td_read_shapes. */
static float distance_of(const image *now, int64_t a, int64_t b) {
    int64_t quanta = (int64_t)((uint64_t)b - (uint64_t)a);
    return (float)(now->head.length_scale / TD_FIXED_ONE) * (float)(double)quanta;
}

/* Reads the normals of the lanes, and the rows cross_a and cross_b of the point at this offset. */
static void read_normals(const lanes *l, size_t point, float nx[TD_LANES], float ny[TD_LANES],
                         float cross_a[TD_LANES], float cross_b[TD_LANES]) {
    read_row(l, offsetof(td_block, nx), nx);
    read_row(l, offsetof(td_block, ny), ny);
    read_row(l, point + offsetof(td_point, cross_a), cross_a);
    read_row(l, point + offsetof(td_point, cross_b), cross_b);
}

/* Predicts the separations at point k of manifolds that were reused from an earlier step
 * (td_cached_lanes). */
static void kept_separations(const lanes *l, int k, float out[TD_LANES]) {
    int points = td_form_points((td_block_form)(l->section - TD_SECTION_BLOCKS));
    size_t point = offsetof(td_block, point) + (size_t)k * sizeof(td_point);
    size_t kept = offsetof(td_block, point) +
                  (size_t)points * (sizeof(td_point) + sizeof(td_point_history)) +
                  sizeof(td_surface);
    td_manifold_cache cache;
    memcpy(&cache, l->block + kept, sizeof cache);
    float nx[TD_LANES], ny[TD_LANES], cross_a[TD_LANES], cross_b[TD_LANES];
    read_normals(l, point, nx, ny, cross_a, cross_b);
    for (int i = 0; i < TD_LANES; i++) {
        start a = start_of(l, 0, i), b = start_of(l, 1, i);
        float dx = distance_of(l->now, a.x, b.x), dy = distance_of(l->now, a.y, b.y);
        float turn_a = a.s * cache.ac[i] - a.c * cache.as[i];
        float turn_b = b.s * cache.bc[i] - b.c * cache.bs[i];
        float along = (dx - cache.dx[i]) * nx[i] + (dy - cache.dy[i]) * ny[i];
        out[i] = cache.separation[k][i] + along + turn_b * cross_b[i] - turn_a * cross_a[i];
    }
}

/* Predicts normals and start separations of pairs of circles, as circle_circle computes them. */
static void circle_normals(const lanes *l, size_t at, float out[TD_LANES]) {
    float skin;
    read(l->now, TD_SECTION_FIELDS, 0, td_snapshot_field_at(offsetof(thud_world, skin)), &skin,
         sizeof skin);
    for (int i = 0; i < TD_LANES; i++) {
        start a = start_of(l, 0, i), b = start_of(l, 1, i);
        float dx = distance_of(l->now, a.x, b.x), dy = distance_of(l->now, a.y, b.y);
        float length = sqrtf(dx * dx + dy * dy);
        bool apart = length > 1e-18f;
        float nx = apart ? dx / length : 0.0f, ny = apart ? dy / length : 1.0f;
        out[i] = at == offsetof(td_block, nx)   ? nx
                 : at == offsetof(td_block, ny) ? ny
                                                : length - a.half_x - b.half_x - skin;
    }
}

/* Predicts the rows that td_write_points computes from normals and separations of circles. */
static void circle_rows(const lanes *l, size_t at, float out[TD_LANES]) {
    const size_t point = offsetof(td_block, point);
    float nx[TD_LANES], ny[TD_LANES], separation[TD_LANES], inv_inertia[2][TD_LANES];
    float cross[2][TD_LANES], tangent_cross[2][TD_LANES];
    read_row(l, offsetof(td_block, nx), nx);
    read_row(l, offsetof(td_block, ny), ny);
    read_row(l, offsetof(td_block, inv_inertia_a), inv_inertia[0]);
    read_row(l, offsetof(td_block, inv_inertia_b), inv_inertia[1]);
    read_row(l, point + offsetof(td_point, start_separation), separation);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < TD_LANES; i++) {
            float r =
                float_at(l->now, PART(PROXY), l->shape[k][i], offsetof(td_shape_proxy, half_x)) +
                0.5f * separation[i];
            float x = nx[i] * (k ? -r : r), y = ny[i] * (k ? -r : r);
            cross[k][i] = x * ny[i] - y * nx[i];
            tangent_cross[k][i] = -(x * nx[i] + y * ny[i]);
        }
    }
    int side =
        at == offsetof(td_block, tangent_cross_b) || at == point + offsetof(td_point, cross_b);
    if (at == offsetof(td_block, tangent_cross_a) || at == offsetof(td_block, tangent_cross_b)) {
        memcpy(out, tangent_cross[side], sizeof tangent_cross[side]);
    } else if (at == point + offsetof(td_point, cross_a) ||
               at == point + offsetof(td_point, cross_b)) {
        memcpy(out, cross[side], sizeof cross[side]);
    } else {
        const float *a = at == offsetof(td_block, tangent_mass) ? tangent_cross[0] : cross[0];
        const float *b = at == offsetof(td_block, tangent_mass) ? tangent_cross[1] : cross[1];
        for (int i = 0; i < TD_LANES; i++) {
            float inv_mass = 0.0f;
            for (int k = 0; k < 2; k++) {
                inv_mass += float_at(l->now, AWAKE(velocity), l->slot[k][i], 3 * sizeof(float));
            }
            out[i] = inverse_of(inv_mass + inv_inertia[0][i] * a[i] * a[i] +
                                inv_inertia[1][i] * b[i] * b[i]);
        }
    }
}

/* The speed along the normal at which b moves away from a: of the centres, and if `turns` also by
 * the rotations at a point. `section` names the records by awake slot that are read: velocities, or
 * motions, which give a distance in place of a speed. */
static void speeds_of(const lanes *l, const image *from, int section, size_t point, bool turns,
                      float out[TD_LANES]) {
    float nx[TD_LANES], ny[TD_LANES], cross_a[TD_LANES], cross_b[TD_LANES];
    read_normals(l, point, nx, ny, cross_a, cross_b);
    for (int i = 0; i < TD_LANES; i++) {
        float v[2][3] = {{0.0f}};
        for (int k = 0; k < 2; k++) {
            if (l->slot[k][i] > 0) {
                read(from, section, l->slot[k][i], 0, v[k], sizeof v[k]);
            }
        }
        out[i] = (v[1][0] - v[0][0]) * nx[i] + (v[1][1] - v[0][1]) * ny[i];
        if (turns) {
            out[i] = out[i] + v[1][2] * cross_b[i] - v[0][2] * cross_a[i];
        }
    }
}

/* Predicts separations at the end of the step, as relax_blocks computes them: those at its start
 * plus the motion along the normal. In blocks with one point, of circles, rotations do not change
 * them, since the normal goes through the centres. */
static void moved_separations(const lanes *l, size_t point, float out[TD_LANES]) {
    float from[TD_LANES];
    read_row(l, point + offsetof(td_point, start_separation), from);
    speeds_of(l, l->now, AWAKE(delta), point, l->section != TD_SECTION_BLOCKS + TD_FORM_ONE, out);
    for (int i = 0; i < TD_LANES; i++) {
        out[i] = from[i] + out[i];
    }
}

/* Predicts the rows of shapes and awake slots from the row of constraints. */
static void block_indices(const lanes *l, size_t at, uint32_t *out) {
    int32_t constraint[TD_LANES];
    read_row(l, offsetof(td_block, constraint), constraint);
    for (int i = 0; i < TD_LANES; i++) {
        if (constraint[i] < 0) {
            out[i] = 0;
        } else if (at == offsetof(td_block, shape_a) || at == offsetof(td_block, shape_b)) {
            size_t shape = at == offsetof(td_block, shape_a) ? offsetof(td_constraint, shape_a)
                                                             : offsetof(td_constraint, shape_b);
            out[i] = word_at(l->now, TD_SECTION_CONSTRAINTS, constraint[i], shape);
        } else {
            int32_t shape = l->shape[at == offsetof(td_block, b)][i];
            int32_t body = SHAPE(l->now, shape, body);
            out[i] = td_side_of_slot((td_awake_slot){BODY(l->now, body, awake)});
        }
    }
}

static void block_words(const field *f, size_t first, uint32_t *out) {
    lanes l = lanes_of(f, first);
    const size_t points = offsetof(td_block, point);
    bool circle = f->section == TD_SECTION_BLOCKS + TD_FORM_ONE;
    size_t k = circle || f->at < points + sizeof(td_point) ? 0 : 1;
    size_t point = points + k * sizeof(td_point);
    float values[TD_LANES];
    if (f->at == offsetof(td_block, shape_a) || f->at == offsetof(td_block, shape_b) ||
        f->at == offsetof(td_block, a) || f->at == offsetof(td_block, b)) {
        block_indices(&l, f->at, out);
        return;
    }
    if (f->at == offsetof(td_block, inv_inertia_a) || f->at == offsetof(td_block, inv_inertia_b)) {
        int side = f->at == offsetof(td_block, inv_inertia_b);
        for (int i = 0; i < TD_LANES; i++) {
            int32_t slot = l.slot[side][i], body = int_at(l.now, AWAKE(body_of), slot, 0);
            values[i] = slot > 0 ? BODY_FLOAT(l.now, body, inv_inertia) : 0.0f;
        }
    } else if (f->at == point + offsetof(td_point, separation)) {
        moved_separations(&l, point, values);
    } else if (!circle) {
        kept_separations(&l, (int)k, values);
    } else if (f->at == points + sizeof(td_point)) { /* the first row of td_point_history */
        speeds_of(&l, l.base, AWAKE(velocity), points, true, values);
    } else if (f->at == offsetof(td_block, nx) || f->at == offsetof(td_block, ny) ||
               f->at == points + offsetof(td_point, start_separation)) {
        circle_normals(&l, f->at, values);
    } else {
        circle_rows(&l, f->at, values);
    }
    for (int i = 0; i < TD_LANES; i++) {
        out[i] = bits_of(values[i]);
    }
}

/* ---- which column, and when ---- */

/* What a row of a block holds: a point's separation at the start of the step, that at its end, or
 * something else. */
typedef enum separation { NO_SEPARATION, AT_START, AT_END } separation;

static separation separation_of(int section, size_t at) {
    int points = td_form_points((td_block_form)(section - TD_SECTION_BLOCKS));
    for (int k = 0; k < points; k++) {
        size_t point = offsetof(td_block, point) + (size_t)k * sizeof(td_point);
        if (at == point + offsetof(td_point, start_separation)) {
            return AT_START;
        }
        if (at == point + offsetof(td_point, separation)) {
            return AT_END;
        }
    }
    return NO_SEPARATION;
}

/* Whether a row of a block of contacts can be predicted from others. */
static bool row_follows(int section, size_t at) {
    size_t point = offsetof(td_block, point);
    if (section > TD_SECTION_BLOCKS + TD_FORM_TWO_CACHED) {
        return false;
    }
    if (at < point) {
        bool anywhere = at == offsetof(td_block, shape_a) || at == offsetof(td_block, shape_b) ||
                        at == offsetof(td_block, a) || at == offsetof(td_block, b) ||
                        at == offsetof(td_block, inv_inertia_a) ||
                        at == offsetof(td_block, inv_inertia_b);
        bool circle = at == offsetof(td_block, nx) || at == offsetof(td_block, ny) ||
                      at == offsetof(td_block, tangent_mass) ||
                      at == offsetof(td_block, tangent_cross_a) ||
                      at == offsetof(td_block, tangent_cross_b);
        return anywhere || (circle && section == TD_SECTION_BLOCKS + TD_FORM_ONE);
    }
    if (section == TD_SECTION_BLOCKS + TD_FORM_ONE) {
        return at < point + sizeof(td_point) + sizeof(f8) &&
               at != point + offsetof(td_point, normal_impulse);
    }
    return separation_of(section, at) != NO_SEPARATION;
}

bool td_packed_follows(const td_packed_field *f) {
    bool base = f->pair->base.bytes;
    int section = f->section;
    if (section == TD_SECTION_BODIES) {
        return f->at == offsetof(td_body, inv_mass) || f->at == offsetof(td_body, inv_inertia) ||
               f->at == offsetof(td_body, max_extent);
    }
    if (section == TD_SECTION_CONSTRAINTS) {
        return f->at == offsetof(td_constraint, body) ||
               f->at == offsetof(td_constraint, body) + sizeof(td_body_index);
    }
    if (section >= TD_SECTION_BLOCKS && section < TD_SECTION_PARTS) {
        return row_follows(section, f->at);
    }
    if (section == AWAKE(velocity)) {
        return f->at == 3 * sizeof(float);
    }
    if (section == PART(POSE)) {
        return f->at < offsetof(td_pose, c) ? base : f->at < offsetof(td_pose, padding);
    }
    if (section == PART(PROXY)) {
        return f->at < offsetof(td_shape_proxy, x) || f->at >= offsetof(td_shape_proxy, fat);
    }
    if (section >= PART(PROXY_SETS) && section < TD_SECTION_RULED) {
        int part = (section - PART(PROXY_SETS)) % TD_SNAPSHOT_PROXY_SET_PARTS;
        return (part >= TD_SNAPSHOT_MIN_X && part <= TD_SNAPSHOT_PLACES_MOVED) ||
               part == TD_SNAPSHOT_ANCHOR_X || part == TD_SNAPSHOT_ANCHOR_Y;
    }
    return section == PART(PREVIOUS_FAT) || section == AWAKE(reach) || section == AWAKE(mass) ||
           section == AWAKE(inertia) || section == AWAKE(gravity_mass) ||
           (section == AWAKE(delta) && f->at < 3 * sizeof(float));
}

void td_packed_known(const void *context, size_t first, int count, uint32_t *out) {
    const field *f = context;
    int section = f->section;
    if (section >= TD_SECTION_BLOCKS && section < TD_SECTION_PARTS) {
        block_words(f, first, out);
        return;
    }
    uint32_t (*word_of)(const field *f, int32_t record) =
        section == TD_SECTION_BODIES        ? body_word
        : section == TD_SECTION_CONSTRAINTS ? constraint_word
        : section == PART(POSE)             ? pose_word
        : section == PART(PROXY)            ? proxy_word
        : section == PART(PREVIOUS_FAT)     ? previous_fat_word
        : section < PART(MOVED)             ? awake_word
                                            : proxy_set_word;
    for (int i = 0; i < count; i++) {
        out[i] = word_of(f, (int32_t)first + i);
    }
}

void td_packed_order(int order[TD_SECTION_COUNT]) {
    const int early[] = {PART(MARKS), AWAKE(body_of)},
              late[] = {PART(POSE), PART(PROXY), PART(PREVIOUS_FAT)};
    int count = 0;
    for (int k = 0; k < TD_SECTION_BLOCKS; k++) {
        order[count++] = k;
    }
    for (size_t i = 0; i < sizeof early / sizeof *early; i++) {
        order[count++] = early[i];
    }
    for (int k = PART(AWAKE); k < PART(MOVED); k++) {
        if (k != AWAKE(body_of)) {
            order[count++] = k;
        }
    }
    for (size_t i = 0; i < sizeof late / sizeof *late; i++) {
        order[count++] = late[i];
    }
    for (int k = PART(MOVED); k < TD_SECTION_COUNT; k++) {
        order[count++] = k;
    }
    for (int k = TD_SECTION_BLOCKS; k < TD_SECTION_PARTS; k++) {
        order[count++] = k;
    }
}

int td_packed_pass_of(int section, size_t at) {
    enum { CONSTRAINTS, HEAD, START_OF_CIRCLES, REST, START, END };
    if (section < TD_SECTION_BLOCKS || section >= TD_SECTION_PARTS) {
        return 0;
    }
    switch (separation_of(section, at)) {
    case AT_START:
        return section == TD_SECTION_BLOCKS + TD_FORM_ONE ? START_OF_CIRCLES : START;
    case AT_END:
        return END;
    case NO_SEPARATION:
        break;
    }
    return at == offsetof(td_block, constraint)    ? CONSTRAINTS
           : at < offsetof(td_block, tangent_mass) ? HEAD
                                                   : REST;
}
