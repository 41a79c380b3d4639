/* page.h: docs/stability.md, made of the figures. */
#ifndef THUD_STABILITY_PAGE_H
#define THUD_STABILITY_PAGE_H

#include "extremes/extreme.h"

#include <stdio.h>

typedef struct page_part {
    const extreme *extreme;
    const ledger *ledger;
} page_part;

/* `notes` is the text kept by hand: what stands before its first line "## NAME" opens the page, and
 * what follows such a line goes below the table of that extreme. */
void page_write(FILE *out, const page_part *parts, int count, const char *notes);

/* Whether a heading of the notes names no extreme; then *line is where it starts. */
bool page_notes_stray(const char *notes, const char **line);

/* One extreme's table alone. */
void page_write_table(FILE *out, const ledger *l);

#endif
