#!/bin/sh
# Prints the setup files of the ROS that is installed here, of any version: nothing where there is none but Debian's own.
for setup in /opt/ros/*/setup.sh /opt/ros/*/install/setup.sh /opt/*/setup.sh /opt/*/install/setup.sh; do
    directory=${setup%/setup.sh}
    if [ -f "$setup" ] && { [ -f "$directory/local_setup.sh" ] || [ -f "$directory/.catkin" ]; }; then echo "$setup"; fi
done
