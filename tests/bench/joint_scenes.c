/* joint_scenes.c: scenes of joints that only the benchmark (thud-bench) runs; the demo page does
 * not have them. The functions that fill them (tests/measure/tied_scenes.h) are shared with
 * thud-envelope, which runs scenes near a limit (docs/stability.md), and thud-tradeoff, which plots
 * time per step against error (docs/tradeoff.md). */
#include "plan.h"

#include "tied_scenes.h"

const scene_info bench_chains = {
    .name = "swinging_chains",
    .title = "Swinging chains",
    .about = "Chains of 50 links, each with a ball of ten times a link's mass at its free end, "
             "are let go from the horizontal.",
    .size_means = "chains",
    .default_size = 20,
    .min_size = 1,
    .max_size = 2000,
    .fill = fill_chains,
};

const scene_info bench_bridges = {
    .name = "bridges",
    .title = "Bridges",
    .about = "Boxes fall on bridges of 50 planks.",
    .size_means = "bridges",
    .default_size = 20,
    .min_size = 1,
    .max_size = 2000,
    .fill = fill_bridges,
};

const scene_info bench_ragdoll_heap = {
    .name = "ragdoll_heap",
    .title = "Heap of ragdolls",
    .about = "Ragdolls of 11 bodies and 10 hinges with limits fall into a pit.",
    .size_means = "ragdolls",
    .default_size = 50,
    .min_size = 1,
    .max_size = 2000,
    .fill = fill_ragdoll_heap,
};

const scene_info bench_boxed_bridge = {
    .name = "boxed_bridge",
    .title = "Bridge under boxes",
    .about = "A bridge of hinged planks bears a box on every fifth one.",
    .size_means = "planks",
    .default_size = 100,
    .min_size = 10,
    .max_size = 2000,
    .fill = fill_boxed_bridge,
};
