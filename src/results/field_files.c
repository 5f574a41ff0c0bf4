/* Writes fields on a box of voxels: as OpenVDB grids with metadata, and as VTK
 * image data (.vti), XML before raw bytes in appended mode. */
#include "results/field_files.h"

#include "medium/grid_write.h"
#include "results/vtk.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEPTH_SHOWN 2 /* optical depth over the longest edge */

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
               "numbers are written as they lie in memory");

size_t murk_field_voxels(const murk_field_box *box)
{
    return box->size[0] * box->size[1] * box->size[2];
}

murk_affine murk_field_to_world(const murk_field_box *b)
{
    const murk_vec3 a = b->box.min, all = murk_sub(b->box.max, a);
    const murk_vec3 e =
        murk_vec(all.x / (double)b->size[0], all.y / (double)b->size[1],
                 all.z / (double)b->size[2]);
    return (murk_affine){
        .matrix = {{e.x, 0, 0}, {0, e.y, 0}, {0, 0, e.z}},
        .shift = murk_vec(a.x + e.x / 2, a.y + e.y / 2, a.z + e.z / 2)};
}

float *murk_voxel_fields_add(murk_voxel_fields *fields,
                             const murk_voxel_field *like, int band)
{
    assert(fields->n < MURK_VOXEL_FIELDS_MAX);
    murk_voxel_field *field = &fields->field[fields->n];
    *field = *like;
    field->band = band;
    field->value =
        malloc(murk_field_voxels(&fields->box) * sizeof *field->value + 1);
    if (band >= 0) {
        snprintf(field->name, sizeof field->name, "%.24s_%.9gnm", like->name,
                 fields->scene->band_nm[band]);
    }
    fields->n += field->value != NULL;
    return field->value;
}

void murk_voxel_fields_release(murk_voxel_fields *fields)
{
    for (size_t i = 0; i < fields->n; ++i) {
        free(fields->field[i].value);
    }
    fields->n = 0;
}

/* ---- .vdb ---- */

/* Metadata of a grid: key, text, key, text, ..., NULL. */
#define NOTES 24
typedef struct notes {
    const char *note[NOTES];
    murk_facts facts;
    char band_nm[32];
} notes;

static void put_note(notes *out, size_t *n, const char *key, const char *text)
{
    assert(*n + 2 < NOTES);
    out->note[(*n)++] = key;
    out->note[(*n)++] = text;
}

static void make_notes(notes *out, const murk_scene_desc *scene,
                       const murk_voxel_field *field)
{
    size_t n = 0;
    *out = (notes){.band_nm = "all"};
    murk_facts_of(&out->facts, scene);
    if (field->band >= 0) {
        snprintf(out->band_nm, sizeof out->band_nm, "%.9g",
                 scene->band_nm[field->band]);
    }
    put_note(out, &n, "unit", field->unit);
    put_note(out, &n, "quantity", field->quantity);
    if (field->meaning) {
        put_note(out, &n, "meaning", field->meaning);
    }
    put_note(out, &n, "band_nm", out->band_nm);
    for (const char *const *fact = out->facts.fact; fact[0]; fact += 2) {
        put_note(out, &n, fact[0], fact[1]);
    }
}

typedef struct vdb {
    const murk_voxel_fields *fields;
    murk_field_density density;
} vdb;

static double longest_edge_m(const murk_box *box)
{
    const murk_vec3 e = murk_sub(box->max, box->min);
    return fmax(fmax(e.x, e.y), e.z);
}

/* The factor of `density` on the first field. */
static double factor_of(const vdb *v)
{
    const murk_field_box *box = &v->fields->box;
    double sum = 0;
    size_t lit = 0;
    for (size_t i = 0; i < murk_field_voxels(box); ++i) {
        const float value = v->fields->field[0].value[i];
        if (value > 0) {
            sum += (double)value;
            ++lit;
        }
    }
    const double mean = lit > 0 ? sum / (double)lit : 0;
    return v->density == MURK_DENSITY_EQUAL || !(mean > 0)
               ? 1
               : DEPTH_SHOWN / (mean * longest_edge_m(&box->box));
}

static murk_status write_vdb(const char *path, const void *context,
                             murk_error *err)
{
    const vdb *v = context;
    const murk_voxel_fields *f = v->fields;
    const size_t voxels = murk_field_voxels(&f->box);
    const double factor = v->density ? factor_of(v) : 0;
    murk_grid_field grid[MURK_VOXEL_FIELDS_MAX + 1];
    notes *note = malloc(f->n * sizeof *note);
    float *density = malloc(voxels * sizeof *density + 1);
    if (!note || !density) {
        free(note);
        free(density);
        return murk_no_memory(err, path, "to write it");
    }
    for (size_t i = 0; i < f->n; ++i) {
        make_notes(&note[i], f->scene, &f->field[i]);
        grid[i] = (murk_grid_field){f->field[i].name, f->field[i].value,
                                    note[i].note};
    }
    /* the first field times the factor, for the grid `density` */
    for (size_t i = 0; i < voxels; ++i) {
        const double value = (double)f->field[0].value[i];
        density[i] = (float)(value > 0 ? factor * value : 0);
    }
    char factor_text[32];
    snprintf(factor_text, sizeof factor_text, "%.9g", factor);
    const char *const shown[] = {"unit",     "1/m",
                                 "quantity", "density for viewers",
                                 "of",       f->field[0].name,
                                 "factor",   factor_text,
                                 NULL};
    grid[f->n] = (murk_grid_field){"density", density, shown};

    murk_affine to_world = murk_field_to_world(&f->box);
    to_world.shift = murk_scene_user(f->scene, to_world.shift);
    const murk_status status =
        murk_grid_write(path, grid, f->n + (v->density != MURK_DENSITY_NONE),
                        f->box.size, &to_world, err);
    free(density);
    free(note);
    return status;
}

murk_status murk_field_add_vdb(murk_results *results, const char *name,
                               const murk_voxel_fields *fields,
                               murk_field_density density, murk_error *err)
{
    const vdb v = {fields, density};
    return murk_results_add(results, name, write_vdb, &v, err);
}

/* ---- .vti: VTK's image data, as XML before raw bytes ---- */

static void put_facts(FILE *to, const murk_voxel_fields *f)
{
    fputs("    <FieldData>\n", to);
    murk_vtk_put_facts(to, f->scene, NULL);
    for (size_t i = 0; i < f->n; ++i) {
        const murk_voxel_field *field = &f->field[i];
        char name[sizeof field->name + 16], text[512];
        snprintf(name, sizeof name, "%s.meaning", field->name);
        snprintf(text, sizeof text, "%s [%s]%s%s", field->quantity, field->unit,
                 field->meaning ? ": " : "",
                 field->meaning ? field->meaning : "");
        murk_vtk_put_text(to, name, text);
    }
    fputs("    </FieldData>\n", to);
}

static void put_header(FILE *to, const murk_voxel_fields *f)
{
    const size_t *n = f->box.size;
    const uint64_t bytes = murk_field_voxels(&f->box) * sizeof(float);
    const murk_vec3 at = murk_scene_user(f->scene, f->box.box.min);
    const murk_affine m = murk_field_to_world(&f->box);
    /* The box and the facts of the fields, then an array for each field. */
    murk_vtk_begin(to, "ImageData");
    fprintf(to,
            "  <ImageData WholeExtent=\"0 %zu 0 %zu 0 %zu\" "
            "Origin=\"%.17g %.17g %.17g\" Spacing=\"%.17g %.17g %.17g\">\n",
            n[0], n[1], n[2], at.x, at.y, at.z, m.matrix[0][0], m.matrix[1][1],
            m.matrix[2][2]);
    put_facts(to, f);
    fprintf(to,
            "    <Piece Extent=\"0 %zu 0 %zu 0 %zu\">\n"
            "      <CellData Scalars=\"%s\">\n",
            n[0], n[1], n[2], f->field[0].name);
    for (size_t i = 0; i < f->n; ++i) {
        fprintf(to,
                "        <DataArray type=\"Float32\" Name=\"%s\" "
                "format=\"appended\" offset=\"%llu\"/>\n",
                f->field[i].name,
                (unsigned long long)(i * (bytes + sizeof bytes)));
    }
    fputs("      </CellData>\n    </Piece>\n  </ImageData>\n"
          "  <AppendedData encoding=\"raw\">\n_",
          to);
}

static murk_status write_vti(FILE *to, const void *context, murk_error *err)
{
    const murk_voxel_fields *f = context;
    const uint64_t bytes = murk_field_voxels(&f->box) * sizeof(float);
    put_header(to, f);
    for (size_t i = 0; i < f->n; ++i) {
        (void)fwrite(&bytes, sizeof bytes, 1, to); /* failures show when the
                                                      file is committed */
        (void)fwrite(f->field[i].value, 1, bytes, to);
    }
    fputs("\n  </AppendedData>\n</VTKFile>\n", to);
    (void)err;
    return MURK_OK;
}

murk_status murk_field_add_vti(murk_results *results, const char *name,
                               const murk_voxel_fields *fields, murk_error *err)
{
    return murk_results_add_stream(results, name, write_vti, fields, err);
}
