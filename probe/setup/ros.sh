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
    # Where nodes run nothing can be written: what is not compiled now is compiled by each of them anew.
    for setup in $(sh "${0%/*}/find.sh"); do
        python3 -m compileall -q "${setup%/setup.sh}"/lib/python3*/ >/dev/null 2>&1 || true
    done
else
    apt-get update -q
    # shellcheck disable=SC2086
    install $ROS_PACKAGES
fi
apt-get clean
