/* Every refusal of a scene's world: its place and its words, to the letter.
 * Nothing here is random. */
#define _DEFAULT_SOURCE /* P_tmpdir */
#include "refusals.h"

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
     "misses a key of a geometry, must be one of file, box, rect, sphere, fds, "
     "geotiff"},
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
     "not a key of a geometry (sphere), must be one of name, file, box, "
     "rect, sphere, scale, rotate_deg, translate_m, material"},
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
     "fds, netcdf, profile, extinction_per_m, albedo, phase"},
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
    {"media:\n  a: {vdb: s#.vdb, frame: -1e-9, extinction_per_m: 1, albedo: "
     "1}\n",
     VALUE, "fog.yaml:3:27: media.a.frame", "-1e-9, must be 0..999999999"},
    {"media:\n  a: {vdb: s#.vdb, frame: nan, extinction_per_m: 1, albedo: 1}\n",
     VALUE, "fog.yaml:3:27: media.a.frame",
     "nan, must be a number, 0..999999999"},
    {"media:\n  a: {vdb: s#.vdb, frame: 999999999.5, extinction_per_m: 1, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:27: media.a.frame",
     "999999999.5, must be 0..999999999"},
    {"media:\n  a: {vdb: s#.vdb, frame: 9007199254740993, extinction_per_m: 1, "
     "albedo: 1}\n",
     VALUE, "fog.yaml:3:27: media.a.frame",
     "9007199254740993, must be 0..999999999"},
    {"media:\n  a: {vdb: s.vdb, frame: 3.5, extinction_per_m: 1, albedo: 1}\n",
     VALUE, "fog.yaml:3:3: media.a",
     "a frame of s.vdb, which has no place for its number, such as #### or "
     "%04d"},
    {"media:\n  a: {vdb: s#.vdb, frame: 3.5, extinction_per_m: 1, albedo: "
     "{grid: w}}\n",
     VALUE, "fog.yaml:3:27: media.a.frame",
     "3.5 is between two frames, must be whole if each frame has a grid of "
     "albedos: only densities are interpolated in time"},
    {"media:\n  a: {vdb: s#.vdb, frame: 3.5, extinction_per_m: 1, albedo: "
     "{grid: w, vdb: w%d.vdb}}\n",
     VALUE, "fog.yaml:3:27: media.a.frame",
     "3.5 is between two frames, must be whole if each frame has a grid of "
     "albedos: only densities are interpolated in time"},
    {"media:\n  a: {frame: 3, extinction_per_m: 1, albedo: 1}\n", VALUE,
     "fog.yaml:3:7: media.a.frame",
     "not a key of a medium (homogeneous), must be one of vdb, fds, netcdf, "
     "profile, "
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
};

static void test_refusals(void)
{
    check_refusals(REFUSALS, sizeof REFUSALS / sizeof *REFUSALS);
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
        "moon, sky, night_sky, luminaire, daylight");
    CHECK_REFUSED(HEAD "lights:\n  - {type: point, position_m: [0, 0, 0]}\n",
                  VALUE, "fog.yaml:3:5: lights.0",
                  "misses power_w, must be a number (the total), 0..1e15 W, or "
                  "a list, one a band");
    CHECK_REFUSED(
        HEAD "lights:\n  - {type: point, position_m: [0, 0, 0], "
             "power_w: 1, radius_m: 1}\n",
        VALUE, "fog.yaml:3:54: lights.0.radius_m",
        "not a key of a light (point), must be one of type, "
        "position_m, power_w, spectrum, temperature_k, array, schedule");
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
    murk_scene_desc *scene = NULL;
    murk_error err = {0};
    CHECK(murk_scene_desc_read(&scene, "none.yaml", NULL, 0, &err) ==
          MURK_BAD_FILE);
    CHECK_TEXT(err.where, "none.yaml");
    CHECK_TEXT(err.text, "cannot read: No such file or directory");
    err = (murk_error){0};
    CHECK(murk_scene_desc_read(&scene, ".", NULL, 0, &err) == MURK_BAD_FILE);
    CHECK_MENTIONS(err.text, "a folder, must be a regular file");
}
int main(void)
{
    if (!folder_enter()) {
        check_skip("no folder for temporary files");
    }
    test_refusals();
    test_lights();
    test_the_file_itself();
    folder_leave((const char *const[]){"fog.yaml", NULL});
    return check_done();
}
