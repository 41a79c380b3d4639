/* events.c: guarantees of begin, end and hit events of contacts, and of sensor events. */
#include "guarantee.h"
#include "yard.h"

enum { SHAPES_MAX = 96 };

/* ---- ledger of pairs ---- */

/* The pairs that have begun and not ended, by the slots of their shapes. */
typedef struct books {
    bool open[SHAPES_MAX][SHAPES_MAX];
    int begun;
} books;

/* The pair's entry in the ledger. */
static bool *entry(trial *t, books *b, const thud_contact_event *e) {
    if (e->shape_a.index1 >= SHAPES_MAX || e->shape_b.index1 >= SHAPES_MAX) {
        trial_fault(t, "no shape has the slots %u, %u", e->shape_a.index1, e->shape_b.index1);
        return &b->open[0][0];
    }
    return &b->open[e->shape_a.index1][e->shape_b.index1];
}

/* Whether the list has an event of the same two shapes. */
static bool listed(const thud_contact_event *e, const thud_contact_event *list, int count) {
    int i = 0;
    while (i < count && memcmp(e, &list[i], sizeof *e) != 0) {
        i++;
    }
    return i < count;
}

/* Enters a step's events into the ledger, and reports ends without a begin and second begins. A
 * pair that is in both lists has ended and begun again if it was open, otherwise begun and ended.
 */
static void book(trial *t, books *b, const thud_contact_event *begin, int begins,
                 const thud_contact_event *end, int ends) {
    for (int i = 0; i < ends; i++) {
        bool *open = entry(t, b, &end[i]), again = listed(&end[i], begin, begins);
        if (!*open && !again) {
            trial_fault(t, "shapes %u and %u end and had not begun", end[i].shape_a.index1,
                        end[i].shape_b.index1);
        }
        *open = *open && again;
    }
    for (int i = 0; i < begins; i++) {
        bool *open = entry(t, b, &begin[i]), ended = listed(&begin[i], end, ends);
        if (*open && !ended) {
            trial_fault(t, "shapes %u and %u begin twice", begin[i].shape_a.index1,
                        begin[i].shape_b.index1);
        }
        *open = *open ? true : !ended;
        b->begun++;
    }
}

/* The number of open pairs. */
static int open_in(const books *b) {
    int count = 0;
    for (int i = 0; i < SHAPES_MAX * SHAPES_MAX; i++) {
        count += b->open[i / SHAPES_MAX][i % SHAPES_MAX];
    }
    return count;
}

/* Runs until five pairs have begun, between 1.5 and 6 seconds; then all bodies are destroyed, so
 * that the last step has to end every pair. */
static void each_begin_has_one_end(trial *t) {
    books *touch = calloc(2, sizeof *touch), *sensed = touch + 1;
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    int least = trial_steps(t, 1.5), most = trial_steps(t, 6);
    for (int i = 0, last = most; i <= last && touch && !trial_failed(t); i++) {
        if (i >= least && touch->begun >= 5) {
            last = i;
        }
        for (int k = 0; k < YARD_BODIES && i == last; k++) {
            DO(t, thud_body_destroy(y.world, y.body[k]));
        }
        trial_run(t, y.world, 1);
        thud_events e = thud_events_of(y.world);
        book(t, touch, e.begin, e.begin_count, e.end, e.end_count);
        book(t, sensed, e.sensor_begin, e.sensor_begin_count, e.sensor_end, e.sensor_end_count);
        if (i < last) {
            yard_before_step(&y);
        }
    }
    if (touch && !trial_failed(t) && (touch->begun < 5 || open_in(touch) || open_in(sensed))) {
        trial_fault(t, "of %d pairs %d, and of sensors %d, never ended", touch->begun,
                    open_in(touch), open_in(sensed));
    }
    free(touch);
}

/* ---- one fall ---- */

/* A body that falls on a floor has one begin event and one hit event, at the speed of the fall, and
 * no end event while it settles. */
static void a_fall_begins_and_hits_once(trial *t) {
    int begins = 0, ends = 0, hits = 0;
    double speed = 0, fall = sqrt(2 * 10 * 1.0), slower = 10 * t->step;
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 5, 1);
    thud_body_id body = trial_drop(t, world, trial_pick(t, 2) ? BALL : UPRIGHT, 0, 1.3, 0.3);
    for (int i = 0; i < trial_steps(t, 1.5) && !trial_failed(t); i++) {
        trial_run(t, world, 1);
        thud_events e = thud_events_of(world);
        begins += e.begin_count;
        ends += e.end_count;
        for (int k = 0; k < e.hit_count; k++) {
            hits++;
            speed = (double)e.hit[k].speed / t->scale;
        }
    }
    if (begins != 1 || ends != 0 || hits != 1 || fabs(speed - fall) > slower + 0.05 * fall) {
        trial_fault(t, "%d begins, %d ends, %d hits, the last at %g of %g", begins, ends, hits,
                    speed, fall);
    }
    DO(t, thud_body_destroy(world, body));
    trial_run(t, world, 1);
    if (thud_events_of(world).end_count != 1) {
        trial_fault(t, "no end when the body went");
    }
}

static void without_contact_events_sensors_report(trial *t) {
    thud_world_def def = trial_def(t);
    thud_shape_def sensor = thud_default_shape_def();
    int sensed = 0;
    yard y;
    def.contact_events = false;
    yard_make(&y, t, def, 0);
    sensor.sensor = true;
    trial_add(t, y.world, (part){.form = UPRIGHT, .y = 3, .hx = 4, .hy = 2, .shape = &sensor});
    for (int i = 0; i < trial_steps(t, 0.5) && !trial_failed(t); i++) {
        yard_step(&y);
        thud_events e = thud_events_of(y.world);
        sensed += e.sensor_begin_count;
        if (e.begin_count || e.end_count || e.hit_count) {
            trial_fault(t, "%d begins, %d ends, %d hits", e.begin_count, e.end_count, e.hit_count);
        }
    }
    if (sensed == 0) {
        trial_fault(t, "no sensor reported anything");
    }
}

/* ---- sensors ---- */

enum { WATCHED = 9 };

typedef struct watch {
    thud_world *world;
    thud_body_id body[WATCHED];
    thud_shape_id shape[WATCHED];
    bool sensor[WATCHED], open[WATCHED][WATCHED];
    bool passive[WATCHED]; /* its body is static */
} watch;

static void add_watched(trial *t, watch *w) {
    for (int i = 0; i < WATCHED; i++) {
        static const thud_body_kind kinds[] = {THUD_BODY_DYNAMIC, THUD_BODY_KINEMATIC,
                                               THUD_BODY_STATIC};
        thud_shape_def def = thud_default_shape_def();
        thud_body_kind kind = kinds[i % 3];
        bool moves = kind != THUD_BODY_STATIC;
        w->sensor[i] = def.sensor = i < 5;
        w->passive[i] = !moves;
        w->body[i] = trial_add(t, w->world,
                               (part){.kind = kind,
                                      .form = (form)trial_pick(t, FORMS),
                                      .x = trial_draw(t, -2, 2),
                                      .y = trial_draw(t, -2, 2),
                                      .hx = trial_draw(t, 0.3, 0.9),
                                      .hy = trial_draw(t, 0.3, 0.9),
                                      .vx = moves ? trial_draw(t, -3, 3) : 0,
                                      .vy = moves ? trial_draw(t, -3, 3) : 0,
                                      .shape = &def});
        w->shape[i] = trial_shape(t, w->world, w->body[i]);
    }
}

static int number_of(const watch *w, thud_shape_id shape) {
    int i = 0;
    while (i < WATCHED && w->shape[i].index1 != shape.index1) {
        i++;
    }
    return i;
}

/* Enters the step's sensor events into `open`. */
static void note_sensors(trial *t, watch *w) {
    thud_events e = thud_events_of(w->world);
    for (int i = 0; i < e.sensor_end_count + e.sensor_begin_count; i++) {
        bool begins = i >= e.sensor_end_count;
        const thud_contact_event *pair =
            begins ? &e.sensor_begin[i - e.sensor_end_count] : &e.sensor_end[i];
        int a = number_of(w, pair->shape_a), b = number_of(w, pair->shape_b);
        if (a == WATCHED || b == WATCHED || !w->sensor[a]) {
            trial_fault(t, "shape %u is no sensor", pair->shape_a.index1);
        } else {
            w->open[a][b] =
                !w->open[a][b]; /* a pair in both lists has the state that it had before */
        }
    }
}

/* Sensor events agree with the geometry of the poses at the end of the step, except for pairs that
 * are closer to touching than rounding errors. */
static void sensors_report_all_they_overlap(trial *t) {
    watch w = {.world = trial_make(t, trial_weightless(t))};
    thud_geometry stood[WATCHED];
    if (!w.world) {
        return;
    }
    add_watched(t, &w);
    for (int k = 0; k < trial_steps(t, 0.6) && !trial_failed(t); k++) {
        if (k % 7 == 3) {
            DO(t, thud_body_set_transform(w.world, w.body[trial_pick(t, WATCHED)],
                                          trial_place(t, trial_draw(t, -2, 2), 0), 0));
        }
        trial_run(t, w.world, 1);
        for (int i = 0; i < WATCHED; i++) {
            stood[i] = trial_placed(t, w.world, w.body[i]);
        }
        note_sensors(t, &w);
        for (int i = 0; i < WATCHED * WATCHED && !trial_failed(t); i++) {
            int a = i / WATCHED, b = i % WATCHED;
            thud_closest c = {.distance = 1};
            if (a == b || !w.sensor[a] || (w.passive[a] && w.passive[b])) {
                continue;
            }
            DO(t, thud_geometry_closest(&stood[a], &stood[b], &c));
            if (w.open[a][b] != (c.distance < 0) && fabs(c.distance) > 3e-4) {
                trial_fault(t, "step %d: sensor %d and shape %d, %g apart: %s", k, a, b, c.distance,
                            w.open[a][b] ? "reported" : "not reported");
            }
        }
    }
}

/* A ball flies through a sensor that is thinner than its motion in a step, and is reported in that
 * step with its time; `continuous` does so for static sensors only. */
static void sensors_report_what_passes(trial *t) {
    thud_shape_def sensor = thud_default_shape_def();
    thud_world *world = trial_make(t, trial_weightless(t));
    if (!world) {
        return;
    }
    bool moves = t->set->value[DETECTION] != CONTINUOUS && trial_pick(t, 2);
    double way = trial_draw(t, 4, 6), from = trial_draw(t, -3, -1);
    double in = (-0.15 - from) / way, out = (0.15 - from) / way;
    sensor.sensor = true;
    trial_add(t, world,
              (part){.kind = moves ? THUD_BODY_DYNAMIC : THUD_BODY_STATIC,
                     .form = UPRIGHT,
                     .hx = 0.05,
                     .hy = 2,
                     .shape = &sensor});
    trial_add(t, world,
              (part){.kind = THUD_BODY_DYNAMIC,
                     .form = BALL,
                     .x = from,
                     .hx = 0.1,
                     .hy = 0.1,
                     .vx = way / t->step});
    trial_run(t, world, 1);
    thud_events e = thud_events_of(world);
    if (e.sensor_begin_count != 1 || e.sensor_end_count != 1) {
        trial_fault(t, "%d begins, %d ends", e.sensor_begin_count, e.sensor_end_count);
    } else if (fabs((double)e.sensor_begin_time[0] - in) > 1e-3 ||
               fabs((double)e.sensor_end_time[0] - out) > 1e-3) {
        trial_fault(t, "from %g to %g, not from %g to %g", (double)e.sensor_begin_time[0],
                    (double)e.sensor_end_time[0], in, out);
    }
}

static void sensors_stop_nothing(trial *t) {
    thud_shape_def sensor = thud_default_shape_def();
    sensor.sensor = true;
    thud_world *world = trial_make(t, trial_def(t)), *empty = trial_make(t, trial_def(t));
    if (!world || !empty) {
        return;
    }
    form kind = (form)trial_pick(t, FORMS);
    thud_body_id body = trial_drop(t, world, kind, 0, 3, 0.3);
    thud_body_id free_body = trial_drop(t, empty, kind, 0, 3, 0.3);
    trial_add(t, world,
              (part){.form = UPRIGHT, .x = 0, .y = 1, .hx = 1, .hy = 0.2, .shape = &sensor});
    trial_add(t, world,
              (part){.kind = THUD_BODY_DYNAMIC,
                     .form = TURNED,
                     .x = 0.2,
                     .y = 1.5,
                     .hx = 0.5,
                     .hy = 0.5,
                     .shape = &sensor});
    int seen = 0;
    for (int k = 0; k < trial_steps(t, 1.0) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        trial_run(t, empty, 1);
        seen += thud_events_of(world).sensor_begin_count;
    }
    double at = trial_state(t, world, body).position.y;
    double wanted = trial_state(t, empty, free_body).position.y;
    if (fabs(at - wanted) > 1e-6 || seen == 0) {
        trial_fault(t, "it fell to %g, not %g, and was seen %d times", at, wanted, seen);
    }
}

const guarantee guarantees_of_events[] = {
    GUARANTEE(a_fall_begins_and_hits_once),
    GUARANTEE(each_begin_has_one_end),
    GUARANTEE(sensors_report_all_they_overlap),
    GUARANTEE_EXCEPT(sensors_report_what_passes,
                     {DETECTION, BIT(OVERLAP), "it looks where shapes stand, and nowhere else"}),
    GUARANTEE(sensors_stop_nothing),
    GUARANTEE(without_contact_events_sensors_report),
    {.name = NULL},
};
