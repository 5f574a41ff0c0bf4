/* Detection by power: gathers the photons around every place once, in batches
 * over all threads, and stores radiances of surface places as numbers and
 * photons of volume places as lists, because the phase function depends on the
 * direction to the sensor. Formulas: sensing/power.h. */
#include "sensing/power.h"

#include "base/interrupt.h"
#include "base/pool.h"
#include "base/progress.h"
#include "sensing/neighbours.h"
#include "sensing/vicinity.h"

#include <assert.h>
#include <stdlib.h>

/* Places of a task, and of a list (a choice). */
#define BATCH_PHOTONS 1024

/* Share of the maximum radius: photons nearer than that count as one spot. */
#define MIN_RADIUS 1e-3

/* Photons around a batch of volume places: place i has list[begin[i]] ..
 * list[begin[i + 1] - 1]. */
typedef struct chunk {
    uint32_t begin[BATCH_PHOTONS + 1];
    uint32_t *list;
    float factor[BATCH_PHOTONS];
    uint8_t level[BATCH_PHOTONS];
} chunk;

struct murk_power {
    murk_power_desc desc;
    murk_vicinity *surface, *volume;
    float *radiance; /* [surface photons] */
    chunk **chunk;   /* [chunks], by batches of the volume map */
    size_t chunks;
    uint32_t *few; /* places with few photons, [batches of the surface map, then
                      of the volume map] */
    uint32_t **found; /* [threads] scratch during creation, like */
    murk_neighbours_workspace **workspace;
};

static size_t batches_of(const murk_photon_map *map)
{
    return (murk_photon_map_count(map) + BATCH_PHOTONS - 1) / BATCH_PHOTONS;
}

static size_t end_of(const murk_photon_map *map, size_t first)
{
    const size_t n = murk_photon_map_count(map);
    return n - first < BATCH_PHOTONS ? n : first + BATCH_PHOTONS;
}

/* ---- gathering ---- */

/* The fixed radius. With neighbours it is the radius of a single spot of light;
 * single precision resolves it in domains of up to some 1e5 times that radius.
 */
static double within_m(const murk_power_desc *desc)
{
    return desc->neighbours > 0 ? MIN_RADIUS * desc->radius_m : desc->radius_m;
}

/* The emitted photon to be left out at this place: that of the place, if the
 * place is a record of the light itself. */
static uint64_t path_of(const murk_power *power, const murk_photon *of)
{
    const murk_power_desc *desc = &power->desc;
    const bool is_own = murk_photon_is_volume(of)
                            ? desc->volume_map == desc->light.volume_map
                            : desc->surface_map == desc->light.surface_map;
    return is_own ? murk_photon_emitted(of) : MURK_VICINITY_ALL;
}

/* The photons of an estimate: found[0..n). */
typedef struct gathered {
    size_t n;
    int level; /* thinning level of the vicinity */
    double radius_m, factor;
} gathered;

/* Gathers the photons of an estimate: the nearest ones; or, for a fixed radius
 * and in a spot of light where the nearest ones lie next to each other, all
 * within the fixed radius. */
static gathered gather(const murk_power *power, const murk_vicinity *vicinity,
                       unsigned worker, const murk_photon *of)
{
    const murk_power_desc *desc = &power->desc;
    const bool is_volume = murk_photon_is_volume(of);
    const uint64_t path = path_of(power, of);
    uint32_t *found = power->found[worker];
    /* The nearest photons, unless their radius is that of a spot. */
    if (desc->neighbours > 0) {
        const murk_neighbours neighbours = {
            .map = is_volume ? desc->light.volume_map : desc->light.surface_map,
            .domain = desc->domain,
            .k = desc->neighbours,
            .max_m = desc->radius_m};
        const uint64_t emitted = desc->light.photons_emitted;
        const uint64_t others = emitted - (path < emitted);
        gathered g = {.factor =
                          others > 0 ? (double)emitted / (double)others : 0};
        g.n = murk_neighbours_find(&neighbours, power->workspace[worker], of,
                                   path, found, &g.radius_m);
        if (g.radius_m >= within_m(desc)) {
            return g;
        }
    }
    /* All photons within the fixed radius that are of the same band and side.
     */
    const murk_around a =
        murk_vicinity_find(vicinity, murk_photon_place(of), path, found);
    const murk_photon *photon = murk_vicinity_photons(vicinity, a.level);
    gathered g = {
        .level = a.level, .radius_m = within_m(desc), .factor = a.factor};
    for (size_t k = 0; k < a.n; ++k) {
        if (murk_neighbours_alike(of, &photon[found[k]])) {
            found[g.n++] = found[k];
        }
    }
    return g;
}

static void survey_surface(void *context, unsigned worker, uint64_t batch)
{
    murk_power *power = context;
    const murk_photon_map *map = power->desc.surface_map;
    const size_t first = (size_t)batch * BATCH_PHOTONS,
                 end = end_of(map, first);
    const uint32_t *found = power->found[worker];
    for (size_t i = first; i < end; ++i) {
        const gathered g = gather(power, power->surface, worker,
                                  &murk_photon_map_photons(map)[i]);
        const murk_photon *photon =
            murk_vicinity_photons(power->surface, g.level);
        double sum_w = 0;
        for (size_t k = 0; k < g.n; ++k) {
            sum_w += murk_photon_power_w(&photon[found[k]]);
        }
        power->radiance[i] =
            (float)(g.factor * sum_w /
                    (MURK_PI * MURK_PI * g.radius_m * g.radius_m));
        power->few[batch] += g.n < MURK_POWER_FEW;
    }
    murk_progress_add(end - first);
}

/* False when out of memory. */
static bool survey_place(murk_power *power, size_t i, unsigned worker, chunk *c)
{
    const gathered g =
        gather(power, power->volume, worker,
               &murk_photon_map_photons(power->desc.volume_map)[i]);
    const size_t at = i % BATCH_PHOTONS, begin = c->begin[at];
    if (begin + g.n > UINT32_MAX) {
        return false;
    }
    /* Append the photons of the place to the list of the batch. */
    uint32_t *more = realloc(c->list, (begin + g.n + 1) * sizeof *more);
    if (!more) {
        return false;
    }
    for (size_t k = 0; k < g.n; ++k) {
        more[begin + k] = power->found[worker][k];
    }
    const double r = g.radius_m;
    c->list = more;
    c->begin[at + 1] = (uint32_t)(begin + g.n);
    c->level[at] = (uint8_t)g.level;
    c->factor[at] = (float)(g.factor / (4 / 3. * MURK_PI * r * r * r));
    power->few[batches_of(power->desc.surface_map) + i / BATCH_PHOTONS] +=
        g.n < MURK_POWER_FEW;
    return true;
}

static void survey_volume(void *context, unsigned worker, uint64_t batch)
{
    murk_power *power = context;
    const size_t first = (size_t)batch * BATCH_PHOTONS;
    const size_t end = end_of(power->desc.volume_map, first);
    chunk *c = calloc(1, sizeof *c);
    for (size_t i = first; c && i < end; ++i) {
        if (!survey_place(power, i, worker, c)) {
            free(c->list);
            free(c);
            c = NULL;
        }
    }
    power->chunk[batch] = c;
    murk_progress_add(end - first);
}

/* ---- creation ---- */

murk_status murk_power_check_radius(double radius_m, const murk_domain *domain,
                                    const char *where, murk_error *err)
{
    const murk_vec3 size = murk_sub(domain->box.max, domain->box.min);
    const double maximum = domain->is_periodic ? fmin(size.x, size.y) / 2 : 1e9;
    if (!(radius_m > 0 && radius_m <= maximum)) {
        return murk_fail(err, MURK_BAD_VALUE, where,
                         "power_radius_m is %g m, must be more than 0 and at "
                         "most %g m%s",
                         radius_m, maximum,
                         domain->is_periodic ? ", half the domain's period"
                                             : "");
    }
    return MURK_OK;
}

static murk_status check(const murk_power_desc *desc, murk_error *err)
{
    const murk_status status =
        murk_power_check_radius(desc->radius_m, desc->domain, "placement", err);
    if (status) {
        return status;
    }
    const murk_photon_map *map = desc->light.volume_map;
    const murk_photon *photon = murk_photon_map_photons(map);
    for (size_t i = 0; i < murk_photon_map_count(map); ++i) {
        if (murk_photon_material(&photon[i]) >= murk_media_count(desc->media)) {
            return murk_fail(err, MURK_BAD_FILE, "volume map",
                             "record %zu: medium %d of %zu cannot be", i,
                             murk_photon_material(&photon[i]),
                             murk_media_count(desc->media));
        }
    }
    return MURK_OK;
}

static murk_status no_memory(const murk_power_desc *desc, murk_error *err)
{
    return murk_fail(err, MURK_NO_MEMORY, "",
                     "no memory for the light around %zu photons",
                     murk_photon_map_count(desc->surface_map) +
                         murk_photon_map_count(desc->volume_map));
}

static murk_status allocate(murk_power *power, murk_error *err)
{
    const murk_power_desc *desc = &power->desc;
    const murk_power_light *light = &desc->light;
    murk_status status =
        murk_vicinity_create(&power->surface, light->surface_map, desc->domain,
                             light->photons_emitted, within_m(desc),
                             MURK_POWER_SURFACE_MAX, desc->threads, err);
    if (!status) {
        status = murk_vicinity_create(&power->volume, light->volume_map,
                                      desc->domain, light->photons_emitted,
                                      within_m(desc), MURK_POWER_VOLUME_MAX,
                                      desc->threads, err);
    }
    if (status) {
        return status;
    }
    /* Results, and the workspace of each thread. */
    const size_t a = murk_vicinity_capacity(power->surface);
    const size_t b = murk_vicinity_capacity(power->volume);
    power->chunks = batches_of(desc->volume_map);
    power->chunk = calloc(power->chunks + 1, sizeof *power->chunk);
    power->radiance = malloc(
        murk_photon_map_count(desc->surface_map) * sizeof *power->radiance + 1);
    power->found = calloc(desc->threads, sizeof *power->found);
    power->workspace = calloc(desc->threads, sizeof *power->workspace);
    power->few = calloc(batches_of(desc->surface_map) + power->chunks + 1,
                        sizeof *power->few);
    bool has_memory = power->chunk && power->radiance && power->found &&
                      power->workspace && power->few;
    for (unsigned i = 0; has_memory && i < desc->threads; ++i) {
        power->found[i] = malloc(
            ((a > b ? a : b) + desc->neighbours) * sizeof *power->found[i] + 1);
        power->workspace[i] =
            murk_neighbours_workspace_create(desc->neighbours + 1);
        has_memory = power->found[i] && power->workspace[i];
    }
    return has_memory ? MURK_OK : no_memory(desc, err);
}

static void release_found(murk_power *power)
{
    for (unsigned i = 0; power->found && i < power->desc.threads; ++i) {
        free(power->found[i]);
    }
    for (unsigned i = 0; power->workspace && i < power->desc.threads; ++i) {
        murk_neighbours_workspace_destroy(power->workspace[i]);
    }
    free(power->found);
    free(power->workspace);
    power->found = NULL;
    power->workspace = NULL;
}

static murk_status survey(murk_power *power, murk_error *err)
{
    const murk_power_desc *desc = &power->desc;
    murk_progress_begin("power",
                        murk_photon_map_count(desc->surface_map) +
                            murk_photon_map_count(desc->volume_map),
                        "photons");
    murk_pool_run_workers(desc->threads, batches_of(desc->surface_map),
                          survey_surface, power);
    murk_pool_run_workers(desc->threads, power->chunks, survey_volume, power);
    murk_progress_end();
    release_found(power);
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    for (size_t i = 0; i < power->chunks; ++i) {
        if (!power->chunk[i]) {
            return no_memory(desc, err);
        }
    }
    return MURK_OK;
}

murk_status murk_power_create(murk_power **out, const murk_power_desc *desc,
                              murk_error *err)
{
    assert(out && desc && desc->threads >= 1);
    murk_power *power = NULL;
    murk_status status = check(desc, err);
    if (status) {
        goto done;
    }
    power = calloc(1, sizeof *power);
    if (!power) {
        status = no_memory(desc, err);
        goto done;
    }
    /* Allocate, then gather the photons around every place. */
    power->desc = *desc;
    status = allocate(power, err);
    if (!status) {
        status = survey(power, err);
    }
    if (status) {
        goto done;
    }
    *out = power;
    power = NULL;
done:
    murk_power_destroy(power);
    return status;
}

void murk_power_destroy(murk_power *power)
{
    if (!power) {
        return;
    }
    for (size_t i = 0; power->chunk && i < power->chunks; ++i) {
        if (power->chunk[i]) {
            free(power->chunk[i]->list);
            free(power->chunk[i]);
        }
    }
    release_found(power);
    free(power->chunk);
    free(power->radiance);
    free(power->few);
    murk_vicinity_destroy(power->surface);
    murk_vicinity_destroy(power->volume);
    free(power);
}

/* ---- queries ---- */

size_t murk_power_few(const murk_power *power)
{
    const size_t batches = batches_of(power->desc.surface_map) + power->chunks;
    size_t few = 0;
    for (size_t i = 0; i < batches; ++i) {
        few += power->few[i];
    }
    return few;
}

double murk_power_radiance(const murk_power *power, size_t i)
{
    return (double)power->radiance[i];
}

double murk_power_source(const murk_power *power, size_t i, murk_vec3 toward)
{
    const chunk *c = power->chunk[i / BATCH_PHOTONS];
    const size_t at = i % BATCH_PHOTONS;
    const murk_photon *photon =
        murk_vicinity_photons(power->volume, c->level[at]);
    double sum = 0;
    for (uint32_t k = c->begin[at]; k < c->begin[at + 1]; ++k) {
        const murk_photon *p = &photon[c->list[k]];
        const double mu = murk_dot(murk_photon_direction(p), toward);
        const murk_phase *phase = murk_media_phase(
            power->desc.media, murk_photon_material(p), murk_photon_band(p));
        sum += murk_photon_power_w(p) *
               murk_phase_density(phase, fmax(-1, fmin(1, mu)));
    }
    return sum * (double)c->factor[at];
}

double murk_power_signal_w(const murk_power *power,
                           const murk_sensor_type *type,
                           const murk_field *field, const murk_photon *photon,
                           size_t i, const murk_sightline *line)
{
    const double d2 = murk_dot(line->way, line->way);
    double taken = type->aperture_m2 / (d2 + type->aperture_m2 / MURK_PI);
    if (field->view != MURK_VIEW_SPHERE) {
        taken *= fmax(0, murk_dot(field->frame.axis, murk_unit(line->way)));
    }
    const double sent =
        murk_photon_is_volume(photon)
            ? murk_power_source(power, i, line->leaving) * type->target_m3
            : murk_power_radiance(power, i) * type->target_m2 *
                  fmax(0, murk_dot(murk_photon_normal(photon), line->leaving));
    return line->transmittance * line->gain * sent * taken;
}

double murk_power_chance(const murk_sensor_type *type, double signal_w,
                         double wavelength_nm)
{
    const double counts_per_j =
        type->quantum_efficiency * wavelength_nm * 1e-9 / MURK_PLANCK_LIGHT;
    return -expm1(-type->exposure_s * counts_per_j * signal_w);
}

murk_status murk_power_check_type(const murk_sensor_type *type, murk_error *err)
{
    const struct {
        const char *name;
        double value, max;
    } settings[] = {{"aperture_m2", type->aperture_m2, 1e9},
                    {"quantum_efficiency", type->quantum_efficiency, 1},
                    {"exposure_s", type->exposure_s, 1e9},
                    {"target_m2", type->target_m2, 1e9},
                    {"target_m3", type->target_m3, 1e9}};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; ++i) {
        if (!(settings[i].value > 0 && settings[i].value <= settings[i].max)) {
            return murk_fail(err, MURK_BAD_VALUE, "sensors.types",
                             "%s is %g, must be more than 0 and at most %g",
                             settings[i].name, settings[i].value,
                             settings[i].max);
        }
    }
    return MURK_OK;
}
