"""What a C++ program publishes, subscribes, serves, calls and reads, from its sources."""

from launchlint.extract.cpp.program import cpp_program

__all__ = ["cpp_program"]
