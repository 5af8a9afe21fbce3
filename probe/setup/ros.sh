#!/bin/sh
# Installs what every probe needs. Where the base image has ROS already (osrf/ros, ros:noetic, ros:jazzy …) only what is missing; else Debian's ROS.
set -eu
export DEBIAN_FRONTEND=noninteractive
install() { apt-get install -qy --no-install-recommends "$@"; }

if command -v update-ca-certificates >/dev/null; then update-ca-certificates >/dev/null 2>&1 || true; fi
if [ -n "$(sh "${0%/*}/find.sh")" ]; then
    missing=""
    for tool in python3 cmake make g++; do command -v "$tool" >/dev/null || missing="$missing $tool"; done
    if [ -n "$missing" ]; then
        apt-get update -q || echo "the package lists of this old image cannot be refreshed; going on without"
        # shellcheck disable=SC2086
        install $missing
    fi
else
    apt-get update -q
    # shellcheck disable=SC2086
    install $ROS_PACKAGES
fi
apt-get clean
