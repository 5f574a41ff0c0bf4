/* Writes VTK's XML poly data (.vtp) with arrays of raw bytes in appended mode,
 * and the parts that it shares with .vti and PLY files: facts of the origin as
 * field data or as comments. */
#include "results/vtk.h"

#include "base/file.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "results/version.h"

#include <string.h>

#define SHOWN_EVERY 65536 /* items between two looks at the bar */
#define ITEM_BYTES  24    /* at most: a place in doubles */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are written as they lie in memory");

/* ---- where it is from ---- */

void murk_facts_of(murk_facts *out, const murk_scene_desc *scene)
{
    snprintf(out->seed, sizeof out->seed, "%lu", (unsigned long)scene->seed);
    const char *const facts[MURK_FACTS] = {"scene",
                                           scene->path,
                                           "scene_sha256",
                                           scene->sha256,
                                           "seed",
                                           out->seed,
                                           "murk_version",
                                           MURK_VERSION,
                                           "murk_commit",
                                           murk_version_commit(),
                                           NULL};
    memcpy(out->fact, facts, sizeof facts);
}

void murk_ply_put_comment(FILE *to, const char *key, const char *text)
{
    fprintf(to, "comment %s ", key);
    for (const char *c = text; *c; ++c) {
        const unsigned char byte = (unsigned char)*c;
        fputc(byte < ' ' || byte == 127 ? '?' : byte, to);
    }
    fputc('\n', to);
}

void murk_ply_put_facts(FILE *to, const murk_scene_desc *scene)
{
    murk_facts facts = {0};
    murk_facts_of(&facts, scene);
    for (const char *const *fact = facts.fact; fact[0]; fact += 2) {
        murk_ply_put_comment(to, fact[0], fact[1]);
    }
}

void murk_vtk_put_text(FILE *to, const char *name, const char *text)
{
    fprintf(to,
            "      <DataArray type=\"String\" Name=\"%s\" "
            "NumberOfTuples=\"1\" format=\"ascii\">",
            name);
    for (const char *c = text; *c; ++c) {
        fprintf(to, "%d ", (unsigned char)*c);
    }
    fputs("0</DataArray>\n", to);
}

void murk_vtk_put_facts(FILE *to, const murk_scene_desc *scene)
{
    murk_facts facts = {0};
    murk_facts_of(&facts, scene);
    for (const char *const *fact = facts.fact; fact[0]; fact += 2) {
        murk_vtk_put_text(to, fact[0], fact[1]);
    }
}

void murk_vtk_begin(FILE *to, const char *type)
{
    fprintf(to,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"%s\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
            type);
}

/* ---- .vtp ---- */

typedef struct file {
    const murk_vtp *vtp;
    FILE *to;
    uint64_t offset; /* of the next array, behind those announced */
} file;

static size_t cells_of(const murk_vtp *vtp)
{
    return vtp->has_triangles ? vtp->points / 3 : vtp->points > 0;
}

/* Arrays of one value or more an item of each cell. */
static size_t items_of(const murk_vtp *vtp)
{
    return vtp->has_triangles ? vtp->points / 3 : vtp->points;
}

static void announce(file *f, const murk_vtk_array *array, size_t items)
{
    fprintf(f->to,
            "        <DataArray type=\"%s\" Name=\"%s\" "
            "NumberOfComponents=\"%zu\" format=\"appended\" "
            "offset=\"%llu\"/>\n",
            array->type, array->name, array->components,
            (unsigned long long)f->offset);
    f->offset += sizeof(uint64_t) + items * array->item_bytes;
}

static void put_number(const void *context, size_t i, void *item)
{
    const int64_t number = (int64_t)i;
    (void)context;
    memcpy(item, &number, sizeof number);
}

static void put_third(const void *context, size_t i, void *item)
{
    const int64_t number = 3 * ((int64_t)i + 1);
    (void)context;
    memcpy(item, &number, sizeof number);
}

static void put_all(const void *context, size_t i, void *item)
{
    const int64_t number = (int64_t)((const murk_vtp *)context)->points;
    (void)i;
    memcpy(item, &number, sizeof number);
}

static const murk_vtk_array connectivity = {"connectivity", "Int64", 1, 8,
                                            put_number};
static const murk_vtk_array by_threes = {"offsets", "Int64", 1, 8, put_third};
static const murk_vtk_array all_at_once = {"offsets", "Int64", 1, 8, put_all};

static const murk_vtk_array *offsets_of(const murk_vtp *vtp)
{
    return vtp->has_triangles ? &by_threes : &all_at_once;
}

static void put_header(file *f)
{
    const murk_vtp *v = f->vtp;
    const char *cells = v->has_triangles ? "Polys" : "Verts";
    const char *data = v->has_triangles ? "CellData" : "PointData";
    murk_vtk_begin(f->to, "PolyData");
    fputs("  <PolyData>\n    <FieldData>\n", f->to);
    murk_vtk_put_facts(f->to, v->scene);
    for (const char *const *note = v->notes; note && note[0]; note += 2) {
        murk_vtk_put_text(f->to, note[0], note[1]);
    }
    fprintf(f->to,
            "    </FieldData>\n"
            "    <Piece NumberOfPoints=\"%zu\" NumberOf%s=\"%zu\">\n"
            "      <Points>\n",
            v->points, cells, cells_of(v));
    announce(f, &v->place, v->points);
    fprintf(f->to, "      </Points>\n      <%s>\n", cells);
    announce(f, &connectivity, v->points);
    announce(f, offsets_of(v), cells_of(v));
    fprintf(f->to, "      </%s>\n      <%s Scalars=\"%s\">\n", cells, data,
            v->array[0].name);
    for (size_t k = 0; k < v->arrays; ++k) {
        announce(f, &v->array[k], items_of(v));
    }
    fprintf(f->to,
            "      </%s>\n    </Piece>\n  </PolyData>\n"
            "  <AppendedData encoding=\"raw\">\n_",
            data);
}

/* False when interrupted. */
static bool put_array(file *f, const murk_vtk_array *array, size_t items,
                      const void *context)
{
    const uint64_t bytes = items * array->item_bytes;
    unsigned char item[ITEM_BYTES];
    (void)fwrite(&bytes, sizeof bytes, 1, f->to); /* commit asks ferror */
    for (size_t i = 0; i < items; ++i) {
        array->put(context, i, item);
        (void)fwrite(item, array->item_bytes, 1, f->to);
        if ((i + 1) % SHOWN_EVERY == 0) {
            murk_progress_add(SHOWN_EVERY);
            if (murk_interrupted()) {
                return false;
            }
        }
    }
    murk_progress_add(items % SHOWN_EVERY);
    return true;
}

static bool put_arrays(file *f)
{
    const murk_vtp *v = f->vtp;
    bool goes_on = put_array(f, &v->place, v->points, v->context) &&
                   put_array(f, &connectivity, v->points, v) &&
                   put_array(f, offsets_of(v), cells_of(v), v);
    for (size_t k = 0; goes_on && k < v->arrays; ++k) {
        goes_on = put_array(f, &v->array[k], items_of(v), v->context);
    }
    return goes_on;
}

murk_status murk_vtp_write(const murk_vtp *vtp, const char *path,
                           murk_error *err)
{
    murk_file *out = NULL;
    const murk_status status = murk_file_create(&out, path, err);
    if (status) {
        return status;
    }
    file f = {.vtp = vtp, .to = murk_file_stream(out)};
    put_header(&f);
    murk_progress_begin(vtp->step,
                        2 * vtp->points + cells_of(vtp) +
                            vtp->arrays * items_of(vtp),
                        "values");
    const bool is_whole = put_arrays(&f);
    murk_progress_end();
    fputs("\n  </AppendedData>\n</VTKFile>\n", f.to);
    if (!is_whole) {
        murk_file_discard(out);
        return murk_fail(err, MURK_INTERRUPTED, path, "interrupted");
    }
    return murk_file_commit(&out, err);
}
