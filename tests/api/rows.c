/* Rows of a study from a host with a busy second thread: murk-rows, the process
 * itself, and forks, which need a host with one thread, give the same table,
 * stored rows and grids to the bit, and the first two never fork the host. Each
 * of the three can be cancelled, leaves no process behind, and refuses a scene
 * that has changed. Files that rows alone read are never written over. */
#define _XOPEN_SOURCE 700 /* nftw */
#include "checks.h"

#include <dirent.h>
#include <errno.h>
#include <ftw.h>
#include <pthread.h>
#include <stdatomic.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static murk_error error = MURK_ERROR_NONE;

static void must(murk_status status)
{
    must_be_ok(status, &error);
}

/* The processes that run rows, each with a folder. */
static const murk_imports modes[] = {MURK_IMPORTS_READER, MURK_IMPORTS_FORK,
                                     MURK_IMPORTS_IN_PROCESS};
static const char *const folders[] = {"by-program", "by-fork", "in-process"};
#define MODES 3

/* ---- files ---- */

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    CHECK(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

/* A hall of a mesh, in fog. */
static const char scene_text[] =
    "murk: 1\n"
    "domain: {min_m: [0, 0, 0], max_m: [6, 6, 3]}\n"
    "geometry: [{file: floor.obj, up: z}]\n"
    "materials: {default: {diffuse: 0.5}, oak: {diffuse: 0.3}}\n"
    "media: {fog: {extinction_per_m: 0.2, albedo: 0.9, phase: {hg: 0.7}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: point, position_m: [2, 2, 2], power_w: 1}]\n"
    "photons: {emit: 3000}\n"
    "tallies: [{name: probe, type: sphere, center_m: [3, 3, 1], radius_m: "
    "0.5}]\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 4}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [5, 5, 2], size: [3, 3, "
    "2]}}\n"
    "  count: 2\n"
    "placement: {restarts: 5}\n";

/* Six rows in four groups: the powers of a lamp share the light, and the rows
 * with a malformed mesh fail. */
static const char study_text[] =
    "murk_study: 1\n"
    "base: scene.yaml\n"
    "axes:\n"
    "  media.fog.extinction_per_m: [0.1, 0.4]\n"
    "  state:\n"
    "    dim: {}\n"
    "    bright: {lights.0.power_w: 3}\n"
    "    broken: {geometry.0.file: broken.obj}\n"
    "outputs: [density, stored, probe, coverage_best, coverage_one_mean, "
    "coverage_one_worst, fluence_vdb]\n"
    "fluence_size: [6, 6, 3]\n";
#define ROWS   6
#define FAILED 2

static void write_files(void)
{
    write_text("floor.obj", "mtllib floor.mtl\n"
                            "v 0 0 0.5\nv 6 0 0.5\nv 6 6 0.5\nv 0 6 0.5\n"
                            "usemtl oak\nf 1 2 3\nf 1 3 4\n");
    write_text("floor.mtl", "newmtl oak\n");
    write_text("broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 99\n");
    write_text("scene.yaml", scene_text);
    write_text("study.yaml", study_text);
}

/* The bytes of a file, for free(). */
static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    CHECK(file && fseek(file, 0, SEEK_END) == 0);
    *size = (size_t)ftell(file);
    char *bytes = malloc(*size + 1);
    rewind(file);
    CHECK(bytes && fread(bytes, 1, *size, file) == *size);
    fclose(file);
    return bytes;
}

static void check_equal(const char *a, const char *b)
{
    size_t n = 0, m = 0;
    char *one = read_file(a, &n), *other = read_file(b, &m);
    if (n != m || memcmp(one, other, n) != 0) {
        fprintf(stderr, "%s and %s differ\n", a, b);
        exit(1);
    }
    free(one);
    free(other);
}

/* Compares the files of two folders of results but study.json, which names the
 * run. Returns the number of files in the first. */
static int compare(const char *a, const char *b, const char *below)
{
    char folder[300], one[600], other[600];
    int n = 0;
    snprintf(folder, sizeof folder, "%s%s", a, below);
    DIR *files = opendir(folder);
    CHECK(files);
    const struct dirent *file;
    while ((file = readdir(files)) != NULL) {
        const char *dot = strrchr(file->d_name, '.');
        if (file->d_name[0] == '.' || !dot || strcmp(dot, ".json") == 0) {
            continue;
        }
        snprintf(one, sizeof one, "%s/%s", folder, file->d_name);
        snprintf(other, sizeof other, "%s%s/%s", b, below, file->d_name);
        check_equal(one, other);
        ++n;
    }
    closedir(files);
    return n;
}

static int remove_one(const char *path, const struct stat *file, int kind,
                      struct FTW *place)
{
    (void)file;
    (void)kind;
    (void)place;
    return remove(path);
}

/* ---- the host ---- */

static atomic_int forks;
static atomic_bool is_over; /* the second thread ends */

static void count_fork(void)
{
    atomic_fetch_add(&forks, 1);
}

/* The second thread, which holds a lock of the C library most of the time. */
static void *be_busy(void *nothing)
{
    unsigned long sum = 0;
    while (!atomic_load(&is_over)) {
        char *memory = malloc(sum % 5000 + 1);
        CHECK(memory);
        memory[0] = (char)sum;
        sum = sum * 1103515245 + 12345;
        free(memory);
    }
    return nothing;
}

/* Starts or ends the second thread. */
static void set_busy(bool is_busy)
{
    static pthread_t busy;
    static bool was_busy;
    if (was_busy) {
        atomic_store(&is_over, true);
        CHECK(pthread_join(busy, NULL) == 0);
    }
    atomic_store(&is_over, false);
    CHECK(!is_busy || pthread_create(&busy, NULL, be_busy, NULL) == 0);
    was_busy = is_busy;
}

typedef struct shown {
    int calls;
    uint64_t done; /* rows, of the last call */
} shown;

static void show(void *user, const murk_progress *progress)
{
    shown *s = user;
    if (strcmp(progress->step, "study") == 0) {
        CHECK(progress->total == ROWS && progress->done <= ROWS);
        s->done = progress->done;
        ++s->calls;
    }
}

/* A context of a host that is as busy as the processes for rows allow. */
static murk_context *make_context(murk_imports imports, const char *reader,
                                  shown *s)
{
    set_busy(imports != MURK_IMPORTS_FORK);
    const murk_context_options options = {.size = sizeof options,
                                          .threads = 2,
                                          .progress = s ? show : NULL,
                                          .user = s,
                                          .imports = imports,
                                          .reader = reader};
    murk_context *context = NULL;
    must(murk_context_create(&context, &options, &error));
    return context;
}

static murk_study *read_study(murk_context *context, const char *folder,
                              const char *photons)
{
    const char *const key[] = {"photons.emit"}, *const value[] = {photons};
    const murk_study_options options = {.size = sizeof options,
                                        .folder = folder,
                                        .n = photons ? 1 : 0,
                                        .key = key,
                                        .value = value};
    murk_study *study = NULL;
    must(murk_study_read(&study, context, "study.yaml", &options, &error));
    return study;
}

static int64_t count_of(murk_study *study, const char *field)
{
    const murk_fields *fields = NULL;
    int64_t value = -1;
    must(murk_study_fields(study, &fields, &error));
    must(murk_fields_int64(fields, field, &value, &error));
    return value;
}

/* The reason why a row has failed. */
static const char *failure_of(murk_study *study, size_t row)
{
    const murk_fields *fields = NULL;
    const char *text = NULL;
    char path[64];
    snprintf(path, sizeof path, "rows.%zu.failed", row);
    must(murk_study_fields(study, &fields, &error));
    must(murk_fields_string(fields, path, &text, &error));
    return text ? text : "";
}

static void check_no_process(void)
{
    CHECK(waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD);
}

/* ---- the tests ---- */

/* A file that only the importer of a row opens is an input of the context. */
static void check_inputs(murk_context *context)
{
    murk_scene *scene = NULL;
    murk_world *world = NULL;
    murk_light *light = NULL;
    must(murk_scene_read(&scene, context, "scene.yaml", &error));
    must(murk_scene_set(scene, "geometry", "[]", &error));
    must(murk_scene_set(scene, "photons.emit", "10", &error));
    must(murk_world_create(&world, scene, &error));
    must(murk_light_trace(&light, world, &error));
    CHECK(murk_light_write(light, "floor.mtl", NULL) == MURK_BAD_VALUE);
    murk_light_destroy(light);
    murk_world_destroy(world);
    murk_scene_destroy(scene);
}

/* Runs and saves the study; the fields as JSON, for free(). */
static char *run(murk_imports imports, const char *folder, shown *s)
{
    murk_context *context = make_context(imports, NULL, s);
    murk_study *study = read_study(context, folder, NULL);
    const murk_fields *fields = NULL;
    must(murk_study_run(study, &error));
    CHECK(count_of(study, "rows_done") == ROWS);
    CHECK(count_of(study, "rows_failed") == FAILED);
    CHECK(strstr(failure_of(study, 2), "broken.obj"));
    must(murk_study_fields(study, &fields, &error));
    char *json = strdup(murk_fields_json(fields));
    must(murk_study_save(study, folder, NULL, NULL, &error));
    check_inputs(context);
    murk_study_destroy(study);
    murk_context_destroy(context);
    check_no_process();
    CHECK(json);
    return json;
}

static void test_modes_agree(void)
{
    char *json[MODES];
    for (int m = 0; m < MODES; ++m) {
        shown s = {0};
        const int before = atomic_load(&forks);
        json[m] = run(modes[m], folders[m], &s);
        const int made = atomic_load(&forks) - before;
        CHECK(modes[m] == MURK_IMPORTS_FORK ? made > 0 : made == 0);
        CHECK(s.calls > 0 && s.done == ROWS);
    }
    for (int m = 1; m < MODES; ++m) {
        if (strcmp(json[0], json[m]) != 0) {
            fprintf(stderr, "%s:\n%s\n%s:\n%s\n", folders[0], json[0],
                    folders[m], json[m]);
            exit(1);
        }
        /* The table, the scene and the grids; stored are also the two plans
         * for all rows and their coverage in each row. */
        CHECK(compare(folders[0], folders[m], "") == 2 + ROWS - FAILED);
        CHECK(compare(folders[0], folders[m], "/rows") ==
              2 * (ROWS - FAILED) + 2);
        free(json[m]);
    }
    free(json[0]);
}

static void *cancel_soon(void *context)
{
    const struct timespec soon = {.tv_nsec = 300000000};
    nanosleep(&soon, NULL);
    murk_context_cancel(context);
    return NULL;
}

static void test_cancel(void)
{
    for (int m = 0; m < MODES; ++m) {
        murk_context *context = make_context(modes[m], NULL, NULL);
        murk_study *study = read_study(context, "cancelled", "10000000");
        pthread_t thread;
        CHECK(pthread_create(&thread, NULL, cancel_soon, context) == 0);
        CHECK(murk_study_run(study, NULL) == MURK_INTERRUPTED);
        CHECK(pthread_join(thread, NULL) == 0);
        check_no_process();
        CHECK(count_of(study, "rows_done") <= FAILED);
        murk_study_destroy(study);
        murk_context_destroy(context);
    }
}

/* All rows fail if the scene has changed since the study was read, and with
 * murk-rows also if the study has. */
static void test_changed(const char *name, const char *text, int n_modes)
{
    for (int m = 0; m < n_modes; ++m) {
        murk_context *context = make_context(modes[m], NULL, NULL);
        murk_study *study = read_study(context, "changed", NULL);
        char changed[4000];
        snprintf(changed, sizeof changed, "%s# changed\n", text);
        write_text(name, changed);
        must(murk_study_run(study, &error));
        CHECK(count_of(study, "rows_failed") == ROWS);
        CHECK(strstr(failure_of(study, 0), "has changed"));
        murk_study_destroy(study);
        murk_context_destroy(context);
        write_text(name, text);
    }
}

/* Without the program nothing is run; another program answers nothing. */
static void test_no_program(void)
{
    murk_context *context =
        make_context(MURK_IMPORTS_READER, "nowhere/murk-reader", NULL);
    murk_study *study = read_study(context, "none", NULL);
    murk_error why = MURK_ERROR_NONE;
    CHECK(murk_study_run(study, &why) == MURK_RUN_FAILED);
    CHECK(strstr(why.text, "nowhere/murk-rows"));
    CHECK(count_of(study, "rows_done") == 0);
    murk_study_destroy(study);
    murk_context_destroy(context);
    CHECK(symlink("/bin/true", "murk-rows") == 0);
    context = make_context(MURK_IMPORTS_READER, "./murk-reader", NULL);
    study = read_study(context, "none", NULL);
    must(murk_study_run(study, &error));
    CHECK(count_of(study, "rows_failed") == ROWS);
    CHECK(strstr(failure_of(study, 0), "ended without a word"));
    murk_study_destroy(study);
    murk_context_destroy(context);
    check_no_process();
}

int main(void)
{
    char folder[] = "/tmp/murk_rows_XXXXXX";
    CHECK(mkdtemp(folder) && chdir(folder) == 0);
    CHECK(pthread_atfork(count_fork, NULL, NULL) == 0);
    write_files();
    test_modes_agree();
    test_cancel();
    test_changed("scene.yaml", scene_text, MODES);
    test_changed("study.yaml", study_text, 1);
    test_no_program();
    set_busy(false);
    CHECK(chdir("/") == 0);
    CHECK(nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS) == 0);
    return 0;
}
