"""A suppression comment gives no reason.

This rule is off until it is selected.

## Why it matters

Who reads the file later cannot tell whether the finding is a false alarm, a known defect or a decision.

## Example

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <!-- launchlint: ignore[LL605] -->
    <remap from="scan" to="scan"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="amcl" type="amcl" name="amcl">
    <!-- launchlint: ignore[LL605] shows that the name is left as it is -->
    <remap from="scan" to="scan"/>
  </node>
</launch>
```
"""

from __future__ import annotations

from collections.abc import Iterator

from launchlint.finding import Finding, Severity
from launchlint.rules.rule import Rule
from launchlint.rules.view import SuppressionView

RULE = Rule("LL803", "suppression-without-reason", Severity.INFO, default=False)


def check(view: SuppressionView) -> Iterator[Finding]:
    """Look at every suppression that works."""
    for suppression in view.suppressions:
        if not suppression.problem and not suppression.reason:
            named = ", ".join(name.text for name in suppression.names) or "all rules"
            yield RULE.at_location(
                suppression.location,
                f"{named} suppressed without a reason",
                label="no reason",
                help="write the reason behind the brackets" if suppression.names else "name the rule, and write the reason behind it",
                element=f"suppression {' '.join(sorted(suppression.rules))}".strip(),
            )
