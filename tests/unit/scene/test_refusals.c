/* Every refusal of a scene: its place and its words, to the letter. Nothing
 * here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "full_scene.h"
#include "scene_files.h"

#define HEAD  "murk: 1\n"
#define LAMP  "lights: [{type: point, position_m: [0, 0, 0], power_w: 1}]\n"
#define ROOM  "sensors: {types: [{name: a, range_m: 1}], "
#define VALUE MURK_BAD_VALUE
#define LATER MURK_UNSUPPORTED

typedef struct refusal {
    const char *scene; /* from line 2 on, without lights */
    murk_status status;
    const char *where, *text;
} refusal;

static const refusal REFUSALS[] = {
    /* wrong types and numbers */
    {"seed: -3\n", VALUE, "fog.yaml:2:7: seed", "-3, must be 0..4294967295"},
    {"seed: 12abc\n", VALUE, "fog.yaml:2:7: seed",
     "12abc, must be a whole number, 0..4294967295"},
    {"seed: 1.5\n", VALUE, "fog.yaml:2:7: seed",
     "1.5, must be a whole number, 0..4294967295"},
    {"seed: \"1\"\n", VALUE, "fog.yaml:2:7: seed",
     "\"1\", must be a whole number, 0..4294967295"},
    {"seed: 0x10\n", VALUE, "fog.yaml:2:7: seed",
     "0x10, must be a whole number, 0..4294967295"},
    {"seed:\n", VALUE, "fog.yaml:2:6: seed",
     "nothing, must be a whole number, 0..4294967295"},
    {"seed: [1]\n", VALUE, "fog.yaml:2:1: seed",
     "a list, must be a whole number, 0..4294967295"},
    {"geometry: {}\n", VALUE, "fog.yaml:2:1: geometry",
     "an empty map, must be a list of maps"},
    {"media: []\n", VALUE, "fog.yaml:2:1: media",
     "an empty list, must be a map of names"},
    {"photons: 5\n", VALUE, "fog.yaml:2:10: photons",
     "5, must be a map of keys"},
    {"geometry: [wall]\n", VALUE, "fog.yaml:2:12: geometry.0",
     "wall, must be a map of keys"},
    /* bands and domain */
    {"bands_nm: []\n", VALUE, "fog.yaml:2:1: bands_nm",
     "an empty list, must be a list of 1..16 rising wavelengths, each more "
     "than 0 and at most 1e9 nm"},
    {"bands_nm: [500, 400]\n", VALUE, "fog.yaml:2:17: bands_nm",
     "400 after 500, must rise, nm"},
    {"bands_nm: [0]\n", VALUE, "fog.yaml:2:12: bands_nm.0",
     "0, must be more than 0 and at most 1e9 nm"},
    {"bands_nm: [5]\nband_edges_nm: [1, 2]\n", VALUE, "fog.yaml:1:1",
     "has bands_nm and band_edges_nm, must have one of them"},
    {"domain: {min_m: [0, 0, 0], max_m: [1, 1, 0]}\n", VALUE,
     "fog.yaml:2:1: domain",
     "min_m [0, 0, 0] and max_m [1, 1, 0], min must be less than max on each "
     "axis, m"},
    {"domain: {min_m: [0, 0], max_m: [1, 1, 0]}\n", VALUE,
     "fog.yaml:2:10: domain.min_m",
     "a list, must be [x, y, z], each -1e9..1e9 m"},
    {"domain: {min_m: [0, nan, 0], max_m: [1, 1, 0]}\n", VALUE,
     "fog.yaml:2:21: domain.min_m.1", "nan, must be a number, -1e9..1e9 m"},
    {"domain: {min_m: [0, 0, 0], max_m: [1, 1, 1], sides: closed}\n", VALUE,
     "fog.yaml:2:53: domain.sides", "closed, must be open, periodic"},
    /* geometry */
    {"geometry:\n  - {box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, file: a}\n",
     VALUE, "fog.yaml:3:5: geometry.0",
     "has file and box, must have one of them"},
    {"geometry:\n  - {scale: 2}\n", VALUE, "fog.yaml:3:5: geometry.0",
     "misses a key of a geometry, must be one of file, box, rect, sphere"},
    {"geometry:\n  - {file: a, scale: 0}\n", VALUE,
     "fog.yaml:3:22: geometry.0.scale",
     "0, must be more than 0 and at most 1e9"},
    {"geometry:\n  - {file: a, material: wod}\nmaterials: {wood: {}}\n", VALUE,
     "fog.yaml:3:25: geometry.0.material",
     "wod is not in materials, did you mean wood?"},
    {"geometry:\n  - {file: a, material: gold}\nmaterials: {wood: {}}\n", VALUE,
     "fog.yaml:3:25: geometry.0.material",
     "gold is not in materials, must be a name given there: default, wood"},
    {"geometry:\n  - {sphere: {center_m: [0, 0, 0], radius_m: 1}, up: z}\n",
     VALUE, "fog.yaml:3:50: geometry.0.up",
     "not a key of a geometry (sphere), must be one of file, box, rect, "
     "sphere, scale, rotate_deg, translate_m, material"},
    {"geometry:\n  - {rect: {corner_m: [0, 0, 0], edge1_m: [1, 2, 3], "
     "edge2_m: [2, 4, 6]}}\n",
     VALUE, "fog.yaml:3:6: geometry.0.rect",
     "edge1_m and edge2_m span no area, must not be zero or parallel"},
    {"geometry:\n  - {sphere: {center_m: [0, 0, 0]}}\n", VALUE,
     "fog.yaml:3:6: geometry.0.sphere",
     "misses radius_m, must be a number, more than 0 and at most 1e9 m"},
    /* materials */
    {"materials:\n  wood: {diffuse: 0.6, specular: 0.5}\n", VALUE,
     "fog.yaml:3:3: materials.wood",
     "diffuse + specular + transmit is 1.1 at 550 nm, must be at most 1"},
    {"materials:\n  wood: {diffuse: [0.6, 0.5]}\n", VALUE,
     "fog.yaml:3:10: materials.wood.diffuse",
     "a list of 2, must be one number or a list of 1, one a band"},
    {"materials:\n  wood: {difuse: 0.6}\n", VALUE,
     "fog.yaml:3:10: materials.wood.difuse",
     "unknown key, did you mean diffuse?"},
    {"materials:\n  wood: {colour: 0.6}\n", VALUE,
     "fog.yaml:3:10: materials.wood.colour",
     "unknown key, must be one of diffuse, specular, transmit, ior"},
    {"materials:\n  wood: {ior: 0.5}\n", VALUE,
     "fog.yaml:3:15: materials.wood.ior", "0.5, must be 1..10"},
    /* media */
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1.2}\n", VALUE,
     "fog.yaml:3:38: media.fog.albedo", "1.2, must be 0..1"},
    {"media:\n  fog: {extinction_per_m: -1, albedo: 1}\n", VALUE,
     "fog.yaml:3:27: media.fog.extinction_per_m", "-1, must be 0..1e9 1/m"},
    {"media:\n  fog: {albedo: 1}\n", VALUE, "fog.yaml:3:3: media.fog",
     "misses extinction_per_m, must be a number, 0..1e9 1/m, or a list of "
     "them, one a band"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {hg: 1}}\n", VALUE,
     "fog.yaml:3:53: media.fog.phase.hg",
     "1, must be more than -1 and less than 1"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: isotrop}\n", VALUE,
     "fog.yaml:3:48: media.fog.phase",
     "isotrop, must be isotropic, rayleigh or a map of keys"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {}}\n", VALUE,
     "fog.yaml:3:41: media.fog.phase",
     "misses a key of a phase, must be one of hg, two_hg, fournier_forand, "
     "table"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, grid: a}\n", VALUE,
     "fog.yaml:3:41: media.fog.grid",
     "not a key of a medium (homogeneous), must be one of vdb, "
     "profile, extinction_per_m, albedo, phase"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {two_hg: [0, "
     "0]}}\n",
     VALUE, "fog.yaml:3:49: media.fog.phase.two_hg",
     "a list, must be [g1, g2, weight1], g1 more than -1 and less than 1, g2 "
     "more than -1 and less than 1, weight1 0..1"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {two_hg: [0, 1, "
     "1]}}\n",
     VALUE, "fog.yaml:3:61: media.fog.phase.two_hg.1",
     "1, must be more than -1 and less than 1"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {two_hg: [0, 0, "
     "2]}}\n",
     VALUE, "fog.yaml:3:64: media.fog.phase.two_hg.2", "2, must be 0..1"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {two_hg: [0, 0, "
     "x]}}\n",
     VALUE, "fog.yaml:3:64: media.fog.phase.two_hg.2",
     "x, must be a number, 0..1"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {fournier_forand: "
     "1.1}}\n",
     VALUE, "fog.yaml:3:66: media.fog.phase.fournier_forand",
     "1.1, must be [n, mu], n 1.001..2, mu 3.0001..4.9999"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {fournier_forand: "
     "[1, 3.5]}}\n",
     VALUE, "fog.yaml:3:67: media.fog.phase.fournier_forand.0",
     "1, must be 1.001..2"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {fournier_forand: "
     "[1.1, 3]}}\n",
     VALUE, "fog.yaml:3:72: media.fog.phase.fournier_forand.1",
     "3, must be 3.0001..4.9999"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {table: []}}\n",
     VALUE, "fog.yaml:3:49: media.fog.phase.table",
     "an empty list, must be the name of a file"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: {hg: 0, table: "
     "x}}\n",
     VALUE, "fog.yaml:3:41: media.fog.phase",
     "has hg and table, must have one of them"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: [rayleigh, "
     "isotropic]}\n",
     VALUE, "fog.yaml:3:41: media.fog.phase",
     "a list of 2, must be one phase or a list of 1, one a band"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: [rayleig]}\n",
     VALUE, "fog.yaml:3:49: media.fog.phase.0",
     "rayleig, must be isotropic, rayleigh or a map of keys"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: [{hg: [0]}]}\n",
     VALUE, "fog.yaml:3:50: media.fog.phase.0.hg",
     "a list inside a list of bands, must be one number"},
    {"media:\n  fog: {extinction_per_m: 1, albedo: 1, phase: [{hg: 2}]}\n",
     VALUE, "fog.yaml:3:54: media.fog.phase.0.hg",
     "2, must be more than -1 and less than 1"},
    {"media:\n  fog: {preset: fog/kruze}\n", VALUE,
     "fog.yaml:3:17: media.fog.preset",
     "no preset fog/kruze, did you mean fog/kruse?"},
    {"media:\n  a: {vdb: x, extinction_per_m: 1, albedo: 1, interpolation: "
     "cubic}\n",
     VALUE, "fog.yaml:3:62: media.a.interpolation",
     "cubic, must be nearest, linear"},
    {"media:\n  a: {profile: {z_m: [0, 1], extinction_per_m: [1]}, albedo: "
     "1}\n",
     VALUE, "fog.yaml:3:7: media.a.profile",
     "2 heights and 1 extinctions, must be as many of both, at least 2"},
    {"media:\n  a: {profile: {z_m: [1], extinction_per_m: [1]}, albedo: 1}\n",
     VALUE, "fog.yaml:3:7: media.a.profile",
     "1 heights and 1 extinctions, must be as many of both, at least 2"},
    {"media:\n  a: {profile: {z_m: [0, 2, 1], extinction_per_m: [1, 1, 1]}, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:7: media.a.profile",
     "z_m has 1 after 2, must rise; a height given twice is a jump"},
    {"media:\n  a: {profile: {z_m: [0, 0, 0], extinction_per_m: [1, 1, 1]}, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:7: media.a.profile",
     "z_m has 0 after 0, must rise; a height given twice is a jump"},
    {"media:\n  a: {profile: {z_m: [3, 3], extinction_per_m: [1, 1]}, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:7: media.a.profile",
     "z_m has 3 alone, must span a layer"},
    {"media:\n  a: {profile: {z_m: [0, .nan], extinction_per_m: [1, 1]}, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:26: media.a.profile.z_m.1",
     ".nan, must be a number, -1e9..1e9 m"},
    {"media:\n  a: {profile: {z_m: 5, extinction_per_m: [1, 1]}, albedo: 1}\n",
     VALUE, "fog.yaml:3:22: media.a.profile.z_m",
     "5, must be a list of numbers, each -1e9..1e9 m"},
    {"media:\n  a: {profile: {z_m: [0, 1], extinction_per_m: [1, -1]}, albedo: "
     "1}\n",
     VALUE, "fog.yaml:3:52: media.a.profile.extinction_per_m.1",
     "-1, must be 0..1e9 1/m"},
    {"media:\n  a: {profile: {z_m: [0, 1], extinction_per_m: [1, [1, 2]]}, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:52: media.a.profile.extinction_per_m.1",
     "a list of 2, must be one number or a list of 1, one a band"},
    {"media:\n  a: {profile: {z_m: [0, 1], extinction_per_m: [1, 1]}, vdb: x, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:3: media.a",
     "has vdb and profile, must have one of them"},
    {"media:\n  a: {extinction_per_m: 1, albedo: {grid: w}}\n", VALUE,
     "fog.yaml:3:28: media.a.albedo", "misses vdb, must be the name of a file"},
    {"media:\n  a: {extinction_per_m: 1, albedo: {vdb: w}}\n", VALUE,
     "fog.yaml:3:28: media.a.albedo",
     "misses grid, must be a text of 1..255 bytes"},
    {"media:\n  a: {vdb: smoke.vdb, frame: 3, extinction_per_m: 1, albedo: "
     "1}\n",
     VALUE, "fog.yaml:3:3: media.a",
     "a frame of smoke.vdb, which has no place for its number, such as #### "
     "or %04d"},
    {"media:\n  a: {vdb: s#.vdb, frame: -3, extinction_per_m: 1, albedo: 1}\n",
     VALUE, "fog.yaml:3:27: media.a.frame", "-3, must be 0..999999999"},
    {"media:\n  a: {frame: 3, extinction_per_m: 1, albedo: 1}\n", VALUE,
     "fog.yaml:3:7: media.a.frame",
     "not a key of a medium (homogeneous), must be one of vdb, profile, "
     "extinction_per_m, albedo, phase"},
    /* regions */
    {"regions:\n  - {medium: fog}\n", VALUE, "fog.yaml:3:14: regions.0.medium",
     "fog is not in media, must be a name given there: there are none"},
    {"regions:\n  - {medium: fog, below_z_m: 0, ior: 0.9}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:38: regions.0.ior", "0.9, must be 1..10"},
    {"regions:\n  - {medium: fog, below_z_m: 0, ior: 1.3, wind_m_per_s: 21}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:57: regions.0.wind_m_per_s", "21, must be 0..20 m/s"},
    {"regions:\n  - {medium: fog, below_z_m: 0, ior: 1.3, wind_m_per_s: nan}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:57: regions.0.wind_m_per_s",
     "nan, must be a number, 0..20 m/s"},
    {"regions:\n  - {medium: fog, below_z_m: 0, wind_m_per_s: 5}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:47: regions.0.wind_m_per_s",
     "5 m/s over a region without ior, must be 0 there: only where the index "
     "changes waves bend light"},
    {"regions:\n  - {medium: fog, ior: 1.3, wind_m_per_s: 5}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:29: regions.0.wind_m_per_s",
     "not a key of a region (everywhere), must be one of medium, box, sphere, "
     "below_z_m, mesh, replace, ior"},
    {"regions:\n  - {medium: fog, below_z_m: .inf}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:30: regions.0.below_z_m",
     ".inf, must be a number, -1e9..1e9 m"},
    {"regions:\n  - {medium: fog, below_z_m: 0, scale: 2}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:33: regions.0.scale",
     "not a key of a region (half space), must be one of medium, box, sphere, "
     "below_z_m, mesh, replace, ior, wind_m_per_s"},
    {"regions:\n  - {medium: a, ior: 1.5}\n"
     "media: {a: {vdb: x, extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:17: regions.0.ior",
     "not a key of a region (grid), must be one of medium, box, sphere, "
     "below_z_m, mesh, scale, rotate_deg, translate_m, replace"},
    {"regions:\n  - {medium: fog, below_z_m: 0, sphere: {center_m: [0, 0, 0], "
     "radius_m: 1}}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:5: regions.0",
     "has sphere and below_z_m, must have one of them"},
    {"regions:\n  - {medium: fog, scale: 2}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:19: regions.0.scale",
     "not a key of a region (everywhere), must be one of medium, box, sphere, "
     "below_z_m, mesh, replace, ior"},
    {"regions:\n  - {medium: fog, replace: yes}\n"
     "media: {fog: {extinction_per_m: 1, albedo: 1}}\n",
     VALUE, "fog.yaml:3:28: regions.0.replace", "yes, must be true or false"},
    /* photons */
    {"photons: {emit: 0}\n", VALUE, "fog.yaml:2:17: photons.emit",
     "0, must be 1..4294967295 photons"},
    {"photons: {emit: 1152921504606846976}\n", VALUE,
     "fog.yaml:2:17: photons.emit",
     "1152921504606846976, must be 1..4294967295 photons"},
    {"photons: {emit: -5}\n", VALUE, "fog.yaml:2:17: photons.emit",
     "-5, must be 1..4294967295 photons"},
    {"photons: {emit: 5, store: 5}\n", VALUE, "fog.yaml:2:1: photons",
     "has emit and store, must have one of them"},
    {"photons: {store: 5, max_stored: 4}\n", VALUE, "fog.yaml:2:1: photons",
     "store 5 is more than max_stored 4"},
    {"photons: {store: 5, maps: none}\n", VALUE, "fog.yaml:2:1: photons",
     "store 5 with maps: none, must be emit where nothing is stored"},
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
    {ROOM "budget: 0}\n", VALUE, "fog.yaml:2:51: sensors.budget",
     "0, must be more than 0 and at most 1e12"},
    {ROOM "target: 1.5}\n", VALUE, "fog.yaml:2:51: sensors.target",
     "1.5, must be more than 0 and at most 1"},
    {ROOM "fixed: [1]}\n", VALUE, "fog.yaml:2:51: sensors.fixed.0",
     "1, must be a map of keys"},
    {ROOM "fixed: [{type: b, position_m: [0, 0, 0]}]}\n", VALUE,
     "fog.yaml:2:51: sensors.fixed.0", "type: b is no type of `types`"},
    {ROOM "fixed: [{position_m: [0, 0, 0], tilt_deg: 3}]}\n", VALUE,
     "fog.yaml:2:51: sensors.fixed.0",
     "heading_deg or tilt_deg, but type a sees all round"},
    {"north: [0, 0, 1]\n", VALUE, "fog.yaml:2:1",
     "north: [0, 0, 1] is not level, must be [x, y, 0] and point somewhere"},
    {ROOM "count: 0}\n", VALUE, "fog.yaml:2:50: sensors.count",
     "0, must be 1..1e6 sensors"},
    {ROOM "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
          "size: [2, 0, 2]}}}\n",
     VALUE, "fog.yaml:2:109: sensors.candidates.grid.size.1",
     "0, must be 1..1e7 points"},
    {ROOM "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
          "size: [1e4, 1e4, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "200000000 points, must be at most 1e7"},
    {ROOM "candidates: {grid: {min_m: [0, 0, 0], max_m: [1, 1, 1], "
          "spacing_m: 1e-9}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "1.0000003e+21 points, must be at most 1e7"},
    {ROOM "candidates: {grid: {min_m: [0, 0, 2], max_m: [1, 1, 1], "
          "size: [2, 1, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "min_m [0, 0, 2] and max_m [1, 1, 1], min must be at most max on each "
     "axis, m"},
    {ROOM "candidates: {grid: {min_m: [0, 0, 1], max_m: [1, 1, 1], "
          "size: [2, 1, 2]}}}\n",
     VALUE, "fog.yaml:2:56: sensors.candidates.grid",
     "size 2 along z where min_m is max_m, must be 1"},
    {ROOM "candidates: {mount: wall}}\n", VALUE,
     "fog.yaml:2:63: sensors.candidates.mount",
     "wall, must be free or a map of keys, or a list of them"},
    {ROOM "candidates: {mount: {offset_m: 0}}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.offset_m",
     "0, must be more than 0 and at most 1e9 m"},
    {ROOM "candidates: {mount: [{}, {facing: north}]}}\n", VALUE,
     "fog.yaml:2:77: sensors.candidates.mount.1.facing",
     "north, must be any, up, down, side"},
    {ROOM "candidates: {mount: [{z_m: [3, 2]}]}}\n", VALUE,
     "fog.yaml:2:64: sensors.candidates.mount.0",
     "z_m is from 3 to 2 m, must not fall"},
    {ROOM "candidates: {mount: [{z_m: [3, .nan]}]}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.0.z_m.1",
     ".nan, must be a number, -1e9..1e9 m"},
    {ROOM "candidates: {mount: {surfaces: wood}}}\n", VALUE,
     "fog.yaml:2:74: sensors.candidates.mount.surfaces",
     "wood, must be all or a list of names of materials"},
    {ROOM "candidates: {mount: {surfaces: [default, wod]}}, count: 1}\n"
          "materials: {wood: {diffuse: 0.5}}\n",
     VALUE, "fog.yaml:2:84: sensors.candidates.mount.surfaces.1",
     "wod is not in materials, did you mean wood?"},
    {ROOM "candidates: {points: []}}\n", VALUE,
     "fog.yaml:2:56: sensors.candidates.points",
     "an empty list, must be the name of a file, or a list of such names and "
     "of [x, y, z]"},
    {ROOM "candidates: {points: [a.csv, [1, 2]]}}\n", VALUE,
     "fog.yaml:2:72: sensors.candidates.points.1",
     "a list, must be [x, y, z], each -1e9..1e9 m"},
    {ROOM "candidates: {points: [[1, 2, x]]}}\n", VALUE,
     "fog.yaml:2:72: sensors.candidates.points.0.2",
     "x, must be a number, -1e9..1e9 m"},
    {ROOM "candidates: {avoid: [{}]}}\n", VALUE,
     "fog.yaml:2:64: sensors.candidates.avoid.0",
     "misses a key of a zone, must be one of box, sphere, mesh"},
    {ROOM "candidates: {within: [{sphere: {center_m: [0, 0, 0], "
          "radius_m: 0}}]}}\n",
     VALUE, "fog.yaml:2:106: sensors.candidates.within.0.sphere.radius_m",
     "0, must be more than 0 and at most 1e9 m"},
    {ROOM "candidates: {avoid: [{box: {min_m: [0, 0, 0], max_m: [1, 1, 1]}, "
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
     "best, must be null, mean, worst"},
    {"placement: {weights: {surface: 0, volume: 0}}\n", VALUE,
     "fog.yaml:2:13: placement.weights",
     "surface and volume are both 0, one must be more than 0"},
    {"placement: {jitter_m: -0.1}\n", VALUE,
     "fog.yaml:2:23: placement.jitter_m", "-0.1, must be 0..1e9 m"},
    {"placement: {jitter_deg: 181}\n", VALUE,
     "fog.yaml:2:25: placement.jitter_deg", "181, must be 0..180 degrees"},
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
     "to_m, pixels, samples"},
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
    char text[1000];
    for (size_t i = 0; i < sizeof REFUSALS / sizeof *REFUSALS; ++i) {
        const refusal *r = &REFUSALS[i];
        snprintf(text, sizeof text, HEAD "%s" LAMP, r->scene);
        CHECK_REFUSED(text, r->status, r->where, r->text);
    }
}

static void test_lights(void)
{
    CHECK_REFUSED(HEAD "lights: []\n", VALUE, "fog.yaml:2:1: lights",
                  "an empty list, must have at least one light");
    CHECK_REFUSED(HEAD, VALUE, "fog.yaml:1:1",
                  "misses lights, must be a list of at least one light");
    CHECK_REFUSED(
        HEAD "lights:\n  - {power_w: 1}\n", VALUE, "fog.yaml:3:5: lights.0",
        "misses type, must be sphere, rect, point, beam, directional, sun, "
        "moon, sky, night_sky");
    CHECK_REFUSED(HEAD "lights:\n  - {type: point, position_m: [0, 0, 0]}\n",
                  VALUE, "fog.yaml:3:5: lights.0",
                  "misses power_w, must be a number (the total), 0..1e15 W, or "
                  "a list, one a band");
    CHECK_REFUSED(HEAD "lights:\n  - {type: point, position_m: [0, 0, 0], "
                       "power_w: 1, radius_m: 1}\n",
                  VALUE, "fog.yaml:3:54: lights.0.radius_m",
                  "not a key of a light (point), must be one of type, "
                  "position_m, power_w, schedule");
    CHECK_REFUSED(HEAD "lights:\n  - {type: directional, direction: [0, 0, 0], "
                       "irradiance_w_per_m2: 1}\n",
                  VALUE, "fog.yaml:3:5: lights.0",
                  "direction is [0, 0, 0], must point somewhere");
}

static void test_the_file_itself(void)
{
    CHECK_REFUSED("", MURK_BAD_FILE, "fog.yaml", "empty, must be YAML");
    CHECK_REFUSED("[1]", VALUE, "fog.yaml:1:1",
                  "a list, must be a scene: a map of keys");
    CHECK_REFUSED(LAMP, VALUE, "fog.yaml:1:1",
                  "misses murk, must be a whole number, 1");
    CHECK_REFUSED("murk: 2\n" LAMP, VALUE, "fog.yaml:1:7: murk",
                  "2, must be 1");
    murk_scene *scene = NULL;
    murk_error err = {0};
    CHECK(murk_scene_read(&scene, "none.yaml", NULL, 0, &err) == MURK_BAD_FILE);
    CHECK_TEXT(err.where, "none.yaml");
    CHECK_TEXT(err.text, "cannot read: No such file or directory");
    err = (murk_error){0};
    CHECK(murk_scene_read(&scene, ".", NULL, 0, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, "a folder, must be a regular file");
}

/* ---- options ---- */

typedef struct option_refusal {
    const char *option, *where, *text;
} option_refusal;

static const option_refusal OPTIONS[] = {
    {"lights.9.power_w=1", "--set lights.9.power_w=1",
     "item 9 of a list of 5, must be 0..4"},
    {"lights.x.power_w=1", "--set lights.x.power_w=1",
     "item x of a list of 5, must be 0..4"},
    {"lights.0.power_w=1W", "--set lights.0.power_w=1W",
     "1W, must be a number (the total), 0..1e15 W, or a list, one a band"},
    {"lights.0.powr_w=1", "--set lights.0.powr_w=1",
     "no powr_w in lights, did you mean power_w?"},
    {"media.hase.albedo=1", "--set media.hase.albedo=1",
     "no hase in media, did you mean haze?"},
    {"media.fog={albedo: 1}", "--set media.fog={albedo: 1}",
     "misses extinction_per_m, must be a number, 0..1e9 1/m, or a list of "
     "them, one a band"},
    {"media.haze={extinction_per_m: 1, albedo: 3}",
     "--set media.haze={extinction_per_m: 1, albedo: 3}: media.haze.albedo",
     "3, must be 0..1"},
    {"media.haze.preset=x", "--set media.haze.preset=x",
     "no preset x, must be one of those that `murk media` lists"},
    {"photons", "--set photons", "must be KEY=VALUE, such as photons.emit=1e5"},
    {"=3", "--set =3",
     "an empty key, must be KEY=VALUE, such as photons.emit=1e5"},
    {"photons..emit=3", "--set photons..emit=3",
     "an empty key, must be KEY=VALUE, such as photons.emit=1e5"},
    {"seed=", "--set seed=", "empty, must be YAML"},
    {"seed=[1", "--set seed=[1", "not YAML: did not find expected ',' or ']'"},
    {"seed.x=1", "--set seed.x=1", "x is below a single value"},
    {"sed=1", "--set sed=1", "no sed in the scene, did you mean seed?"},
    {"placement.method.x=1", "--set placement.method.x=1",
     "x is below a single value"},
    {"domain.min_m.3=1", "--set domain.min_m.3=1",
     "item 3 of a list of 3, must be 0..2"},
};

static void test_option_refusals(void)
{
    for (size_t i = 0; i < sizeof OPTIONS / sizeof *OPTIONS; ++i) {
        const murk_override option = {.text = OPTIONS[i].option};
        murk_scene *scene;
        murk_error err;
        CHECK(scene_of(&scene, FULL_SCENE, &option, 1, &err) != MURK_OK);
        CHECK_TEXT(err.where, OPTIONS[i].where);
        CHECK_TEXT(err.text, OPTIONS[i].text);
        murk_scene_destroy(scene);
    }
}

static void test_options_of_other_names(void)
{
    const murk_override option = {.text = "seed=-3", .option = "--seed -3"};
    murk_scene *scene;
    murk_error err;
    CHECK(scene_of(&scene, FULL_SCENE, &option, 1, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "--seed -3");
    CHECK_TEXT(err.text, "-3, must be 0..4294967295");
}

static void test_options_apply(void)
{
    static const murk_override options[] = {
        {.text = "media.haze.phase=isotropic"},
        {.text = "media.thin.phase.hg=0.5"}, /* was a word: now a map */
        {.text = "media.smoke.phase=[rayleigh, {hg: .1}]"},
        {.text = "media.smoke.phase.0.two_hg=[.9, -.1, .7]"},
        {.text = "media.smoke.phase.1.hg=.2"},
        {.text = "lights.1.power_w.0=11"},
        {.text = "photons.emit=1e6"}, /* in place of store */
        {.text = "photons.emit=2e6"}, /* the last of equals wins */
        {.text = "placement.weights=balanced"},
        {.text = "media.new={extinction_per_m: 1, albedo: 0}"},
        {.text = "regions.0.medium=new"},
        {.text = "materials.default.diffuse=0.25"},
        {.text = "sensors.candidates.grid.spacing_m=2"},
    };
    murk_scene *scene;
    murk_error err;
    const murk_status status = scene_of(&scene, FULL_SCENE, options,
                                        sizeof options / sizeof *options, &err);
    CHECK(status == MURK_OK);
    CHECK_TEXT(err.text, "");
    if (status) {
        return;
    }
    CHECK(scene->media[0].phase[0].mean_cosine.band[0] == 0);
    CHECK(scene->media[2].phase[0].mean_cosine.band[1] == 0.5);
    const murk_scene_medium *smoke = &scene->media[1];
    CHECK(smoke->n_phases == 2);
    CHECK(smoke->phase[0].kind == MURK_SCENE_PHASE_TWO_HG);
    CHECK(smoke->phase[0].two_hg[2] == .7);
    CHECK(smoke->phase[1].mean_cosine.band[1] == .2);
    CHECK(scene->lights[1].power_w.band[0] == 11);
    CHECK(scene->lights[1].power_w.band[1] == 30);
    CHECK(scene->photons.emit == 2000000 && scene->photons.store == 0);
    CHECK(scene->photons.store_hits);
    CHECK(scene->placement.balanced);
    CHECK(scene->n_media == 6 && scene->regions[0].medium == 5);
    CHECK(scene->materials[0].diffuse.band[0] == 0.25);
    CHECK(scene->sensors.candidates.grid_size[0] == 15);
    murk_scene_destroy(scene);
}

static void test_emit_and_store_exclude_each_other(void)
{
    const murk_override both[] = {{.text = "photons.store=5"},
                                  {.text = "photons.emit=5"}};
    murk_scene *scene;
    murk_error err;
    CHECK(scene_of(&scene, FULL_SCENE, both, 2, &err) == MURK_BAD_VALUE);
    CHECK_TEXT(err.where, "--set photons.emit=5");
    CHECK_TEXT(err.text, "store and emit are both on the command line, must be "
                         "one of them");
}

int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_refusals();
    test_lights();
    test_the_file_itself();
    test_option_refusals();
    test_options_of_other_names();
    test_options_apply();
    test_emit_and_store_exclude_each_other();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
