#include "app/candidates_out.h"
#include "app/check_sensors.h"
#include "app/check_sky.h"
#include "app/goals_out.h"
#include "app/over_out.h"
#include "app/session.h"
#include "app/tallies_out.h"

#include <string.h>

#include "study/extent.h"
#include "study/machine.h"

/* Everything that check finds out, before it is printed one way or another. */
typedef struct findings {
    const murk_session *session;
    murk_surfaces_facts surfaces;
    murk_forecast forecast;
    murk_candidates *candidates; /* NULL without sensors */
    murk_poses *poses;           /* likewise */
} findings;

/* Most that the known environment's matrix can take: a bit a photon and
 * candidate in clear air, two bytes where media dim. */
static double matrix_bytes(const findings *f)
{
    const double records = f->forecast.surface + f->forecast.volume;
    const double usable = f->poses ? (double)f->poses->count : 0;
    const bool dims = murk_media_any(f->session->stage->media);
    return records * usable * (dims ? 2 : 0.125);
}

static void add_box(cJSON *object, const char *key, const murk_box *box)
{
    if (!(box->min.x <= box->max.x)) {
        cJSON_AddNullToObject(object, key);
        return;
    }
    cJSON *item = cJSON_AddObjectToObject(object, key);
    murk_json_vector(item, "min_m", box->min);
    murk_json_vector(item, "max_m", box->max);
}

static void add_spectrum(cJSON *object, const char *key,
                         const murk_spectrum *spectrum, int bands)
{
    cJSON_AddItemToObject(object, key,
                          cJSON_CreateDoubleArray(spectrum->band, bands));
}

static void add_surfaces(cJSON *root, const findings *f)
{
    const murk_scene *scene = f->session->scene;
    cJSON *object = cJSON_AddObjectToObject(root, "surfaces");
    cJSON_AddNumberToObject(object, "triangles", (double)f->surfaces.triangles);
    cJSON_AddNumberToObject(object, "spheres", (double)f->surfaces.spheres);
    cJSON_AddNumberToObject(object, "degenerate",
                            (double)f->surfaces.degenerate);
    cJSON_AddNumberToObject(object, "solids", (double)f->surfaces.solids);
    cJSON_AddNumberToObject(object, "sheets", (double)f->surfaces.sheets);
    cJSON_AddNumberToObject(object, "area_m2", f->surfaces.area_m2);
    add_box(object, "bounds", &f->surfaces.bounds_m);
    cJSON *materials = cJSON_AddArrayToObject(object, "materials");
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", m->name);
        cJSON_AddNumberToObject(
            item, "area_m2",
            murk_surfaces_material_area(f->session->stage->surfaces, i));
        add_spectrum(item, "diffuse", &m->diffuse, scene->bands);
        add_spectrum(item, "specular", &m->specular, scene->bands);
        add_spectrum(item, "transmit", &m->transmit, scene->bands);
        cJSON_AddItemToArray(materials, item);
    }
}

/* What the region fills; of an unbounded one the part in the domain. */
static murk_box region_box(const findings *f, size_t i)
{
    const murk_stage *stage = f->session->stage;
    const murk_scene_region *r = &stage->scene->regions[i];
    murk_box box = stage->world.domain.box;
    if (murk_extent_is_bounded(r)) {
        return murk_extent_region(stage->scene, r, stage->grid[r->medium],
                                  stage->region_mesh[i]);
    }
    const murk_scene_numbers *z = &stage->scene->media[r->medium].profile_z_m;
    if (z->n > 0) {
        box.min.z = fmax(box.min.z, z->value[0]);
        box.max.z = fmin(box.max.z, z->value[z->n - 1]);
    }
    if (r->shape == MURK_SCENE_BELOW && r->below_z_m < box.max.z) {
        box.max.z = r->below_z_m;
    }
    return box.min.z < box.max.z ? box : murk_box_empty();
}

static const murk_phase *phase_of(const findings *f, size_t medium, int band)
{
    return &f->session->stage->phases->medium[medium][band];
}

/* A band's phase function, and of a table what normalising it told. */
static cJSON *phase_json(const findings *f, size_t medium, int band)
{
    const murk_scene_medium *m = &f->session->scene->media[medium];
    const murk_phase *phase = phase_of(f, medium, band);
    cJSON *item = cJSON_CreateObject();
    cJSON_AddStringToObject(item, "kind", murk_phases_kind(m, band));
    cJSON_AddNumberToObject(item, "mean_cosine", murk_phase_mean_cosine(phase));
    if (phase->table) {
        const murk_phase_facts *facts = murk_phase_table_facts(phase->table);
        cJSON_AddNumberToObject(item, "backward", facts->backward);
        cJSON_AddNumberToObject(item, "integral", facts->integral);
        cJSON_AddNumberToObject(item, "before_first", facts->before_first);
        cJSON_AddNumberToObject(item, "behind_last", facts->behind_last);
    }
    return item;
}

static void add_phases(cJSON *item, const findings *f, size_t medium)
{
    const int bands = f->session->scene->bands;
    murk_spectrum mean = {{0}};
    cJSON *list = cJSON_AddArrayToObject(item, "phase");
    for (int band = 0; band < bands; ++band) {
        mean.band[band] = murk_phase_mean_cosine(phase_of(f, medium, band));
        cJSON_AddItemToArray(list, phase_json(f, medium, band));
    }
    add_spectrum(item, "mean_cosine", &mean, bands);
}

static murk_spectrum profile_maximum(const murk_scene_medium *m)
{
    murk_spectrum most = {{0}};
    for (size_t i = 0; i < m->profile_per_m.n; ++i) {
        for (int band = 0; band < MURK_BANDS_MAX; ++band) {
            most.band[band] =
                fmax(most.band[band], m->profile_per_m.value[i].band[band]);
        }
    }
    return most;
}

static void add_profile(cJSON *item, const murk_scene_medium *m, int bands)
{
    const murk_scene_numbers *z = &m->profile_z_m;
    const double ends[] = {z->value[0], z->value[z->n - 1]};
    const murk_spectrum most = profile_maximum(m);
    cJSON *profile = cJSON_AddObjectToObject(item, "profile");
    cJSON_AddNumberToObject(profile, "heights", (double)z->n);
    cJSON_AddItemToObject(profile, "z_m", cJSON_CreateDoubleArray(ends, 2));
    add_spectrum(profile, "maximum_per_m", &most, bands);
}

static void add_grid(cJSON *item, const char *key, const murk_grid *grid)
{
    if (!grid) {
        return;
    }
    const murk_grid_facts *facts = murk_grid_describe(grid);
    cJSON *g = cJSON_AddObjectToObject(item, key);
    cJSON_AddStringToObject(g, "name", facts->name);
    cJSON_AddNumberToObject(g, "active_voxels", (double)facts->active);
    cJSON_AddNumberToObject(g, "minimum", facts->minimum);
    cJSON_AddNumberToObject(g, "maximum", facts->maximum);
    cJSON_AddNumberToObject(g, "sum", facts->sum);
    cJSON_AddItemToObject(g, "voxel_m",
                          cJSON_CreateDoubleArray(facts->voxel_m, 3));
}

static void add_media(cJSON *root, const findings *f)
{
    const murk_scene *scene = f->session->scene;
    cJSON *media = cJSON_AddArrayToObject(root, "media");
    for (size_t i = 0; i < scene->n_media; ++i) {
        const murk_scene_medium *m = &scene->media[i];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "name", m->name);
        if (m->profile_z_m.n > 0) {
            add_profile(item, m, scene->bands);
        } else {
            add_spectrum(item, "extinction_per_m", &m->extinction_per_m,
                         scene->bands);
        }
        if (!m->albedo_grid) {
            add_spectrum(item, "albedo", &m->albedo, scene->bands);
        }
        add_phases(item, f, i);
        add_grid(item, "grid", f->session->stage->fillings->grid[i]);
        add_grid(item, "albedo_grid", f->session->stage->fillings->albedo[i]);
        cJSON_AddItemToArray(media, item);
    }
    cJSON *regions = cJSON_AddArrayToObject(root, "regions");
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        cJSON *item = cJSON_CreateObject();
        cJSON_AddStringToObject(item, "medium", scene->media[r->medium].name);
        const murk_box box = region_box(f, i);
        add_box(item, "bounds", &box);
        if (r->shape == MURK_SCENE_IN_MESH) {
            const murk_hull_facts mesh =
                murk_hulls_describe(f->session->stage->hulls, (int)i);
            cJSON_AddNumberToObject(item, "triangles", (double)mesh.triangles);
            cJSON_AddNumberToObject(item, "crossings", (double)mesh.crossings);
        }
        if (r->ior > 0) {
            cJSON_AddNumberToObject(item, "ior", r->ior);
        }
        if (r->wind_m_per_s > 0) {
            cJSON_AddNumberToObject(item, "wind_m_per_s", r->wind_m_per_s);
        }
        cJSON_AddItemToArray(regions, item);
    }
}

static cJSON *check_json(const findings *f)
{
    const murk_stage *stage = f->session->stage;
    cJSON *root = murk_json_begin(f->session->scene);
    cJSON *domain = cJSON_AddObjectToObject(root, "domain");
    murk_json_vector(domain, "min_m", stage->world.domain.box.min);
    murk_json_vector(domain, "max_m", stage->world.domain.box.max);
    cJSON_AddStringToObject(
        domain, "sides", stage->world.domain.is_periodic ? "periodic" : "open");
    add_surfaces(root, f);
    add_media(root, f);
    murk_json_lights(root, stage);
    if (f->candidates) {
        murk_json_candidates(root, f->candidates);
    } else {
        cJSON_AddNullToObject(root, "candidates");
    }
    murk_json_sensor_types(root, f->session->scene, f->poses);
    murk_json_tallies(root, f->session);
    cJSON *forecast = cJSON_AddObjectToObject(root, "forecast");
    cJSON_AddNumberToObject(forecast, "pilot_photons",
                            (double)f->forecast.pilot_photons);
    cJSON_AddNumberToObject(forecast, "emitted", f->forecast.emitted);
    cJSON_AddNumberToObject(forecast, "surface", f->forecast.surface);
    cJSON_AddNumberToObject(forecast, "volume", f->forecast.volume);
    cJSON_AddNumberToObject(forecast, "memory_bytes", f->forecast.memory_bytes);
    cJSON_AddNumberToObject(forecast, "matrix_bytes_at_most", matrix_bytes(f));
    return root;
}

static void print_phase(const findings *f, size_t medium, int band)
{
    const murk_phase *phase = phase_of(f, medium, band);
    const char *kind =
        murk_phases_kind(&f->session->scene->media[medium], band);
    printf("%s, mean cosine %.6g", kind, murk_phase_mean_cosine(phase));
    if (phase->table) {
        printf(", %.4g backward",
               murk_phase_table_facts(phase->table)->backward);
    }
    if (strcmp(kind, "table") == 0) {
        const murk_phase_facts *facts = murk_phase_table_facts(phase->table);
        printf(" (integral %.6g before it became 1; share before the first "
               "row %.3g, behind the last %.3g)",
               facts->integral, facts->before_first, facts->behind_last);
    }
}

static bool is_same(const murk_phase *a, const murk_phase *b)
{
    return a->kind == b->kind && a->g == b->g && a->g2 == b->g2 &&
           a->weight == b->weight && a->table == b->table;
}

/* One phase, or one a band where they differ. */
static void print_phases(const findings *f, size_t medium)
{
    const murk_scene *scene = f->session->scene;
    bool are_equal = true;
    for (int band = 1; band < scene->bands; ++band) {
        are_equal = are_equal &&
                    is_same(phase_of(f, medium, band), phase_of(f, medium, 0));
    }
    printf("phase       %s: ", scene->media[medium].name);
    for (int band = 0; band < (are_equal ? 1 : scene->bands); ++band) {
        if (!are_equal) {
            printf("%s%.6g nm ", band ? "; " : "", scene->band_nm[band]);
        }
        print_phase(f, medium, band);
    }
    printf("\n");
}

static void print_medium(const findings *f, size_t medium)
{
    const murk_scene_medium *m = &f->session->scene->media[medium];
    const murk_fillings *fillings = f->session->stage->fillings;
    const murk_grid *grid = fillings->grid[medium];
    const murk_grid *albedo = fillings->albedo[medium];
    if (m->profile_z_m.n > 0) {
        printf("medium      %s: %zu heights, %.4g to %.4g m, extinction up to "
               "%.6g /m",
               m->name, m->profile_z_m.n, m->profile_z_m.value[0],
               m->profile_z_m.value[m->profile_z_m.n - 1],
               profile_maximum(m).band[0]);
    } else {
        printf("medium      %s: extinction %.6g /m", m->name,
               m->extinction_per_m.band[0]);
    }
    if (albedo) {
        const murk_grid_facts *facts = murk_grid_describe(albedo);
        printf(", albedo %.4g..%.4g by grid %s, %.4g elsewhere", facts->minimum,
               facts->maximum, facts->name, facts->background);
    } else {
        printf(", albedo %.4g", m->albedo.band[0]);
    }
    if (grid) {
        const murk_grid_facts *facts = murk_grid_describe(grid);
        printf("; %sgrid %s: %llu voxels of %.4g m, density %.4g..%.4g",
               m->is_linear ? "linear " : "", facts->name,
               (unsigned long long)facts->active, facts->voxel_m[0],
               facts->minimum, facts->maximum);
    }
}

static void print_media(const findings *f)
{
    const murk_scene *scene = f->session->scene;
    for (size_t i = 0; i < scene->n_media; ++i) {
        print_medium(f, i);
        printf("%s\n", scene->bands > 1 ? " (first band)" : "");
        print_phases(f, i);
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_region *r = &scene->regions[i];
        const murk_box box = region_box(f, i);
        printf("region      %s", scene->media[r->medium].name);
        if (r->shape == MURK_SCENE_EVERYWHERE) {
            printf(" everywhere");
            if (scene->media[r->medium].profile_z_m.n > 0) {
                printf(" at %.4g to %.4g m", box.min.z, box.max.z);
            }
        } else if (r->shape == MURK_SCENE_BELOW) {
            printf(" below z = %.4g m", r->below_z_m);
        } else {
            printf(" in %.4g %.4g %.4g to %.4g %.4g %.4g m", box.min.x,
                   box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
        }
        if (r->shape == MURK_SCENE_IN_MESH) {
            printf(", a mesh of %zu triangles",
                   murk_hulls_describe(f->session->stage->hulls, (int)i)
                       .triangles);
        }
        if (r->ior > 0) {
            printf(", index %.5g", r->ior);
        }
        if (r->wind_m_per_s > 0) {
            printf(", waves of %.3g m/s wind", r->wind_m_per_s);
        }
        printf("\n");
    }
}

static void print_findings(const findings *f)
{
    const murk_stage *stage = f->session->stage;
    const murk_domain *domain = &stage->world.domain;
    const murk_surfaces_facts *s = &f->surfaces;
    printf("scene       %s: %d band%s, seed %u\n", f->session->scene->path,
           f->session->scene->bands, f->session->scene->bands > 1 ? "s" : "",
           f->session->scene->seed);
    printf("domain      %.6g %.6g %.6g to %.6g %.6g %.6g m, %s sides\n",
           domain->box.min.x, domain->box.min.y, domain->box.min.z,
           domain->box.max.x, domain->box.max.y, domain->box.max.z,
           domain->is_periodic ? "periodic" : "open");
    printf("surfaces    %zu triangles, %zu spheres, %.4g m2; %zu solids, %zu "
           "sheets; %zu degenerate triangles left out\n",
           s->triangles, s->spheres, s->area_m2, s->solids, s->sheets,
           s->degenerate);
    for (size_t i = 0; i < f->session->scene->n_materials; ++i) {
        const murk_scene_material *m = &f->session->scene->materials[i];
        printf("material    %-12s %10.4g m2: diffuse %.3g, specular %.3g, "
               "transmit %.3g\n",
               m->name, murk_surfaces_material_area(stage->surfaces, i),
               m->diffuse.band[0], m->specular.band[0], m->transmit.band[0]);
    }
    print_media(f);
    murk_print_lights(stage);
    if (f->candidates) {
        murk_print_candidates(f->candidates);
        murk_print_sensor_types(f->session->scene, f->poses);
    } else {
        printf("candidates  none: the scene has no sensors\n");
    }
    murk_print_asked_goals(f->session->scene);
    murk_over_print_asked(f->session->scene);
    murk_print_asked_tallies(f->session);
    printf("forecast    %.3g photons emitted; stored: %.3g surface, %.3g "
           "volume (from a pilot of %llu photons)\n",
           f->forecast.emitted, f->forecast.surface, f->forecast.volume,
           (unsigned long long)f->forecast.pilot_photons);
    if (!(f->forecast.memory_bytes + matrix_bytes(f) >= 1e5)) {
        return; /* not worth a word */
    }
    printf("memory      about %.3g GB a map while tracing; to place in a known "
           "environment at most %.3g GB more\n",
           f->forecast.memory_bytes / 1e9, matrix_bytes(f) / 1e9);
}

murk_status murk_command_check(const murk_options *options, murk_error *err)
{
    murk_session session;
    findings f = {.session = &session};
    murk_status status = murk_session_begin(&session, options, err);
    if (!status) {
        f.surfaces = murk_surfaces_describe(session.stage->surfaces);
        status = murk_light_forecast(&f.forecast, session.stage, 0,
                                     options->threads, err);
    }
    if (!status && session.scene->placement.targets.given) {
        status = murk_targets_check(session.stage, options->threads, err);
    }
    if (!status && session.scene->sensors.given) {
        status = murk_sites_find(&f.candidates, session.stage, options->threads,
                                 err);
    }
    if (!status && f.candidates) {
        status = murk_poses_create(
            &f.poses, session.scene, &session.stage->world.domain,
            f.candidates->position, f.candidates->usable, err);
    }
    if (!status && options->json) {
        status = murk_session_finish(&session, NULL, check_json(&f), err);
    } else if (!status && murk_session_speaks(&session)) {
        print_findings(&f);
    }
    murk_poses_destroy(f.poses);
    murk_candidates_destroy(f.candidates);
    murk_session_end(&session);
    return status;
}
