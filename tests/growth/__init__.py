"""How the work grows with what launchlint is given: each construct of a launch file, from few to very many.

:mod:`tests.growth.ros1` and :mod:`tests.growth.ros2` make workspaces of any size in which one construct is repeated;
:mod:`tests.growth.work` counts what a command does with them. :mod:`tests.growth.test_growth` holds every construct to
linear growth; ``python -m tests.bench.growth`` does the same for processor time and memory, to 100,000 of each.
"""
