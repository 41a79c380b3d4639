/* wide_finalize.c: the end of the step, for eight awake bodies at a time. For all bodies: clamps
 * velocities, adds up kinetic energy and the work of gravity, and counts idle times. For bodies
 * with one centred shape (its centre is the centre of mass): moves the pose, the shape and, where
 * the shape left them, its fat bounds; lists those that moved far, for continuous detection. All
 * other bodies (several shapes or none, values that are not finite, motion too large for the
 * arithmetic here) are listed in scratch.odd, and finalize.c moves them one by one. */
#include "solver/motion.h"
#include "base/rotation.h"
#include "solver/wide_energy.h"
#include "state/shape.h"
#include "state/world.h"

#include <stddef.h>

/* Cosine and sine of eight angles, by the operations of td_angle_turn in the same order, so that
 * both give the same bits: the quarter turn nearest to the angle, and a polynomial of the rest. */
TD_INLINE void turn_of(u8 angle, f8 *c, f8 *s) {
    u8 quarter = (angle + 0x20000000u) >> 30;
    f8 x = __builtin_convertvector((i8)(angle - (quarter << 30)), f8) *
           f8_all((float)TD_RADIANS_A_QUANTUM);
    f8 xx = x * x, one = f8_all(1.0f);
    f8 sine = x + x * xx * (TD_SIN3 + xx * (TD_SIN5 + xx * (TD_SIN7 + xx * TD_SIN9)));
    f8 cosine = one + xx * (TD_COS2 + xx * (TD_COS4 + xx * (TD_COS6 + xx * TD_COS8)));
    i8 odd = (i8)((quarter & 1u) == 1u);
    *c = f8_flip(f8_pick(odd, sine, cosine), (i8)(((quarter + 1u) & 2u) == 2u));
    *s = f8_flip(f8_pick(odd, cosine, sine), (i8)((quarter & 2u) == 2u));
}

/* Rotations in radians, |radians| < pi / 2, as whole angle quanta. TD_ROUND_SHIFT leaves the
 * rounded integer in the low bits of a double; (l4) keeps the bits, and of these the low 32 are
 * taken. (The low 32 bits of TD_ROUND_BITS are 0, so that nothing has to be subtracted.) */
TD_INLINE u8 quanta_of(f8 radians) {
    d4 low = __builtin_convertvector(__builtin_shufflevector(radians, radians, 0, 1, 2, 3), d4);
    d4 high = __builtin_convertvector(__builtin_shufflevector(radians, radians, 4, 5, 6, 7), d4);
    low = low * (1.0 / TD_RADIANS_A_QUANTUM) + TD_ROUND_SHIFT;
    high = high * (1.0 / TD_RADIANS_A_QUANTUM) + TD_ROUND_SHIFT;
    i4 a = __builtin_convertvector((l4)low, i4), b = __builtin_convertvector((l4)high, i4);
    return (u8)__builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

/* Appends the slot first + i to the list for each bit i that is set. */
static void list_lanes(td_array *list, td_awake_slot first, unsigned bits) {
    for (; bits; bits &= bits - 1) {
        td_push_slot(list, (td_awake_slot){first.at + __builtin_ctz(bits)});
    }
}

/* Adds the time step to the idle time of each slow body, and sets that of every other body to 0. A
 * body is slow if both its centre and, by rotation, its farthest point (at max_extent) move slower
 * than TD_SLEEP_SPEED length scales a second. Of the lanes in `here`, counts the bodies that are
 * idle long enough to sleep, and those that will be after one more step (drowsy). */
TD_INLINE void count_idle(thud_world *w, td_finalize_part *part, td_awake_slot first,
                          const td_rows *v, f8 max_extent, i8 here) {
    f8 still = f8_all(TD_SLEEP_SPEED * w->length_scale), dt = f8_all((float)w->def.time_step);
    float *at = td_row(&w->idle, first);
    i8 rests = (v->x * v->x + v->y * v->y < still * still) & (f8_abs(v->z) * max_extent < still);
    f8 idle = f8_keep(rests, f8_load(at) + dt);
    __builtin_memcpy(at, &idle, sizeof idle);
    part->idle += __builtin_popcount(i8_bits(here & (idle >= f8_all(TD_SLEEP_TIME))));
    part->drowsy += __builtin_popcount(i8_bits(here & (idle + dt >= f8_all(TD_SLEEP_TIME))));
}

/* Tight bounds of eight shapes, in coarse quanta. */
typedef struct bounds8 {
    i8 min_x, min_y, max_x, max_y;
} bounds8;

TD_INLINE i8 wrap_add(i8 a, i8 b) {
    return (i8)((u8)a + (u8)b);
}

/* Bounds around centres (x, y). `shape`: cosine, sine and half extents; a shape that does not turn
 * has c = 1 and s = 0. The half extents along the world's axes are |c| hx + |s| hy and
 * |s| hx + |c| hy, plus two quanta that take up rounding. The centres are rounded down, so that the
 * maxima get one quantum more, as in td_bounds_about. */
TD_INLINE bounds8 tight_bounds(i8 x, i8 y, const td_rows *shape, f8 to_coarse) {
    f8 ca = f8_abs(shape->x), sa = f8_abs(shape->y);
    f8 hx = ca * shape->z + sa * shape->w, hy = sa * shape->z + ca * shape->w;
    i8 half_x = __builtin_convertvector(hx * to_coarse, i8) + i8_all(2);
    i8 half_y = __builtin_convertvector(hy * to_coarse, i8) + i8_all(2);
    return (bounds8){i8_wrap_sub(x, half_x), i8_wrap_sub(y, half_y),
                     wrap_add(x, half_x + i8_all(1)), wrap_add(y, half_y + i8_all(1))};
}

/* Gives a shape that left its fat bounds new fat bounds, and lists it as moved. */
TD_INLINE void renew_bounds(thud_world *w, td_array *moved, int shape, f4 fat) {
    td_shape_mark_moved_in(w, moved, shape);
    __builtin_memcpy(td_fat_at(w, shape), &fat, sizeof fat);
}

/* Loads 16 bytes at `offset` of each of eight records of any type: the k-th words of all records
 * are in the k-th row. */
TD_INLINE td_rows load_eight(const void *const records[TD_LANES], size_t offset) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)(const void *)((const char *)records[i] + offset);
    }
    return td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                        f8_two(r[3], r[7]));
}

TD_INLINE void store_eight(void *const records[TD_LANES], size_t offset, td_rows v) {
    f4 r[TD_LANES];
    td_transpose_back(v, r);
    for (int i = 0; i < TD_LANES; i++) {
        __builtin_memcpy((char *)records[i] + offset, &r[i], sizeof r[i]);
    }
}

#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#define TD_FIRST_HALF_SHIFT 32
#else
#define TD_FIRST_HALF_SHIFT 0
#endif

/* Adds the motion of eight bodies to their positions, and copies them to the centres of their
 * shapes. Returns the new positions in coarse quanta, the unit of bounds: x in .x and y in .z. */
TD_INLINE td_rows move_eight(const thud_world *w, td_awake_slot first, void *const poses[TD_LANES],
                             void *const proxies[TD_LANES]) {
    f4 coarse[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        const float *delta = td_row(&w->delta, (td_awake_slot){first.at + i});
        d2 quanta = {(double)delta[0], (double)delta[1]};
        l2 center;
        /* TD_ROUND_SHIFT leaves the rounded integer in the low bits of the double (base/fixed.h);
         * the cast keeps the bits. Unsigned, since the motion of odd bodies, which are on spare
         * records here, may wrap around. */
        v2 moved = (v2)(quanta * w->to_fixed + TD_ROUND_SHIFT) - (uint64_t)TD_ROUND_BITS;
        __builtin_memcpy(&center, poses[i], sizeof center);
        center = (l2)((v2)center + moved);
        __builtin_memcpy(poses[i], &center, sizeof center);
        __builtin_memcpy(proxies[i], &center, sizeof center);
        /* The low half of each shifted 64-bit coordinate is the coarse one. On a little-endian
         * machine it is the first half; a big-endian one shifts it there. */
        coarse[i] = (f4)((v2)center >> TD_COARSE_SHIFT << TD_FIRST_HALF_SHIFT);
    }
    f8 r[4];
    for (int i = 0; i < 4; i++) {
        r[i] = __builtin_shufflevector(coarse[i], coarse[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    }
    return td_transpose(r[0], r[1], r[2], r[3]);
}

/* Turns eight rotations (cosines and sines in the first two rows) further by the angles of the
 * shapes in their bodies' frames, for the lanes in `bits`; by the operations of compute_place in
 * shape_place.c. */
TD_INLINE void turn_by_own_angles(const thud_world *w, const int32_t *shapes, unsigned bits,
                                  float *rows) {
    for (; bits; bits &= bits - 1) {
        int i = __builtin_ctz(bits);
        const td_shape *shape = td_shape_at(w, shapes[i]);
        float c = rows[i], s = rows[i + TD_LANES];
        rows[i] = c * shape->angle_c - s * shape->angle_s;
        rows[i + TD_LANES] = s * shape->angle_c + c * shape->angle_s;
    }
}

/* Updates poses, shapes and bounds of the bodies in slots first + i for the bits i that are set.
 * The other lanes work on a spare record. */
TD_INLINE void place_lanes(thud_world *w, td_finalize_part *part, td_awake_slot first, f8 turn,
                           unsigned bits) {
    const int32_t *bodies = (const int32_t *)w->body_of.data + first.at;
    const int32_t *lone = (const int32_t *)w->lone.data + first.at;
    td_pose spare_pose = {0};
    td_shape_proxy spare_proxy = {0};
    void *poses[TD_LANES], *proxies[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        bool here = bits >> i & 1;
        poses[i] = here ? (void *)((td_pose *)w->pose.data + bodies[i]) : &spare_pose;
        proxies[i] = here ? (void *)((td_shape_proxy *)w->proxy.data + lone[i]) : &spare_proxy;
    }
    td_rows coarse = move_eight(w, first, poses, proxies);
    td_rows tail = load_eight((const void *const *)poses, offsetof(td_pose, angle));
    u8 angle = (u8)tail.x + quanta_of(turn);
    tail.x = (f8)angle;
    turn_of(angle, &tail.y, &tail.z);
    store_eight(poses, offsetof(td_pose, angle), tail);

    td_rows shape = load_eight((const void *const *)proxies, offsetof(td_shape_proxy, c));
    /* x, y, turns (0: the shape does not turn, 1: with its body, 2: it also has an angle of its
     * own) and margin */
    td_rows rest = load_eight((const void *const *)proxies, offsetof(td_shape_proxy, x));
    i8 turns = rest.z > f8_all(0.0f);
    shape.x = f8_pick(turns, tail.y, f8_all(1.0f));
    shape.y = f8_keep(turns, tail.z);
    turn_by_own_angles(w, lone, i8_bits(rest.z > f8_all(1.0f)), (float *)&shape);
    store_eight(proxies, offsetof(td_shape_proxy, c), shape);

    td_rows fat = load_eight((const void *const *)proxies, offsetof(td_shape_proxy, fat));
    bounds8 tight = tight_bounds((i8)coarse.x, (i8)coarse.z, &shape, f8_all((float)w->to_coarse));
    i8 outside = i8_wrap_sub(tight.min_x, (i8)fat.x) | i8_wrap_sub(tight.min_y, (i8)fat.y) |
                 i8_wrap_sub((i8)fat.z, tight.max_x) | i8_wrap_sub((i8)fat.w, tight.max_y);
    unsigned left = bits & i8_bits(outside);
    if (left) {
        i8 margin = (i8)rest.w;
        f4 grown[TD_LANES];
        td_transpose_back((td_rows){(f8)i8_wrap_sub(tight.min_x, margin),
                                    (f8)i8_wrap_sub(tight.min_y, margin),
                                    (f8)wrap_add(tight.max_x, margin),
                                    (f8)wrap_add(tight.max_y, margin)},
                          grown);
        part->has_moved = true;
        for (; left; left &= left - 1) {
            int i = __builtin_ctz(left);
            renew_bounds(w, part->moved, lone[i], grown[i]);
        }
    }
}

/* Clamps the finite velocities of the rows in `bits`, which the last relax pass may have left
 * beyond the bounds. A velocity that is not finite is left for finalize.c to find. */
static void clamp_speeds(float (*velocity)[4], unsigned bits, const float max[3]) {
    for (; bits; bits &= bits - 1) {
        float *row = velocity[__builtin_ctz(bits)];
        bool finite = td_finite((double)row[0] + (double)row[1] + (double)row[2]);
        for (int k = 0; k < 3 && finite; k++) {
            row[k] = td_max_float(-max[k], td_min_float(row[k], max[k]));
        }
    }
}

/* The rows whose velocity is beyond the bounds. */
TD_INLINE unsigned too_fast(td_rows v, i8 here, const float max[3]) {
    return i8_bits(here & ((f8_abs(v.x) > f8_all(max[0])) | (f8_abs(v.y) > f8_all(max[1])) |
                           (f8_abs(v.z) > f8_all(max[2]))));
}

td_finalize_bodies_fn TD_WIDE(td_finalize_bodies);
void TD_WIDE(td_finalize_bodies)(thud_world *w, td_finalize_part *part) {
    float(*velocity)[4] = w->velocity.data;
    const float(*delta)[4] = w->delta.data;
    const float *mass = w->mass.data, *inertia = w->inertia.data,
                *gravity_mass = w->gravity_mass.data;
    i8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    /* Motions below `far` are below the 2^51 quanta up to which TD_ROUND_SHIFT rounds. */
    f8 zero = f8_all(0.0f), far = f8_all((float)(0x1p50 / w->to_fixed));
    f8 gx = f8_all(w->def.gravity.x), gy = f8_all(w->def.gravity.y);
    td_energy_sums *sums = part->sums;
    float linear = w->def.maximum_speed * w->length_scale,
          max_speed[3] = {linear, linear, THUD_ANGULAR_SPEED_MAX};
    int end = part->end;
    for (td_awake_slot first = {part->first}; first.at < end; first.at += TD_LANES) {
        int at = first.at;
        i8 slot = i8_all(at) + lane, here = (slot > i8_all(0)) & (slot < i8_all(end));
        td_rows v = td_load_rows((const float(*)[4])velocity + at);
        unsigned fast_rows = too_fast(v, here, max_speed);
        if (fast_rows) {
            clamp_speeds(velocity + at, fast_rows, max_speed);
            v = td_load_rows((const float(*)[4])velocity + at);
        }
        td_rows d = td_load_rows(delta + at);
        f8 reach0 = f8_load(td_row(&w->reach, first));
        f8 reach1 = f8_load(td_row(&w->reach, first) + TD_LANES);
        f8 min_extent = __builtin_shufflevector(reach0, reach1, 0, 2, 4, 6, 8, 10, 12, 14);
        f8 max_extent = __builtin_shufflevector(reach0, reach1, 1, 3, 5, 7, 9, 11, 13, 15);
        f8 sum = v.x + v.y + v.z + (d.x + d.y + d.z);
        i8 finite = sum - sum == zero; /* not where a number is infinite or not a number */
        f8 max = f8_all(TD_ENERGY_MAX);
        f8 fallen = f8_clamp(f8_load(gravity_mass + at) * (gx * d.x + gy * d.y), -max, max);
        f8 moving = td_kinetic_of(&v, mass + at, inertia + at);
        sums->kinetic += d4_folded(f8_keep(here & finite, moving));
        sums->gained += d4_folded(f8_keep(here & finite, fallen));
        sums += part->sums_step;
        if (w->def.sleeping) {
            count_idle(w, part, first, &v, max_extent, here & finite);
        }
        /* quanta_of converts rotations below pi / 2. */
        i8 easy = here & finite & (i8_load(TD_AT(int32_t, &w->lone, at)) >= i8_all(0)) &
                  (f8_abs(d.x) < far) & (f8_abs(d.y) < far) & (f8_abs(d.z) < f8_all(1.5f));
        list_lanes(part->odd, first, i8_bits(here & ~easy));
        if (w->detections[TD_RANK_CONTINUOUS]) {
            /* Dynamic bodies (their inverse mass is above 0) that moved by more than half of their
             * least extent. */
            i8 fast = easy & (v.w > zero) &
                      (d.x * d.x + d.y * d.y > f8_all(0.25f) * min_extent * min_extent);
            list_lanes(part->fast, first, i8_bits(fast));
        }
        unsigned bits = i8_bits(easy);
        if (bits) {
            place_lanes(w, part, first, d.z, bits);
        }
    }
}

td_kinetic_energy_fn TD_WIDE(td_kinetic_energy);
double TD_WIDE(td_kinetic_energy)(const thud_world *w) {
    const float(*velocity)[4] = w->velocity.data;
    const float *mass = w->mass.data, *inertia = w->inertia.data;
    i8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    d4 kinetic = {0};
    int count = w->body_of.count;
    for (int first = 0; first < count; first += TD_LANES) {
        td_rows v = td_load_rows(velocity + first);
        i8 slot = i8_all(first) + lane, here = (slot > i8_all(0)) & (slot < i8_all(count));
        kinetic += d4_folded(f8_keep(here, td_kinetic_of(&v, mass + first, inertia + first)));
    }
    return td_total_of(&kinetic);
}
