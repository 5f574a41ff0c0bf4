"""tools/check_words finds a place that breaks each rule, passes the same place put right, and finds
nothing in the repository."""
import importlib.machinery
import importlib.util
import os
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOOL = os.path.join(TOP, "tools", "check_words")
sys.path.insert(0, os.path.join(TOP, "tools"))
loader = importlib.machinery.SourceFileLoader("check_words", TOOL)
check_words = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_words", loader))
loader.exec_module(check_words)
from source_text import Source  # noqa: E402

GLOSSARY = check_words.Glossary("""
| term | meaning | do not write |
| --- | --- | --- |
| interface | boundary | `shell`, hull |
| tolerance | - | `in_plane_by` |
| minimum | - | `least` |

## Names that stay
| name | reason |
| --- | --- |
| `at_least`, `pnano_*` | contract |
""")
OPENING = "/* Sums the powers of all photons in fixed order, so that the sum repeats. */\n\n"
LONG = "static void f(void)\n{\n" + "    g();\n" * 25 + "}\n"


def found(text, name="src/room/name.c", **others):
    source = Source({name: OPENING + text, **{f"src/{room}/{room}.h": t for room, t in others.items()}})
    return [place.split(": ", 1)[1] for place in check_words.broken(source, ["room"], GLOSSARY)]


def expect(n, text, name="src/room/name.c", **others):
    places = found(text, name, **others)
    assert len(places) == n, (text, places)


# term: whole words of identifiers and file names; not strings, comments, includes or names that stay
expect(1, "int outer_shell;\n")
expect(1, "int murk_in_plane_by_m;\n")
expect(1, "#define SHELL_M (x + 1) /* reason */\n")
expect(1, "int a;\n", name="src/room/shell.c")
expect(0, "int shells, hull, plane_by;\n")
expect(0, "#include \"shell.h\"\n/* shell */ // shell\nconst char *t = \"shell\";\n")
expect(0, "int is_at_least, pnano_shell;\n")
expect(1, "int at_least_least;\n")
expect(1, "void f(void) { murk_shell(); }\n")
expect(1, "void f(void) { murk_shell(); }\n", other="void murk_shell(void);\n")
assert not check_words.broken(Source({"src/other/other.c": "int shell;\n"}), ["room"], GLOSSARY)

# opening
assert check_words.broken(Source({"src/room/a.c": "#include <a.h>\n" + OPENING}), ["room"], GLOSSARY)
assert check_words.broken(Source({"src/room/a.c": "/* Sums. */\n#include <a.h>\n"}), ["room"], GLOSSARY)
assert not check_words.broken(Source({"src/room/a.h": "int a;\n"}), ["room"], GLOSSARY)

# outline
expect(1, LONG)
expect(0, LONG.replace("    g();\n", "", 3))
expect(0, LONG.replace("    g();\n", "    /* Step 1. */\n", 1))

# constant: a reason beside it, above it or above its block
expect(1, "#define SIZE 64\n")
expect(1, "static const double EDGES[] = {\n    1, 2,\n};\n")
expect(1, "static const uint64_t N = UINT64_C(5);\n")
expect(1, "/* A reason of something else. */\n\n#define SIZE 64\n")
expect(1, "int a; /* not a reason */\n#define SIZE 64\n")
expect(0, "#define SIZE 64 /* bytes of a cache line */\n")
expect(0, "/* Bytes of a cache line and of a page. */\n#define SIZE 64\n#define PAGE 4096\n")
expect(0, "/* The rule's nodes. */\nstatic const double X[2] = {\n    -1, 1,\n};\n")
expect(0, "#define NAME_H\n#define TEXT \"64\"\n#define SQUARE(x) ((x) * (x))\n#define WIDTH (SIZE)\n")
expect(0, "static const char *const WORDS[] = {\"1\", \"2\"};\n")

# type: also in a room that is not asked for
expect(1, "", name="src/other/b.h", **{"room": "struct murk_a { int b; };\n", "third": "struct murk_a { int b; };\n"})

# tests: names, opening of sources and headers, outline


def expect_in_tests(n, text, name="tests/unit/room/test_a.c"):
    places = check_words.broken_in_tests(Source({name: text}), GLOSSARY)
    assert len(places) == n, (text, places)


expect_in_tests(1, OPENING + "static void test_a_shell(void);\n")
expect_in_tests(1, OPENING + "#define SHELL_M (x + 1)\n")
expect_in_tests(1, OPENING + "int a;\n", name="tests/physics/test_shell.c")
expect_in_tests(0, OPENING + "/* shell */ const char *t = \"shell\"; int shells, at_least;\n")
expect_in_tests(1, "int a;\n", name="tests/a.h")
expect_in_tests(1, OPENING + LONG)
expect_in_tests(0, OPENING + LONG.replace("    g();\n", "    /* Step 1. */\n", 1))

sys.exit(subprocess.run([sys.executable, "-B", TOOL]).returncode)
