"""Python expressions in launch files, computed without letting them do anything: the language, for every dialect.

A small interpreter walks the tree of an expression: it knows the harmless part of Python, counts every step and every character it would
produce, and gives up with :class:`~launchlint.evaluate.expression.errors.UnknownValue` before anything gets large. Which names there are
is the dialect's: :mod:`launchlint.evaluate.ros1.expression`, :mod:`launchlint.evaluate.ros2.expression`.
"""
