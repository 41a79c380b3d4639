/* report.c: see report.h. */
#include "report.h"

#include "verdict.h"

void report_table_head(FILE *out) {
    fprintf(out, "%-14s %6s  %-7s %8s %8s  %6s %-13s %6s %6s  %15s %13s %13s  %s\n", "", "", "", "",
            "", "ratio", "", "ratio", "ratio", "deepest overlap", "mean overlap", "memory",
            "at least,");
    fprintf(out, "%-14s %6s  %-7s %8s %8s  %6s %-13s %6s %6s  %15s %13s %13s  %s\n", "scene",
            "bodies", "against", "its ms", "thud ms", "median", "(spread)", "p99", "worst",
            "its, thud mm", "its, thud mm", "its, thud MB", "verdict");
}

static double ratio(double a, double b) {
    return b > 0 ? a / b : 0;
}

static void print_promise(FILE *out, const race_result *r) {
    char text[64];
    verdict_text(r, text, sizeof text);
    if (r->target > 0 && *text)
        fprintf(out, "%.1f ", r->target);
    if (r->limit_ms > 0 && *text)
        fprintf(out, "worst %.1f ms of %.0f ", r->entries[0].time.max, r->limit_ms);
    fputs(text, out);
}

static void print_rival(FILE *out, const race_result *r, const race_entry *rival) {
    const race_entry *own = &r->entries[0];
    char spread[32];
    snprintf(spread, sizeof spread, "(%.2f-%.2f)", rival->ratio_low, rival->ratio_high);
    fprintf(out,
            "%-14s %6d  %-7s %8.3f %8.3f  %6.2f %-13s %6.2f %6.2f  %7.1f %7.1f %6.2f %6.2f %6.2f "
            "%6.2f  ",
            r->scene, r->bodies, rival->engine, rival->time.median, own->time.median,
            ratio(rival->time.median, own->time.median), spread,
            ratio(rival->time.p99, own->time.p99), ratio(rival->time.max, own->time.max),
            rival->overlap.worst * 1e3, own->overlap.worst * 1e3,
            penetration_mean(&rival->overlap) * 1e3, penetration_mean(&own->overlap) * 1e3,
            (double)rival->bytes * 1e-6, (double)own->bytes * 1e-6);
    if (rival == verdict_rival(r))
        print_promise(out, r);
    fputc('\n', out);
}

/* Prints a line about gaps, for scenes with joints. */
static void print_gaps(FILE *out, const race_result *r, const race_entry *rival) {
    const joint_gaps *own = &r->entries[0].gaps, *its = &rival->gaps;
    if (own->joints > 0)
        fprintf(out, "  widest joint %.1f mm in %s, %.1f in thud; mean %.3f and %.3f\n",
                its->worst.length * 1e3, rival->engine, own->worst.length * 1e3,
                joint_gaps_mean(its) * 1e3, joint_gaps_mean(own) * 1e3);
}

void report_table_row(FILE *out, const race_result *r) {
    for (int e = 1; e < r->entry_count; e++) {
        print_rival(out, r, &r->entries[e]);
        print_gaps(out, r, &r->entries[e]);
    }
    for (int e = 0; e < r->entry_count; e++)
        if (r->entries[e].overlap.lost > 0)
            fprintf(out, "  %s lost %d shapes: their pose is no longer finite\n",
                    r->entries[e].engine, r->entries[e].overlap.lost);
    fflush(out);
}

void report_table_foot(FILE *out, int repetitions) {
    fprintf(
        out,
        "\nms: the median step. ratio: its time over thud's, above 1 thud is faster; (spread)\n"
        "of the median over %d repetition%s. One thread, every engine at its defaults; overlap\n"
        "measured by separate double-precision geometry. A scene holds when median, p99 and\n"
        "worst step all reach what is asked of it against Box2D, with no deeper overlap and no\n"
        "wider joints.\n",
        repetitions, repetitions == 1 ? "" : "s");
}

static void write_entry(json *out, const race_entry *entry) {
    json_begin_object(out, NULL);
    json_text(out, "engine", entry->engine);
    json_number(out, "ms_median", entry->time.median);
    json_number(out, "ms_p99", entry->time.p99);
    json_number(out, "ms_max", entry->time.max);
    json_number(out, "ratio_low", entry->ratio_low);
    json_number(out, "ratio_high", entry->ratio_high);
    json_number(out, "penetration_max", entry->overlap.worst);
    json_number(out, "penetration_mean", penetration_mean(&entry->overlap));
    json_number(out, "gap_max", entry->gaps.worst.length);
    json_number(out, "gap_mean", joint_gaps_mean(&entry->gaps));
    json_number(out, "lost", entry->overlap.lost);
    json_number(out, "bytes", (double)entry->bytes);
    json_end(out);
}

void report_json(json *out, const race_result *r) {
    char text[64];
    verdict_text(r, text, sizeof text);
    json_begin_object(out, NULL);
    json_text(out, "scene", r->scene);
    json_number(out, "size", r->size);
    json_number(out, "bodies", r->bodies);
    json_number(out, "steps", r->steps);
    json_number(out, "target", r->target);
    json_number(out, "limit_ms", r->limit_ms);
    json_text(out, "verdict", text);
    json_begin_array(out, "engines");
    for (int e = 0; e < r->entry_count; e++)
        write_entry(out, &r->entries[e]);
    json_end(out);
    json_end(out);
}
