"""What a C++ program publishes, subscribes, serves, calls and reads, from its sources."""

from launchlint.extract.cpp.files import Trees
from launchlint.extract.cpp.program import cpp_program

__all__ = ["Trees", "cpp_program"]
