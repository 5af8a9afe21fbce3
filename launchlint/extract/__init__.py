"""Interfaces of nodes read from their source code, never by running or importing it.

Everything found is a :class:`~launchlint.extract.fact.Fact` with the place it was found at; :mod:`.package` makes a library of them.
"""
