/* reader.h: what the files of the level reader share, and nobody else needs. */
#ifndef THUD_DEMO_READER_H
#define THUD_DEMO_READER_H

#include "level.h"

#include <cjson/cJSON.h>

/* Pixels beyond which a map is absurd. */
#define LEVEL_FAR 1e9
#define LEVEL_DEGREES 1e6

/* What a tile number belongs to: an entry of a map's or a template's list of tilesets. */
typedef struct level_tileset {
    double first;      /* the first tile number */
    const cJSON *json; /* itself, or what tells its file */
    const char *path;  /* of the file that this stands in, "" for the map's own */
} level_tileset;

typedef struct level_tilesets {
    level_tileset *items;
    int count;
} level_tilesets;

typedef struct level_library level_library;

/* A body of an object. */
typedef struct level_placed {
    uint32_t id;
    int index;       /* in scene.bodies */
    double rotation; /* degrees, clockwise, in [-180, 180) */
} level_placed;

/* An object that is a joint, until all that it may refer to is read. */
typedef struct level_joint {
    scene_joint joint; /* but for its bodies and frames */
    uint32_t id, a, b; /* of objects; a is 0 if it holds to the world */
    double x[2], y[2]; /* pixels: where it is in a and in b */
    double rotation;   /* of its axis, degrees, clockwise */
    int made;          /* its index in scene.joints, or -1 */
} level_joint;

typedef struct level_reader {
    scene *s;
    level_report *report;
    level_library *library;
    double tile_width, tile_height; /* pixels */
    double map_height;              /* pixels */
    double pixels_per_unit;
    level_tilesets tilesets;
    double cells;   /* that may still be read, in all layers: a small file can claim any number */
    bool all_solid; /* nothing in the map says what collides, so that every tile does */
    int unmarked;   /* tiles of which nothing says whether they do */
    level_placed *placed; /* bodies of objects, in the order of the map */
    int placed_count, placed_capacity;
    level_joint *joints; /* likewise */
    int joint_count, joint_capacity;
} level_reader;

/* Where properties are looked up: from the innermost link (an object, a tile) to the map. */
enum { LEVEL_CHAIN = 20, LEVEL_DEEPEST = 13 };
typedef struct level_chain {
    const cJSON *links[LEVEL_CHAIN]; /* JSON objects that may have `properties` */
    int count;                       /* the last is the innermost */
} level_chain;

/* A layer on the way from the map, through its groups. */
typedef struct level_layer {
    const cJSON *json;
    level_chain chain; /* ends with the layer itself; LEVEL_DEEPEST long at most */
    double ox, oy;     /* pixels, with the groups' */
    const char *name;  /* for messages */
} level_layer;

/* ---- report.c, properties.c ---- */

/* Reads values for one thing; `bad` is set, and the reason reported, when one has the wrong type
 * or lies outside its range. */
typedef struct level_values {
    level_report *report;
    const level_chain *chain;
    uint32_t object; /* 0: `where` says what it is about */
    const char *where;
    bool bad;
} level_values;

#if defined(__GNUC__)
#define LEVEL_FORMAT(text, first) __attribute__((format(printf, text, first)))
#else
#define LEVEL_FORMAT(text, first)
#endif
LEVEL_FORMAT(4, 5)
void level_problem_add(level_report *report, level_severity severity, uint32_t object,
                       const char *format, ...);
LEVEL_FORMAT(3, 4)
void level_complain(const level_values *v, level_severity severity, const char *format, ...);

/* A field of a JSON object, by its exact name; null if there is none. */
const cJSON *level_field(const cJSON *json, const char *name);
/* A field's text; `fallback` if there is none. */
const char *level_field_text(const cJSON *json, const char *name, const char *fallback);
/* A custom property's value from one link only; null if it has none. */
const cJSON *level_own_property(const cJSON *json, const char *name);
/* From the innermost link of the chain that has it. */
const cJSON *level_property(const level_chain *chain, const char *name);

double level_number(level_values *v, const char *name, double fallback, double low, double high);
/* True, false, or neither: 1, 0, -1. */
int level_flag_of(const cJSON *value);
bool level_flag(level_values *v, const char *name, bool fallback);
const char *level_text(level_values *v, const char *name, const char *fallback);

/* True, and *value, if the whole text is a number as JSON writes it. */
bool level_number_of(const char *text, double *value);

double level_whole_number(level_values *v, const char *name, double fallback, double low,
                          double high);

/* What an object is where it is no joint, and what it may be where that is not known. */
enum { LEVEL_NO_JOINT = -1, LEVEL_ANY_JOINT = -2 };

/* Notes every property of one JSON object that means nothing to what it is, `joint` (a
 * scene_joint_kind or one of the above): a misspelt name ought not to pass in silence. */
void level_note_unknown(level_report *report, const cJSON *json, uint32_t object, const char *where,
                        int joint);

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
void level_apply_body(const level_physics *p, scene_body *body);
void level_apply_shape(const level_physics *p, scene_shape *shape);

/* A required number that is a field of the format itself; sets v->bad if there is none. */
double level_required(level_values *v, const cJSON *json, const char *name, double low,
                      double high);
/* The same where a file may do without. */
double level_optional(level_values *v, const cJSON *json, const char *name, double fallback,
                      double low, double high);

/* ---- document.c, tmx.c: text to JSON ---- */

/* Reads .tmj, .tsj, .tj or their XML forms. Null, and why stands in `trouble`, if it is neither;
 * the caller frees it. XML becomes what Tiled would have written as JSON. */
cJSON *level_document(const char *text, size_t length, char *trouble, size_t size);
cJSON *level_tmx(const char *text, size_t length, char *trouble, size_t size);

/* ---- library.c: the files that a map refers to ---- */

/* Null without memory. The opener may be null. */
level_library *level_library_create(const level_opener *opener);
void level_library_free(level_library *library);
/* What `source` means in the file `from` ("" for the map): a document whose "type" is `type`,
 * read once and kept. Null, after one report, if there is none. *path becomes the file's own. */
const cJSON *level_library_open(level_library *library, level_report *report, const char *from,
                                const char *source, const char *type, const char **path);
/* What was reported will be again: before a map is read anew. */
void level_library_forget_reports(level_library *library);

/* ---- unpack.c, cells.c: tile numbers ---- */

/* Unpacks base64, then by `compression` ("", "zlib", "gzip", "zstd"), to exactly `size` bytes.
 * Null if it worked, else why not. Never writes or unpacks more, whatever the data claims. */
const char *level_unpack(const char *text, const char *compression, uint8_t *out, size_t size);

/* The cells of a layer, of all its chunks if the map is infinite. */
typedef struct level_cells {
    uint32_t *at;      /* row by row, tile numbers with their flips; from malloc */
    int width, height; /* of the box around all chunks */
    int column, row;   /* of its first cell */
} level_cells;
/* False after a report. */
bool level_read_cells(level_reader *r, const level_layer *layer, level_cells *cells);

/* ---- forms.c, polygon.c: outlines of objects ---- */

/* The rotation of (x, y), which is not (0, 0), in degrees. */
double level_direction(double x, double y);

typedef enum level_form_kind { LEVEL_BOX, LEVEL_CIRCLE, LEVEL_LINE, LEVEL_POLYGON } level_form_kind;

/* One shape in pixels, y down; see level.h. */
typedef struct level_form {
    level_form_kind kind;
    double x, y;         /* centre; of a line or polygon the place that its points start from */
    double hx, hy;       /* half extents; of a circle its radius, twice */
    double rotation;     /* degrees, clockwise, in [-180, 180) */
    scene_point *points; /* of a line or polygon */
    int count;
    bool ground; /* a line that was a polygon: stands for it only where all below it is solid */
    double foot; /* how far down that polygon reached, below y */
    level_physics physics;
} level_form;

typedef struct level_forms {
    level_form *items;
    int count;
    bool failed; /* memory ran out */
} level_forms;

void level_forms_free(level_forms *forms);
/* Never null; a spare that is none of them without memory. */
level_form *level_forms_add(level_forms *forms, level_form_kind kind, level_form *spare);
/* Room for the points of a form; false without memory. */
bool level_form_points(level_forms *forms, level_form *form, int count);

/* What the outline of an object is, that is no tile, point or text, unturned about its own place;
 * false after a report. */
bool level_read_forms(level_values *v, const cJSON *object, level_forms *forms);
/* A polygon as the boxes that make it up, else as itself. */
void level_read_polygon(const scene_point *points, int count, level_forms *forms);
/* Makes a polygon, turned as it will lie, the line of its upper side; false after a report. */
bool level_form_to_ground(const level_values *v, level_form *form);

/* Turns a form about its frame's origin, then moves that to (x, y). */
void level_form_turn(level_form *form, double x, double y, double degrees);
/* In a tile of this size, as the upper bits of its number tell; the size is of the tile after. */
void level_form_flip(level_form *form, uint32_t gid, double *width, double *height);
/* False after a report: an ellipse or a slanted box would come of it. */
bool level_form_scale(const level_values *v, level_form *form, double sx, double sy);
/* Takes away, after a report, what the engine does not take of a body's forms, polygons become
 * ground, and lines run from left to right. `degrees` is the body's rotation, which lines and
 * polygons take over. Ground reaches down to `lowest` at least, pixels below the body. */
void level_forms_settle(const level_reader *r, const level_values *v, const level_physics *physics,
                        level_forms *forms, double degrees, double lowest);

/* A body at (x, y) pixels with these forms, but for lines, which get one each. */
void level_add_body(level_reader *r, const level_physics *physics, uint32_t id,
                    const level_forms *forms, bool with_ground, double x, double y, double degrees);

/* ---- tilesets.c ---- */

/* The upper bits of a tile number tell how it is flipped. */
#define LEVEL_FLIP_X 0x80000000u
#define LEVEL_FLIP_Y 0x40000000u
#define LEVEL_FLIP_TURN 0x20000000u
#define LEVEL_NUMBER 0x0FFFFFFFu

/* A tile as it lies in a map: what it is made of, about the middle of its picture. */
typedef struct level_tile {
    const cJSON *tileset;      /* null: there is none, or it cannot be used, which is reported */
    const cJSON *json;         /* the tile's own entry, or null */
    double width, height;      /* of its picture, pixels */
    double offset_x, offset_y; /* of the tileset, likewise */
    double anchor_x, anchor_y; /* of tile objects, as a fraction of the picture */
    bool fills_cell;           /* in a layer drawn as large as a cell of the map */
    bool keeps_aspect;         /* but no wider or higher than the picture is */
} level_tile;

/* Reads a list "tilesets", of the map or the one of a template; false without memory. */
bool level_list_tilesets(level_tilesets *tilesets, const cJSON *list, const char *path);
level_tile level_find_tile(const level_reader *r, const level_tilesets *tilesets, uint32_t gid);

/* What a tile is to the world. */
typedef enum level_solid {
    LEVEL_OPEN = 0, /* something says that it does not collide */
    LEVEL_UNMARKED, /* nothing says whether it does: it does not */
    LEVEL_SOLID     /* it does; with no forms, if all of them were reported */
} level_solid;

/* The forms of a tile drawn as large as told, about its middle: its collision shapes, else a box
 * if something says that it is solid. The chain of `v` has the layer, the tileset, the tile's own
 * entry if it has one (`outer` links up to here), and, of a tile object, what it is. *physics
 * becomes the body's. */
level_solid level_read_tile_forms(level_reader *r, const level_values *v, const level_tile *tile,
                                  uint32_t gid, double width, double height, int outer,
                                  level_physics *physics, level_forms *forms);

/* ---- joints.c, tie.c ---- */

/* The kind that a class of objects is, or LEVEL_NO_JOINT. */
int level_joint_kind(const char *name);
const char *level_joint_name(scene_joint_kind kind);
/* Whether a property means something to a kind, or to any. */
bool level_joint_knows(int kind, const char *name);
/* Whether the engine takes a length of either sign. */
bool level_joint_fits(const level_reader *r, double length);
/* Where a side of a joint is, in the world. */
scene_point level_joint_place(const level_reader *r, const level_joint *o, int side);
/* Keeps the joint that an object at (x, y) pixels is, or reports why it is none. */
void level_read_joint(level_reader *r, level_values *v, const cJSON *object, int kind, double x,
                      double y, double degrees);

/* The scene's latest body is of this object. */
void level_place_body(level_reader *r, uint32_t id, double rotation);
/* Adds to the scene the joints that were kept, or reports why not: gears after all others. */
void level_tie_joints(level_reader *r);

/* ---- objects.c, tiles.c ---- */

void level_read_objects(level_reader *r, const level_layer *layer);
void level_read_tiles(level_reader *r, const level_layer *layer);

#endif
