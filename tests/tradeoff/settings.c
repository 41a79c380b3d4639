/* settings.c: the settings that are compared. thud runs at each of its qualities with everything
 * else at its default; with the soft solver alone at several numbers of substeps; and at qualities
 * default and high with swept detection (draft is the same as default then, and exact is swept by
 * itself).
 *
 * Chipmunk 7 runs with its default of 10 iterations and with more.
 *
 * Box2D v3.2 runs with 1 to 16 substeps, with its default contact stiffness and with one that is
 * scaled with the substeps. Its step (b2World_Step) limits b2WorldDef.contactHertz to an eighth of
 * the substep rate, and uses twice that against static bodies. The default is 30 Hz: at 60 steps
 * per second it is lowered to 7.5 and 15 Hz at one and two substeps, is equal to the limit at four,
 * and is below it at more. Scaled means the limit, 7.5 Hz per substep: up to four substeps this is
 * the same as the default, so that these three settings are run once and belong to both curves.
 * Scaled joints are as stiff as Box2D allows too, a quarter of the substep rate with a damping
 * ratio of 10; the defaults are 60 Hz and 2. Bodies for which a scene asks for swept detection are
 * bullets in Box2D, which it stops at moving shapes too. Its maximum speed, 400 m/s by default, is
 * raised: a body that is limited to it would have an error of speed that the case does not ask
 * about. */
#include "settings.h"

/* thud with the soft solver alone (island_limit 1), for comparison with Box2D's, which is soft at
 * all settings. */
#define SOFT(n)                                                                                  \
    {                                                                                            \
        .engine = &engine_thud, .name = "soft " #n, .curve = "thud soft",                        \
        .with.quality = &(const thud_quality) {                                                  \
            .name = "soft " #n, .substeps = n, .contact_stiffness = 0.16f,                       \
            .contact_damping = 10.0f, .detection = &thud_detection_continuous, .island_limit = 1 \
        }                                                                                        \
    }

#define BOX2D(n, suffix, hertz)                                                        \
    {                                                                                  \
        .engine = &engine_box2d, .name = #n suffix, .curve = "box2d" suffix, .with = { \
            .substeps = n,                                                             \
            .contact_hertz = hertz,                                                    \
            .joint_hertz = (hertz) > 30 ? 2 * (hertz) : 0,                             \
            .joint_damping = (hertz) > 30 ? 10 : 0,                                    \
            .bullets = true                                                            \
        }                                                                              \
    }

#define CHIPMUNK(n)                                                                             \
    {                                                                                           \
        .engine = &engine_chipmunk, .name = #n, .curve = "chipmunk", .with = {.iterations = n } \
    }

const setting SETTINGS[] = {
    {&engine_thud, "draft", "thud", {.quality = &thud_quality_draft}},
    {&engine_thud, "default", "thud", {.quality = &thud_quality_default}},
    {&engine_thud, "high", "thud", {.quality = &thud_quality_high}},
    {&engine_thud, "exact", "thud", {.quality = &thud_quality_exact}},
    SOFT(4),
    SOFT(8),
    SOFT(16),
    {&engine_thud,
     "default swept",
     "thud swept",
     {.quality = &thud_quality_default, .detection = &thud_detection_swept}},
    {&engine_thud,
     "high swept",
     "thud swept",
     {.quality = &thud_quality_high, .detection = &thud_detection_swept}},
#ifdef THUD_BOX2D_BUILD
    BOX2D(1, "", 30),
    BOX2D(2, "", 30),
    BOX2D(4, "", 30),
    BOX2D(8, "", 30),
    BOX2D(16, "", 30),
    BOX2D(8, " stiff", 8 * 7.5),
    BOX2D(16, " stiff", 16 * 7.5),
#endif
#ifdef THUD_CHIPMUNK_BUILD
    CHIPMUNK(10),
    CHIPMUNK(40),
    CHIPMUNK(160),
#endif
};
const int SETTING_COUNT = sizeof SETTINGS / sizeof SETTINGS[0];

bool setting_goes_through(const setting *how, const scene *s) {
    return !how->engine->only_by_name || (s->joint_count > 0 && engine_can_build(how->engine, s));
}

_Static_assert(sizeof SETTINGS / sizeof SETTINGS[0] <= SETTINGS_MAX, "SETTINGS_MAX");
