"""What a command does, counted: the calls of functions that it makes. Unlike seconds they are the same on every machine."""

from __future__ import annotations

import contextlib
import io
import os
import sys
import tempfile
from collections.abc import Mapping, Sequence
from cProfile import Profile
from importlib import import_module
from pathlib import Path

from tests.cli.forking import import_everything


def calls(words: Sequence[str], directory: Path, bounds: Mapping[str, int]) -> int:
    """The calls (of Python and of C) that ``launchlint WORDS`` makes in ``directory``.

    It runs in a fork of this process, with an empty cache, so that nothing is kept from one count to the next. ``bounds`` are launchlint's
    own, by module and name, with the numbers to put in their place: a small workspace lies beyond a small bound as a great one beyond the
    real one. Raises :exc:`RuntimeError` where the command ends by an exception or with a status above 1.
    """
    from launchlint.cli import main

    import_everything()  # in the parent, so that no count has the imports in it
    reading, writing = os.pipe()
    child = os.fork()
    if child:
        os.close(writing)
        with os.fdopen(reading) as answer:
            told = answer.read()
        os.waitpid(child, 0)
        status, _, count = told.partition(" ")
        if status not in ("0", "1"):
            raise RuntimeError(f"launchlint {' '.join(words)} in {directory}: {told}")
        return int(count)
    os.close(reading)
    try:
        os.chdir(directory)
        os.environ["XDG_CACHE_HOME"] = tempfile.mkdtemp(dir=directory.parent)
        for place, most in bounds.items():
            module, _, constant = place.rpartition(".")
            assert isinstance(getattr(import_module(module), constant), int)
            setattr(import_module(module), constant, most)
        status, counted = _counted(main, words)
        os.write(writing, f"{status} {counted}".encode())
    except BaseException as error:
        os.write(writing, f"failed {error!r}"[:4000].encode())
    finally:
        os._exit(0)


def _counted(main: object, words: Sequence[str]) -> tuple[int, int]:
    assert callable(main)
    counter = Profile()
    sys.argv = ["launchlint", *words]
    status: object = 0
    with contextlib.redirect_stdout(io.TextIOWrapper(io.BytesIO())), contextlib.redirect_stderr(io.StringIO()):
        counter.enable()
        try:
            main()
        except SystemExit as ended:
            status = ended.code
        finally:
            counter.disable()
    return (status if isinstance(status, int) else 0), sum(each.callcount for each in counter.getstats())
