/* Every refusal of sensors, placement and what else a scene asks for: its place
 * and its words, to the letter. Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "refusals.h"

static const refusal REFUSALS[] = {
    /* sensors */
    {"sensors: {count: 3}\n", VALUE, "fog.yaml:2:1: sensors",
     "misses types, must be a list of at least one sensor type"},
    {"sensors: {types: []}\n", VALUE, "fog.yaml:2:11: sensors.types",
     "an empty list, must have at least one sensor type"},
    {"sensors: {types: [{name: a, range_m: 1}, {name: a, range_m: 2}]}\n",
     VALUE, "fog.yaml:2:42: sensors.types.1",
     "name: a is the name of an earlier type, must be one's own"},
    {"sensors: {types: [{name: a, range_m: 1, least_range_m: 2}]}\n", VALUE,
     "fog.yaml:2:19: sensors.types.0",
     "least_range_m is 2 and range_m 1 m, the least must be less"},
    {"sensors: {types: [{name: a, range_m: 1, least_count: 3, max_count: "
     "2}]}\n",
     VALUE, "fog.yaml:2:19: sensors.types.0",
     "least_count is 3 and max_count 2, the least must be at most the other"},
    {"sensors: {types: [{name: a, range_m: 1, cost: -1}]}\n", VALUE,
     "fog.yaml:2:47: sensors.types.0.cost", "-1, must be 0..1e6"},
    {"sensors: {types: [{name: a, range_m: 1, bands: [77]}]}\n", VALUE,
     "fog.yaml:2:49: sensors.types.0",
     "bands: 77 nm is in no band of the scene"},
    {"sensors: {types: [{name: a, range_m: 1, bands: some}]}\n", VALUE,
     "fog.yaml:2:48: sensors.types.0.bands",
     "some, must be all or a list of numbers, each more than 0 and at most 1e9 "
     "nm"},
    {"sensors: {types: [{name: a, range_m: 1, view: {}}]}\n", VALUE,
     "fog.yaml:2:41: sensors.types.0.view",
     "misses hfov_deg, must be a number, more than 0 and less than 180 "
     "degrees"},
    {"sensors: {types: [{name: a, range_m: 1, view: round}]}\n", VALUE,
     "fog.yaml:2:47: sensors.types.0.view",
     "round, must be sphere or a map of keys"},
    {"sensors: {types: [{name: a, range_m: 1, view: {cone_deg: 9, hfov_deg: "
     "9}}]}\n",
     VALUE, "fog.yaml:2:61: sensors.types.0.view.hfov_deg",
     "not a key of a view (cone), must be cone_deg"},
    {"sensors: {types: [{name: a, range_m: 1, headings: 4}]}\n", VALUE,
     "fog.yaml:2:41: sensors.types.0.headings",
     "not a key of a sensor type (all round), must be one of name, range_m, "
     "least_range_m, view, arrival, acceptance_deg, aperture_m2, "
     "quantum_efficiency, exposure_s, target_m2, target_m3, bands, cost, "
     "least_count, max_count"},
    {"sensors: {types: [{name: a, range_m: 1}], count: 1, candidates: "
     "{spacing_m: -1}}\n",
     VALUE, "fog.yaml:2:77: sensors.candidates.spacing_m",
     "-1, must be 0..1e9 m"},
    {SENSORS "budget: 0}\n", VALUE, "fog.yaml:2:51: sensors.budget",
     "0, must be more than 0 and at most 1e12"},
    {SENSORS "target: 1.5}\n", VALUE, "fog.yaml:2:51: sensors.target",
     "1.5, must be more than 0 and at most 1"},
    {SENSORS "fixed: [1]}\n", VALUE, "fog.yaml:2:51: sensors.fixed.0",
     "1, must be a map of keys"},
    {SENSORS "fixed: [{type: b, position_m: [0, 0, 0]}]}\n", VALUE,
     "fog.yaml:2:51: sensors.fixed.0", "type: b is no type of `types`"},
    {SENSORS "fixed: [{position_m: [0, 0, 0], tilt_deg: 3}]}\n", VALUE,
     "fog.yaml:2:51: sensors.fixed.0",
     "heading_deg or tilt_deg, but type a sees all round"},
    {"north: [0, 0, 1]\n", VALUE, "fog.yaml:2:1",
     "north: [0, 0, 1] is not level, must be [x, y, 0] and point somewhere"},
    {SENSORS "count: 0}\n", VALUE, "fog.yaml:2:50: sensors.count",
     "0, must be 1..1e6 sensors"},
    {SENSORS "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
             "size: [2, 0, 2]}}}\n",
     VALUE, "fog.yaml:2:109: sensors.candidates.grid.size.1",
     "0, must be 1..1e7 points"},
    {SENSORS "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
             "size: [1e4, 1e4, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "200000000 points, must be at most 1e7"},
    {SENSORS "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
             "spacing_m: 1e-9}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "1.0000003e+21 points, must be at most 1e7"},
    {SENSORS "candidates: {grid: {min_m: [0, 0, 2], max_m: [1, 1, 1], "
             "size: [2, 1, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "min_m [0, 0, 2] and max_m [1, 1, 1], min must be at most max on each "
     "axis, m"},
    {SENSORS "candidates: {grid: {min_m: [0, 0, 1], max_m: [1, 1, 1], "
             "size: [2, 1, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "size 2 along z where min_m is max_m, must be 1"},
    {SENSORS "candidates: {mount: wall}}\n", VALUE,
     "fog.yaml:2:63: sensors.candidates.mount",
     "wall, must be free or a map of keys, or a list of them"},
    {SENSORS "candidates: {mount: {offset_m: 0}}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.offset_m",
     "0, must be more than 0 and at most 1e9 m"},
    {SENSORS "candidates: {mount: [{}, {facing: north}]}}\n", VALUE,
     "fog.yaml:2:77: sensors.candidates.mount.1.facing",
     "north, must be any, up, down, side"},
    {SENSORS "candidates: {mount: [{z_m: [3, 2]}]}}\n", VALUE,
     "fog.yaml:2:64: sensors.candidates.mount.0",
     "z_m is from 3 to 2 m, must not fall"},
    {SENSORS "candidates: {mount: [{z_m: [3, .nan]}]}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.0.z_m.1",
     ".nan, must be a number, -1e9..1e9 m"},
    {SENSORS "candidates: {mount: {surfaces: wood}}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.surfaces",
     "wood, must be all or a list of names of materials"},
    {SENSORS "candidates: {mount: {surfaces: [default, wod]}}, count: 1}\n"
             "materials: {wood: {diffuse: 0.5}}\n",
     VALUE, "fog.yaml:2:84: sensors.candidates.mount.surfaces.1",
     "wod is not in materials, did you mean wood?"},
    {SENSORS "candidates: {points: []}}\n", VALUE,
     "fog.yaml:2:56: sensors.candidates.points",
     "an empty list, must be the name of a file, or a list of such names and "
     "of [x, y, z]"},
    {SENSORS "candidates: {points: [a.csv, [1, 2]]}}\n", VALUE,
     "fog.yaml:2:72: sensors.candidates.points.1",
     "a list, must be [x, y, z], each -1e9..1e9 m"},
    {SENSORS "candidates: {points: [[1, 2, x]]}}\n", VALUE,
     "fog.yaml:2:72: sensors.candidates.points.0.2",
     "x, must be a number, -1e9..1e9 m"},
    {SENSORS "candidates: {avoid: [{}]}}\n", VALUE,
     "fog.yaml:2:64: sensors.candidates.avoid.0",
     "misses a key of a zone, must be one of box, sphere, mesh"},
    {SENSORS "candidates: {within: [{sphere: {center_m: [0, 0, 0], "
             "radius_m: 0}}]}}\n",
     VALUE, "fog.yaml:2:106: sensors.candidates.within.0.sphere.radius_m",
     "0, must be more than 0 and at most 1e9 m"},
    {SENSORS "candidates: {avoid: [{box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, "
             "up: z}]}}\n",
     VALUE, "fog.yaml:2:108: sensors.candidates.avoid.0.up",
     "not a key of a zone (box), must be one of box, sphere, mesh, scale, "
     "rotate_deg, translate_m"},
    /* placement and the rest */
    {"placement: {method: bset}\n", VALUE, "fog.yaml:2:21: placement.method",
     "bset, must be best, spoq, greedy, exact"},
    {"placement: {detection: radar}\n", VALUE,
     "fog.yaml:2:24: placement.detection",
     "radar, must be weighted, independent, threshold, power"},
    {"placement: {redundancy: 2, detection: power}\n", VALUE,
     "fog.yaml:2:1: placement",
     "redundancy is 2 with detection: power, must be 1: all views count there"},
    {"placement: {power_radius_m: 0}\n", VALUE,
     "fog.yaml:2:29: placement.power_radius_m",
     "0, must be more than 0 and at most 1e9 m"},
    {"placement: {at_least: 17}\n", VALUE, "fog.yaml:2:23: placement.at_least",
     "17, must be 1..16"},
    {"placement: {at_least: 2, detection: power}\n", VALUE,
     "fog.yaml:2:1: placement",
     "at_least is given, which needs detection: weighted or threshold"},
    {"placement: {at_least: 2, method: spoq}\n", VALUE,
     "fog.yaml:2:1: placement",
     "at_least is given, which needs method: best, greedy or exact"},
    {"placement: {at_least: 2, knowledge: unknown}\n", VALUE,
     "fog.yaml:2:1: placement",
     "at_least is given, which needs knowledge: known"},
    {"placement: {redundancy: 17}\n", VALUE,
     "fog.yaml:2:25: placement.redundancy", "17, must be 1..16"},
    {"placement: {redundancy: 2, detection: independent}\n", VALUE,
     "fog.yaml:2:1: placement",
     "redundancy is 2 with detection: independent, must be 1: all views count "
     "there"},
    {"placement: {threshold: 0}\n", VALUE, "fog.yaml:2:24: placement.threshold",
     "0, must be more than 0 and at most 1"},
    {"placement: {nodes: -5}\n", VALUE, "fog.yaml:2:20: placement.nodes",
     "-5, must be 0..1e15"},
    {"placement: {over: worst}\n", VALUE, "fog.yaml:2:19: placement.over",
     "worst, but the scene has no conditions"},
    {"placement: {over: best}\n", VALUE, "fog.yaml:2:19: placement.over",
     "best, must be null, mean, worst, regret"},
    {"placement: {weights: {surface: 0, volume: 0}}\n", VALUE,
     "fog.yaml:2:13: placement.weights",
     "surface and volume are both 0, one must be more than 0"},
    {"placement: {jitter_m: -0.1}\n", VALUE,
     "fog.yaml:2:23: placement.jitter_m", "-0.1, must be 0..1e9 m"},
    {"placement: {jitter_deg: 181}\n", VALUE,
     "fog.yaml:2:25: placement.jitter_deg", "181, must be 0..180 degrees"},
    {"placement: {memory_mb: -1}\n", VALUE,
     "fog.yaml:2:24: placement.memory_mb", "-1, must be 0..1e9 MiB"},
    {"placement: {jitter_draws: 1}\n", VALUE,
     "fog.yaml:2:27: placement.jitter_draws", "1, must be 2..1e6"},
    {"placement: {restarts: 0}\n", VALUE, "fog.yaml:2:23: placement.restarts",
     "0, must be 1..1e6"},
    {"flight: woodcock\n", VALUE, "fog.yaml:2:9: flight",
     "woodcock, must be march, delta"},
    {"units: lumens\n", VALUE, "fog.yaml:2:8: units",
     "lumens, must be radiometric, photometric, photons, par"},
    {"cameras: [{name: a}]\n", VALUE, "fog.yaml:2:11: cameras.0",
     "misses from_m, must be [x, y, z], each -1e9..1e9 m"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [0, 0, 1]}]\n", VALUE,
     "fog.yaml:2:11: cameras.0",
     "from_m and to_m are both [0, 0, 1] m, must be apart"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [0, 0, 0]}]\n", VALUE,
     "fog.yaml:2:11: cameras.0",
     "up is [0, 0, 1], must not be zero or along the way it looks"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [1, 0, 0], vfov_deg: "
     "180}]\n",
     VALUE, "fog.yaml:2:67: cameras.0.vfov_deg",
     "180, must be more than 0 and less than 180 degrees"},
    {"cameras: [{name: a, type: equirectangular, from_m: [0, 0, 1], vfov_deg: "
     "45}]\n",
     VALUE, "fog.yaml:2:63: cameras.0.vfov_deg",
     "not a key of a camera (equirectangular), must be one of name, type, "
     "from_m, "
     "to_m, pixels, samples, clip"},
    {"cameras: [{name: a, type: equirectangular, from_m: [0, 0, 1], to_m: [0, "
     "0, 9]}]\n",
     VALUE, "fog.yaml:2:11: cameras.0",
     "to_m is straight above or below from_m, must be to one side: it says "
     "what is in the middle"},
    {"cameras: [{name: a, from_m: [0, 0, 1]}]\n", VALUE,
     "fog.yaml:2:11: cameras.0",
     "misses to_m, must be [x, y, z], each -1e9..1e9 m"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [1, 0, 0], samples: 0}]\n",
     VALUE, "fog.yaml:2:66: cameras.0.samples", "0, must be 1..65536 samples"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [1, 0, 0], pixels: [65536, "
     "65536]}]\n",
     VALUE, "fog.yaml:2:11: cameras.0",
     "pixels are 65536 x 65536, must be 67108864 or fewer together"},
    {"cameras: [{name: a, from_m: [0, 0, 1], to_m: [1, 0, 0]}, {name: a, "
     "from_m: [0, 0, 1], to_m: [1, 0, 0]}]\n",
     VALUE, "fog.yaml:2:58: cameras.1",
     "name: a is the name of an earlier camera, must be one's own"},
    {"tallies: [{name: a}]\n", VALUE, "fog.yaml:2:11: tallies.0",
     "misses type, must be plane, grid, sphere"},
    {"tallies: [{name: a, type: cone}]\n", VALUE,
     "fog.yaml:2:27: tallies.0.type", "cone, must be plane, grid, sphere"},
    {"tallies: [{name: a, type: sphere, center_m: [0, 0, 0], radius_m: 1, "
     "bins: [2, 2]}]\n",
     VALUE, "fog.yaml:2:69: tallies.0.bins",
     "not a key of a tally (sphere), must be one of name, type, center_m, "
     "radius_m, hemispheres"},
    {"tallies: [{name: a, type: plane, point_m: [0, 0, 0], normal: [0, 0, "
     "0]}]\n",
     VALUE, "fog.yaml:2:11: tallies.0",
     "normal is [0, 0, 0], must point somewhere"},
    {"tallies: [{name: a, type: plane, point_m: [0, 0, 0], normal: [0, 0, 1], "
     "bins: [2, 2, 2]}]\n",
     VALUE, "fog.yaml:2:73: tallies.0.bins",
     "a list, must be [nx, ny], each a whole number, 1..1e6 bins"},
    {"tallies: [{name: a, type: plane, point_m: [0, 0, 0], normal: [0, 0, 1], "
     "angle_bins: 0}]\n",
     VALUE, "fog.yaml:2:85: tallies.0.angle_bins", "0, must be 1..1e6 bins"},
    {"tallies: [{name: a, type: grid, min_m: [0, 0, 0], max_m: [1, 0, 1], "
     "size: [2, 2, 2]}]\n",
     VALUE, "fog.yaml:2:11: tallies.0",
     "min_m [0, 0, 0] and max_m [1, 0, 1], min must be less than max on each "
     "axis, m"},
    {"conditions: {fog: 3}\n", VALUE, "fog.yaml:2:19: conditions.fog",
     "3, must be a map of keys"},
    {"photon: {}\n", VALUE, "fog.yaml:2:1: photon",
     "unknown key, did you mean photons?"},
};

static void test_refusals(void)
{
    check_refusals(REFUSALS, sizeof REFUSALS / sizeof *REFUSALS);
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_refusals();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
