/* OR-Library's set cover instance scp41 as maximum coverage: the most rows
 * that 2, 3, 4 and 5 columns cover are 21, 30, 39 and 48 (proven by others).
 * Nothing is random but the seed. Source: Beasley, J. Oper. Res. Soc. 41
 * (1990) 1069. */
#include "check.h"
#include "placement/place.h"

#include <stdlib.h>

#define FILE_NAME "../shared/data/placement/scp41.txt"

typedef struct cover_problem {
    size_t rows, columns;
    uint32_t *row; /* [columns][rows] */
    size_t *seen;  /* [columns] */
} cover_problem;

static void get_row(void *context, unsigned worker, size_t candidate,
                    murk_sparse_row *out)
{
    const cover_problem *c = context;
    (void)worker;
    *out = (murk_sparse_row){c->seen[candidate], c->row + candidate * c->rows,
                             NULL};
}

static bool read_number(FILE *file, size_t *out)
{
    char text[32];
    char *end = NULL;
    if (fscanf(file, "%31s", text) != 1) {
        return false;
    }
    *out = strtoul(text, &end, 10);
    return *end == '\0';
}

static bool read_cover(cover_problem *c, FILE *file)
{
    /* Number of rows and columns. */
    size_t cost = 0, n = 0, column = 0;
    if (!read_number(file, &c->rows) || !read_number(file, &c->columns) ||
        c->rows > 10000 || c->columns > 10000) {
        return false;
    }
    c->row = calloc(c->rows * c->columns, sizeof *c->row);
    c->seen = calloc(c->columns, sizeof *c->seen);
    /* Costs of the columns are of no use here. */
    for (size_t j = 0; j < c->columns; ++j) {
        if (!read_number(file, &cost)) {
            return false;
        }
    }
    /* Each row lists the columns that cover it, numbered from 1; keep the
     * rows of each column instead. */
    for (size_t i = 0; i < c->rows; ++i) {
        if (!read_number(file, &n)) {
            return false;
        }
        for (size_t k = 0; k < n; ++k) {
            if (!read_number(file, &column) || column < 1 ||
                column > c->columns) {
                return false;
            }
            c->row[(column - 1) * c->rows + c->seen[column - 1]++] =
                (uint32_t)i;
        }
    }
    return true;
}

int main(void)
{
    /* Read the published problem. */
    static const uint64_t covered[] = {21, 30, 39, 48};
    FILE *file = fopen(FILE_NAME, "r");
    if (!file) {
        check_skip(FILE_NAME " is missing");
    }
    cover_problem c = {0};
    CHECK(read_cover(&c, file));
    fclose(file);
    CHECK(c.rows == 200 && c.columns == 1000);
    /* Columns are candidates, and rows are photons of weight 1. */
    uint32_t *weight = calloc(c.rows, sizeof *weight);
    for (size_t i = 0; i < c.rows; ++i) {
        weight[i] = 1;
    }
    const murk_problem problem = {.photons = c.rows,
                                  .candidates = c.columns,
                                  .weight = weight,
                                  .get_row = get_row,
                                  .context = &c,
                                  .threads = 2};
    murk_matrix *matrix = NULL;
    murk_error err = {0};
    CHECK(murk_matrix_create(&matrix, &problem, 1 << 30, &err) == MURK_OK);
    /* The best coverage by 2 to 5 columns is the known one, and the upper
     * bound is valid. */
    for (size_t n = 2; n <= 5; ++n) {
        murk_place_desc desc = murk_place_defaults();
        murk_place_result r = {0};
        desc.count = n;
        CHECK(murk_place_sensors(&r, &problem, matrix, &desc, &err) == MURK_OK);
        printf("%zu columns: %g rows, at most %g, %zu starts\n", n,
               (double)r.value / MURK_CLEAR, (double)r.upper / MURK_CLEAR,
               r.restarts);
        CHECK(r.value == covered[n - 2] * MURK_CLEAR);
        CHECK(r.upper >= covered[n - 2] * MURK_CLEAR);
        murk_place_release(&r);
    }
    murk_matrix_destroy(matrix);
    free(weight);
    free(c.row);
    free(c.seen);
    return check_done();
}
