/* Grids that tools/make_media makes: what they must hold whatever the seed, and
 * that the same words make the same grid.
 *
 * The moments of the noise are z-tests over places too far apart to know of one
 * another; they share a 1e-6 chance of a false alarm (Sidak). */
#include "base/stats.h"
#include "check.h"
#include "kinds.h"

#include <stdlib.h>

static media_frame frame_of(const media_kind *kind)
{
    media_frame f = {.voxel_m = kind->voxel_m, .seed = 1};
    for (int i = 0; i < 3; ++i) {
        f.size[i] = kind->size[i];
    }
    for (int i = 0; i < KIND_WORDS_MAX; ++i) {
        f.word[i] = kind->words[i].usual;
    }
    return f;
}

static double *word_of(const media_kind *kind, media_frame *f, const char *name)
{
    for (int i = 0; i < KIND_WORDS_MAX; ++i) {
        if (strcmp(kind->words[i].name, name) == 0) {
            return &f->word[i];
        }
    }
    printf("no word %s\n", name);
    exit(1);
}

static size_t voxels(const media_frame *f)
{
    return f->size[0] * f->size[1] * f->size[2];
}

static float *filled(const media_kind *kind, const media_frame *f)
{
    float *value = malloc(voxels(f) * sizeof *value);
    kind_fill(kind, f, value);
    return value;
}

static void test_all_kinds_are_finite_and_repeat(void)
{
    for (size_t k = 0; k < kinds_count; ++k) {
        media_frame f = frame_of(kinds[k]);
        f.size[0] = f.size[1] = f.size[2] = 12;
        f.voxel_m *= 4;
        float *one = filled(kinds[k], &f), *two = filled(kinds[k], &f);
        CHECK(memcmp(one, two, voxels(&f) * sizeof *one) == 0);
        int wrong = 0, some = 0;
        for (size_t i = 0; i < voxels(&f); ++i) {
            wrong += !(one[i] >= 0 && isfinite(one[i]));
            some += one[i] > 0;
        }
        CHECK(wrong == 0 && some > 0);
        f.seed = 2;
        kind_fill(kinds[k], &f, two);
        const bool has_luck = kinds[k] != &kind_chlorophyll;
        CHECK((memcmp(one, two, voxels(&f) * sizeof *one) != 0) == has_luck);
        free(one);
        free(two);
    }
}

/* Sums of the noise and of its squares, at places two units and more apart. */
static void test_noise_is_normal_everywhere(uint32_t seed)
{
    const int n = 20;
    const double limit = murk_sidak_limit(1e-6, 6);
    for (int octaves = 1; octaves <= 4; octaves += 3) {
        double sum = 0, squares = 0, patches = 0;
        for (int i = 0; i < n * n * n; ++i) {
            const murk_vec3 p =
                murk_vec(3 * (i % n) + .01 * (i % 97),
                         3 * (i / n % n) + .5 - 40, 3 * (i / n / n) + .25);
            const double x = noise_normal(seed, 5, octaves, p);
            sum += x;
            squares += x * x;
            patches += noise_patches(.5, x);
        }
        const double count = n * n * n;
        CHECK_WITHIN(limit, sum / count, 0, 1 / sqrt(count));
        CHECK_WITHIN(limit, squares / count, 1, sqrt(2 / count));
        CHECK_WITHIN(limit, patches / count, 1, sqrt(expm1(.25) / count));
        /* teeth: weights that are not divided by their root leave less */
        CHECK(sigmas_off(squares / count, .8, sqrt(2 / count)) > limit);
    }
}

/* A fog without patches: 1 at the ground, water rising as said, nothing above
 * the top. */
static void test_fog_is_stratified(void)
{
    media_frame f = frame_of(&kind_fog_bank);
    *word_of(&kind_fog_bank, &f, "patch") = 0;
    *word_of(&kind_fog_bank, &f, "swell_m") = 0;
    const double top = *word_of(&kind_fog_bank, &f, "top_m");
    const double edge = *word_of(&kind_fog_bank, &f, "edge_m");
    CHECK_NEAR(kind_fog_bank.value(&f, murk_vec(3, 4, 0)), 1, 1e-12);
    CHECK(kind_fog_bank.value(&f, murk_vec(3, 4, top)) == 0);
    const double z = top - edge;
    CHECK_NEAR(kind_fog_bank.value(&f, murk_vec(9, 4, z)),
               pow(1 + 2 * z / top, 2. / 3), 1e-12);
    CHECK(kind_fog_bank.value(&f, murk_vec(9, 4, z + edge / 2)) <
          kind_fog_bank.value(&f, murk_vec(9, 4, z)));
}

/* Wind takes the pattern along: after a time it is the same some voxels on. */
static void test_frames_move(void)
{
    const media_kind *const moving[] = {&kind_fog_bank, &kind_rain_shafts};
    for (int i = 0; i < 2; ++i) {
        media_frame f = frame_of(moving[i]), later = f;
        later.time_s = 10;
        const double drift = 10 * *word_of(moving[i], &f, "wind_m_per_s");
        double worst = 0, differ = 0;
        for (int k = 0; k < 100; ++k) {
            const murk_vec3 p = murk_vec(.5 * k, 40 - .3 * k, .2 * k + 1);
            const double now = moving[i]->value(&f, p);
            worst =
                fmax(worst,
                     fabs(now - moving[i]->value(
                                    &later, murk_vec(p.x + drift, p.y, p.z))));
            differ = fmax(differ, fabs(now - moving[i]->value(&later, p)));
        }
        CHECK(worst < 1e-9);
        CHECK(differ > .01);
    }
}

/* Drops fall along the shaft's axis, which comes back across the sides. */
static void test_shafts_slant_and_wrap(void)
{
    const media_frame f = frame_of(&kind_rain_shafts);
    const double across = (double)f.size[0] * f.voxel_m;
    const double down_m = 100, drift = 4 * down_m / 6.5;
    for (int k = 0; k < 50; ++k) {
        const murk_vec3 p = murk_vec(8 * k, 5 * k, 200);
        const double here = kind_rain_shafts.value(&f, p);
        CHECK_NEAR(kind_rain_shafts.value(
                       &f, murk_vec(p.x + drift, p.y, p.z - down_m)),
                   here, 1e-9);
        CHECK_NEAR(kind_rain_shafts.value(
                       &f, murk_vec(p.x + across, p.y - across, p.z)),
                   here, 1e-9);
    }
    CHECK(kind_rain_shafts.value(&f, murk_vec(0, 0, 290)) == 0);
}

/* Flux through a section across the current. */
static double flux(const media_frame *f, size_t column)
{
    const murk_vec3 first = kind_first_middle(&kind_plume, f);
    double sum = 0;
    for (size_t j = 0; j < f->size[1]; ++j) {
        for (size_t k = 0; k < f->size[2]; ++k) {
            const murk_vec3 steps =
                murk_vec((double)column, (double)j, (double)k);
            sum += kind_plume.value(f, murk_along(first, f->voxel_m, steps));
        }
    }
    return sum * f->voxel_m * f->voxel_m * f->word[1];
}

static void test_a_plume_carries_what_its_source_gives(void)
{
    media_frame f = frame_of(&kind_plume);
    *word_of(&kind_plume, &f, "patch") = 0;
    f.size[1] = 200;         /* nothing beyond the sides */
    CHECK(flux(&f, 7) == 0); /* upstream */
    for (size_t column = 9; column < 160; column += 50) {
        CHECK_NEAR(flux(&f, column), 100, 1e-6);
    }
    /* sunk to the bed, and mixed all over */
    *word_of(&kind_plume, &f, "sinking_m_per_s") = .1;
    CHECK_NEAR(flux(&f, 100), 100, 1e-6);
    *word_of(&kind_plume, &f, "mixing_up_m2_per_s") = 3;
    CHECK_NEAR(flux(&f, 100), 100, 1e-6);
    *word_of(&kind_plume, &f, "rate_g_per_s") = 101; /* teeth */
    CHECK(fabs(flux(&f, 100) - 100) > .9);
}

static void test_a_column_of_chlorophyll(void)
{
    media_frame f = frame_of(&kind_chlorophyll);
    const double deep = (double)f.size[2] * f.voxel_m;
    const murk_vec3 first = kind_first_middle(&kind_chlorophyll, &f);
    CHECK_NEAR(first.z, f.voxel_m / 2 - deep, 1e-12);
    double sum = 0, max = 0, at = 0;
    for (size_t k = 0; k < f.size[2]; ++k) {
        const murk_vec3 p =
            murk_along(first, f.voxel_m, murk_vec(0, 0, (double)k));
        const double value = kind_chlorophyll.value(&f, p);
        sum += value * f.voxel_m;
        at = value > max ? p.z : at;
        max = fmax(max, value);
    }
    CHECK_NEAR(sum, .1 * deep + 20, 1e-4); /* 4.7 widths to the surface */
    CHECK_NEAR(at, -70, f.voxel_m);
    CHECK_NEAR(max, .1 + 20 / (15 * sqrt(2 * MURK_PI)), 2e-3);
}

int main(int argc, char **argv)
{
    test_all_kinds_are_finite_and_repeat();
    test_noise_is_normal_everywhere(
        argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 1);
    test_fog_is_stratified();
    test_frames_move();
    test_shafts_slant_and_wrap();
    test_a_plume_carries_what_its_source_gives();
    test_a_column_of_chlorophyll();
    return check_done();
}
