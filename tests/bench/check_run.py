"""Tests ./run bench without building: its help, and that wrong options are refused.

usage: check_run.py THUD_BENCH
"""

import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RUN = os.path.join(ROOT, "run")


def run(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False)


def options_of(text):
    """The options that a help text lists."""
    return set(re.findall(r"^  (--[a-z0-9]+)", text, re.MULTILINE)) | \
        set(re.findall(r"^  --[a-z]+, (--[a-z]+)", text, re.MULTILINE))


def check_help_has_every_option_of_the_program(bench):
    own, program = run(RUN, "bench", "--help"), run(bench, "--help")
    assert own.returncode == 0 and program.returncode == 0, (own, program)
    missing = options_of(program.stdout) - options_of(own.stdout) - {"--help"}
    assert not missing, missing
    more = options_of(own.stdout) - options_of(program.stdout)
    assert more == {"--wasm", "--report", "--catalogue", "--picture"}, more
    assert run(RUN, "bench", "--quick", "-h").stdout == own.stdout


def check_report_help_and_refusals():
    done = run(RUN, "bench", "--report", "--help")
    assert done.returncode == 0 and "--again" in done.stdout, done
    done = run(RUN, "bench", "--catalogue", "--help")
    assert done.returncode == 0 and "--quick" in done.stdout and "--out" in done.stdout, done
    for words, says in ((["--picture"], "--picture wants"), (["--picture", "x.png"], ".svg")):
        done = run(RUN, "bench", *words)
        assert done.returncode == 1 and says in done.stderr, done


check_help_has_every_option_of_the_program(sys.argv[1])
check_report_help_and_refusals()
