/* seam_find.c: which faces of static shapes have something static at them. */
#include "contact.h"
#include "lanes.h"
#include "seam.h"
#include "seams.h"
#include "shape.h"
#include "terrain.h"

static void note(thud_world *w, int shape, uint8_t seams)
{
    td_shape *s = td_shape_at(w, shape);
    if ((s->seams | seams) == s->seams) {
        return;
    }
    s->seams |= seams;
    int e = td_body_at(w, s->body)->first_contact;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_contact *contact = td_contact_at(w, e / 2);
        if (contact->state == TD_TOUCHING && contact->shape_a == shape) {
            td_block *block = td_block_at(w, contact->kind, contact->slot / TD_LANES);
            block->seams[contact->slot % TD_LANES] = s->seams;
        }
    }
}

/* A strip just outside a face, short of its ends. */
static thud_placed strip_of(const thud_placed *box, int face, double width)
{
    thud_placed strip = *box;
    double along = face % 2 ? box->hx : box->hy, out = (face % 2 ? box->hy : box->hx) + 0.5 * width;
    double u = face % 2 ? 0.0 : out, v = face % 2 ? out : 0.0, x, y;
    td_from_frame(box, face >= 2 ? -u : u, face >= 2 ? -v : v, &x, &y);
    strip.x += x;
    strip.y += y;
    along = along > 2.0 * width ? along - width : 0.5 * along;
    strip.hx = face % 2 ? along : 0.5 * width;
    strip.hy = face % 2 ? 0.5 * width : along;
    return strip;
}

static uint8_t faces_at(const td_seam *s, const thud_placed *box, const thud_placed *other,
                        int other_shape)
{
    uint8_t faces = 0;
    for (int f = 0; f < TD_FACES; f++) {
        thud_placed strip = strip_of(box, f, TD_FLUSH * s->unit);
        bool covered;
        if (other->kind == THUD_TERRAIN) {
            thud_terrain terrain = td_terrain_view(s->w, other_shape);
            strip.x -= other->x;
            strip.y -= other->y;
            covered = thud_terrain_overlap(&terrain, &strip);
        } else {
            covered = thud_shapes_overlap(other, &strip);
        }
        faces |= (uint8_t)(covered << f);
    }
    return faces;
}

/* A line's end is sealed where a neighbour reaches up to it from outside. */
static uint8_t ends_at(const td_seam *s, int terrain_shape, int neighbour)
{
    thud_terrain t = td_terrain_view(s->w, terrain_shape);
    thud_placed at = td_shape_placed(s->w, terrain_shape, s->origin);
    double out = TD_FLUSH * s->unit;
    if (t.kind == THUD_TERRAIN_FLAT) {
        return 0;
    }
    double right = td_terrain_x(&t, t.count - 1), left = td_terrain_x(&t, 0);
    bool at_right = td_seam_holds(s, neighbour, at.x + right + out, at.y + t.points[t.count - 1].y - out, out);
    bool at_left = td_seam_holds(s, neighbour, at.x + left - out, at.y + t.points[0].y - out, out);
    return (uint8_t)(at_right << TD_FACE_RIGHT | at_left << TD_FACE_LEFT);
}

static bool note_pair(const td_seam *s, int neighbour, void *context)
{
    (void)context;
    thud_placed n = td_shape_placed(s->w, neighbour, s->origin);
    bool box = s->a.kind == THUD_AABB || s->a.kind == THUD_OBB;
    bool other_box = n.kind == THUD_AABB || n.kind == THUD_OBB;
    if (box) {
        note(s->w, s->shape, faces_at(s, &s->a, &n, neighbour));
    }
    if (other_box) {
        note(s->w, neighbour, faces_at(s, &n, &s->a, s->shape));
    }
    if (s->a.kind == THUD_TERRAIN) {
        note(s->w, s->shape, ends_at(s, s->shape, neighbour));
    }
    if (n.kind == THUD_TERRAIN) {
        note(s->w, neighbour, ends_at(s, neighbour, s->shape));
    }
    return false;
}

/* Boxes are found by a terrain that came as well: all of them, since lines are few. */
bool td_seams_find(thud_world *w, int shape)
{
    if (!td_is_ground(w, shape)) {
        return true;
    }
    td_seam s = td_seam_of(w, shape, TD_NONE);
    if (s.a.kind == THUD_TERRAIN) {
        for (int i = 0; i < w->rest_shapes.ids.count; i++) {
            int n = *(int *)td_at(&w->rest_shapes.ids, i);
            if (td_is_ground(w, n)) {
                note_pair(&s, n, NULL);
            }
        }
    }
    if (!td_array_reserve(&w->memory, &w->scratch.hits, 3 * w->rest_shapes.ids.count + 4 * TD_LANES)) {
        return false;
    }
    td_seam_any(&s, note_pair, NULL);
    return true;
}
