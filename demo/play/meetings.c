/* meetings.c: lets a user choose the collision rule of two kinds of a scene; see session.h. */
#include "session.h"

#include <thud/thud_rules.h>

#include <stdio.h>

/* Last: the calls of this file are recorded. */
#include <thud/thud_recorded.h>

/* The category bit of a kind, counted from 0. */
static uint32_t kind(int index) {
    return 2u << index;
}

/* How the chosen pair of kinds interacts now. */
static thud_rule_kind meeting_of(const session *s) {
    thud_rule rule;
    thud_result result =
        thud_world_get_rule(s->world, kind(s->pair[0]), kind(s->pair[1]), &rule, NULL, NULL);
    return result == THUD_OK ? rule.kind : THUD_RULE_COLLIDE;
}

static void tell(session *s, thud_rule_kind meeting) {
    static const char *const words[] = {"collide", "ignore each other", "meet one way"};
    snprintf(s->message, sizeof s->message, "Kinds %d and %d %s.", s->pair[0] + 1, s->pair[1] + 1,
             words[meeting]);
}

void session_next_pair(session *s) {
    if (!s->world || s->scene.kinds == 0)
        return;
    if (++s->pair[1] == s->scene.kinds) {
        s->pair[0] = (s->pair[0] + 1) % s->scene.kinds;
        s->pair[1] = s->pair[0];
    }
    tell(s, meeting_of(s));
}

/* Removes the rules of these kinds from the scene's timetable, which would replace the user's. */
static void forget_rules(scene_fields *fields, uint32_t first, uint32_t second) {
    int kept = 0;
    for (int i = 0; i < fields->rule_count; i++)
        if (fields->rules[i].first != first || fields->rules[i].second != second)
            fields->rules[kept++] = fields->rules[i];
    fields->rule_count = kept;
}

void session_next_meeting(session *s) {
    if (!s->world || s->scene.kinds == 0)
        return;
    uint32_t first = kind(s->pair[0]), second = kind(s->pair[1]);
    int choices = first == second ? THUD_RULE_ONE_WAY : THUD_RULE_KIND_COUNT;
    thud_rule_kind next = (thud_rule_kind)((meeting_of(s) + 1) % choices);
    forget_rules(&s->scene.fields, first, second);
    scene_add_rule(&s->scene, first, second, (scene_rule_kind)next);
    tell(s, next);
}
