"""Time of one position."""

import time

REPEATS = 15


def nanoseconds(work, positions, repeats=REPEATS):
    """The shortest of several runs of `work`, for one of its positions: whatever else the machine does only adds time."""
    work()  # warm: compiled, and in cache
    shortest = float("inf")
    for _ in range(repeats):
        start = time.perf_counter_ns()
        work()
        shortest = min(shortest, time.perf_counter_ns() - start)
    return shortest / positions
