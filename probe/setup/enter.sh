#!/bin/sh
# Runs a command in the environment of ROS and of the workspace.
here=${0%/*}
for setup in $(sh "$here/find.sh"); do
    # A file that is sourced cannot know where it is; without this it believes to be where it was made.
    export COLCON_CURRENT_PREFIX="${setup%/setup.sh}" AMENT_CURRENT_PREFIX="${setup%/setup.sh}"
    # shellcheck disable=SC1090
    . "$setup"
    unset COLCON_CURRENT_PREFIX AMENT_CURRENT_PREFIX
done
if [ -f /workspace/devel/setup.sh ]; then
    # shellcheck disable=SC1091
    . /workspace/devel/setup.sh
fi
if [ -d /workspace/install ] && [ -n "${AMENT_PREFIX_PATH:-}" ]; then
    export AMENT_PREFIX_PATH="/workspace/install:$AMENT_PREFIX_PATH" CMAKE_PREFIX_PATH="/workspace/install:${CMAKE_PREFIX_PATH:-}"
    export LD_LIBRARY_PATH="/workspace/install/lib:${LD_LIBRARY_PATH:-}" PATH="/workspace/install/bin:$PATH"
    for modules in /workspace/install/lib/python3*/site-packages /workspace/install/local/lib/python3*/dist-packages; do
        [ ! -d "$modules" ] || export PYTHONPATH="$modules:${PYTHONPATH:-}"
    done
fi
exec "$@"
