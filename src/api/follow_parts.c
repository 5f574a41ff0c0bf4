/* Parts of a sequence of steps (--shard K/N): a part makes a run of
 * neighbouring steps, because a step takes over what the step before has
 * computed, and leaves them in the folder steps/ with the file follow.part,
 * which says of which scene and of which steps the part is. A merging run takes
 * each step from the part that has it, copies it into a folder of its own, and
 * makes what is missing.
 *
 * A step is known by the identity in its plan.json, and its files by the
 * checksums there, so follow.part needs no list of them. Sections of
 * follow.part: "part" (which part of how many steps), "scene" and "files"
 * (texts of what the steps follow from), which are compared line by line, so
 * that a message can name the first difference. */
#include "api/follow.h"

#include "base/file.h"
#include "base/log.h"
#include "lightmap/key_check.h"
#include "photonmap/map_file.h"
#include "results/json.h"
#include "scene/timeline.h"
#include "world/file_sums.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PART_FILE "follow.part"
#define PLAN      "plan.json"
#define LEDGER    "ledger.json"

/* The section "part", as it is stored. */
typedef struct facts {
    uint64_t steps; /* of the timeline */
    uint32_t number, count;
    char version[64]; /* murk_host_version(), ended by '\0' */
} facts;

/* ---- the steps of a part ---- */

/* The first step of a shard, which is the end of the shard before. */
static size_t begin_of(size_t steps, uint32_t number, uint32_t count)
{
    return (size_t)((uint64_t)steps * (number - 1) / count);
}

bool murk_follow_is_divisible(const murk_follow *follow)
{
    const murk_scene_desc *scene = follow->session.scene;
    return scene->timeline.from_start_plan ||
           scene->placement.method == MURK_PLACE_GREEDY;
}

murk_status murk_follow_shard(murk_follow *follow, uint32_t number,
                              uint32_t count, murk_error *error)
{
    if (!follow || follow->sequence.rows > 0 || follow->part_of) {
        return murk_call_refuse(error, "follow is NULL, or has steps or parts");
    }
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, error);
    const murk_shard shard = {number, count};
    /* The number, the folder, and the scene. */
    murk_status status = murk_shard_check(shard, &call.failure);
    if (!status && !follow->folder) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE, "shard",
                           "needs a folder, which the steps are left in");
    }
    if (!status && !murk_follow_is_divisible(follow)) {
        status = murk_fail(&call.failure, MURK_BAD_VALUE, "shard",
                           "each step begins at the plan of the step before; "
                           "timeline.search_from must be start_plan, or "
                           "placement.method greedy");
    }
    if (!status) {
        follow->shard = shard;
        follow->next = begin_of(follow->steps, number, count);
        follow->end = begin_of(follow->steps, number + 1, count);
    }
    return murk_call_end(&call, status);
}

/* ---- writing ---- */

murk_status murk_follow_part_write(const murk_follow *follow, murk_error *err)
{
    const murk_scene_desc *scene = follow->session.scene;
    char *path = murk_path_join(follow->folder, PART_FILE);
    char *files = murk_file_sums_print(scene);
    facts f = {.steps = follow->steps,
               .number = follow->shard.number,
               .count = follow->shard.count};
    snprintf(f.version, sizeof f.version, "%s", murk_host_version());
    murk_status status =
        path && files ? MURK_OK : murk_no_memory(err, "", "for the part");
    if (!status) {
        const murk_section sections[] = {
            murk_section_of("part", &f, sizeof f),
            murk_section_of("scene", scene->whole_key,
                            strlen(scene->whole_key)),
            murk_section_of("files", files, strlen(files))};
        status = murk_map_file_write(path, sections,
                                     sizeof sections / sizeof *sections, err);
    }
    free(files);
    free(path);
    return status;
}

/* ---- reading ---- */

/* While parts are read. */
typedef struct reading {
    murk_follow *follow;
    char *files;    /* checksums of the files of the scene */
    uint32_t count; /* of the parts of the run; 0: no part was read yet */
    bool *has;      /* [count] parts that were given */
    bool *damaged;  /* [steps] a part has the step, with damaged files */
} reading;

/* A part that is read. */
typedef struct part_file {
    size_t number; /* from 1, among those given */
    const char *folder;
    char *path; /* of follow.part */
    murk_section *sections;
    size_t n;
} part_file;

static murk_status bad_part(const part_file *p, const char *what,
                            murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, p->path,
                     "no part of a sequence of steps: %s", what);
}

/* Compares a text of the file with that of this run. */
static murk_status check_text(const part_file *p, const char *name,
                              const char *text, const char *what,
                              murk_error *err)
{
    const murk_section *section = murk_map_file_find(p->sections, p->n, name);
    return section ? murk_lightmap_check_text(section, text, what, p->path, err)
                   : bad_part(p, "a text is missing", err);
}

/* Checks that the part is one of this run, made by this version of murk. */
static murk_status check_part(reading *r, const part_file *p, const facts *f,
                              murk_error *err)
{
    const murk_follow *follow = r->follow;
    murk_status status = murk_shard_check_version(
        f->version, sizeof f->version, murk_host_version(), p->path, err);
    if (!status) {
        status = check_text(p, "scene", follow->session.scene->whole_key,
                            "scene", err);
    }
    if (!status) {
        status =
            check_text(p, "files", r->files, "file that the scene names", err);
    }
    /* The number of steps and of parts. */
    if (!status && f->steps != follow->steps) {
        status = bad_part(p, "another number of steps", err);
    }
    if (!status && r->count > 0 && f->count != r->count) {
        status = murk_fail(err, MURK_BAD_VALUE, p->path,
                           "part %u of %u, other parts are of %u", f->number,
                           f->count, r->count);
    }
    if (!status && r->count == 0) {
        r->has = calloc(f->count, sizeof *r->has);
        r->count = r->has ? f->count : 0;
        status = r->has ? MURK_OK : murk_no_memory(err, p->path, "to read it");
    }
    return status;
}

/* Sets the identity that the plan of step i must have, and the checksum of the
 * scene file; `start`: the file at which the search begins, or NULL. */
static murk_status expect(char identity[65], char scene_sum[65],
                          const murk_follow *follow, size_t i,
                          const char *start, murk_error *err)
{
    const double t_s =
        murk_timeline_time_s(&follow->session.scene->timeline, i);
    murk_scene *scene = NULL;
    murk_session session = {.scene = NULL};
    murk_status status = murk_follow_scene_at(&scene, follow, t_s, start, err);
    if (!status) {
        status = murk_scene_describe(&session.scene, scene, err);
    }
    if (!status) {
        status = murk_save_identify(&session, "place", &follow->save, "", err);
    }
    if (!status) {
        memcpy(identity, session.identity, sizeof session.identity);
        memcpy(scene_sum, session.scene->sha256, sizeof session.scene->sha256);
    }
    murk_scene_desc_destroy(session.scene);
    murk_scene_destroy(scene);
    return status;
}

/* Fails unless the step begins at the same sensors, and its plan follows from
 * the same scene, files and options as that of this run. */
static murk_status check_step(const reading *r, const part_file *p, size_t i,
                              murk_error *err)
{
    char *start = NULL, identity[65], scene_sum[65];
    const char *plan = NULL;
    char *path = murk_follow_file(p->folder, i, PLAN);
    cJSON *root = murk_follow_read_json(p->folder, i, PLAN);
    murk_status status =
        path && root
            ? murk_follow_part_start(&start, r->follow, p->folder, i, err)
            : murk_no_memory(err, p->path, "to read it");
    if (!status) {
        status = expect(identity, scene_sum, r->follow, i, start, err);
    }
    if (!status) {
        plan = cJSON_GetStringValue(cJSON_GetObjectItem(root, "identity"));
    }
    /* The difference: the scene file, or what else the identity follows from.
     */
    if (!status && (!plan || strcmp(plan, identity) != 0)) {
        plan = cJSON_GetStringValue(cJSON_GetObjectItem(root, "scene_sha256"));
        status = murk_fail(err, MURK_BAD_VALUE, path,
                           "made for another step %zu: %s", i,
                           plan && strcmp(plan, scene_sum) == 0
                               ? "an option, or a file that the scene names, "
                                 "is another one"
                               : "the scene has changed");
    }
    cJSON_Delete(root);
    free(start);
    free(path);
    return status;
}

/* True if both lists have the same files with the same checksums, but for the
 * resolved scene, which names files by their folder. */
static bool is_same(const murk_owned *a, const murk_owned *b)
{
    size_t n = 0, same = 0;
    for (size_t i = 0; i < a->n; ++i) {
        const murk_owned_file *file = &a->file[i];
        const bool counts =
            !file->is_earlier && strcmp(file->name, MURK_SCENE_NAME) != 0;
        n += counts;
        for (size_t k = 0; k < b->n && counts; ++k) {
            same += !b->file[k].is_earlier &&
                    strcmp(b->file[k].name, file->name) == 0 &&
                    strcmp(b->file[k].sum, file->sum) == 0;
        }
    }
    return n == same;
}

/* Fails if another part has given the step with other results. */
static murk_status check_again(const reading *r, const part_file *p,
                               const murk_owned *owned, const facts *f,
                               size_t i, murk_error *err)
{
    const murk_follow *follow = r->follow;
    const char *other = follow->part[follow->part_of[i] - 1];
    murk_owned before = {0};
    char *folder = murk_follow_file(other, i, NULL);
    murk_status status =
        folder ? MURK_OK : murk_no_memory(err, p->path, "to read it");
    if (!status) {
        murk_owned_read(&before, folder);
        status = is_same(&before, owned) && is_same(owned, &before)
                     ? MURK_OK
                     : murk_fail(err, MURK_BAD_VALUE, p->path,
                                 "part %u of %u again, and step %zu other than "
                                 "in %s",
                                 f->number, f->count, i, other);
    }
    murk_owned_release(&before);
    free(folder);
    return status;
}

/* Takes step i of the part over. A step that has no plan has failed there. */
static murk_status take_step(reading *r, const part_file *p, const facts *f,
                             size_t i, murk_error *err)
{
    murk_follow *follow = r->follow;
    char *folder = murk_follow_file(p->folder, i, NULL);
    murk_owned owned = {0};
    if (!folder) {
        return murk_no_memory(err, p->path, "to read it");
    }
    murk_status status = MURK_OK;
    /* A step that is whole must be that of this run. */
    if (!murk_follow_has_file(p->folder, i, PLAN)) {
        goto done;
    }
    if (!murk_follow_is_whole(&owned, folder)) {
        r->damaged[i] = true;
        goto done;
    }
    status = check_step(r, p, i, err);
    if (!status && follow->part_of[i] > 0) {
        status = check_again(r, p, &owned, f, i, err);
    } else if (!status) {
        follow->part_of[i] = p->number;
    }
done:
    murk_owned_release(&owned);
    free(folder);
    return status;
}

static murk_status read_part(reading *r, part_file *p, murk_error *err)
{
    p->path = murk_path_join(p->folder, PART_FILE);
    murk_status status =
        p->path ? murk_map_file_read(&p->sections, &p->n, p->path, err)
                : murk_no_memory(err, p->folder, "to read it");
    if (status) {
        return status;
    }
    const murk_section *section = murk_map_file_find(p->sections, p->n, "part");
    const facts *f =
        section && section->size == sizeof *f ? section->bytes : NULL;
    if (!f || murk_shard_check((murk_shard){f->number, f->count}, NULL)) {
        return bad_part(p, "the section \"part\" is missing", err);
    }
    status = check_part(r, p, f, err);
    if (status) {
        return status;
    }
    /* Its steps, and no others that lie in the folder. */
    const size_t end = begin_of(r->follow->steps, f->number + 1, f->count);
    r->has[f->number - 1] = true;
    for (size_t i = begin_of(r->follow->steps, f->number, f->count);
         i < end && !status; ++i) {
        status = take_step(r, p, f, i, err);
    }
    return status;
}

static bool has_part(const void *of, uint32_t number)
{
    const reading *r = of;
    return r->has[number - 1];
}

/* Warns of missing parts, and of steps that cannot be taken over. */
static void warn(const reading *r)
{
    murk_shards_warn_of_missing(has_part, r, r->count,
                                "their steps are made now");
    for (size_t i = 0; i < r->follow->steps; ++i) {
        if (r->damaged[i] && !r->follow->part_of[i]) {
            murk_warn("merge",
                      "the files of step %zu are damaged or missing: it is "
                      "made now",
                      i);
        }
    }
}

static murk_status read_parts(murk_follow *follow, murk_error *err)
{
    reading r = {.follow = follow,
                 .files = murk_file_sums_print(follow->session.scene),
                 .damaged = calloc(follow->steps, sizeof *r.damaged)};
    murk_status status = r.files && r.damaged
                             ? MURK_OK
                             : murk_no_memory(err, "", "for the parts");
    for (size_t i = 0; i < follow->parts && !status; ++i) {
        part_file p = {.number = i + 1, .folder = follow->part[i]};
        status = read_part(&r, &p, err);
        murk_map_file_release(p.sections, p.n);
        free(p.path);
    }
    if (!status && r.count > 0) {
        warn(&r);
    }
    free(r.files);
    free(r.has);
    free(r.damaged);
    return status;
}

murk_status murk_follow_merge(murk_follow *follow, const char *const *part,
                              size_t parts, murk_error *error)
{
    if (!follow || (parts > 0 && !part) || follow->sequence.rows > 0 ||
        follow->part_of || follow->shard.count > 0) {
        return murk_call_refuse(error,
                                "follow or part is NULL, or follow has steps, "
                                "parts or a shard");
    }
    murk_call call =
        murk_call_begin(follow->scene->context, &follow->scene->files, error);
    follow->part = calloc(parts + 1, sizeof *follow->part);
    follow->part_of = calloc(follow->steps, sizeof *follow->part_of);
    bool has_all = follow->part && follow->part_of;
    /* Copy the names of the folders, then read the parts. */
    for (size_t i = 0; i < parts && has_all; ++i) {
        follow->part[i] = part[i] ? strdup(part[i]) : NULL;
        has_all = follow->part[i] != NULL;
        follow->parts += has_all;
    }
    murk_status status =
        has_all ? read_parts(follow, &call.failure)
                : murk_no_memory(&call.failure, "", "for the parts");
    if (status) {
        murk_follow_release_parts(follow);
    }
    return murk_call_end(&call, status);
}

void murk_follow_release_parts(murk_follow *follow)
{
    for (size_t i = 0; i < follow->parts; ++i) {
        free(follow->part[i]);
    }
    free(follow->part);
    free(follow->part_of);
    follow->part = NULL;
    follow->part_of = NULL;
    follow->parts = 0;
}

/* ---- copying ---- */

/* A murk_results_writer of the bytes of the file `from`. */
static murk_status write_copy(const char *path, const void *from,
                              murk_error *err)
{
    return murk_file_copy_own(path, from, UINT64_MAX, err);
}

/* Adds a copy of a file of the step in the folder of the part. */
static murk_status add_copy(murk_results *results, const char *part, size_t i,
                            const char *name, murk_error *err)
{
    char *from = murk_follow_file(part, i, name);
    const murk_status status =
        from ? murk_results_add(results, name, write_copy, from, err)
             : murk_no_memory(err, name, "to copy it");
    free(from);
    return status;
}

/* Adds the main JSON of the step. It states the checksum of the resolved scene,
 * which names the file of the start, and so the folder. */
static murk_status add_plan(murk_results *results, const char *part, size_t i,
                            const char *resolved, murk_error *err)
{
    static const char key[] = "\"" MURK_SCENE_NAME "\": \"";
    char *path = murk_follow_file(part, i, PLAN), *text = NULL, sum[65];
    size_t size = 0;
    murk_status status =
        path ? murk_file_read_own(&text, &size, path, MURK_YAML_MAX_BYTES, err)
             : murk_no_memory(err, PLAN, "to copy it");
    char *at = status ? NULL : strstr(text, key);
    if (at && strlen(at) > sizeof key + 64) {
        murk_sha256_hex(resolved, strlen(resolved), sum);
        memcpy(at + sizeof key - 1, sum, 64);
        murk_json_put_sum(text);
    }
    if (!status) {
        status = murk_results_add_text(results, PLAN, text, err);
    }
    free(text);
    free(path);
    return status;
}

/* Copies the files of the step from the folder of the part into that of this
 * run, but for start.csv, which is there. */
static murk_status copy_step(const murk_follow *follow,
                             const murk_follow_step *step, const char *part,
                             murk_error *err)
{
    const char *resolved = step->world->desc->resolved;
    const size_t i = step->number;
    char *folder = murk_follow_file(follow->folder, i, NULL),
         *from = murk_follow_file(part, i, NULL);
    murk_owned owned = {0};
    murk_results results = {0};
    murk_status status =
        folder && from
            ? murk_results_begin(&results, folder, follow->save.replaces, err)
            : murk_no_memory(err, "", "for the step");
    if (!status) {
        murk_owned_read(&owned, from);
    }
    /* The files in their order, the main JSON last. */
    for (size_t k = 0; k < owned.n && !status; ++k) {
        const char *name = owned.file[k].name;
        if (owned.file[k].is_earlier || strcmp(name, MURK_STEP_START) == 0) {
            continue;
        }
        status = strcmp(name, MURK_SCENE_NAME) == 0
                     ? murk_results_add_text(&results, name, resolved, err)
                     : add_copy(&results, part, i, name, err);
    }
    if (!status) {
        status = add_copy(&results, part, i, LEDGER, err);
    }
    if (!status) {
        status = add_plan(&results, part, i, resolved, err);
    }
    if (!status) {
        status = murk_results_show(&results, err);
    }
    murk_results_end(&results);
    murk_owned_release(&owned);
    free(folder);
    free(from);
    return status;
}

murk_status murk_follow_take_part(bool *is_taken, const murk_follow *follow,
                                  murk_follow_step *step, murk_error *err)
{
    const size_t number = follow->part_of ? follow->part_of[step->number] : 0;
    *is_taken = false;
    if (number == 0) {
        return MURK_OK;
    }
    const char *part = follow->part[number - 1];
    const char *folder = follow->folder ? follow->folder : part;
    const murk_status status =
        follow->folder ? copy_step(follow, step, part, err) : MURK_OK;
    *is_taken = !status && murk_follow_take_earlier(follow, folder, step);
    return status;
}
