/* advise_json.c: prints an advice as one JSON object. */
#include "advise.h"

#include "choices.h"

#include <cjson/cJSON.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

static cJSON *command_of(const run_options *how) {
    char command[RUN_COMMAND_MAX];
    run_command(how, command);
    return cJSON_CreateString(command);
}

static cJSON *finite_or_null(double value) {
    return isfinite(value) ? cJSON_CreateNumber(value) : cJSON_CreateNull();
}

static cJSON *setting_of(const advise_setting *setting) {
    const run_options *how = &setting->how;
    const run_outcome *o = &setting->outcome;
    char hash[17], name[ADVISE_NAME_MAX];
    snprintf(hash, sizeof hash, "%016" PRIx64, o->hash);
    advise_name(how, name);
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "name", name);
    cJSON_AddStringToObject(json, "quality", QUALITIES[how->quality]->name);
    cJSON_AddStringToObject(json, "detection", DETECTIONS[how->detection].name);
    cJSON_AddStringToObject(json, "broadphase", BROADPHASES[how->broadphase].name);
    cJSON_AddNumberToObject(json, "substeps", how->substeps);
    cJSON_AddItemToObject(json, "error", finite_or_null(setting->error));
    cJSON_AddNumberToObject(json, "penetration_max", o->penetration_max);
    cJSON_AddNumberToObject(json, "joint_gap_max", o->worst.joint_gap_max);
    cJSON_AddNumberToObject(json, "passed", (double)o->passed);
    cJSON_AddNumberToObject(json, "quarantined", (double)o->quarantined);
    cJSON_AddNumberToObject(json, "ms", setting->ms);
    cJSON_AddNumberToObject(json, "ms_max", setting->ms_max);
    cJSON_AddNumberToObject(json, "runs", setting->runs);
    cJSON_AddBoolToObject(json, "meets", advise_meets(setting));
    cJSON_AddNumberToObject(json, "bytes", (double)o->stats.bytes);
    cJSON_AddStringToObject(json, "hash", hash);
    cJSON_AddItemToObject(json, "command", command_of(how));
    return json;
}

static void add_link(cJSON *json, advise_link link) {
    cJSON_AddItemToObject(json, "link_program",
                          link.program ? cJSON_CreateString(link.program) : cJSON_CreateNull());
    cJSON_AddItemToObject(json, "link_kB",
                          link.program ? cJSON_CreateNumber(link.kilobytes) : cJSON_CreateNull());
}

static cJSON *offs_of(const advice *a) {
    cJSON *list = cJSON_CreateArray();
    const advise_setting *base = &a->series.settings[a->offs.base];
    for (int i = 0; i < a->offs.count; i++) {
        const advise_off *off = &a->offs.offs[i];
        cJSON *json = setting_of(&off->setting);
        cJSON_AddStringToObject(json, "without", off->name);
        cJSON_AddNumberToObject(json, "saved_ms", base->ms - off->setting.ms);
        cJSON_AddNumberToObject(json, "saved_bytes",
                                (double)base->outcome.stats.bytes -
                                    (double)off->setting.outcome.stats.bytes);
        add_link(json, off->link);
        cJSON_AddItemToObject(json, "moved", finite_or_null(off->moved));
        cJSON_AddBoolToObject(json, "same", off->same);
        cJSON_AddBoolToObject(json, "needless", off->needless);
        cJSON_AddBoolToObject(json, "saves", off->saves);
        cJSON_AddItemToArray(list, json);
    }
    return list;
}

static cJSON *strain_of(const advise_strain *strain) {
    cJSON *list = cJSON_CreateArray();
    for (int i = 0; i < strain->count; i++) {
        cJSON *row = setting_of(&strain->tried[i]);
        cJSON_AddNumberToObject(row, "factor", strain->factors[i]);
        cJSON_AddItemToArray(list, row);
    }
    return list;
}

static cJSON *growth_of(const advise_growth *g) {
    static const char *const BROKEN[] = {"holds", "time", "error"};
    cJSON *json = cJSON_CreateObject();
    cJSON_AddItemToObject(json, "not_measured_as",
                          g->why_not ? cJSON_CreateString(g->why_not) : cJSON_CreateNull());
    cJSON_AddNumberToObject(json, "budget_ms", g->budget_ms);
    cJSON *sizes = cJSON_AddArrayToObject(json, "sizes");
    for (int i = 0; i < g->count; i++) {
        const advise_size *size = &g->sizes[i];
        cJSON *row = setting_of(&size->setting);
        cJSON_AddNumberToObject(row, "size", size->size);
        cJSON_AddNumberToObject(row, "bodies", size->bodies);
        cJSON_AddStringToObject(row, "broken", BROKEN[size->broken]);
        cJSON_AddNumberToObject(row, "stack", size->uses.stack);
        cJSON_AddNumberToObject(row, "mass_ratio", size->uses.mass_ratio);
        cJSON_AddNumberToObject(row, "speed", size->uses.speed);
        cJSON_AddItemToArray(sizes, row);
    }
    cJSON_AddItemToObject(json, "held",
                          g->held < 0 ? cJSON_CreateNull() : cJSON_CreateNumber(g->held));
    cJSON_AddItemToObject(json, "missed",
                          g->missed < 0 ? cJSON_CreateNull() : cJSON_CreateNumber(g->missed));
    cJSON_AddBoolToObject(json, "gave_up", g->gave_up);
    cJSON_AddItemToObject(json, "no_speeds_as",
                          g->no_speeds ? cJSON_CreateString(g->no_speeds) : cJSON_CreateNull());
    cJSON_AddItemToObject(json, "faster", strain_of(&g->faster));
    cJSON_AddItemToObject(json, "heavier", strain_of(&g->heavier));
    advise_first first = advise_first_of(g);
    cJSON_AddStringToObject(json, "first", first.what);
    cJSON_AddItemToObject(json, "first_factor", finite_or_null(first.factor));
    return json;
}

bool advise_print_json(const advice *a) {
    const advise_series *series = &a->series;
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "scene", a->scene->name);
    cJSON_AddNumberToObject(json, "steps", (double)a->options->steps);
    cJSON_AddNumberToObject(json, "bodies", a->scene->body_count);
    cJSON_AddNumberToObject(json, "length_scale", a->scene->length_scale);
    cJSON_AddNumberToObject(json, "max_error", a->options->max_error);
    cJSON_AddItemToObject(json, "budget_ms", finite_or_null(a->options->budget));
    cJSON *settings = cJSON_AddArrayToObject(json, "settings");
    for (int i = 0; i < series->count; i++) {
        cJSON *setting = setting_of(&series->settings[i]);
        add_link(setting, advise_link_of(&series->settings[i].how, a->scene));
        cJSON_AddItemToArray(settings, setting);
    }
    cJSON_AddNumberToObject(json, "now", series->now);
    cJSON_AddItemToObject(json, "advised",
                          series->advised < 0 ? cJSON_CreateNull()
                                              : cJSON_CreateNumber(series->advised));
    cJSON_AddNumberToObject(json, "nearest", series->nearest);
    cJSON *used = cJSON_AddObjectToObject(json, "uses");
    run_options count = series->settings[series->now].how;
    count.uses = true;
    cJSON_AddItemToObject(used, "counts", uses_json(&a->uses, a->used.hash));
    cJSON_AddItemToObject(used, "command", command_of(&count));
    cJSON_AddNumberToObject(json, "base", a->offs.base);
    cJSON_AddItemToObject(json, "off", offs_of(a));
    cJSON_AddItemToObject(json, "growth", growth_of(&a->growth));
    return run_print_and_free(json);
}
