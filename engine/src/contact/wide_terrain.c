/* wide_terrain.c: manifolds of circles and boxes with terrain segments. A manifold is kept while
 * the shape hardly moves (wide_manifold_cache.h). New ones are computed one by one in double
 * precision, relative to the terrain's origin (terrain/terrain_manifold.c), and written eight at a
 * time. */
#include "state/body.h"
#include "state/shape.h"
#include "terrain/terrain_manifold.h"
#include "contact/wide_manifold_cache.h"

/* The manifolds of eight lanes, relative to the centres of the shapes b. */
typedef struct terrain8 {
    f8 nx, ny, separation[2], x[2], y[2];
    i8 feature, valid[2];
} terrain8;

/* Computes the manifold of one lane. The feature holds the ids of up to two points, 16 bits each; 0
 * is no point. */
static void one_lane(const thud_world *w, const td_block *block, int lane, float margin,
                     terrain8 *out) {
    int a = block->shape_a[lane], b = block->shape_b[lane];
    const td_contact *contact = td_contact_at(w, block->constraint[lane]);
    thud_terrain terrain = td_terrain_view(w, a);
    thud_geometry placed = td_shape_instance(w, b, td_shape_proxy_at(w, a)->center);
    td_terrain_manifold m;
    td_terrain_segment_manifold(&terrain, contact->child, &placed,
                                td_shape_at(w, a)->internal_edges, (double)margin, &m);
    out->nx[lane] = (float)m.nx;
    out->ny[lane] = (float)m.ny;
    uint32_t feature = 0;
    for (int k = 0; k < m.count; k++) {
        out->valid[k][lane] = -1;
        out->separation[k][lane] = (float)m.point[k].separation;
        out->x[k][lane] = (float)m.point[k].px;
        out->y[k][lane] = (float)m.point[k].py;
        feature |= ((m.point[k].id & 0x7fffu) + 1u) << (16 * k);
    }
    out->feature[lane] = (int32_t)feature;
}

/* In the lanes in `recomputed`, moves each impulse to the point with the same id, and drops the
 * others.
 */
TD_INLINE void carry_impulses(td_block *block, i8 feature, i8 recomputed, int points) {
    i8 old = i8_load((const int32_t *)block->feature), low = i8_all(0xffff), zero = i8_all(0);
    feature = i8_pick(recomputed, feature, old);
    __builtin_memcpy(block->feature, &feature, sizeof feature);
    f8 n[2] = {block->point[0].normal_impulse, block->point[points - 1].normal_impulse};
    i8 old_id[2] = {old & low, (old >> 16) & low};
    i8 new_id[2] = {feature & low, (feature >> 16) & low};
    i8 kept = ~recomputed;
    for (int k = 0; k < points; k++) {
        i8 first = (new_id[k] == old_id[0]) & (new_id[k] != zero);
        i8 second = (new_id[k] == old_id[1]) & (new_id[k] != zero);
        block->point[k].normal_impulse = f8_pick(first, n[0], f8_keep(second, n[1]));
        kept |= first | second;
    }
    block->tangent_impulse = f8_keep(kept, block->tangent_impulse);
}

/* The centres of mass of the bodies b, in units of 256 position quanta and modulo 2^32: the
 * difference of two is exact for what a body moves in a step, however far from the origin it is. */
TD_INLINE void read_places(const thud_world *w, const td_block *block, i8 *x, i8 *y) {
    int32_t px[TD_LANES], py[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        const td_shape_proxy *s = td_shape_proxy_at(w, block->shape_b[i]);
        px[i] = (int32_t)(uint32_t)((uint64_t)(s->center.x - td_length_from(w, s->x)) >> 8);
        py[i] = (int32_t)(uint32_t)((uint64_t)(s->center.y - td_length_from(w, s->y)) >> 8);
    }
    *x = i8_load(px);
    *y = i8_load(py);
}

/* Computes the manifolds of the lanes in `recomputed`. Returns the lanes that touch. */
TD_INLINE i8 collide_block(thud_world *w, td_block *block, i8 recomputed,
                           const td_collide_context *c, int points) {
    f8 zero = f8_all(0.0f);
    terrain8 t = {0};
    for (unsigned bits = i8_bits(recomputed & td_used_mask(block)); bits; bits &= bits - 1) {
        one_lane(w, block, __builtin_ctz(bits), c->margin, &t);
    }
    td_set_row(&block->nx, &recomputed, t.nx);
    td_set_row(&block->ny, &recomputed, t.ny);
    carry_impulses(block, t.feature, recomputed, points);
    td_rows arm = td_gather_proxies(c, block->shape_b, offsetof(td_shape_proxy, x));
    td_found found[2];
    for (int k = 0; k < points; k++) {
        found[k] =
            (td_found){t.valid[k], t.separation[k], zero, zero, arm.x + t.x[k], arm.y + t.y[k]};
    }
    td_write_points(block, found, points, &recomputed, c);
    return t.valid[0] | t.valid[1];
}

/* The manifolds of all blocks, kept ones and new ones; `points`: 1 for circles, 2 for boxes. */
TD_INLINE void terrain_blocks(thud_world *w, td_block *const *blocks, int count,
                              const td_collide_context *c, int points) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_manifold_cache *kept = td_manifold_cache_of(block, points);
        td_rows proxy = td_gather_proxies(c, block->shape_b, offsetof(td_shape_proxy, c));
        i8 x, y;
        read_places(w, block, &x, &y);
        f8 zero = f8_all(0.0f), quantum = f8_all(256.0f * c->quantum), separation[2];
        td_moved moved = {.dx = quantum * __builtin_convertvector(i8_wrap_sub(x, (i8)kept->dx), f8),
                          .dy = quantum * __builtin_convertvector(i8_wrap_sub(y, (i8)kept->dy), f8),
                          .turn_a = zero};
        moved.small_turn = small_turn(proxy.x, proxy.y, kept->bc, kept->bs, &moved.turn_b);
        i8 keep = td_keep_mask(block, points, &moved, c, separation), recomputed = ~keep;
        unsigned touching = i8_bits(keep);
        if (touching != i8_bits(td_used_mask(block))) {
            touching |= i8_bits(collide_block(w, block, recomputed, c, points) & recomputed);
            kept->dx = f8_pick(recomputed, (f8)x, kept->dx);
            kept->dy = f8_pick(recomputed, (f8)y, kept->dy);
            kept->bc = f8_pick(recomputed, proxy.x, kept->bc);
            kept->bs = f8_pick(recomputed, proxy.y, kept->bs);
            td_keep_note(block, points, recomputed, f8_min(proxy.z, proxy.w),
                         f8_max(proxy.z, proxy.w), c);
        }
        td_keep_follow(block, points, keep, separation, c);
        td_set_touching(block, touching, c);
    }
}

/* Kernels of the two pair kinds. */
static void terrain_circle(thud_world *w, td_block *const *blocks, int count,
                           const td_collide_context *c) {
    terrain_blocks(w, blocks, count, c, 1);
}

static void terrain_box(thud_world *w, td_block *const *blocks, int count,
                        const td_collide_context *c) {
    terrain_blocks(w, blocks, count, c, 2);
}

TD_TERRAIN_PAIRS(TD_DEFINE_PAIR)
