"""The files that a run has written, for tests that compare runs."""
import json
import os


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
