"""rospy: what Python programs publish, subscribe, serve, call and read, found by walking through their syntax trees with values in hand.

:func:`~launchlint.extract.python.program.python_program` is the way in. Nothing is imported or run: statements are followed one by one,
both ways through every ``if``, with strings, lists, objects and functions as far as they are known; the rest is unknown.
"""
