/* operations_textures.c: textures of terrain lines, in the world and without one. What a texture
 * does to contacts enters the digest with the next step. */
#include "operations.h"

enum { ROOM = 24 }; /* vertices of a texture at most; the lines of the sessions have fewer */

/* The lists of a texture. */
typedef struct lists {
    double vertices[ROOM];
    float table[4];
} lists;

/* A texture of `count` vertices from the fuzzer's bytes, most of them valid. */
static thud_texture pick_texture(fuzz_session *s, int count, lists *l) {
    unsigned how = next_byte(&s->bytes);
    for (int i = 0; i < ROOM; i++) {
        l->vertices[i] = i < 4 ? next_number(&s->bytes, 0, 1.0 / 128) : l->vertices[i - 4];
    }
    for (int i = 0; i < 4; i++) {
        l->table[i] = how & 1 ? next_float(&s->bytes, 0, 0.0078125f) : 0.0f;
    }
    int entries = how & 1 ? 1 + (int)(how >> 2 & 3) : 0;
    return (thud_texture){l->vertices, count < ROOM ? count : ROOM, how & 1 ? l->table : NULL,
                          how >= 248 ? 1 - entries : entries, how >> 1 & 1};
}

static void set_texture(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    bool none = next_chance(&s->bytes, 8);
    thud_terrain line = {.count = 3};
    lists l;
    if (COUNTED(thud_shape_get_terrain(s->world, shape, &line)) == THUD_OK &&
        line.kind == THUD_TERRAIN_FLAT) {
        line.count = 2;
    }
    thud_texture texture = pick_texture(s, line.count, &l), kept;
    TRY(s, thud_shape_set_texture(s->world, shape, none ? NULL : &texture));
    if (s->result == THUD_OK &&
        (COUNTED(thud_shape_get_texture(s->world, shape, &kept)) != THUD_OK ||
         kept.count != (none ? 0 : texture.count))) {
        fuzz_fail(s, "a texture of %d vertices has %d", texture.count, kept.count);
    }
}

static void get_texture(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    double x = pick_place(s).x;
    thud_texture texture;
    float friction;
    memset(&texture, CALL_FILL, sizeof texture);
    memset(&friction, CALL_FILL, sizeof friction);
    TRY(s, thud_shape_get_texture(s->world, shape, &texture));
    if (s->result != THUD_OK) {
        call_untouched(s, &texture, sizeof texture);
    } else {
        note_bits(s, (uint64_t)texture.count);
        note_bits(s, (uint64_t)texture.table_count);
    }
    TRY(s, thud_shape_get_friction_at(s->world, shape, x, &friction));
    if (s->result != THUD_OK) {
        call_untouched(s, &friction, sizeof friction);
    } else if (!(friction >= 0.0f && friction <= THUD_FRICTION_MAX)) {
        fuzz_fail(s, "the friction %g", (double)friction);
    } else {
        note_number(s, (double)friction);
    }
}

static void read_texture_of_line(fuzz_session *s) {
    thud_pos points[PICK_POINTS];
    thud_terrain line = pick_line(s, points);
    double x = pick_coordinate(s);
    thud_terrain_sample sample;
    lists l;
    thud_texture texture = pick_texture(s, line.count, &l);
    PURE(s, sample, thud_terrain_sample_at(&line, x, &sample));
    if (s->result == THUD_OK) {
        float friction;
        PURE(s, friction, thud_texture_friction_at(&texture, &sample, &friction));
        if (s->result == THUD_OK && !(friction >= 0.0f && friction <= THUD_FRICTION_MAX)) {
            fuzz_fail(s, "the friction %g of a sample", (double)friction);
        }
    }
}

void play_texture(fuzz_session *s) {
    fuzz_operation *const plays[] = {set_texture, get_texture, read_texture_of_line};
    plays[next_choice(&s->bytes, 3)](s);
}
