/* What one row of a study has found: named values with their errors, and the
 * plan made for it; as text, which another process hands over or a file keeps.
 */
#ifndef MURK_CASES_ROW_H
#define MURK_CASES_ROW_H

#include "base/stats.h"
#include "base/status.h"
#include "scene/scene.h"
#include "sensing/sensor.h"

#define MURK_ROW_NAME_SIZE 160
#define MURK_ROW_TEXT_SIZE 4096
#define MURK_ROW_SUM_SIZE  33

typedef struct murk_study_value {
    char name[MURK_ROW_NAME_SIZE];
    char unit[24];
    murk_estimate of; /* NaN: there is none */
} murk_study_value;

typedef struct murk_study_sensor {
    murk_scene_name type;
    murk_vec3 position;
    double heading_deg, tilt_deg; /* NaN: sees all round */
} murk_study_sensor;

typedef struct murk_study_row {
    char failed[MURK_ROW_TEXT_SIZE]; /* why, in one line; empty: not */
    char note[MURK_ROW_TEXT_SIZE];   /* what is worth knowing; may be empty */
    uint64_t emitted;                /* photons; 0: none were traced */
    char fluence[MURK_ROW_SUM_SIZE]; /* checksum of its grid; empty: none */
    murk_study_value *value;         /* [values] */
    size_t values;
    murk_study_sensor *sensor; /* [sensors] the best plan for this row */
    size_t sensors;
} murk_study_row;

/* Fails with MURK_NO_MEMORY. */
murk_status murk_study_row_add(murk_study_row *row, const char *name,
                               const char *unit, murk_estimate of,
                               murk_error *err);
murk_status murk_study_row_set_sensors(murk_study_row *row,
                                       const murk_scene_desc *scene,
                                       const murk_pose *sensor, size_t n,
                                       murk_error *err);
/* Its sensors as poses[row->sensors] for free(), by the scene's types. Fails
 * with MURK_BAD_VALUE where the scene has no such type, or MURK_NO_MEMORY. */
murk_status murk_study_row_poses(murk_pose **out, const murk_study_row *row,
                                 const murk_scene_desc *scene, murk_error *err);
/* Puts a text behind the note, cut with "..." where it is full; "" changes
 * nothing. */
void murk_study_row_add_note(murk_study_row *row, const char *text);
/* Says in `failed` why. */
void murk_study_row_fail(murk_study_row *row, const murk_error *why);
/* The value of that name, or NULL. */
const murk_study_value *murk_study_row_get(const murk_study_row *row,
                                           const char *name);
void murk_study_row_release(murk_study_row *row);

/* Text for free(), NULL when out of memory; and from it. Numbers read back the
 * same. Release *out, also after a failure. */
char *murk_study_row_print(const murk_study_row *row);
murk_status murk_study_row_read(murk_study_row *out, const char *text,
                                size_t size, const char *source,
                                murk_error *err);

#endif
