/* Traces a few photons of each band and looks at the ledger. A band without
 * absorption or escape loses every photon at the limit of events or wraps; the
 * message then depends on whether any surface or medium absorbs in that
 * band. */
#include "lightmap/emission.h"

/* Photons traced for each band, in the mean over the bands, and the number of
 * lost photons from which a band is refused if no photon of the band ended
 * otherwise. At the largest loss that is accepted, one photon in 100, four lost
 * photons have a probability of 1e-8. */
#define PHOTONS_A_BAND 8
#define LOST_MIN       4

static bool is_whole(double share)
{
    return share >= 1;
}

/* True if any material that covers a surface, or the medium of any region,
 * absorbs light of the band. A medium with an albedo grid is assumed to
 * absorb. */
static bool absorbs(const murk_stage *stage, int band)
{
    const murk_scene_desc *scene = stage->scene;
    for (size_t i = 0; i < scene->n_materials; ++i) {
        const murk_scene_material *m = &scene->materials[i];
        if (murk_surfaces_material_area(stage->surfaces, i) > 0 &&
            !is_whole(m->diffuse.band[band] + m->specular.band[band] +
                      m->transmit.band[band])) {
            return true;
        }
    }
    for (size_t i = 0; i < scene->n_regions; ++i) {
        const murk_scene_medium *m =
            stage->phases->source[scene->regions[i].medium];
        if (m->albedo_grid || !is_whole(m->albedo.band[band])) {
            return true;
        }
    }
    return false;
}

/* The number of lost photons of a band; 0 if any photon of the band ended
 * otherwise. */
static double lost_alone(const murk_stage *stage, const murk_ledger *ledger,
                         int band)
{
    const size_t bands = (size_t)stage->scene->bands;
    int64_t emitted = 0, lost = 0;
    for (size_t c = (size_t)band; c < ledger->channels; c += bands) {
        emitted += murk_tally_read(&ledger->emitted[c]);
        lost += murk_tally_read(&ledger->lost[c]);
    }
    return emitted == lost ? (double)lost / (double)MURK_PACKET : 0;
}

murk_status murk_ending_check(const murk_stage *stage, uint32_t stream,
                              murk_error *err)
{
    const murk_scene_desc *scene = stage->scene;
    murk_ledger *ledger = NULL;
    murk_status status = murk_ledger_create(&ledger, &stage->world, err);
    if (status) {
        return status;
    }
    /* Trace the first photons. */
    murk_trace trace = murk_stage_trace(stage);
    trace.stream = stream;
    trace.last = PHOTONS_A_BAND * (uint64_t)scene->bands;
    murk_trace_run(&trace, ledger);
    /* Refuse the first band that lost LOST_MIN photons or more and of which no
     * photon ended otherwise. */
    for (int band = 0; band < scene->bands && !status; ++band) {
        const double lost = lost_alone(stage, ledger, band);
        if (lost >= LOST_MIN) {
            status = murk_fail(
                err, MURK_BAD_VALUE, scene->path,
                "light of %.6g nm does not end: all of %.0f photons went on "
                "for %u events or %u wraps, or were lost; %s",
                scene->band_nm[band], lost, trace.events_max, trace.wraps_max,
                absorbs(stage, band)
                    ? "give surfaces or media more absorption, or light a way "
                      "out"
                    : "no surface or medium absorbs and no way out was found: "
                      "give one of them absorption, or open the box");
        }
    }
    murk_ledger_destroy(ledger);
    return status;
}
