/* Writes points and triangles: PLY files vertex by vertex, and VTK's XML poly
 * data (.vtp) array by array, as raw bytes in appended mode.
 *
 * Source of the VTK format: Schroeder, Martin, Lorensen, The Visualization
 * Toolkit, 4th ed., Kitware, 2006, and the notes on its file formats. */
#include "results/mesh_file.h"

#include "base/interrupt.h"
#include "base/progress.h"
#include "results/vtk.h"
#include "scene/places.h"

#include <assert.h>
#include <string.h>

#define SHOWN_EVERY 65536 /* items between two updates of the progress */
#define RECORD_MAX  64    /* bytes of a record; the longest is 40 */
#define NAME_SIZE   32    /* of a file: "surfaces.vtp" */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are written as they lie in memory");

static const struct {
    const char *ply, *vtk;
    size_t bytes;
} types[] = {[MURK_MESH_FLOAT] = {"float", "Float32", 4},
             [MURK_MESH_UINT8] = {"uchar", "UInt8", 1},
             [MURK_MESH_UINT16] = {"ushort", "UInt16", 2},
             [MURK_MESH_UINT32] = {"uint", "UInt32", 4}};

static size_t bytes_of(const murk_mesh_column *column)
{
    return types[column->type].bytes * column->components;
}

/* Counts item i as written; progress is updated every SHOWN_EVERY items. False
 * when interrupted. */
static bool count(size_t i)
{
    if ((i + 1) % SHOWN_EVERY != 0) {
        return true;
    }
    murk_progress_add(SHOWN_EVERY);
    return !murk_interrupted();
}

static murk_status interrupted(const murk_mesh_export *v, bool goes_on,
                               murk_error *err)
{
    return goes_on ? MURK_OK
                   : murk_fail(err, MURK_INTERRUPTED, v->name, "interrupted");
}

/* ---- PLY ---- */

murk_ply murk_mesh_begin(FILE *to, const murk_scene_desc *scene,
                         const char *comments)
{
    fprintf(to, "ply\nformat binary_little_endian 1.0\n%s", comments);
    return (murk_ply){.to = to, .scene = scene};
}

/* Writes the properties of columns to the header. Returns the bytes of a
 * record. */
static size_t put_properties(FILE *to, const murk_mesh_column *column, size_t n)
{
    size_t bytes = 0;
    for (size_t k = 0; k < n; ++k, ++column) {
        for (size_t i = 0; i < column->components; ++i) {
            fprintf(to, "property %s %s\n", types[column->type].ply,
                    column->component[i] ? column->component[i] : column->name);
        }
        bytes += bytes_of(column);
    }
    assert(bytes <= RECORD_MAX);
    return bytes;
}

void murk_mesh_vertices(murk_ply *ply, size_t n, const murk_mesh_column *column,
                        size_t columns)
{
    fprintf(ply->to, "element vertex %zu\n%s", n, murk_place_ply(ply->scene));
    ply->vertex_bytes = put_properties(ply->to, column, columns);
}

void murk_mesh_faces(murk_ply *ply, size_t n, const murk_mesh_column *column,
                     size_t columns)
{
    fprintf(ply->to,
            "element face %zu\nproperty list uchar int vertex_indices\n", n);
    ply->face_bytes = put_properties(ply->to, column, columns);
}

void murk_mesh_end_header(const murk_ply *ply)
{
    fputs("end_header\n", ply->to);
}

void murk_mesh_put_vertex(const murk_ply *ply, murk_vec3 position,
                          const void *record)
{
    unsigned char bytes[MURK_PLACE_BYTES_MAX + RECORD_MAX];
    const size_t place = murk_place_bytes(ply->scene);
    murk_place_put(ply->scene, position, bytes);
    memcpy(bytes + place, record, ply->vertex_bytes);
    /* failures show when the file is committed */
    (void)fwrite(bytes, 1, place + ply->vertex_bytes, ply->to);
}

void murk_mesh_put_face(const murk_ply *ply, size_t a, size_t b, size_t c,
                        const void *record)
{
    const uint32_t corner[3] = {(uint32_t)a, (uint32_t)b, (uint32_t)c};
    fputc(3, ply->to);
    (void)fwrite(corner, sizeof corner, 1, ply->to);
    if (record) {
        (void)fwrite(record, ply->face_bytes, 1, ply->to);
    }
}

/* ---- .vtp ---- */

/* The arrays of a file, in order. */
enum { PLACES, CONNECTIVITY, OFFSETS, FIRST_COLUMN };

typedef struct array {
    const char *type, *name;
    size_t components, item_bytes, items;
    size_t begin; /* of a column in the record */
} array;

/* Number of cells: the triangles; points without triangles are one cell, or no
 * cell if there are no points. */
static size_t cells_of(const murk_mesh_export *v)
{
    return v->has_triangles ? v->points / 3 : v->points > 0;
}

/* Number of records: one for each triangle, or for each point if the mesh has
 * no triangles. */
static size_t items_of(const murk_mesh_export *v)
{
    return v->has_triangles ? v->points / 3 : v->points;
}

static array array_of(const murk_mesh_export *v, size_t number)
{
    if (number == PLACES) {
        return (array){murk_place_vtk(v->scene),   "place",   3,
                       murk_place_bytes(v->scene), v->points, 0};
    }
    if (number == CONNECTIVITY) {
        return (array){"Int64", "connectivity", 1, 8, v->points, 0};
    }
    if (number == OFFSETS) {
        return (array){"Int64", "offsets", 1, 8, cells_of(v), 0};
    }
    const murk_mesh_column *column =
        &v->column[v->order[number - FIRST_COLUMN]];
    size_t begin = 0;
    for (const murk_mesh_column *before = v->column; before < column;
         ++before) {
        begin += bytes_of(before);
    }
    return (array){types[column->type].vtk, column->name, column->components,
                   bytes_of(column),        items_of(v),  begin};
}

/* Writes the element of an array, whose bytes begin at *offset, to the header,
 * and moves *offset behind them. */
static void announce(FILE *to, const murk_mesh_export *v, size_t number,
                     uint64_t *offset)
{
    const array a = array_of(v, number);
    fprintf(to,
            "        <DataArray type=\"%s\" Name=\"%s\" "
            "NumberOfComponents=\"%zu\" format=\"appended\" "
            "offset=\"%llu\"/>\n",
            a.type, a.name, a.components, (unsigned long long)*offset);
    *offset += sizeof(uint64_t) + a.items * a.item_bytes;
}

static void put_header(FILE *to, const murk_mesh_export *v)
{
    const char *cells = v->has_triangles ? "Polys" : "Verts";
    const char *data = v->has_triangles ? "CellData" : "PointData";
    uint64_t offset = 0;
    /* field data: the origin of the file, and the meaning of its numbers */
    murk_vtk_begin(to, "PolyData");
    fputs("  <PolyData>\n    <FieldData>\n", to);
    murk_vtk_put_facts(to, v->scene, v->notes);
    /* points, cells and columns, whose bytes follow the header */
    fprintf(to,
            "    </FieldData>\n"
            "    <Piece NumberOfPoints=\"%zu\" NumberOf%s=\"%zu\">\n"
            "      <Points>\n",
            v->points, cells, cells_of(v));
    announce(to, v, PLACES, &offset);
    fprintf(to, "      </Points>\n      <%s>\n", cells);
    announce(to, v, CONNECTIVITY, &offset);
    announce(to, v, OFFSETS, &offset);
    fprintf(to, "      </%s>\n      <%s Scalars=\"%s\">\n", cells, data,
            v->column[v->order[0]].name);
    for (size_t k = 0; k < v->columns; ++k) {
        announce(to, v, FIRST_COLUMN + k, &offset);
    }
    fprintf(to,
            "      </%s>\n    </Piece>\n  </PolyData>\n"
            "  <AppendedData encoding=\"raw\">\n_",
            data);
}

static void put_item(FILE *to, const murk_mesh_export *v, size_t number,
                     const array *a, size_t i)
{
    unsigned char bytes[RECORD_MAX];
    if (number == PLACES) {
        murk_place_put(v->scene, v->position(v->context, i), bytes);
    } else if (number < FIRST_COLUMN) {
        /* points are numbered in order; an offset is the end of a cell */
        const size_t end = v->has_triangles ? 3 * (i + 1) : v->points;
        const int64_t value = (int64_t)(number == CONNECTIVITY ? i : end);
        memcpy(bytes, &value, sizeof value);
    } else {
        v->record(v->context, i, bytes);
    }
    (void)fwrite(bytes + a->begin, a->item_bytes, 1, to);
}

/* False when interrupted. */
static bool put_array(FILE *to, const murk_mesh_export *v, size_t number)
{
    const array a = array_of(v, number);
    const uint64_t bytes = a.items * a.item_bytes;
    (void)fwrite(&bytes, sizeof bytes, 1, to);
    bool goes_on = true;
    for (size_t i = 0; goes_on && i < a.items; ++i) {
        put_item(to, v, number, &a, i);
        goes_on = count(i);
    }
    murk_progress_add(a.items % SHOWN_EVERY);
    return goes_on;
}

murk_status murk_vtp_write(FILE *to, const void *mesh, murk_error *err)
{
    const murk_mesh_export *v = mesh;
    char step[NAME_SIZE];
    bool goes_on = true;
    put_header(to, v);
    snprintf(step, sizeof step, "%s.vtp", v->name);
    murk_progress_begin(
        step, 2 * v->points + cells_of(v) + v->columns * items_of(v), "values");
    for (size_t k = 0; goes_on && k < FIRST_COLUMN + v->columns; ++k) {
        goes_on = put_array(to, v, k);
    }
    murk_progress_end();
    fputs("\n  </AppendedData>\n</VTKFile>\n", to);
    return interrupted(v, goes_on, err);
}

/* ---- both files ---- */

static murk_status write_ply(FILE *to, const void *context, murk_error *err)
{
    const murk_mesh_export *v = context;
    const size_t faces = v->has_triangles ? items_of(v) : 0;
    unsigned char record[RECORD_MAX];
    char step[NAME_SIZE];
    bool goes_on = true;
    /* The header: origin, meaning of numbers, properties. */
    murk_ply ply = murk_mesh_begin(to, v->scene, v->comment);
    murk_ply_put_facts(to, v->scene, v->notes);
    murk_mesh_vertices(&ply, v->points, v->column,
                       v->has_triangles ? 1 : v->columns);
    if (v->has_triangles) {
        murk_mesh_faces(&ply, faces, v->column, v->columns);
    }
    murk_mesh_end_header(&ply);
    /* Points, then triangles. */
    snprintf(step, sizeof step, "%s.ply", v->name);
    murk_progress_begin(step, v->points + faces, v->name);
    for (size_t i = 0; goes_on && i < v->points; ++i) {
        v->record(v->context, v->has_triangles ? i / 3 : i, record);
        murk_mesh_put_vertex(&ply, v->position(v->context, i), record);
        goes_on = count(i);
    }
    for (size_t i = 0; goes_on && i < faces; ++i) {
        v->record(v->context, i, record);
        murk_mesh_put_face(&ply, 3 * i, 3 * i + 1, 3 * i + 2, record);
        goes_on = count(i);
    }
    murk_progress_end();
    return interrupted(v, goes_on, err);
}

void murk_mesh_add(murk_results *results, const murk_mesh_export *mesh,
                   murk_error *late)
{
    char name[NAME_SIZE];
    snprintf(name, sizeof name, "%s.ply", mesh->name);
    (void)murk_results_add_stream(results, name, write_ply, mesh, late);
    snprintf(name, sizeof name, "%s.vtp", mesh->name);
    (void)murk_results_add_stream(results, name, murk_vtp_write, mesh, late);
}
