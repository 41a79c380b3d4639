/* joint_scenes.c: scenes of joints for measurements only, made of the scenes of tests/measure that
 * the envelope and the trade-off use too. */
#include "plan.h"

#include "tied_scenes.h"

const scene_info bench_chains = {
    .name = "swinging_chains",
    .title = "Swinging chains",
    .about = "Chains of 50 links with a ball of ten links' mass swing from level.",
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

const scene_info bench_heap = {
    .name = "ragdoll_heap",
    .title = "Heap of ragdolls",
    .about = "Figures of 11 bodies and 10 hinges with limits fall into a pit.",
    .size_means = "figures",
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
