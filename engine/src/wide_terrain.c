/* wide_terrain.c: contacts with terrain segments. The geometry is done pair by pair in double
 * precision, relative to the terrain's origin; the rows are then made eight at a time. */
#include "shape.h"
#include "terrain_manifold.h"
#include "wide_collide.h"

typedef struct terrain8 {
    f8 nx, ny, separation[2], x[2], y[2];
    i8 feature, valid[2];
} terrain8;

static void one_lane(const thud_world *w, const td_block *block, int lane, float margin,
                     terrain8 *out)
{
    int a = block->shape_a[lane], b = block->shape_b[lane];
    const td_contact *contact = td_contact_at(w, block->contact[lane]);
    thud_terrain terrain = td_terrain_view(w, a);
    thud_placed placed = td_shape_placed(w, b, td_stance_at(w, a)->center);
    td_terrain_manifold m;
    td_terrain_segment_manifold(&terrain, contact->child, &placed, (double)margin, &m);
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

/* Impulses move to the point of the same id. */
TD_INLINE void carry_impulses(td_block *block, i8 feature, int points)
{
    i8 old = i8_load((const int32_t *)block->feature), low = i8_all(0xffff), zero = i8_all(0);
    __builtin_memcpy(block->feature, &feature, sizeof feature);
    f8 n[2] = {block->point[0].normal_impulse, block->point[points - 1].normal_impulse};
    i8 old_id[2] = {old & low, (old >> 16) & low};
    i8 new_id[2] = {feature & low, (feature >> 16) & low};
    i8 kept = zero;
    for (int k = 0; k < points; k++) {
        i8 first = (new_id[k] == old_id[0]) & (new_id[k] != zero);
        i8 second = (new_id[k] == old_id[1]) & (new_id[k] != zero);
        block->point[k].normal_impulse = f8_pick(first, n[0], f8_keep(second, n[1]));
        kept |= first | second;
    }
    block->tangent_impulse = f8_keep(kept, block->tangent_impulse);
}

TD_INLINE void terrain_blocks(thud_world *w, td_block *const *blocks, int count,
                              const td_collide_context *c, int points)
{
    f8 zero = f8_all(0.0f);
    for (int i = 0; i < count; i++) {
        td_block *block = blocks[i];
        terrain8 t = {0};
        for (int lane = 0; lane < block->used; lane++) {
            one_lane(w, block, lane, c->margin, &t);
        }
        block->nx = t.nx;
        block->ny = t.ny;
        carry_impulses(block, t.feature, points);
        td_rows arm = td_gather_stances(c, block->shape_b, offsetof(td_stance, x));
        td_found found[2];
        for (int k = 0; k < points; k++) {
            found[k] = (td_found){t.valid[k], t.separation[k], zero, zero, arm.x + t.x[k],
                                  arm.y + t.y[k]};
        }
        td_write_points(block, found, points, NULL, c);
        block->touching = i8_bits(t.valid[0] | t.valid[1]);
    }
}

static void terrain_circle(thud_world *w, td_block *const *blocks, int count,
                           const td_collide_context *c)
{
    terrain_blocks(w, blocks, count, c, 1);
}

static void terrain_box(thud_world *w, td_block *const *blocks, int count,
                        const td_collide_context *c)
{
    terrain_blocks(w, blocks, count, c, 2);
}

extern const td_solve_ops TD_WIDE(td_solve_one), TD_WIDE(td_solve_two);

extern const td_pair_ops TD_WIDE(td_pair_terrain_circle), TD_WIDE(td_pair_terrain_box);
const td_pair_ops TD_WIDE(td_pair_terrain_circle) = {1, NULL, terrain_circle,
                                                     &TD_WIDE(td_solve_one)};
const td_pair_ops TD_WIDE(td_pair_terrain_box) = {2, NULL, terrain_box, &TD_WIDE(td_solve_two)};
