/* reader.h: types and functions that the files of the level reader share. */
#ifndef THUD_DEMO_READER_H
#define THUD_DEMO_READER_H

#include "level.h"

#include <cjson/cJSON.h>

/* Max coordinates in pixels, and max rotations in degrees, that are read. Chosen, far beyond any
 * real map. */
#define LEVEL_FAR 1e9
#define LEVEL_DEGREES 1e6

/* An entry of the list of tilesets of a map or a template. */
typedef struct level_tileset {
    double first;      /* its first tile number (firstgid) */
    const cJSON *json; /* the tileset, or a reference to its file ("source") */
    const char *path;  /* of the file that contains the entry; "" for the map */
} level_tileset;

typedef struct level_tilesets {
    level_tileset *items;
    int count;
} level_tilesets;

typedef struct level_library level_library;

/* A body that was made for an object. */
typedef struct level_placed {
    uint32_t id;
    int index;       /* in scene.bodies */
    double rotation; /* degrees, clockwise, in [-180, 180) */
} level_placed;

/* An object that is a joint. Kept until the whole map is read, since it may refer to objects after
 * it. */
typedef struct level_joint {
    scene_joint joint; /* all but its bodies and frames */
    uint32_t id, a, b; /* ids of objects; a is 0 if the joint holds b to the world */
    double x[2], y[2]; /* its places on a and on b, pixels in the map */
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
    double unit; /* the engine's own length scale: the greatest power of two that is not above the
                    map's `length_scale`; thud_limits.h counts in it */
    level_tilesets tilesets;
    double cells; /* number of cells that may still be read, over all layers: a small file can claim
                     any number */
    double parts; /* number of shapes, and of vertices of lines, that may still be added: tiles and
                     templates repeat those of a small file any number of times */
    bool all_solid;       /* every tile collides, because the map does not say which do */
    int unmarked;         /* number of tiles without any mark of whether they collide */
    level_placed *placed; /* bodies of objects, in the order of the map */
    int placed_count, placed_capacity;
    level_joint *joints; /* joints, in the order of the map */
    int joint_count, joint_capacity;
} level_reader;

/* The JSON objects in which properties are looked up, from the map (first) to an object or a tile
 * (last, the innermost). LEVEL_CHAIN is the max number of links. A layer is refused if there are
 * more than LEVEL_DEEPEST links around it; that leaves room for a template, an object, a tileset, a
 * tile and a collision shape. Chosen. */
enum { LEVEL_CHAIN = 20, LEVEL_DEEPEST = 13 };
typedef struct level_chain {
    const cJSON *links[LEVEL_CHAIN]; /* each may have `properties` */
    int count;                       /* the last is the innermost */
} level_chain;

/* A layer, with the groups around it. */
typedef struct level_layer {
    const cJSON *json;
    level_chain chain; /* ends with the layer itself */
    double ox, oy;     /* offset in pixels, the groups' included */
    const char *name;  /* for messages */
} level_layer;

/* ---- report.c, properties.c ---- */

/* The source of the values of one object, tile or layer. `bad` is set, and the reason reported, if
 * a value has the wrong type or is out of range. */
typedef struct level_values {
    level_report *report;
    const level_chain *chain;
    uint32_t object; /* id of the object; 0: `where` names what it is */
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

/* A field of a JSON object by its exact name; null if it has none. */
const cJSON *level_field(const cJSON *json, const char *name);
/* A field's text; `fallback` if it has none. */
const char *level_field_text(const cJSON *json, const char *name, const char *fallback);
/* The value of a custom property of this JSON object alone; null if it has none. */
const cJSON *level_own_property(const cJSON *json, const char *name);
/* The value of a custom property in the innermost link that has it; null if none has. */
const cJSON *level_property(const level_chain *chain, const char *name);

double level_number(level_values *v, const char *name, double fallback, double low, double high);
/* 1 for true, 0 for false, also as texts; -1 for anything else, and for null. */
int level_flag_of(const cJSON *value);
bool level_flag(level_values *v, const char *name, bool fallback);
const char *level_text(level_values *v, const char *name, const char *fallback);

/* True, and *value is set, if the whole text is a number as JSON writes it. */
bool level_number_of(const char *text, double *value);

double level_whole_number(level_values *v, const char *name, double fallback, double low,
                          double high);

/* Instead of a scene_joint_kind: an object that is no joint, and one of which it is not known. */
enum { LEVEL_NO_JOINT = -1, LEVEL_ANY_JOINT = -2 };

/* Adds a note for each property of a JSON object that has no meaning for it, so that misspelt names
 * are seen. `joint` is a scene_joint_kind or one of the above. */
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
    int approximate; /* the greatest count of shapes that cover a polygon; 0: none do */
} level_physics;

level_physics level_read_physics(level_values *v);
void level_apply_body(const level_physics *p, scene_body *body);
void level_apply_shape(const level_physics *p, scene_shape *shape);

/* A required number of Tiled's format; without it v->bad is set. */
double level_required(level_values *v, const cJSON *json, const char *name, double low,
                      double high);
/* The same for a number that may be missing: `fallback`. */
double level_optional(level_values *v, const cJSON *json, const char *name, double fallback,
                      double low, double high);

/* ---- document.c, tmx.c: text to JSON ---- */

/* Parses .tmj, .tsj, .tj, or their XML forms .tmx, .tsx, .tx, which become the JSON that Tiled
 * would have written. The caller frees the result. Null, and the reason is in `trouble`, if the
 * text is neither. */
cJSON *level_document(const char *text, size_t length, char *trouble, size_t size);
cJSON *level_tmx(const char *text, size_t length, char *trouble, size_t size);

/* ---- library.c: the files that a map refers to ---- */

/* `opener` may be null. Returns null if memory runs out. */
level_library *level_library_create(const level_opener *opener);
void level_library_free(level_library *library);
/* The document that `source` means in the file `from` ("" for the map), with "type" equal to
 * `type`. It is read once and kept. *path becomes its path from the map's folder. Null, after one
 * report a file, if it cannot be used. */
const cJSON *level_library_open(level_library *library, level_report *report, const char *from,
                                const char *source, const char *type, const char **path);
/* Lets problems of files be reported again, before a map is read for a second time. */
void level_library_forget_reports(level_library *library);

/* ---- unpack.c, cells.c: tile numbers ---- */

/* Decodes base64, then decompresses by `compression` ("", "zlib", "gzip", "zstd") to exactly `size`
 * bytes. Returns null if it worked, else the reason. Never writes more, whatever the data claims.
 */
const char *level_unpack(const char *text, const char *compression, uint8_t *out, size_t size);

/* The cells of a layer; in an infinite map those of all its chunks. */
typedef struct level_cells {
    uint32_t *at;      /* row by row: tile numbers with their flip bits; from malloc */
    int width, height; /* of the bounds of all chunks */
    int column, row;   /* of the first cell */
} level_cells;
/* Reads the cells of a layer. False after a report. */
bool level_read_cells(level_reader *r, const level_layer *layer, level_cells *cells);

/* ---- forms.c, polygon.c: outlines of objects ---- */

/* The rotation of the direction (x, y), which is not (0, 0), in degrees. */
double level_direction(double x, double y);

typedef enum level_form_kind { LEVEL_BOX, LEVEL_CIRCLE, LEVEL_LINE, LEVEL_POLYGON } level_form_kind;

/* One shape in pixels, y down; level.h has the rules of their geometry. */
typedef struct level_form {
    level_form_kind kind;
    double x, y;         /* centre; of a line or polygon the origin of its points */
    double hx, hy;       /* half extents; of a circle both are its radius */
    double rotation;     /* degrees, clockwise, in [-180, 180) */
    scene_point *points; /* of a line or polygon */
    int count;
    bool ground; /* a polygon that became its upper line, usable where everything below it is solid
                  */
    double foot; /* the highest point of that polygon's lower side, pixels below y */
    level_physics physics;
} level_form;

typedef struct level_forms {
    level_form *items;
    int count;
    bool failed; /* memory ran out */
} level_forms;

void level_forms_free(level_forms *forms);
/* Adds a form and returns it. If memory runs out, `failed` is set and `spare` returned. */
level_form *level_forms_add(level_forms *forms, level_form_kind kind, level_form *spare);
/* Allocates the points of a form; false if memory runs out. */
bool level_form_points(level_forms *forms, level_form *form, int count);

/* Adds the forms of the outline of an object that is no tile, point or text, unrotated, about the
 * object's own place. False after a report. */
bool level_read_forms(level_values *v, const cJSON *object, level_forms *forms);
/* Adds a polygon as the boxes that make it up, if there are such, else as itself. */
void level_read_polygon(const scene_point *points, int count, level_forms *forms);
/* Replaces a polygon, in the rotation that it has in the map, by the line of its upper side. False
 * if it has none, or if memory runs out. */
bool level_form_to_ground(level_form *form);
/* Adds circles and boxes that approximate the polygon forms->items[index], at most as many as its
 * physics say, without those smaller than `smallest` pixels. Adds none after a report. */
void level_approximate(const level_values *v, level_forms *forms, int index, double smallest);

/* Rotates a form about its frame's origin, then moves the origin to (x, y). */
void level_form_turn(level_form *form, double x, double y, double degrees);
/* Flips a form in a tile of this size by the flip bits of `gid`. The size becomes that of the
 * flipped tile. */
void level_form_flip(level_form *form, uint32_t gid, double *width, double *height);
/* Scales a form. False after a report, if it would become an ellipse or a slanted box. */
bool level_form_scale(const level_values *v, level_form *form, double sx, double sy);
/* Prepares the forms of a body for the engine: removes, after a report, those that it cannot model,
 * replaces polygons by ground or by shapes that approximate them, and lets lines run from left to
 * right. `degrees` is the body's rotation, which is applied to the points of lines and polygons. A
 * polygon is ground if it reaches down to `lowest`, pixels below the body. */
void level_forms_settle(const level_reader *r, const level_values *v, const level_physics *physics,
                        level_forms *forms, double degrees, double lowest);

/* Whether the engine accepts a body at this place, in units. */
bool level_place_fits(const level_reader *r, double x, double y);
/* Follows "its place is" or "the places are" in reports of places that the engine does not accept.
 */
#define LEVEL_TOO_FAR "further from the map's lower left corner than 1e9 length scales"
/* Max number of shapes and vertices of lines that are read of a map. Chosen: their bodies take
 * about 240 MB in a scene. */
#define LEVEL_PARTS 1048576
#define LEVEL_TOO_MANY "this map has more shapes and vertices than are read, 1048576 in all"

/* What became of the bodies of some forms. */
typedef enum level_added {
    LEVEL_ADDED,
    LEVEL_LEFT_FAR, /* one is left out: the engine does not accept its place */
    LEVEL_LEFT_MANY /* one is left out: the map has more than LEVEL_PARTS */
} level_added;
/* Adds a body at (x, y) pixels with these forms, and one more for each line. Lines that are ground
 * are left out if `solid_below` is false: a tile whose ground does not go on in the cells below it.
 */
level_added level_add_body(level_reader *r, const level_physics *physics, uint32_t id,
                           const level_forms *forms, bool solid_below, double x, double y,
                           double degrees);

/* ---- tilesets.c ---- */

/* The highest bits of a tile number say how the tile is flipped. */
#define LEVEL_FLIP_X 0x80000000u
#define LEVEL_FLIP_Y 0x40000000u
#define LEVEL_FLIP_TURN 0x20000000u
#define LEVEL_NUMBER 0x0FFFFFFFu

/* A tile of a tileset. */
typedef struct level_tile {
    const cJSON *tileset; /* null: no tileset has it, or none that can be used, which is reported */
    const cJSON *json;    /* the tile's own entry, or null */
    double width, height; /* of its image, pixels */
    double offset_x, offset_y; /* of the tileset, pixels */
    double anchor_x, anchor_y; /* of tile objects: the origin as a fraction of the image */
    bool fills_cell;           /* in layers: drawn as large as a cell of the map */
    bool keeps_aspect;         /* scaled to fit the cell, with its aspect ratio kept */
} level_tile;

/* Reads the list "tilesets" of a map, or of a template with the given path. False if memory runs
 * out. */
bool level_list_tilesets(level_tilesets *tilesets, const cJSON *list, const char *path);
level_tile level_find_tile(const level_reader *r, const level_tilesets *tilesets, uint32_t gid);

/* Whether a tile collides. */
typedef enum level_solid {
    LEVEL_OPEN = 0, /* a property says that it does not */
    LEVEL_UNMARKED, /* nothing says whether it does: it does not */
    LEVEL_SOLID     /* it does; without any form if all of them were reported */
} level_solid;

/* Reads the forms of a tile drawn with this size in pixels, about its centre: its collision shapes,
 * or a box if it has none and is solid. The first `outer` links of the chain of `v` are those up to
 * the tileset and the tile's own entry; further links are those of a tile object. *physics becomes
 * the body's. */
level_solid level_read_tile_forms(level_reader *r, const level_values *v, const level_tile *tile,
                                  uint32_t gid, double width, double height, int outer,
                                  level_physics *physics, level_forms *forms);

/* ---- joints.c, tie.c ---- */

/* The joint kind with this name, which is a class of objects, or LEVEL_NO_JOINT. */
int level_joint_kind(const char *name);
const char *level_joint_name(scene_joint_kind kind);
/* Whether a property has a meaning for a kind of joint, or for LEVEL_ANY_JOINT. */
bool level_joint_knows(int kind, const char *name);
/* Whether the engine accepts a coordinate of a frame. */
bool level_joint_fits(const level_reader *r, double length);
/* The place of a side of a joint in the world, in units. */
scene_point level_joint_place(const level_reader *r, const level_joint *o, int side);
/* Keeps the joint that an object at (x, y) pixels describes, or reports why it is none. */
void level_read_joint(level_reader *r, level_values *v, const cJSON *object, int kind, double x,
                      double y, double degrees);

/* Records that the scene's latest body was made for the object `id`. */
void level_place_body(level_reader *r, uint32_t id, double rotation);
/* Adds the kept joints to the scene, or reports why not; gears after all others. */
void level_tie_joints(level_reader *r);

/* ---- objects.c, tiles.c ---- */

void level_read_objects(level_reader *r, const level_layer *layer);
void level_read_tiles(level_reader *r, const level_layer *layer);

#endif
