"""What attributes take, in plain words."""

from __future__ import annotations

EXPECTED = {
    "str": "one text",
    "bool": "true or false",
    "int": "a whole number",
    "float": "a number",
    "list_of_str": "a list of texts, such as [a, b]",
    "list_of_bool": "a list of true and false, such as [true, false]",
    "list_of_int": "a list of whole numbers, such as [1, 2]",
    "list_of_float": "a list of numbers with a point, such as [1.0, 2.5]",
    "yaml": "a text, a number, true, false, or a list of values of one type",
}
"""By the names that types have in ``type`` of ``<param>``."""
