/* script.c: the callbacks of a session. Which calls they make depends on the script's bytes and on
 * the number of callbacks before, so that twins, which get the same callbacks, make the same calls.
 */
#include "calls.h"

/* The script's next byte. */
static unsigned dice(fuzz_session *s) {
    return s->script[s->asked++ % SESSION_SCRIPT];
}

/* Once the callbacks have read more bytes of the script than this, they make no more calls: an
 * input then makes some twenty thousand calls at most, and takes seconds under sanitizers. Chosen.
 */
enum { BYTES_READ_MAX = 20000 };

void session_ask(fuzz_session *s) {
    unsigned turn = s->asked, byte = dice(s);
    if (!s->mood || turn > BYTES_READ_MAX || s->depth + 1 == SESSION_DEPTH ||
        (turn + byte) % (unsigned)s->mood != 0) {
        return;
    }
    fuzz_bytes outer = s->bytes;
    unsigned from = (turn * 5 + byte) % SESSION_SCRIPT;
    s->bytes = (fuzz_bytes){s->script + from, s->script + SESSION_SCRIPT, outer.hostile};
    s->depth++;
    session_play(s);
    s->depth--;
    s->bytes = outer;
}

static void note_contact(fuzz_session *s, const thud_contact *contact) {
    note_bits(s, (uint64_t)contact->shape_a.index1 << 32 | contact->shape_b.index1);
    note_bits(s, (uint64_t)contact->body_a.index1 << 32 | contact->body_b.index1);
    s->calls[s->depth].text = "a callback";
    note_vector(s, contact->normal);
    note_place(s, contact->point);
    note_number(s, (double)contact->separation);
    note_number(s, (double)contact->normal_impulse);
    note_number(s, (double)contact->tangent_impulse);
    note_bits(s, (uint64_t)contact->point_count);
}

static void note_settings(fuzz_session *s, const thud_contact_settings *settings) {
    note_number(s, (double)settings->friction);
    note_number(s, (double)settings->restitution);
    note_number(s, (double)settings->surface_speed);
}

bool session_prologue(thud_world *world, const thud_contact *contact,
                      thud_contact_settings *settings, void *context) {
    fuzz_session *s = context;
    const char *text = s->calls[s->depth].text;
    (void)world;
    note_contact(s, contact);
    note_settings(s, settings);
    unsigned byte = dice(s);
    if (byte % 16 == 1) {
        fuzz_bytes one = {&s->script[byte % SESSION_SCRIPT], s->script + SESSION_SCRIPT,
                          s->bytes.hostile};
        settings->friction = next_float(&one, 0, 0.05);
        settings->restitution = next_float(&one, 0, 0.03);
        settings->surface_speed = next_float(&one, -8, 0.125) * (float)s->unit;
    }
    const thud_contact *outer = s->question;
    s->question = contact;
    session_ask(s);
    s->question = outer;
    s->calls[s->depth].text = text;
    return byte % 16 != 2;
}

void session_epilogue(thud_world *world, const thud_contact *contact, void *context) {
    fuzz_session *s = context;
    const char *text = s->calls[s->depth].text;
    (void)world;
    note_contact(s, contact);
    session_ask(s);
    s->calls[s->depth].text = text;
}

void session_object_epilogue(thud_world *world, const thud_contact *contact, int side,
                             void *context) {
    thud_body_id body = side ? contact->body_b : contact->body_a;
    if (!thud_body_is_valid(world, body)) {
        fuzz_fail(context, "an epilogue of body %u, which is gone", body.index1);
    }
    note_bits(context, (uint64_t)side);
    session_epilogue(world, contact, context);
}

void session_prologue_all(thud_world *world, const thud_contact *contacts,
                          thud_contact_answer *answers, int count, void *context) {
    for (int i = 0; i < count; i++) {
        if (!answers[i].collide) {
            fuzz_fail(context, "answer %d of %d begins with no", i, count);
        }
        answers[i].collide = session_prologue(world, &contacts[i], &answers[i].settings, context);
    }
}

void session_epilogue_all(thud_world *world, const thud_contact *contacts, int count,
                          void *context) {
    for (int i = 0; i < count; i++) {
        session_epilogue(world, &contacts[i], context);
    }
}

bool session_overlap(thud_shape_id shape, void *context) {
    fuzz_session *s = context;
    note_bits(s, shape.index1);
    if (!thud_shape_is_valid(s->world, shape) && !s->destroyed_inside) {
        fuzz_fail(s, "an overlap with shape %u, which is gone", shape.index1);
    }
    session_ask(s);
    return dice(s) % 16 != 3;
}

double session_cast(const thud_ray_hit *hit, void *context) {
    fuzz_session *s = context;
    note_bits(s, hit->shape.index1);
    note_number(s, hit->fraction);
    if (!thud_shape_is_valid(s->world, hit->shape)) {
        fuzz_fail(s, "a cast meets shape %u, which is gone", hit->shape.index1);
    }
    session_ask(s);
    const double answers[] = {THUD_CAST_ON, THUD_CAST_IGNORE, hit->fraction, 0.75, THUD_CAST_END};
    unsigned byte = dice(s);
    return byte == 255 && s->bytes.hostile ? NAN : answers[byte % 16 < 5 ? byte % 16 : 0];
}

bool session_pass(const thud_mover *mover, const thud_mover_hit *hit, thud_vec2 velocity,
                  void *context) {
    fuzz_session *s = context;
    thud_one_way way = {.categories = 1, .drop = s->script[2] & 1};
    /* The hit is in double precision, which a shift rounds. A move that runs out of memory may have
     * called this before, and calls it again when it is repeated. */
    if (s->twin != TWIN_SHIFT && s->twin != TWIN_MEMORY) {
        note_bits(s, hit->shape.index1);
        note_vector(s, hit->normal);
        session_ask(s);
    }
    return s->script[3] & 1 && COUNTED(thud_mover_passes_one_way(mover, hit, velocity, &way));
}
