"""Who talks to whom: the names of a launch joined with what its nodes are known to do.

:func:`launchlint.graph.connect.connect` makes the connection graph of one launch, in plain values and without networkx, so that rules can
look at it in every check; :mod:`.topology` joins those of several configurations, :mod:`.multigraph` makes a networkx graph of that.
"""
