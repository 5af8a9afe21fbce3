#!/bin/sh
# Runs a command in the environment of ROS and of the workspace.
for setup in /opt/ros/*/setup.sh; do
    # shellcheck disable=SC1090
    [ ! -f "$setup" ] || . "$setup"
done
if [ -f /workspace/devel/setup.sh ]; then
    # shellcheck disable=SC1091
    . /workspace/devel/setup.sh
fi
exec "$@"
