/* whole_file.h: reads files whole, for the level reader and for what plays recordings. */
#ifndef WHOLE_FILE_H
#define WHOLE_FILE_H

#include <stddef.h>

/* Reads a file into memory from malloc, without a zero at its end. Null if it cannot be read, is no
 * regular file (one that never ends, as /dev/zero, or a named pipe, which blocks whoever opens it)
 * or has more than `bytes_max` bytes. */
char *whole_file_read(const char *path, size_t bytes_max, size_t *length);

#endif
