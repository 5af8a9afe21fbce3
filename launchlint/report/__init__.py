"""Findings out: one file per output format; :mod:`launchlint.report.formats` finds them by name."""
