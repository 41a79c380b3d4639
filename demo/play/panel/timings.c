/* timings.c: see timings.h. */
#include "panel/timings.h"

#include "draw/palette.h"

#include <math.h>
#include <stdio.h>

void timings_clear(timings *t) {
    t->count = t->next = 0;
}

void timings_add(timings *t, const thud_stats *stats) {
    for (int i = 0; i < THUD_STAGE_COUNT; i++)
        t->seconds[t->next][i] = (float)stats->stage_seconds[i];
    t->next = (t->next + 1) % TIMINGS_KEPT;
    if (t->count < TIMINGS_KEPT)
        t->count++;
}

/* The step of this age; 0: the last. */
static const float *step_at(const timings *t, int age) {
    return t->seconds[(t->next - 1 - age + 2 * TIMINGS_KEPT) % TIMINGS_KEPT];
}

/* The time at the top of the graph, s: the next 1, 2 or 5 times a power of ten above the slowest
 * step. */
static float full_scale(const timings *t) {
    float slowest = 1e-5f; /* s: min of the scale */
    for (int age = 0; age < t->count; age++) {
        float sum = 0;
        for (int i = 0; i < THUD_STAGE_COUNT; i++)
            sum += step_at(t, age)[i];
        slowest = fmaxf(slowest, sum);
    }
    float power = powf(10, floorf(log10f(slowest)));
    float digits = slowest / power;
    return power * (digits <= 1 ? 1.0f : digits <= 2 ? 2.0f : digits <= 5 ? 5.0f : 10.0f);
}

static const SDL_Color colors[] = COLOR_STAGES;
_Static_assert(sizeof colors / sizeof colors[0] == THUD_STAGE_COUNT, "a colour for each stage");

static void draw_graph(const timings *t, canvas *c, SDL_FRect area, float scale) {
    float column = area.w / TIMINGS_KEPT;
    for (int age = 0; age < t->count; age++) {
        float y = area.y + area.h;
        for (int i = 0; i < THUD_STAGE_COUNT; i++) {
            float height = step_at(t, age)[i] / scale * area.h;
            SDL_FRect bar = {area.x + area.w - (float)(age + 1) * column, y - height, column,
                             height};
            canvas_rect(c, bar, colors[i], colors[i]);
            y -= height;
        }
    }
}

/* The legend: mean milliseconds of each stage over the last 30 steps, in two columns. */
static void draw_legend(const timings *t, canvas *c, SDL_FRect area, float row) {
    enum { ROWS = (THUD_STAGE_COUNT + 1) / 2, MEAN_OF = 30 };
    int count = t->count < MEAN_OF ? t->count : MEAN_OF;
    for (int i = 0; i < THUD_STAGE_COUNT; i++) {
        float sum = 0;
        for (int age = 0; age < count; age++)
            sum += step_at(t, age)[i];
        char label[32];
        snprintf(label, sizeof label, "%.2f", count > 0 ? (double)(sum / (float)count) * 1e3 : 0);
        float x = area.x + (float)(i / ROWS) * 0.52f * area.w;
        float y = area.y + row * (float)(i % ROWS + 1);
        float box = 8 * c->unit;
        canvas_rect(c, (SDL_FRect){x, y - box, box, box}, colors[i], colors[i]);
        canvas_text(c, x + 1.6f * box, y, COLOR_TEXT_DIM, thud_stage_name((thud_stage)i));
        float width = font_width(&c->text, label, 4);
        canvas_text(c, x + 0.46f * area.w - width, y, COLOR_TEXT, label);
    }
}

void timings_draw(const timings *t, canvas *c, float footer) {
    float u = c->unit;
    float pad = 12 * u, row = 17 * u, graph = 84 * u;
    float legend = row * (float)((THUD_STAGE_COUNT + 1) / 2) + 6 * u;
    SDL_FRect box = {(float)c->width - 312 * u, (float)c->height - footer - graph - legend - 62 * u,
                     300 * u, graph + legend + 50 * u};
    canvas_round_rect(c, box, 6 * u, (canvas_style){COLOR_SHADE, COLOR_SHADE, 0});
    float scale = full_scale(t);
    char title[64];
    snprintf(title, sizeof title, "Stages of a step; full height %g ms", (double)scale * 1e3);
    canvas_text(c, box.x + pad, box.y + 20 * u, COLOR_TEXT, title);
    SDL_FRect area = {box.x + pad, box.y + 30 * u, box.w - 2 * pad, graph};
    canvas_rect(c, area, COLOR_SKY_TOP, COLOR_SKY_TOP);
    draw_graph(t, c, area, scale);
    draw_legend(t, c, (SDL_FRect){area.x, area.y + graph + 5 * u, area.w, legend}, row);
}
