/* report.c: prints race results. Scene and engine names are plain words, so that JSON needs no
 * escapes. */
#include "report.h"

void report_table_head(FILE *out) {
    fprintf(out, "%-15s %7s  %-8s %8s %8s  %5s %-13s %5s %5s %7s  %15s %15s %13s\n", "", "", "",
            "", "", "ratio", "", "", "", "", "deepest overlap", "mean overlap", "memory");
    fprintf(out, "%-15s %7s  %-8s %8s %8s  %5s %-13s %5s %5s %7s  %15s %15s %13s\n", "scene",
            "bodies", "against", "its ms", "thud ms", "", "(spread)", "p99", "worst", "target",
            "its, thud mm", "its, thud mm", "its, thud MB");
}

static double ratio(double a, double b) {
    return b > 0 ? a / b : 0;
}

static void print_rival(FILE *out, const race_result *r, const race_entry *own,
                        const race_entry *rival) {
    char spread[32];
    snprintf(spread, sizeof spread, "(%.2f-%.2f)", rival->ratio_low, rival->ratio_high);
    char target[32] = "";
    if (r->target > 0 && rival == &r->entries[1])
        snprintf(target, sizeof target, "%.1f %s", r->target,
                 ratio(rival->time.median, own->time.median) >= r->target ? "yes" : "NO");
    fprintf(out,
            "%-15s %7d  %-8s %8.3f %8.3f  %5.2f %-13s %5.2f %5.2f %7s  %7.1f %7.1f %7.2f %7.2f %6.2f "
            "%6.2f\n",
            r->scene, r->bodies, rival->engine, rival->time.median, own->time.median,
            ratio(rival->time.median, own->time.median), spread,
            ratio(rival->time.p99, own->time.p99), ratio(rival->time.max, own->time.max),
            target, rival->overlap.worst * 1e3, own->overlap.worst * 1e3,
            penetration_mean(&rival->overlap) * 1e3, penetration_mean(&own->overlap) * 1e3,
            (double)rival->bytes * 1e-6, (double)own->bytes * 1e-6);
}

void report_table_row(FILE *out, const race_result *r) {
    for (int e = 1; e < r->entry_count; e++)
        print_rival(out, r, &r->entries[0], &r->entries[e]);
    for (int e = 0; e < r->entry_count; e++)
        if (r->entries[e].overlap.lost > 0)
            fprintf(out, "  %s lost %d shapes: their pose is no longer finite\n",
                    r->entries[e].engine, r->entries[e].overlap.lost);
    fflush(out);
}

void report_table_foot(FILE *out, int repetitions) {
    fprintf(out,
            "\nms: the median step. ratio: its ms over thud's, above 1 thud is faster; spread over "
            "%d repetition%s.\nOne thread, both at their defaults; overlap measured by separate "
            "double-precision geometry.\n",
            repetitions, repetitions == 1 ? "" : "s");
}

static void print_object(FILE *out, const race_result *r, const race_entry *entry) {
    fprintf(out,
            "  {\"scene\": \"%s\", \"engine\": \"%s\", \"size\": %d, \"bodies\": %d, "
            "\"steps\": %d, \"target\": %.3g,\n"
            "   \"ms_median\": %.6g, \"ms_p99\": %.6g, \"ms_max\": %.6g,\n"
            "   \"ratio_low\": %.4g, \"ratio_high\": %.4g,\n"
            "   \"penetration_max\": %.6g, \"penetration_mean\": %.6g, \"lost\": %d, "
            "\"bytes\": %llu}",
            r->scene, entry->engine, r->size, r->bodies, r->steps, r->target, entry->time.median,
            entry->time.p99, entry->time.max, entry->ratio_low, entry->ratio_high,
            entry->overlap.worst, penetration_mean(&entry->overlap), entry->overlap.lost,
            (unsigned long long)entry->bytes);
}

bool report_json(FILE *out, const race_result *results, int count) {
    const char *between = "";
    fprintf(out, "[\n");
    for (int i = 0; i < count; i++)
        for (int e = 0; e < results[i].entry_count; e++) {
            fputs(between, out);
            print_object(out, &results[i], &results[i].entries[e]);
            between = ",\n";
        }
    fprintf(out, "\n]\n");
    return fflush(out) == 0 && !ferror(out);
}
