#!/usr/bin/env python3
"""The man pages: every command, option, scene key, result file, JSON key and
CSV column is in one, the examples in them run, and mandoc and man find nothing
to warn of (each where it is installed). Standard library only.
usage: pages.py MURK MAN-FOLDER
"""

import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

MURK, FOLDER = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
failures = 0


def check(holds, text):
    global failures
    if not holds:
        print("pages.py:", text)
        failures += 1


def run(*words, **more):
    return subprocess.run(words, capture_output=True, text=True, **more)


def plain(roff):
    """What a page says: without fonts and escapes."""
    text = re.sub(r"\\f[BIR]", "", roff)
    text = re.sub(r"^\.(TP|PP|nf|fi|RS.*|RE|ad l|nh)\n", "", text, flags=re.M)
    text = re.sub(r"^\.(?:BR|SH|SS|IP) ?", "", text, flags=re.M)
    return text.replace("\\-", "-").replace("\\e", "\\").replace("\\&", "")


def says(page, word):
    return re.search(r"(?<![A-Za-z0-9_])" + re.escape(word) + r"(?![A-Za-z0-9_])", page)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def strings_of(path):
    """Adjacent C strings joined."""
    return re.sub(r'"\s*\n\s*"', "", text_of(path))


pages = {os.path.basename(p): text_of(p) for p in glob.glob(FOLDER + "/man?/*")}
said = {name: plain(text) for name, text in pages.items()}
commands = re.findall(r'^    \{"([a-z]+)",', text_of("src/app/commands.c"), re.M)
check(len(commands) >= 10, "no commands found")


def check_installed():
    listed = text_of(os.path.join(FOLDER, "..", "cmake_install.cmake"))
    for path in sorted(glob.glob(FOLDER + "/man?/*")):
        check(f'"{path}"' in listed, path + " is not installed")
    # murk-mpi(1) is made with MURK_MPI alone
    sources = [page for page in glob.glob("doc/man/*.md") if not page.endswith("/murk-mpi.1.md") or "murk-mpi.1" in pages]
    check(len(pages) == len(commands) + 1 + len(sources),
          f"{len(pages)} pages")


def check_headings():
    """The sections that each page begins with; those of formats of files have no synopsis."""
    for name, page in pages.items():
        first = ["NAME", "SYNOPSIS", "DESCRIPTION"] if not name.endswith(".5") else ["NAME", "DESCRIPTION"]
        found = re.findall(r'^\.SH "?([^"\n]*)', page, re.M)
        check(found[:len(first)] == first and found[-1] == "SEE ALSO", f"{name}: sections {found}")


def check_warnings():
    for path in sorted(glob.glob(FOLDER + "/man?/*")):
        name = os.path.basename(path)
        if shutil.which("mandoc"):
            done = run("mandoc", "-Tlint", "-Wwarning", path)
            check(done.returncode == 0 and not done.stdout, name + ": " + done.stdout[:300])
        if shutil.which("man") and shutil.which("groff"):
            done = run("man", "-l", "--warnings", "-Tutf8", path,
                       env=dict(os.environ, MANWIDTH="80", LC_ALL="C.UTF-8"))
            check(done.returncode == 0 and not done.stderr, name + ": " + done.stderr[:300])
    for tool in ("mandoc", "groff"):
        if not shutil.which(tool):
            print("not checked: no", tool)


def check_commands_and_options():
    for command in commands:
        name = f"murk-{command}.1"
        check(name in pages, "no page " + name)
        page, help_text = said.get(name, ""), run(MURK, command, "--help").stdout
        words = " ".join(page.split())
        options = re.findall(r"^  ((?:-\w, )?--[a-z-]+(?: \S+)?)\s+(.*(?:\n {24}.*)*)",
                             help_text, re.M)
        begun = len(re.findall(r"^  (?:-\w, )?--", help_text, re.M))
        check(len(options) == begun >= 8,
              f"{command}: {len(options)} of {begun} options in --help can be read")
        for option, meaning in options:
            check(option + " " + " ".join(meaning.split()) in words,
                  f"{name}: {option} is not as --help has it")
        check(f"murk-{command}(1)" in said["murk.1"].replace(" (1)", "(1)"),
              "murk.1 does not name " + name)
        for see in re.findall(r"^\.BR (\S+) \((\d)\)", pages.get(name, ""), re.M):
            other = see[0].replace("\\-", "-") + "." + see[1]
            check(other in pages, f"{name} names {other}, which there is not")


def check_keys():
    page = said["murk-scene.5"]
    text = "".join(text_of(page) for page in re.findall(r"include (doc/reference/\S+\.md)", text_of("doc/man/murk-scene.5.md")))
    keys = set(re.findall(r"^\| `([a-z0-9_]+)` \|", text, re.M))
    check(len(keys) > 100, "few keys found")
    for key in keys:
        check(re.search("^" + key + ": ", page, re.M) or says(page, key),
              "murk-scene(5) lacks " + key)
    words = set(re.findall(r'^    X\([^,]*, *"?([a-z0-9_]+)', text_of("src/preset/words.h"), re.M))
    for word in words:
        check(says(page, word.lower()) or word.isupper(), "murk-scene(5) lacks " + word)


def check_results():
    page = said["murk-results.5"]
    everywhere = "\n".join(said.values())
    n_files = n_keys = n_columns = 0
    for path in sorted(glob.glob("src/app/*.c") + glob.glob("src/results/*.c") + glob.glob("src/cases/sweep*.c")):
        if path == "src/app/command_schema.c": # the words of JSON Schema, which golden/schema checks
            continue
        source = strings_of(path)
        for name in re.findall(
                r'"([a-z_]+\.(?:json|csv|ply|vdb|vti|vtp|txt|lp|murk|html))"', source):
            n_files += 1
            check(name in page, f"murk-results(5) lacks the file {name} ({path})")
        for key in re.findall(r'(?:murk_json_\w+|cJSON_Add\w+ToObject|add_\w+)\(\s*'
                              r'[^,()]+(?:\([^)]*\))?,\s*"([A-Za-z0-9_]+)"', source):
            n_keys += 1
            check(says(page, key), f"murk-results(5) lacks the key {key} ({path})")
        for header in re.findall(r'"([a-z0-9_]+(?:,[a-z0-9_]+){3,})', source):
            for column in header.split(","):
                n_columns += 1
                check(says(everywhere, column), f"no page has the column {column} ({path})")
    # the table of result fields, which the page includes
    kind = None
    for row in text_of(os.path.join(FOLDER, "..", "generated", "fields.md")).splitlines():
        kind = row.split()[1] if re.match(r"\| (key|column) \|", row) else kind
        name = re.match(r"\| `([^`]+)` \| (.+) \|$", row)
        if not name:
            continue
        n_keys += kind == "key"
        n_columns += kind == "column"
        last = name[1].split(".")[-1]
        check(says(page, last) and name[2].split(" (")[0] in " ".join(page.split()),
              f"murk-results(5) lacks the {kind} {name[1]}")
    check(n_files > 15 and n_keys > 250 and n_columns > 30,
          f"{n_files} files, {n_keys} keys, {n_columns} columns found")


def check_examples():
    """As written, but for so few photons that they take no time."""
    less = {"place": " --emit 500 --set placement.restarts=1 --set placement.nodes=0",
            "trace": " --emit 500", "sense": " --emit 500", "study": " --emit 50",
            "render": " --emit 500 --set cameras.0.pixels=[8,6] --set cameras.0.samples=2",
            "fit": " --emit 2000 --traces 1"}
    n = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in ("scenes", "media"):
            os.symlink(os.path.abspath(name), os.path.join(folder, name))
        # what later ones read, earlier ones have left in out/
        for command in ["check", "trace", "place", "sense", "report", "render", "study", "fit",
                        "replay", "media", "help", "schema", "init"]:
            page = said[f"murk-{command}.1"]
            lines = re.findall(r"^murk .*$", page.split("\nEXAMPLES\n")[-1], re.M)
            for line in (l for l in lines if "(1)" not in l):
                n += 1
                wanted = line.split()[1]
                change = "" if "--matrix" in line else less.get(wanted, "")
                if line.endswith("calibrated.yaml"):
                    change += " -q"
                done = run("sh", "-c", shlex.quote(MURK) + line[4:] + change, cwd=folder)
                check(done.returncode == 0, f"{line}: {done.returncode} {done.stderr[-300:]}")
    check(n >= 15, f"{n} examples found")


check_installed()
check_headings()
check_warnings()
check_commands_and_options()
check_keys()
check_results()
check_examples()
print(f"{len(pages)} pages" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
