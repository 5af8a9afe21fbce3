"""Work shared by several processes, in order; it ends early where processes cannot be had, and on Ctrl-C without a trace."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable
from typing import Any, TypeVar

from launchlint.garbage import seldom_looked_for

Item = TypeVar("Item")
Result = TypeVar("Result")
State = TypeVar("State")


_here: list[Any] = []
"""In a process of a pool, what it keeps for all its items: whatever else a pool hands to its processes is sent anew with each item."""


def in_pool(
    work: Callable[[State, Item], Result], items: Iterable[Item], workers: int, begin: Callable[..., State], given: tuple[Any, ...]
) -> Generator[Result, None, None]:
    """What ``work`` makes of each item, in order; only the first ones where processes cannot be had, or one of them was killed.

    Each process calls ``begin(*given)`` first, and gives ``work`` what it returns with each item. Close the iterator where it is not read
    to its end: that ends the processes.
    """
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    try:
        with ProcessPoolExecutor(workers, initializer=_begin, initargs=(begin, given)) as pool:
            try:
                # Not pool.map: interrupted, it cancels its futures, and the pool's own thread then falls over them with a traceback.
                for future in [pool.submit(_work, work, item) for item in items]:
                    yield future.result()
            except (KeyboardInterrupt, GeneratorExit):
                _end_workers()
                raise
    except (BrokenProcessPool, OSError):
        return


def _begin(begin: Callable[..., Any], given: tuple[Any, ...]) -> None:
    """In a new process: Ctrl-C is for the parent, which ends it."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _here[:] = [begin(*given)]


def _work(work: Callable[[Any, Item], Result], item: Item) -> Result:
    with seldom_looked_for():
        return work(_here[0], item)


def _end_workers() -> None:
    import multiprocessing

    for process in multiprocessing.active_children():
        process.terminate()
