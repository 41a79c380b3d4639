"""What git says of the commit that a page was measured at. Where there is no repository, or one without
its history, nobody can tell, and no page is wrong for that."""

import subprocess

import measured

ENGINE = ["engine", "demo/scenes"]


def git(*words):
    """What it prints, or None where it fails or is missing."""
    try:
        done = subprocess.run(["git", "-C", measured.ROOT, *words], capture_output=True, text=True,
                              check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def is_whole():
    return (git("rev-parse", "--is-shallow-repository") or "").strip() == "false"


def why_not(commit):
    """Why it can be no commit that a page was measured at; None where it can, or nobody can tell."""
    if git("merge-base", "--is-ancestor", commit, "HEAD") is not None or not is_whole():
        return None
    return "no commit of this history"


def since(commit):
    """The lines of the engine's commits since; None where nobody can tell."""
    found = git("log", "--format=%h %s", f"{commit}..HEAD", "--", *ENGINE)
    return None if found is None else found.splitlines()
