"""The report page from outside: tags that close and load nothing, its policy,
the commands that it prints, and, as Chromium draws it, its words and its plots,
read back from marks and ticks. Standard library only."""

import atexit
import base64
import csv
import hashlib
import html
import html.parser
import os
import re

import browser

BYTES_MAX = 3_000_000
VOID = {"meta", "link", "br", "hr", "img", "input", "wbr"}
failed = []
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../src/murk.h"), encoding="utf-8") as header:
    VERSION = [int(n) for n in re.findall(r"^#define MURK_VERSION_\w+ (\d+)", header.read(), re.M)]  # major, minor, patch


def check(holds, *what):
    if not holds:
        failed.append(what)
        print("not so:", *what)


class Page(html.parser.HTMLParser):
    """Tags that close, attributes that load or run nothing. Drawn: as the
    page's own script left it, which styles the view by itself."""

    def __init__(self, text, is_drawn=False):
        super().__init__()
        self.is_drawn = is_drawn
        self.open, self.text, self.inside = [], "", {}
        self.tags, self.ids, self.links, self.policy = [], set(), [], ""
        self.pictures = []
        self.feed(text)
        self.close()
        check(not self.open, "left open:", self.open)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        values = dict(attrs)
        check(len(values) == len(attrs), "an attribute twice:", attrs)
        for name, value in attrs:
            check(not name.startswith("on"), "a handler:", tag, name)
            if tag == "img" and name == "src":
                self.pictures.append(value)
                continue
            if name == "style" and self.is_drawn and tag in ("canvas", "i"):
                continue
            check(name not in ("src", "srcset", "action", "data", "style", "poster",
                               "xlink:href", "background"), "an attribute:", tag, name)
            if name == "href":
                check(value.startswith("#"), "a link away:", value)
                self.links.append(value[1:])
            if name == "id":
                check(value not in self.ids, "an id twice:", value)
                self.ids.add(value)
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"]
        if tag not in VOID and not self.get_starttag_text().endswith("/>"):
            self.open.append("data" if tag == "script" and "type" in values else tag)

    def handle_endtag(self, tag):
        if tag in VOID or self.get_starttag_text().endswith("/>") and \
                (not self.open or self.open[-1] != tag):
            return
        inside = "data" if tag == "script" and self.open[-1:] == ["data"] else tag
        check(self.open and self.open[-1] == inside, "closes", tag, "in", self.open[-3:])
        if self.open:
            self.open.pop()

    def handle_data(self, data):
        inside = self.open[-1] if self.open else ""
        if inside in ("style", "script", "data"):
            self.inside.setdefault(inside, []).append(data)
        else:
            self.text += data


def commands(path):
    """The page's blocks of commands, as text to paste."""
    with open(path, encoding="utf-8") as file:
        blocks = re.findall(r'<pre tabindex="0">([^<]*)</pre>', file.read())
    return [html.unescape(block) for block in blocks]


def hash_of(text):
    digest = hashlib.sha256(text.encode()).digest()
    return "'sha256-" + base64.b64encode(digest).decode() + "'"


# The page without what is no text of it: scripts, styles, and what is shown without scripts.
DRAWN = """(() => { const page = document.documentElement.cloneNode(true);
  page.querySelectorAll("script, style, noscript").forEach((part) => part.remove());
  return page.outerHTML; })()"""
chromium = []  # one, which is started for the first page


def drawn(path):
    """The page as Chromium draws it, which says nothing on its console."""
    if not chromium:
        chromium.append(browser.Browser())
        atexit.register(chromium[0].end)
        # words and plots alone: drawing the view takes a processor seconds
        chromium[0].call("Page.addScriptToEvaluateOnNewDocument",
                         source="HTMLCanvasElement.prototype.getContext = () => null;")
    page = chromium[0]
    page.said = []
    page.open(os.path.abspath(path))
    text = page.value(DRAWN)
    said = [words for words in page.said if "WebGL" not in words]
    check(said == [], path, "says", said)
    check("A part of the page cannot be drawn" not in text, path, "is not drawn whole")
    check(not re.search(r' (d|x|y|r|cx|cy|width|height|transform)="[^"]*(NaN|Infinity|undefined|null)', text),
          path, "has no number in a drawing")
    return text


def without_script(text):
    """The page's file without its script, which has all words that it could say."""
    return re.sub("<script>.*?</script>", "", text, flags=re.S)


def read(path, pictures=()):
    """The page's words as they are drawn, with the checks of its file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    check(len(text.encode()) <= BYTES_MAX, path, "has", len(text.encode()), "bytes")
    check(not re.search("[�\x80-\x9f]", without_script(text)), path, "has characters that are none")
    page = Page(text)
    check("default-src 'none'" in page.policy, "policy", page.policy)
    check("unsafe" not in page.policy and "http" not in page.policy, page.policy)
    for part in page.inside.get("style", []) + page.inside.get("script", []):
        check(hash_of(part) in page.policy, "a hash is not in", page.policy)
    check(len(page.inside["script"]) == 1 and page.policy.count("sha256-") == 2, page.policy)
    check(page.pictures == ["data:image/png;base64," + base64.b64encode(p).decode()
                            for p in pictures], "pictures:", len(page.pictures))
    check(page.tags.count("img") == len(pictures), "a name became a tag")
    check(("img-src data:" in page.policy) == (len(pictures) > 0), page.policy)
    shown = Page(drawn(path), True)
    check(shown.tags.count("img") == len(pictures), "a name became a tag, drawn")
    for link in shown.links:
        check(link in shown.ids, "no such place:", link)
    check("nan" not in re.sub(r"[a-z]*nan[a-z]+|[a-z]+nan", "", shown.text.lower()),
          "NaN is shown")
    return shown


def number(text):
    """What a tick says: 3, -0.2, 40 %, 2·10⁻⁵, 06:30."""
    power = re.fullmatch("(?:(.+)·)?10([⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)", text)
    if power:
        exponent = power[2].translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"))
        return float(power[1] or 1) * 10 ** float(exponent)
    if ":" in text:
        return int(text[:2]) + int(text[3:]) / 60
    return float(text.replace(" %", "e-2"))


class Plot:
    """A plot read back from its marks and the ticks of its axes."""

    def __init__(self, page, title):
        self.svg = next((s for s in re.findall(r"<svg.*?</svg>", page, re.S)
                         if f'aria-label="{title}' in html.unescape(s)), "")
        check(self.svg, "no plot", title)
        self.x = re.findall(r'class="axis" d="M([\d.]+) 308.0v5"></path><text[^>]*>([^<]*)', self.svg)
        self.y = re.findall(r'class="grid" d="M80.0 ([\d.]+)H[\d.]+"></path><text[^>]*>([^<]*)', self.svg)

    def marks(self, series):
        return [(float(x), float(y)) for x, y in
                re.findall(rf'class="point s{series}" d="M([\d.]+) ([\d.]+)m[^"]*"><title>', self.svg)]

    def whiskers(self, series):
        return [tuple(map(float, w)) for w in re.findall(
            rf'class="whisker s{series}" d="M[\d.]+ ([\d.]+)V([\d.]+)', self.svg)]

    @staticmethod
    def value(ticks, at, is_log=False):
        """By the two ticks that are farthest from each other."""
        (a, a_text), (b, b_text) = ticks[0], ticks[-1]
        part = (at - float(a)) / (float(b) - float(a))
        low, high = number(a_text), number(b_text)
        return low * (high / low) ** part if is_log else low + part * (high - low)

    def is_at(self, mark, x, y, what, logs=(False, False)):
        """Within a tenth of a unit, to which places are written, and the ticks' own."""
        for ticks, at, want, is_log in ((self.x, mark[0], x, logs[0]), (self.y, mark[1], y, logs[1])):
            if want is not None:
                near, off = self.value(ticks, at, is_log), self.value(ticks, at + 0.2, is_log)
                check(abs(near - want) <= abs(off - near), what, "is drawn at", near, "and is", want)


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))
