/* Imports the grids of density and albedo of a scene's media by medium/grid.h,
 * which reads files in subprocesses, or shares them with another scene, and
 * borrows the profiles of the media from the scene. murk_fillings_files()
 * reports a missing frame of a sequence with the list of frames that exist. */
#include "world/fillings.h"

#include "scene/frames.h"
#include "scene/ground.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool is_missing(const char *path)
{
    return path && access(path, F_OK) != 0 && errno == ENOENT;
}

/* Fails with the number of the frame that is missing. */
static murk_status frame_missing(const murk_scene_medium *m, uint64_t number,
                                 const char *frames, murk_error *err)
{
    return m->vdb_next
               ? murk_fail(err, MURK_BAD_FILE, m->where,
                           "frame %.15g is between two frames, and frame "
                           "%llu of %s is not there; there are %s",
                           m->frame, (unsigned long long)number, m->vdb_frames,
                           frames)
               : murk_fail(err, MURK_BAD_FILE, m->where,
                           "frame %llu of %s is not there; there are %s",
                           (unsigned long long)number, m->vdb_frames, frames);
}

/* Fails if a density file of a medium does not exist and is a frame of a
 * sequence, or is the pattern of a sequence because the scene gives no frame
 * number. A missing file that belongs to no sequence is no failure here. */
static murk_status find_frames(const murk_scene_medium *m, murk_error *err)
{
    const char *pattern = m->vdb_frames ? m->vdb_frames : m->vdb;
    char *any = murk_frames_file(pattern, 0);
    const bool is_sequence = any != NULL;
    free(any);
    const bool misses_first = is_sequence && is_missing(m->vdb);
    if (!misses_first && !is_missing(m->vdb_next)) {
        return MURK_OK;
    }
    char frames[256];
    murk_frames_list(pattern, frames, sizeof frames);
    const uint64_t number = (uint64_t)m->frame + (misses_first ? 0 : 1);
    return m->has_frame ? frame_missing(m, number, frames, err)
                        : murk_fail(err, MURK_BAD_VALUE, m->where,
                                    "%s stands for a sequence: misses frame, "
                                    "there are %s",
                                    pattern, frames);
}

murk_status murk_fillings_files(const murk_scene_desc *scene, size_t i,
                                const char *file[MURK_FILLING_FILES],
                                murk_error *err)
{
    const murk_scene_medium *m = &scene->media[i];
    const bool is_same =
        m->vdb && m->albedo_vdb && strcmp(m->vdb, m->albedo_vdb) == 0;
    file[0] = m->vdb;
    file[1] = is_same ? NULL : m->albedo_vdb;
    file[2] = m->vdb_next;
    return m->vdb ? find_frames(m, err) : MURK_OK;
}

/* Reads the grids of medium i. */
static murk_status read_grids(murk_fillings *f, const murk_scene_desc *scene,
                              size_t i, murk_error *err)
{
    const murk_scene_medium *m = &scene->media[i];
    murk_status status = MURK_OK;
    /* The density by the kind of file, then the albedo. */
    if (m->vdb_next) {
        const char *const frames[] = {m->vdb, m->vdb_next};
        status = murk_grid_read_between(&f->grid[i], frames, m->next_weight,
                                        m->grid, m->where, err);
    } else if (m->vdb) {
        status = murk_grid_read(&f->grid[i], m->vdb, m->grid, m->where, err);
    } else if (m->fds) {
        const murk_fds_asked asked = {.quantity =
                                          (murk_fds_quantity)m->fds_quantity,
                                      .mesh = m->fds_mesh.value,
                                      .n_meshes = m->fds_mesh.n,
                                      .time_s = m->time_s};
        status = murk_grid_read_fds(&f->grid[i], m->fds, &asked, m->where, err);
    } else if (m->netcdf) {
        murk_netcdf_asked asked = {
            .liquid_water = m->liquid_water,
            .effective_radius = m->effective_radius,
            .variable = m->variable,
            .effective_radius_um = m->effective_radius_um,
            .per_unit = m->per_unit,
            .law = {m->law.n, m->law.value, m->law.density},
            .time_s = m->time_s,
            .is_linear = m->is_linear,
            .has_within = m->has_within,
            .altitude_m = scene->site.altitude_m};
        memcpy(asked.within_m, m->within_m, sizeof asked.within_m);
        asked.has_frame = murk_scene_frame(scene, &asked.frame);
        status = murk_grid_read_netcdf(&f->grid[i], m->netcdf, &asked, m->where,
                                       err);
    }
    if (!status && m->albedo_grid) {
        status = murk_grid_read_albedo(&f->albedo[i], m->albedo_vdb,
                                       m->albedo_grid, m->where, err);
    }
    return status;
}

/* Reads or shares the grids of medium i, and borrows the profile from the
 * scene. */
static murk_status fill(murk_fillings *f, const murk_scene_desc *scene,
                        size_t i, const murk_fillings *other, size_t from,
                        murk_error *err)
{
    const murk_scene_medium *m = &scene->media[i];
    f->profile[i] = (murk_profile){m->profile_z_m.n, m->profile_z_m.value,
                                   m->profile_per_m.value};
    if (from == MURK_NOT_SHARED) {
        return read_grids(f, scene, i, err);
    }
    f->grid[i] = murk_grid_share(other->grid[from]);
    f->albedo[i] = murk_grid_share(other->albedo[from]);
    return MURK_OK;
}

murk_status murk_fillings_create(murk_fillings **out,
                                 const murk_scene_desc *scene,
                                 const murk_fillings *other, const size_t *from,
                                 murk_error *err)
{
    murk_fillings *f = calloc(1, sizeof *f);
    bool has_memory = f != NULL;
    if (has_memory) {
        f->n = scene->n_media;
        f->grid = calloc(f->n + 1, sizeof *f->grid);
        f->albedo = calloc(f->n + 1, sizeof *f->albedo);
        f->profile = calloc(f->n + 1, sizeof *f->profile);
        has_memory = f->grid && f->albedo && f->profile;
    }
    murk_status status =
        has_memory
            ? MURK_OK
            : murk_no_memory(err, scene->path, "for what fills its media");
    /* Read the files of each medium. */
    for (size_t i = 0; i < scene->n_media && !status; ++i) {
        status =
            fill(f, scene, i, other, from ? from[i] : MURK_NOT_SHARED, err);
    }
    if (status) {
        murk_fillings_destroy(f);
        return status;
    }
    *out = f;
    return MURK_OK;
}

void murk_fillings_destroy(murk_fillings *f)
{
    if (!f) {
        return;
    }
    for (size_t i = 0; f->grid && f->albedo && i < f->n; ++i) {
        murk_grid_destroy(f->grid[i]);
        murk_grid_destroy(f->albedo[i]);
    }
    free(f->grid);
    free(f->albedo);
    free(f->profile);
    free(f);
}

void murk_fillings_give(const murk_fillings *fillings, size_t i,
                        murk_medium *medium)
{
    medium->grid = fillings->grid[i];
    medium->albedo_grid = fillings->albedo[i];
    if (fillings->profile[i].n > 0) {
        medium->profile = &fillings->profile[i];
    }
}
