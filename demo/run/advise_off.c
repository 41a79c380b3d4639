/* advise_off.c: see advise_off.h. */
#include "advise_off.h"

#include "choices.h"
#include "load.h"

#include <math.h>
#include <stdio.h>

/* The furthest that a body ended from where it ended in the other run; infinite where a body is in
 * one run only. */
static double furthest(const advise_setting *a, const advise_setting *b, const scene *s) {
    double most = 0;
    for (int i = 0; i < s->body_count; i++) {
        bool in_a = !isnan(a->ends[i].x), in_b = !isnan(b->ends[i].x);
        if (in_a && in_b)
            most = fmax(most, hypot(a->ends[i].x - b->ends[i].x, a->ends[i].y - b->ends[i].y));
        else if (in_a != in_b)
            most = INFINITY;
    }
    return most / s->length_scale;
}

/* Runs without the part, which the options of *off's setting leave out already. `with`: what is
 * linked with it. */
static bool measure(advise_off *off, const advise_setting *base, const advise_link *with,
                    const scene *whole) {
    scene s;
    if (!run_load(&off->setting.how, &s))
        return false;
    bool done = true;
    for (int i = 0; i < base->runs && done; i++)
        done = advise_run(&off->setting, &s);
    if (done) {
        off->moved = furthest(base, &off->setting, whole);
        off->same = off->setting.outcome.hash == base->outcome.hash;
        off->needless = off->setting.error <= base->how.max_error &&
                        (off->same || off->moved <= base->how.max_error);
        off->link = advise_link_of(&off->setting.how, &s);
    }
    scene_free(&s);
    double bytes = (double)base->outcome.stats.bytes;
    off->saves = off->setting.ms * ADVISE_EQUAL < base->ms ||
                 (double)off->setting.outcome.stats.bytes < 0.99 * bytes ||
                 (off->link.program && with->program && off->link.kilobytes < with->kilobytes);
    return done;
}

static bool try_without(advise_offs *out, const char *name, run_options how,
                        const advise_setting *base, const scene *s) {
    advise_off *off = &out->offs[out->count++];
    *off = (advise_off){.name = name, .setting = {.how = how}};
    return measure(off, base, &out->link, s);
}

bool advise_switch_off(const advise_series *series, const scene *s, advise_offs *out) {
    *out = (advise_offs){.base = series->advised >= 0 ? series->advised : series->nearest};
    const advise_setting *base = &series->settings[out->base];
    out->link = advise_link_of(&base->how, s);
    unsigned parts = without_possible(s) & ~base->how.without;
    if (!QUALITIES[base->how.quality]->islands &&
        DETECTIONS[base->how.detection].detection != &thud_detection_bisect &&
        DETECTIONS[base->how.detection].detection != &thud_detection_swept)
        parts &= ~(unsigned)WITHOUT_DIRECT;
    if (base->how.no_sleeping)
        parts &= ~(unsigned)WITHOUT_SLEEP;
    for (int i = 0; i < WITHOUT_PARTS; i++) {
        run_options how = base->how;
        how.without |= 1u << i;
        advise_progress("leaving out", i + 1, ADVISE_OFFS_MAX);
        if (parts & 1u << i && !try_without(out, without_name(i), how, base, s))
            return false;
    }
    run_options how = base->how;
    while (DETECTIONS[how.detection].detection != &thud_detection_overlap)
        how.detection = (how.detection + 1) % DETECTION_CHOICES;
    return how.detection == base->how.detection || try_without(out, "detection", how, base, s);
}

void advise_offs_free(advise_offs *offs) {
    for (int i = 0; i < offs->count; i++)
        advise_setting_free(&offs->offs[i].setting);
}
