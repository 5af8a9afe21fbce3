from setuptools import setup

setup(
    name="probe_teller",
    version="2.1.0",
    packages=["probe_teller"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/probe_teller"]), ("share/probe_teller", ["package.xml"])],
    entry_points={"console_scripts": ["teller = probe_teller.main:main"]},
)
