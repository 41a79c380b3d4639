/* level.h: reads a map of the Tiled editor into a scene: .tmj and .tmx, with the tilesets (.tsj,
 * .tsx) and templates (.tj, .tx) that it refers to.
 *
 * What of a map means what, and the names of the properties, stand in assets/levels/README.md.
 * The page has a reader of its own for the same files, and both must make equal worlds to the bit.
 * So the arithmetic is part of the contract; every operation is one IEEE double operation, in the
 * order that the parentheses give:
 *
 *   ppu         pixels per unit: the map's property, else its tilewidth
 *   H           map height in pixels: height * tileheight
 *   ox, oy      a layer's offset: offsetx, offsety, plus its parent group's: parent + own
 *   c, s, r     level_turn(rotation), below
 *   form        what an object's outline is, in pixels from the object's own place, unturned:
 *               rectangle or circle about (width * 0.5, height * 0.5); the points of a line
 *   turned      about (x, y): centre (x + (c * fx - s * fy), y + (s * fx + c * fy)), its rotation
 *               level_turn(form's + rotation); points of a line (c * px - s * py, s * px + c * py)
 *               about the place (x, y), reversed if the last lies left of the first
 *   body        position (x / ppu, (H - y) / ppu), angle 0 - r * (pi / 180); a form on it has the
 *               offset (fx / ppu, 0 - fy / ppu), half extents hx / ppu, hy / ppu, radius hx / ppu,
 *               angle 0 - its r * (pi / 180), points (px / ppu, 0 - py / ppu)
 *   object      a single box or circle is turned about (ox + x, oy + y), and its body lies at its
 *               centre with its rotation; a line's body lies at (ox + x, oy + y), unturned; several
 *               forms share a body there, with the object's rotation
 *   tile        of w by h pixels (its image), drawn dw by dh: sx = dw / w, sy = dh / h. Forms of
 *               its collision shapes are turned about their places, flipped (x and y change places
 *               first, then x becomes w - x, y becomes h - y; rotations change sign each time),
 *               scaled, then moved by (0 - dw * 0.5, 0 - dh * 0.5)
 *   tile object body at the drawn centre: the anchor's fraction (ax, ay) of the tileset gives
 *               (((0.5 - ax) * dw) + offx * sx, ((0.5 - ay) * dh) + offy * sy), turned about
 *               (ox + x, oy + y)
 *   cell        column i, row j: body at ((ox + i * tilewidth) + offx * sx) + dw * 0.5,
 *               ((oy + (j + 1) * tileheight) + offy * sy) - dh * 0.5
 *   joint       its places in a and in b are turned about (ox + x, oy + y) as a form is: (0, 0) of
 *               a point, (width * 0.5, height * 0.5) of a rectangle, the ends of a line, of which
 *               the first counts twice unless it is a distance. They become (px, py) as bodies do,
 *               rounded by scene_grid; in a body at (bx, by) with c, s of its rotation, and with
 *               dx = px - bx, dy = py - by, they are (c * dx - s * dy, s * dx + c * dy).
 *               A distance between places dx, dy apart is sqrt(dx * dx + dy * dy) long
 *   axis        has the rotation r of the joint's object, of a wheel less 90, or of its line
 *               (level_direction, in polygon.c); in a body its angle is
 *               (0 - level_turn(r) * (pi / 180)) - the body's
 *
 * Positions of bodies are then rounded by scene_grid. Layers come in the order of the file, within
 * them objects in the order of the file and tiles row by row from the top left. Lines have a body
 * each, after that of the other forms. Joints follow, in the order of the file, gears after all
 * others; one that holds to the world brings a static body, without shapes, at its place in a. */
#ifndef THUD_DEMO_LEVEL_H
#define THUD_DEMO_LEVEL_H

#include "scene.h"

typedef enum level_severity {
    LEVEL_NOTE = 0, /* has no effect on the world; the level loads */
    LEVEL_SKIP,     /* cannot be modelled, or is malformed: refused, or left out on request */
    LEVEL_FATAL     /* the file cannot be used at all */
} level_severity;

typedef struct level_problem {
    level_severity severity;
    uint32_t object; /* id of the object, or 0 if it is about a layer or the map */
    char text[200];  /* says what and where; already names the object or layer */
} level_problem;

/* All that a reader has to say about a file, in the order of the file; what joints refer to comes
 * last, since it may stand after them. Only a file made to fill
 * the memory has more than LEVEL_PROBLEMS: those are counted, and not in words. */
enum { LEVEL_PROBLEMS = 100000 };
typedef struct level_report {
    level_problem *problems;
    int count, capacity;       /* of problems in words, and of the room for them */
    int notes, skipped, fatal; /* how many there are of each severity, in words or not */
} level_report;

/* Frees the words; a report that a reader filled needs it. */
void level_report_free(level_report *report);

/* Gives the files that a map refers to. `path` is relative to the map's own folder, with '/' and
 * no '.' in it, "templates/block.tx" or "../tiles/ground.tsx"; paths that are absolute, or name a
 * host, are refused before. Returns the whole file in memory from malloc, or null. */
typedef struct level_opener {
    char *(*open)(void *context, const char *path, size_t *length);
    void *context;
} level_opener;

/* Reads a map of `length` bytes into *s, which it initialises; the caller frees the scene. `name`
 * becomes the scene's. A null `opener` means a map that stands alone. Everything amiss is in
 * *report, which it initialises too; the caller frees it. False, and *s is empty, if something is
 * fatal, or if something would have to be skipped and `skip` is false. */
bool level_read_with(const char *name, const char *text, size_t length, const level_opener *opener,
                     bool skip, scene *s, level_report *report);

/* The same with a map that stands alone. */
bool level_read(const char *name, const char *text, size_t length, bool skip, scene *s,
                level_report *report);

/* The same with a file, and with those beside it that it refers to; the name is the file's,
 * without folder and suffix. */
bool level_read_file(const char *path, bool skip, scene *s, level_report *report);

/* Cosine and sine of a rotation in degrees, equal in every language with IEEE doubles:
 *   r = degrees - 360 * floor(degrees / 360 + 0.5)        in [-180, 180)
 *   q = floor(r / 90 + 0.5)                               the nearest quarter turn, -2 to 2
 *   a = (r - 90 * q) * (pi / 180)                         in [-pi/4, pi/4]
 * then sine and cosine of `a` by their Taylor series in Horner's form (see the source), turned by
 * q quarters. Returns r. Multiples of 90 degrees are exact. */
double level_turn(double degrees, double *c, double *s);

#endif
