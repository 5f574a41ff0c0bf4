# Reads murk.h and prints a C program that prints the size of each struct of murk.h
# that is not opaque, the place of each member and the value of each enumerator:
# programs that are built already rely on them.

# The text of the header is joined into one line and loses its comments.
{ text = text " " $0 }

END {
    gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, "", text)
    print "#include <murk.h>\n#include <stddef.h>\n#include <stdio.h>\nint main(void)\n{"
    while (match(text, /typedef (struct|enum) [a-z_]+ \{[^}]*\}/)) {
        body = substr(text, RSTART, RLENGTH - 1)
        text = substr(text, RSTART + RLENGTH)
        split(body, words, " ")
        sub(/^[^{]*\{/, "", body)
        if (words[2] == "struct") {
            layout(words[3], body)
        } else {
            values(body)
        }
    }
    print "return 0;\n}"
}

function layout(type, body,    n, i, members) {
    printf "printf(\"size %s %%zu\\n\", sizeof(%s));\n", type, type
    gsub(/\[[^]]*\]/, "", body)
    n = split(body, members, /[;,]/)
    for (i = 1; i < n; ++i) { # the last piece follows the last semicolon
        sub(/ +$/, "", members[i])
        sub(/^.*[ *]/, "", members[i])
        printf "printf(\"place %s.%s %%zu\\n\", offsetof(%s, %s));\n", type, members[i], type, members[i]
    }
}

function values(body,    n, i, names) {
    gsub(/=[^,]*/, "", body)
    n = split(body, names, /,/)
    for (i = 1; i <= n; ++i) {
        gsub(/ /, "", names[i])
        if (names[i] != "") {
            printf "printf(\"value %s %%d\\n\", (int)%s);\n", names[i], names[i]
        }
    }
}
