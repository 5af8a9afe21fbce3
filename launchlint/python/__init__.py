"""Python read and never run: an abstract interpreter that walks through syntax trees with values in hand.

Statements are followed one by one, both ways through every ``if``, with strings, lists, objects and functions as far as they are known;
the rest is unknown. What stands in modules that are not followed is up to a :class:`~launchlint.python.recogniser.Recogniser`, which is
passed to the :class:`~launchlint.python.interpreter.Interpreter`. Nothing is imported, compiled to code or executed.
"""
