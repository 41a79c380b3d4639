/* uses_print.c: prints what a scene has and what a run of it used. */
#include "uses.h"

#include <cjson/cJSON.h>
#include <inttypes.h>
#include <stdio.h>

static const char *const SHAPES[USES_SHAPE_KINDS] = {"circles", "aabbs", "obbs", "terrains"};
static const char *const JOINTS[USES_JOINT_KINDS] = {"distance", "hinge",  "slider", "weld",
                                                     "wheel",    "target", "filter", "gear"};

void uses_print_text(const uses *u) {
    printf("It has %d dynamic, %d kinematic and %d static bodies;", u->dynamic_bodies,
           u->kinematic_bodies, u->static_bodies);
    for (int i = 0; i < USES_SHAPE_KINDS; i++)
        printf("%s %d %s", i ? "," : "", u->shapes[i], SHAPES[i]);
    printf("; %d sensors; %d joints", u->sensors, u->joint_count);
    for (int i = 0, any = 0; i < USES_JOINT_KINDS; i++)
        if (u->joints[i] > 0)
            printf("%s %s %d", any++ ? "," : ":", JOINTS[i], u->joints[i]);
    printf("; %d explosions, %d rules%s%s%s.\n", u->blasts, u->rules, u->water ? ", water" : "",
           u->wind ? ", wind" : "", u->breaking ? ", boxes that break" : "");
    printf("Of the dynamic bodies %d turned (%d with a box), %d bounced, %d slid, %d had friction, "
           "%d slept.\n",
           u->turned, u->turned_boxes, u->bounced, u->slid, u->rubbed, u->slept);
    printf("Continuous detection held bodies back %ld times, in %ld steps; bisect or swept "
           "resolved %ld impacts.\n",
           u->held, u->held_steps, u->impacts);
    printf("Direct islands solved %ld of %ld contacts, in %ld steps (a contact counts in each "
           "step).\n",
           u->direct_contacts, u->contacts, u->direct_steps);
    printf("At most %d bodies stood on top of each other; masses of bodies that touched or were "
           "joined differed by up to %.3g times; the fastest moved %.3g of the thinnest shape's "
           "thickness in a step.\n",
           u->stack, u->mass_ratio, u->speed);
}

cJSON *uses_json(const uses *u, uint64_t hash) {
    cJSON *json = cJSON_CreateObject();
    const struct {
        const char *name;
        double value;
    } numbers[] = {{"dynamic_bodies", u->dynamic_bodies},
                   {"kinematic_bodies", u->kinematic_bodies},
                   {"static_bodies", u->static_bodies},
                   {"sensors", u->sensors},
                   {"joints", u->joint_count},
                   {"explosions", u->blasts},
                   {"rules", u->rules},
                   {"turned", u->turned},
                   {"turned_boxes", u->turned_boxes},
                   {"bounced", u->bounced},
                   {"slid", u->slid},
                   {"rubbed", u->rubbed},
                   {"slept", u->slept},
                   {"held", (double)u->held},
                   {"held_steps", (double)u->held_steps},
                   {"impacts", (double)u->impacts},
                   {"contacts", (double)u->contacts},
                   {"direct_contacts", (double)u->direct_contacts},
                   {"direct_steps", (double)u->direct_steps},
                   {"stack", u->stack},
                   {"mass_ratio", u->mass_ratio},
                   {"speed", u->speed}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        cJSON_AddNumberToObject(json, numbers[i].name, numbers[i].value);
    for (int i = 0; i < USES_SHAPE_KINDS; i++)
        cJSON_AddNumberToObject(json, SHAPES[i], u->shapes[i]);
    cJSON *joints = cJSON_AddObjectToObject(json, "joints_by_kind");
    for (int i = 0; i < USES_JOINT_KINDS; i++)
        cJSON_AddNumberToObject(joints, JOINTS[i], u->joints[i]);
    cJSON_AddBoolToObject(json, "water", u->water);
    cJSON_AddBoolToObject(json, "wind", u->wind);
    cJSON_AddBoolToObject(json, "breaking", u->breaking);
    char text[17];
    snprintf(text, sizeof text, "%016" PRIx64, hash);
    cJSON_AddStringToObject(json, "hash", text);
    return json;
}
