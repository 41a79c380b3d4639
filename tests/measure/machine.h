/* machine.h: describes what measurements depend on besides the code: processor, system, compiler,
 * builds of other engines. */
#ifndef THUD_BENCH_MACHINE_H
#define THUD_BENCH_MACHINE_H

#include "json.h"

/* Writes an object "about". The commit is the environment variable THUD_COMMIT, which `./run bench`
 * sets. */
void machine_describe(json *out);

#endif
