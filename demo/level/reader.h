/* reader.h: what the files of the level reader share, and nobody else needs. */
#ifndef THUD_DEMO_READER_H
#define THUD_DEMO_READER_H

#include "level.h"

#include <cjson/cJSON.h>

typedef struct level_reader {
    scene *s;
    level_report *report;
    double tile_width, tile_height; /* pixels */
    double map_height;              /* pixels */
    double pixels_per_unit;
    const cJSON *tilesets;
} level_reader;

/* Where properties are looked up: from the innermost link (an object, a tile) to the map. */
enum { LEVEL_CHAIN = 16 };
typedef struct level_chain {
    const cJSON *links[LEVEL_CHAIN]; /* JSON objects that may have `properties` */
    int count;                       /* the last is the innermost */
} level_chain;

/* A layer on the way from the map, through its groups. */
typedef struct level_layer {
    const cJSON *json;
    level_chain chain; /* ends with the layer itself */
    double ox, oy;     /* pixels, with the groups' */
    const char *name;  /* for messages */
} level_layer;

/* ---- report.c ---- */

#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
void level_problem_add(level_report *report, level_severity severity, uint32_t object,
                       const char *format, ...);

/* ---- properties.c ---- */

/* Reads values for one thing; `bad` is set, and the reason reported, when one has the wrong type
 * or lies outside its range. */
typedef struct level_values {
    level_report *report;
    const level_chain *chain;
    uint32_t object;   /* 0: `where` says what it is about */
    const char *where;
    bool bad;
} level_values;

/* A field of a JSON object, by its exact name; null if there is none. */
const cJSON *level_field(const cJSON *json, const char *name);
/* A custom property's value from one link only; null if it has none. */
const cJSON *level_own_property(const cJSON *json, const char *name);

double level_number(level_values *v, const char *name, double fallback, double low, double high);
bool level_flag(level_values *v, const char *name, bool fallback);
const char *level_text(level_values *v, const char *name, const char *fallback);

/* Notes every property of one JSON object that the reader does not know: a misspelt name ought
 * not to pass in silence. */
void level_note_unknown(level_report *report, const cJSON *json, uint32_t object,
                        const char *where);

/* The physical properties of an object or a tile. */
typedef struct level_physics {
    scene_body_kind kind;
    bool fixed_rotation, sensor, may_sleep;
    double vx, vy, angular_velocity;
    double gravity_scale, linear_damping, angular_damping;
    scene_material material;
    uint32_t category, mask;
    int32_t group;
} level_physics;

level_physics level_read_physics(level_values *v);
void level_apply_physics(const level_physics *p, scene_body *body, scene_shape *shape);

/* A required number that is a field of the format itself; sets v->bad if there is none. */
double level_required(level_values *v, const cJSON *json, const char *name, double low,
                      double high);

/* ---- objects.c, tiles.c ---- */

void level_read_objects(level_reader *r, const level_layer *layer);
void level_read_tiles(level_reader *r, const level_layer *layer);

#endif
