/* The cone around changed places: no sightline that meets one of them begins
 * outside of it or of the ball around it; and it is narrow enough to leave out
 * photons. Random boxes, sensors and photons. */
#include "base/rng.h"
#include "check.h"
#include "sensing/changed_lines.h"

#define SEED    7
#define CONES   300
#define PHOTONS 2000
#define RANGE_M 4.0
#define OFF_M   0.01 /* a sightline begins so far off its photon */

static murk_vec3 somewhere(uint64_t i, uint32_t slot, double size_m)
{
    const murk_random4 r = murk_random(SEED, MURK_SCATTER, i, 0, slot);
    return murk_vec(size_m * (r.u[0] - 0.5), size_m * (r.u[1] - 0.5),
                    size_m * (r.u[2] - 0.5));
}

/* One to three boxes of up to half a metre. */
static murk_box_list places_of(uint64_t i)
{
    murk_box_list list = {0};
    for (uint32_t k = 0; k <= i % 3; ++k) {
        const murk_vec3 a = somewhere(i, 2 * k, 4),
                        b = murk_add(a, somewhere(i, 2 * k + 1, 1));
        murk_box_list_add(&list,
                          murk_box_with(murk_box_with(murk_box_empty(), a), b));
    }
    return list;
}

/* A photon anywhere around the sensor, or every other one beside the line
 * through a place. */
static murk_vec3 photon_at(const murk_box_list *places, murk_vec3 sensor,
                           uint64_t number)
{
    const murk_random4 r = murk_random(SEED, MURK_SCATTER, number, 0, 2);
    const murk_vec3 to = murk_sub(places->box[0].min, sensor);
    return number % 2 == 0
               ? murk_add(sensor, somewhere(number, 0, 8))
               : murk_along(murk_add(sensor, somewhere(number, 0, 1)),
                            2 * r.u[0], to);
}

int main(void)
{
    size_t cones = 0, met = 0, outside = 0;
    for (uint64_t i = 0; i < CONES; ++i) {
        const murk_box_list places = places_of(i);
        const murk_vec3 sensor = somewhere(i, 10, 8);
        const murk_change_cone cone =
            murk_changes_cone(&places, sensor, RANGE_M, OFF_M);
        cones += cone.is_there;
        for (uint64_t k = 0; cone.is_there && k < PHOTONS; ++k) {
            const uint64_t number = CONES + i * PHOTONS + k;
            const murk_vec3 photon = photon_at(&places, sensor, number);
            const murk_vec3 from =
                murk_along(photon, OFF_M, murk_unit(somewhere(number, 1, 1)));
            const bool is_in_range =
                           murk_length(murk_sub(photon, sensor)) <= RANGE_M,
                       meets = murk_box_list_meet(&places, from,
                                                  murk_sub(sensor, from)),
                       is_in = murk_change_cone_has(&cone,
                                                    murk_sub(photon, sensor)) &&
                               murk_length(murk_sub(photon, cone.middle)) <=
                                   cone.radius_m;
            CHECK(!is_in_range || !meets || is_in);
            met += is_in_range && meets;
            outside += is_in_range && !is_in;
        }
    }
    /* It is not empty, and not all around. */
    printf("%zu of %d cones, %zu lines meet a place, %zu photons outside\n",
           cones, CONES, met, outside);
    CHECK(cones > CONES / 4 && met > 1000 && outside > met);
    /* No cone for a sensor in a changed place, or if any place may have
     * changed. */
    murk_box_list one = {.n = 1, .box = {{{0, 0, 0}, {1, 1, 1}}}};
    CHECK(!murk_changes_cone(&one, murk_vec(.5, .5, .4), 4, 0).is_there);
    CHECK(!murk_changes_cone(&one, murk_vec(.5, .5, .5), 4, 0).is_there);
    CHECK(murk_changes_cone(&one, murk_vec(5, .5, .4), 9, 0).is_there);
    one.are_all = true;
    CHECK(!murk_changes_cone(&one, murk_vec(5, .5, .4), 9, 0).is_there);
    return check_done();
}
