/* Writes the parts that several files for viewers share: the facts of where a
 * file is from, as comments of a PLY file or as field data of VTK's files, and
 * the beginning of the latter. */
#include "results/vtk.h"

#include "results/version.h"

#include <stdlib.h>
#include <string.h>

void murk_facts_of(murk_facts *out, const murk_scene_desc *scene)
{
    snprintf(out->seed, sizeof out->seed, "%lu", (unsigned long)scene->seed);
    const murk_facts facts = {.fact = {"scene", scene->path, "scene_sha256",
                                       scene->sha256, "seed", out->seed,
                                       "murk_version", MURK_VERSION,
                                       "murk_commit", murk_version_commit()}};
    memcpy(out->fact, facts.fact, sizeof facts.fact);
}

static void put_comments(FILE *to, const char *const *note)
{
    for (; note && note[0]; note += 2) {
        fprintf(to, "comment %s ", note[0]);
        for (const char *c = note[1]; *c; ++c) {
            const unsigned char byte = (unsigned char)*c;
            fputc(byte < ' ' || byte == 127 ? '?' : byte, to);
        }
        fputc('\n', to);
    }
}

void murk_ply_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note)
{
    murk_facts facts = {0};
    murk_facts_of(&facts, scene);
    put_comments(to, facts.fact);
    put_comments(to, note);
}

char *murk_numbered_names(const char *first, size_t n, size_t stride)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    for (size_t i = 0; out && i < n; ++i) {
        fprintf(out, "%s%zu: %s", i > 0 ? ", " : "", i, first + i * stride);
    }
    if (!out || fclose(out) != 0) {
        free(text);
        return NULL;
    }
    return text;
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

static void put_texts(FILE *to, const char *const *note)
{
    for (; note && note[0]; note += 2) {
        murk_vtk_put_text(to, note[0], note[1]);
    }
}

void murk_vtk_put_facts(FILE *to, const murk_scene_desc *scene,
                        const char *const *note)
{
    murk_facts facts = {0};
    murk_facts_of(&facts, scene);
    put_texts(to, facts.fact);
    put_texts(to, note);
}

void murk_vtk_begin(FILE *to, const char *type)
{
    fprintf(to,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"%s\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
            type);
}
