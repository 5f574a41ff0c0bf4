#!/bin/sh
# tools/picture draws a PNG of the asked width: light on surfaces is warm, smoke
# is blue and only there is smoke, the bytes repeat, and a file cut short is
# refused on one line.
# usage: picture.sh MURK
set -eu
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
murk=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
"$murk" place scenes/paper-room.yaml --store 500 --set placement.restarts=1 --quiet \
    -o "$dir/room" >"$dir/log"
"$murk" place scenes/smoke-hall.yaml --emit 2000 --set placement.restarts=1 --quiet \
    -o "$dir/hall" >"$dir/log"
tools/picture "$dir/room" "$dir/room.png" 600
tools/picture "$dir/room" "$dir/again.png" 600
tools/picture "$dir/hall" "$dir/hall.png" 600
cmp "$dir/room.png" "$dir/again.png"
python3 - "$dir/room.png" "$dir/hall.png" <<'PYTHON'
import pathlib
import struct
import sys
import zlib


def colours(path):
    """Shares of warm and of blue pixels; the filter must be "above"."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    at, body = 8, b""
    while at < len(data):
        n, kind = struct.unpack_from(">I4s", data, at)
        chunk = data[at + 8:at + 8 + n]
        check, = struct.unpack_from(">I", data, at + 8 + n)
        assert check == zlib.crc32(kind + chunk), "checksum"
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">2I5B", chunk)
        elif kind == b"IDAT":
            body += chunk
        at += 12 + n
    assert kind == b"IEND" and form == [8, 2, 0, 0, 0] and width == 600 < 2 * height
    raw, row = zlib.decompress(body), bytes(3 * width)
    assert len(raw) == height * (3 * width + 1)
    warm = blue = 0
    for y in range(height):
        line = raw[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        assert line[0] == 2
        row = bytes((a + b) & 255 for a, b in zip(line[1:], row))
        for r, g, b in zip(row[::3], row[1::3], row[2::3]):
            warm += r > b + 80 and r > g
            blue += b > r + 60 and b > g + 20
    return warm / width / height, blue / width / height


room, hall = map(colours, sys.argv[1:])
print(f"warm and blue: room {room[0]:.4f} {room[1]:.4f}, hall {hall[0]:.4f} {hall[1]:.4f}")
assert room[0] > .01 and room[1] == 0
assert hall[0] > .01 and hall[1] > .001
PYTHON
head -c 9000 "$dir/room/light.murk" >"$dir/cut" && mv "$dir/cut" "$dir/room/light.murk"
if tools/picture "$dir/room" "$dir/none.png" 2>"$dir/message"; then
    echo "a file cut short was drawn"
    exit 1
fi
cat "$dir/message"
[ "$(wc -l <"$dir/message")" = 1 ] && grep -q 'cut short' "$dir/message" && [ ! -e "$dir/none.png" ]
