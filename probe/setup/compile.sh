#!/bin/sh
# Stands for the C++ compiler where ROS is Debian's: its libraries need C++17, and its Boost no longer puts _1, _2 … where ROS 1 code looks
# for them. What a package asks for in between is dropped.
for word do
    shift
    case $word in
        -std=*) ;;
        *) set -- "$@" "$word" ;;
    esac
done
extra="-std=gnu++17 -w"
if [ -f /usr/include/boost/bind.hpp ]; then extra="$extra -DBOOST_BIND_GLOBAL_PLACEHOLDERS -include boost/bind.hpp"; fi
case " $* " in
    *" -c "*) exec /usr/bin/c++ "$@" $extra ;;
    *) exec /usr/bin/c++ "$@" ;;
esac
