/* plain.h: a scene as words of text, every double by its bits, for programs that have no reader of
 * levels. What is written on one machine is read on every other to the same scene. */
#ifndef THUD_TESTS_PLAIN_H
#define THUD_TESTS_PLAIN_H

#include "scene.h"

#include <stdio.h>

/* What a scene is called in such a file: words without blanks. The kind is what it is run as. */
typedef struct plain_title {
    char kind[16], name[64];
} plain_title;

/* False where the file could not be written. */
bool plain_write(FILE *file, const plain_title *title, scene *s);

/* Reads the next scene of a file into *s, which it initialises. At the end of the file, and where
 * it is damaged, false: then *s is empty, and *damaged tells. */
bool plain_read(FILE *file, plain_title *title, scene *s, bool *damaged);

#endif
