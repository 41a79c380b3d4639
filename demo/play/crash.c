/* crash.c: see crash.h. What the handler does may fail in a program that has crashed, as its heap
 * may be damaged: then the program ends by that, within a few seconds. */
#define _POSIX_C_SOURCE 200809L
#include "crash.h"

#include <signal.h>
#include <stdio.h>

#ifndef _WIN32
#include <unistd.h>
#endif

/* Seconds after which a handler that hangs is ended. Chosen. */
enum { HANGS = 5 };

static session *watched;

static const int signals[] = {
    SIGSEGV, SIGABRT, SIGFPE, SIGILL,
#ifdef SIGBUS
    SIGBUS,
#endif
};

static void set_handler(void (*handler)(int)) {
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        signal(signals[i], handler);
}

static void save(int number) {
    char path[LAST_SECONDS_PATH];
    set_handler(SIG_DFL);
#ifndef _WIN32
    signal(SIGALRM, SIG_DFL);
    alarm(HANGS);
#endif
    fprintf(stderr, "thud-play: crashed by signal %d\n", number);
    if (last_seconds_salvage(&watched->last, &watched->scene, path))
        fprintf(
            stderr,
            "thud-play: the last %d s, up to the step that crashed, are in %s; please attach it "
            "to a report\n",
            LAST_SECONDS, path);
    raise(number);
}

void crash_watch(session *s) {
    watched = s;
    set_handler(s ? save : SIG_DFL);
}
