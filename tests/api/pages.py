"""doc/api is as tools/api_pages makes it of src/murk.h, and the tool finds a function without a
comment, without errors or without an example."""
import importlib.machinery
import importlib.util
import os
import subprocess
import sys

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TOOL = os.path.join(TOP, "tools", "api_pages")
loader = importlib.machinery.SourceFileLoader("api_pages", TOOL)
api_pages = importlib.util.module_from_spec(importlib.util.spec_from_loader("api_pages", loader))
loader.exec_module(api_pages)

HEADER = """/* A header.
 *
 * It has one section. */

/* ---- lamp ---- */

/* Makes a lamp of that power [W]. Fails with MURK_BAD_VALUE if it is negative. */
murk_status murk_lamp_create(murk_lamp **out, double power_w, murk_error *error);

/* Releases a lamp. */
void murk_lamp_destroy(murk_lamp *lamp);
"""
EXAMPLE = """int main(void)
{
    murk_lamp_create(&lamp, 1, &error);
    murk_lamp_destroy(lamp);
}

/* Prints:
 *
 * a line
 */
"""


def expect(n, header=HEADER, examples=None):
    found = api_pages.missing(header, examples or {"lamp": EXAMPLE})
    assert len(found) == n, found


expect(0)
expect(1, HEADER.replace(" Fails with MURK_BAD_VALUE if it is negative.", ""))
expect(1, HEADER.replace("/* Releases a lamp. */\n", "\n"))
expect(1, examples={"lamp": EXAMPLE.replace("    murk_lamp_destroy(lamp);\n", "")})
expect(1, examples={"lamp": EXAMPLE.replace("/* Prints:", "/* It prints:")})
expect(1, examples={"lamp": EXAMPLE, "moon": EXAMPLE})
page = api_pages.pages_of(HEADER, {"lamp": EXAMPLE})["doc/api/lamp.md"]
for part in ("### murk_lamp_create()", "Makes a lamp of that power [W].\n", "owns `*out` until",
             "**Errors:** Fails with `MURK_BAD_VALUE` if it is negative.", "a line\n```"):
    assert part in page, (part, page)
sys.exit(subprocess.run([TOOL, "--check"]).returncode)
