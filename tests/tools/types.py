"""Every struct, union and enum name of src/ is defined once (tools/house finds no other), and the
names of the handles of the public interface (src/murk.h, src/api) are taken by no type and no function elsewhere.
The program (src/app) uses the interface, and defines none of these names."""
import os
import re
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
with open(os.path.join(TOP, "src", "murk.h"), encoding="utf-8") as header:
    HANDLES = re.findall(r"^void murk_(\w+)_destroy\(murk_\1 \*\1\);", header.read(), re.M)
# A word in a comment or a string, such as the key murk_study, is not a name of the program.
TOKENS = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|(\bmurk_(?:%s)(?:_(?:create|read|destroy|set|get))?\b)"
                    % "|".join(HANDLES), re.S)


# A type that is defined, or a function: its name stands in a line that begins without a blank, before a body.
DEFINED = re.compile(r"\b(?:struct|union|enum)\s+(\w+)\s*\{|\}\s*(\w+)\s*;|^[a-z][\w\s*]*?\b(\w+)\([^;{}]*\)\s*\{", re.M)


def reserved_names(text):
    return [m[1] for m in TOKENS.finditer(text) if m[1]]


def defined_names(text):
    return [name for m in DEFINED.finditer(text) for name in m.groups() if name and TOKENS.fullmatch(name)]


assert len(HANDLES) >= 10, HANDLES  # the handles that interface 0.1 of murk.h has
assert defined_names("typedef struct murk_plan { int a; } murk_plan;\nint murk_scene_set(int x)\n{\n"
                     "    if (murk_fit_read(x)) {\n}}\nmurk_light *other(murk_scene *s)\n{\n") == \
    ["murk_plan", "murk_plan", "murk_scene_set"]


assert reserved_names("typedef struct murk_plan { int a; } murk_plan; murk_scene_set(x); /* murk_fit */") == \
    ["murk_plan", "murk_plan", "murk_scene_set"]
house = [sys.executable, os.path.join(TOP, "tools", "house"), "--list", "types"]
found = subprocess.run(house, capture_output=True, text=True, check=True).stdout
files = subprocess.run(["git", "ls-files", "src/*.c", "src/*.h", "src/*.cpp"], cwd=TOP, check=True, capture_output=True,
                       text=True).stdout.split()
for name in (f for f in files if f != "src/murk.h" and not f.startswith("src/api/")):
    path = os.path.join(TOP, name)
    if os.path.isfile(path):
        with open(path, encoding="utf-8") as f:
            text = f.read()
            for taken in defined_names(text) if name.startswith("src/app/") else reserved_names(text):
                found += f"{name}: {taken} is reserved for the public interface\n"
print(found, end="")
sys.exit(1 if found.strip() else 0)
