/* far_away.c: the extreme "far-away": the same scene at the origin and shifted by whole length
 * units. thud stores positions relative to cells of one unit, so both must be equal bit for bit. */
#include "scenes.h"
#include "extremes/stack.h"

#include <math.h>
#include <string.h>

/* The difference between a run far away and the same run at the origin. */
typedef struct difference {
    double bodies; /* bodies with a different bit in pose or velocity; infinite if one is lost */
    double deeper; /* difference of the largest penetration at the end */
} difference;

static trial *run_scene(ledger *l, entrant e, const scene *s, double x, double y) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (t) {
        trial_look_from(t, x, y);
        trial_steps(t, l->quick ? 60 : 600);
    }
    return t;
}

static difference compare(trial *a, trial *b, int body_count) {
    const engine_body *bodies_a = trial_read(a), *bodies_b = trial_read(b);
    difference d = {0, 0};
    for (int i = 0; i < body_count; i++) {
        float pose_a[4], pose_b[4];
        trial_pose(a, i, pose_a);
        trial_pose(b, i, pose_b);
        d.bodies += memcmp(pose_a, pose_b, sizeof pose_a) != 0 ||
                    bodies_a[i].vx != bodies_b[i].vx || bodies_a[i].vy != bodies_b[i].vy ||
                    bodies_a[i].angular_velocity != bodies_b[i].angular_velocity;
    }
    if (!isfinite(trial_speed(b)))
        d.bodies = INFINITY;
    penetration seen_a = {0}, seen_b = {0};
    trial_penetration(a, &seen_a);
    trial_penetration(b, &seen_b);
    d.deeper = fabs(seen_b.worst - seen_a.worst);
    return d;
}

static difference far_from_near(ledger *l, entrant e, const scene_info *info, int size,
                                double away) {
    scene near, far;
    if (!scenes_fill(info, size, &near) || !scenes_fill(info, size, &far)) {
        l->failed = true;
        return (difference){NAN, NAN};
    }
    scene_shift(&far, away, -away);
    trial *a = run_scene(l, e, &near, 0, 0);
    trial *b = run_scene(l, e, &far, away, -away);
    difference d = a && b ? compare(a, b, near.body_count) : (difference){NAN, NAN};
    trial_end(a);
    trial_end(b);
    scene_free(&near);
    scene_free(&far);
    return d;
}

static void run(ledger *l) {
    static const struct {
        const scene_info *info;
        int size;
    } SCENES[] = {{&scene_pyramid, 10},
                  {&scene_circle_pit, 200},
                  {&scene_mixed_terrain, 200},
                  {&scene_bullets, 0},
                  {&scene_heavy_on_light, 5}};
    static const double AWAY[] = {1e3, 1e5, 1e7};
    enum { SCENE_COUNT = 5, PLACES = 3 };
    for (int i = 0; i < SCENE_COUNT; i++) {
        for (int place = 0; place < PLACES; place++) {
            /* One scene suffices to see the distance at which Box2D becomes inaccurate. */
            if (place + 1 < PLACES && (l->quick || i > 0))
                continue;
            const char *name = SCENES[i].info->name;
            int power = (int)round(log10(AWAY[place]));
            figure *differ = ledger_add(l, bound_at_most(0, ON_THUD),
                                        "%s 10^%d away: bodies that differ in a bit", name, power);
            figure *deeper = ledger_add(l, bound_at_most(1e-6, ON_THUD),
                                        "%s 10^%d away: change of worst penetration", name, power);
            for (entrant e = 0; e < ENTRANTS; e++) {
                ledger_progress(l, differ->what,
                                (double)(i * PLACES + place) / (SCENE_COUNT * PLACES));
                if (!ledger_has(l, e))
                    continue;
                difference d = far_from_near(l, e, SCENES[i].info, SCENES[i].size, AWAY[place]);
                figure_tell(differ, e, d.bodies);
                figure_tell(deeper, e, d.deeper);
            }
        }
    }
}

const extreme extreme_far_away = {
    .name = "far-away",
    .title = "Far from the origin",
    .about = "Scenes run for 10 s at the origin, and so many units, a box's width each, to the "
             "right of it and below.",
    .run = run,
};
