/* solve.c: solves the contact problem of solve.h by a primal-dual active set method on all
 * contacts, which is a semismooth Newton method for the contact laws; if it converges the result is
 * exact up to rounding. It guesses which contacts are open, stick or slip, solves the linear system
 * of the guess (in slip the tangent impulse is proportional to the normal one, so that the matrix
 * is not symmetric), and derives the next guess from the result (Alart and Curnier 1991,
 * Hintermueller et al. 2002). With friction the method may cycle; then Gauss-Seidel sweeps and
 * random changes of the guess continue it. */
#include "sim/solve.h"

#include "random.h"
#include "sim/solve_rows.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NEWTON_STEPS = 40, ROUNDS = 8, FIRST_SWEEPS = 20, CORRECTIONS = 2 };

/* Redundant contacts make the matrix W singular. This share of its diagonal is added to make it
 * regular, and distributes a load evenly. Each solve is corrected by its residual, so that accuracy
 * does not suffer. */
static const double REGULAR = 1e-12;

/* Speeds below this share of the fastest contact speed of the problem count as zero. */
static const double ROUNDING = 1e-11;

struct contact_solver {
    int body_count, capacity;
    int *list_start; /* start of each dynamic body's contacts in `list`, with one more entry at the
                        end */
    int *list;
    int *row; /* first row of a contact in the matrix; -1 if it is open */
    contact_block *blocks;
    contact *kept; /* a copy of all contacts */
    double *x;
    motion *free_motion, *work;
    skyline matrix;
};

contact_solver *contact_solver_create(int body_count) {
    contact_solver *s = calloc(1, sizeof *s);
    if (!s)
        return NULL;
    size_t bodies = (size_t)body_count + 1;
    s->body_count = body_count;
    s->list_start = calloc(bodies + 1, sizeof *s->list_start);
    s->free_motion = calloc(bodies, sizeof *s->free_motion);
    s->work = calloc(bodies, sizeof *s->work);
    if (s->list_start && s->free_motion && s->work)
        return s;
    contact_solver_destroy(s);
    return NULL;
}

void contact_solver_destroy(contact_solver *s) {
    if (!s)
        return;
    skyline_free(&s->matrix);
    free(s->list_start);
    free(s->list);
    free(s->row);
    free(s->blocks);
    free(s->kept);
    free(s->x);
    free(s->free_motion);
    free(s->work);
    free(s);
}

static bool make_room(contact_solver *s, int count) {
    if (count <= s->capacity)
        return true;
    int capacity = count + count / 2;
    skyline_free(&s->matrix);
    free(s->list);
    free(s->row);
    free(s->blocks);
    free(s->kept);
    free(s->x);
    s->capacity = 0;
    s->list = malloc(2 * (size_t)capacity * sizeof *s->list);
    s->row = malloc((size_t)capacity * sizeof *s->row);
    s->blocks = malloc((size_t)capacity * sizeof *s->blocks);
    s->kept = malloc((size_t)capacity * sizeof *s->kept);
    s->x = malloc(2 * (size_t)capacity * sizeof *s->x);
    if (!skyline_init(&s->matrix, 2 * capacity) || !s->list || !s->row || !s->blocks || !s->kept ||
        !s->x)
        return false;
    s->capacity = capacity;
    return true;
}

/* Whether a body can move. */
static bool gives_way(inverse_mass m) {
    return m.linear > 0 || m.angular > 0;
}

/* Lists the contacts of each body, by counting sort. */
static void list_contacts(contact_solver *s, const contact *contacts, int count,
                          const inverse_mass *masses) {
    int *start = s->list_start;
    memset(start, 0, ((size_t)s->body_count + 2) * sizeof *start);
    for (int i = 0; i < count; i++) {
        start[contacts[i].body_a + 1] += gives_way(masses[contacts[i].body_a]);
        start[contacts[i].body_b + 1] += gives_way(masses[contacts[i].body_b]);
    }
    for (int b = 0; b <= s->body_count; b++)
        start[b + 1] += start[b];
    for (int i = 0; i < count; i++) {
        int ends[2] = {contacts[i].body_a, contacts[i].body_b};
        for (int e = 0; e < 2; e++)
            if (gives_way(masses[ends[e]]))
                s->list[start[ends[e]]++] = i;
    }
    for (int b = s->body_count; b > 0; b--)
        start[b] = start[b - 1];
    start[0] = 0;
}

static bool sticks(const contact *c) {
    return c->state == CONTACT_STICK;
}

/* Tangent impulse over normal impulse for a contact that slips; 0 if it does not. */
static double slip_ratio(const contact *c) {
    return c->state == CONTACT_SLIP_FORWARD ? contact_slip_ratio(c)
           : c->state == CONTACT_SLIP_BACK  ? -contact_slip_ratio(c)
                                            : 0;
}

/* Numbers the rows of contacts that are not open, and computes the profile. */
static void number_rows(contact_solver *s, const contact *contacts, int count) {
    skyline *a = &s->matrix;
    a->size = 0;
    for (int i = 0; i < count; i++) {
        s->row[i] = contacts[i].state == CONTACT_OPEN ? -1 : a->size;
        a->size += contacts[i].state == CONTACT_OPEN ? 0 : 1 + sticks(&contacts[i]);
    }
    for (int i = 0; i < count; i++) {
        if (s->row[i] < 0)
            continue;
        int first = s->row[i], ends[2] = {contacts[i].body_a, contacts[i].body_b};
        for (int e = 0; e < 2; e++)
            for (int k = s->list_start[ends[e]]; k < s->list_start[ends[e] + 1]; k++) {
                int row = s->row[s->list[k]];
                if (row >= 0) {
                    first = row < first ? row : first;
                    break;
                }
            }
        for (int r = s->row[i]; r <= s->row[i] + sticks(&contacts[i]); r++)
            a->first[r] = first;
    }
    skyline_clear(a);
}

/* Adds the effect of contact `other` on contact `one` through a body that both share. */
static void couple(contact_solver *s, const contact *contacts, int one, int other, int body,
                   inverse_mass mass) {
    const contact *c = &contacts[one], *d = &contacts[other];
    bool c_is_b = c->body_b == body, d_is_b = d->body_b == body;
    double sign = c_is_b == d_is_b ? 1 : -1;
    contact_row rows[2] = {contact_normal_row(c), contact_tangent_row(c)};
    contact_row n = contact_normal_row(d), t = contact_tangent_row(d);
    double ratio = slip_ratio(d);
    for (int r = 0; r <= sticks(c); r++) {
        double turn = c_is_b ? rows[r].turn_b : rows[r].turn_a;
        double by_normal =
            contact_coupling(rows[r], turn, n, d_is_b ? n.turn_b : n.turn_a, mass, sign);
        double by_tangent =
            contact_coupling(rows[r], turn, t, d_is_b ? t.turn_b : t.turn_a, mass, sign);
        skyline_add(&s->matrix, s->row[one] + r, s->row[other], by_normal + ratio * by_tangent);
        if (sticks(d))
            skyline_add(&s->matrix, s->row[one] + r, s->row[other] + 1, by_tangent);
    }
}

/* Fills the matrix of the contacts that are closed. */
static void assemble(contact_solver *s, const contact *contacts, int count,
                     const inverse_mass *masses) {
    number_rows(s, contacts, count);
    for (int b = 0; b < s->body_count; b++)
        for (int j = s->list_start[b]; j < s->list_start[b + 1]; j++)
            for (int k = s->list_start[b]; k < s->list_start[b + 1]; k++)
                if (s->row[s->list[j]] >= 0 && s->row[s->list[k]] >= 0)
                    couple(s, contacts, s->list[j], s->list[k], b, masses[b]);
    for (int i = 0; i < count; i++) {
        if (s->row[i] < 0)
            continue;
        skyline_add(&s->matrix, s->row[i], s->row[i], REGULAR * s->blocks[i].nn);
        if (sticks(&contacts[i]))
            skyline_add(&s->matrix, s->row[i] + 1, s->row[i] + 1, REGULAR * s->blocks[i].tt);
    }
}

/* Adds impulses that bring the speeds of all contacts that are not open to the values that their
 * states require. */
static void correct(contact_solver *s, contact *contacts, int count, const inverse_mass *masses) {
    for (int i = 0; i < count; i++) {
        if (s->row[i] < 0)
            continue;
        s->x[s->row[i]] = -contact_normal_speed(&contacts[i], s->work) - contacts[i].bias;
        if (sticks(&contacts[i]))
            s->x[s->row[i] + 1] = -contact_tangent_speed(&contacts[i], s->work);
    }
    skyline_solve(&s->matrix, s->x);
    for (int i = 0; i < count; i++) {
        contact *c = &contacts[i];
        if (s->row[i] < 0)
            continue;
        double normal = s->x[s->row[i]];
        double tangent = sticks(c) ? s->x[s->row[i] + 1] : slip_ratio(c) * normal;
        c->normal += normal;
        c->tangent += tangent;
        contact_push(c, normal, tangent, masses, s->work);
    }
}

/* Computes the impulses for the present states; `work` becomes the velocities with them. False if
 * the matrix is singular. */
static bool solve_guess(contact_solver *s, contact *contacts, int count,
                        const inverse_mass *masses) {
    assemble(s, contacts, count, masses);
    if (!skyline_factor(&s->matrix))
        return false;
    memcpy(s->work, s->free_motion, (size_t)s->body_count * sizeof *s->work);
    for (int i = 0; i < count; i++)
        contacts[i].normal = contacts[i].tangent = 0;
    for (int i = 0; i < CORRECTIONS; i++)
        correct(s, contacts, count, masses);
    return true;
}

static contact_state next_state(const contact *c, contact_block w, const motion *velocities,
                                double zero) {
    double normal_speed = contact_normal_speed(c, velocities) + c->bias;
    double tangent_speed = contact_tangent_speed(c, velocities);
    if (c->state == CONTACT_OPEN && normal_speed >= -zero)
        return CONTACT_OPEN;
    if (c->state != CONTACT_OPEN && c->normal * w.nn < -zero)
        return CONTACT_OPEN;
    /* For a contact that closes, the direction of slip follows from its own 2x2 block. */
    double normal = c->state == CONTACT_OPEN ? -normal_speed / w.nn : fmax(0, c->normal);
    double tangent = c->tangent - tangent_speed / w.tt, bound = contact_slip_ratio(c) * normal;
    double margin = zero / w.tt;
    bool slipped = c->state == CONTACT_SLIP_FORWARD || c->state == CONTACT_SLIP_BACK;
    /* Within rounding a contact keeps its state. */
    double slack = slipped ? -margin : margin;
    if (tangent > bound + slack)
        return CONTACT_SLIP_FORWARD;
    if (tangent < -bound - slack)
        return CONTACT_SLIP_BACK;
    return CONTACT_STICK;
}

/* Changes contacts to the states that follow from the last solution: all that differ or, with
 * `random`, a random half of them. False if none differs: the guess is confirmed. */
static bool guess_anew(const contact_solver *s, contact *contacts, int count, double zero,
                       scene_random *random) {
    bool changed = false;
    for (int i = 0; i < count; i++) {
        contact_state next = next_state(&contacts[i], s->blocks[i], s->work, zero);
        if (next == contacts[i].state)
            continue;
        changed = true;
        if (!random || scene_random_bits(random) >> 63)
            contacts[i].state = next;
    }
    return changed;
}

/* Iterates; true once a guess is confirmed. */
static bool active_set(contact_solver *s, contact *contacts, int count, const inverse_mass *masses,
                       double zero, scene_random *random) {
    for (int step = 0; step < NEWTON_STEPS; step++) {
        if (!solve_guess(s, contacts, count, masses))
            return false;
        if (!guess_anew(s, contacts, count, zero, random))
            return true;
    }
    return false;
}

/* Clamps impulses to the laws: rounding may leave a small negative normal impulse, or a tangent
 * impulse beyond its bound. */
static void make_lawful(contact *contacts, int count) {
    for (int i = 0; i < count; i++) {
        contact *c = &contacts[i];
        c->normal = fmax(0, c->normal);
        c->tangent = contact_lawful_tangent(c, c->normal, c->tangent);
    }
}

/* Sets `work` to the free velocities plus the contacts' impulses. */
static void apply_impulses(contact_solver *s, const contact *contacts, int count,
                           const inverse_mass *masses) {
    memcpy(s->work, s->free_motion, (size_t)s->body_count * sizeof *s->work);
    for (int i = 0; i < count; i++)
        contact_push(&contacts[i], contacts[i].normal, contacts[i].tangent, masses, s->work);
}

/* The largest violation of a contact's conditions. */
static double worst_breach(const contact_solver *s, const contact *contacts, int count) {
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, contact_breach(&contacts[i], s->blocks[i], s->work));
    return worst;
}

/* The largest relative speed at a contact, including its bias. */
static double fastest(const contact *contacts, int count, const motion *velocities) {
    double speed = 0;
    for (int i = 0; i < count; i++) {
        speed = fmax(speed, fabs(contact_normal_speed(&contacts[i], velocities)));
        speed = fmax(speed, fabs(contact_tangent_speed(&contacts[i], velocities)));
        speed = fmax(speed, -contacts[i].bias);
    }
    return speed;
}

/* Used if the active set method cycles: sweeps, then the active set method from their result with
 * random changes, in several rounds. If none converges, the result of the sweeps is kept. The
 * random numbers are the same each time. */
static bool lead_out(contact_solver *s, contact *contacts, int count, const inverse_mass *masses,
                     double zero) {
    size_t bytes = (size_t)count * sizeof *contacts;
    for (int i = 0; i < count; i++)
        contacts[i].normal = contacts[i].tangent = 0;
    int sweeps = FIRST_SWEEPS;
    scene_random random = {1};
    for (int round = 0; round < ROUNDS; round++, sweeps *= 2) {
        apply_impulses(s, contacts, count, masses);
        contact_sweep(contacts, s->blocks, count, sweeps, masses, s->work);
        memcpy(s->kept, contacts, bytes);
        if (worst_breach(s, contacts, count) < zero)
            return true;
        if (active_set(s, contacts, count, masses, zero, &random))
            return true;
        memcpy(contacts, s->kept, bytes);
    }
    return false;
}

contact_solution contact_solve(contact_solver *s, contact *contacts, int count,
                               const inverse_mass *masses, motion *velocities) {
    contact_solution solution = {.ok = make_room(s, count)};
    if (!solution.ok || count == 0)
        return solution;
    memcpy(s->free_motion, velocities, (size_t)s->body_count * sizeof *velocities);
    list_contacts(s, contacts, count, masses);
    for (int i = 0; i < count; i++)
        s->blocks[i] = contact_own_block(&contacts[i], masses);
    double zero = ROUNDING * fastest(contacts, count, velocities);
    bool solved = active_set(s, contacts, count, masses, zero, NULL);
    solution.hard = !solved;
    if (!solved)
        solved = lead_out(s, contacts, count, masses, zero);
    make_lawful(contacts, count);
    apply_impulses(s, contacts, count, masses);
    solution.residual = worst_breach(s, contacts, count);
    memcpy(velocities, s->work, (size_t)s->body_count * sizeof *velocities);
    return solution;
}
