#!/bin/sh
# Malformed coverage matrices: one line on standard error with file, line and
# column, exit 2, nothing written, within 10 seconds and 2 GB.
# usage: matrix.sh MURK [SANITIZER]
set -u
murk=$1
sanitizer=${2:-}
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0
file=$dir/matrix.txt

within_limits() (
    [ -n "$sanitizer" ] || {
        ulimit -s 2048
        ulimit -v 2000000
    }
    MALLOC_ARENA_MAX=2 timeout 10 "$murk" "$@"
)

# expect CODE PART-OF-MESSAGE ARGS...
expect() {
    code=$1
    part=$2
    shift 2
    within_limits place --matrix "$file" -o "$dir/out" "$@" >"$dir/stdout" 2>"$dir/stderr"
    got=$?
    if [ "$got" -ne "$code" ] || [ "$(wc -l <"$dir/stderr")" -ne 1 ] || ! grep -qF -- "$part" "$dir/stderr"; then
        echo "$* of: $(head -c 60 "$file" | tr '\n' '/')"
        echo "  exit $got, want $code; want one line with: $part"
        sed 's/^/  /' "$dir/stderr"
        failed=1
    fi
    if [ -d "$dir/out" ] && [ -n "$(ls -A "$dir/out")" ]; then
        echo "$*: wrote $(ls -A "$dir/out")"
        failed=1
    fi
    rm -rf "$dir/out"
}
# refused PART TEXT: of a file with that text
refused() {
    printf '%b' "$2" >"$file"
    expect 2 "$1" --count 1
}

# ---- either format ----
refused "matrix.txt: is empty" ""
refused "matrix.txt: is empty" " \n\n\t"
refused "matrix.txt: has comments alone" "# nothing\n# here, either"
refused "byte 4 is 0" "1,0\\000,1\n"
refused "0 entries above 0" "0,0\n0,0\n"
refused "0 entries above 0" "1 1\n1\n0\n"

# ---- dense ----
refused "matrix.txt:3:3: the line has 2 cells, the first has 3" "1,0,1\n0,1,0\n1,0\n"
refused "matrix.txt:2:7: the line has 4 cells" "1,0,1\n0,1,0,1\n"
refused 'matrix.txt:2:3: clarity "-0.5", must be a number 0..1' "1,0\n0,-0.5\n"
refused 'matrix.txt:2:3: clarity "1.5", must be a number 0..1' "a,b\n0,1.5\n"
refused 'matrix.txt:2:1: clarity "nan"' "1,0\nnan,1\n"
refused 'matrix.txt:1:1: clarity "nan"' "nan,nan\n1,1\n"
refused 'matrix.txt:1:3: clarity "inf"' "1,inf\n1,1\n"
refused 'matrix.txt:1:3: clarity "0x1"' "1,0x1\n1,1\n"
refused 'matrix.txt:2:3: clarity ""' "a,b\n1,\n"
refused 'matrix.txt:1:1: clarity ""' ",1\n1,1\n"
refused 'matrix.txt:2:5: weight "-1"' "a,b,weight\n1,0,-1\n"
refused 'matrix.txt:3:5: weight "1e300"' "a,b,weight\n1,0,2\n1,0,1e300\n"
refused 'a second column weight' "a,weight,weight\n1,1,1\n"
refused 'the weights add up to 0' "a,weight\n1,0\n1,0\n"
refused '0 rows' "a,b\n"
refused '0 columns' "row,weight\n1,2\n"
refused 'matrix.txt:2:3: a quote is not closed' 'a,b\n1,"0\n1,1\n'
refused 'matrix.txt:2:3: text behind a closing quote' 'a,b\n1,"0"1\n'
refused "semicolons" "1;0;1\n0;1;0\n"

# ---- sparse ----
refused 'matrix.txt:3: column 1 covers row 1 twice' "row,column,clarity\n1,1,1\n1,1,.5\n"
refused 'matrix.txt:2:1: row "0"' "row,column\n0,1\n"
refused 'matrix.txt:2:3: column "1.5"' "row,column\n1,1.5\n"
refused 'matrix.txt:2:1: row 1000000000, but the file can name no more than' "row,column\n1000000000,1\n"
refused 'matrix.txt:2:3: column 18446744073709551615, but' "row,column\n1,18446744073709551615\n"
refused 'row 2 of 1..3 is in no line' "row,column\n1,1\n3,1\n"
refused 'column 1 of 1..2 is in no line' "row,column\n1,2\n2,2\n"
refused 'matrix.txt:2:1: the line has 1 cells, the header has 2' "row,column\n1\n"
refused 'matrix.txt:1:12: column "colour"' "row,column,colour\n1,1,1\n"
refused 'matrix.txt:1:12: column "row"' "row,column,row\n1,1,1\n"
refused 'matrix.txt:2:5: clarity "2"' "row,column,clarity\n1,1,2\n"
refused 'matrix.txt:2:4: a clarity needs a row and a column' "row,column,clarity\n1,,1\n"
refused 'names neither a row nor a column' "row,column\n,\n"
refused 'matrix.txt:2:4: a weight without a row' "row,column,weight\n,1,2\n"
refused 'matrix.txt:3:5: weight 3 of row 1, which a line above says is 2' "row,column,weight\n1,1,2\n1,2,3\n"

# ---- OR-Library ----
refused 'matrix.txt:1:12: 1000000000 rows and 1000000000 columns need 2000000000 numbers more' "1000000000 1000000000\n1 1\n"
refused 'matrix.txt:1:1: rows: 99999999999999999999' "99999999999999999999 2\n"
refused 'matrix.txt:1:1: rows: 0, must be' "0 2\n1 1\n"
refused 'matrix.txt:1:3: columns: -2' "2 -2\n1 1\n"
refused 'matrix.txt:1:3: columns: 2.5' "2 2.5\n1 1\n"
refused 'matrix.txt:2:1: the file ends before columns' "2\n"
refused 'matrix.txt:2:1: the cost of column 1 of 2: -1' "2 2\n-1 1\n1 1\n1 2\n"
refused 'matrix.txt:3:1: the count of row 1: 3, must be a whole number 0..2' "2 2\n1 1\n3 1 2\n1 2\n"
refused 'matrix.txt:3:3: column 1 of 1 of row 1: 3, must be a whole number 1..2' "2 2\n1 1\n1 3\n1 2\n"
refused 'matrix.txt:3:3: column 1 of 1 of row 1: 0' "2 2\n1 1\n1 0\n1 2\n"
refused 'matrix.txt:3: column 2 covers row 1 twice' "2 2\n1 1\n2 2 2\n1 2\n"
refused 'matrix.txt:5:1: the file ends before column 2 of 2 of row 2' "2 2\n1 1\n1 1\n2 2\n"
refused 'matrix.txt:5:2: the file ends before behind' "2 2\n1 1\n1 1\n1 2\n7"
refused 'matrix.txt:5:5: 3 behind the last weight' "2 2\n1 1\n1 1\n1 2\n1 2 3\n"
refused 'the weight of row 2 of 2: -2' "2 2\n1 1\n1 1\n1 2\n1 -2\n"
refused 'matrix.txt:2:1: the cost of column 1 of 2: nan' "2 2\nnan 1\n1 1\n1 2\n"

# ---- the wish ----
printf '1,0,1\n0,1,0\n0,0,0\n' >"$file"
expect 2 "--count: 4, but $file has 3 columns" --count 4
expect 2 "--count: 0" --count 0
expect 2 "0 are given" --seed 3
expect 2 "2 are given" --count 2 --target 0.5
expect 2 "2 are given" --count 2 --budget 5
expect 2 "--target: 1.5, must be more than 0 and at most 1" --target 1.5
expect 2 "--target: nan" --target nan
expect 2 "cannot be reached: all 3" --target 0.9
expect 2 "--budget: 0, must be more than 0 and at most 1e12" --budget 0
expect 2 "--budget: inf" --budget inf
expect 2 "a matrix has no light" --light light.murk --count 1
expect 2 "--set photons.emit: a matrix has no such key" --set photons.emit=5 --count 1
expect 2 "--emit: a matrix has no such key" --emit 5 --count 1
expect 2 "--set placement.method=fast: fast, must be best, spoq, greedy, exact" --set placement.method=fast --count 1
expect 2 "placement.detection: threshold, must be weighted, independent for a matrix" --set placement.detection=threshold --count 1
expect 2 "--set placement.redundancy=17: 17, must be 1..16" --set placement.redundancy=17 --count 1
expect 2 "redundancy is 2, must be 1 where views are independent chances" --set placement.redundancy=2 --set placement.detection=independent --count 1
expect 2 "--set placement.restarts=0: 0, must be 1..1e6" --set placement.restarts=0 --count 1
expect 2 "stands in place of a scene" scenes/paper-room.yaml --count 1
expect 2 "--export: \"png\" is not an export; allowed are" --export lp,png --count 1
expect 2 "--export: \"\" is not an export; allowed are" --export "" --count 1
file=$dir/absent.csv
expect 2 "absent.csv" --count 1
file=$dir
expect 2 "$dir" --count 1
within_limits place --matrix "$file" --count 1 --export lp >"$dir/stdout" 2>"$dir/stderr"
[ $? -eq 2 ] && grep -qF -- "--export: needs a folder" "$dir/stderr" || {
    echo "--export without -o:"
    cat "$dir/stderr"
    failed=1
}
exit $failed
