/* progress.h: shows the progress of a long measurement in one line of the terminal. Does nothing if
 * stderr is not a terminal. */
#ifndef THUD_BENCH_PROGRESS_H
#define THUD_BENCH_PROGRESS_H

void progress_show(const char *what, double fraction); /* fraction in [0, 1] */
void progress_clear(void);                             /* call before anything else is printed */

#endif
