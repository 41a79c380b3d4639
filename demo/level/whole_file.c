/* whole_file.c: see whole_file.h. The kind of file is asked for before it is opened. */
#define _POSIX_C_SOURCE 200809L /* S_ISREG */

#include "whole_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

char *whole_file_read(const char *path, size_t bytes_max, size_t *length) {
    struct stat about;
    if (stat(path, &about) != 0 || !S_ISREG(about.st_mode) ||
        (unsigned long long)about.st_size > bytes_max)
        return NULL;
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    char *text = malloc((size_t)about.st_size + 1); /* + 1: malloc(0) may be null */
    if (text) {
        *length = fread(text, 1, (size_t)about.st_size, file);
        if (ferror(file)) {
            free(text);
            text = NULL;
        }
    }
    fclose(file);
    return text;
}
