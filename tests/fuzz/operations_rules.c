/* operations_rules.c: rules between four categories of shapes, the caller's pair filter, and
 * impulse events, which rules ask for. The effect of a rule on contacts enters the digest with the
 * next step. */
#include "operations.h"

/* See session.h. */
void session_take_filter(fuzz_session *s, thud_world *world) {
    if (s->filters) {
        COUNTED(thud_world_set_filter(world, session_filter, s));
    }
}

/* Excludes one in seven pairs, by the slots of their shapes. */
bool session_filter(const thud_world *world, thud_shape_id a, thud_shape_id b, void *context) {
    (void)world, (void)context;
    return (a.index1 + b.index1) % 7 != 3;
}

void play_rule(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    int a = byte & 3, b = byte >> 2 & 3;
    bool none = byte >> 6 == 3;
    thud_rule rule = thud_default_rule();
    rule.kind = (thud_rule_kind)next_choice(&s->bytes, 4);
    unsigned wanted = next_byte(&s->bytes);
    rule.solid_side = wanted & 1 ? pick_velocity(s) : rule.solid_side;
    rule.friction = wanted & 2 ? next_float(&s->bytes, 0, 0.0078125) : rule.friction;
    rule.restitution = wanted & 4 ? next_float(&s->bytes, 0, 0.0078125) : rule.restitution;
    rule.surface_speed = wanted & 8 ? pick_speed(s) : rule.surface_speed;
    rule.event_impulse = wanted & 16 ? next_float(&s->bytes, 0, 0.03125) : rule.event_impulse;
    TRY(s, thud_world_set_rule(s->world, 1u << a, 1u << b, none ? NULL : &rule));
    if (s->result == THUD_OK) {
        s->now.ruled[b][a] = false;
        s->now.ruled[a][b] = !none;
        s->now.rules[a][b] = rule;
    }
}

void play_rule_get(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    int a = byte & 3, b = byte >> 2 & 3;
    thud_rule rule;
    bool set = false, reversed = false;
    TRY(s, thud_world_get_rule(s->world, 1u << a, 1u << b, &rule, &set, &reversed));
    bool there = s->now.ruled[a][b] || s->now.ruled[b][a];
    if (s->result != THUD_OK || set != there || reversed != (there && !s->now.ruled[a][b])) {
        fuzz_fail(s, "rule of %d and %d: %d, %d", a, b, set, reversed);
    }
    note_bits(s, (uint64_t)rule.kind);
}

void play_filter(fuzz_session *s) {
    bool filters = next_byte(&s->bytes) & 1;
    TRY(s, thud_world_set_filter(s->world, filters ? session_filter : NULL, s));
    s->filters = s->result == THUD_OK ? filters : s->filters;
}

void play_impulses(fuzz_session *s) {
    int count = -1;
    const thud_impulse_event *events = COUNTED(thud_impulse_events_of(s->world, &count));
    for (int i = 0; i < count; i++) {
        if (!(events[i].impulse > 0.0f)) {
            fuzz_fail(s, "impulse %g is told", (double)events[i].impulse);
        }
    }
    note_bits(s, (uint64_t)count);
}
