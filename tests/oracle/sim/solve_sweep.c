/* solve_sweep.c: see solve_rows.h. */
#include "sim/solve_rows.h"

#include <math.h>

double contact_slip_ratio(const contact *c) {
    return c->friction;
}

double contact_lawful_tangent(const contact *c, double normal, double tangent) {
    double bound = contact_slip_ratio(c) * normal;
    return tangent < -bound ? -bound : tangent > bound ? bound : tangent;
}

contact_row contact_normal_row(const contact *c) {
    double x = c->normal_x, y = c->normal_y;
    return (contact_row){x, y, c->arm_ax * y - c->arm_ay * x, c->arm_bx * y - c->arm_by * x};
}

contact_row contact_tangent_row(const contact *c) {
    double x = c->normal_y, y = -c->normal_x;
    return (contact_row){x, y, c->arm_ax * y - c->arm_ay * x, c->arm_bx * y - c->arm_by * x};
}

static double speed_along(contact_row r, const motion *a, const motion *b) {
    return (b->x - a->x) * r.x + (b->y - a->y) * r.y + b->turn * r.turn_b - a->turn * r.turn_a;
}

double contact_normal_speed(const contact *c, const motion *velocities) {
    return speed_along(contact_normal_row(c), &velocities[c->body_a], &velocities[c->body_b]);
}

double contact_tangent_speed(const contact *c, const motion *velocities) {
    return speed_along(contact_tangent_row(c), &velocities[c->body_a], &velocities[c->body_b]);
}

double contact_coupling(contact_row one, double turn_one, contact_row other, double turn_other,
                        inverse_mass mass, double sign) {
    return sign * (mass.linear * (one.x * other.x + one.y * other.y) +
                   mass.angular * turn_one * turn_other);
}

contact_block contact_own_block(const contact *c, const inverse_mass *masses) {
    contact_row n = contact_normal_row(c), t = contact_tangent_row(c);
    inverse_mass a = masses[c->body_a], b = masses[c->body_b];
    return (contact_block){
        .nn = contact_coupling(n, n.turn_a, n, n.turn_a, a, 1) +
              contact_coupling(n, n.turn_b, n, n.turn_b, b, 1),
        .nt = contact_coupling(n, n.turn_a, t, t.turn_a, a, 1) +
              contact_coupling(n, n.turn_b, t, t.turn_b, b, 1),
        .tt = contact_coupling(t, t.turn_a, t, t.turn_a, a, 1) +
              contact_coupling(t, t.turn_b, t, t.turn_b, b, 1),
    };
}

void contact_push(const contact *c, double normal, double tangent, const inverse_mass *masses,
                  motion *velocities) {
    contact_row n = contact_normal_row(c), t = contact_tangent_row(c);
    double px = normal * n.x + tangent * t.x, py = normal * n.y + tangent * t.y;
    inverse_mass a = masses[c->body_a], b = masses[c->body_b];
    motion *va = &velocities[c->body_a], *vb = &velocities[c->body_b];
    va->x -= a.linear * px;
    va->y -= a.linear * py;
    va->turn -= a.angular * (normal * n.turn_a + tangent * t.turn_a);
    vb->x += b.linear * px;
    vb->y += b.linear * py;
    vb->turn += b.angular * (normal * n.turn_b + tangent * t.turn_b);
}

double contact_breach(const contact *c, contact_block block, const motion *velocities) {
    double normal_speed = contact_normal_speed(c, velocities) + c->bias;
    double tangent_speed = contact_tangent_speed(c, velocities);
    double normal = fmax(0, c->normal - normal_speed / block.nn);
    double tangent = contact_lawful_tangent(c, c->normal, c->tangent - tangent_speed / block.tt);
    return fmax(fabs(normal - c->normal) * block.nn, fabs(tangent - c->tangent) * block.tt);
}

/* Computes the impulses that obey the laws at this contact if all others keep theirs; the speeds
 * are those without this contact's impulses. */
static void solve_one(contact *c, contact_block w, double normal_speed, double tangent_speed) {
    c->normal = c->tangent = 0;
    c->state = CONTACT_OPEN;
    if (normal_speed >= 0)
        return;
    double determinant = w.nn * w.tt - w.nt * w.nt;
    double normal = (w.nt * tangent_speed - w.tt * normal_speed) / determinant;
    double tangent = (w.nt * normal_speed - w.nn * tangent_speed) / determinant;
    if (determinant > 0 && normal >= 0 && contact_lawful_tangent(c, normal, tangent) == tangent) {
        c->normal = normal;
        c->tangent = tangent;
        c->state = CONTACT_STICK;
        return;
    }
    double along = tangent_speed < 0 ? contact_slip_ratio(c) : -contact_slip_ratio(c);
    for (int turn = 0; turn < 2; turn++, along = -along) {
        double effective = w.nn + along * w.nt;
        if (!(effective > 0))
            continue;
        normal = -normal_speed / effective;
        double slip = tangent_speed + (w.nt + along * w.tt) * normal;
        c->normal = normal;
        c->tangent = along * normal;
        c->state = along > 0 ? CONTACT_SLIP_FORWARD : CONTACT_SLIP_BACK;
        if (slip * along <= 0)
            return;
    }
}

void contact_sweep(contact *contacts, const contact_block *blocks, int count, int sweeps,
                   const inverse_mass *masses, motion *velocities) {
    for (int sweep = 0; sweep < sweeps; sweep++)
        for (int i = 0; i < count; i++) {
            contact *c = &contacts[i];
            contact_push(c, -c->normal, -c->tangent, masses, velocities);
            solve_one(c, blocks[i], contact_normal_speed(c, velocities) + c->bias,
                      contact_tangent_speed(c, velocities));
            contact_push(c, c->normal, c->tangent, masses, velocities);
        }
}
