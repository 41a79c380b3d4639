/* shared_stages.c: the table of the stages that workers share where a program asks for them. */
#include "state/shared_stages.h"

const thud_shared_stages thud_shared_stages_all = {
    .finalize = td_shared_finalize,
    .sweep = td_shared_sweep,
    .waiting = td_shared_waiting,
    .sift_fast = td_shared_sift_fast,
};
