/* terrain_foot.c: places a horizontal sole, such as a character's foot, on a terrain. */
#include "terrain/terrain.h"

#include "thud/thud_terrain.h"

/* Moves the foot to x if the ground is higher there, or equally high and nearer to the sole's
 * middle. */
static void try_place(thud_foot *foot, double middle, double x, double height) {
    if (height > foot->height ||
        (height == foot->height && td_abs(x - middle) < td_abs(foot->x - middle))) {
        foot->height = height;
        foot->x = x;
    }
}

thud_result thud_terrain_place_foot(const thud_terrain *t, double x, double width, thud_foot *out) {
    thud_result readable = td_terrain_readable(t);
    if (readable != THUD_OK || !out) {
        return readable != THUD_OK ? readable : THUD_ERROR_NULL;
    }
    double left = x - 0.5 * width, right = x + 0.5 * width;
    if (!td_finite(left) || !td_finite(right) || !(width >= 0.0)) {
        return THUD_ERROR_INVALID;
    }
    bool endless = t->kind == THUD_TERRAIN_FLAT;
    if (!endless) {
        double first = td_terrain_x(t, 0), last = td_terrain_x(t, t->count - 1);
        left = left < first ? first : left;
        right = right > last ? last : right;
    }
    thud_terrain_sample l, r, under;
    if (left > right || thud_terrain_sample_at(t, left, &l) != THUD_OK ||
        thud_terrain_sample_at(t, right, &r) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    double middle = td_clamp(x, left, right);
    thud_terrain_sample_at(t, middle, &under);
    thud_foot foot = {.height = under.height, .x = middle, .nx = under.nx, .ny = under.ny};
    try_place(&foot, x, left, l.height);
    try_place(&foot, x, right, r.height);
    for (int i = l.segment + 1; i <= r.segment && !endless; i++) {
        try_place(&foot, x, td_terrain_x(t, i), t->points[i].y);
    }
    double dx = right - left, dy = r.height - l.height;
    double length = __builtin_sqrt(dx * dx + dy * dy);
    if (l.segment != r.segment && length > 0.0) {
        foot.nx = -dy / length;
        foot.ny = dx / length;
    }
    *out = foot;
    return THUD_OK;
}
