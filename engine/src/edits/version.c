/* version.c: thud_version, the version of the library that is linked; see thud_version.h. */
#include "thud/thud_version.h"

int thud_version(void) {
    return THUD_VERSION;
}
