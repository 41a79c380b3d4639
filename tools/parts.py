"""The parts of the engine that thud.c, the engine in one file, is compiled without where a program defines
THUD_NO_ and the part's name.

A part is what only calls to it and what it plugs into a world bring to life: the files of engine/src that
nothing else calls. tests/package holds this table to the calls of the compiled library.
"""

import dataclasses
import fnmatch


@dataclasses.dataclass
class Part:
    files: tuple  # patterns of paths below engine/src
    what: str
    goes_with: tuple = ()  # parts that call this one, and so have to be left out with it


IMPACTS = ("detection/arrival_rows.c", "detection/arrivals.c", "detection/ballistics.c",
           "detection/collide.c", "detection/gaps.c", "detection/ghosts.c", "detection/impacts.c",
           "detection/sensing_awake.c", "detection/toi_candidates.c", "detection/toi_queue.c",
           "detection/unbisectable.c", "detection/wide_project.c", "solver/bounces.c")
# A file of several parts is left out where all of them are.
PARTS = {
    "RECORDING": Part(("recording/*",), "recordings and their player: `thud_recording.h`, `thud_recorded.h`"),
    "SESSIONS": Part(("sessions/*",), "rollback, packed snapshots, saved worlds: `thud_rollback.h`, `thud_packed.h`,"
                     " `thud_world_save` and `_load`", ("RECORDING",)),
    "SNAPSHOTS": Part(("api/snapshot*.c",), "`thud_snapshot.h`", ("RECORDING", "SESSIONS")),
    "JOINTS": Part(("joints/*", "edits/locks.c", "direct/contact_check.c", "direct/island_step_joints.c",
                    "direct/joint_*.c", "direct/line_search.c", "direct/overloaded_joints.c", "direct/resolve_island.c",
                    "direct/step_parts.c", "api/drawing.c"),
                   "joints and locked bodies: `thud_joint.h`, `thud_joint_at.h`, `thud_locks.h`", ("RECORDING",)),
    "DIRECT": Part(("direct/active_set.c", "direct/conjugate_gradients.c", "direct/contact_rows.c", "direct/direct.c",
                    "direct/interior_point.c", "direct/island_problem.c", "direct/island_step.c",
                    "direct/newton_step.c", "direct/sparse_numbers.c", "direct/wide_sparse.c",
                    "solver/quality_default.c", "solver/quality_high.c", "api/default_world.c"),
                   "the direct island solver, with the qualities `default`, `high` and `exact` and"
                   " `thud_default_world_def`; `draft` is left", ("RECORDING", "SNAPSHOTS", "JOINTS", "BISECT",
                                                                  "SWEPT")),
    "BISECT": Part(("detection/detect_bisect.c", "geometry/bisect.c", "terrain/terrain_bisect.c", *IMPACTS),
                   "the detection `bisect`", ("RECORDING", "SNAPSHOTS")),
    "SWEPT": Part(("detection/detect_swept.c", "solver/quality_exact.c", *IMPACTS),
                  "the detection `swept`, with the quality `exact`", ("RECORDING", "SNAPSHOTS")),
    "BROADPHASES": Part(("broadphase/plane_sweep*.c", "broadphase/all_pairs.c", "broadphase/sorted_axis.c",
                         "broadphase/wide_axis_sweep.c", "api/default_small_world.c"),
                        "the broadphases of `thud_broadphase_sweep`, `_sweep_y`, `_sweep_widest`, `_sweep_both` and"
                        " `_all`, with `thud_default_small_world_def`; the grid is left", ("RECORDING",)),
    "QUERIES": Part(("api/query*.c", "casts/path.c", "state/preview.c"), "`thud_queries.h`", ("CASTS", "FIELDS", "MOVER")),
    "CASTS": Part(("casts/each.c", "casts/extrapolate.c", "casts/many.c", "casts/one_shape.c", "casts/predict.c",
                   "casts/walk.c"),
                  "casts hit by hit, many at once or against one shape, and prediction: `thud_casts.h`,"
                  " `thud_prediction.h`", ("RECORDING",)),
    "MOVER": Part(("api/mover*.c",), "characters: `thud_mover.h`", ("RECORDING",)),
    "FIELDS": Part(("fields/*", "casts/walk.c"), "`thud_fields.h`", ("RECORDING",)),
    "LISTENERS": Part(("listeners/*", "detection/sweep_veto.c"), "`thud_listeners.h`", ("RECORDING",)),
    "RULES": Part(("rules/*", "detection/sweep_veto.c"), "`thud_rules.h`", ("RECORDING",)),
    "TEXTURES": Part(("textures/*", "terrain/terrain_texture.c"), "`thud_textured.h`", ("RECORDING",)),
    "LISTS": Part(("lists/*",), "`thud_lists.h`"),
    "DRAWING": Part(("api/debug_draw.c", "api/draw*.c", "state/preview.c"), "`thud_draw.h`"),
    "GEOMETRY": Part(("geometry/approach.c", "geometry/approximate.c", "geometry/bisect.c", "geometry/capsule.c",
                      "geometry/cover_*.c", "geometry/polygon.c", "geometry/volumes*.c", "terrain/terrain_bisect.c",
                      "terrain/terrain_capsule.c", "terrain/terrain_foot.c", "api/body_volume.c", "state/preview.c"),
                     "geometry without a world that worlds have no use for: `thud_approximate.h`,"
                     " `thud_capsule.h`, `thud_volumes.h`"),
    "STAGES": Part(("api/shared_stages.c", "broadphase/shared_sweep.c", "contact/shared_waiting.c",
                    "detection/shared_fast.c", "solver/shared_finalize.c"),
                   "`thud_shared_stages_all`: workers share contacts and the solver alone", ("THREADS",)),
    "THREADS": Part(("threads/*",), "the pool of threads: `thud_threads.h`"),
}


def parts_of(path):
    """The parts that a file of engine/src belongs to: it is left out where all of these are."""
    return [name for name, part in PARTS.items() if any(fnmatch.fnmatch(path, files) for files in part.files)]


def left_out_with(*names):
    """These parts and those that have to be left out with them, in the table's order."""
    wanted = set()
    todo = list(names)
    while todo:
        name = todo.pop()
        if name not in wanted:
            wanted.add(name)
            todo += PARTS[name].goes_with
    return [name for name in PARTS if name in wanted]
