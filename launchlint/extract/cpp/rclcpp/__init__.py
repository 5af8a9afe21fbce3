"""What rclcpp and the packages around it offer to programs, as tables for the machine."""
