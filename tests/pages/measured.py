"""The commit, day and processor that figures belong to, which every generated page names in the
same form; and whether a run may write to docs/."""

import os
import re

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DOCS = os.path.join(ROOT, "docs")
COMMIT = re.compile(r"[0-9a-f]{12}")
LINE = re.compile(r"^Measured at commit ([0-9a-f]{12}) on (\d{4}-\d\d-\d\d), (.+)\.$", re.MULTILINE)


def line(about):
    return f"Measured at commit {about['commit']} on {about['date'][:10]}, {about['processor']}."


def is_docs(folder):
    return os.path.realpath(folder) == os.path.realpath(DOCS)


def commit_of_run():
    """The commit that the programs were built from, as ./run found it (tools/commit.sh)."""
    return os.environ.get("THUD_COMMIT") or "unknown"


def refuse_unnamed(folder, commit=None):
    """Refuses to write to docs/ unless the build is that of a commit, so that each page can be
    measured again."""
    commit = commit_of_run() if commit is None else commit
    if is_docs(folder) and not COMMIT.fullmatch(commit):
        raise ValueError(f"what was built is no commit ({commit}): a run on such a tree does not "
                         "write to docs/; commit first, or give --out a folder of its own")
