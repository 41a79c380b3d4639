/* canvas.c: see canvas.h. A convex outline is drawn as concentric rings of vertices around a filled
 * inside. */
#include "draw/canvas.h"

#include "draw/palette.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    VERTEX_ROOM = 1 << 16, /* max number of vertices in a batch */
    INDEX_ROOM = 3 << 16,  /* max number of indices in a batch */
    OUTLINE_MAX = 64,      /* max number of points of an outline */
    RINGS = 3              /* rings of an outline, see add_convex */
};

bool canvas_init(canvas *c, SDL_Renderer *renderer, float unit) {
    *c = (canvas){.renderer = renderer};
    c->vertices = malloc(VERTEX_ROOM * sizeof *c->vertices);
    c->indices = malloc(INDEX_ROOM * sizeof *c->indices);
    if (!c->vertices || !c->indices) {
        canvas_free(c);
        SDL_SetError("out of memory");
        return false;
    }
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    if (canvas_resize(c, unit))
        return true;
    canvas_free(c);
    return false;
}

void canvas_free(canvas *c) {
    font_free(&c->text);
    free(c->vertices);
    free(c->indices);
    *c = (canvas){0};
}

bool canvas_resize(canvas *c, float unit) {
    if (SDL_GetRendererOutputSize(c->renderer, &c->width, &c->height) != 0)
        return false;
    if (unit == c->unit)
        return true;
    font replacement;
    if (!font_init(&replacement, c->renderer, unit))
        return false;
    font_free(&c->text);
    c->text = replacement;
    c->unit = unit;
    return true;
}

void canvas_flush(canvas *c) {
    if (c->index_count > 0)
        SDL_RenderGeometry(c->renderer, NULL, c->vertices, c->vertex_count, c->indices,
                           c->index_count);
    c->vertex_count = c->index_count = 0;
}

/* Makes room for vertices and indices, by a flush if necessary. Returns the index of the next
 * vertex. */
static int reserve(canvas *c, int vertices, int indices) {
    if (c->vertex_count + vertices > VERTEX_ROOM || c->index_count + indices > INDEX_ROOM)
        canvas_flush(c);
    return c->vertex_count;
}

static void add_vertex(canvas *c, float x, float y, SDL_Color color) {
    c->vertices[c->vertex_count++] = (SDL_Vertex){{x, y}, color, {0, 0}};
}

static void add_triangle(canvas *c, int i, int j, int k) {
    c->indices[c->index_count++] = i;
    c->indices[c->index_count++] = j;
    c->indices[c->index_count++] = k;
}

void canvas_quad(canvas *c, const SDL_FPoint corners[4], const SDL_Color colors[4]) {
    int first = reserve(c, 4, 6);
    for (int i = 0; i < 4; i++)
        add_vertex(c, corners[i].x, corners[i].y, colors[i]);
    add_triangle(c, first, first + 1, first + 2);
    add_triangle(c, first, first + 2, first + 3);
}

/* Edges are rounded to whole pixels, so that adjacent rectangles neither overlap nor leave a gap:
 * the software renderer rounds a rectangle's position and its size separately. */
void canvas_rect(canvas *c, SDL_FRect r, SDL_Color top, SDL_Color bottom) {
    float left = roundf(r.x), right = roundf(r.x + r.w);
    float upper = roundf(r.y), lower = roundf(r.y + r.h);
    SDL_FPoint corners[4] = {{left, upper}, {right, upper}, {right, lower}, {left, lower}};
    SDL_Color colors[4] = {top, top, bottom, bottom};
    canvas_quad(c, corners, colors);
}

/* Adds a convex outline p; `out` is for each point the displacement that moves it outwards by a
 * pixel. `half` is the smallest half width of the inside, which limits how far rings go inwards.
 * The rings are half a pixel outside of the outline, where it is transparent; half a pixel inside,
 * in the edge colour; and there plus the border, in the fill colour. */
static void add_convex(canvas *c, const SDL_FPoint *p, const SDL_FPoint *out, int n, float half,
                       canvas_style style) {
    float inset = fminf(0.5f, half);
    float inner = fminf(0.5f + style.border, half);
    const float offsets[RINGS] = {0.5f, -inset, -inner};
    const SDL_Color colors[RINGS] = {color_fade(style.edge, 0), style.edge, style.fill};
    int first = reserve(c, RINGS * n + 1, 3 * (2 * (RINGS - 1) * n + n));
    for (int ring = 0; ring < RINGS; ring++)
        for (int i = 0; i < n; i++)
            add_vertex(c, p[i].x + out[i].x * offsets[ring], p[i].y + out[i].y * offsets[ring],
                       colors[ring]);
    add_vertex(c, 0.5f * (p[0].x + p[n / 2].x), 0.5f * (p[0].y + p[n / 2].y), style.fill);
    for (int ring = 0; ring + 1 < RINGS; ring++)
        for (int i = 0; i < n; i++) {
            int a = first + ring * n + i;
            int b = first + ring * n + (i + 1) % n;
            add_triangle(c, a, b, b + n);
            add_triangle(c, a, b + n, a + n);
        }
    /* A fan about the centre. SDL's software renderer draws two triangles that form a rectangle as
     * such, rounded differently from the rings. */
    int inside = first + (RINGS - 1) * n;
    for (int i = 0; i < n; i++)
        add_triangle(c, inside + n, inside + i, inside + (i + 1) % n);
}

/* Number of points for which a circle's chords deviate by at most 0.1 pixels from it: the sagitta
 * is r (1 - cos(pi / n)). */
static int circle_points(float radius) {
    int n = (int)ceilf(3.14159265f / sqrtf(0.2f / fmaxf(radius, 1)));
    return n < 8 ? 8 : n > OUTLINE_MAX ? OUTLINE_MAX : n;
}

void canvas_ring(canvas *c, SDL_FPoint center, float radius, float width, SDL_Color color) {
    int n = circle_points(radius);
    SDL_FPoint last = {center.x + radius, center.y};
    for (int i = 1; i <= n; i++) {
        float angle = 6.2831853f * (float)i / (float)n;
        SDL_FPoint next = {center.x + radius * cosf(angle), center.y + radius * sinf(angle)};
        canvas_line(c, last, next, width, color);
        last = next;
    }
}

void canvas_circle(canvas *c, SDL_FPoint center, float radius, canvas_style style) {
    int n = circle_points(radius);
    SDL_FPoint points[OUTLINE_MAX], out[OUTLINE_MAX];
    for (int i = 0; i < n; i++) {
        float angle = 6.2831853f * (float)i / (float)n;
        out[i] = (SDL_FPoint){cosf(angle), sinf(angle)};
        points[i] = (SDL_FPoint){center.x + radius * out[i].x, center.y + radius * out[i].y};
    }
    add_convex(c, points, out, n, radius, style);
}

void canvas_box(canvas *c, SDL_FPoint center, SDL_FPoint axis, SDL_FPoint half,
                canvas_style style) {
    static const float sign_x[4] = {-1, 1, 1, -1}, sign_y[4] = {-1, -1, 1, 1};
    SDL_FPoint points[4], out[4];
    for (int i = 0; i < 4; i++) {
        out[i].x = sign_x[i] * axis.x - sign_y[i] * axis.y;
        out[i].y = sign_x[i] * axis.y + sign_y[i] * axis.x;
        points[i].x = center.x + sign_x[i] * half.x * axis.x - sign_y[i] * half.y * axis.y;
        points[i].y = center.y + sign_x[i] * half.x * axis.y + sign_y[i] * half.y * axis.x;
    }
    add_convex(c, points, out, 4, fminf(half.x, half.y), style);
}

void canvas_round_rect(canvas *c, SDL_FRect r, float radius, canvas_style style) {
    enum { PER_CORNER = 6 };
    static const float corner_x[4] = {1, 0, 0, 1}, corner_y[4] = {1, 1, 0, 0};
    SDL_FPoint points[4 * PER_CORNER], out[4 * PER_CORNER];
    radius = fminf(radius, 0.5f * fminf(r.w, r.h));
    for (int i = 0; i < 4 * PER_CORNER; i++) {
        int corner = i / PER_CORNER;
        float angle = 1.5707963f * ((float)corner + (float)(i % PER_CORNER) / (PER_CORNER - 1));
        float x = r.x + radius + corner_x[corner] * (r.w - 2 * radius);
        float y = r.y + radius + corner_y[corner] * (r.h - 2 * radius);
        out[i] = (SDL_FPoint){cosf(angle), sinf(angle)};
        points[i] = (SDL_FPoint){x + radius * out[i].x, y + radius * out[i].y};
    }
    add_convex(c, points, out, 4 * PER_CORNER, 0.5f * fminf(r.w, r.h), style);
}

void canvas_line(canvas *c, SDL_FPoint a, SDL_FPoint b, float width, SDL_Color color) {
    float dx = b.x - a.x, dy = b.y - a.y;
    float length = hypotf(dx, dy);
    SDL_FPoint axis = {length > 0 ? dx / length : 1, length > 0 ? dy / length : 0};
    SDL_FPoint center = {0.5f * (a.x + b.x), 0.5f * (a.y + b.y)};
    SDL_FPoint half = {0.5f * (length + width), 0.5f * width};
    canvas_box(c, center, axis, half, (canvas_style){color, color, 0});
}

float canvas_text(canvas *c, float x, float y, SDL_Color color, const char *text) {
    canvas_flush(c);
    return font_draw(&c->text, c->renderer, x, y, color, text, strlen(text));
}

void canvas_text_fit(canvas *c, float x, float y, float width, SDL_Color color, const char *text) {
    size_t length = strlen(text);
    canvas_flush(c);
    if (font_width(&c->text, text, length) > width) {
        float dots = font_width(&c->text, "..", 2);
        while (length > 0 && font_width(&c->text, text, length) + dots > width)
            length--;
        x += font_draw(&c->text, c->renderer, x, y, color, text, length);
        text = "..";
        length = 2;
    }
    font_draw(&c->text, c->renderer, x, y, color, text, length);
}
