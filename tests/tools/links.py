#!/usr/bin/env python3
"""tools/check_links: all links of the Markdown files lead somewhere, and planted
wrong links and anchors are found, in Markdown and in HTML. Standard library only.
usage: links.py
"""

import os
import subprocess
import sys
import tempfile

failures = 0

# Files, then the lines that must be printed.
MARKDOWN = {
    "README.md": "# Top\n\n[good](sub/a.md#two-words-1) [out](https://example.org/no) `[code](none)`\n"
                 "[file](sub/b.md)\n[anchor](sub/a.md#three)\n[own](#top) [own](#bottom)\n"
                 "![picture](sub/none.png) [up](../outside.md)\n\n```\n[fence](none.md)\n```\n",
    "sub/a.md": "# A `b_c` d\n\n## Two words\n\n## Two *words*\n\n[back](../README.md#top) [a](#a-b_c-d)\n",
}
MARKDOWN_WRONG = ["README.md:4: sub/b.md: no such file", "README.md:5: sub/a.md#three: no such anchor",
                  "README.md:6: #bottom: no such anchor", "README.md:7: sub/none.png: no such file",
                  "README.md:7: ../outside.md: no such file"]
HTML = {
    "index.html": '<title>Top</title>\n<h1 id="top">Top</h1><a href="sub/a.html#x">good</a>\n'
                  '<a href="sub/a.html#y">anchor</a>\n<a href="b.html">file</a><img src="c.png">\n'
                  '<a href="#top">own</a><a href="https://example.org/no">out</a>\n',
    "sub/a.html": '<h1 id="x">A</h1><a href="../index.html#top">back</a>\n',
}
HTML_WRONG = ["index.html:3: sub/a.html#y: no such anchor", "index.html:4: b.html: no such file",
              "index.html:4: c.png: no such file", "sub/a.html: no title"]


def check(holds, *text):
    global failures
    if not holds:
        print("links.py:", *text)
        failures += 1


def run(*words):
    return subprocess.run([sys.executable, "-B", "tools/check_links", *words], capture_output=True, text=True)


def check_planted(files, wrong, *words):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        done = run(*words, folder)
    check(done.returncode == 1 and done.stdout.splitlines() == wrong, done.stdout, done.stderr)


documents = run()
check(documents.returncode == 0 and not documents.stdout, documents.stdout, documents.stderr)
check_planted(MARKDOWN, MARKDOWN_WRONG)
check_planted(HTML, HTML_WRONG, "--html")
print("ok" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
