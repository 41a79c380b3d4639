/* level.h: reads a map of the Tiled editor in its JSON format (.tmj) into a scene.
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
 *   rectangle   hw = width * 0.5    dx = c * hw - s * hh    position x = ((ox + x) + dx) / ppu
 *   or ellipse  hh = height * 0.5   dy = s * hw + c * hh             y = (H - ((oy + y) + dy)) /
 * ppu angle = 0 - r * (pi / 180)    half extents hw / ppu, hh / ppu; radius hw / ppu polyline
 * position of its body ((ox + x) / ppu, (H - (oy + y)) / ppu), angle 0; points
 *               ((c * px - s * py) / ppu, 0 - (s * px + c * py) / ppu), reversed if the last
 *               lies left of the first
 *   tile        column i, row j: x = (ox + (i + 0.5) * tilewidth) / ppu,
 *               y = (H - (oy + (j + 0.5) * tileheight)) / ppu,
 *               half extents (tilewidth * 0.5) / ppu, (tileheight * 0.5) / ppu
 *
 * Positions of bodies are then rounded by scene_grid. Layers come in the order of the file, within
 * them objects in the order of the file and tiles row by row from the top left. */
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
    char text[160];  /* says what and where; already names the object or layer */
} level_problem;

/* All that a reader has to say about a file; the first LEVEL_PROBLEMS of it in words. */
enum { LEVEL_PROBLEMS = 100 };
typedef struct level_report {
    level_problem problems[LEVEL_PROBLEMS];
    int count;                  /* of problems in words */
    int notes, skipped, fatal;  /* how many there are of each severity, in words or not */
} level_report;

/* Reads a map of `length` bytes into *s, which it initialises; the caller frees the scene. `name`
 * becomes the scene's. Everything amiss is in *report. False, and *s is empty, if something is
 * fatal, or if something would have to be skipped and `skip` is false. */
bool level_read(const char *name, const char *text, size_t length, bool skip, scene *s,
                level_report *report);

/* The same with a file; the name is the file's, without folder and suffix. */
bool level_read_file(const char *path, bool skip, scene *s, level_report *report);

/* Cosine and sine of a rotation in degrees, equal in every language with IEEE doubles:
 *   r = degrees - 360 * floor(degrees / 360 + 0.5)        in [-180, 180)
 *   q = floor(r / 90 + 0.5)                               the nearest quarter turn, -2 to 2
 *   a = (r - 90 * q) * (pi / 180)                         in [-pi/4, pi/4]
 * then sine and cosine of `a` by their Taylor series in Horner's form (see the source), turned by
 * q quarters. Returns r. Multiples of 90 degrees are exact. */
double level_turn(double degrees, double *c, double *s);

#endif
