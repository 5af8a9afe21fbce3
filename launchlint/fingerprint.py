"""What a finding is recognised by when lines move: baseline, SARIF and GitLab use it.

A fingerprint is made of the rule, the path and the normalised text of the element (:attr:`Finding.element`), of the topic, and of nothing
that changes when other lines of the file do. Equal ones in one file are numbered in the order of the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256

from launchlint.finding import Finding
from launchlint.order import ordered

_SCHEME = "launchlint/1"


def fingerprint(finding: Finding, occurrence: int = 1) -> str:
    """SHA-256, in hex, of rule, path, element and topic of ``finding``; the first ``occurrence`` is number 1."""
    parts = [_SCHEME, finding.rule, finding.location.path.replace("\\", "/"), " ".join(finding.element.split()), finding.topic]
    if occurrence > 1:
        parts.append(str(occurrence))
    return sha256("\0".join(parts).encode("utf-8", "surrogatepass")).hexdigest()


def fingerprints(findings: Sequence[Finding]) -> list[tuple[Finding, str]]:
    """Each finding with its fingerprint, in report order; no two fingerprints are the same, whatever order the findings came in."""
    seen: dict[str, int] = {}
    result: list[tuple[Finding, str]] = []
    for finding in ordered(findings):
        plain = fingerprint(finding)
        seen[plain] = seen.get(plain, 0) + 1
        result.append((finding, plain if seen[plain] == 1 else fingerprint(finding, seen[plain])))
    return result
