/* Detection by power: gathers the photons around every place once, on all
 * threads, and stores radiances of surface places as numbers and
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
#include <string.h>

/* Places that a thread takes at a time (a choice). */
#define BATCH_PHOTONS 1024

/* Share of the maximum radius: if the radius of the nearest photons is below
 * it, the photons are taken for one spot of light (gather()). */
#define MIN_RADIUS 1e-3

/* The photons around a place of the volume map. */
typedef struct place {
    uint32_t *list; /* [n] */
    uint32_t n;
    float factor;
    uint8_t level;
} place;

/* Scratch buffers of a thread during creation. */
typedef struct worker {
    uint32_t *found;
    murk_neighbours_workspace *workspace;
} worker;

struct murk_power {
    murk_sight_desc desc;
    murk_power_light light;
    murk_vicinity *surface, *volume;
    float *radiance; /* [surface photons] */
    place *place;    /* [volume photons] */
    murk_tally few;  /* places with few photons */
    worker *worker;  /* [threads] */
};

/* ---- gathering ---- */

/* The fixed radius. If the settings give a number of neighbours, it is a
 * thousandth of the maximum radius, and photons within it count as one spot of
 * light; single precision of the positions resolves that radius in domains of
 * up to some 1e5 times the fixed radius. */
static double within_m(const murk_power_settings *settings)
{
    return settings->neighbours > 0 ? MIN_RADIUS * settings->radius_m
                                    : settings->radius_m;
}

/* The emitted photon to be left out at this place: that of the place, if the
 * place is a record of the light itself; else MURK_VICINITY_ALL, and none is
 * left out. */
static uint64_t path_of(const murk_power *power, const murk_photon *of)
{
    const murk_sight_desc *desc = &power->desc;
    const bool is_own = murk_photon_is_volume(of)
                            ? desc->volume_map == power->light.volume_map
                            : desc->surface_map == power->light.surface_map;
    return is_own ? murk_photon_emitted(of) : MURK_VICINITY_ALL;
}

/* The photons of an estimate: found[0..n) of a thinning level. */
typedef struct gathered {
    const uint32_t *found;
    size_t n;
    int level; /* thinning level of the vicinity */
    double radius_m, factor;
} gathered;

/* Gathers the photons of an estimate. If the settings give a number of
 * neighbours, these are the nearest photons, unless all of them lie within the
 * radius of a spot of light. Otherwise these are all photons within the fixed
 * radius (within_m()). */
static gathered gather(const murk_power *power, const murk_vicinity *vicinity,
                       const worker *w, const murk_photon *of)
{
    const murk_power_settings *settings = &power->desc.power;
    const bool is_volume = murk_photon_is_volume(of);
    const uint64_t path = path_of(power, of);
    gathered g = {.found = w->found};
    /* The nearest photons, unless their radius is that of a spot. */
    if (settings->neighbours > 0) {
        const murk_neighbours neighbours = {
            .map =
                is_volume ? power->light.volume_map : power->light.surface_map,
            .domain = &power->desc.domain,
            .k = settings->neighbours,
            .max_m = settings->radius_m};
        const uint64_t emitted = power->light.photons_emitted;
        const uint64_t others = emitted - (path < emitted);
        g.factor = others > 0 ? (double)emitted / (double)others : 0;
        g.n = murk_neighbours_find(&neighbours, w->workspace, of, path,
                                   w->found, &g.radius_m);
        if (g.radius_m >= within_m(settings)) {
            return g;
        }
    }
    /* All photons within the fixed radius that are of the same band and side.
     */
    const murk_around a =
        murk_vicinity_find(vicinity, murk_photon_place(of), path, w->found);
    const murk_photon *photon = murk_vicinity_photons(vicinity, a.level);
    g = (gathered){.found = w->found,
                   .level = a.level,
                   .radius_m = within_m(settings),
                   .factor = a.factor};
    for (size_t k = 0; k < a.n; ++k) {
        if (murk_neighbours_alike(of, &photon[w->found[k]])) {
            w->found[g.n++] = w->found[k];
        }
    }
    return g;
}

static void survey_surface(void *context, unsigned number, uint64_t i)
{
    murk_power *power = context;
    const gathered g =
        gather(power, power->surface, &power->worker[number],
               murk_photon_map_photons(power->desc.surface_map) + i);
    const murk_photon *photon = murk_vicinity_photons(power->surface, g.level);
    double sum_w = 0;
    for (size_t k = 0; k < g.n; ++k) {
        sum_w += murk_photon_power_w(&photon[g.found[k]]);
    }
    power->radiance[i] = (float)(g.factor * sum_w /
                                 (MURK_PI * MURK_PI * g.radius_m * g.radius_m));
    murk_tally_add(&power->few, g.n < MURK_POWER_FEW);
    murk_progress_add(1);
}

/* A place without a list tells that memory ran out. */
static void survey_volume(void *context, unsigned number, uint64_t i)
{
    murk_power *power = context;
    const gathered g =
        gather(power, power->volume, &power->worker[number],
               murk_photon_map_photons(power->desc.volume_map) + i);
    const double r = g.radius_m;
    place *p = &power->place[i];
    *p = (place){.list = malloc(g.n * sizeof *p->list + 1),
                 .n = (uint32_t)g.n,
                 .factor = (float)(g.factor / (4 / 3. * MURK_PI * r * r * r)),
                 .level = (uint8_t)g.level};
    if (p->list) {
        memcpy(p->list, g.found, g.n * sizeof *p->list);
    }
    murk_tally_add(&power->few, g.n < MURK_POWER_FEW);
    murk_progress_add(1);
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

static murk_status check_type(const murk_sensor_type *type, murk_error *err)
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

static murk_status check(const murk_power *power, murk_error *err)
{
    const murk_sight_desc *desc = &power->desc;
    murk_status status = MURK_OK;
    for (size_t k = 0; k < desc->types && !status; ++k) {
        status = check_type(&desc->type[k], err);
    }
    if (!status) {
        status = murk_power_check_radius(desc->power.radius_m, &desc->domain,
                                         "placement", err);
    }
    /* Each photon of the light's volume map must lie in a medium. */
    const murk_photon_map *map = power->light.volume_map;
    const murk_photon *photon = murk_photon_map_photons(map);
    for (size_t i = 0; i < murk_photon_map_count(map) && !status; ++i) {
        if (murk_photon_material(&photon[i]) >= murk_media_count(desc->media)) {
            status = murk_fail(err, MURK_BAD_FILE, "volume map",
                               "record %zu: medium %d of %zu cannot be", i,
                               murk_photon_material(&photon[i]),
                               murk_media_count(desc->media));
        }
    }
    return status;
}

static murk_status no_memory(size_t photons, murk_error *err)
{
    return murk_no_memory(err, "", "for the light around %zu photons", photons);
}

static murk_status allocate(murk_power *power, size_t surface, size_t volume,
                            murk_error *err)
{
    const murk_sight_desc *desc = &power->desc;
    const murk_power_light *light = &power->light;
    const double radius_m = within_m(&desc->power);
    murk_status status =
        murk_vicinity_create(&power->surface, light->surface_map, &desc->domain,
                             light->photons_emitted, radius_m,
                             MURK_POWER_SURFACE_MAX, desc->threads, err);
    if (!status) {
        status = murk_vicinity_create(&power->volume, light->volume_map,
                                      &desc->domain, light->photons_emitted,
                                      radius_m, MURK_POWER_VOLUME_MAX,
                                      desc->threads, err);
    }
    if (status) {
        return status;
    }
    /* Results, and the scratch buffers of each thread. */
    const size_t a = murk_vicinity_capacity(power->surface);
    const size_t b = murk_vicinity_capacity(power->volume);
    const size_t k = desc->power.neighbours;
    power->place = calloc(volume + 1, sizeof *power->place);
    power->radiance = malloc(surface * sizeof *power->radiance + 1);
    power->worker = calloc(desc->threads, sizeof *power->worker);
    bool has_memory = power->place && power->radiance && power->worker;
    for (unsigned i = 0; has_memory && i < desc->threads; ++i) {
        worker *w = &power->worker[i];
        w->found = malloc(((a > b ? a : b) + k) * sizeof *w->found + 1);
        w->workspace = murk_neighbours_workspace_create(k + 1);
        has_memory = w->found && w->workspace;
    }
    return has_memory ? MURK_OK : no_memory(surface + volume, err);
}

static murk_status survey(murk_power *power, size_t surface, size_t volume,
                          murk_error *err)
{
    const unsigned threads = power->desc.threads;
    murk_progress_begin("power", surface + volume, "photons");
    murk_pool_run_items_of_workers(threads, surface, BATCH_PHOTONS,
                                   survey_surface, power);
    murk_pool_run_items_of_workers(threads, volume, BATCH_PHOTONS,
                                   survey_volume, power);
    murk_progress_end();
    if (murk_interrupted()) {
        return murk_fail(err, MURK_INTERRUPTED, "", "interrupted");
    }
    for (size_t i = 0; i < volume; ++i) {
        if (!power->place[i].list) {
            return no_memory(surface + volume, err);
        }
    }
    return MURK_OK;
}

static void release_workers(murk_power *power)
{
    for (unsigned i = 0; power->worker && i < power->desc.threads; ++i) {
        free(power->worker[i].found);
        murk_neighbours_workspace_destroy(power->worker[i].workspace);
    }
    free(power->worker);
    power->worker = NULL;
}

murk_status murk_power_create(murk_power **out, const murk_sight_desc *desc,
                              murk_error *err)
{
    assert(out && desc && desc->threads >= 1);
    const size_t surface = murk_photon_map_count(desc->surface_map);
    const size_t volume = murk_photon_map_count(desc->volume_map);
    murk_power *power = calloc(1, sizeof *power);
    if (!power) {
        return no_memory(surface + volume, err);
    }
    power->desc = *desc;
    power->light = desc->power.light;
    if (!power->light.surface_map) {
        power->light = (murk_power_light){desc->surface_map, desc->volume_map,
                                          desc->photons_emitted};
    }
    /* Allocate, then gather the photons around every place. */
    murk_status status = check(power, err);
    if (!status) {
        status = allocate(power, surface, volume, err);
    }
    if (!status) {
        status = survey(power, surface, volume, err);
    }
    release_workers(power);
    if (status) {
        murk_power_destroy(power);
        return status;
    }
    *out = power;
    return MURK_OK;
}

void murk_power_destroy(murk_power *power)
{
    if (!power) {
        return;
    }
    const size_t volume = murk_photon_map_count(power->desc.volume_map);
    for (size_t i = 0; power->place && i < volume; ++i) {
        free(power->place[i].list);
    }
    free(power->place);
    free(power->radiance);
    murk_vicinity_destroy(power->surface);
    murk_vicinity_destroy(power->volume);
    free(power);
}

/* ---- queries ---- */

size_t murk_power_few(const murk_power *power)
{
    return (size_t)murk_tally_read(&power->few);
}

double murk_power_radiance(const murk_power *power, size_t i)
{
    return (double)power->radiance[i];
}

double murk_power_source(const murk_power *power, size_t i, murk_vec3 toward)
{
    const place *at = &power->place[i];
    const murk_photon *photon = murk_vicinity_photons(power->volume, at->level);
    double sum = 0;
    for (uint32_t k = 0; k < at->n; ++k) {
        const murk_photon *p = &photon[at->list[k]];
        const double mu = murk_dot(murk_photon_direction(p), toward);
        const murk_phase *phase = murk_media_phase(
            power->desc.media, murk_photon_material(p), murk_photon_band(p));
        sum += murk_photon_power_w(p) *
               murk_phase_density(phase, fmax(-1, fmin(1, mu)));
    }
    return sum * (double)at->factor;
}

bool murk_power_has_same_source(const murk_power *a, size_t i,
                                const murk_power *b, size_t k)
{
    const place *p = &a->place[i], *q = &b->place[k];
    const murk_photon *photon_a = murk_vicinity_photons(a->volume, p->level),
                      *photon_b = murk_vicinity_photons(b->volume, q->level);
    bool is_same = p->n == q->n && p->factor == q->factor;
    for (uint32_t j = 0; j < p->n && is_same; ++j) {
        is_same = memcmp(&photon_a[p->list[j]], &photon_b[q->list[j]],
                         sizeof *photon_a) == 0;
    }
    return is_same;
}

double murk_power_signal_w(const murk_power *power,
                           const murk_sensor_type *type,
                           const murk_field *field, const murk_photon *photon,
                           size_t i, const murk_sightline *line)
{
    const double d2 = murk_dot(line->apparent, line->apparent);
    double taken = type->aperture_m2 / (d2 + type->aperture_m2 / MURK_PI);
    if (field->view != MURK_VIEW_SPHERE) {
        taken *=
            fmax(0, murk_dot(field->frame.axis, murk_unit(line->apparent)));
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
