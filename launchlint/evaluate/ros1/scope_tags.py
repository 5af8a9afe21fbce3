"""What several tags share: ``ns`` and ``clear_params``, command lines, and what a ``<remap>`` or ``<env>`` says, wherever it stands."""

from __future__ import annotations

from launchlint.evaluate.block import Value
from launchlint.evaluate.names import UNKNOWN_NAMESPACE, canonical, child_namespace, is_legal, is_portable, join
from launchlint.evaluate.problems import DoubledSlash, InvalidNamespace, InvalidRemapName, UnbalancedQuotes
from launchlint.evaluate.ros1.file import FileEvaluation
from launchlint.evaluate.ros1.scope import Context
from launchlint.model import EnvironmentSetting, Remap, Unknown
from launchlint.source import Origin
from launchlint.syntax.ros1.problems import conflicting_attributes
from launchlint.syntax.ros1.substitutions import parts_of
from launchlint.syntax.tree import Element
from launchlint.words import split_words


def scope_namespace(file: FileEvaluation, element: Element, context: Context) -> tuple[str, bool | None]:
    """The namespace that ``ns`` opens, and whether ``ns`` is there, None where its value is unknown
    (roslaunch.xmlloader._ns_clear_params_attr). Which one is meant by a value that roslaunch refuses, nobody knows either.
    """
    attribute = element.attributes.get("ns")
    if attribute is None:
        return context.namespace, False
    value, reads = file.traced(lambda: file.value(attribute, context))
    if isinstance(value, Unknown):
        return join(context.namespace, UNKNOWN_NAMESPACE) + "/", None
    if not value:
        file.record(conflicting_attributes(file.document, element, "empty-ns", ("ns",), environment=file.from_environment(reads)))
        return join(context.namespace, UNKNOWN_NAMESPACE) + "/", None
    file.spend_characters(len(context.namespace) + len(value), attribute.value_span)
    try:
        namespace = child_namespace(context.namespace, value)
    except ValueError:
        file.record(InvalidNamespace(origin=file.at(attribute.value_span), refused=True, namespace=value, private=True))
        return join(context.namespace, UNKNOWN_NAMESPACE) + "/", True
    if not (is_legal(value) and is_portable(value)) and "//" not in value:
        file.record(InvalidNamespace(origin=file.at(attribute.value_span), namespace=value, private=False))
    return namespace, True


def clear_without_namespace(file: FileEvaluation, element: Element) -> None:
    """Record ``clear_params`` on a group or include that has no ``ns``."""
    file.record(conflicting_attributes(file.document, element, "clear-params-without-ns", ("clear_params",)))


def remap(file: FileEvaluation, element: Element, context: Context) -> Remap | None:
    """The rule of a ``<remap>``; None, with a problem, where roslaunch refuses it (roslaunch.loader.LoaderContext.add_remap).

    Where a name in it is unknown, so is the whole rule: then its ``source`` is empty, and its ``patterns`` are what is known.
    """
    origin = Origin(file.place(element.start_span))
    names: list[str] = []
    values: list[Value] = [file.required(element, attribute, context) for attribute in ("from", "to")]
    for attribute, value in zip(("from", "to"), values, strict=True):
        written = element.attributes.get(attribute)
        if written is not None and "//" in written.value and parts_of(written).expression is None:
            start = written.value.index("//")
            end = start + len(written.value[start:]) - len(written.value[start:].lstrip("/"))
            file.record(DoubledSlash(origin=file.at(written.span_of(start, end)), attribute=attribute, value=written.value))
        if written is None or isinstance(value, Unknown):
            continue
        name = canonical(value)
        if name and is_legal(name):
            names.append(name)
        else:
            file.record(InvalidRemapName(origin=file.at(written.value_or_name_span), refused=True, attribute=attribute, value=value,
                                         reason="illegal" if name else "empty"))  # fmt: skip
    if any(isinstance(value, Unknown) for value in values):
        source, target = (value.pattern if isinstance(value, Unknown) else canonical(value) for value in values)
        return Remap("", "", origin, (source, target))
    return Remap(names[0], names[1], origin) if len(names) == 2 else None


def env(file: FileEvaluation, element: Element, context: Context) -> EnvironmentSetting | None:
    """The setting of an ``<env>`` (roslaunch.loader.Loader.load_env)."""
    name, value = file.required(element, "name", context), file.required(element, "value", context)
    if name == "":
        file.invalid(element, "name", "", "a name")
        return None
    if isinstance(name, Unknown) or isinstance(value, Unknown):
        return None
    return EnvironmentSetting(name, value, Origin(file.place(element.start_span)))


def check_quotes(file: FileEvaluation, element: Element, attribute: str, text: str) -> None:
    """Record quotes that do not match: roslaunch splits the resolved ``text`` as a shell does.

    It splits ``args`` and ``launch-prefix`` when it starts the node (roslaunch.node_args.create_local_process_args), the ``command`` of a
    param when it loads the file (roslaunch.loader.Loader.param_value).
    """
    if not any(char in text for char in "'\"\\"):
        return
    try:
        split_words(text)
    except ValueError as error:
        origin = file.at(element.attributes[attribute].value_span)
        file.record(UnbalancedQuotes(origin=origin, refused=True, attribute=attribute, reason=str(error).lower()))
