"""Headings, anchors and links of Markdown text as GitHub reads it, for the tools
that check and convert the documents."""
import os
import re

TOP = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def prose(text):
    """The lines of the text with their numbers, without fenced code."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if re.match(r" *(```|~~~)", line):
            fenced = not fenced
        elif not fenced:
            yield number, line


def anchor(heading, used):
    """The anchor that GitHub gives a heading. `used` counts those of the page."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
    used[name] = used.get(name, -1) + 1
    return f"{name}-{used[name]}" if used[name] else name


def headings(text):
    """Level, text and anchor of each heading, with the number of its line."""
    used = {}
    for number, line in prose(text):
        found = re.match(r"(#{1,6}) +(.+?) *#*$", line)
        if found:
            yield number, len(found[1]), found[2], anchor(found[2], used)


def links(text):
    """The target of each link and picture, with the number of its line."""
    for number, line in prose(text):
        for target in re.findall(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", re.sub(r"`[^`]*`", "``", line)):
            yield number, target
