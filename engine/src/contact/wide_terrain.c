/* wide_terrain.c: manifolds of circles and boxes with terrain segments. A manifold is kept while
 * the shape hardly moves (wide_manifold_cache.h). New ones are computed one by one in double
 * precision, relative to the terrain's origin (terrain/terrain_manifold.c), and written eight at a
 * time. */
#include "state/body.h"
#include "state/shape.h"
#include "terrain/terrain_manifold.h"
#include "contact/wide_manifold_cache.h"

/* The manifolds of eight lanes. */
typedef struct terrain8 {
    f8 nx, ny, separation[2];
    f8 x[2], y[2]; /* the points, relative to the centres of the shapes b */
    i8 feature;    /* ids of up to two points, POINT_ID_BITS each: td_terrain_point.id + 1; 0: no
                      point */
    i8 valid[2];   /* masks: the lane has this point */
} terrain8;

enum { POINT_ID_BITS = 16, POINT_ID_MASK = 0xffff };

/* Computes the manifold of one lane. `margin`: separation up to which points count, length. */
static void collide_lane(const thud_world *w, const td_block *block, int lane, float margin,
                         terrain8 *out) {
    int a = block->shape_a[lane], b = block->shape_b[lane];
    const td_contact *contact = td_contact_at(w, block->constraint[lane]);
    thud_terrain terrain = td_terrain_view(w, a);
    /* The shape in coordinates relative to the terrain's origin; the points of the manifold come
     * relative to the shape's centre. */
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
        feature |= (m.point[k].id + 1u) << (POINT_ID_BITS * k);
    }
    out->feature[lane] = (int32_t)feature;
}

/* In the lanes in `recomputed`, moves each normal impulse to the point with the same id, and drops
 * the others. The tangent impulse stays where one of the points has kept its id. */
TD_INLINE void carry_impulses(td_block *block, i8 feature, i8 recomputed, int points) {
    i8 old = i8_load((const int32_t *)block->feature), mask = i8_all(POINT_ID_MASK);
    i8 zero = i8_all(0);
    feature = i8_pick(recomputed, feature, old);
    __builtin_memcpy(block->feature, &feature, sizeof feature);
    f8 n[2] = {block->point[0].normal_impulse, block->point[points - 1].normal_impulse};
    i8 old_id[2] = {old & mask, (old >> POINT_ID_BITS) & mask};
    i8 new_id[2] = {feature & mask, (feature >> POINT_ID_BITS) & mask};
    i8 kept = ~recomputed;
    for (int k = 0; k < points; k++) {
        i8 first = (new_id[k] == old_id[0]) & (new_id[k] != zero);
        i8 second = (new_id[k] == old_id[1]) & (new_id[k] != zero);
        block->point[k].normal_impulse = f8_pick(first, n[0], f8_keep(second, n[1]));
        kept |= first | second;
    }
    block->tangent_impulse = f8_keep(kept, block->tangent_impulse);
}

/* A unit of place: 256 position quanta, 2^-24 length scales, as a shift. Places wrap around every
 * 2^32 units, 256 length scales. */
enum { PLACE_SHIFT = 8 };

/* The places of the centres of mass of the bodies b, rounded down to units of place, modulo 2^32.
 * The difference of two is the motion between them, within one unit, however far from the origin
 * they are. A motion by exactly 256 length scales would look like none. Only a teleport may be that
 * long; it makes the next narrowphase compute the body's contacts with terrain anew
 * (state/changes.c). */
TD_INLINE void read_mass_centres(const thud_world *w, const td_block *block, i8 *x, i8 *y) {
    int32_t px[TD_LANES], py[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        const td_shape_proxy *s = td_shape_proxy_at(w, block->shape_b[i]);
        int64_t center_x = s->center.x - td_length_from(w, s->x);
        int64_t center_y = s->center.y - td_length_from(w, s->y);
        px[i] = (int32_t)(uint32_t)((uint64_t)center_x >> PLACE_SHIFT);
        py[i] = (int32_t)(uint32_t)((uint64_t)center_y >> PLACE_SHIFT);
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
        collide_lane(w, block, __builtin_ctz(bits), c->margin, &t);
    }
    td_set_row(&block->nx, &recomputed, t.nx);
    td_set_row(&block->ny, &recomputed, t.ny);
    carry_impulses(block, t.feature, recomputed, points);
    /* .x, .y: from the body's centre of mass to the shape's centre. The terrain does not move, so
     * that it needs no lever arm. */
    td_rows offset = td_gather_proxies(c, block->shape_b, offsetof(td_shape_proxy, x));
    td_found found[2];
    for (int k = 0; k < points; k++) {
        found[k] = (td_found){.valid = t.valid[k],
                              .separation = t.separation[k],
                              .rax = zero,
                              .ray = zero,
                              .rbx = offset.x + t.x[k],
                              .rby = offset.y + t.y[k]};
    }
    td_write_points(block, found, points, &recomputed, c);
    return t.valid[0] | t.valid[1];
}

/* The manifolds of all blocks, kept ones and new ones; `points`: 1 for circles, 2 for boxes. Only
 * lanes that touch are kept (td_cached_lanes), so that all others are computed anew in each step.
 */
TD_INLINE void terrain_blocks(thud_world *w, td_block *const *blocks, int count,
                              const td_collide_context *c, int points) {
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        td_manifold_cache *cache = td_manifold_cache_of(block, points);
        td_rows proxy = td_gather_proxies(c, block->shape_b, offsetof(td_shape_proxy, c));
        f8 cosine = proxy.x, sine = proxy.y, half_x = proxy.z, half_y = proxy.w;
        i8 x, y;
        read_mass_centres(w, block, &x, &y);
        /* In contacts with terrain, dx and dy of the cache hold the bits of integers, the place of
         * b (td_manifold_cache). */
        i8 cached_x = (i8)cache->dx, cached_y = (i8)cache->dy;
        f8 unit = f8_all((float)(1 << PLACE_SHIFT) * c->quantum), separation[2];
        td_moved moved = {.dx = unit * __builtin_convertvector(i8_wrap_sub(x, cached_x), f8),
                          .dy = unit * __builtin_convertvector(i8_wrap_sub(y, cached_y), f8),
                          .turn_a = f8_all(0.0f)};
        moved.small_turn = small_turn(cosine, sine, cache->bc, cache->bs, &moved.turn_b);
        i8 kept = td_cached_lanes(block, points, &moved, c, separation), recomputed = ~kept;
        unsigned touching = i8_bits(kept);
        if (touching != i8_bits(td_used_mask(block))) {
            touching |= i8_bits(collide_block(w, block, recomputed, c, points) & recomputed);
            cache->dx = f8_pick(recomputed, (f8)x, cache->dx);
            cache->dy = f8_pick(recomputed, (f8)y, cache->dy);
            cache->bc = f8_pick(recomputed, cosine, cache->bc);
            cache->bs = f8_pick(recomputed, sine, cache->bs);
            td_cache_store(block, points, recomputed, f8_min(half_x, half_y),
                           f8_max(half_x, half_y), c);
        }
        td_cache_update_points(block, points, kept, separation, c);
        td_set_touching(block, touching, c);
    }
}

/* The collide_world of both pair kinds: TD_PAIR_TERRAIN_CIRCLE and TD_PAIR_TERRAIN_BOX. */
static void terrain_circle(thud_world *w, td_block *const *blocks, int count,
                           const td_collide_context *c) {
    terrain_blocks(w, blocks, count, c, 1);
}

static void terrain_box(thud_world *w, td_block *const *blocks, int count,
                        const td_collide_context *c) {
    terrain_blocks(w, blocks, count, c, 2);
}

/* Defines the td_constraint_ops of both pair kinds. */
TD_TERRAIN_PAIRS(TD_DEFINE_PAIR)
