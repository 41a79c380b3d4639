/* replay.c: runs a fuzz target on kept inputs without a fuzzer: on files, folders of them, and
 * packed files (pack.py). It prints the name of each before it is played, so that the last name
 * printed is the one that fails. */
#include "session.h"
#include "target.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 1 << 22 };

static int played;

/* Plays an input from a block of exactly its length, so that sanitizers notice a read past its end.
 */
static void play(const char *name, const uint8_t *text, size_t size) {
    uint8_t *exact = malloc(size + (size == 0));
    memcpy(exact, text, size);
    fprintf(stderr, "%s\n", name);
    LLVMFuzzerTestOneInput(exact, size);
    free(exact);
    played++;
}

static void play_pack(const char *path, const uint8_t *text, size_t size) {
    size_t number = 0;
    for (size_t at = 0; at + 4 <= size; number++) {
        size_t length = text[at] | (size_t)text[at + 1] << 8 | (size_t)text[at + 2] << 16;
        char name[1024];
        snprintf(name, sizeof name, "%s, input %zu, %zu bytes from %zu on", path, number, length,
                 at + 4);
        if (text[at + 3] || length > size - at - 4) {
            fprintf(stderr, "replay: %s is cut short\n", path);
            exit(1);
        }
        play(name, text + at + 4, length);
        at += 4 + length;
    }
}

static void play_file(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) {
        fprintf(stderr, "replay: cannot open %s\n", path);
        exit(1);
    }
    uint8_t *text = malloc(LARGEST);
    size_t size = fread(text, 1, LARGEST, file), length = strlen(path);
    fclose(file);
    bool packed = length > 5 && strcmp(path + length - 5, ".pack") == 0;
    (packed ? play_pack : play)(path, text, size);
    free(text);
}

/* False if the path is not a folder. */
static bool play_folder(const char *path) {
    DIR *folder = opendir(path);
    if (!folder) {
        return false;
    }
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[1024];
        if (entry->d_name[0] != '.') {
            snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
            play_file(name);
        }
    }
    closedir(folder);
    return true;
}

int main(int count, char **paths) {
    for (int i = 1; i < count; i++) {
        if (!play_folder(paths[i])) {
            play_file(paths[i]);
        }
    }
    printf("%d inputs, %" PRIu64 " calls\n", played, fuzz_calls_made);
    return played ? 0 : 1;
}
