/* Reads the .smv file of an FDS run line by line. A keyword begins a section;
 * the lines of sections that matter are read as words and numbers. */
#include "fds/run.h"

#include "base/field_blocks.h"
#include "base/file.h"
#include "base/number.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A .smv file has some 100 bytes for each grid line, obstruction and event. */
#define FILE_MAX ((size_t)1 << 30)

/* Numbers in a line that are read; the rest of a line is left alone. */
#define NUMBERS_MAX 16

typedef struct reader {
    char *at;         /* the rest of the text */
    char *text;       /* the current line, without white space around it */
    bool is_indented; /* the line begins with white space */
    unsigned line;
    murk_fds_run *run;
    size_t capacity_meshes, capacity_surfaces, capacity_events, capacity_files;
    const char *where;
    murk_error *err;
} reader;

static murk_status bad(const reader *r, const char *problem, const char *text)
{
    char place[sizeof r->err->where];
    snprintf(place, sizeof place, "%s:%u", r->where, r->line);
    return murk_fail(r->err, MURK_BAD_FILE, place, "%s%s%.80s%s", problem,
                     text ? " (" : "", text ? text : "", text ? ")" : "");
}

/* ---- lines ---- */

/* Advances to the next line; false at the end of the text. */
static bool next_line(reader *r)
{
    if (*r->at == '\0') {
        return false;
    }
    char *end = strchr(r->at, '\n');
    char *next = end ? end + 1 : r->at + strlen(r->at);
    char *last = end ? end : next;
    r->text = r->at;
    while (r->text < last && isspace((unsigned char)*r->text)) {
        ++r->text;
    }
    while (last > r->text && isspace((unsigned char)last[-1])) {
        --last;
    }
    r->is_indented = r->text > r->at;
    *last = '\0';
    r->at = next;
    ++r->line;
    return true;
}

static murk_status need_line(reader *r)
{
    return next_line(r) ? MURK_OK : bad(r, "ends within a section", NULL);
}

/* Reads numbers at the beginning of a text, up to the first word that is none,
 * and returns how many there are, at most NUMBERS_MAX. */
static size_t read_numbers(const char *text, double out[NUMBERS_MAX])
{
    size_t n = 0;
    while (n < NUMBERS_MAX) {
        char word[MURK_NUMBER_SIZE * 2];
        size_t length = 0;
        while (isspace((unsigned char)*text)) {
            ++text;
        }
        while (text[length] && !isspace((unsigned char)text[length])) {
            ++length;
        }
        if (length == 0 || length >= sizeof word) {
            break;
        }
        memcpy(word, text, length);
        word[length] = '\0';
        if (!murk_number_parse(word, &out[n])) {
            break;
        }
        ++n;
        text += length;
    }
    return n;
}

/* Reads the next line, which must have at least n numbers. */
static murk_status need_numbers(reader *r, size_t n, double out[NUMBERS_MAX])
{
    const murk_status status = need_line(r);
    if (status) {
        return status;
    }
    return read_numbers(r->text, out) >= n
               ? MURK_OK
               : bad(r, "too few numbers in the line", r->text);
}

static bool is_whole(double number, double low, double high)
{
    return number >= low && number <= high && number == (double)(int64_t)number;
}

/* A whole number from low to high. */
static murk_status need_whole(const reader *r, double number, double low,
                              double high, const char *name)
{
    char problem[128];
    if (is_whole(number, low, high)) {
        return MURK_OK;
    }
    snprintf(problem, sizeof problem, "%s is %.9g, must be %.9g to %.9g", name,
             number, low, high);
    return bad(r, problem, NULL);
}

/* Reads the next line as a name of at most size - 1 bytes; the rest is cut
 * off. */
static murk_status need_name(reader *r, char *out, size_t size)
{
    const murk_status status = need_line(r);
    if (!status) {
        snprintf(out, size, "%s", r->text);
    }
    return status;
}

/* Makes room for one more item of an array of n items of `item` bytes, which
 * may move. Returns the array; NULL without memory, then the array stays as it
 * is. */
static void *with_capacity(void *array, size_t n, size_t *capacity, size_t item)
{
    if (array && n < *capacity) {
        return array;
    }
    const size_t more = *capacity ? 2 * *capacity : 16;
    void *larger = realloc(array, more * item);
    *capacity = larger ? more : *capacity;
    return larger;
}

/* ---- sections ---- */

/* "GRID name", then the numbers of cells. */
static murk_status read_grid(reader *r, const char *name)
{
    murk_fds_run *run = r->run;
    double number[NUMBERS_MAX] = {0};
    if (run->meshes >= MURK_FDS_MESHES_MAX) {
        return bad(r, "too many meshes", NULL);
    }
    murk_fds_mesh *all =
        with_capacity(run->mesh, run->meshes, &r->capacity_meshes, sizeof *all);
    if (!all) {
        return murk_no_memory(r->err, r->where, "for its meshes");
    }
    run->mesh = all;
    murk_fds_mesh *mesh = &all[run->meshes++];
    *mesh = (murk_fds_mesh){0};
    snprintf(mesh->name, sizeof mesh->name, "%s", name);
    murk_status status = need_numbers(r, 3, number);
    for (int axis = 0; axis < 3 && !status; ++axis) {
        status = need_whole(r, number[axis], 1, MURK_FIELD_CELLS_MAX,
                            "the number of cells");
        mesh->cells[axis] = status ? 0 : (size_t)number[axis];
    }
    return status;
}

/* The mesh of a section that belongs to the last GRID. */
static murk_status find_mesh(const reader *r, murk_fds_mesh **out)
{
    if (r->run->meshes == 0) {
        return bad(r, "comes before the first GRID", r->text);
    }
    *out = &r->run->mesh[r->run->meshes - 1];
    return MURK_OK;
}

/* "TRNX", then how many points of a transformation follow, and the grid
 * lines. */
static murk_status read_edges(reader *r, int axis)
{
    murk_fds_mesh *mesh = NULL;
    double number[NUMBERS_MAX] = {0};
    murk_status status = find_mesh(r, &mesh);
    if (!status) {
        status = need_numbers(r, 1, number);
    }
    if (!status) {
        status = need_whole(r, number[0], 0, MURK_FIELD_CELLS_MAX,
                            "the number of points");
    }
    /* Points of the transformation, which are skipped, then grid lines. */
    for (double skip = 0; !status && skip < number[0]; ++skip) {
        status = need_line(r);
    }
    if (status) {
        return status;
    }
    if (mesh->edge[axis]) {
        return bad(r, "grid lines of one axis are given twice", NULL);
    }
    const size_t n = mesh->cells[axis] + 1;
    double *edge = mesh->edge[axis] = calloc(n, sizeof *edge);
    if (!edge) {
        return murk_no_memory(r->err, r->where, "for its grid lines");
    }
    for (size_t i = 0; i < n && !status; ++i) {
        status = need_numbers(r, 2, number);
        edge[i] = status ? 0 : number[1];
        if (!status && i > 0 && !(edge[i] > edge[i - 1])) {
            status = bad(r, "grid lines must rise", r->text);
        }
    }
    return status;
}

/* The six numbers of nodes of an obstruction or a vent. */
static murk_status take_nodes(const reader *r, const murk_fds_mesh *mesh,
                              const double number[NUMBERS_MAX],
                              murk_fds_nodes *out)
{
    murk_status status = MURK_OK;
    for (int axis = 0; axis < 3 && !status; ++axis) {
        const double low = number[2 * axis], high = number[2 * axis + 1];
        status = need_whole(r, low, 0, (double)mesh->cells[axis],
                            "the number of a grid line");
        if (!status) {
            status = need_whole(r, high, low, (double)mesh->cells[axis],
                                "the number of a grid line");
        }
        if (!status) {
            out->low[axis] = (int32_t)low;
            out->high[axis] = (int32_t)high;
        }
    }
    return status;
}

/* Reads a count of items, at most MURK_FDS_ITEMS_MAX. */
static murk_status read_count(reader *r, size_t *n)
{
    double number[NUMBERS_MAX] = {0};
    murk_status status = need_numbers(r, 1, number);
    if (!status) {
        status = need_whole(r, number[0], 0, MURK_FDS_ITEMS_MAX,
                            "the number of items");
    }
    /* Each item has two lines of at least two bytes. */
    if (!status && number[0] > (double)strlen(r->at)) {
        status = bad(r, "has fewer lines than items", NULL);
    }
    *n = status ? 0 : (size_t)number[0];
    return status;
}

/* "OBST" or "VENT" and the count; then for each item a line with six
 * coordinates, a number and `surfaces` surfaces; then for each item a line with
 * the nodes. *out must be NULL before: a mesh has one section of a kind. */
static murk_status read_items(reader *r, const murk_fds_mesh *mesh,
                              size_t surfaces, murk_fds_item **out, size_t *n)
{
    double number[NUMBERS_MAX] = {0};
    murk_status status = read_count(r, n);
    if (!status && *out) {
        status = bad(r, "items of one mesh are given twice", NULL);
    }
    if (status) {
        return status;
    }
    murk_fds_item *item = *out = calloc(*n + 1, sizeof *item);
    if (!item) {
        return murk_no_memory(r->err, r->where, "for %zu items", *n);
    }
    /* The surfaces of all items, then the nodes of all items. */
    for (size_t i = 0; i < *n && !status; ++i) {
        status = need_numbers(r, 7 + surfaces, number);
        for (size_t k = 0; k < surfaces && !status; ++k) {
            status = need_whole(r, number[7 + k], 0, MURK_FDS_ITEMS_MAX,
                                "the number of a surface");
            item[i].surface[k] = status ? 0 : (uint32_t)number[7 + k];
        }
    }
    for (size_t i = 0; i < *n && !status; ++i) {
        status = need_numbers(r, 6, number);
        if (!status) {
            status = take_nodes(r, mesh, number, &item[i].nodes);
        }
    }
    return status;
}

static murk_status read_obstructions(reader *r)
{
    murk_fds_mesh *mesh = NULL;
    const murk_status status = find_mesh(r, &mesh);
    return status ? status
                  : read_items(r, mesh, 6, &mesh->obstruction,
                               &mesh->obstructions);
}

static murk_status read_vents(reader *r)
{
    murk_fds_mesh *mesh = NULL;
    const murk_status status = find_mesh(r, &mesh);
    return status ? status : read_items(r, mesh, 1, &mesh->vent, &mesh->vents);
}

static murk_status read_surface(reader *r)
{
    murk_fds_run *run = r->run;
    char(*all)[MURK_FDS_NAME_SIZE] = with_capacity(
        run->surface, run->surfaces, &r->capacity_surfaces, sizeof *all);
    if (!all) {
        return murk_no_memory(r->err, r->where, "for its surfaces");
    }
    run->surface = all;
    return need_name(r, all[run->surfaces++], sizeof *all);
}

/* "HIDE_OBST mesh", then the number of the obstruction and the time. */
static murk_status read_event(reader *r, const char *rest, bool is_vent,
                              bool is_there)
{
    murk_fds_run *run = r->run;
    double mesh[NUMBERS_MAX], number[NUMBERS_MAX];
    /* Numbers of the mesh and of the item count from 1 on. */
    if (read_numbers(rest, mesh) < 1) {
        return bad(r, "misses the number of the mesh", r->text);
    }
    murk_status status = need_whole(r, mesh[0], 1, MURK_FDS_MESHES_MAX,
                                    "the number of the mesh");
    if (!status) {
        status = need_numbers(r, 2, number);
    }
    if (!status) {
        status = need_whole(r, number[0], 1, MURK_FDS_ITEMS_MAX,
                            "the number of the item");
    }
    if (status) {
        return status;
    }
    murk_fds_event *all = with_capacity(run->event, run->events,
                                        &r->capacity_events, sizeof *all);
    if (!all) {
        return murk_no_memory(r->err, r->where, "for its events");
    }
    run->event = all;
    all[run->events++] = (murk_fds_event){.time_s = number[1],
                                          .mesh = (uint32_t)mesh[0] - 1,
                                          .item = (uint32_t)number[0] - 1,
                                          .is_vent = is_vent,
                                          .is_there = is_there};
    return MURK_OK;
}

/* A data file: the mesh, then lines with the name of the file, the quantity, a
 * short name and the unit. */
static murk_status read_data(reader *r, const char *rest, murk_fds_kind kind)
{
    murk_fds_run *run = r->run;
    const unsigned line = r->line;
    double number[NUMBERS_MAX], nodes[NUMBERS_MAX];
    const size_t n = read_numbers(rest, number);
    const char *after = strchr(rest, '&');
    if (n < 1) {
        return bad(r, "misses the number of the mesh", r->text);
    }
    /* The first line: mesh, and of a slice the grid lines after '&'. */
    murk_fds_data data = {.kind = kind, .line = line};
    murk_status status = need_whole(r, number[0], 1, MURK_FDS_MESHES_MAX,
                                    "the number of the mesh");
    if (!status && kind != MURK_FDS_SMOKE3D &&
        (!after || read_numbers(after + 1, nodes) < 6)) {
        status = bad(r, "misses the six grid lines of the slice", r->text);
    }
    for (int i = 0; i < 6 && kind != MURK_FDS_SMOKE3D && !status; ++i) {
        status = need_whole(r, nodes[i], 0, MURK_FIELD_CELLS_MAX,
                            "the number of a grid line");
        int32_t *const of = i % 2 ? data.nodes.high : data.nodes.low;
        of[i / 2] = status ? 0 : (int32_t)nodes[i];
    }
    if (status) {
        return status;
    }
    data.mesh = (uint32_t)number[0] - 1;
    data.mass_extinction = kind == MURK_FDS_SMOKE3D && n >= 2 ? number[1] : 0;
    /* Four lines of names. */
    char short_name[MURK_FDS_NAME_SIZE];
    status = need_name(r, data.file, sizeof data.file);
    if (!status) {
        status = need_name(r, data.quantity, sizeof data.quantity);
    }
    if (!status) {
        status = need_name(r, short_name, sizeof short_name);
    }
    if (!status) {
        status = need_name(r, data.unit, sizeof data.unit);
    }
    if (status) {
        return status;
    }
    murk_fds_data *all =
        with_capacity(run->data, run->files, &r->capacity_files, sizeof *all);
    if (!all) {
        return murk_no_memory(r->err, r->where, "for its list of files");
    }
    run->data = all;
    all[run->files++] = data;
    return MURK_OK;
}

/* Reads the section that a line begins; lines that begin none are skipped.
 * Keywords begin in the first column, and names, which may be like keywords,
 * are indented. */
static murk_status read_section(reader *r)
{
    /* The keyword and the rest of the line. */
    size_t length = 0;
    while (isupper((unsigned char)r->text[length]) ||
           isdigit((unsigned char)r->text[length]) || r->text[length] == '_') {
        ++length;
    }
    const char *rest = r->text + length;
    if (r->is_indented || length == 0 ||
        (*rest && !isspace((unsigned char)*rest))) {
        return MURK_OK;
    }
    while (isspace((unsigned char)*rest)) {
        ++rest;
    }
#define IS(word) (strlen(word) == length && memcmp(r->text, word, length) == 0)
    if (IS("GRID")) {
        return read_grid(r, rest);
    }
    if (IS("TRNX") || IS("TRNY") || IS("TRNZ")) {
        return read_edges(r, r->text[3] - 'X');
    }
    if (IS("OBST")) {
        return read_obstructions(r);
    }
    if (IS("VENT")) {
        return read_vents(r);
    }
    if (IS("GEOM") && r->run->geom_line > 0) {
        return bad(r, "has a second section GEOM, must have one", NULL);
    }
    if (IS("GEOM")) {
        r->run->geom_line = r->line;
        return need_name(r, r->run->geom, sizeof r->run->geom);
    }
    if (IS("SURFDEF")) {
        return need_name(r, r->run->usual, sizeof r->run->usual);
    }
    if (IS("SURFACE")) {
        return read_surface(r);
    }
    if (IS("SHOW_OBST") || IS("HIDE_OBST")) {
        return read_event(r, rest, false, IS("SHOW_OBST"));
    }
    if (IS("OPEN_VENT") || IS("CLOSE_VENT")) {
        return read_event(r, rest, true, IS("OPEN_VENT"));
    }
    if (IS("SMOKF3D") || IS("SMOKE3D")) {
        return read_data(r, rest, MURK_FDS_SMOKE3D);
    }
    if (IS("SLCF") || IS("SLCC")) {
        return read_data(
            r, rest, IS("SLCC") ? MURK_FDS_SLICE_CELLS : MURK_FDS_SLICE_NODES);
    }
#undef IS
    return MURK_OK;
}

/* ---- checks of the whole ---- */

/* Data files lie beside the .smv file; a name, of at most size - 2 bytes, must
 * not lead elsewhere. */
static murk_status check_name(const reader *at, const char *file, size_t size)
{
    const bool is_beside = file[0] != '\0' && file[0] != '.' &&
                           !strchr(file, '/') && strlen(file) + 1 < size;
    return is_beside
               ? MURK_OK
               : bad(at, "a data file must lie in the folder of the .smv file",
                     file);
}

static murk_status check_data(const reader *r, const murk_fds_data *data)
{
    const murk_fds_run *run = r->run;
    const reader at = {.where = r->where, .line = data->line, .err = r->err};
    if (data->mesh >= run->meshes) {
        return bad(&at, "the mesh of a data file is not there", NULL);
    }
    const murk_status status = check_name(&at, data->file, sizeof data->file);
    if (status) {
        return status;
    }
    const murk_fds_mesh *mesh = &run->mesh[data->mesh];
    for (int axis = 0; axis < 3 && data->kind != MURK_FDS_SMOKE3D; ++axis) {
        if (data->nodes.low[axis] > data->nodes.high[axis] ||
            (size_t)data->nodes.high[axis] > mesh->cells[axis]) {
            return bad(&at, "a slice lies outside of its mesh", NULL);
        }
    }
    return MURK_OK;
}

static murk_status check_mesh(const reader *r, const murk_fds_mesh *mesh)
{
    const murk_fds_run *run = r->run;
    bool is_good = mesh->edge[0] && mesh->edge[1] && mesh->edge[2];
    if (!is_good) {
        return bad(r, "a mesh misses grid lines", mesh->name);
    }
    for (size_t i = 0; i < mesh->obstructions && is_good; ++i) {
        for (int face = 0; face < 6; ++face) {
            is_good =
                is_good && mesh->obstruction[i].surface[face] < run->surfaces;
        }
    }
    for (size_t i = 0; i < mesh->vents && is_good; ++i) {
        is_good = mesh->vent[i].surface[0] < run->surfaces;
    }
    return is_good
               ? MURK_OK
               : bad(r, "a mesh has a surface that is not there", mesh->name);
}

static murk_status check_run(const reader *r)
{
    const murk_fds_run *run = r->run;
    murk_status status =
        run->meshes > 0 ? MURK_OK
                        : bad(r, "has no GRID: is no .smv file of FDS", NULL);
    for (size_t i = 0; i < run->surfaces; ++i) {
        if (strcmp(run->surface[i], run->usual) == 0) {
            r->run->usual_surface = (uint32_t)i;
        }
    }
    if (!status && run->surfaces == 0) {
        status = bad(r, "has no SURFACE", NULL);
    }
    for (size_t i = 0; i < run->meshes && !status; ++i) {
        status = check_mesh(r, &run->mesh[i]);
    }
    if (!status && run->geom_line > 0) {
        const reader at = {
            .where = r->where, .line = run->geom_line, .err = r->err};
        status = check_name(&at, run->geom, sizeof run->geom);
    }
    for (size_t i = 0; i < run->files && !status; ++i) {
        status = check_data(r, &run->data[i]);
    }
    /* Obstructions and vents of events. */
    for (size_t i = 0; i < run->events && !status; ++i) {
        const murk_fds_event *event = &run->event[i];
        const bool is_there =
            event->mesh < run->meshes &&
            event->item < (event->is_vent
                               ? run->mesh[event->mesh].vents
                               : run->mesh[event->mesh].obstructions);
        status = is_there ? MURK_OK
                          : bad(r,
                                "an event names an obstruction or vent "
                                "that is not there",
                                NULL);
    }
    return status;
}

murk_status murk_fds_run_read(murk_fds_run **out, const char *path,
                              const char *where, murk_error *err)
{
    char *text = NULL;
    size_t size = 0;
    murk_error why = {0};
    murk_status status = murk_file_read(&text, &size, path, FILE_MAX, &why);
    if (status) {
        return murk_fail(err, status, where, "%s", why.text);
    }
    murk_fds_run *run = calloc(1, sizeof *run);
    murk_error own = {0};
    reader r = {
        .at = text, .run = run, .where = where, .err = err ? err : &own};
    status = run ? MURK_OK : murk_no_memory(err, where, "for its meshes");
    if (!status && strlen(text) != size) {
        status = bad(&r, "is not a text", NULL);
    }
    /* Read section by section, then check the whole. */
    while (!status && next_line(&r)) {
        status = read_section(&r);
    }
    if (!status) {
        status = check_run(&r);
    }
    free(text);
    if (status) {
        murk_fds_run_destroy(run);
        return status;
    }
    *out = run;
    return MURK_OK;
}

void murk_fds_run_destroy(murk_fds_run *run)
{
    if (!run) {
        return;
    }
    for (size_t i = 0; i < run->meshes; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            free(run->mesh[i].edge[axis]);
        }
        free(run->mesh[i].obstruction);
        free(run->mesh[i].vent);
    }
    free(run->mesh);
    free(run->surface);
    free(run->event);
    free(run->data);
    free(run);
}

bool murk_fds_is_open(const murk_fds_run *run, uint32_t surface)
{
    return strcmp(run->surface[surface], "OPEN") == 0;
}
