/* Import of a mesh file by Assimp, inside the subprocess.
 *
 * Assimp's scene is a tree of nodes that place meshes. The tree is traversed
 * three times (count, vertices, triangles) and the arrays are sent in blocks,
 * so that no array is in memory as a whole beside Assimp's scene.
 *
 * Axes and units, as Assimp 5.2 delivers them: Collada, IFC, 3DS, ASE and DXF
 * scenes are rotated to y up by Assimp; glTF and X3D are y up by format; FBX
 * files state their up axis; the other formats know no up axis and are taken as
 * z up. Assimp scales Collada and IFC to metres (Collada by the root node, so
 * that the file's unit can be read there). FBX states a unit and is not scaled
 * by Assimp; glTF is in metres; the other formats state no unit. */
#include "geometry/import.h"

#include "geometry/import_files.h"

#include <assimp/cimport.h>
#include <assimp/commonMetaData.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes sent at a time: few calls of the system, little memory (a choice). */
#define BLOCK 65536

/* ---- axes and units ---- */

murk_affine murk_import_up_to_z(char up)
{
    switch (up) {
    case 'x':
        return (murk_affine){.matrix = {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}}};
    case 'y':
        return (murk_affine){.matrix = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
    default:
        return murk_affine_identity();
    }
}

static murk_affine affine_of(const struct aiMatrix4x4 *m)
{
    return (murk_affine){
        .matrix = {{(double)m->a1, (double)m->a2, (double)m->a3},
                   {(double)m->b1, (double)m->b2, (double)m->b3},
                   {(double)m->c1, (double)m->c2, (double)m->c3}},
        .shift = {(double)m->a4, (double)m->b4, (double)m->c4}};
}

static double length_scale(const murk_affine *a)
{
    const murk_vec3 x = {a->matrix[0][0], a->matrix[1][0], a->matrix[2][0]};
    const murk_vec3 y = {a->matrix[0][1], a->matrix[1][1], a->matrix[2][1]};
    const murk_vec3 z = {a->matrix[0][2], a->matrix[1][2], a->matrix[2][2]};
    return cbrt(fabs(murk_dot(x, murk_cross(y, z))));
}

static const struct aiMetadataEntry *metadata_entry(const struct aiScene *scene,
                                                    const char *key,
                                                    enum aiMetadataType type)
{
    const struct aiMetadata *notes = scene->mMetaData;
    for (unsigned i = 0; notes && i < notes->mNumProperties; ++i) {
        if (strcmp(notes->mKeys[i].data, key) == 0 &&
            notes->mValues[i].mType == type && notes->mValues[i].mData) {
            return &notes->mValues[i];
        }
    }
    return NULL;
}

/* A number from the metadata, or `otherwise` if there is none. Assimp 5.2
 * stores FBX's unit in single precision. */
static double metadata_number(const struct aiScene *scene, const char *key,
                              double otherwise)
{
    const struct aiMetadataEntry *wide = metadata_entry(scene, key, AI_DOUBLE);
    const struct aiMetadataEntry *narrow = metadata_entry(scene, key, AI_FLOAT);
    return wide     ? *(const double *)wide->mData
           : narrow ? (double)*(const float *)narrow->mData
                    : otherwise;
}

/* The conventions of Assimp's coordinates: up axis and metres per unit; and
 * those of the file itself (own_), if Assimp has rotated or scaled the
 * coordinates. */
typedef struct conventions {
    char up, own_up;
    double unit_m, own_unit_m;
} conventions;

static conventions conventions_of(const struct aiScene *scene)
{
    conventions c = {.up = 'z', .own_up = 'z', .unit_m = 1, .own_unit_m = 1};
    const struct aiMetadataEntry *format =
        metadata_entry(scene, AI_METADATA_SOURCE_FORMAT, AI_AISTRING);
    const char *name =
        format ? ((const struct aiString *)format->mData)->data : "";
    if (strstr(name, "Collada")) {
        const murk_affine root = affine_of(&scene->mRootNode->mTransformation);
        c.up = c.own_up =
            'y'; /* own_up is used only if the user states the up axis;
                  * read_scene() then makes Assimp keep the file's axes */
        c.own_unit_m = length_scale(&root);
    } else if (strstr(name, "IFC") || strstr(name, "3DS") ||
               strstr(name, "ASE") || strstr(name, "DXF")) {
        c.up = 'y';
    } else if (strstr(name, "glTF") || strstr(name, "X3D")) {
        c.up = c.own_up = 'y';
    } else if (strstr(name, "FBX")) {
        const struct aiMetadataEntry *up =
            metadata_entry(scene, "UpAxis", AI_INT32);
        const int32_t axis = up ? *(const int32_t *)up->mData : 1;
        c.up = c.own_up = axis == 0 ? 'x' : axis == 2 ? 'z' : 'y';
        c.unit_m = c.own_unit_m =
            0.01 * metadata_number(scene, "UnitScaleFactor", 1);
    }
    return c;
}

/* Transformation from Assimp's coordinates to metres with z up. */
static murk_affine to_metres(const struct aiScene *scene,
                             const murk_mesh_import *import)
{
    const conventions c = conventions_of(scene);
    murk_affine out = murk_import_up_to_z(c.up);
    if (import->up) {
        /* The user's up axis refers to the axes of the file: undo Assimp's
         * rotation first. Formats that Assimp rotates are z up. */
        const murk_affine own = c.up == c.own_up ? murk_affine_identity()
                                                 : murk_import_up_to_z(c.up);
        const murk_affine turn = murk_import_up_to_z(import->up);
        out = murk_affine_compose(&turn, &own);
    }
    const double scale = import->unit_m > 0
                             ? c.unit_m * import->unit_m / c.own_unit_m
                             : c.unit_m;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            out.matrix[i][j] *= scale;
        }
    }
    return out;
}

/* ---- traversing the tree ---- */

typedef enum purpose { COUNT, SEND_VERTICES, SEND_TRIANGLES } purpose;

typedef struct traversal {
    murk_subprocess *subprocess;
    const murk_import_request *request;
    const struct aiScene *scene;
    purpose purpose;
    murk_import_head head;
    uint64_t first_vertex; /* number of the current mesh's first vertex among
                              all vertices */
    uint64_t bad_vertices, bad_indices, bad_vertex_at, bad_index_at;
    size_t filled; /* bytes of the block that are not sent yet */
    unsigned char block[BLOCK];
} traversal;

static murk_status send_block(traversal *t)
{
    const size_t n = t->filled;
    t->filled = 0;
    return murk_subprocess_send(t->subprocess, t->block, n);
}

static murk_status send(traversal *t, const void *bytes, size_t size)
{
    const murk_status status =
        t->filled + size > sizeof t->block ? send_block(t) : MURK_OK;
    memcpy(t->block + t->filled, bytes, size);
    t->filled += size;
    return status;
}

static murk_status send_vertices(traversal *t, const struct aiMesh *mesh,
                                 const murk_affine *place)
{
    murk_status status = MURK_OK;
    for (unsigned i = 0; i < mesh->mNumVertices && !status; ++i) {
        const struct aiVector3D *v = &mesh->mVertices[i];
        const murk_vec3 p = murk_affine_point(
            place, murk_vec((double)v->x, (double)v->y, (double)v->z));
        const float vertex[3] = {(float)p.x, (float)p.y, (float)p.z};
        status = send(t, vertex, sizeof vertex);
    }
    return status;
}

static murk_status send_triangles(traversal *t, const struct aiMesh *mesh)
{
    const uint32_t first = (uint32_t)t->first_vertex;
    murk_status status = MURK_OK;
    for (unsigned i = 0; i < mesh->mNumFaces && !status; ++i) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices == 3) { /* points and lines have no area */
            const uint32_t triangle[4] = {
                first + face->mIndices[0], first + face->mIndices[1],
                first + face->mIndices[2], mesh->mMaterialIndex};
            status = send(t, triangle, sizeof triangle);
        }
    }
    t->first_vertex += mesh->mNumVertices;
    return status;
}

static void count_mesh(traversal *t, const struct aiMesh *mesh)
{
    for (unsigned i = 0; i < mesh->mNumVertices; ++i) {
        const struct aiVector3D *v = &mesh->mVertices[i];
        if (!isfinite(v->x) || !isfinite(v->y) || !isfinite(v->z)) {
            t->bad_vertex_at =
                t->bad_vertices++ ? t->bad_vertex_at : t->head.vertices + i;
        }
    }
    for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices != 3) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            if (face->mIndices[k] >= mesh->mNumVertices) {
                t->bad_index_at =
                    t->bad_indices++ ? t->bad_index_at : t->head.triangles;
            }
        }
        ++t->head.triangles;
    }
    t->head.vertices += mesh->mNumVertices;
}

static murk_status visit(traversal *t, const struct aiNode *node,
                         const murk_affine *parent)
{
    const murk_affine own = affine_of(&node->mTransformation);
    const murk_affine place = murk_affine_compose(parent, &own);
    murk_status status = MURK_OK;
    /* Handle the meshes of this node in world coordinates. */
    for (unsigned i = 0; i < node->mNumMeshes && !status; ++i) {
        const struct aiMesh *mesh = t->scene->mMeshes[node->mMeshes[i]];
        switch (t->purpose) {
        case COUNT:
            count_mesh(t, mesh);
            break;
        case SEND_VERTICES:
            status = send_vertices(t, mesh, &place);
            break;
        case SEND_TRIANGLES:
            status = send_triangles(t, mesh);
            break;
        }
    }
    /* The children are placed relative to this node. */
    for (unsigned i = 0; i < node->mNumChildren && !status; ++i) {
        status = visit(t, node->mChildren[i], &place);
    }
    return status;
}

static murk_status check_counts(const traversal *t, murk_error *err)
{
    const char *where = t->request->where, *path = t->request->path;
    /* Refuse an empty mesh, coordinates that are not finite, indices out of
     * range, and more elements than a 32-bit index can name. */
    if (t->head.triangles == 0) {
        return murk_fail(err, MURK_BAD_FILE, where, "%s holds no triangles",
                         path);
    }
    if (t->bad_vertices > 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: %" PRIu64 " of %" PRIu64
                         " vertices are not finite, the first is vertex "
                         "%" PRIu64,
                         path, t->bad_vertices, t->head.vertices,
                         t->bad_vertex_at);
    }
    if (t->bad_indices > 0) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: %" PRIu64 " corners name a vertex that is not "
                         "there, the first in triangle %" PRIu64 " of %" PRIu64,
                         path, t->bad_indices, t->bad_index_at,
                         t->head.triangles);
    }
    if (t->head.vertices > UINT32_MAX || t->head.triangles > UINT32_MAX) {
        return murk_fail(err, MURK_BAD_FILE, where,
                         "%s: %" PRIu64 " triangles, must be at most %" PRIu32,
                         path, t->head.triangles, UINT32_MAX);
    }
    return MURK_OK;
}

static murk_status send_names(traversal *t)
{
    murk_status status = MURK_OK;
    for (unsigned i = 0; i < t->scene->mNumMaterials && !status; ++i) {
        struct aiString own = {0};
        char name[MURK_NAME_SIZE] = {0};
        if (aiGetMaterialString(t->scene->mMaterials[i], AI_MATKEY_NAME,
                                &own) == aiReturn_SUCCESS) {
            memcpy(name, own.data, strnlen(own.data, MURK_NAME_SIZE - 1));
        }
        status = send(t, name, sizeof name);
    }
    return status;
}

static const struct aiScene *read_scene(const murk_import_request *request,
                                        struct aiFileIO *files)
{
    struct aiPropertyStore *settings = aiCreatePropertyStore();
    if (!settings) {
        return NULL;
    }
    if (request->import.up) {
        /* The user states the up axis: Assimp must keep Collada's axes as
         * they are, whatever the file says. */
        aiSetImportPropertyInteger(
            settings, AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, 1);
    }
    const struct aiScene *scene = aiImportFileExWithProperties(
        request->path, aiProcess_Triangulate, files, settings);
    aiReleasePropertyStore(settings);
    return scene;
}

/* Replaces control characters in Assimp's message, so that the message is one
 * line. */
static void one_line(char *text)
{
    for (; *text; ++text) {
        if ((unsigned char)*text < ' ') {
            *text = ' ';
        }
    }
}

/* Fails if Assimp asked for a file outside the folder of the mesh, or could not
 * read the mesh (scene is NULL). */
static murk_status check_scene(const murk_import_request *request,
                               const murk_import_source *source,
                               const struct aiScene *scene, murk_error *err)
{
    if (source->access.refused[0]) { /* an error, even if Assimp has read the
                                      * mesh without the refused file */
        return murk_fail(err, MURK_BAD_FILE, request->where,
                         "%s names %s, which is outside its folder: "
                         "geometry.*.allow: DIR lets meshes open files in DIR",
                         request->path, source->access.refused);
    }
    if (!scene || !scene->mRootNode) {
        char why[256];
        snprintf(why, sizeof why, "%s", aiGetErrorString());
        one_line(why);
        return murk_fail(err, MURK_BAD_FILE, request->where,
                         "%s is no mesh that can be read: %s", request->path,
                         why);
    }
    return MURK_OK;
}

static murk_status send_scene(murk_subprocess *subprocess,
                              const murk_import_request *request,
                              const murk_import_source *source,
                              const struct aiScene *scene, murk_error *err)
{
    traversal *t = calloc(1, sizeof *t);
    if (!t) {
        return murk_no_memory(err, request->where, "to read %s", request->path);
    }
    t->subprocess = subprocess;
    t->request = request;
    t->scene = scene;
    /* Origin of the vertices in metres: the shift that was subtracted from
     * the file's vertices. */
    const murk_affine place = to_metres(scene, &request->import);
    t->head.origin_m = murk_affine_direction(
        &place, murk_vec(source->shift[0], source->shift[1], source->shift[2]));
    /* First traversal: count and check. Then send the header and, in one
     * traversal each, the arrays. */
    visit(t, scene->mRootNode, &place);
    t->head.materials = scene->mNumMaterials;
    t->head.names_others = source->names_others;
    murk_status status = check_counts(t, err);
    if (!status) {
        status = send(t, &t->head, sizeof t->head);
    }
    for (int p = SEND_VERTICES; p <= SEND_TRIANGLES && !status; ++p) {
        t->purpose = (purpose)p;
        status = visit(t, scene->mRootNode, &place);
    }
    if (!status) {
        status = send_names(t);
    }
    if (!status) {
        status = send_block(t);
    }
    free(t);
    return status;
}

/* Releases all memory, because the work may run in the process of the host. */
murk_status murk_import_work(murk_subprocess *subprocess, void *context,
                             murk_error *err)
{
    const murk_import_request *request = context;
    murk_import_source source;
    murk_import_source_of(&source, request->path, request->import.allow);
    struct aiFileIO files = murk_import_files(&source);
    const struct aiScene *scene = read_scene(request, &files);
    murk_status status = check_scene(request, &source, scene, err);
    if (!status) {
        status = send_scene(subprocess, request, &source, scene, err);
    }
    aiReleaseImport(scene);
    free(source.bytes);
    return status;
}

/* ---- the job ---- */

void murk_import_pack(murk_parcel *to, const void *context)
{
    const murk_import_request *request = context;
    murk_parcel_put_text(to, request->path);
    murk_parcel_put_text(to, request->where);
    murk_parcel_put(to, &request->import, sizeof request->import);
    murk_parcel_put_text(to, request->import.allow);
}

murk_status murk_import_unpack(murk_import_request *out, murk_parcel *from,
                               murk_error *err)
{
    out->path = murk_parcel_take_text(from);
    out->where = murk_parcel_take_text(from);
    const murk_mesh_import *import = murk_parcel_take(from, sizeof *import);
    const char *allow = murk_parcel_take_text(from);
    if (from->is_short || !out->path || !out->where) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    out->import = *import;
    out->import.allow = allow;
    return MURK_OK;
}

static murk_status work_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    murk_import_request request = {0};
    const murk_status status = murk_import_unpack(&request, from, err);
    return status ? status : murk_import_work(subprocess, &request, err);
}

const murk_subprocess_job murk_import_job = {.name = "mesh",
                                             .work = murk_import_work,
                                             .pack = murk_import_pack,
                                             .work_packed = work_packed};
