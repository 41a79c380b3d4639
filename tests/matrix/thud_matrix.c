/* thud_matrix.c: the program that each row of ./run matrix runs (a row is a compiler, a processor
 * and a system). It runs scenes and prints a line with the hash of each, so that the output of all
 * rows can be compared. */
#include "act_thud.h"
#include "build_thud.h"
#include "choices.h"
#include "options.h"
#include "plain.h"
#include "scenes.h"

#ifdef MATRIX_READS_LEVELS
#include "level.h"
#endif

#include <thud/thud.h>
#include <thud/thud_packed.h>
#include <thud/thud_recording.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_testing.h>

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* The state of a run of this program. */
typedef struct matrix {
    matrix_options options;
    FILE *snapshots;  /* file that is written or read; null: none */
    FILE *kept;       /* file that gets the scenes that are run; may be null */
    char reason[200]; /* message of the engine's last refusal */
} matrix;

/* The world's log: keeps the last message. */
static void keep_reason(thud_result result, const char *message, void *context) {
    (void)result;
    matrix *m = context;
    snprintf(m->reason, sizeof m->reason, "%s", message);
}

/* Settings of a kind of run. A null detection is that of the quality. */
typedef struct setting {
    const char *kind;
    const thud_quality *quality;
    const thud_detection *detection;
    const thud_broadphase *broadphase;
} setting;

static const setting SETTINGS[] = {{"exact", &thud_quality_exact, NULL, &thud_broadphase_all},
                                   {"swept", &thud_quality_high, &thud_detection_swept,
                                    &thud_broadphase_sweep}};
enum { SETTING_COUNT = sizeof SETTINGS / sizeof *SETTINGS };

static thud_world *build(matrix *m, const scene *s, const char *kind) {
    thud_world_def def = thud_default_world_def();
    for (int i = 0; i < SETTING_COUNT; i++) {
        if (strcmp(kind, SETTINGS[i].kind) == 0) {
            def.quality = SETTINGS[i].quality;
            def.detection = SETTINGS[i].detection;
            def.broadphase = SETTINGS[i].broadphase;
        }
    }
    thud_world_def_set_baseline_simd(&def, m->options.baseline);
    def.log = keep_reason;
    def.log_context = m;
    thud_world *world;
    return scene_build_thud(s, &def, &world, NULL, NULL) == THUD_OK ? world : NULL;
}

static bool make_steps(thud_world *world, const scene *s, int count) {
    for (int i = 0; i < count; i++)
        if (scene_step_thud(&s->fields, world) != THUD_OK)
            return false;
    return true;
}

/* ---- snapshot files: for each run four lots of bytes, each after its size in 8 bytes,
 * little-endian: the snapshot, the one of the step before, the first packed against the second, and
 * a recording of the second half ---- */

/* Bytes in memory from malloc. */
typedef struct lot {
    unsigned char *bytes; /* null: there was no memory, or no file */
    size_t size;
} lot;

static thud_bytes in_lot(lot l) {
    return (thud_bytes){l.bytes, l.size};
}

static lot snapshot_of(const thud_world *world) {
    lot l = {NULL, 0};
    if (thud_world_get_snapshot_size(world, &l.size) == THUD_OK)
        l.bytes = malloc(l.size);
    if (l.bytes && thud_world_snapshot(world, l.bytes, l.size, NULL) != THUD_OK) {
        free(l.bytes);
        l.bytes = NULL;
    }
    return l;
}

/* Packs a snapshot against a base. */
static lot packed_of(const thud_world *world, lot snapshot, lot base) {
    lot l = {NULL, 0};
    if (snapshot.bytes && base.bytes &&
        thud_world_pack(world, in_lot(base), in_lot(snapshot), NULL, 0, &l.size) == THUD_OK)
        l.bytes = malloc(l.size);
    if (l.bytes && thud_world_pack(world, in_lot(base), in_lot(snapshot), l.bytes, l.size,
                                   &l.size) != THUD_OK) {
        free(l.bytes);
        l.bytes = NULL;
    }
    return l;
}

/* Appends the bytes to the file of snapshots. */
static bool append(matrix *m, lot l) {
    unsigned char head[8];
    for (int i = 0; i < 8; i++)
        head[i] = (unsigned char)((uint64_t)l.size >> 8 * i);
    return l.bytes && fwrite(head, 1, 8, m->snapshots) == 8 &&
           fwrite(l.bytes, 1, l.size, m->snapshots) == l.size;
}

/* Makes steps, and appends the snapshots after the last one and before it. */
static bool take(matrix *m, thud_world *world, const scene *s, int steps) {
    bool made = make_steps(world, s, steps - 1);
    lot base = snapshot_of(world);
    made = made && make_steps(world, s, 1);
    lot snapshot = snapshot_of(world), packed = packed_of(world, snapshot, base);
    made = made && append(m, snapshot) && append(m, base) && append(m, packed);
    free(base.bytes);
    free(snapshot.bytes);
    free(packed.bytes);
    return made;
}

/* Reads the next bytes; null at the end of the file. */
static lot next_lot(matrix *m) {
    unsigned char head[8];
    uint64_t count = 0;
    lot l = {NULL, 0};
    if (fread(head, 1, 8, m->snapshots) != 8)
        return l;
    for (int i = 0; i < 8; i++)
        count |= (uint64_t)head[i] << 8 * i;
    l.size = (size_t)count;
    l.bytes = count < 1u << 30 ? malloc(l.size + 1) : NULL;
    if (l.bytes && fread(l.bytes, 1, l.size, m->snapshots) != l.size) {
        free(l.bytes);
        l.bytes = NULL;
    }
    return l;
}

/* Whether packing gives the bytes that it gave where they were taken, and these unpack. */
static bool packs_alike(matrix *m, const thud_world *world, lot snapshot, lot base, lot packed) {
    lot own = packed_of(world, snapshot, base);
    unsigned char *back = malloc(snapshot.size);
    size_t size = 0;
    bool alike =
        own.bytes && own.size == packed.size && memcmp(own.bytes, packed.bytes, own.size) == 0;
    if (!alike)
        snprintf(m->reason, sizeof m->reason, "its snapshot is packed to other bytes");
    alike = alike && back &&
            thud_world_unpack(world, in_lot(base), in_lot(packed), back, snapshot.size, &size) ==
                THUD_OK &&
            size == snapshot.size && memcmp(back, snapshot.bytes, size) == 0;
    free(own.bytes);
    free(back);
    return alike;
}

/* Makes steps, and appends a recording of them: CMakeLists.txt compiles act_thud.c and break_thud.c
 * so that their calls are recorded. */
static bool record(matrix *m, thud_world *world, const scene *s, int steps) {
    thud_recorder *recorder;
    thud_recorder_options options = {.hash_steps = 10, .keyframe_steps = 100, .body_hashes = true};
    if (thud_recorder_begin(world, &options, &recorder) != THUD_OK)
        return false;
    thud_bytes bytes;
    bool made = make_steps(world, s, steps) && thud_recorder_get_bytes(recorder, &bytes) == THUD_OK;
    if (made) {
        lot recording = {malloc(bytes.count), bytes.count};
        if (recording.bytes)
            memcpy(recording.bytes, bytes.data, bytes.count);
        made = append(m, recording);
        free(recording.bytes);
    }
    thud_recorder_end(recorder);
    return made;
}

/* Whether a recording, which may be of another row, is played to the state of this world. */
static bool plays_alike(matrix *m, const thud_world *world, lot recording) {
    thud_player_options options = {.log = keep_reason, .log_context = m};
    thud_player *player = NULL;
    thud_world *played = NULL;
    thud_result result = thud_player_create(in_lot(recording), &options, &player);
    for (bool stepped = true; result == THUD_OK && stepped;)
        result = thud_player_step(player, &stepped);
    bool alike = result == THUD_OK && thud_player_get_world(player, &played) == THUD_OK &&
                 thud_hash_of(played) == thud_hash_of(world);
    if (result == THUD_OK && !alike)
        snprintf(m->reason, sizeof m->reason, "its recording is played to another state");
    thud_player_destroy(player);
    return alike;
}

/* ---- a line of output ---- */

/* Makes all steps; if wanted takes a snapshot in the middle, and records what follows. */
static bool run_through(matrix *m, thud_world *world, const scene *s) {
    int half = m->options.steps / 2;
    return m->snapshots ? take(m, world, s, half) && record(m, world, s, half)
                        : make_steps(world, s, 2 * half);
}

/* Restores the next snapshot and makes the second half of the steps, which the recording has, too.
 * False if it is refused, packed to other bytes, or the recording differs. */
static bool run_on(matrix *m, thud_world *world, const scene *s) {
    lot snapshot = next_lot(m), base = next_lot(m), packed = next_lot(m), recording = next_lot(m);
    bool whole = snapshot.bytes && base.bytes && packed.bytes && recording.bytes;
    if (!whole)
        snprintf(m->reason, sizeof m->reason, "the file of snapshots ends too early");
    bool restored = whole && thud_world_restore(world, snapshot.bytes, snapshot.size) == THUD_OK &&
                    packs_alike(m, world, snapshot, base, packed);
    free(snapshot.bytes);
    free(base.bytes);
    free(packed.bytes);
    bool done =
        restored && make_steps(world, s, m->options.steps / 2) && plays_alike(m, world, recording);
    free(recording.bytes);
    return done;
}

static void print_run(matrix *m, const plain_title *title, scene *s) {
    m->reason[0] = 0;
    thud_world *world = build(m, s, title->kind);
    bool done = world && (m->options.go_on ? run_on(m, world, s) : run_through(m, world, s));
    if (m->kept && !plain_write(m->kept, title, s)) {
        snprintf(m->reason, sizeof m->reason, "its plain form could not be written");
        done = false;
    }
    printf("%s %s ", title->kind, title->name);
    if (done)
        printf("%016" PRIx64 "\n", thud_hash_of(world));
    else
        printf("refused: %s\n", m->reason);
    fflush(stdout);
    thud_world_destroy(world);
}

/* ---- all lines of output ---- */

/* The same as in tests/scenes/test_golden.c, so that the hashes are those of its file. */
enum { LARGE = 1000, SIZE_OF_LARGE = 600 };
enum { MOST_BODIES_OF_COSTLY = 120 };

/* Fills the scene at the size of the golden hashes; halves it while the scene has too many bodies.
 */
static bool fill(const matrix *m, const scene_info *info, bool costly, scene *s) {
    int size = info->default_size > LARGE ? SIZE_OF_LARGE : info->default_size;
    int most = m->options.bodies;
    if (costly && most > MOST_BODIES_OF_COSTLY)
        most = MOST_BODIES_OF_COSTLY;
    while (scenes_fill(info, size, s)) {
        if (s->body_count <= most || size / 2 < info->min_size)
            return true;
        scene_free(s);
        size /= 2;
    }
    return false;
}

static void print_scenes(matrix *m, const char *kind, bool costly) {
    for (int i = 0; i < scenes_count(); i++) {
        plain_title title;
        scene s;
        snprintf(title.kind, sizeof title.kind, "%s", kind);
        snprintf(title.name, sizeof title.name, "%s", scenes_at(i)->name);
        if (fill(m, scenes_at(i), costly, &s)) {
            print_run(m, &title, &s);
            scene_free(&s);
        } else {
            printf("%s %s refused: it cannot be filled\n", kind, title.name);
        }
    }
}

/* Runs the scenes of the file of plain scenes. False, after a message, if it is damaged. */
static bool print_plain(matrix *m) {
    FILE *file = m->options.plain ? fopen(m->options.plain, "rb") : NULL;
    bool damaged = m->options.plain && !file;
    plain_title title;
    scene s;
    while (file && plain_read(file, &title, &s, &damaged)) {
        print_run(m, &title, &s);
        scene_free(&s);
    }
    if (file)
        fclose(file);
    if (damaged)
        fprintf(stderr, "thud-matrix: %s has no scenes in plain form\n", m->options.plain);
    return !damaged;
}

/* Writes the named levels in plain form. */
static bool make_plain(const matrix_options *options) {
#ifdef MATRIX_READS_LEVELS
    FILE *file = fopen(options->make_plain, "wb");
    bool made = file != NULL;
    for (int i = 0; i < options->source_count && made; i++) {
        const char *path = options->sources[i], *slash = strrchr(path, '/');
        plain_title title = {.kind = "level"};
        snprintf(title.name, sizeof title.name, "%s", slash ? slash + 1 : path);
        scene s;
        level_report report;
        made = level_read_file(path, true, &s, &report) && plain_write(file, &title, &s);
        if (!made)
            fprintf(stderr, "thud-matrix: %s cannot be read or written\n", path);
        level_report_free(&report);
        scene_free(&s);
    }
    return file && fclose(file) == 0 && made;
#else
    fprintf(stderr, "thud-matrix: built without the reader of levels: %s\n", options->make_plain);
    return false;
#endif
}

/* Opens a file if a path is given. False, after a message, if it cannot be opened. */
static bool open_file(const char *path, const char *mode, FILE **out) {
    *out = path ? fopen(path, mode) : NULL;
    if (!path || *out)
        return true;
    fprintf(stderr, "thud-matrix: %s cannot be opened\n", path);
    return false;
}

static bool close_file(FILE *file) {
    return !file || fclose(file) == 0;
}

int main(int count, char **words) {
    matrix m = {0};
    if (!matrix_options_parse(count, words, &m.options))
        return 2;
    const matrix_options *o = &m.options;
    if (o->make_plain)
        return make_plain(o) ? 0 : 1;
    if (!open_file(o->go_on ? o->go_on : o->take, o->go_on ? "rb" : "wb", &m.snapshots) ||
        !open_file(o->keep, "wb", &m.kept))
        return 1;
    if (!o->no_scenes) {
        print_scenes(&m, "scene", false);
        for (int i = 0; i < SETTING_COUNT; i++)
            print_scenes(&m, SETTINGS[i].kind, true);
    }
    bool done = print_plain(&m);
    done = close_file(m.kept) && done;
    done = close_file(m.snapshots) && done;
    return done ? 0 : 1;
}
