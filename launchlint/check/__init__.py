"""The pipeline: entry files in, findings out; workers, cache, suppressions."""
