#!/usr/bin/env python3
"""Spreads a file of jobs over the machines of a Ray cluster, and gathers the results.

    pip install "ray>=2"
    python3 ray_jobs.py JOBS RESULTS --parts 20                      on this machine alone
    python3 ray_jobs.py JOBS RESULTS --parts 20 --address auto       on the cluster it belongs to

JOBS is a file for thud-run --jobs. Each part of it is a task of Ray, which starts it anew where a
machine is lost. thud-run, and the levels that the jobs name, must be on every machine, at the same
path. Results of parts are kept beside RESULTS until all are there: after an interruption, only the
parts without results are run. Exit status: 0 done, 1 some jobs failed, and their results say so,
2 a job is wrong, the jobs cannot be read, or there are results already, 3 not all jobs were run, or
their results cannot be written: thud-run is missing or has crashed, or the cluster is lost.
"""

import argparse
import hashlib
import json
import pathlib
import subprocess
import sys

import ray


@ray.remote(max_retries=5)
def run_part(thud_run, jobs, part, parts, cores):
    """Runs one part, on whichever machine has the cores. Returns exit status, results, complaint."""
    done = subprocess.run([thud_run, "--jobs", "/dev/stdin", "--part", f"{part}/{parts}",
                           "--workers", str(cores)], input=jobs, capture_output=True)
    return done.returncode, done.stdout, done.stderr.decode(errors="replace")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("jobs", type=pathlib.Path, help="the file of jobs, one JSON object a line")
    parser.add_argument("results", type=pathlib.Path, help="the file of results to write")
    parser.add_argument("--parts", type=int, default=8, help="how many tasks (8)")
    parser.add_argument("--cores", type=int, default=1, help="cores of a task (1)")
    parser.add_argument("--address", help="the cluster; without it, Ray is started here")
    parser.add_argument("--thud-run", default="thud-run", help="the program, on every machine")
    given = parser.parse_args()
    if given.parts < 1 or given.cores < 1:
        parser.error("--parts and --cores are at least 1")
    return given


def complain(text, status):
    print(f"ray_jobs.py: {text}", file=sys.stderr)
    return status


def have_failures(lines):
    return any("failed" in json.loads(line) for line in lines.splitlines())


def run(given, jobs):
    """Runs the parts that have no results, and puts all results together. Returns the exit status."""
    # Results of other jobs, or of another division, have another name, and are never taken for ours.
    name = hashlib.sha256(jobs).hexdigest()[:12]
    kept = {part: given.results.with_name(f"{given.results.name}.{name}.{part}-{given.parts}")
            for part in range(1, given.parts + 1)}
    if given.results.exists():
        return complain(f"{given.results} is there already", 2)
    ray.init(address=given.address, log_to_driver=False)
    running = {run_part.options(num_cpus=given.cores).remote(
        given.thud_run, jobs, part, given.parts, given.cores): part
        for part, path in kept.items() if not path.exists()}
    while running:
        [task], _ = ray.wait(list(running), num_returns=1)
        part = running.pop(task)
        status, results, complaint = ray.get(task)
        if status == 2:
            return complain(f"part {part}: {complaint}", 2)
        # thud-run also ends with 1 where it cannot write all its results.
        whole = status in (0, 1) and (not results or results.endswith(b"\n"))
        if not whole or status != have_failures(results):
            return complain(f"part {part}: thud-run ended with {status}: {complaint}", 3)
        new = kept[part].with_name("new." + kept[part].name)
        new.write_bytes(results)
        new.replace(kept[part])
        print(f"part {part} of {given.parts} done, {len(running)} to go", flush=True)
    lines = b"".join(path.read_bytes() for path in kept.values())
    given.results.write_bytes(lines)
    for path in kept.values():
        path.unlink()
    return 1 if have_failures(lines) else 0


def main():
    given = arguments()
    try:
        jobs = given.jobs.read_bytes()
    except OSError as error:
        return complain(error, 2)
    try:
        return run(given, jobs)
    except (OSError, ray.exceptions.RayError) as error:
        return complain(error, 3)


if __name__ == "__main__":
    sys.exit(main())
