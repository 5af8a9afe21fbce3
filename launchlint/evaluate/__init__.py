"""Launch semantics: scopes, args, substitutions, includes, namespaces and params become a :mod:`launchlint.model`."""
