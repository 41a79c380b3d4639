"""Runs a command of the tests of this folder."""

import subprocess


def run(*words, **more):
    """What the command prints; an AssertionError with it where the command fails."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True,
                          stderr=subprocess.STDOUT, check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout
