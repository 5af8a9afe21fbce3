"""What the packages of the checked workspaces say of their own programs: their sources, read when a launch file starts one of them.

:mod:`.own` is the door. :mod:`.entry` is what is known of one program and what that hangs on, :mod:`.reading` makes it of sources, and
:mod:`.store` keeps it.
"""
