"""Stands between the probe and its observer: ``ros2_observer.py record|replay RECORDING COUNT OBSERVER``.

A recording has a line for each graph that the observer told, with the commands before it that may have changed the graph, and one for each
command and its answer, of each run one after the other. ``COUNT`` is a file that knows how many runs there have been. When it is replayed,
time does not matter: a graph comes as soon as those commands have come.
"""

import json
import subprocess
import sys
import threading
import time

CHANGES = ("load", "state", "serve", "send")


def name(command):
    """What a command is, whenever it is given."""
    return json.dumps({key: value for key, value in command.items() if key != "id"}, sort_keys=True)


def number_of(path):
    try:
        with open(path) as file:
            number = int(file.read()) + 1
    except FileNotFoundError:
        number = 1
    with open(path, "w") as file:
        file.write(str(number))
    return number


def record(recording, run, observer):
    process = subprocess.Popen(["/usr/bin/python3", observer], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    asked = {}
    changing = []

    def relay():
        for line in process.stdout:
            said = json.loads(line)
            with open(recording, "a") as file:
                if "graph" in said:
                    file.write(json.dumps({"run": run, "after": list(changing), "graph": said["graph"]}) + "\n")
                elif "answer" in said:
                    command = asked[said.pop("answer")]
                    file.write(json.dumps({"run": run, "command": name(command), "said": said}) + "\n")
            sys.stdout.buffer.write(line)
            sys.stdout.buffer.flush()

    threading.Thread(target=relay, daemon=True).start()
    for line in sys.stdin.buffer:
        command = json.loads(line)
        asked[command["id"]] = command
        if command["do"] in CHANGES:
            changing.append(name(command))
        process.stdin.write(line)
        process.stdin.flush()


def replay(recording, run):
    with open(recording) as file:
        known = [each for each in map(json.loads, file) if each["run"] == run]
    graphs = [each for each in known if "graph" in each]
    answers = [each for each in known if "said" in each]
    come = []

    def say(what):
        sys.stdout.write(json.dumps(what) + "\n")
        sys.stdout.flush()

    def tell_graphs():
        for each in graphs:
            while not all(command in come for command in each["after"]):
                time.sleep(0.02)
            say({"graph": each["graph"]})

    say({"ready": True})
    threading.Thread(target=tell_graphs, daemon=True).start()
    for line in sys.stdin:
        command = json.loads(line)
        same = [each for each in answers if each["command"] == name(command)]
        if len(same) > 1:
            answers.remove(same[0])
        say(dict(same[0]["said"] if same else {}, answer=command["id"]))
        come.append(name(command))


if __name__ == "__main__":
    mode, where, count, *rest = sys.argv[1:]
    if mode == "record":
        record(where, number_of(count), rest[0])
    else:
        replay(where, number_of(count))
