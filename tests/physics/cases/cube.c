/* A pencil of light into the face of a cube of even fog, 60 mm wide: the
 * benchmark B1, without refraction and with that at all of the cube's faces.
 * Light starts just inside. Lengths in mm.
 *
 * Source: the cube of Fang and Boas, Opt. Express 17 (2009) 20178,
 * doi:10.1364/OE.17.020178, run by several codes that agree to 5e-5. */
#include "cases/groups.h"
#include "cases/reference.h"
#include "worlds.h"

#define SOURCE   "Fang and Boas 2009, several codes"
#define KNOWN_TO 5e-5
#define SIDE     60.0

enum { ABSORBED, BACK, THROUGH, QUANTITIES };

static void score(const void *context, const murk_event *before,
                  const murk_event *event, double *out)
{
    const size_t n = *(const size_t *)context;
    (void)before;
    double scored[QUANTITIES] = {0};
    if (event->kind == MURK_EVENT_MEDIUM) {
        scored[ABSORBED] = event->weight - event->leaving;
    } else if (event->kind == MURK_EVENT_ESCAPED) {
        scored[BACK] = event->position.z <= 0 ? event->weight : 0;
        scored[THROUGH] = event->position.z >= SIDE ? event->weight : 0;
    }
    for (size_t i = 0; i < n; ++i) {
        out[i] += scored[i];
    }
}

static void trace(validation *v, const char *name, const char *is_wrong,
                  double index, double absorption,
                  const validation_reference *reference, size_t n)
{
    if (!validation_wants(v, name)) {
        return;
    }
    const murk_source beam =
        test_beam(murk_vec(30.1, 30.2, 0), murk_vec(0, 0, 1));
    const murk_medium fog =
        test_medium(1 + absorption, 1 / (1 + absorption), .01);
    murk_region cube =
        test_box_region(0, murk_vec(0, 0, 0), murk_vec(SIDE, SIDE, SIDE));
    cube.ior = index;
    /* A face in a side of the domain would not refract. */
    const double air = index > 0 ? 1 : 0;
    test_world w = test_world_made(&(test_setup){
        .domain = {{{-air, -air, -air}, {SIDE + air, SIDE + air, SIDE + air}},
                   false},
        .lights = &beam,
        .n_lights = 1,
        .media = &fog,
        .n_media = 1,
        .regions = &cube,
        .n_regions = 1});
    validation_trace(v, &(validation_case){.name = name,
                                           .source = SOURCE,
                                           .is_wrong = is_wrong,
                                           .world = &w.world,
                                           .reference = reference,
                                           .quantities = n,
                                           .score = score,
                                           .context = &n});
    test_world_unmade(&w);
}

void cases_cube(validation *v)
{
    const validation_reference plain[QUANTITIES] = {
        {"absorbed", .17700, KNOWN_TO},
        {"reflected", .81498, KNOWN_TO},
        {"transmitted", .000125, 5e-7}};
    const validation_reference fresnel = {"absorbed", .27255, KNOWN_TO};
    /* One photon in 8000 gets through: only long runs wait for them. */
    trace(v, "without refraction", NULL, 0, .005, plain,
          validation_is_quick(v) ? 2 : QUANTITIES);
    trace(v, "index 1.37", NULL, 1.37, .005, &fresnel, 1);
    trace(v, "without refraction", "absorption .0051", 0, .0051, plain, 2);
    trace(v, "index 1.37", "index 1.34", 1.34, .005, &fresnel, 1);
}
