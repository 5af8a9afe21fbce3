"""Read by catkin_python_setup() in CMakeLists.txt; not meant to be run by hand."""

from catkin_pkg.python_setup import generate_distutils_setup
from setuptools import setup

setup(**generate_distutils_setup(packages=["turtle_parade"], package_dir={"": "src"}))
