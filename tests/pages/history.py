"""What git knows about the commit that a page was measured at. Without a repository, or with an
incomplete history, nothing can be said, and no page counts as wrong for that."""

import subprocess

import measured

ENGINE = ["engine", "demo/scenes"]


def git(*words):
    """The output of a git command; None if it fails or git is missing."""
    try:
        done = subprocess.run(["git", "-C", measured.ROOT, *words], capture_output=True, text=True,
                              check=False)
    except OSError:
        return None
    return done.stdout if done.returncode == 0 else None


def is_whole():
    return (git("rev-parse", "--is-shallow-repository") or "").strip() == "false"


def why_not(commit):
    """Why a page cannot have been measured at this commit; None if it can, or if the history is
    incomplete."""
    if git("merge-base", "--is-ancestor", commit, "HEAD") is not None or not is_whole():
        return None
    return "no commit of this history"


def since(commit):
    """The lines of the engine's commits since this commit; None if the history is incomplete."""
    found = git("log", "--format=%h %s", f"{commit}..HEAD", "--", *ENGINE)
    return None if found is None else found.splitlines()
