"""The text of src/ as the tools measure it: files, comments, functions and type names.

tools/house prints measures of it, tools/check_words refuses places. The code of src/ is laid out by
clang-format, so that regular expressions and the first column of a line are enough to find comments,
functions and definitions."""
import os
import re
import subprocess

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LONG_FUNCTION = 25  # lines: a longer one has an outline in comments
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'", re.S)


def tracked(*patterns):
    out = subprocess.run(["git", "ls-files", "-z", "--", *patterns], cwd=TOP, check=True, capture_output=True).stdout
    return [n for n in out.decode().split("\0") if n and os.path.isfile(os.path.join(TOP, n))]


def read(name):
    with open(os.path.join(TOP, name), encoding="utf-8", errors="replace") as f:
        return f.read()


class Source:
    """The C and C++ files of src/, each read once; a test gives texts by name instead."""

    def __init__(self, text=None):
        self.text = text or {n: read(n) for n in tracked("src") if re.search(r"\.(c|h|cpp)$", n)}
        self.bare = {n: without_comments(t) for n, t in self.text.items()}


def without_comments(text):
    """The text with every comment blanked, so that line numbers stay; strings stay, too."""
    def blank(match):
        found = match.group()
        return re.sub(r"[^\n]", " ", found) if found[0] == "/" else found
    return COMMENT.sub(blank, text)


def comments_of(text):
    return " ".join(m.group() for m in COMMENT.finditer(text) if m.group()[0] == "/")


def room_of(name):
    return name.split("/")[1]


def repeated_types(source):
    places = {}
    for name, text in source.bare.items():
        for match in re.finditer(r"\b(?:struct|union|enum)\s+(\w+)\s*\{", text):
            places.setdefault(match.group(1), set()).add(name)
    return [f"{t}: {' '.join(sorted(where))}" for t, where in sorted(places.items())
            if len(where) > 1 and any(n.endswith(".h") for n in where)]


def functions(text):
    """(name, first line, last line, body) of each function of a file laid out by clang-format: the
    body stands between a `{` and a `}` in the first column."""
    lines, out, begin = text.split("\n"), [], None
    for i, line in enumerate(lines):
        if line == "{":
            begin = i
        elif line == "}" and begin is not None:
            head = begin
            while head > 0 and lines[head - 1].strip() and lines[head - 1][-1] not in ";}/":
                head -= 1
            name = re.search(r"(\w+)\s*\(", " ".join(lines[head:begin]))
            out.append((name.group(1) if name else "?", head + 1, i + 1, "\n".join(lines[begin:i + 1])))
            begin = None
    return out


def long_functions(source):
    """Names of the long functions without a comment, and the number of all long functions."""
    silent, all_long = [], 0
    for name, text in sorted(source.text.items()):
        for function, first, last, body in functions(text):
            if last - first + 1 > LONG_FUNCTION:
                all_long += 1
                if not comments_of(body).strip():
                    silent.append(f"{name}:{first}: {function}, {last - first + 1} lines")
    return silent, all_long


def without_opening(source):
    return [n for n, t in sorted(source.text.items()) if n.endswith(".c") and not t.lstrip().startswith("/*")]
