/* Which receivers a segment crosses, and where: a tree against trying all.
 * Segments are drawn, but what is found must be the same to the bit. */
#include "base/rng.h"
#include "calibrate/receiver_tree.h"
#include "check.h"

#include <stdlib.h>

#define RECEIVERS 300
#define SEGMENTS  4000

static murk_random4 draw(uint64_t i, uint32_t slot)
{
    return murk_random(1, MURK_EMIT, i, 0, slot);
}

/* Small and large, some one in the other, two in one place. */
static void make(murk_receiver receiver[RECEIVERS])
{
    for (size_t i = 0; i < RECEIVERS; ++i) {
        const murk_random4 r = draw(i, 0);
        receiver[i] = (murk_receiver){
            .center = murk_vec(100 + 20 * r.u[0], -10 * r.u[1], 5 * r.u[2]),
            .radius_m = 0.02 + 0.5 * r.u[3] * r.u[3],
            .band = -1};
    }
    receiver[17] = receiver[250];
}

/* True if a segment crosses one sphere, by direct computation. */
static bool crosses(const murk_receiver *r, murk_vec3 from, murk_vec3 d,
                    double length_m, double *from_m, double *to_m)
{
    const murk_vec3 o = murk_sub(from, r->center);
    const double b = murk_dot(o, d);
    const double c = murk_dot(o, o) - r->radius_m * r->radius_m;
    const double root = sqrt(fmax(0, b * b - c));
    *from_m = fmax(0, -b - root);
    *to_m = fmin(length_m, -b + root);
    return b * b > c && *to_m > *from_m;
}

static void check_segment(const murk_receiver_tree *chords,
                          const murk_receiver *receiver, murk_vec3 from,
                          murk_vec3 d, double length_m, size_t *crossed,
                          size_t *wrong)
{
    murk_chord chord[RECEIVERS];
    bool seen[RECEIVERS] = {false};
    const size_t n =
        murk_receiver_tree_chords(chords, from, d, length_m, chord);
    for (size_t i = 0; i < n; ++i) {
        const murk_chord *c = &chord[i];
        double from_m, to_m;
        crosses(&receiver[c->receiver], from, d, length_m, &from_m, &to_m);
        *wrong += seen[c->receiver] || fabs(c->from_m - from_m) > 1e-9 ||
                  fabs(c->to_m - to_m) > 1e-9;
        seen[c->receiver] = true;
    }
    for (size_t i = 0; i < RECEIVERS; ++i) {
        double from_m, to_m;
        const bool is_crossed =
            crosses(&receiver[i], from, d, length_m, &from_m, &to_m);
        *wrong += is_crossed && !seen[i] && to_m - from_m > 1e-6;
    }
    *crossed += n;
}

static void test_all_are_found(const murk_receiver_tree *chords,
                               const murk_receiver *receiver)
{
    size_t crossed = 0, wrong = 0;
    for (uint64_t i = 0; i < SEGMENTS; ++i) {
        const murk_random4 a = draw(i, 1), b = draw(i, 2);
        const double z = 2 * b.u[0] - 1, s = sqrt(1 - z * z);
        const double turn = 2 * MURK_PI * b.u[1];
        murk_vec3 d = murk_vec(s * cos(turn), s * sin(turn), z);
        if (i % 4 == 0) { /* along an axis */
            d = murk_vec(i % 12 == 0, i % 12 == 4, i % 12 == 8);
        }
        const murk_vec3 from =
            murk_vec(100 + 20 * a.u[0], -10 * a.u[1], 5 * a.u[2]);
        check_segment(chords, receiver, from, d, 10 * a.u[3] * a.u[3], &crossed,
                      &wrong);
    }
    CHECK(crossed > 500);
    CHECK(wrong == 0);
}

static void test_none_and_one(const murk_receiver *receiver)
{
    murk_receiver_tree *chords = NULL;
    murk_error err = {0};
    murk_chord chord[1];
    const murk_vec3 along = {1, 0, 0};
    CHECK(!murk_receiver_tree_create(&chords, receiver, 0, &err));
    CHECK(murk_receiver_tree_chords(chords, receiver->center, along, 9,
                                    chord) == 0);
    murk_receiver_tree_destroy(chords);
    CHECK(!murk_receiver_tree_create(&chords, receiver, 1, &err));
    CHECK(murk_receiver_tree_chords(chords, receiver->center, along, 9,
                                    chord) == 1);
    CHECK(chord->receiver == 0 && chord->from_m == 0);
    CHECK_NEAR(chord->to_m, receiver->radius_m, 1e-12);
    murk_receiver_tree_destroy(chords);
}

int main(void)
{
    static murk_receiver receiver[RECEIVERS];
    murk_receiver_tree *chords = NULL;
    murk_error err = {0};
    make(receiver);
    CHECK(!murk_receiver_tree_create(&chords, receiver, RECEIVERS, &err));
    if (chords) {
        test_all_are_found(chords, receiver);
    }
    murk_receiver_tree_destroy(chords);
    test_none_and_one(receiver);
    return check_done();
}
