/* share.h: what share of its cases a test runs. A build whose tests run slowly, as those of the
 * sanitizers do, sets THUD_TEST_SHARE to n, and long tests run one of n cases there. */
#ifndef SHARE_H
#define SHARE_H

#ifndef TEST_SHARE
#define TEST_SHARE 1
#endif

/* Rounded up, so that something is left of everything; a test takes its share of what it expects
 * of all cases together, too. */
static inline int share_of(int cases) {
    return (cases + TEST_SHARE - 1) / TEST_SHARE;
}

#endif
