"""Rules about what only ROS 2 has, and what the rules of both say of it."""
