/* Compares the numbers of a light.murk with those that the scene determines.
 *
 * The scene and the number of emitted photons determine how many photons each
 * channel (light source and band) emits, the power of a photon packet of each
 * channel, and the channel of each photon (source/sources.h). Energy is
 * conserved exactly in quanta (base/tally.h), so absorbed, escaped and lost
 * quanta must add up to the emitted quanta. Other values are bounded: a record
 * lies in the domain, or beyond it by the margin within which surfaces count as
 * lying in a side of the domain (path/path.h), its directions exist, its power
 * is at most that of a packet. */
#include "lightmap/store_check.h"

#include <float.h>
#include <stdlib.h>

#include "path/path.h"

/* Relative. Machines may round the sums and quotients of a few doubles
 * differently. */
#define PACKET_TOLERANCE 1e-9
/* Relative. The power of a record is rounded to float. */
#define POWER_TOLERANCE (2.0 * FLT_EPSILON)
/* Positions of records are rounded to float, by half of this share of the
 * largest coordinate. */
#define PLACE_TOLERANCE (1.0 * FLT_EPSILON)

static murk_status impossible(const char *path, const char *section,
                              const char *what, murk_error *err)
{
    return murk_fail(err, MURK_BAD_FILE, path,
                     "section %s holds what no run can have written: %s",
                     section, what);
}

/* True if every part is at least 0 and the parts add up to `whole`. No sum can
 * overflow, because the remainder never grows. */
static bool adds_up(int64_t whole, const int64_t *part, size_t n)
{
    int64_t left = whole;
    for (size_t i = 0; i < n; ++i) {
        if (part[i] < 0 || part[i] > left) {
            return false;
        }
        left -= part[i];
    }
    return left == 0;
}

/* Checks the packet power and the energy balance of one channel. */
static murk_status check_channel(const int64_t *cell, size_t c, uint64_t count,
                                 double packet_w, const murk_stage *stage,
                                 const char *path, murk_error *err)
{
    const size_t channels = murk_sources_channels(stage->lights);
    const size_t materials = stage->scene->n_materials;
    const size_t media = stage->scene->n_media;
    const double due_w =
        count ? murk_sources_channel_power_w(stage->lights, c) / (double)count
              : 0;
    if (!(fabs(packet_w - due_w) <= PACKET_TOLERANCE * due_w)) {
        return impossible(path, "packet_w",
                          "a photon packet of another power than the scene's",
                          err);
    }
    /* 2^32 photons of 2^30 quanta fit in 63 bits */
    if (cell[c] != (int64_t)count * MURK_PACKET) {
        return impossible(path, "ledger",
                          "other emitted energy than of its photons", err);
    }
    const int64_t ends[] = {cell[channels + c], cell[2 * channels + c],
                            cell[3 * channels + c], cell[4 * channels + c]};
    if (!adds_up(cell[c], ends, sizeof ends / sizeof *ends)) {
        return impossible(path, "ledger", "energy that does not add up", err);
    }
    const int64_t *absorbed = cell + 5 * channels + c * (materials + media);
    if (!adds_up(ends[0], absorbed, materials) ||
        !adds_up(ends[1], absorbed + materials, media)) {
        return impossible(path, "absorbed",
                          "energy that does not add up to the ledger's", err);
    }
    return MURK_OK;
}

murk_status murk_lightmap_check_ledger(const int64_t *cell, uint64_t emitted,
                                       const double *packet_w,
                                       const murk_stage *stage,
                                       const char *path, murk_error *err)
{
    const size_t channels = murk_sources_channels(stage->lights);
    const size_t absorbers =
        channels * (stage->scene->n_materials + stage->scene->n_media);
    const int64_t *lost_photons = cell + 5 * channels + absorbers;
    const int64_t counted = lost_photons[MURK_LOSSES];
    const int64_t collisions = lost_photons[MURK_LOSSES + 1];
    int64_t lost = 0;
    /* The photons of light sources that are on are counted in the ledger, no
     * more photons are lost than were emitted, and the counts fit the types
     * that a run has for them. */
    bool is_possible = emitted <= UINT32_MAX && counted >= 0 &&
                       counted <= (int64_t)emitted && collisions >= 0;
    for (int i = 0; i < MURK_LOSSES && is_possible; ++i) {
        is_possible =
            lost_photons[i] >= 0 && lost_photons[i] <= (int64_t)emitted - lost;
        lost += lost_photons[i];
    }
    if (!is_possible) {
        return impossible(path, "facts", "counts that are out of range", err);
    }
    /* Find the number of photons of each channel, then check each channel. */
    uint64_t *count = calloc(channels + 1, sizeof *count);
    if (!count) {
        return murk_no_memory(err, path, "to check it");
    }
    murk_sources_deal(stage->lights, emitted, count);
    murk_status status = MURK_OK;
    uint64_t traced = 0;
    for (size_t c = 0; c < channels && !status; ++c) {
        traced += count[c];
        status =
            check_channel(cell, c, count[c], packet_w[c], stage, path, err);
    }
    free(count);
    return !status && traced != (uint64_t)counted
               ? impossible(path, "facts", "another number of photons", err)
               : status;
}

/* A description of the first impossible property of a record, or NULL. */
static const char *flaw_of(const murk_photon *p, bool is_volume,
                           uint64_t emitted, const double *packet_w,
                           const murk_stage *stage, const murk_box *within)
{
    const murk_scene_desc *scene = stage->scene;
    const size_t materials = is_volume ? scene->n_media : scene->n_materials;
    const size_t channel = (size_t)murk_photon_light(p) * (size_t)scene->bands +
                           (size_t)murk_photon_band(p);
    /* Indices must exist in the scene; then class and kind must exist. */
    if (murk_photon_band(p) >= scene->bands ||
        murk_photon_light(p) >= scene->n_lights ||
        murk_photon_material(p) >= materials ||
        murk_photon_emitted(p) >= emitted) {
        return "an index that is out of range";
    }
    if (murk_photon_class(p) > 2 || murk_photon_tag(p) > 7 ||
        (murk_photon_is_volume(p) != 0) != is_volume) {
        return "a kind that its map has not";
    }
    /* The number of a photon determines its channel, the channel limits its
     * power. */
    if (murk_sources_channel_of(stage->lights, murk_photon_emitted(p)) !=
        channel) {
        return "a photon of another light or band than its number's";
    }
    if (!(murk_photon_power_w(p) >= 0 &&
          murk_photon_power_w(p) <=
              packet_w[channel] * (1 + POWER_TOLERANCE))) {
        return "a power that is not 0 to its photon packet's";
    }
    /* Position and directions. */
    if (!murk_box_contains(within, murk_photon_place(p))) {
        return "a position outside the domain";
    }
    if (murk_photon_packed_direction(p) == 0 ||
        (murk_photon_packed_normal(p) == 0) != is_volume) {
        return "a direction or normal that is missing";
    }
    return NULL;
}

murk_status murk_lightmap_check_records(const murk_photon *photon, size_t n,
                                        bool is_volume, uint64_t emitted,
                                        const double *packet_w,
                                        const murk_stage *stage,
                                        const char *path, murk_error *err)
{
    /* The box in which the tracer finds surfaces, which is larger than the
     * domain by a margin, grown on all sides by the step that a ray takes off a
     * surface and by the rounding of positions. */
    murk_box within = stage->world.domain.box;
    const double slack = murk_path_margin_m(&stage->world.domain) +
                         murk_surfaces_leave_step_m(stage->surfaces) +
                         PLACE_TOLERANCE * murk_box_largest_coordinate(&within);
    const murk_vec3 wider = murk_vec(slack, slack, slack);
    within.min = murk_sub(within.min, wider);
    within.max = murk_add(within.max, wider);
    const bool is_dark = murk_sources_lit(stage->lights) == 0;
    for (size_t i = 0; i < n; ++i) {
        const char *flaw = is_dark ? "records of a scene without light"
                                   : flaw_of(&photon[i], is_volume, emitted,
                                             packet_w, stage, &within);
        if (flaw) {
            return impossible(path, is_volume ? "volume" : "surface", flaw,
                              err);
        }
    }
    return MURK_OK;
}
