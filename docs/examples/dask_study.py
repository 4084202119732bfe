"""Runs the tasks of a `peristat` study with Dask and collects them.

    python dask_study.py STUDY.json [-o FOLDER] [--scheduler ADDRESS] [--workers N]

Without an address the workers are processes of this machine. Workers start the command `peristat` (or what the variable
PERISTAT names), and see the same folder. Ends with the exit code of the study: 0 if all is as expected.
"""

import argparse
import json
import os
import subprocess
import sys

from dask.distributed import Client, LocalCluster, as_completed

PERISTAT = os.environ.get("PERISTAT", "peristat")


def study(arguments, options):
    """Runs the command; returns its exit code and what it printed."""
    done = subprocess.run([PERISTAT, "study", *arguments, *options], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("study")
    parser.add_argument("-o", "--output", help="results folder, as of `peristat study`")
    parser.add_argument("--scheduler", help="address of a scheduler; the workers are of this machine if not given")
    parser.add_argument("--workers", type=int, help="processes of this machine; as many as cores if not given")
    given = parser.parse_args()
    arguments = [given.study] + (["-o", given.output] if given.output else [])

    code, plan, message = study(arguments, ["--plan", "--json"])
    if code != 0:
        sys.exit(message)
    tasks = range(1, len(json.loads(plan)["tasks"]) + 1)

    cluster = given.scheduler or LocalCluster(
        n_workers=given.workers, threads_per_worker=1, dashboard_address=None
    )
    with Client(cluster) as client:
        # `pure=False`: what a task does is its file, so an earlier answer does not stand for it.
        futures = {
            client.submit(study, arguments, ["--task", str(task), "--threads", "1"], pure=False): task
            for task in tasks
        }
        for future, (code, _, message) in as_completed(futures, with_results=True):
            if code != 0:
                print(f"task {futures[future]} ended with {code}: {message}", file=sys.stderr)

    code, text, message = study(arguments, ["--collect"])
    print(text, end="")
    print(message, end="", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
