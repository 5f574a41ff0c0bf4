/* Extinction of an FDS run at one time (fds/extinction.h): finds the data file
 * of each mesh, reads the frames around the time, and converts the values. */
#include "fds/extinction.h"

#include "base/interval.h"
#include "base/path.h"
#include "fds/frames.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BYTE_MAX_VALUE  254.0  /* the byte of an opaque cell */
#define BYTE_AT_LEAST   253.5  /* the least that rounds to it */
#define VISIBILITY_C    3.0    /* fds/extinction.h */
#define MASS_EXTINCTION 8700.0 /* [m2/kg] */

/* A time this close to that of a frame is the time of the frame, as a share of
 * the time: times of files are in single precision, and users read them with
 * seven digits. */
#define SAME_TIME 1e-6

/* Values below 0 by this share of the largest, or of 1 /m, are rounding. */
#define NEGATIVE_MAX 1e-3

const char *const murk_fds_quantity_names[3] = {"soot density", "extinction",
                                                "visibility"};

typedef struct reading {
    const murk_fds_run *run;
    const murk_fds_asked *asked;
    const char *path, *where;
    murk_fds_field *field;
    float visibility_max; /* the largest of all values [m] */
    murk_error *err;
} reading;

/* ---- choice of files ---- */

static bool ends_with(const char *text, const char *end)
{
    const size_t n = strlen(text), m = strlen(end);
    return n >= m && strcmp(text + n - m, end) == 0;
}

/* True if a data file has the quantity that is asked for. FDS puts the name of
 * the species before extinction and visibility. */
static bool has_quantity(const murk_fds_data *data, murk_fds_quantity asked)
{
    const bool is_smoke3d = data->kind == MURK_FDS_SMOKE3D;
    switch (asked) {
    case MURK_FDS_SOOT_DENSITY:
        return strcmp(data->quantity, "SOOT DENSITY") == 0;
    case MURK_FDS_EXTINCTION:
        return !is_smoke3d &&
               ends_with(data->quantity, "EXTINCTION COEFFICIENT");
    case MURK_FDS_VISIBILITY:
        return !is_smoke3d && ends_with(data->quantity, "VISIBILITY");
    }
    return false;
}

/* The number of cells that a slice spans; 0 for a plane. */
static double cells_of(const murk_fds_data *data)
{
    double cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        cells *= data->nodes.high[axis] - data->nodes.low[axis];
    }
    return cells;
}

/* The data file of a mesh; NULL if there is none. Slices that fill a space,
 * whose numbers are not rounded, come before .s3d files, and the slice of more
 * cells before others. */
static const murk_fds_data *find_data(const reading *r, size_t mesh)
{
    const murk_fds_data *best = NULL;
    double largest = 0;
    for (size_t i = 0; i < r->run->files; ++i) {
        const murk_fds_data *data = &r->run->data[i];
        if (data->mesh != mesh || !has_quantity(data, r->asked->quantity)) {
            continue;
        }
        const double cells =
            data->kind == MURK_FDS_SMOKE3D ? 0.5 : cells_of(data);
        if (cells > largest) {
            largest = cells;
            best = data;
        }
    }
    return best;
}

static murk_status no_data(const reading *r, size_t mesh)
{
    char list[512] = "";
    size_t n = 0;
    /* The quantities that fill a space, each once. */
    for (size_t i = 0; i < r->run->files && n + 80 < sizeof list; ++i) {
        const murk_fds_data *data = &r->run->data[i];
        const bool fills = data->kind == MURK_FDS_SMOKE3D || cells_of(data) > 0;
        if (data->mesh == mesh && fills && !strstr(list, data->quantity)) {
            n += (size_t)snprintf(list + n, sizeof list - n, "%s%s",
                                  n ? ", " : "", data->quantity);
        }
    }
    return murk_fail(
        r->err, MURK_BAD_VALUE, r->where,
        "mesh %zu (%s) has no %s in a space (.s3d file or three-dimensional "
        "slice), but %s",
        mesh + 1, r->run->mesh[mesh].name,
        murk_fds_quantity_names[r->asked->quantity],
        n ? list : "nothing at all");
}

/* ---- time ---- */

/* Chooses the frame at the time, or the two around it and the weight of the
 * later one. Fails if the time is before the first or after the last frame. */
static murk_status choose_frames(const reading *r, const murk_fds_frames *f,
                                 murk_bracket *out)
{
    const double t = r->asked->time_s;
    const double same = SAME_TIME * fmax(fabs(t), 1e-3);
    return murk_bracket_find(out, f->time_s, f->n, t, same)
               ? MURK_OK
               : murk_fail(r->err, MURK_BAD_VALUE, r->where,
                           "time_s is %.9g s, must be %.9g to %.9g s, from "
                           "the first to the last of %zu frames",
                           t, f->time_s[0], f->time_s[f->n - 1], f->n);
}

/* ---- values ---- */

/* Converts the bytes of a .s3d file into extinction coefficients. */
static void convert_bytes(const reading *r, float *value, uint64_t n,
                          double cell_m)
{
    float k[256] = {0};
    for (int b = 0; b < 256; ++b) {
        k[b] =
            (float)(-log1p(-fmin(b, BYTE_AT_LEAST) / BYTE_MAX_VALUE) / cell_m);
    }
    murk_fds_field *field = r->field;
    field->is_rounded = true;
    field->step_per_m = fmax(field->step_per_m, (double)k[1]);
    for (uint64_t i = 0; i < n; ++i) {
        const int byte = (int)value[i];
        if (byte >= (int)BYTE_MAX_VALUE) {
            ++field->capped;
            field->capped_per_m = fmax(field->capped_per_m, (double)k[byte]);
        }
        value[i] = k[byte];
    }
}

/* Converts the numbers of a slice. FDS's mass fractions may be slightly below
 * 0; fails if a value is so by more than rounding, or has no meaning. */
static murk_status convert_slice(const reading *r, const murk_fds_frames *f,
                                 float *value)
{
    const double mass_extinction = r->field->mass_extinction;
    double low = 0, high = 0;
    bool are_finite = true;
    /* Each value by its formula, and the range of all. */
    for (uint64_t i = 0; i < f->values; ++i) {
        const double v = (double)value[i];
        const double k =
            r->asked->quantity == MURK_FDS_SOOT_DENSITY ? mass_extinction * v
            : r->asked->quantity == MURK_FDS_VISIBILITY ? VISIBILITY_C / v
                                                        : v;
        are_finite = are_finite && fabs(k) <= FLT_MAX;
        low = fmin(low, k);
        high = fmax(high, k);
        value[i] = (float)fmax(k, 0);
    }
    if (!are_finite || low < -NEGATIVE_MAX * fmax(high, 1)) {
        return murk_fail(r->err, MURK_BAD_FILE, f->where,
                         "has extinctions from %g to %g /m by its %s, must be "
                         "finite and 0 or more",
                         low, high,
                         murk_fds_quantity_names[r->asked->quantity]);
    }
    return MURK_OK;
}

/* Counts the cells with the largest visibility, at which FDS cuts. */
static void count_largest(reading *r, const float *value, uint64_t n)
{
    for (uint64_t i = 0; i < n; ++i) {
        if (value[i] > r->visibility_max) {
            r->visibility_max = value[i];
            r->field->capped = 0;
        }
        r->field->capped += value[i] == r->visibility_max;
    }
    r->field->capped_per_m = VISIBILITY_C / (double)r->visibility_max;
}

/* Reads one frame and converts it. `cell_m` is the first cell along x. */
static murk_status read_frame(reading *r, murk_fds_frames *f, size_t frame,
                              double cell_m, float *value)
{
    const murk_status status = murk_fds_frames_read(f, frame, value, r->err);
    if (status) {
        return status;
    }
    if (f->is_smoke3d) {
        convert_bytes(r, value, f->values, cell_m);
        return MURK_OK;
    }
    if (r->asked->quantity == MURK_FDS_VISIBILITY) {
        count_largest(r, value, f->values);
    }
    return convert_slice(r, f, value);
}

/* Values of cells in a file have a first layer along each axis that means
 * nothing: moves the others to the front. */
static void drop_padding(float *value, const size_t cells[3])
{
    const size_t row = cells[0] + 1, sheet = row * (cells[1] + 1);
    float *to = value;
    for (size_t k = 1; k <= cells[2]; ++k) {
        for (size_t j = 1; j <= cells[1]; ++j) {
            memmove(to, &value[k * sheet + j * row + 1], cells[0] * sizeof *to);
            to += cells[0];
        }
    }
}

/* Reads the frames at the time, and their mean if there are two. */
static murk_status read_values(reading *r, murk_fds_frames *f, double cell_m,
                               float **out)
{
    murk_bracket time = {0};
    murk_status status = choose_frames(r, f, &time);
    if (status) {
        return status;
    }
    /* Read one frame, or two and their mean. */
    const double w = time.weight;
    float *value = malloc(f->values * sizeof *value);
    float *later = w > 0 ? malloc(f->values * sizeof *later) : NULL;
    status = value && (later || !(w > 0))
                 ? read_frame(r, f, time.first, cell_m, value)
                 : murk_no_memory(r->err, f->where, "for a frame");
    if (!status && later) {
        status = read_frame(r, f, time.second, cell_m, later);
    }
    for (uint64_t i = 0; later && !status && i < f->values; ++i) {
        value[i] = (float)((1 - w) * (double)value[i] + w * (double)later[i]);
    }
    free(later);
    if (status) {
        free(value);
        return status;
    }
    r->field->frame_s[0] = f->time_s[time.first];
    r->field->frame_s[1] = f->time_s[time.second];
    r->field->weight = w;
    *out = value;
    return MURK_OK;
}

/* ---- blocks ---- */

/* Sets the edges of a block: the grid lines that the data file spans. */
static murk_status take_edges(const reading *r, const murk_fds_mesh *mesh,
                              const murk_fds_frames *f, murk_field_block *block)
{
    for (int axis = 0; axis < 3; ++axis) {
        const size_t low = (size_t)f->nodes[2 * axis],
                     high = (size_t)f->nodes[2 * axis + 1];
        block->cells[axis] = high - low;
        const size_t bytes = (high - low + 1) * sizeof(double);
        block->edge[axis] = malloc(bytes);
        if (!block->edge[axis]) {
            return murk_no_memory(r->err, f->where, "for its grid lines");
        }
        memcpy(block->edge[axis], &mesh->edge[axis][low], bytes);
    }
    return MURK_OK;
}

/* Fails unless the file has the nodes that the .smv file says. */
static murk_status check_nodes(const reading *r, const murk_fds_data *data,
                               const murk_fds_mesh *mesh,
                               const murk_fds_frames *f)
{
    const bool is_whole = data->kind == MURK_FDS_SMOKE3D;
    for (int axis = 0; axis < 3; ++axis) {
        const int32_t low = is_whole ? 0 : data->nodes.low[axis],
                      high = is_whole ? (int32_t)mesh->cells[axis]
                                      : data->nodes.high[axis];
        if (f->nodes[2 * axis] != low || f->nodes[2 * axis + 1] != high) {
            return murk_fail(r->err, MURK_BAD_FILE, f->where,
                             "has nodes %d to %d along %c, must be %d to %d as "
                             "in the .smv file",
                             f->nodes[2 * axis], f->nodes[2 * axis + 1],
                             'x' + axis, low, high);
        }
    }
    return MURK_OK;
}

/* Reads the block of a mesh. */
static murk_status read_block(reading *r, size_t number,
                              murk_field_block *block)
{
    const murk_fds_mesh *mesh = &r->run->mesh[number];
    const murk_fds_data *data = find_data(r, number);
    if (!data) {
        return no_data(r, number);
    }
    /* Open the file beside the .smv file; grid lines, then values. */
    char *path = murk_path_beside(r->path, data->file);
    if (!path) {
        return murk_no_memory(r->err, r->where, "for the name of a file");
    }
    char place[sizeof r->err->where];
    snprintf(place, sizeof place, "%s: %s", r->where, data->file);
    murk_fds_frames frames = {0};
    murk_status status = murk_fds_frames_open(
        &frames, path, data->kind == MURK_FDS_SMOKE3D, place, r->err);
    if (!status) {
        status = check_nodes(r, data, mesh, &frames);
    }
    if (!status) {
        status = take_edges(r, mesh, &frames, block);
    }
    if (!status) {
        const double cell_m = mesh->edge[0][1] - mesh->edge[0][0];
        status = read_values(r, &frames, cell_m, &block->value);
    }
    block->has_nodes = data->kind != MURK_FDS_SLICE_CELLS;
    if (!status && !block->has_nodes) {
        drop_padding(block->value, block->cells);
    }
    murk_fds_frames_close(&frames);
    free(path);
    return status;
}

/* Fails if two of the meshes overlap: it is not said which of them counts. */
static murk_status check_overlap(const reading *r, const size_t *number)
{
    const murk_fds_field *f = r->field;
    for (size_t i = 0; i < f->n; ++i) {
        for (size_t k = 0; k < i; ++k) {
            bool overlap = true;
            for (int axis = 0; axis < 3; ++axis) {
                overlap = overlap &&
                          murk_field_overlap(
                              f->block[i].edge[axis], f->block[i].cells[axis],
                              f->block[k].edge[axis], f->block[k].cells[axis]);
            }
            if (overlap) {
                return murk_fail(r->err, MURK_BAD_VALUE, r->where,
                                 "meshes %zu and %zu overlap: name one of them "
                                 "with `mesh`",
                                 number[k] + 1, number[i] + 1);
            }
        }
    }
    return MURK_OK;
}

/* ---- the field ---- */

/* The mass extinction coefficient of the run's soot. */
static double mass_extinction_of(const murk_fds_run *run)
{
    for (size_t i = 0; i < run->files; ++i) {
        const murk_fds_data *data = &run->data[i];
        if (has_quantity(data, MURK_FDS_SOOT_DENSITY) &&
            data->mass_extinction > 0) {
            return data->mass_extinction;
        }
    }
    return MASS_EXTINCTION;
}

/* The numbers of the meshes, from 0 on. */
static murk_status choose_meshes(const reading *r, size_t *number)
{
    const murk_fds_asked *asked = r->asked;
    for (size_t i = 0; i < r->field->n; ++i) {
        number[i] = i;
        const double n = asked->n_meshes ? asked->mesh[i] : 0;
        if (asked->n_meshes &&
            !(n >= 1 && n <= (double)r->run->meshes && n == floor(n))) {
            return murk_fail(r->err, MURK_BAD_VALUE, r->where,
                             "mesh is %.9g, must be 1 to %zu", n,
                             r->run->meshes);
        }
        if (asked->n_meshes) {
            number[i] = (size_t)n - 1;
        }
        for (size_t k = 0; k < i; ++k) {
            if (number[k] == number[i]) {
                return murk_fail(r->err, MURK_BAD_VALUE, r->where,
                                 "mesh %zu is there twice, must be named once",
                                 number[i] + 1);
            }
        }
    }
    return MURK_OK;
}

static murk_status read_blocks(reading *r)
{
    murk_fds_field *f = r->field;
    size_t *number = calloc(f->n, sizeof *number);
    f->block = calloc(f->n, sizeof *f->block);
    murk_status status =
        number && f->block
            ? choose_meshes(r, number)
            : murk_no_memory(r->err, r->where, "for %zu meshes", f->n);
    for (size_t i = 0; i < f->n && !status; ++i) {
        status = read_block(r, number[i], &f->block[i]);
    }
    if (!status) {
        status = check_overlap(r, number);
    }
    free(number);
    return status;
}

murk_status murk_fds_field_read(murk_fds_field **out, const char *path,
                                const murk_fds_asked *asked, const char *where,
                                murk_error *err)
{
    murk_fds_run *run = NULL;
    murk_error own = {0};
    reading r = {
        .asked = asked, .path = path, .where = where, .err = err ? err : &own};
    murk_status status = murk_fds_run_read(&run, path, where, r.err);
    if (status) {
        return status;
    }
    /* The field of the chosen meshes. */
    r.run = run;
    r.field = calloc(1, sizeof *r.field);
    if (r.field) {
        r.field->n = asked->n_meshes ? asked->n_meshes : run->meshes;
        r.field->quantity = asked->quantity;
        r.field->mass_extinction = mass_extinction_of(run);
        status = read_blocks(&r);
    } else {
        status = murk_no_memory(r.err, where, "for a field");
    }
    murk_fds_run_destroy(run);
    if (status) {
        murk_fds_field_destroy(r.field);
        return status;
    }
    *out = r.field;
    return MURK_OK;
}

void murk_fds_field_destroy(murk_fds_field *field)
{
    if (!field) {
        return;
    }
    murk_field_blocks_destroy(field->block, field->n);
    free(field);
}
