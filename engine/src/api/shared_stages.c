/* shared_stages.c: the table of the stages that workers share where a program asks for them. */
#include "state/shared_stages.h"

const thud_shared_stages thud_shared_stages_all = {
    .finalize_reserve = td_shared_finalize_reserve,
    .finalize = td_shared_finalize,
};
