#!/bin/bash
# The completion scripts complete command lines. bash calls the function that the
# script registers; of zsh, when it is installed, the builtins of completion are
# replaced by functions that print their arguments.
#
#     completion.sh MURK
set -u
murk=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
"$murk" --completion bash >"$work/bash" && "$murk" --completion zsh >"$work/_murk" || exit 1
cd "$work" || exit 1
touch scene.yaml

# in_bash WORD...: what bash offers for the last word, sorted, with spaces between
in_bash() {
    bash -c 'source ./bash
        COMP_WORDS=("$@")
        COMP_CWORD=$(($# - 1))
        $(complete -p murk | sed "s/.*-F \([^ ]*\).*/\1/")
        printf "%s\n" "${COMPREPLY[@]}"' - "$@" | sort | xargs
}
# in_zsh WORD...: the same in zsh, without those that do not begin as the last word
in_zsh() {
    zsh -fc 'compadd() { while [[ $1 != -- ]]; do shift; done; shift; print -l -- ${(M)@:#$PREFIX*} }
        _files() { print -l -- $PREFIX*(N) }
        compset() { PREFIX=${PREFIX#*=} }
        words=("$@")
        CURRENT=$#
        PREFIX=${words[CURRENT]}
        source ./_murk' - "$@" | sort | xargs
}
# offers EXPECTED WORD...: both shells offer the expected words
offers() {
    local expected=$1 shell found
    shift
    for shell in bash zsh; do
        command -v $shell >/dev/null || continue
        found=$("in_$shell" "$@")
        [ "${found//=/}" = "$expected" ] || {
            echo "$shell: $*: offered \"$found\", expected \"$expected\""
            failed=1
        }
    done
}
offers "place" murk pl
offers "render replay report" murk re
offers "--matrix" murk place --mat
offers "" murk trace --mat
offers "maps maps-only" murk render scene.yaml --method m
offers "json text" murk place --format ""
offers "scene.yaml" murk place sc
offers "scene.yaml" murk sense --sensors sc
offers "" murk place --seed ""
offers "photons.emit" murk place --set photons.em
offers "photons.emit" murk fit --free photons.em
offers "fog/kim fog/kruse" murk media fog/k
offers "smoke street" murk init s
offers "" murk init sc
offers "" murk schema sc
offers "sensors.count" murk help sensors.cou
offers "media.*.albedo media.*.albedo.grid media.*.albedo.vdb" murk help "media.*.alb"
offers "help" murk he

# the value behind "=", which bash takes for a word of its own and zsh does not
[ "$(in_bash murk place --format = j)" = json ] || { echo "bash: --format=j is not completed"; failed=1; }
[ "$(in_bash murk place --format =)" = "json text" ] || { echo "bash: --format= is not completed"; failed=1; }
! command -v zsh >/dev/null || [ "$(in_zsh murk place --format=j)" = json ] ||
    { echo "zsh: --format=j is not completed"; failed=1; }

# every command, and every option that --help of a command shows, is offered
commands=$("$murk" --help | sed -n '/^commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(in_bash murk "")" = "$(printf '%s\n' $commands | sort | xargs)" ] ||
    { echo "the commands differ from those of --help"; failed=1; }
for command in $commands; do
    shown=$("$murk" "$command" --help | sed -n '/^options:/,$s/^  \(-.,* \)*\(--[a-z-]*\).*/\2/p' | sort | xargs)
    [ "$(in_bash murk "$command" --)" = "$shown" ] ||
        { echo "$command: the options differ from those of --help"; failed=1; }
done
exit $failed
