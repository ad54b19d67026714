"""A study on the workers of Dask, Ray or Spark: each task computes some rows, and one Parquet file holds all. A row hangs on the study and
its index alone, so a task that is lost is done again elsewhere, and the rows are those of one machine.

    pip install "kinegon[pandas,parquet]" "dask[distributed]"     # or ray, or pyspark
    python in_python.py dask study.json results.parquet
    python in_python.py ray study.json results.parquet
    python in_python.py spark study.json results.parquet

Workers on other machines need kinegon and pandas, and no file: the study goes to them with its scene. What is larger than memory is done by
the program, as on_dask.py shows.
"""

import os
import sys

import kinegon
import pandas
import pyarrow
from pyarrow import parquet

ROWS_OF_A_TASK = 4096


def starts(study):
    """The first row of each task."""
    return list(range(0, len(study), ROWS_OF_A_TASK))


def rows(study, first):
    """The rows of a task; on one core, as each worker is one process."""
    os.environ.setdefault("RAYON_NUM_THREADS", "1")
    return study.rows(first, min(first + ROWS_OF_A_TASK, len(study))).to_pandas()


def on_dask(study, client):
    """All tasks, on the workers of a dask.distributed.Client."""
    return client.gather(client.map(lambda first: rows(study, first), starts(study)))


def on_ray(study):
    """All tasks, on the Ray that is running."""
    import ray

    shared, task = ray.put(study), ray.remote(rows)
    return ray.get([task.remote(shared, first) for first in starts(study)])


def on_spark(study, spark):
    """All tasks, in a SparkSession."""
    firsts = starts(study)
    return spark.sparkContext.parallelize(firsts, len(firsts)).map(lambda first: rows(study, first)).collect()


def save(study, tasks, path):
    """Writes the rows of all tasks, with what tells where they come from."""
    table = pyarrow.Table.from_pandas(pandas.concat(tasks, ignore_index=True), preserve_index=False)
    parquet.write_table(table.replace_schema_metadata({**table.schema.metadata, **study.origin}), path)


def main(system, study, results):
    study = kinegon.Study(study)
    if system == "dask":
        from dask.distributed import Client, LocalCluster

        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            save(study, on_dask(study, client), results)
    elif system == "ray":
        import ray

        ray.init(num_cpus=2, include_dashboard=False)
        save(study, on_ray(study), results)
        ray.shutdown()
    else:
        from pyspark.sql import SparkSession

        # The workers' Python is this one.
        os.environ.setdefault("PYSPARK_PYTHON", sys.executable)
        spark = SparkSession.builder.master("local[2]").getOrCreate()
        save(study, on_spark(study, spark), results)
        spark.stop()


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] not in ("dask", "ray", "spark"):
        sys.exit(__doc__)
    main(*sys.argv[1:])
