/* Cells of CSV text against RFC 4180, and the faults of quoted cells. */
#include "base/csv.h"
#include "check.h"

/* Prints the cells as "line:cell|cell;", or the fault as "line!fault". */
static void cells_of(const char *text, bool is_one_line, char *out, size_t size)
{
    char copy[200];
    snprintf(copy, sizeof copy, "%s", text);
    murk_csv csv = {copy, copy + strlen(copy), 1, is_one_line};
    size_t n = 0;
    out[0] = '\0';
    while (murk_csv_find_line(&csv)) {
        n += (size_t)snprintf(out + n, size - n, "%zu:", csv.line);
        for (bool is_last = false; !is_last;) {
            char *cell = NULL;
            const char *fault = murk_csv_read_cell(&csv, &cell, &is_last);
            if (fault) {
                snprintf(out + n, size - n, "%zu!%s", csv.line, fault);
                return;
            }
            n += (size_t)snprintf(out + n, size - n, "%s%s", cell,
                                  is_last ? ";" : "|");
        }
    }
}

static void check_cells(const char *text, bool is_one_line, const char *want)
{
    char got[300];
    cells_of(text, is_one_line, got, sizeof got);
    CHECK_TEXT(got, want);
}

#define BEHIND \
    "text behind a closing quote, must be a comma or the end of the line"

int main(void)
{
    /* Lines, blanks, comments, line ends of any kind, no last line end. */
    check_cells("", false, "");
    check_cells("a,b\n1,2\n", false, "1:a|b;2:1|2;");
    check_cells("a,b\r\n\r\n 1 ,\t2 \r\n", false, "1:a|b;3:1|2;");
    check_cells("\n # x, y\na\n#\n\nb,", false, "3:a;6:b|;");
    check_cells(",\n,,", false, "1:|;2:||;");

    /* Quotes: commas, quotes and line ends inside; blanks outside. */
    check_cells("\"a,b\" , \"c \"\"d\"\"\"\n\"\"", false, "1:a,b|c \"d\";2:;");
    check_cells("\"a\nb\",c\nd", false, "1:a\nb|c;3:d;");
    check_cells("\"a\nb\",c\nd", true, "1:1!a quote is not closed in its line");
    check_cells("a\n\"b\n\nc", false, "1:a;2:2!a quote is not closed");
    check_cells("a\n\"b\nc\"d", false, "1:a;2:3!" BEHIND);
    check_cells("a,\"b\"\"", true, "1:a|1!a quote is not closed in its line");
    check_cells("a\"b,c\n", false, "1:a\"b|c;");
    return check_done();
}
