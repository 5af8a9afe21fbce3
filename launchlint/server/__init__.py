"""The language server: the protocol, documents, positions, and what is worked out when. The answers are those of :mod:`launchlint.ide`."""
