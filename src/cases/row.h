/* The result of one row of a study: values by name with their errors, and the
 * sensors of its best plan. A row can be printed as text and read back with
 * equal bits, for messages between processes and for files. */
#ifndef MURK_CASES_ROW_H
#define MURK_CASES_ROW_H

#include "base/stats.h"
#include "base/status.h"
#include "scene/scene.h"
#include "sensing/sensor.h"

/* Bytes of a name (a tally, a suffix and a wavelength), of a note, and of a
 * checksum of 128 bits as hexadecimal text; each with the terminating 0. */
#define MURK_ROW_NAME_SIZE 160
#define MURK_ROW_TEXT_SIZE 4096
#define MURK_ROW_SUM_SIZE  33

typedef struct murk_study_value {
    char name[MURK_ROW_NAME_SIZE];
    char unit[24];
    murk_estimate of; /* NaN: the row has no such value */
} murk_study_value;

typedef struct murk_study_sensor {
    murk_scene_name type;
    murk_vec3 position;
    double heading_deg, tilt_deg; /* NaN: the type sees in all directions */
} murk_study_sensor;

typedef struct murk_study_row {
    char failed[MURK_ROW_TEXT_SIZE]; /* the reason, in one line; empty: the row
                                        has not failed */
    char note[MURK_ROW_TEXT_SIZE];   /* warnings and remarks; may be empty */
    uint64_t emitted;                /* photons; 0: none were traced */
    char fluence[MURK_ROW_SUM_SIZE]; /* checksum of the grid of the fluence
                                        rate; empty: none */
    murk_study_value *value;         /* [values] */
    size_t values;
    murk_study_sensor *sensor; /* [sensors] the best plan for this row */
    size_t sensors;
    bool lacks_memory; /* a value could not be added */
} murk_study_row;

/* Adds a value. A lack of memory is stored in the row; murk_study_row_check()
 * reports it after all values were added. */
void murk_study_row_add(murk_study_row *row, const char *name, const char *unit,
                        murk_estimate of);
/* Fails with MURK_NO_MEMORY if a value could not be added. */
murk_status murk_study_row_check(const murk_study_row *row, murk_error *err);
/* Replaces the sensors, in the coordinates of the user. Fails with
 * MURK_NO_MEMORY. */
murk_status murk_study_row_set_sensors(murk_study_row *row,
                                       const murk_scene_desc *scene,
                                       const murk_pose *sensor, size_t n,
                                       murk_error *err);
/* The sensors as poses in the coordinates of the scene. The caller frees the
 * array (*out)[row->sensors] with free(). Fails with MURK_BAD_VALUE if the
 * scene lacks a sensor type, or with MURK_NO_MEMORY. */
murk_status murk_study_row_poses(murk_pose **out, const murk_study_row *row,
                                 const murk_scene_desc *scene, murk_error *err);
/* Appends a text to a list of notes, "; " between. A text that does not fit is
 * cut, with "..." at the end; an empty text changes nothing. */
void murk_study_add_note(char notes[MURK_ROW_TEXT_SIZE], const char *text);
/* Marks the row as failed, for this reason. */
void murk_study_row_fail(murk_study_row *row, const murk_error *why);
/* The value of that name, or NULL. */
const murk_study_value *murk_study_row_get(const murk_study_row *row,
                                           const char *name);
void murk_study_row_release(murk_study_row *row);

/* murk_study_row_print() prints a line with the number and then the row as
 * text, which the caller frees; NULL when out of memory. murk_study_row_read()
 * reads the text that follows that line, and all numbers are equal to those
 * printed. murk_study_row_read() fails with MURK_BAD_FILE, or as
 * murk_yaml_parse(); `source` names the text in messages. Release *out also
 * after a failure. */
char *murk_study_row_print(const murk_study_row *row, size_t number);
murk_status murk_study_row_read(murk_study_row *out, const char *text,
                                size_t size, const char *source,
                                murk_error *err);

#endif
