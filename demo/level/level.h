/* level.h: reads a map of the Tiled editor (.tmj, .tmx) into a scene, with the tilesets (.tsj,
 * .tsx) and templates (.tj, .tx) that it refers to.
 *
 * assets/levels/README.md says what each element of a map becomes, and lists the properties. The
 * page has a reader of its own for the same files, and both must produce the same worlds, bit for
 * bit. So the arithmetic is specified here: each operation is one IEEE double operation, in the
 * order that the parentheses give.
 *
 *   ppu         pixels per unit: the map's property, else its tilewidth
 *   H           map height in pixels: height * tileheight
 *   ox, oy      a layer's offset: offsetx, offsety, plus its parent group's: parent + own
 *   c, s, r     level_turn(rotation), below
 *   form        an object's outline in pixels, relative to the object's place, unrotated:
 *               rectangle or circle about (width * 0.5, height * 0.5); the points of a line
 *   rotated     about (x, y): centre (x + (c * fx - s * fy), y + (s * fx + c * fy)), its rotation
 *               level_turn(form's + rotation); points of a line (c * px - s * py, s * px + c * py)
 *               about the place (x, y), reversed if the last lies left of the first
 *   body        position (x / ppu, (H - y) / ppu), angle 0 - r * (pi / 180); a form on it has the
 *               offset (fx / ppu, 0 - fy / ppu), half extents hx / ppu, hy / ppu, radius hx / ppu,
 *               angle 0 - its r * (pi / 180), points (px / ppu, 0 - py / ppu)
 *   object      a single box or circle is rotated about (ox + x, oy + y), and its body lies at its
 *               centre with its rotation; a line's body lies at (ox + x, oy + y), unrotated;
 *               several forms share a body there, with the object's rotation
 *   tile        of w by h pixels (its image), drawn dw by dh: sx = dw / w, sy = dh / h. Forms of
 *               its collision shapes are rotated about their places, flipped (x and y change places
 *               first, then x becomes w - x, y becomes h - y; rotations change sign each time),
 *               scaled, then moved by (0 - dw * 0.5, 0 - dh * 0.5)
 *   tile object body at the drawn centre: the anchor's fraction (ax, ay) of the tileset gives
 *               (((0.5 - ax) * dw) + offx * sx, ((0.5 - ay) * dh) + offy * sy), rotated about
 *               (ox + x, oy + y)
 *   cell        column i, row j: body at ((ox + i * tilewidth) + offx * sx) + dw * 0.5,
 *               ((oy + (j + 1) * tileheight) + offy * sy) - dh * 0.5
 *   joint       its places on a and on b are rotated about (ox + x, oy + y) as a form is: (0, 0) of
 *               a point, (width * 0.5, height * 0.5) of a rectangle, the two ends of a line for a
 *               distance, the first end for both in other joints. They become (px, py) as bodies
 * do, rounded by scene_grid; in a body at (bx, by) with c, s of its rotation, and with dx = px -
 * bx, dy = py - by, they are (c * dx - s * dy, s * dx + c * dy). A distance between places dx, dy
 * apart is sqrt(dx * dx + dy * dy) long axis        has the rotation r of the joint's object (less
 * 90 for a wheel), or of its line (level_direction, in polygon.c); relative to a body its angle is
 *               (0 - level_turn(r) * (pi / 180)) - the body's
 *
 * Positions of bodies are then rounded by scene_grid. Layers are read in the order of the file,
 * within them objects in the order of the file and tiles row by row from the top left. Each line
 * gets a body of its own, after that of the other forms. Joints follow in the order of the file,
 * gears after all others. A joint that holds a body to the world adds a static body without shapes
 * at its place on a. */
#ifndef THUD_DEMO_LEVEL_H
#define THUD_DEMO_LEVEL_H

#include "scene.h"

typedef enum level_severity {
    LEVEL_NOTE = 0, /* has no effect on the world; the level is loaded */
    LEVEL_SKIP, /* cannot be modelled, or is malformed: the level is refused, or loaded without it
                   on request */
    LEVEL_FATAL /* the file cannot be used at all */
} level_severity;

/* Instead of the id of an object, which is at least 1. */
enum { LEVEL_NO_OBJECT = 0 };

typedef struct level_problem {
    level_severity severity;
    uint32_t object; /* its id; LEVEL_NO_OBJECT: the problem is about a layer or the map */
    char text[200];  /* what is wrong and where; names the object or layer */
} level_problem;

/* The problems that a reader found in a file, in the order of the file; those of joints' references
 * come last, since the objects may follow the joints. At most LEVEL_PROBLEMS have a text; further
 * ones are only counted, which happens only for files that are made to fill the memory. */
enum { LEVEL_PROBLEMS = 100000 };
typedef struct level_report {
    level_problem *problems;
    int count, capacity;       /* of problems with a text, and of the memory for them */
    int notes, skipped, fatal; /* number of problems of each severity, with or without a text */
} level_report;

/* Frees the problems. A report that a reader filled has to be freed. */
void level_report_free(level_report *report);

/* Opens the files that a map refers to. `path` is relative to the map's own folder, with '/'
 * between its parts and no part ".", as "templates/block.tx" or "../tiles/ground.tsx". Absolute
 * paths and those that name a host are refused before. `open` returns the whole file in memory from
 * malloc, or null. */
typedef struct level_opener {
    char *(*open)(void *context, const char *path, size_t *length);
    void *context;
} level_opener;

/* Reads a map of `length` bytes into *s and its problems into *report; both are initialised here
 * and freed by the caller. `name` becomes the scene's name. A null `opener` means a map that refers
 * to no files. False, and *s is empty, if a problem is fatal, or if something has to be left out
 * and `skip_unsupported` is false. */
bool level_read_with(const char *name, const char *text, size_t length, const level_opener *opener,
                     bool skip_unsupported, scene *s, level_report *report);

/* The same for a map that refers to no files. */
bool level_read(const char *name, const char *text, size_t length, bool skip_unsupported, scene *s,
                level_report *report);

/* The same for a file, and the files that it refers to by their paths from its folder. The scene's
 * name is the file's, without folder and suffix. */
bool level_read_file(const char *path, bool skip_unsupported, scene *s, level_report *report);

/* The rotation `degrees` reduced to [-180, 180), which is returned, and its cosine and sine, with
 * the same bits in every language with IEEE doubles:
 *   r = degrees - 360 * floor(degrees / 360 + 0.5)        in [-180, 180)
 *   q = floor(r / 90 + 0.5)                               the nearest quarter turn, -2 to 2
 *   a = (r - 90 * q) * (pi / 180)                         in [-pi/4, pi/4]
 * Sine and cosine of `a` are the Taylor series in Horner's form (turn.c), rotated by q quarter
 * turns. Multiples of 90 degrees are exact. */
double level_turn(double degrees, double *c, double *s);

#endif
