/* kinds.h: declares the functions that are compiled once for each instruction set (wide_*.c), and
 * the kinds of shapes. A kind plugs its pair functions into a world when the world gets its first
 * shape of the kind, so that a program that never makes one does not link its code. A new kind
 * begins in thud_geometry.h; docs/architecture.md lists the files that follow. */
#ifndef TD_KINDS_H
#define TD_KINDS_H

#include "solver/motion.h"
#include "state/world.h"

/* ROW(shape kind, function that plugs it in, pair kind). Snapshots recognise by the pair kind,
 * which a world only has with that shape kind, that the kind is plugged in. */
#define TD_ALL_KINDS(ROW)                                         \
    ROW(THUD_SHAPE_CIRCLE, td_kind_circle, TD_PAIR_CIRCLE_CIRCLE) \
    ROW(THUD_SHAPE_AABB, td_kind_aabb, TD_PAIR_AABB_AABB)         \
    ROW(THUD_SHAPE_OBB, td_kind_obb, TD_PAIR_BOX_BOX)             \
    ROW(THUD_SHAPE_TERRAIN, td_kind_terrain, TD_PAIR_TERRAIN_BOX)

#define TD_DECLARE_KIND(kind, plug, own) void plug(thud_world *w);
TD_ALL_KINDS(TD_DECLARE_KIND)

TD_DECLARE_WIDE(td_grid_measure_fn, td_grid_measure);
TD_DECLARE_WIDE(td_grid_cells_fn, td_grid_cells);
TD_DECLARE_WIDE(td_proxy_set_fill_fn, td_proxy_set_fill);
TD_DECLARE_WIDE(td_sweep_fn, td_grid_sweep);
TD_DECLARE_WIDE(td_sweep_fn, td_sorted_axis_sweep);
TD_DECLARE_WIDE(td_find_fn, td_grid_find);
TD_DECLARE_WIDE(td_find_fn, td_sorted_axis_find);
TD_DECLARE_WIDE(td_begin_motion_fn, td_begin_motion);
TD_DECLARE_WIDE(td_integrate_velocity_fn, td_integrate_velocity);
TD_DECLARE_WIDE(td_integrate_position_fn, td_integrate_position);
TD_DECLARE_WIDE(td_solve_fn, td_bounce_one);
TD_DECLARE_WIDE(td_solve_fn, td_bounce_two);
TD_DECLARE_WIDE(td_end_flights_fn, td_end_flights);
TD_DECLARE_WIDE(td_tally_fn, td_tally_points);
TD_DECLARE_WIDE(td_tally_speeds_fn, td_tally_speeds);
TD_DECLARE_WIDE(td_kinetic_energy_fn, td_kinetic_energy);
TD_DECLARE_WIDE(td_finalize_bodies_fn, td_finalize_bodies);

#define TD_DECLARE_PAIR(kind, ops, ...) TD_DECLARE_WIDE(const td_constraint_ops, ops);
TD_ALL_PAIRS(TD_DECLARE_PAIR)

/* Sets the operations of one pair kind, a row of pair_kinds.h, in the world `w` of the scope. */
#define TD_PLUG_PAIR(kind, ops, ...) w->kinds[kind] = &TD_PICK_WIDE(w, ops);

#endif
