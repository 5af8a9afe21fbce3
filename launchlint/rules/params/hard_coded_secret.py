"""A password, token or key is written into the launch file.

Told are the `password` of a `<machine>`, and literal values of parameters, args and environment variables whose name
ends in a word such as `password`, `secret`, `token` or `api_key`. Empty values, substitutions, file names,
placeholders, words such as `admin` that anybody would try, a word that the name of a token itself has (`ready` for `ready_token`: what
programs tell each other), and the name of the user that stands beside it, are left alone. The default of
an `<arg>` is an info, and so is a value that a comment beside it calls a default: it may be the one that everybody knows, to be replaced.
The value itself is never printed: what is shown of the line has asterisks in its place. One value that stands in many places is told once.
In ROS 2, which has no `<machine>`, what a `<let>` or an include hands on counts, too.

## Why it matters

Launch files are published, copied and kept in version control for ever, and so is everything that stands in them.

## Example

```xml
<launch>
  <node pkg="axis_camera" type="axis.py" name="camera">
    <param name="username" value="root"/>
    <param name="password" value="hunter2"/>
  </node>
</launch>
```

## Use instead

```xml
<launch>
  <node pkg="axis_camera" type="axis.py" name="camera">
    <param name="username" value="root"/>
    <param name="password" value="$(optenv CAMERA_PASSWORD)"/>
  </node>
</launch>
```
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from launchlint.finding import Finding, Location, Severity
from launchlint.rules.judging.secret_names import is_said_by_name, is_secret
from launchlint.rules.rule import Rule
from launchlint.rules.view import FileView, of_ros2
from launchlint.rules.wording import words_at
from launchlint.source import Place
from launchlint.syntax.tree import Attribute, Document, Element

RULE = Rule("LL509", "hard-coded-secret", Severity.WARNING)

_PLACEHOLDER = (
    r"(?is)<.*>|\{.*\}|%.*%|\[.*\]|(.)\1*|(?:your|my|the|some|enter|insert|put)[\W_].*|"
    r".*(?:change_?me|replace_?me|placeholder|example|dummy).*|"
    r"(?:none|null|nil|n/?a|todo|tbd|true|false|yes|no|on|off|unset|default|secret|token|pass|password|passwd|passphrase|"
    r"admin|guest|anonymous|public|demo|test|\W*)"
)
_DEFAULT = r"(?i)\b(?:default|factory|special)\b"
_FILE = r"(?s)[~.]*[/\\].*|[\w. /\\-]+\.[A-Za-z]{2,6}"
_USER = r"(?i)(?:^|[\W_])(?:user(?:[\W_]?name)?|login|account)$"
_MOST_BESIDE = 200


def check(view: FileView) -> Iterator[Finding]:
    """Look at every attribute that holds a value."""
    if of_ros2(view):
        yield from _ros2(view)
        return
    document = view.document
    for element in document.elements:
        tag = element.tag.lower()
        if tag == "machine":
            password = element.attributes.get("password")
            user = (element.get("user") or "").strip().lower()
            if password is not None and _is_literal(password) and password.value.strip().lower() != user:
                yield _finding(document, element, "password", f"the password of machine {element.get('name') or ''}".rstrip())
        elif tag in ("param", "arg", "env"):
            name = element.get("name") or ""
            if is_secret(name):
                for attribute in ("value", "default"):
                    said = is_said_by_name(element.get(attribute) or "", name)
                    if not said and _is_literal(element.attributes.get(attribute)) and not _is_known_word(element, attribute):
                        yield _finding(document, element, attribute, name.strip())


def _ros2(view: FileView) -> Iterator[Finding]:
    from launchlint.rules.judging.ros2_written import masked, values

    written = list(values(view))
    users = {(each.text.literal or "").strip().lower() for each in written if re.search(_USER, each.name) is not None}
    for kind, name, text in written:
        secret = text.literal
        if secret is None or not is_secret(name) or not _is_secret_value(secret) or secret.strip().lower() in users:
            continue
        if is_said_by_name(secret, name):
            continue
        variable = re.sub(r"\W+", "_", name).strip("_").upper()
        yield RULE.at_location(
            masked(text.place),
            f"{name.strip()} is written into the launch file",
            severity=Severity.INFO if kind == "arg" else None,
            label="a literal secret",
            help=f"read it from the environment, {words_at(text.place).call('env', variable)}, or from a file that is not published;"
            " and change it where it is in use",
            element=f"{kind} {name}",
            cause=f"{_digest(secret)}{' replaceable' * (kind == 'arg')}",
        )


def _is_literal(attribute: Attribute | None) -> bool:
    """Whether this looks like a real secret."""
    return attribute is not None and _is_secret_value(attribute.value)


def _is_secret_value(written: str) -> bool:
    value = written.strip()
    return "$" not in value and re.fullmatch(_PLACEHOLDER, value) is None and re.fullmatch(_FILE, value) is None


def _is_known_word(element: Element, attribute: str) -> bool:
    """Whether the secret is the name of the user that stands beside it: that protects nothing, and whoever set it knows."""
    secret = (element.get(attribute) or "").strip().lower()
    around = element.parent.children if element.parent is not None else ()
    return any(
        re.search(_USER, each.get("name") or "") is not None and secret == (each.get(name) or "").strip().lower()
        for each in around[:_MOST_BESIDE]
        if each.tag.lower() == element.tag.lower()
        for name in ("value", "default")
    )


def _finding(document: Document, element: Element, name: str, what: str) -> Finding:
    attribute = element.attributes[name]
    at = Location.of(Place(document.source, attribute.name_span))
    variable = re.sub(r"\W+", "_", element.get("name") or "").strip("_").upper() or "PASSWORD"
    if element.tag.lower() == "machine":
        help_ = "log in with an SSH key and leave the password out, and change it where it is in use"
    else:
        help_ = f"read it from the environment, $(env {variable}), or from a file that is not published; and change it where it is in use"
    replaceable = (element.tag.lower() == "arg" and name == "default") or _is_known(document, element)
    return RULE.at_location(
        _masked(at, attribute),
        f"{what} is written into the launch file",
        severity=Severity.INFO if replaceable else None,
        label="a literal secret",
        help=help_,
        element=f"{element.tag} {element.get('name') or ''} {name}",
        cause=f"{_digest(attribute.value)}{' replaceable' * replaceable}",
    )


def _digest(secret: str) -> str:
    """What tells one secret from another, in caches too, without giving it away."""
    from hashlib import sha256

    return sha256(secret.strip().encode("utf-8", "surrogatepass")).hexdigest()[:12]


def _is_known(document: Document, element: Element) -> bool:
    """Whether a comment in the same line says that this is what the maker has set."""
    source = document.source
    line = source.position(element.span.end).line
    return any(
        source.position(comment.span.start).line == line and re.search(_DEFAULT, comment.text) is not None for comment in document.comments
    )


def _masked(at: Location, attribute: Attribute) -> Location:
    """``at`` with asterisks for the secret in the line that is shown, so that reports and logs do not spread it."""
    line_start = at.start - (at.column - 1)
    start, end = attribute.value_span.start - line_start, attribute.value_span.end - line_start
    text = at.text
    return at._replace(text=text[:start] + "*" * (min(end, len(text)) - start) + text[end:] if start < len(text) else text)
