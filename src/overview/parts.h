/* Parts of murk check: for each, one function prints lines of the summary, and
 * another adds a part of the JSON. */
#ifndef MURK_OVERVIEW_PARTS_H
#define MURK_OVERVIEW_PARTS_H

#include "lightmap/lightmap.h"
#include "plan/poses.h"
#include "results/json.h"
#include "results/session.h"
#include "world/stage.h"

/* Media with their coefficients, phase functions and grids, and regions with
 * their bounds: "media" and "regions". Bounds of an unbounded region are those
 * of the part in the domain. */
void murk_overview_print_media(const murk_stage *stage);
void murk_overview_json_media(cJSON *root, const murk_stage *stage);

/* Ground from files of elevations: size, missing heights, triangles, the error
 * of the mesh, and the place: "ground": [{geometry, file, columns, rows,
 * missing, uncovered, spacing_m, low_m, high_m, unit_m, unit_from, triangles,
 * error_m, longitude_deg, latitude_deg, system}], left out without ground. */
void murk_overview_print_ground(const murk_stage *stage);
void murk_overview_json_ground(cJSON *root, const murk_stage *stage);

/* The power of all lights together, in watts and in the scene's `units`; of
 * each light of the sky the irradiance, and the position of sun or moon; and
 * which lamps are off. Adds "lights": {count, power_w, power_SUFFIX (in the
 * scene's `units`, unless these are radiometric), sky: [{light, type, on,
 * azimuth_deg, elevation_deg, irradiance_w_per_m2, irradiance, unit (of
 * `units`), taken_again: {share, optical_depth, transmittance} of the media of
 * the scene (world/daylight_loss.h)}]}. The array sky has every light, lamps
 * too, by its number in the scene, with null for each value, or for
 * taken_again as a whole, that a light does not have. */
void murk_overview_print_lights(const murk_stage *stage);
void murk_overview_json_lights(cJSON *root, const murk_stage *stage);

/* The weather at the time of the scene, and the preset that media with `preset:
 * weather` have: "weather", see murk-results(5). Nothing if the scene takes no
 * weather. */
void murk_overview_print_weather(const murk_stage *stage);
void murk_overview_json_weather(cJSON *root, const murk_stage *stage);

/* Types of sensors, with the number of their usable candidates: "sensors", null
 * without poses. */
void murk_overview_print_sensor_types(const murk_scene_desc *scene,
                                      const murk_poses *poses);
void murk_overview_json_sensor_types(cJSON *root, const murk_scene_desc *scene,
                                     const murk_poses *poses);

/* Cameras: "cameras": [{name, type, pixels, samples, memory_bytes}], the memory
 * of one picture by maps with the maps and the kernels made of them; and
 * warnings of pictures that would not fit into the free memory. */
void murk_overview_print_cameras(const murk_scene_desc *scene,
                                 const murk_forecast *forecast);
void murk_overview_json_cameras(cJSON *root, const murk_scene_desc *scene,
                                const murk_forecast *forecast);
void murk_overview_warn_of_cameras(const murk_scene_desc *scene,
                                   const murk_forecast *forecast);

/* The timeline of a scene: its steps, the time shown, and what each track
 * changes: "timeline": {steps, from_s, to_s, at_s, tracks: [{of, name, from_s,
 * to_s, keyframes, files}]}, with null for each value that a track does not
 * have. Nothing without a timeline. Warns of files of a sequence that steps
 * need and that do not exist, and of steps at which a value of the scene is
 * refused, one warning a key. */
void murk_overview_print_timeline(const murk_scene_desc *scene);
void murk_overview_json_timeline(cJSON *root, const murk_scene_desc *scene);
void murk_overview_warn_of_timeline(const murk_stage *stage);

/* The forecast of a full run: photons, records, memory and disk space. poses:
 * NULL if the scene has no sensors. "forecast": see murk-results(5). */
void murk_overview_print_forecast(const murk_session *session,
                                  const murk_poses *poses,
                                  const murk_forecast *forecast);
void murk_overview_json_forecast(cJSON *root, const murk_session *session,
                                 const murk_poses *poses,
                                 const murk_forecast *forecast);

/* The same run shared by `ranks` ranks (base/ranks.h), each with the threads of
 * the session: what each rank computes, holds and receives. "ranks": see
 * murk-results(5). */
void murk_overview_print_ranks(const murk_session *session,
                               const murk_poses *poses,
                               const murk_forecast *forecast, unsigned ranks);
void murk_overview_json_ranks(cJSON *root, const murk_session *session,
                              const murk_poses *poses,
                              const murk_forecast *forecast, unsigned ranks);

#endif
