/* Broken mesh files end in a mesh or in one clear line, soon, and never in a
 * crash. Which of the two it is, the bytes decide; that each case ends is the
 * test. An argument multiplies the number of cases, for a long run. */
#include "base/log.h"
#include "base/progress.h"
#include "base/rng.h"
#include "base/subprocess.h"
#include "broken.h"
#include "check.h"
#include "geometry/surfaces.h"
#include "written.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#define SEED 41
/* Of processor time beyond the reader's own limit, for what is done with the
 * triangles afterwards. */
#define SPARE_S 2.0

static char folder[] = "/tmp/murk-bad-XXXXXX";
static size_t meshes, refusals;

static void use(const murk_mesh *m)
{
    const murk_material plain = {.name = "default", .ior = 1.5};
    const murk_surface_desc desc = {.shape = MURK_SHAPE_MESH,
                                    .mesh = m,
                                    .to_world = murk_affine_identity(),
                                    .material = -1};
    murk_surfaces *s = NULL;
    murk_error err = {0};
    if (murk_surfaces_create(&s, &desc, 1, &plain, 1, &err) == MURK_OK) {
        murk_hit hit;
        murk_surfaces_hit(s, murk_vec(0.1, 0.2, 0.3), murk_vec(0, 0, 1),
                          INFINITY, &hit);
        murk_surfaces_solid_at(s, murk_vec(0.1, 0.2, 0.3));
    } else {
        CHECK(err.text[0] != '\0');
    }
    murk_surfaces_destroy(s);
}

/* Processor time of this process and of the readers that it has ended. */
static double processor_s(void)
{
    double sum = 0;
    const int of[] = {RUSAGE_SELF, RUSAGE_CHILDREN};
    for (int i = 0; i < 2; ++i) {
        struct rusage used;
        getrusage(of[i], &used);
        sum += (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
               1e-6 * (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    }
    return sum;
}

static void try_bytes(const char *extension, const char *bytes, size_t size)
{
    /* Write the bytes to a file with the extension. */
    char path[96];
    snprintf(path, sizeof path, "%s/a.%s", folder, extension);
    write_bytes(path, bytes, size);
    /* Read the file: the reading ends within its limit of processor time. */
    murk_mesh *m = NULL;
    murk_error err = {0};
    const double start_s = processor_s();
    const murk_status status = murk_mesh_read(&m, path, NULL, "scene", &err);
    CHECK(processor_s() - start_s <
          murk_subprocess_limits_for(size).seconds + SPARE_S);
    CHECK((status == MURK_OK) == (m != NULL));
    /* A mesh that was read is usable; a refusal is a bad file with a
     * message of one line. */
    if (m) {
        ++meshes;
        use(m);
    } else {
        ++refusals;
        CHECK(status == MURK_BAD_FILE);
        broken_check_refusal(&err);
    }
    murk_mesh_destroy(m);
}

static const char OBJ[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                          "usemtl a\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n";
static const char PLY[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty "
    "float y\nproperty float z\nelement face 2\nproperty list uchar int "
    "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 "
    "3\n";
static const char STL[] =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
    "0\nvertex 0 1 0\nendloop\nendfacet\nfacet normal 0 1 0\nouter "
    "loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
    "endsolid a\n";
static const char GLTF[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}"
    "],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":"
    "{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":"
    "5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],\"buffers\":[{\"uri\":"
    "\"data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\",\"byteLength\":36}]}";

static void break_bytes(const char *extension, const char *whole, size_t size,
                        uint64_t cases)
{
    char *bytes = malloc(size);
    CHECK(bytes != NULL);
    for (uint64_t i = 0; bytes && i < cases; ++i) {
        memcpy(bytes, whole, size);
        uint32_t word[4];
        murk_random_words(SEED, MURK_TEST, i, (uint32_t)size, 0, word);
        if (i % 3 == 0) { /* cut short */
            try_bytes(extension, bytes,
                      1 + murk_random_below(word[0], (uint32_t)size));
            continue;
        }
        const uint32_t flips = 1 + murk_random_below(word[1], 8);
        for (uint32_t k = 0; k < flips; ++k) {
            uint32_t flip[4];
            murk_random_words(SEED, MURK_TEST, i, (uint32_t)size, 1 + k, flip);
            bytes[murk_random_below(flip[0], (uint32_t)size)] ^=
                (char)(1u << (flip[1] & 7u));
        }
        try_bytes(extension, bytes, size);
    }
    free(bytes);
}

static void break_file(const char *path, const char *extension, uint64_t cases)
{
    FILE *f = fopen(path, "rb");
    char *bytes = malloc(1 << 20);
    if (f && bytes) {
        break_bytes(extension, bytes, fread(bytes, 1, 1 << 20, f), cases);
    }
    free(bytes);
    if (f) {
        fclose(f);
    }
}

int main(int argc, char **argv)
{
    const uint64_t cases = argc > 1 ? strtoull(argv[1], NULL, 10) * 40 : 40;
    murk_warn_to(NULL);
    if (!mkdtemp(folder)) {
        check_skip("no temporary folder");
    }
    break_bytes("obj", OBJ, sizeof OBJ - 1, cases);
    break_bytes("ply", PLY, sizeof PLY - 1, cases);
    break_bytes("stl", STL, sizeof STL - 1, cases);
    break_bytes("gltf", GLTF, sizeof GLTF - 1, cases);
    const char *models = "/usr/share/assimp/models/";
    static const char *const model[][2] = {{"FBX/box.fbx", "fbx"},
                                           {"3DS/fels.3ds", "3ds"},
                                           {"PLY/cube_binary.ply", "ply"},
                                           {"STL/Spider_binary.stl", "stl"},
                                           {"Collada/COLLADA.dae", "dae"}};
    for (size_t i = 0; i < sizeof model / sizeof *model; ++i) {
        char path[96]; /* not there: nothing to break */
        snprintf(path, sizeof path, "%s%s", models, model[i][0]);
        break_file(path, model[i][1], cases / 2);
    }
    printf("%zu meshes, %zu refusals\n", meshes, refusals);
    CHECK(meshes > 0 && refusals > 0);
    char clean[64];
    snprintf(clean, sizeof clean, "rm -r %s", folder);
    CHECK(system(clean) == 0);
    return check_done();
}
