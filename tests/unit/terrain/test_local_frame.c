/* The local frame against PROJ, and there and back.
 *
 * The reference is PROJ 9.1.1 through GDAL 3.6.2 (OCTTransform), from
 * "+proj=longlat +datum=WGS84" to "+proj=tmerc +k=1 +datum=WGS84" about each
 * origin, printed to 1e-10 m. Limits: 6e-9 m, by rounding of positions of 1e6 m
 * and of degrees. Each term up to n^5 makes more than that, and fails if it is
 * left out; those of n^6 make 1e-10 m and are below the rounding. */
#include "check.h"
#include "terrain/local_frame.h"

#define LIMIT_M 6e-9

typedef struct reference {
    double latitude, longitude; /* of the origin */
    double at_latitude, at_longitude, east_m, north_m;
} reference;

static const reference references[] = {
    {0.0, 0.0, 0.0, 0.0, 0.0000000000, 0.0000000000},
    {0.0, 0.0, 0.001, 0.001, 111.3194907821, 110.5742758387},
    {0.0, 0.0, -0.05, 0.1, 11131.9505586968, -5528.7222826432},
    {0.0, 0.0, 0.7, -0.5, -55656.3302608383, 77404.9986587203},
    {0.0, 0.0, -2.0, 3.0, 333909.6562392568, -221454.7479295140},
    {0.0, 0.0, 6.0, -5.0, -554261.7727416093, 666002.7609895839},
    {0.0, 0.0, 8.0, 8.0, 884732.2773356661, 893290.1482477650},
    {41.687, -93.89, 41.687, -93.89, 0.0000000000, 0.0000000000},
    {41.687, -93.89, 41.687999999999995, -93.889, 83.2542427327,
     111.0677025062},
    {41.687, -93.89, 41.637, -93.79, 8331.9965777646, -5548.5052953450},
    {41.687, -93.89, 42.387, -94.39, -41173.4783943134, 77872.9146542130},
    {41.687, -93.89, 39.687, -90.89, 257369.3322007117, -217790.8108869311},
    {41.687, -93.89, 47.687, -98.89, -375333.6086186888, 678879.2788349048},
    {41.687, -93.89, 49.687, -85.89, 576971.9864943310, 919968.2922843137},
    {52.1, 5.2, 52.1, 5.2, 0.0000000000, 0.0000000000},
    {52.1, 5.2, 52.101, 5.2010000000000005, 68.5233478457, 111.2697338709},
    {52.1, 5.2, 52.050000000000004, 5.3, 6860.1466105249, -5558.7181646445},
    {52.1, 5.2, 52.800000000000004, 4.7, -33723.4115131448, 78010.3259693092},
    {52.1, 5.2, 50.1, 8.2, 214623.4921206255, -218187.9616092799},
    {52.1, 5.2, 58.1, 0.20000000000000018, -294674.1773762577,
     678876.7024001231},
    {52.1, 5.2, 60.1, 13.2, 444321.7905237386, 917700.1278564287},
    {-33.9, 151.2, -33.9, 151.2, 0.0000000000, 0.0000000000},
    {-33.9, 151.2, -33.899, 151.201, 92.4939824103, 110.9201218593},
    {-33.9, 151.2, -33.949999999999996, 151.29999999999998, 9243.8897447781,
     -5550.5566745333},
    {-33.9, 151.2, -33.199999999999996, 150.7, -46621.1384656268,
     77528.6143201180},
    {-33.9, 151.2, -35.9, 154.2, 270871.1214115736, -226037.9812231039},
    {-33.9, 151.2, -27.9, 146.2, -492616.3683047069, 655134.9485935381},
    {-33.9, 151.2, -25.9, 159.2, 803242.1755467801, 862212.9618479443},
    {78.2, 15.6, 78.2, 15.6, 0.0000000000, 0.0000000000},
    {78.2, 15.6, 78.20100000000001, 15.600999999999999, 22.8358523739,
     111.6469760321},
    {78.2, 15.6, 78.15, 15.7, 2293.3111506634, -5580.3703409227},
    {78.2, 15.6, 78.9, 15.1, -10750.3033332586, 78200.6693466907},
    {78.2, 15.6, 76.2, 18.6, 79880.5743365420, -221245.5341239827},
    {78.2, 15.6, 84.2, 10.6, -56364.8132643816, 672447.8288215534},
    {78.2, 15.6, 86.2, 23.6, 59027.7352145243, 897489.9813929272},
    {-54.8, 179.9, -54.8, 179.9, 0.0000000000, 0.0000000000},
    {-54.8, 179.9, -54.799, 179.901, 64.3136382778, 111.3193744864},
    {-54.8, 179.9, -54.849999999999994, 180.0, 6423.2633487718,
     -5570.5983959088},
    {-54.8, 179.9, -54.099999999999994, 179.4, -32709.1257042360,
     77803.7431059754},
    {-54.8, 179.9, -56.8, 182.9, 183259.9399130242, -226692.3382210411},
    {-54.8, 179.9, -48.8, 174.9, -367259.9524705820, 655508.2756398517},
    {-54.8, 179.9, -46.8, 187.9, 610586.9602323363, 858780.3690354001},
};

static void test_proj(void)
{
    for (size_t i = 0; i < sizeof references / sizeof *references; ++i) {
        const reference *r = &references[i];
        const murk_local_frame frame =
            murk_local_frame_at(r->latitude, r->longitude, 0, 1);
        double at[2], latitude, longitude;
        CHECK(murk_local_from_geographic(&frame, r->at_latitude,
                                         r->at_longitude, at));
        CHECK_NEAR(at[0], r->east_m, LIMIT_M);
        CHECK_NEAR(at[1], r->north_m, LIMIT_M);
        /* There and back: 1e-13 degrees are 1e-8 m. */
        murk_geographic_from_local(&frame, at, &latitude, &longitude);
        CHECK_NEAR(latitude, r->at_latitude, 1e-13);
        CHECK_NEAR(remainder(longitude - r->at_longitude, 360), 0, 1e-12);
        CHECK(fabs(longitude) <= 180);
    }
}

/* North along the direction (3, 4) / 5 of the frame. */
static void test_turned(void)
{
    const murk_local_frame plain = murk_local_frame_at(41.7, -93.9, 0, 1),
                           turned = murk_local_frame_at(41.7, -93.9, 3, 4);
    double at[2], by[2], latitude, longitude;
    CHECK(murk_local_from_geographic(&plain, 41.71, -93.88, at));
    CHECK(murk_local_from_geographic(&turned, 41.71, -93.88, by));
    CHECK_NEAR(by[0], 0.8 * at[0] + 0.6 * at[1], LIMIT_M);
    CHECK_NEAR(by[1], 0.8 * at[1] - 0.6 * at[0], LIMIT_M);
    murk_geographic_from_local(&turned, by, &latitude, &longitude);
    CHECK_NEAR(latitude, 41.71, 1e-12);
    CHECK_NEAR(longitude, -93.88, 1e-12);
}

/* Poles have a place; places too far away have none. */
static void test_far(void)
{
    const murk_local_frame pole = murk_local_frame_at(90, 0, 0, 1),
                           frame = murk_local_frame_at(50, 170, 0, 1);
    double at[2], latitude, longitude;
    CHECK(murk_local_from_geographic(&pole, 90, 0, at));
    CHECK_NEAR(at[0], 0, LIMIT_M);
    CHECK_NEAR(at[1], 0, LIMIT_M);
    CHECK(murk_local_from_geographic(&frame, 50, -175, at));
    murk_geographic_from_local(&frame, at, &latitude, &longitude);
    CHECK_NEAR(longitude, -175, 1e-12);
    CHECK(!murk_local_from_geographic(&frame, 50, -150, at)); /* 2800 km */
    CHECK(!murk_local_from_geographic(&frame, 20, 170, at));  /* 3300 km */
    CHECK(!murk_local_from_geographic(&frame, -50, -10, at));
    CHECK(!murk_local_from_geographic(&frame, 91, 170, at));
    CHECK(!murk_local_from_geographic(&frame, (double)NAN, 170, at));
    CHECK(!murk_local_from_geographic(&frame, 50, (double)INFINITY, at));
}

int main(void)
{
    test_proj();
    test_turned();
    test_far();
    return check_done();
}
