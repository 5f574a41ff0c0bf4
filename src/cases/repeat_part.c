/* Writes and reads parts of the runs of murk_repeat (cases/repeat_part.h). The
 * sections of the file are "part" (which part of how many runs), "scene",
 * "files" and "plan" (texts of what the runs follow from) and "runs". Texts are
 * compared line by line, so that a message can name the first difference. */
#include "cases/repeat_part.h"

#include "base/host.h"
#include "base/number.h"
#include "lightmap/key_check.h"
#include "photonmap/map_file.h"
#include "scene/print.h"
#include "world/file_sums.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The section "part" of a file, as it is stored. */
typedef struct facts {
    uint64_t asked; /* runs of the undivided run, the first one included */
    uint32_t number, count;
    char version[64]; /* murk_host_version(), ended by '\0' */
} facts;

/* A run in the section "runs", as it is stored: without padding. */
typedef struct stored_run {
    uint64_t sensors;
    uint32_t seed, is_optimal;
    double in_sample, upper;
    double held_out[2], plan[2]; /* value and standard error; NaN: none */
} stored_run;

static stored_run store(const murk_repeat_run *run)
{
    return (stored_run){
        .sensors = run->sensors,
        .seed = run->seed,
        .is_optimal = run->proven_optimal,
        .in_sample = run->in_sample,
        .upper = run->upper,
        .held_out = {run->held_out.value, run->held_out.standard_error},
        .plan = {run->plan.value, run->plan.standard_error}};
}

static murk_repeat_run restore(const stored_run *run)
{
    return (murk_repeat_run){.sensors = run->sensors,
                             .seed = run->seed,
                             .proven_optimal = run->is_optimal,
                             .in_sample = run->in_sample,
                             .upper = run->upper,
                             .held_out = {run->held_out[0], run->held_out[1]},
                             .plan = {run->plan[0], run->plan[1]}};
}

/* The number of the first run of a shard; `asked` or more: the shard has none.
 * Nothing is repeated in the dark. */
static size_t first_of(const murk_repeat_first *first, size_t asked,
                       murk_shard shard)
{
    return first->plan->is_dark ? asked : shard.number;
}

static size_t count_runs(const murk_repeat_first *first, size_t asked,
                         murk_shard shard)
{
    const size_t from = first_of(first, asked, shard);
    return from < asked ? (asked - 1 - from) / shard.count + 1 : 0;
}

/* ---- what the runs follow from ---- */

typedef struct texts {
    const char *scene;
    char *files, *plan;
} texts;

static void release_texts(texts *t)
{
    free(t->files);
    free(t->plan);
}

/* Prints a value with all digits, or "none" if it is not finite. */
static void put_number(FILE *to, double value)
{
    char shown[MURK_NUMBER_SIZE] = "none";
    if (isfinite(value)) {
        murk_number_print(shown, value);
    }
    fprintf(to, " %s", shown);
}

/* The figures of the first run and the sensors of the plan. */
static char *print_plan(const murk_repeat_run *run,
                        const murk_plan_result *plan)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) {
        return NULL;
    }
    fputs("coverage", to);
    put_number(to, run->in_sample);
    put_number(to, run->upper);
    put_number(to, run->held_out.value);
    put_number(to, run->held_out.standard_error);
    for (size_t i = 0; i < plan->place.count; ++i) {
        const murk_pose *pose = &plan->sensor[i];
        fprintf(to, "\nsensor %lu", (unsigned long)pose->type);
        put_number(to, pose->position.x);
        put_number(to, pose->position.y);
        put_number(to, pose->position.z);
        put_number(to, pose->heading_rad);
        put_number(to, pose->tilt_rad);
    }
    return murk_print_finish(to, &text);
}

static murk_status make_texts(texts *out, const murk_repeat *repeat,
                              const murk_repeat_first *first, murk_error *err)
{
    const murk_scene_desc *scene = murk_repeat_scene(first);
    *out = (texts){.scene = scene->whole_key,
                   .files = murk_file_sums_print(scene),
                   .plan = print_plan(&repeat->run[0], first->plan)};
    return out->files && out->plan
               ? MURK_OK
               : murk_no_memory(err, "", "for the parts of %zu runs",
                                repeat->asked);
}

/* ---- writing ---- */

murk_status murk_repeat_part_write(const murk_repeat *repeat,
                                   const murk_repeat_first *first,
                                   murk_shard shard, const char *path,
                                   murk_error *err)
{
    const size_t n = count_runs(first, repeat->asked, shard);
    stored_run *run = calloc(n + 1, sizeof *run);
    texts t = {NULL, NULL, NULL};
    facts f = {
        .asked = repeat->asked, .number = shard.number, .count = shard.count};
    snprintf(f.version, sizeof f.version, "%s", murk_host_version());
    murk_status status =
        run ? make_texts(&t, repeat, first, err)
            : murk_no_memory(err, path, "for %zu runs", repeat->asked);
    /* Take the runs of the shard, and write the file. */
    if (!status) {
        const size_t from = first_of(first, repeat->asked, shard);
        for (size_t k = 0; k < n; ++k) {
            run[k] = store(&repeat->run[from + k * shard.count]);
        }
        const murk_section sections[] = {
            murk_section_of("part", &f, sizeof f),
            murk_section_of("scene", t.scene, strlen(t.scene)),
            murk_section_of("files", t.files, strlen(t.files)),
            murk_section_of("plan", t.plan, strlen(t.plan)),
            murk_section_of("runs", run, n * sizeof *run)};
        status = murk_map_file_write(path, sections,
                                     sizeof sections / sizeof *sections, err);
    }
    release_texts(&t);
    free(run);
    return status;
}

murk_status murk_repeat_part_make(const murk_repeat_first *first, size_t asked,
                                  murk_shard shard, unsigned threads,
                                  const char *path, murk_error *err)
{
    murk_repeat repeat = {.run = NULL};
    bool *is_left_out = malloc(asked * sizeof *is_left_out);
    murk_status status = is_left_out
                             ? murk_repeat_begin(&repeat, first, asked, err)
                             : murk_no_memory(err, path, "for %zu runs", asked);
    /* Leave the runs of other shards out. */
    if (!status) {
        const size_t n = count_runs(first, asked, shard);
        const size_t from = first_of(first, asked, shard);
        memset(is_left_out, true, asked * sizeof *is_left_out);
        for (size_t k = 0; k < n; ++k) {
            is_left_out[from + k * shard.count] = false;
        }
        status = murk_repeat_make(&repeat, first, is_left_out, threads, err);
    }
    if (!status) {
        status = murk_repeat_part_write(&repeat, first, shard, path, err);
    }
    free(is_left_out);
    murk_repeat_release(&repeat);
    return status;
}

/* ---- reading ---- */

/* The parts that were read. */
typedef struct reading {
    murk_repeat *repeat;
    bool *has_run;
    const murk_repeat_first *first;
    texts texts;
    uint32_t count;    /* of shards; 0: no part was read */
    const char **path; /* [count] of the file of each part; NULL: missing */
} reading;

/* A file that is read. */
typedef struct part_file {
    const char *path;
    murk_section *sections; /* [n] */
    size_t n;
} part_file;

static murk_status bad_part(const part_file *file, const char *what,
                            murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, file->path,
                     "no part of repeated placements: %s", what);
}

/* Compares a text of the file with that of the run that is merged. */
static murk_status check_text(const part_file *file, const char *name,
                              const char *text, const char *what,
                              murk_error *err)
{
    const murk_section *section =
        murk_map_file_find(file->sections, file->n, name);
    return section
               ? murk_lightmap_check_text(section, text, what, file->path, err)
               : bad_part(file, "a text is missing", err);
}

/* Checks that the part belongs to the run, and was written by this version of
 * murk. */
static murk_status check_owner(const reading *r, const part_file *file,
                               const facts *f, murk_error *err)
{
    /* The version, the scene, the files that it names, and the plan; then the
     * number of runs and of parts. */
    murk_status status = murk_shard_check_version(
        f->version, sizeof f->version, murk_host_version(), file->path, err);
    status = status ? status
                    : check_text(file, "scene", r->texts.scene, "scene", err);
    if (!status) {
        status = check_text(file, "files", r->texts.files,
                            "file that the scene names", err);
    }
    if (!status) {
        status = check_text(file, "plan", r->texts.plan, "first plan", err);
    }
    if (!status && f->asked != r->repeat->asked) {
        status = murk_fail(err, MURK_BAD_VALUE, file->path,
                           "part of %llu runs, must be of %zu",
                           (unsigned long long)f->asked, r->repeat->asked);
    }
    if (!status && r->count > 0 && f->count != r->count) {
        status = murk_fail(err, MURK_BAD_VALUE, file->path,
                           "part %u of %u, other parts are of %u", f->number,
                           f->count, r->count);
    }
    return status;
}

/* True if a run can have such an estimate: none, or a coverage. */
static bool is_estimate(double value)
{
    return isnan(value) || (isfinite(value) && value >= 0);
}

static bool is_possible(const stored_run *run)
{
    return run->is_optimal <= 1 && is_estimate(run->in_sample) &&
           is_estimate(run->upper) && is_estimate(run->held_out[0]) &&
           is_estimate(run->held_out[1]) && is_estimate(run->plan[0]) &&
           is_estimate(run->plan[1]);
}

/* Takes the runs of a part over. A run that another file had must be equal. */
static murk_status take_runs(reading *r, const part_file *file, const facts *f,
                             murk_error *err)
{
    const murk_shard shard = {f->number, f->count};
    const size_t asked = r->repeat->asked;
    const size_t n = count_runs(r->first, asked, shard);
    const size_t from = first_of(r->first, asked, shard);
    const murk_section *runs =
        murk_map_file_find(file->sections, file->n, "runs");
    if (!runs || runs->size != n * sizeof(stored_run)) {
        return bad_part(file, "other runs than those of the part", err);
    }
    /* Take each run that is possible, and no other than the one that is there.
     */
    for (size_t k = 0; k < n; ++k) {
        const size_t i = from + k * shard.count;
        const stored_run *run = (const stored_run *)runs->bytes + k;
        if (run->seed != r->repeat->run[0].seed + i || !is_possible(run)) {
            return bad_part(file, "a run that murk cannot have made", err);
        }
        const stored_run there = store(&r->repeat->run[i]);
        if (r->has_run[i] && memcmp(&there, run, sizeof there) != 0) {
            return murk_fail(err, MURK_BAD_VALUE, file->path,
                             "part %u of %u again, and other than %s: the "
                             "runs of seed %lu differ",
                             shard.number, shard.count,
                             r->path[shard.number - 1],
                             (unsigned long)run->seed);
        }
        r->repeat->run[i] = restore(run);
        r->has_run[i] = true;
    }
    r->path[shard.number - 1] = file->path;
    return MURK_OK;
}

static murk_status read_part(reading *r, const char *path, murk_error *err)
{
    part_file file = {path, NULL, 0};
    murk_status status = murk_map_file_read(&file.sections, &file.n, path, err);
    if (status) {
        return status;
    }
    const murk_section *section =
        murk_map_file_find(file.sections, file.n, "part");
    const facts *f =
        section && section->size == sizeof *f ? section->bytes : NULL;
    if (!f || murk_shard_check((murk_shard){f->number, f->count}, NULL)) {
        status = bad_part(&file, "the section \"part\" is missing", err);
    } else {
        status = check_owner(r, &file, f, err);
    }
    /* The first part says how many there are. */
    if (!status && r->count == 0) {
        r->path = calloc(f->count, sizeof *r->path);
        r->count = r->path ? f->count : 0;
        status = r->path ? MURK_OK : murk_no_memory(err, path, "to read it");
    }
    if (!status) {
        status = take_runs(r, &file, f, err);
    }
    murk_map_file_release(file.sections, file.n);
    return status;
}

static bool has_part(const void *of, uint32_t number)
{
    const reading *r = of;
    return r->path[number - 1] != NULL;
}

murk_status murk_repeat_parts_read(murk_repeat *repeat, bool *has_run,
                                   const murk_repeat_first *first,
                                   const char *const *path, size_t n,
                                   murk_error *err)
{
    reading r = {.repeat = repeat, .has_run = has_run, .first = first};
    murk_status status = make_texts(&r.texts, repeat, first, err);
    for (size_t i = 0; i < n && !status; ++i) {
        status = read_part(&r, path[i], err);
    }
    if (!status && !first->plan->is_dark) {
        murk_shards_warn_of_missing(has_part, &r, r.count,
                                    "their seeds are run now");
    }
    release_texts(&r.texts);
    free(r.path);
    return status;
}

murk_status murk_repeat_merge(murk_repeat *out, const murk_repeat_first *first,
                              size_t asked, const char *const *path, size_t n,
                              unsigned threads, murk_error *err)
{
    bool *has_run = calloc(asked, sizeof *has_run);
    murk_status status = murk_repeat_begin(out, first, asked, err);
    if (!status && !has_run) {
        status = murk_no_memory(err, "", "for %zu runs", asked);
    }
    if (!status && n > 0) {
        status = murk_repeat_parts_read(out, has_run, first, path, n, err);
    }
    /* Make the runs that are missing. Nothing is repeated in the dark. */
    if (status || first->plan->is_dark) {
        murk_repeat_release(out);
    } else {
        status = murk_repeat_make(out, first, has_run, threads, err);
    }
    free(has_run);
    return status;
}
