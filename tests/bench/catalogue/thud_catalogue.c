/* thud_catalogue.c: the program thud-catalogue, which measures the cost and the errors of each
 * system of the engine. It runs the parts that the command line names, one after the other, and
 * prints each when it is done. */
#include "catalogue/catalogue.h"
#include "machine.h"

#include <string.h>

static const struct {
    const char *name, *title;
    bool (*run)(bool quick, json *out);
} PARTS[] = {
    {"broadphases", "Broadphases: what a shape costs", catalogue_broadphases},
    {"detections", "Detection: four ways through the same scene", catalogue_detections},
    {"walls", "Detection: who passes through a thin wall", catalogue_walls},
    {"throws", "Detection: where a thrown ball is met", catalogue_throws},
    {"prices", "Detection, priced: error over time", catalogue_prices},
    {"levels", "Bounding volumes: how many pairs each lets through", catalogue_levels},
    {"volumes", "Bounding volumes: ns a call", catalogue_volumes},
    {"calls", "Geometry: ns a call", catalogue_calls},
    {"grounds", "Terrain: ns a call", catalogue_grounds},
    {"queries", "Queries: ns a call", catalogue_queries},
};

enum { PART_COUNT = sizeof PARTS / sizeof PARTS[0] };

typedef struct settings {
    bool quick;
    unsigned parts; /* a bit for each part */
    const char *json;
} settings;

static void print_help(void) {
    printf("usage: thud-catalogue [option...]\n"
           "Measures what each system of the engine costs and gets wrong.\n\n"
           "  --part NAME  only this part; may be given several times. Parts:");
    for (int i = 0; i < PART_COUNT; i++)
        printf(" %s", PARTS[i].name);
    printf("\n"
           "  --quick      shows that it runs, compares little\n"
           "  --json FILE  also writes everything to FILE\n"
           "  --help       this text\n");
}

static bool refuse(const char *what, const char *value) {
    fprintf(stderr, "thud-catalogue: %s: %s (see --help)\n", what, value);
    return false;
}

static bool add_part(settings *s, const char *name) {
    for (int i = 0; i < PART_COUNT; i++)
        if (strcmp(PARTS[i].name, name) == 0) {
            s->parts |= 1u << i;
            return true;
        }
    return refuse("no such part", name);
}

static bool read_settings(settings *s, int argc, char **argv) {
    *s = (settings){0};
    for (int i = 1; i < argc; i++) {
        bool takes_value = strcmp(argv[i], "--part") == 0 || strcmp(argv[i], "--json") == 0;
        if (takes_value && i + 1 == argc)
            return refuse("a value is missing after", argv[i]);
        if (strcmp(argv[i], "--quick") == 0)
            s->quick = true;
        else if (strcmp(argv[i], "--json") == 0)
            s->json = argv[++i];
        else if (!takes_value)
            return refuse("unknown option", argv[i]);
        else if (!add_part(s, argv[++i]))
            return false;
    }
    if (s->parts == 0)
        s->parts = (1u << PART_COUNT) - 1;
    return true;
}

static bool measure(const settings *s, FILE *file) {
    json out = {.file = file};
    bool ok = true;
    json_begin_object(&out, NULL);
    machine_describe(&out);
    json_bool(&out, "quick", s->quick);
    for (int i = 0; i < PART_COUNT; i++) {
        if (!(s->parts & 1u << i))
            continue;
        printf("\n%s\n\n", PARTS[i].title);
        ok = PARTS[i].run(s->quick, &out) && ok;
        fflush(stdout);
    }
    json_end(&out);
    return ok;
}

int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            print_help();
            return 0;
        }
    settings s;
    if (!read_settings(&s, argc, argv))
        return 2;
    FILE *file = NULL;
    if (s.json && !(file = fopen(s.json, "w"))) {
        refuse("cannot write", s.json);
        return 2;
    }
    bool ok = measure(&s, file);
    if (file) {
        bool written = !ferror(file);
        if (fclose(file) != 0 || !written) {
            fprintf(stderr, "thud-catalogue: could not write: %s\n", s.json);
            ok = false;
        }
    }
    return ok ? 0 : 1;
}
