/* advise_picture.c: the error of each setting over the time of its step, as SVG. Both axes are
 * logarithmic; an error below ERROR_MIN stands at the lower edge, and a setting at which bodies
 * pass through what stands at the upper one. */
#include "advise.h"

#include <math.h>
#include <stdio.h>

/* Pixels: the picture, and the margins around the plot. */
enum { WIDTH = 900, HEIGHT = 580, LEFT = 90, RIGHT = 270, TOP = 60, BOTTOM = 60 };

static const double ERROR_MIN = 1e-6;

/* Ends of both axes, as powers of ten. */
typedef struct axes {
    int x0, x1, y0, y1;
} axes;

static double shown_error(const advise_setting *setting, const axes *at) {
    return isinf(setting->error) ? pow(10, at->y1) : fmax(setting->error, ERROR_MIN);
}

static axes find_axes(const advise_series *series, double max_error) {
    double x0 = INFINITY, x1 = 0, y1 = fmax(10 * max_error, 10 * ERROR_MIN);
    for (int i = 0; i < series->count; i++) {
        x0 = fmin(x0, series->settings[i].ms);
        x1 = fmax(x1, series->settings[i].ms);
        if (isfinite(series->settings[i].error))
            y1 = fmax(y1, 10 * series->settings[i].error);
    }
    x0 = fmax(x0, 1e-6); /* a clock that does not resolve a step says 0 */
    axes at = {(int)floor(log10(x0)), (int)ceil(log10(fmax(x1, x0) * 1.01)),
               (int)round(log10(ERROR_MIN)), (int)ceil(log10(y1))};
    return at;
}

static double x_of(const axes *at, double ms) {
    return LEFT + (WIDTH - LEFT - RIGHT) * (log10(fmax(ms, 1e-6)) - at->x0) / (at->x1 - at->x0);
}

static double y_of(const axes *at, double error) {
    return HEIGHT - BOTTOM -
           (HEIGHT - TOP - BOTTOM) * (log10(fmax(error, ERROR_MIN)) - at->y0) / (at->y1 - at->y0);
}

static void draw_text(FILE *file, double x, double y, const char *anchor, const char *colour,
                      const char *text) {
    fprintf(file, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">", x, y, anchor,
            colour);
    for (const char *c = text; *c; c++)
        if (*c == '<' || *c == '&')
            fputs(*c == '<' ? "&lt;" : "&amp;", file);
        else
            fputc(*c, file);
    fputs("</text>\n", file);
}

static void draw_line(FILE *file, double x1, double y1, double x2, double y2, const char *style) {
    fprintf(file, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" %s/>\n", x1, y1, x2, y2,
            style);
}

static void draw_axes(FILE *file, const axes *at) {
    static const char PALE[] = "stroke=\"#e4e4e4\"";
    char text[32];
    for (int k = at->x0; k <= at->x1; k++) {
        double x = x_of(at, pow(10, k));
        draw_line(file, x, TOP, x, HEIGHT - BOTTOM, PALE);
        snprintf(text, sizeof text, "%g", pow(10, k));
        draw_text(file, x, HEIGHT - BOTTOM + 20, "middle", "#6b6b6b", text);
    }
    for (int k = at->y0; k <= at->y1; k++) {
        double y = y_of(at, pow(10, k));
        draw_line(file, LEFT, y, WIDTH - RIGHT, y, PALE);
        snprintf(text, sizeof text, k == at->y0 ? "none" : "%g", pow(10, k));
        draw_text(file, LEFT - 8, y + 5, "end", "#6b6b6b", text);
    }
    draw_text(file, 0.5 * (LEFT + WIDTH - RIGHT), HEIGHT - 14, "middle", "#202020",
              "milliseconds of a step");
}

/* Places of the numbers that are drawn. */
typedef struct labels {
    double x[ADVISE_SETTINGS_MAX], y[ADVISE_SETTINGS_MAX];
    int count;
} labels;

/* Keeps a place for a number near (x, y), beyond those that are in its way: above them, or, at the
 * upper edge, below. */
static double place_label(labels *l, double x, double y) {
    bool down = y < TOP + 1;
    y += down ? 16 : -3;
    for (bool moved = true; moved;) {
        moved = false;
        for (int i = 0; i < l->count; i++)
            if (fabs(l->x[i] - x) < 17 && fabs(l->y[i] - y) < 13) {
                y = l->y[i] + (down ? 13 : -13);
                moved = true;
            }
    }
    l->x[l->count] = x;
    l->y[l->count++] = y;
    return y;
}

/* Draws a setting as a point with its number, and a line of the key with its name. */
static void draw_setting(FILE *file, const advise_series *series, int index, const axes *at,
                         labels *placed) {
    const advise_setting *setting = &series->settings[index];
    bool advised = index == series->advised;
    double x = x_of(at, setting->ms), y = y_of(at, shown_error(setting, at));
    const char *colour = advised ? "#c4541c" : advise_meets(setting) ? "#00734d" : "#6b6b6b";
    char name[ADVISE_NAME_MAX], text[16 + ADVISE_NAME_MAX];
    advise_name(&setting->how, name);
    fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%d\" fill=\"%s\"%s>", x, y, advised ? 8 : 4,
            colour, advised ? " id=\"advised\"" : "");
    fprintf(file, "<title>%s: %.4g ms, %s %.4g</title></circle>\n", name, setting->ms,
            isinf(setting->error) ? "passed" : "error",
            isinf(setting->error) ? (double)setting->outcome.passed : setting->error);
    snprintf(text, sizeof text, "%d", index + 1);
    double label_x = x + (advised ? 9 : 5);
    draw_text(file, label_x, place_label(placed, label_x, y), "start", colour, text);
    snprintf(text, sizeof text, "%d %s", index + 1, name);
    draw_text(file, WIDTH - RIGHT + 20, TOP + 4 + 15 * index, "start", colour, text);
}

static void draw_all(FILE *file, const advice *a) {
    axes at = find_axes(&a->series, a->options->max_error);
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" "
            "font-family=\"sans-serif\" font-size=\"13\">\n"
            "<rect width=\"%d\" height=\"%d\" fill=\"white\"/>\n",
            WIDTH, HEIGHT, WIDTH, HEIGHT);
    draw_text(file, LEFT, 28, "start", "#202020", a->scene->name);
    draw_text(file, LEFT, 48, "start", "#6b6b6b",
              "Error in length scales over the time of a step; orange: advised, green: meets the "
              "error, upper edge: bodies pass through");
    draw_axes(file, &at);
    double y = y_of(&at, a->options->max_error);
    draw_line(file, LEFT, y, WIDTH - RIGHT, y, "stroke=\"#c4541c\" stroke-dasharray=\"6 4\"");
    if (isfinite(a->options->budget)) {
        double x = fmin(fmax(x_of(&at, a->options->budget), LEFT), WIDTH - RIGHT);
        draw_line(file, x, TOP, x, HEIGHT - BOTTOM, "stroke=\"#c4541c\" stroke-dasharray=\"6 4\"");
    }
    labels placed = {.count = 0};
    for (int i = 0; i < a->series.count; i++)
        draw_setting(file, &a->series, i, &at, &placed);
    fputs("</svg>\n", file);
}

bool advise_draw(const advice *a, const char *path) {
    FILE *file = fopen(path, "w");
    if (file)
        draw_all(file, a);
    bool written = file && !ferror(file);
    if (file && fclose(file) != 0)
        written = false;
    if (!written)
        fprintf(stderr, "thud-run: %s cannot be written\n", path);
    return written;
}
