"""What ``ros2 launch`` executes: the actions of a description, one after the other, in one context."""
