/* machine.h: what figures depend on besides the code: processor, system, compiler, builds. */
#ifndef THUD_BENCH_MACHINE_H
#define THUD_BENCH_MACHINE_H

#include "json.h"

/* An object "about". The commit is what the caller names in THUD_COMMIT, as `./run bench` does. */
void machine_describe(json *out);

#endif
