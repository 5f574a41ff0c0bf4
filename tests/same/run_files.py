"""The files that a run has written, for tests that compare runs."""
import csv
import io
import json
import os

# Columns of follow.csv that depend on the step that the same process made before, and are facts of the run.
OF_RUN = ("photons_traced", "photons_kept", "pairs_looked", "pairs_kept", "seconds")


def content(path):
    """The bytes of a file, of JSON without `run`."""
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".json"):
        fields = json.loads(data)
        fields.pop("run")
        data = json.dumps(fields).encode()
    return data


def files(folder):
    """The contents of all files below a folder, by their paths in it."""
    return {os.path.relpath(os.path.join(at, name), folder): content(os.path.join(at, name))
            for at, _, names in os.walk(folder) for name in names}


def differences(a, b):
    """The paths of files that one folder alone has, or whose contents differ."""
    a, b = files(a), files(b)
    return sorted(path for path in {**a, **b} if a.get(path) != b.get(path))


def files_of_steps(folder):
    """The contents of all files of murk follow, without the facts of the run."""
    found = files(folder)
    for path, data in found.items():
        if path == "follow.csv":
            rows = [{key: value for key, value in row.items() if key not in OF_RUN}
                    for row in csv.DictReader(io.StringIO(data.decode()))]
            found[path] = json.dumps(rows).encode()
        elif path == "follow.json":
            fields = json.loads(data)
            fields["files"].pop("follow.csv")
            for step in fields["steps"]:
                for key in OF_RUN:
                    step.pop(key)
            found[path] = json.dumps(fields).encode()
    return found
