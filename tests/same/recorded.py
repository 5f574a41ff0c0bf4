#!/usr/bin/env python3
"""The program writes today what it wrote when the table was recorded.

Each case of recorded/cases.txt is a list of murk commands over small inputs.
recorded/TABLE.txt holds, for every command, a checksum of what it prints, and
a checksum of every file that it writes. In texts, what belongs to one run alone
is left out (times, memory, folder, date, program version, checksums of other
files), and numbers are rounded to 6 digits, so that a last bit of a sum does
not count. Other tests say what is right; this one says what has changed. A
line of the table changes only together with a reason in CHANGELOG.md.

The path of a photon may turn on the last bit of a sine, and these bits belong
to the processor: the C library and Embree choose their routines by it. On a
processor with other last bits than those in the table's first line, the test
is skipped.

    recorded.py MURK CASE            compare with the table
    recorded.py --list               the names of the cases
    recorded.py MURK --update [CASE...]
                                     record these cases (all) anew
    recorded.py MURK --keep DIR [CASE...]
                                     run these cases (all) and keep, in DIR,
                                     the texts and files that are compared
    recorded.py --differences A B    the files in which two kept folders differ,
                                     and by how much their numbers do
"""
import base64
import ctypes
import hashlib
import json
import os
import re
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "recorded")
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TABLE, CASES = os.path.join(HERE, "TABLE.txt"), os.path.join(HERE, "cases.txt")
SKIPPED = 77
SECONDS_MAX = 300  # of one command: a guard against one that hangs
DIGITS = 6         # of a number in a text

# What belongs to one run in printed texts and in pages.
ONE_RUN = [
    # the summary's paragraph of times and memory, up to the next paragraph
    (re.compile(r"^time {2,}.*\n(?: .*\n)*", re.M), ""),
    (re.compile(r'<th scope="row">(made on|threads|most memory at once|time)</th><td class="text">[^<]*</td>'), "RUN"),
    (re.compile(r"\b[0-9a-f]{64}\b|sha256-[A-Za-z0-9+/]{43}="), "CHECKSUM"),
    # sizes of files, which hold times and the commit
    (re.compile(r'(<th scope="row">[\w.-]+\.\w+</th><td>)\d+'), r"\1SIZE"),
    # a difference of two nearly equal costs, which consists of their last bits
    (re.compile(r"(cost_change\|/cost:\s+)\S+"), r"\1CHANGE"),
    (re.compile(r"\b(?:gcc|clang) \d+\.\d+\.\d+ ?"), "COMPILER"),
    # the date and the program version of a manual page
    (re.compile(r'^(\.TH \S+ 1) [\d-]+ "murk [\d.]+"', re.M), r"\1"),
    # the bundled script and style, which are sources and not results
    (re.compile(r"<(script|style)(?: type=\"module\")?>.*?</\1>", re.S), ""),
    (re.compile(r"\x1b\[[0-9;]*m"), ""),
    # a picture in a page: its pixels count, its texts name the commit
    (re.compile(r"data:image/png;base64,([\w+/=]+)"),
     lambda found: hashlib.sha256(png_data(base64.b64decode(found.group(1)))).hexdigest()[:16]),
]
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.\d*|\.\d+|\d+)(?:[eE][-+]?\d+)?(?![\w.])")


def rounded(match):
    text = match.group()
    if re.fullmatch(r"[-+]?\d+", text):
        return text  # counts are exact
    return f"{float(text):.{DIGITS - 1}e}"


def without_run(value):
    """A JSON result without what belongs to one run."""
    for key in ("run", "murk", "identity", "files"):
        if isinstance(value, dict):
            value.pop(key, None)
    return value


def json_text(data):
    return json.dumps(without_run(json.loads(data)), indent=1).encode()


def plain_text(data, folder):
    """A text as it is compared."""
    text = data.decode("utf-8", "replace").replace(folder, "FOLDER")
    for pattern, instead in ONE_RUN:
        text = pattern.sub(instead, text)
    return NUMBER.sub(rounded, text)


def comparable(path, folder, commit):
    """The bytes of a result file that are compared."""
    with open(path, "rb") as f:
        data = f.read()
    data = BINARY.get(data[:4], lambda bytes: bytes)(data)
    data = without_commit(data, commit)
    if path.endswith(".json"):
        data = json_text(data)
    if path.endswith((".json", ".html", ".csv", ".yaml", ".lp", ".txt")):
        return plain_text(data, folder).encode()
    return data


def exr_data(data):
    """The chunks of an OpenEXR file: its header, which names the program, ends before the table of their
    places, whose first entry is where the first chunk stands."""
    at = 8
    while data[at]:
        name_end = data.index(b"\0", at)
        type_end = data.index(b"\0", name_end + 1)
        size, = struct.unpack_from("<I", data, type_end + 1)
        at = type_end + 5 + size
    first, = struct.unpack_from("<Q", data, at + 1)
    return data[first:]


def png_data(data):
    """Size and pixels of a PNG, without its texts."""
    at, filtered = 8, b""
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        if data[at + 4:at + 8] in (b"IHDR", b"IDAT"):
            filtered += data[at + 4:at + 8 + size]
        at += 12 + size
    return filtered


def vdb_data(data):
    """The grids of an OpenVDB file with their names, without the file's own metadata and the places that
    they stand at."""
    at = 8 + 4 + 4 + 4 + 1 + 36  # magic, versions, flag, identifier

    def text():
        nonlocal at
        size, = struct.unpack_from("<I", data, at)
        at += 4 + size
        return data[at - size:at]

    entries, = struct.unpack_from("<I", data, at)
    at += 4
    for _ in range(entries):
        text(), text(), text()
    grids, = struct.unpack_from("<I", data, at)
    at += 4
    filtered = b""
    for _ in range(grids):
        filtered += text() + text()
        text()
        first, _, end = struct.unpack_from("<3q", data, at)
        filtered += data[first:end]
        at = end
    return filtered


def without_commit(data, commit):
    """The bytes without the commit that the program was built from, be it text, text behind its length
    in four bytes, or the codes of its characters."""
    text = commit.encode()
    return (data.replace(struct.pack("<I", len(text)) + text, b"COMMIT").replace(text, b"COMMIT")
            .replace(" ".join(str(c) for c in text).encode(), b"COMMIT"))


# By the first bytes of a file, as a picture may have any name.
BINARY = {b"\x76\x2f\x31\x01": exr_data, b"\x89PNG": png_data, b" BDV": vdb_data}


def read_cases():
    cases, name = {}, None
    with open(CASES, encoding="utf-8") as f:
        for line in f:
            if not line.strip() or line.startswith("#"):
                continue
            if not line[0].isspace():
                name = line.strip()
                cases[name] = []
            else:
                cases[name].append(shlex.split(line))
    return cases


def commit_of(murk):
    """What the program says that it was built from."""
    version = subprocess.run([murk, "--version"], capture_output=True, text=True, check=True).stdout
    return re.search(r"commit ([^,]+),", version).group(1)


def run_case(murk, commands, folder=None):
    """{what: checksum} of all that the commands print and write."""
    work = tempfile.mkdtemp(prefix="murk-recorded-")
    try:
        os.chmod(work, 0o700)
        for name in ("scenes", "media"):
            shutil.copytree(os.path.join(TOP, name), os.path.join(work, name))
        shutil.copytree(os.path.join(HERE, "scenes"), os.path.join(work, "small"))
        inputs = {os.path.join(at, n) for at, _, names in os.walk(work) for n in names}
        found = {}
        commit = commit_of(murk)

        def keep(what, data):
            found[what] = hashlib.sha256(data).hexdigest()[:16]
            if folder:
                path = os.path.join(folder, what.replace(" ", "-"))
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "wb") as f:
                    f.write(data)

        environment = dict(os.environ, COLUMNS="80", LC_ALL="C", TZ="UTC", TERM="dumb")
        for i, command in enumerate(commands, 1):
            ended = subprocess.run([murk] + command[1:], cwd=work, env=environment, stdin=subprocess.DEVNULL,
                                   capture_output=True, timeout=SECONDS_MAX)
            printed = ended.stdout
            if printed.startswith(b"{"):
                printed = json_text(printed)
            said = f"exit {ended.returncode}\n".encode() + printed + b"\n" + ended.stderr
            keep(f"printed.{i}", plain_text(said, work).encode())
        for at, _, names in sorted(os.walk(work)):
            if os.path.basename(at) == "rows":
                continue  # what a study resumes from: its names hold the version of murk
            for name in sorted(names):
                path = os.path.join(at, name)
                if path not in inputs:
                    keep(os.path.relpath(path, work), comparable(path, work, commit))
        return found
    finally:
        shutil.rmtree(work)


def last_bits():
    """A checksum of the last bits of the C library's functions on this processor, and of the vector
    instructions by which Embree chooses its routines."""
    libm = ctypes.CDLL("libm.so.6")
    digest = hashlib.sha256()
    for name in ("sin", "cos", "tan", "atan", "exp", "log", "asin", "acos"):
        function = getattr(libm, name)
        function.restype, function.argtypes = ctypes.c_double, [ctypes.c_double]
        for i in range(1000):
            digest.update(float(function((i + 0.5) / 1000)).hex().encode())
    with open("/proc/cpuinfo", encoding="utf-8") as f:
        flags = set(re.search(r"^flags\s*:(.*)$", f.read(), re.M).group(1).split())
    digest.update(" ".join(sorted(flags & {"avx", "avx2", "fma", "avx512f", "avx512vl"})).encode())
    return digest.hexdigest()[:16]


def read_table():
    """(last bits, {case: {what: checksum}})"""
    table, bits = {}, None
    if os.path.exists(TABLE):
        with open(TABLE, encoding="utf-8") as f:
            bits = f.readline().split()[-1]
            for line in f:
                case, checksum, what = line.rstrip("\n").split(" ", 2)
                table.setdefault(case, {})[what] = checksum
    return bits, table


def write_table(bits, table):
    with open(TABLE, "w", encoding="utf-8") as f:
        f.write(f"# case, checksum, what; recorded where the last bits are {bits}\n")
        for case in sorted(table):
            for what in sorted(table[case]):
                f.write(f"{case} {table[case][what]} {what}\n")


def differences(a, b):
    """Names the files in which two kept folders differ, with their largest relative difference."""
    names = sorted({os.path.relpath(os.path.join(at, n), top) for top in (a, b)
                    for at, _, files in os.walk(top) for n in files})
    different = 0
    for name in names:
        paths = [os.path.join(top, name) for top in (a, b)]
        if not all(os.path.exists(p) for p in paths):
            print(f"{name}: only in {a if os.path.exists(paths[0]) else b}")
            different += 1
            continue
        data = [open(p, "rb").read() for p in paths]
        if data[0] == data[1]:
            continue
        different += 1
        texts = [d.decode("utf-8", "replace") for d in data]
        numbers = [[float(x) for x in NUMBER.findall(t)] for t in texts]
        if NUMBER.sub("#", texts[0]) == NUMBER.sub("#", texts[1]):
            largest = max(abs(x - y) / max(abs(x), abs(y)) for x, y in zip(*numbers) if x != y)
            print(f"{name}: numbers differ by {largest:.2g} at most")
        else:
            print(f"{name}: differs")
    print(f"{different} of {len(names)} files differ")
    return different > 0


def main():
    if sys.argv[1:] == ["--list"]:
        print("\n".join(read_cases()))
        return 0
    if sys.argv[1:2] == ["--differences"] and len(sys.argv) == 4:
        return differences(sys.argv[2], sys.argv[3])
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    murk, words = os.path.abspath(sys.argv[1]), sys.argv[2:]
    cases, (bits, table) = read_cases(), read_table()
    if words[0] in ("--update", "--keep"):
        folder = os.path.abspath(words[1]) if words[0] == "--keep" else None
        chosen = words[2 if folder else 1:] or list(cases)
        for name in chosen:
            found = run_case(murk, cases[name], folder and os.path.join(folder, name))
            print(f"{name}: {len(found)} texts and files", flush=True)
            if not folder:
                again = run_case(murk, cases[name])
                if again != found:
                    other = [w for w in found if again.get(w) != found[w]]
                    sys.exit(f"{name}: a second run is not equal ({', '.join(other)}): not recorded")
                table[name] = found
                write_table(last_bits(), {n: t for n, t in table.items() if n in cases})
        return 0
    name = words[0]
    if bits != last_bits():
        print("skipped: the table was recorded on a processor with other last bits")
        return SKIPPED
    if commit_of(murk) == "unknown":
        print("skipped: the program does not know its commit, which results name")
        return SKIPPED
    found = run_case(murk, cases[name])
    wanted = table.get(name, {})
    wrong = sorted(w for w in wanted.keys() | found.keys() if wanted.get(w) != found.get(w))
    for what in wrong:
        print(f"{name}: {what}: " + ("is not in the table" if what not in wanted else
                                     "is missing" if what not in found else "differs from the table"))
    if not found:
        print(f"{name}: nothing was compared")
    if wrong:
        print("To see how: recorded.py MURK --keep A of the commit that recorded it, --keep B of this one, "
              "--differences A B")
    return 1 if wrong or not found else 0


if __name__ == "__main__":
    sys.exit(main())
