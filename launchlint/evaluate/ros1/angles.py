"""``deg(…)`` and ``rad(…)`` in rosparam files (rosparam.construct_angle_degrees, construct_angle_radians)."""

from __future__ import annotations

import math

#: Names that rosparam's own module has: reached by an expression in ``rad(…)``, and nothing we look into.
_OF_ROSPARAM = frozenset(
    """Binary GLOBALNS NAME NS OptionParser RosParamException RosParamIOException base64 construct_angle_degrees
    construct_angle_radians construct_yaml_binary delete_param dump_params exprvalue get_param get_param_server
    get_ros_namespace list_params load_file load_str loader make_caller_id make_global_ns node ns_join os pattern
    print_function print_params re represent_foo represent_xml_binary rosgraph script_resolve_name set_param set_param_raw
    socket sys upload_params value yaml yamlmain""".split()
)


def degrees(text: str) -> float:
    """Radians of ``deg(…)``, or of the bare number behind ``!degrees``. Raises ValueError with plain words."""
    number = text.strip()[4:-1] if text.startswith("deg(") else text
    try:
        return float(number) * math.pi / 180.0
    except ValueError:
        raise ValueError(f"deg() wants one number, not {number[:60]!r}") from None


def radians(text: str) -> float:
    """Value of ``rad(…)``, or of what stands behind ``!radians``: an expression in which ``pi`` may be used.

    rosparam hands it to Python's ``eval``; here it is interpreted like ``$(eval …)``. Raises ValueError with plain words, and UnknownValue.
    """
    from launchlint.evaluate.ros1.expression import ExpressionError
    from launchlint.evaluate.ros1.expression.angle import angle

    expression = text.strip().replace("pi", "math.pi")
    if expression.startswith("rad("):
        expression = expression[4:-1]
    try:
        return angle(expression, _OF_ROSPARAM)
    except ExpressionError as error:
        raise ValueError(f"rad() wants an expression with numbers and pi: {error.message}") from None
