"""Names the files of a result folder that are not as its main JSONs list them.

usage: whole.py DIR    (ends with 1 when there is one)

Such a file was edited, is of an earlier run, or is of a run that was killed while it wrote over another's results.
"""
import hashlib
import json
import pathlib
import sys

MAIN = ("plan.json", "coverage.json", "study.json", "follow.json", "fit.json", "predict.json", "ledger.json")


def strangers(folder):
    """Names that some main JSON lists and none with the checksum that the file has."""
    listed, roots = {}, {}
    for name in MAIN:
        try:
            root = roots[name] = json.loads((folder / name).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            continue  # not there; what cannot be read lists nothing
        for file, checksum in root.get("files", {}).items():
            listed.setdefault(file, set()).add(checksum)
        for file in root.get("run", {}).get("earlier", {}):
            listed.setdefault(file, set())  # of an earlier run
    # a ledger that is no trace's is of the run of one of the others
    ledger = roots.pop("ledger.json", {})
    of_others = [root.get("identity") for root in roots.values()]
    stray = "identity" in ledger and "files" not in ledger and ledger["identity"] not in of_others
    return stray * ["ledger.json"] + [name for name, sums in sorted(listed.items()) if (folder / name).is_file()
            and hashlib.sha256((folder / name).read_bytes()).hexdigest() not in sums]


def main():
    found = strangers(pathlib.Path(sys.argv[1]))
    for name in found:
        print(f"{name}: edited since, of an earlier run, or of a run that was killed while it wrote its results")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
