#include "base/utf8.h"

size_t murk_utf8_length(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    const unsigned char c = at[0];
    const size_t n = c < 0x80                ? 1
                     : c >= 0xc2 && c < 0xe0 ? 2
                     : c >= 0xe0 && c < 0xf0 ? 3
                     : c >= 0xf0 && c < 0xf5 ? 4
                                             : 0;
    for (size_t i = 1; i < n; ++i) {
        if ((at[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    const bool is_bad = (c == 0xe0 && at[1] < 0xa0) || /* overlong */
                        (c == 0xed && at[1] >= 0xa0) ||
                        (c == 0xf0 && at[1] < 0x90) ||
                        (c == 0xf4 && at[1] >= 0x90);
    return is_bad ? 0 : n;
}

bool murk_utf8_is_printable(const char *text, size_t n)
{
    for (; n > 0 && *text; --n) {
        const unsigned char c = (unsigned char)*text;
        const size_t length = murk_utf8_length(text);
        if (c < 0x20 || c == 0x7f || length == 0) {
            return false;
        }
        text += length;
    }
    return true;
}
