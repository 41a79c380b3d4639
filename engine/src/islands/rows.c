/* rows.c: see rows.h. */
#include "islands/rows.h"

void td_row_set(td_direct_row *row, td_row_kind kind, double x, double y, double cross_a,
                double cross_b) {
    *row =
        (td_direct_row){.kind = kind, .a = {-x, -y, -cross_a}, .b = {x, y, cross_b}, .used = true};
}
