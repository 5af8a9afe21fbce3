"""A launch file cannot be read, so that nothing in it can be checked.

There is no such file, it may not be read, it is a symbolic link that leads nowhere, or it holds far more than any
launch file a person writes: more than 64 MiB, more than 250,000 elements and attributes, or entities that expand
without measure.

## Why it matters

Where the file cannot be opened, roslaunch stops as well. Where it is only too large, roslaunch might load it after a
long while, but no mistake in it is found.

## Example

Entities that stand for one another more than fifty deep:

```xml
<!DOCTYPE launch [
  <!ENTITY a "base_link"> <!ENTITY b "&a;"> <!ENTITY c "&b;"> <!ENTITY d "&c;"> <!ENTITY e "&d;"> <!ENTITY f "&e;">
  <!ENTITY g "&f;"> <!ENTITY h "&g;"> <!ENTITY i "&h;"> <!ENTITY j "&i;"> <!ENTITY k "&j;"> <!ENTITY l "&k;">
  <!ENTITY m "&l;"> <!ENTITY n "&m;"> <!ENTITY o "&n;"> <!ENTITY p "&o;"> <!ENTITY q "&p;"> <!ENTITY r "&q;">
  <!ENTITY s "&r;"> <!ENTITY t "&s;"> <!ENTITY u "&t;"> <!ENTITY v "&u;"> <!ENTITY w "&v;"> <!ENTITY x "&w;">
  <!ENTITY y "&x;"> <!ENTITY z "&y;"> <!ENTITY A "&z;"> <!ENTITY B "&A;"> <!ENTITY C "&B;"> <!ENTITY D "&C;">
  <!ENTITY E "&D;"> <!ENTITY F "&E;"> <!ENTITY G "&F;"> <!ENTITY H "&G;"> <!ENTITY I "&H;"> <!ENTITY J "&I;">
  <!ENTITY K "&J;"> <!ENTITY L "&K;"> <!ENTITY M "&L;"> <!ENTITY N "&M;"> <!ENTITY O "&N;"> <!ENTITY P "&O;">
  <!ENTITY Q "&P;"> <!ENTITY R "&Q;"> <!ENTITY S "&R;"> <!ENTITY T "&S;"> <!ENTITY U "&T;"> <!ENTITY V "&U;">
  <!ENTITY W "&V;"> <!ENTITY X "&W;"> <!ENTITY Y "&X;"> <!ENTITY Z "&Y;">
]>
<launch>
  <param name="frame" value="&Z;"/>
</launch>
```

## Use instead

```xml
<launch>
  <param name="frame" value="base_link"/>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, LaunchView
from launchlint.syntax.problems import UnreadableFile

RULE = Rule("LL100", "unreadable-file", Severity.ERROR, roslaunch="refuses")


def tell(problem: UnreadableFile, view: object) -> Iterator[Finding]:
    """Say why the file cannot be read."""
    reason = problem.reason
    launcher = view.dialect.launcher if isinstance(view, (FileView, LaunchView)) else "roslaunch"
    may = f"{launcher} may be able to load it; launchlint does not try, since such files can exhaust a machine"
    notes = () if problem.refused else (may,)
    advice = "write it as a plain launch file" if not problem.refused else "correct the path, or make the file readable"
    yield RULE.at(problem.origin, f"this launch file cannot be read: {reason}", notes=notes, help=advice)
