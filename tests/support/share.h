/* share.h: which share of its random cases a test runs. A build whose tests run slowly, as those of
 * the sanitizers do, sets TEST_SHARE to n, and long tests run one of n cases there. */
#ifndef SHARE_H
#define SHARE_H

#ifndef TEST_SHARE
#define TEST_SHARE 1
#endif

/* That share of `cases`, rounded up, so that at least one is left. A test that expects something of
 * all cases together scales that by the same share. */
static inline int share_of(int cases) {
    return (cases + TEST_SHARE - 1) / TEST_SHARE;
}

#endif
