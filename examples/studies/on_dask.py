"""A study on many machines, with Dask: each task has the installed program compute some rows into RESULTS.parts, and at the end one call
joins them. The folder must be one that all workers see. A task that is lost with its worker is given to another one; what it had done
stays done. The bytes are those of one run on one machine.

    pip install "dask[distributed]"
    python on_dask.py study.json results.csv                      # two workers on this machine
    python on_dask.py study.json results.csv tcp://scheduler:8786 # a cluster that is there

Other systems take the same function:

    Ray     ray.get([ray.remote(max_retries=3)(shard).remote(study, results, a, b) for a, b in ranges(rows)])
    Spark   spark.sparkContext.parallelize(ranges(rows), len(ranges(rows))).foreach(lambda ab: shard(study, results, *ab))
"""

import os
import subprocess
import sys

# Rows are kept in parts of 4096; a task has one or several of them.
ROWS_OF_A_TASK = 4096


def kinegon(*arguments):
    """Runs the program (KINEGON names it, if it is not on the path); its message becomes the error."""
    done = subprocess.run([os.environ.get("KINEGON", "kinegon"), *arguments], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    return done.stdout


def shard(study, results, first, last):
    """The rows from `first` to before `last`, into RESULTS.parts. May be done twice, and anywhere."""
    kinegon("study", study, "-o", results, "--parts", "--rows", f"{first}..{last}")
    return first


def ranges(rows, size=ROWS_OF_A_TASK):
    """The rows of each task."""
    return [(first, min(first + size, rows)) for first in range(0, rows, size)]


def count(study):
    """How many rows a study has."""
    return int(kinegon("study", study, "--count"))


def run(study, results, client):
    """Computes all rows of a study on the workers of a Dask client, and joins them."""
    from dask.distributed import as_completed

    # One process of the program for each worker: it takes the cores that RAYON_NUM_THREADS leaves it.
    tasks = [client.submit(shard, study, results, a, b, pure=False, retries=3) for a, b in ranges(count(study))]
    for task in as_completed(tasks):
        task.result()
    kinegon("study", study, "-o", results)


def main(study, results, scheduler=None):
    from dask.distributed import Client, LocalCluster

    if scheduler:
        with Client(scheduler) as client:
            run(study, results, client)
        return
    os.environ.setdefault("RAYON_NUM_THREADS", "1")
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        run(study, results, client)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
