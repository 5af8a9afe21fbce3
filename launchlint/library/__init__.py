"""What nodes say and hear: the interface schema, reading, merging and looking up. ``bundled/`` is the library that launchlint ships.

A library is untrusted input: :mod:`.validate` is passed before anything else reads it. See ``docs/library-format.md``.
"""
