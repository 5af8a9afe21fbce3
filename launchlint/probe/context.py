"""What Docker builds the image from: one tar archive with the Dockerfile, the program, the manifests and the sources."""

from __future__ import annotations

import os
import re
import tarfile
from collections.abc import Sequence

from launchlint.errors import UsageError
from launchlint.probe.configuration import ProbeConfiguration
from launchlint.probe.sources import LARGEST_FILE, Tree, members, put, put_link

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO

_NAME = re.compile(rb"<name>\s*([A-Za-z][A-Za-z0-9_-]{0,199})\s*</name>")

CERTIFICATES = "LAUNCHLINT_CA_CERTIFICATES"
"""Names a PEM file, or a directory of such, that the image shall trust: for networks behind a proxy that looks inside."""


def program_directory() -> str:
    """The directory with the Dockerfile and the program that runs beside the nodes: inside an installed launchlint, else in its source
    tree.

    Raises:
        UsageError: there is none.
    """
    here = os.path.dirname(os.path.abspath(__file__))
    for candidate in (os.path.join(here, "container"), os.path.join(os.path.dirname(os.path.dirname(here)), "probe")):
        if os.path.isfile(os.path.join(candidate, "launchlint_probe", "__main__.py")):
            return candidate
    raise UsageError("this copy of launchlint lacks the program that runs in the container (probe/); install it anew")


def write_context(file: IO[bytes], configuration: ProbeConfiguration, trees: Sequence[Tree]) -> dict[str, str]:
    """Write the archive to ``file``. Returns which tree each package is in.

    Raises:
        UsageError: a source tree, or a certificate, cannot be read.
    """
    program = program_directory()
    found: dict[str, str] = {}
    with tarfile.open(fileobj=file, mode="w") as archive:
        for name in _program_files(program):
            with open(os.path.join(program, name), "rb") as source:
                data = source.read()
            put(archive, name, data, len(data), runs=name.endswith(".sh"))
        for name, words in (("apt", configuration.apt), ("pip", configuration.pip)):
            data = "".join(f"{word}\n" for word in sorted(set(words))).encode()
            put(archive, f"setup/{name}.txt", data, len(data))
        for directory in ("certificates", "manifests", "source"):
            info = tarfile.TarInfo(directory)
            info.type, info.mode = tarfile.DIRTYPE, 0o755
            archive.addfile(info)
        for name, data in _certificates():
            put(archive, f"certificates/{name}", data, len(data))
        for tree in trees:
            for member in members(tree):
                path = f"source/{tree.name}/{member.path}"
                if member.link:
                    put_link(archive, path, member.link)
                    continue
                if os.path.basename(member.path) == "package.xml" and member.size < 2**20:
                    data = member.source.read()
                    named = _NAME.search(data)
                    if named is not None:
                        found.setdefault(named[1].decode("ascii"), tree.name)
                    put(archive, f"manifests/{tree.name}/{member.path}", data, len(data))
                    put(archive, path, data, len(data))
                else:
                    put(archive, path, member.source, member.size, runs=member.runs)
    return found


def _program_files(program: str) -> list[str]:
    found = ["Dockerfile"]
    for directory in ("setup", "launchlint_probe"):
        names = sorted(os.listdir(os.path.join(program, directory)))
        found.extend(f"{directory}/{name}" for name in names if name.endswith((".py", ".sh")))
    return found


def _certificates() -> list[tuple[str, bytes]]:
    where = os.environ.get(CERTIFICATES, "")
    if not where:
        return []
    paths = (
        [where]
        if not os.path.isdir(where)
        else sorted(os.path.join(where, name) for name in os.listdir(where) if name.endswith((".crt", ".pem")))
    )
    found = []
    for number, path in enumerate(paths):
        try:
            with open(path, "rb") as file:
                found.append((f"launchlint-{number}.crt", file.read(LARGEST_FILE)))
        except OSError as error:  # noqa: PERF203 (each says which file it is)
            raise UsageError(f"{CERTIFICATES}: {path} cannot be read: {error.strerror or error}") from None
    return found
