/* packed_known.c: predicts words of a snapshot from others, for packed.c. Much of a snapshot is
 * there twice, or follows from the rest: proxies from poses, fat bounds from proxies, poses from
 * the base's and the motion of the step, separations from motions. Each function here repeats what
 * the engine does, in the same operations, so that mostly the prediction is exact. Where it is not
 * (the snapshots are several steps apart, or an edit came between), the word costs some bytes more.
 *
 * Words are read from the snapshot as far as it was packed, and from the base. Indices may be
 * anything, since packed bytes may be forged: what is not there reads as 0. */
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

/* The bits of a number. What is no number has the same ones everywhere: processors differ there. */
static uint32_t bits_of(float number) {
    uint32_t bits;
    if (number != number) {
        return 0;
    }
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* The field of bodies, shapes and proxies. */
#define BODY(i, body, name) int_at(i, TD_SECTION_BODIES, body, offsetof(td_body, name))
#define BODY_FLOAT(i, body, name) float_at(i, TD_SECTION_BODIES, body, offsetof(td_body, name))
#define SHAPE(i, shape, name) int_at(i, TD_SECTION_SHAPES, shape, offsetof(td_shape, name))

static bool shape_turns(const image *i, int32_t shape) {
    return byte_at(i, TD_SECTION_SHAPES, shape, offsetof(td_shape, kind)) == THUD_SHAPE_OBB;
}

/* ---- motion ---- */

/* The motion of the last step: x, y, angle; of a body without an awake slot 0. */
static void motion_of(const image *i, int32_t body, float motion[3]) {
    int32_t slot = BODY(i, body, awake);
    memset(motion, 0, 3 * sizeof *motion);
    if (slot > 0) {
        read(i, AWAKE(delta), slot, 0, motion, 3 * sizeof *motion);
    }
}

/* Whole quanta, as finalize adds them; 0 for what is too large. */
static uint64_t quanta_of(double quanta) {
    return quanta < 0x1p51 && quanta > -0x1p51 ? (uint64_t)td_round_increment(quanta) : 0;
}

static uint64_t length_quanta(const image *i, float length) {
    return quanta_of((double)length * (TD_FIXED_ONE / i->head.length_scale));
}

static uint32_t angle_quanta(float radians) {
    return (uint32_t)quanta_of((double)radians * (1.0 / TD_RADIANS_A_QUANTUM));
}

/* The word of a 64-bit number whose words are a column each. Where the low word was read before,
 * the high one is that of the number nearest to the prediction with this low word. */
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

/* A body's pose: the base's, and the motion of one step; cosine and sine from the angle. */
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

/* The tight bounds of a shape, with its margin around them: shape_place.c. */
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

/* A shape's proxy, from its body's pose, or as it stood to the body in the base. */
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

/* Fat bounds before the shape moved. */
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

/* The copies of bounds and marks in a proxy set: wide_proxy_set.c, and store_anchors of grid.c. */
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
    return word_at(now, PART(PROXY), shape,
                   offsetof(td_shape_proxy, fat) +
                       (size_t)(part - TD_SNAPSHOT_MIN_X) * sizeof(int32_t));
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

/* What the awake slot has of its body: awake.c. */
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

/* A lane of a block. */
typedef struct lane {
    const image *now;
    int section;
    int32_t block;
    size_t number; /* the lane's */
} lane;

/* The lane's word in the row at byte `at` of its block. */
static int32_t row_int(const lane *l, size_t at) {
    return int_at(l->now, l->section, l->block, at + l->number * sizeof(int32_t));
}

static float row_float(const lane *l, size_t at) {
    return float_at(l->now, l->section, l->block, at + l->number * sizeof(float));
}

#define ROW(l, name) row_float(l, offsetof(td_block, name))

/* A side of a contact at the start of the step, when its manifold was computed. */
typedef struct side {
    td_position center; /* of the shape */
    float c, s, half_x;
    float velocity[3], inv_mass, inv_inertia; /* the velocity is that of the base */
    float motion[3];                          /* since then */
} side;

static side side_of(const field *f, int32_t shape) {
    const image *now = &f->pair->now;
    int32_t body = SHAPE(now, shape, body), slot = BODY(now, body, awake);
    td_shape_proxy p;
    memset(&p, 0, sizeof p);
    read(now, PART(PROXY), shape, 0, &p, sizeof p);
    side found = {.center = p.center, .c = p.c, .s = p.s, .half_x = p.half_x};
    motion_of(now, body, found.motion);
    found.center.x = (int64_t)((uint64_t)p.center.x - length_quanta(now, found.motion[0]));
    found.center.y = (int64_t)((uint64_t)p.center.y - length_quanta(now, found.motion[1]));
    if (shape_turns(now, shape)) {
        uint32_t angle = word_at(now, PART(POSE), body, offsetof(td_pose, angle));
        td_angle_turn(angle - angle_quanta(found.motion[2]), &found.c, &found.s);
    }
    if (slot > 0) {
        read(&f->pair->base, AWAKE(velocity), slot, 0, found.velocity, sizeof found.velocity);
        found.inv_mass = BODY_FLOAT(now, body, inv_mass);
        found.inv_inertia = BODY_FLOAT(now, body, inv_inertia);
    }
    return found;
}

/* The distance of b's centre from a's along an axis: td_read_shapes. */
static float distance_of(const image *now, int64_t a, int64_t b) {
    int64_t quanta = (int64_t)((uint64_t)b - (uint64_t)a);
    return (float)(now->head.length_scale / TD_FIXED_ONE) * (float)(double)quanta;
}

/* The separation of a kept manifold: td_cached_lanes. */
static float kept_separation(const lane *l, int points, int k, const side *a, const side *b,
                             float dx, float dy) {
    size_t kept = offsetof(td_block, point) +
                  (size_t)points * (sizeof(td_point) + sizeof(td_point_history)) +
                  sizeof(td_surface);
    size_t point = offsetof(td_block, point) + (size_t)k * sizeof(td_point);
#define KEPT(name) row_float(l, kept + offsetof(td_manifold_cache, name))
    float turn_a = a->s * KEPT(ac) - a->c * KEPT(as), turn_b = b->s * KEPT(bc) - b->c * KEPT(bs);
    float along = (dx - KEPT(dx)) * ROW(l, nx) + (dy - KEPT(dy)) * ROW(l, ny);
    float separation = row_float(l, kept + offsetof(td_manifold_cache, separation) +
                                        (size_t)k * TD_LANES * sizeof(float));
#undef KEPT
    return separation + along + turn_b * row_float(l, point + offsetof(td_point, cross_b)) -
           turn_a * row_float(l, point + offsetof(td_point, cross_a));
}

/* The manifold of two circles, in the block's rows: circle_circle, td_write_points. */
static uint32_t circle_word(const image *now, size_t at, const side *a, const side *b, float dx,
                            float dy) {
    float length = sqrtf(dx * dx + dy * dy), separation = length - a->half_x - b->half_x;
    float nx = length > 1e-18f ? dx / length : 0.0f, ny = length > 1e-18f ? dy / length : 1.0f;
    float ra = a->half_x + 0.5f * separation, rb = -(b->half_x + 0.5f * separation);
    float rax = nx * ra, ray = ny * ra, rbx = nx * rb, rby = ny * rb;
    float tangent_a = -(rax * nx + ray * ny), tangent_b = -(rbx * nx + rby * ny);
    float cross_a = rax * ny - ray * nx, cross_b = rbx * ny - rby * nx;
    float inv_mass = a->inv_mass + b->inv_mass, ia = a->inv_inertia, ib = b->inv_inertia;
    float normal_velocity =
        (b->velocity[0] - a->velocity[0]) * nx + (b->velocity[1] - a->velocity[1]) * ny;
    float skin;
    read(now, TD_SECTION_FIELDS, 0, td_snapshot_field_at(offsetof(thud_world, skin)), &skin,
         sizeof skin);
    const size_t point = offsetof(td_block, point);
    const struct {
        size_t at;
        float value;
    } rows[] = {
        {offsetof(td_block, nx), nx},
        {offsetof(td_block, ny), ny},
        {offsetof(td_block, tangent_cross_a), tangent_a},
        {offsetof(td_block, tangent_cross_b), tangent_b},
        {offsetof(td_block, tangent_mass),
         inverse_of(inv_mass + ia * tangent_a * tangent_a + ib * tangent_b * tangent_b)},
        {point + offsetof(td_point, cross_a), cross_a},
        {point + offsetof(td_point, cross_b), cross_b},
        {point + offsetof(td_point, normal_mass),
         inverse_of(inv_mass + ia * cross_a * cross_a + ib * cross_b * cross_b)},
        {point + offsetof(td_point, start_separation), separation - skin},
        {point + sizeof(td_point) + offsetof(td_point_history, normal_velocity),
         normal_velocity + b->velocity[2] * cross_b - a->velocity[2] * cross_a},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (rows[i].at == at) {
            return bits_of(rows[i].value);
        }
    }
    return 0;
}

/* The separation after the motion of the step: relax_blocks. */
static float moved_separation(const lane *l, size_t point, const side *a, const side *b) {
    float opened =
        (b->motion[0] - a->motion[0]) * ROW(l, nx) + (b->motion[1] - a->motion[1]) * ROW(l, ny);
    if (l->section != TD_SECTION_BLOCKS + TD_FORM_ONE) {
        opened = opened + b->motion[2] * row_float(l, point + offsetof(td_point, cross_b)) -
                 a->motion[2] * row_float(l, point + offsetof(td_point, cross_a));
    }
    return row_float(l, point + offsetof(td_point, start_separation)) + opened;
}

static uint32_t block_word(const field *f, size_t word) {
    lane l = {&f->pair->now, f->section, (int32_t)(word / TD_LANES), word % TD_LANES};
    int32_t constraint = row_int(&l, offsetof(td_block, constraint));
    if (constraint < 0) {
        return 0;
    }
    int32_t shape_a =
        int_at(l.now, TD_SECTION_CONSTRAINTS, constraint, offsetof(td_constraint, shape_a));
    int32_t shape_b =
        int_at(l.now, TD_SECTION_CONSTRAINTS, constraint, offsetof(td_constraint, shape_b));
    switch (f->at) {
    case offsetof(td_block, shape_a):
        return (uint32_t)shape_a;
    case offsetof(td_block, shape_b):
        return (uint32_t)shape_b;
    case offsetof(td_block, a):
    case offsetof(td_block, b): {
        int32_t body = SHAPE(l.now, f->at == offsetof(td_block, a) ? shape_a : shape_b, body);
        return td_side_of_slot((td_awake_slot){BODY(l.now, body, awake)});
    }
    default:
        break;
    }
    side a = side_of(f, shape_a), b = side_of(f, shape_b);
    if (f->at == offsetof(td_block, inv_inertia_a) || f->at == offsetof(td_block, inv_inertia_b)) {
        return bits_of(f->at == offsetof(td_block, inv_inertia_a) ? a.inv_inertia : b.inv_inertia);
    }
    size_t k = f->at < offsetof(td_block, point) + sizeof(td_point) ? 0 : 1;
    size_t point = offsetof(td_block, point) + k * sizeof(td_point);
    if (f->at == point + offsetof(td_point, separation)) {
        return bits_of(moved_separation(&l, point, &a, &b));
    }
    float dx = distance_of(l.now, a.center.x, b.center.x);
    float dy = distance_of(l.now, a.center.y, b.center.y);
    if (f->section == TD_SECTION_BLOCKS + TD_FORM_ONE) {
        return circle_word(l.now, f->at, &a, &b, dx, dy);
    }
    int points = td_form_points((td_block_form)(f->section - TD_SECTION_BLOCKS));
    return bits_of(kept_separation(&l, points, (int)k, &a, &b, dx, dy));
}

/* ---- which column, and when ---- */

/* Whether the row of a block of contacts may follow from others. */
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
    return td_packed_pass_of(section, at) > 1;
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

uint32_t td_packed_known(const void *context, size_t word) {
    const field *f = context;
    int32_t record = (int32_t)word;
    int section = f->section;
    return section == TD_SECTION_BODIES        ? body_word(f, record)
           : section == TD_SECTION_CONSTRAINTS ? constraint_word(f, record)
           : section < TD_SECTION_PARTS        ? block_word(f, word)
           : section == PART(POSE)             ? pose_word(f, record)
           : section == PART(PROXY)            ? proxy_word(f, record)
           : section == PART(PREVIOUS_FAT)     ? previous_fat_word(f, record)
           : section < PART(MOVED)             ? awake_word(f, record)
                                               : proxy_set_word(f, record);
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
    if (section < TD_SECTION_BLOCKS || section >= TD_SECTION_PARTS) {
        return 0;
    }
    int points = td_form_points((td_block_form)(section - TD_SECTION_BLOCKS));
    for (int k = 0; k < points; k++) {
        size_t point = offsetof(td_block, point) + (size_t)k * sizeof(td_point);
        if (at == point + offsetof(td_point, start_separation)) {
            return 2;
        }
        if (at == point + offsetof(td_point, separation)) {
            return 3;
        }
    }
    return at == offsetof(td_block, constraint) ? 0 : 1;
}
