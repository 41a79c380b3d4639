/* progress.h: one line on a terminal that says how far a long measurement is; nothing where nobody
 * looks. */
#ifndef THUD_BENCH_PROGRESS_H
#define THUD_BENCH_PROGRESS_H

void progress_show(const char *what, double fraction); /* in [0, 1] */
void progress_clear(void);                             /* before anything else is printed */

#endif
