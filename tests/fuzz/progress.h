/* progress.h: how many calls were made, for those who wait. */
#ifndef FUZZ_PROGRESS_H
#define FUZZ_PROGRESS_H

/* Once in a while writes the calls that this process made to the file that FUZZ_PROGRESS names,
 * with the process's number behind its name; without it does nothing. */
void progress_tell(void);

#endif
