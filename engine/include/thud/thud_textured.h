/* thud_textured.h: textured ground: terrain whose friction is read from a texture at each contact,
 * in place of one friction coefficient for the whole line. A program that does not use this header
 * does not link it, and a world without textures does not pay for it.
 *
 * Each vertex of the line has a value, which is interpolated between two vertices by their
 * distances (thud_terrain_sample.weight): at x between the vertices x_l and x_r
 *     w_l = (x_r - x) / (x_r - x_l), w_r = 1 - w_l, value = w_l value_l + w_r value_r,
 * which is continuous across the vertices. The value is the friction itself, or the texture
 * coordinate by which a table gives the friction.
 *
 * Friction of the ground is then combined with that of the other shape as usual (thud_shape_def),
 * and a rule's friction (thud_rules.h) replaces the result. At its start, a step reads the texture
 * at the point of each contact (thud_contact.point); detection reads it at the point of each
 * collision that it finds within the step. A prologue (pre-solve callback) is called after that,
 * and sees and may change the friction. Each segment of a line is a separate contact, with its own
 * friction.
 *
 * Snapshots contain the textures; a restored world has exactly those of the snapshot. */
#ifndef THUD_TEXTURED_H
#define THUD_TEXTURED_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The friction along a ground line. */
typedef struct thud_texture {
    /* One value for each vertex of the line; for a flat line two, at x = 0 and x = 1 from its
     * origin, which are extrapolated beyond. Without a table, they are coefficients of friction in
     * [0, THUD_FRICTION_MAX]; with a table, texture coordinates u, |u| <=
     * THUD_TERRAIN_PLACE_MAX. */
    const double *vertices;
    int count; /* of vertices */
    /* The friction by texture coordinate: coefficients in [0, THUD_FRICTION_MAX] at equal distances
     * of u, interpolated between. Null: the values of the vertices are the friction. */
    const float *table;
    int table_count; /* [1, THUD_TERRAIN_COUNT_MAX]; 0 without a table */
    /* True: entry i is at u = i / table_count, and the table repeats from u = 1 on. False: entry i
     * is at u = i / (table_count - 1); below 0 the first entry is used, and above 1 the last. */
    bool repeats;
} thud_texture;

/* The friction of a texture at a sample of the line (thud_terrain_sample_at), in [0,
 * THUD_FRICTION_MAX]; the extrapolation of a flat line is clamped to this range. No world is
 * needed. THUD_ERROR_NULL; THUD_ERROR_INVALID if the vertices do not contain the sample's segment,
 * or a value at it is out of range; *out is then not written. */
THUD_API thud_result thud_texture_friction_at(const thud_texture *texture,
                                              const thud_terrain_sample *sample, float *out);

/* Gives a terrain shape a texture in place of the friction of its def, or removes it (null). The
 * arrays are copied. The change takes effect with the next step, and wakes the bodies that touch
 * the line.
 *
 * Edits of the line (thud_terrain.h) do not move the texture: a new vertex gets the value that the
 * line had at its x, or, beyond an end, the value of that end; the value of a removed vertex is
 * removed with it.
 *
 * THUD_ERROR_NULL for a null world or null vertices, THUD_ERROR_STALE, THUD_ERROR_INVALID for a
 * shape that is no terrain, a count that is not the line's, or a value out of range,
 * THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a callback: then nothing has changed. */
THUD_API thud_result thud_shape_set_texture(thud_world *world, thud_shape_id shape,
                                            const thud_texture *texture);
/* Gets the texture; all zero if there is none. Its arrays are the world's own, and valid until the
 * texture or the line is edited, the shape is destroyed, or a snapshot is restored. `out` may be
 * null. THUD_ERROR_NULL, THUD_ERROR_STALE, THUD_ERROR_INVALID for a shape that is no terrain. */
THUD_API thud_result thud_shape_get_texture(const thud_world *world, thud_shape_id shape,
                                            thud_texture *out);
/* The friction of a terrain shape at x, a finite coordinate of the world: that of its texture,
 * which beyond an end of the line has the value of the end; without a texture that of the shape.
 * `out` may be null. Errors as above, and THUD_ERROR_INVALID for an x that is not finite. */
THUD_API thud_result thud_shape_get_friction_at(const thud_world *world, thud_shape_id shape,
                                                double x, float *out);

/* Prepares a world that never had a texture for thud_world_restore from a snapshot with textures,
 * which it would refuse otherwise. THUD_ERROR_NULL, THUD_ERROR_MEMORY, THUD_ERROR_LOCKED inside a
 * callback. */
THUD_API thud_result thud_world_use_textures(thud_world *world);

#ifdef __cplusplus
}
#endif

#endif
