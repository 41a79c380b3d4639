/* progress.h: reports how many calls were made while the fuzzer runs. */
#ifndef FUZZ_PROGRESS_H
#define FUZZ_PROGRESS_H

/* At intervals writes the number of calls that this process has made to the file that the
 * environment variable FUZZ_PROGRESS names, with the process's id as suffix. Does nothing if it is
 * not set. */
void progress_tell(void);

#endif
