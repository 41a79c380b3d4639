/* plain.h: reads and writes scenes as hexadecimal words of text, with the bits of each double, for
 * builds without a reader of levels. A file that is written on one machine gives the same scene on
 * every other. */
#ifndef THUD_TESTS_PLAIN_H
#define THUD_TESTS_PLAIN_H

#include "scene.h"

#include <stdio.h>

/* The title of a scene in such a file: words without blanks. The kind determines the settings of
 * its run. */
typedef struct plain_title {
    char kind[16], name[64];
} plain_title;

/* False if the file could not be written. */
bool plain_write(FILE *file, const plain_title *title, scene *s);

/* Reads the next scene of a file into *s, which it initialises. False at the end of the file and if
 * it is damaged; *s is then empty, and *damaged tells which. */
bool plain_read(FILE *file, plain_title *title, scene *s, bool *damaged);

#endif
