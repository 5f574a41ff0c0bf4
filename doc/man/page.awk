# A man page from Markdown, in roff's man macros.
#
#   awk -v source=DIR -v header=murk_build.h -v version=VERSION -f page.awk NAME.5.md
#
# The header says the date (MURK_BUILD_DATE).
# Markdown as this project's files use it: headings, paragraphs, lists, fences,
# tables, `code`, **bold**, [text](link). The first line is "# NAME(SECTION):
# what it is". A line "<!-- include FILE -->" takes in DIR/FILE as a section, and
# "<!-- include FILE: HEADING -->" the section of that heading, which a FILE that
# begins with "@" (one that the build made) has taken in without the heading.
# The first section is SYNOPSIS, or else DESCRIPTION.
# A table becomes a list: its first column is what is listed; of a table of keys
# ("key | value | default | meaning") default "-" is left out.

function escaped(text) {
    gsub(/\\\|/, "|", text)
    gsub(/\\/, "\\e", text)
    return text
}

# Inline marks; hyphens in code are those that one types.
function inline(text,    out, part, n, i) {
    while (match(text, /\[[^\]]+\]\([^)]*\)/)) {
        part = substr(text, RSTART + 1, RLENGTH - 1)
        text = substr(text, 1, RSTART - 1) substr(part, 1, index(part, "](") - 1) \
               substr(text, RSTART + RLENGTH)
    }
    n = split(escaped(text), piece, "`")
    out = ""
    for (i = 1; i <= n; ++i) {
        part = piece[i]
        if (i % 2 == 0 && i < n) {
            gsub(/-/, "\\-", part)
            out = out "\\fB" part "\\fR"
        } else {
            while (match(part, /\*\*[^*]+\*\*/)) {
                part = substr(part, 1, RSTART - 1) "\\fB" \
                       substr(part, RSTART + 2, RLENGTH - 4) "\\fR" \
                       substr(part, RSTART + RLENGTH)
            }
            out = out part
        }
    }
    return out
}

function put(text) {
    if (text ~ /^[.']/) {
        text = "\\&" text
    }
    print text
    after_heading = 0
}

function paragraph() {
    if (!after_heading) {
        print ".PP"
    }
}

function flush() {
    if (held != "") {
        if (!in_item) {
            paragraph()
        }
        put(inline(held))
        held = ""
    }
    in_item = 0
}

function heading(level, text) {
    flush()
    gsub(/`/, "", text)
    if (!headed++ && text != "Synopsis") {
        text = "Description"
    }
    if (text ~ /^(Synopsis|Description|See also)$/) {
        text = toupper(text)
    }
    print (level == 2 ? ".SH \"" : ".SS \"") escaped(text) "\""
    after_heading = 1
}

function cells(row, cell,    n, i) {
    gsub(/\\\|/, "\001", row)
    sub(/^\| */, "", row)
    sub(/ *\|$/, "", row)
    n = split(row, cell, / *\| */)
    for (i = 1; i <= n; ++i) {
        gsub(/\001/, "|", cell[i])
    }
    return n
}

function table_row(row,    n, i, text) {
    if (row ~ /^\|[-| ]+\|$/) {
        return
    }
    if (!in_table) {
        flush()
        columns = cells(row, title)
        in_table = 1
        return
    }
    n = cells(row, cell)
    print ".TP"
    if (title[1] == "key" && columns == 4) {
        put(inline(cell[1]) ": " inline(cell[2]) \
            (cell[3] == "-" ? "" : cell[3] == "required" || cell[3] == "one of these" \
             ? "; " cell[3] : "; default " inline(cell[3])))
        put(inline(cell[4]))
        return
    }
    if (cell[1] == "") { # as in the row above
        cell[1] = tag
    }
    tag = cell[1]
    put(inline(tag ~ /[`*]/ ? tag : "**" tag "**"))
    text = ""
    for (i = 2; i <= n; ++i) {
        label = title[i] == "of" ? "of " : title[i] ": "
        text = text (text == "" ? "" : "; ") \
               (columns == 2 || title[i] ~ /^(what|meaning|content)$/ ? "" : label) cell[i]
    }
    put(inline(text))
}

function take(text) {
    if (in_code) {
        if (text ~ /^ *```/) {
            print ".fi\n.RE"
            in_code = 0
        } else {
            text = escaped(text)
            gsub(/-/, "\\-", text)
            put(text == "" ? "\\&" : text)
        }
        return
    }
    if (text ~ /^ *```/) {
        flush()
        paragraph()
        print ".RS 4\n.nf"
        after_heading = 0
        in_code = 1
    } else if (text ~ /^\|/) {
        table_row(text)
        return
    } else if (text ~ /^##+ /) {
        match(text, /^#+/)
        heading(RLENGTH == 2 ? 2 : 3, substr(text, RLENGTH + 2))
    } else if (text ~ /^ *$/) {
        flush()
    } else if (text ~ /^\* /) {
        flush()
        print ".IP \\(bu 2"
        held = substr(text, 3)
        in_item = 1
    } else if (text !~ /^<!--/) {
        sub(/^ +/, "", text)
        held = held == "" ? text : held " " text
    }
    in_table = 0
}

# The whole file, or the section from that heading to the next one of its level
# or above.
function include(spec,    file, from, text, is_in, found, fenced, is_made, colon) {
    colon = index(spec, ": ")
    file = colon ? substr(spec, 1, colon - 1) : spec
    from = colon ? substr(spec, colon + 2) : ""
    is_made = sub(/^@/, "", file)
    file = (is_made ? generated : source) "/" file
    is_in = found = !colon
    while ((getline text < file) > 0) {
        if (text ~ /^#+ / && !fenced) {
            if (!colon) { # one level down
                text = "#" text
            } else if (text ~ /^##? /) {
                if (is_in) {
                    break
                }
                is_in = index(text, "## " from) == 1
                found = found || is_in
                if (is_in && is_made) {
                    continue
                }
            }
        }
        if (text ~ /^ *```/) {
            fenced = !fenced
        }
        if (is_in) {
            take(text)
        }
    }
    close(file)
    flush()
    if (!found) {
        print FILENAME ": no section \"" from "\" in " file > "/dev/stderr"
        failed = 1
    }
}

NR == 1 {
    while ((getline row < header) > 0) {
        if (row ~ /MURK_BUILD_DATE/) {
            split(row, quoted, "\"")
            date = quoted[2]
        }
    }
    name = substr($2, 1, index($2, "(") - 1)
    section = substr($2, index($2, "(") + 1, 1)
    about = $0
    sub(/^# [^:]*: /, "", about)
    print ".TH " toupper(name) " " section " " date " \"murk " version "\" \"" \
          (section == 1 ? "User Commands" : section == 3 ? "Library Functions" : "File Formats") "\""
    print ".ad l\n.nh\n.SH NAME"
    print name " \\- " escaped(about)
    next
}

/^<!-- include / {
    spec = $0
    sub(/^<!-- include /, "", spec)
    sub(/ -->$/, "", spec)
    flush()
    include(spec)
    next
}

{ take($0) }

END {
    flush()
    exit failed
}
