/* A scene file, read and checked: plain structs in SI units, or in the unit
 * that ends the name of a member (_nm, _deg, _hpa, _min). Items such as media
 * keep their place in the file ("yard.yaml:12:5: media.fog") for later
 * messages.
 *
 * Keys and meanings: doc/reference. An unknown key is refused, with a
 * suggestion or the list of known keys. */
#ifndef MURK_SCENE_SCENE_H
#define MURK_SCENE_SCENE_H

#include "base/bands.h"
#include "base/calendar.h"
#include "base/detection.h"
#include "base/kinds.h"
#include "base/phase_kind.h"
#include "base/photometry.h"
#include "base/shape.h"
#include "base/source_type.h"
#include "base/status.h"
#include "base/vector.h"
#include "luminaire/lamp_spectrum.h"
#include "luminaire/luminaire.h"
#include "preset/preset.h"
#include "terrain/geotiff_request.h"
#include "weather/year.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sizes of names and places in bytes, with the '\0': 63 bytes for a name as
 * in MURK_NAME_SIZE, and a place that holds a file name, line, column and
 * key. */
#define MURK_SCENE_NAME_SIZE      64
#define MURK_SCENE_WHERE_SIZE     320
#define MURK_SCENE_LONG_NAME_SIZE 256 /* names of grids in files */

typedef char murk_scene_name[MURK_SCENE_NAME_SIZE];
typedef char murk_scene_where[MURK_SCENE_WHERE_SIZE];

/* A box, a sphere or a mesh, and how the shape is placed: rotated and scaled
 * about 0, then moved. */
typedef struct murk_scene_solid {
    murk_box box;
    murk_vec3 center; /* of the sphere */
    double radius_m;
    char *mesh;    /* path from the working folder; NULL for the other shapes */
    double unit_m; /* 0: the unit that the file states */
    char up;       /* 'x' 'y' 'z'; 0: the up axis that the file states */
    murk_vec3 rotate_deg, translate_m;
    double scale;
} murk_scene_solid;

/* The map from the coordinates of the solid to those of the scene. */
static inline murk_affine murk_scene_placed(const murk_scene_solid *s)
{
    return murk_affine_place(s->rotate_deg, s->scale, s->translate_m);
}

/* The unit of heights in a file; 0: as the file says. */
typedef enum murk_scene_height_unit {
    MURK_SCENE_HEIGHT_M = 1,
    MURK_SCENE_HEIGHT_CM,
    MURK_SCENE_HEIGHT_FT,
    MURK_SCENE_HEIGHT_US_FT
} murk_scene_height_unit;

typedef struct murk_scene_geometry {
    murk_scene_name name; /* unique; empty: none */
    murk_scene_where where;
    murk_shape shape;
    murk_scene_solid solid;
    char *allow;     /* a further folder in which the file of the mesh may open
                        other files; NULL: only the folder of that file */
    bool is_fds;     /* the file of the mesh is the .smv file of an FDS run */
    double time_s;   /* of that run */
    bool is_geotiff; /* the file of the mesh is a GeoTIFF file of elevations */
    murk_geotiff_asked geotiff; /* without the frame, which is that of the site
                                 */
    int height_unit;            /* murk_scene_height_unit */
    murk_vec3 corner, edge1, edge2; /* of a rectangle */
    int material; /* index into materials; -1: not given: a mesh has the
                   * materials that its file names, any other shape `default` */
} murk_scene_geometry;

typedef struct murk_scene_material { /* [0] is `default` */
    murk_scene_name name;
    murk_scene_where where;
    murk_spectrum diffuse, specular, transmit;
    double ior; /* 0: none */
} murk_scene_material;

typedef struct murk_scene_phase {
    murk_scene_where where; /* of the map, or of the medium if a preset gives
                             * the phase function; empty for words */
    murk_phase_kind kind;
    murk_spectrum mean_cosine;            /* of MURK_PHASE_HG */
    double value[MURK_PHASE_NUMBERS_MAX]; /* of the other kinds that have
                                           * numbers */
    char *table; /* of MURK_PHASE_TABLE: CSV file, path from the working folder
                  */
    murk_mixture *mixture; /* of a preset, with kind MURK_PHASE_TABLE: a sum of
                            * phase functions; else NULL */
} murk_scene_phase;

/* Longer lists belong into files. */
#define MURK_SCENE_LIST_MAX 65536

typedef struct murk_scene_numbers {
    size_t n;
    double *value;
} murk_scene_numbers;

typedef struct murk_scene_indices {
    size_t n;
    size_t *index;
} murk_scene_indices;

typedef struct murk_scene_spectra {
    size_t n;
    murk_spectrum *value;
} murk_scene_spectra;

/* A medium. With a preset, the properties that the scene does not give come
 * from the preset. */
typedef struct murk_scene_medium {
    murk_scene_name name;
    murk_scene_where where;
    char *preset;     /* name; NULL: none */
    murk_words words; /* words of the preset, defaults included */
    murk_spectrum extinction_per_m, albedo;
    murk_scene_phase phase[MURK_BANDS_MAX];
    size_t n_phases;   /* 1: the same in all bands; otherwise one per band */
    char *vdb;         /* path from the working folder; NULL: no grid of
                        * densities */
    char *grid;        /* name; NULL: the only density of the file, or the one
                        * named `density` */
    bool is_linear;    /* interpolation: linear; false: nearest */
    char *albedo_grid; /* name; NULL: the constant `albedo` */
    char *albedo_vdb;  /* file of the albedo grid; NULL: no albedo grid */
    bool has_frame;    /* the files belong to a sequence in time */
    double frame;   /* the time, counted in frames: floor(frame) is the number
                     * in vdb and albedo_vdb */
    char *vdb_next; /* path of the next frame's densities; NULL: `frame` is
                     * whole */
    double next_weight; /* of the densities of vdb_next, frame - floor(frame);
                         * vdb has the weight 1 - next_weight */
    char *vdb_frames;   /* pattern of the files' names; NULL: no frames */
    char *fds;          /* path of the .smv file of an FDS run; NULL: none */
    int fds_quantity;   /* murk_fds_quantity (fds/extinction.h) */
    murk_scene_numbers fds_mesh; /* numbers of meshes, from 1; n 0: all */
    double time_s;               /* of the run, or of the NetCDF file */
    char *netcdf;                /* path of a NetCDF file; NULL: none */
    char *liquid_water, *effective_radius, *variable; /* names of variables;
                                                       * NULL: not given */
    double effective_radius_um;                       /* 0: a variable */
    double effective_variance; /* of the droplets of a NetCDF file, whose albedo
                                * and phase function follow from the file:
                                * `albedo` and `phase` here have no meaning; 0:
                                * they count */
    double per_unit; /* extinction for one unit of `variable` [1/m], or by_word
                      * the factor to the unit of the word */
    bool by_word;    /* `variable` is the amount of a word of the preset:
                      * extinction_per_m is that of the words as they are, and
                      * the law gives the density for each value */
    int word;        /* murk_word_id */
    struct {
        size_t n;
        double *value, *density; /* [n] */
    } law;
    bool has_within;    /* only the part of the NetCDF file in the next box */
    double within_m[4]; /* x and y from, x and y to, without the placement of
                         * the region */
    murk_scene_numbers profile_z_m; /* n 0: no profile */
    murk_scene_spectra profile_per_m;
} murk_scene_medium;

/* True if the filling of the medium states the extinction by itself [1/m]; then
 * extinction_per_m has no meaning. */
static inline bool murk_scene_states_extinction(const murk_scene_medium *m)
{
    return m->profile_z_m.n > 0 || m->fds || (m->netcdf && !m->by_word);
}

typedef struct murk_scene_region {
    murk_scene_where where;
    size_t medium; /* index */
    murk_region_shape shape;
    murk_scene_solid solid;
    double below_z_m;
    bool replaces;
    double ior;          /* 0: none */
    double wind_m_per_s; /* over a half space; 0: a flat surface */
} murk_scene_region;

/* A place on the earth and a time: of the scene, or of a light of the sky,
 * which has its own or takes that of the scene. */
typedef struct murk_scene_site {
    murk_scene_where where;
    bool has_latitude, has_longitude, has_altitude, has_pressure, has_time;
    double latitude_deg, longitude_deg; /* north and east positive */
    double altitude_m;
    double pressure_hpa; /* no meaning unless has_pressure: the pressure then
                          * follows from the altitude (world/sky.c) */
    double temperature_c;
    double unix_s; /* seconds since 1970, UTC; no meaning unless has_time */
    int zone_min;  /* of local clocks, minutes east of Greenwich */
    bool has_zone, has_date, has_clock;
    murk_date date; /* local date and time of day, if the time is given in these
                       parts */
    double clock_s;
} murk_scene_site;

/* The weather: a weather year, or one report. */
typedef struct murk_scene_weather {
    murk_scene_where where;
    bool given;
    char *epw, *metar, *synop; /* path or text; one of them is given */
    murk_weather_year *year;   /* contents of epw, while the scene is read; then
                                * NULL */
    bool is_chosen;            /* the observation was asked for */
    murk_observation seen;     /* at the time of the scene */
    int line;                  /* of the row in the file; 0: a report */
} murk_scene_weather;

typedef enum murk_scene_shining {
    MURK_SCENE_ALWAYS,
    MURK_SCENE_NIGHT, /* while the sun is down */
    MURK_SCENE_NEVER,
    MURK_SCENE_BY_CLOCK
} murk_scene_shining;

/* More spans of a day than any schedule needs. */
#define MURK_SCENE_SPANS_MAX 16

typedef struct murk_scene_schedule {
    murk_scene_shining when;
    size_t spans;
    double from_s[MURK_SCENE_SPANS_MAX]; /* local, since midnight */
    double to_s[MURK_SCENE_SPANS_MAX]; /* less than from_s: the span ends after
                                          midnight */
} murk_scene_schedule;

typedef enum murk_scene_cover {
    MURK_SCENE_CLEAR,
    MURK_SCENE_INTERMEDIATE,
    MURK_SCENE_OVERCAST
} murk_scene_cover;

typedef struct murk_scene_portal { /* light passes towards edge1 x edge2 */
    murk_scene_where where;
    murk_vec3 corner, edge1, edge2;
} murk_scene_portal;

/* Photon records store the number of a light in 8 bits. */
#define MURK_SCENE_LIGHTS_MAX 256

/* Rows and columns of lamps that are alike. The lamp of row i and column j
 * stands i * step1 + j * step2 away from the first. */
typedef struct murk_scene_array {
    size_t count[2]; /* 1 or more */
    murk_vec3 step1, step2;
} murk_scene_array;

typedef struct murk_scene_light {
    murk_scene_where where;
    murk_source_type type;
    size_t part; /* sun or sky of a light of type daylight: the number, from 1,
                  * of the place or patch (base/daylight_parts.h); 0: a light by
                  * itself */
    size_t item; /* number of the item of the scene file: an array is one item
                  * and several lights */
    murk_vec3 position; /* center, corner, position or origin */
    murk_vec3 edge1, edge2;
    murk_vec3 direction; /* luminaire: the aim */
    double radius_m, divergence_rad;
    murk_scene_array array; /* of the first lamp; count 0: a single lamp */
    /* luminaires: */
    char *file;
    murk_luminaire *luminaire; /* contents of the file */
    murk_vec3 c0;              /* direction of C = 0 at roll 0 */
    bool has_c0;               /* false: by the rule of world/lamp_shape.h */
    double roll_rad;
    bool has_size; /* the opening of the file; false: a point */
    double lumens; /* the flux; without the key that of the file */
    bool has_lumens;
    double tilt_factor; /* by which the flux of the file is multiplied */
    /* lamps and directional light: */
    char *spectrum_file;
    double temperature_k;
    murk_lamp_spectrum *spectrum; /* of either; NULL: even in wavelength */
    murk_spectrum power_w; /* per band; for directional light and lights of the
                              sky an irradiance [W/m2] */
    murk_scene_schedule schedule;
    murk_scene_portal *portal; /* [portals] distant light enters through these;
                                * none: everywhere */
    size_t portals;
    /* of the sky: */
    murk_scene_site site;  /* place and time of the light; parts that the light
                            * does not give are those of the scene */
    bool has_irradiance;   /* power_w is given; false: it is modelled */
    bool irradiance_total; /* power_w.band[0] is the total of all bands, to be
                            * spread by the spectrum of the source */
    double linke_turbidity;
    murk_scene_cover cover; /* sun, moon, sky */
    bool by_weather;        /* irradiance and sky are those of the weather, and
                             * `cover` follows from its clouds */
    uint64_t cie_type;      /* sky: 1..15; 0: chosen by `cover` */
    double mag_per_arcsec2; /* night sky, at the zenith */
} murk_scene_light;

/* True for sun, moon, sky and night sky. All but the night sky need a place and
 * a time. */
static inline bool murk_scene_light_is_of_sky(const murk_scene_light *light)
{
    const murk_source_group group = murk_source_type_group(light->type);
    return group == MURK_SOURCE_BODY || group == MURK_SOURCE_DOME;
}

static inline bool murk_scene_light_is_distant(const murk_scene_light *light)
{
    return murk_source_type_group(light->type) != MURK_SOURCE_LAMP;
}

typedef enum murk_scene_maps {
    MURK_SCENE_MAPS_BOTH,
    MURK_SCENE_MAPS_SURFACE,
    MURK_SCENE_MAPS_VOLUME,
    MURK_SCENE_MAPS_NONE
} murk_scene_maps;

typedef struct murk_scene_photons {
    murk_scene_where where;
    uint64_t emit, store; /* one of the two is 0 */
    bool store_hits;      /* store_when: hit; false: reflected */
    double least_weight;  /* 1: roulette alone */
    murk_scene_maps maps;
    uint64_t max_stored;
} murk_scene_photons;

typedef struct murk_scene_tally {
    murk_scene_name name;
    murk_scene_where where;
    murk_tally_type type;
    murk_vec3 point, normal; /* plane */
    size_t bins[2], angle_bins;
    murk_box box; /* grid */
    size_t size[3];
    murk_vec3 center; /* sphere */
    double radius_m;
    bool hemispheres;
} murk_scene_tally;

typedef enum murk_scene_projection {
    MURK_SCENE_PERSPECTIVE,
    MURK_SCENE_EQUIRECTANGULAR,
    MURK_SCENE_ORTHOGRAPHIC
} murk_scene_projection;

typedef struct murk_scene_camera {
    murk_scene_name name;
    murk_scene_where where;
    murk_scene_projection projection;
    murk_vec3 from;
    bool has_to; /* false: all round, with north in the middle */
    murk_vec3 to;
    murk_vec3 up;     /* perspective, orthographic */
    double vfov_rad;  /* perspective */
    double width_m;   /* orthographic; of the picture */
    size_t pixels[2]; /* width, height */
    size_t samples;   /* per pixel */
    bool has_clip;    /* a plane hides everything on the side of the plane on
                       * which the camera is */
    murk_vec3 clip_point, clip_normal; /* of the plane; the normal is not zero
                                        */
} murk_scene_camera;

typedef struct murk_scene_site_zone { /* a zone in which sensors may or may not
                                         be */
    murk_scene_where where;
    murk_region_shape shape;
    murk_scene_solid solid;
} murk_scene_site_zone;

typedef struct murk_scene_points {
    murk_scene_where where;
    bool given;
    char **file; /* [files] CSV files, paths from the working folder */
    size_t files;
    murk_vec3 *position; /* [positions] listed in the scene; after the files */
    size_t positions;
} murk_scene_points;

typedef enum murk_scene_facing {
    MURK_SCENE_FACING_ANY,
    MURK_SCENE_FACING_UP,
    MURK_SCENE_FACING_DOWN,
    MURK_SCENE_FACING_SIDE
} murk_scene_facing;

typedef struct murk_scene_mount {
    murk_scene_where where;
    murk_scene_indices materials; /* n 0: all surfaces */
    double offset_m, spacing_m;
    bool has_band; /* of heights: band_m[0] to band_m[1] */
    double band_m[2];
    murk_scene_facing facing;
} murk_scene_mount;

typedef struct murk_scene_candidates {
    murk_scene_where where; /* of `sensors.candidates` */
    bool has_grid;
    murk_scene_where grid_where; /* of `sensors.candidates.grid` */
    murk_vec3 grid_min, grid_max;
    size_t grid_size[3];
    murk_scene_points points;
    murk_scene_mount *mount; /* [mounts]; 0: none */
    size_t mounts;
    double clearance_m;
    murk_scene_site_zone *avoid, *within;
    size_t avoids, withins;
} murk_scene_candidates;

typedef struct murk_scene_sensor_type {
    murk_scene_name name; /* unique */
    murk_scene_where where;
    double least_range_m, range_m;
    murk_view view;
    double cone_rad, hfov_rad, vfov_rad; /* whole angles */
    uint64_t headings; /* number of equally spaced headings from north; 0: the
                        * headings are headings_deg, or the type sees in all
                        * directions */
    murk_scene_numbers headings_deg,
        tilts_deg;         /* tilts n 0: the type sees in all directions */
    double acceptance_rad; /* half angle; 0: none */
    bool toward;           /* arrival: toward */
    double aperture_m2, quantum_efficiency, exposure_s; /* detection: power */
    double target_m2, target_m3;
    murk_scene_numbers bands_nm; /* n 0: all */
    uint32_t bands;              /* bands_nm as a bit set of band indices; 0:
                                  * all */
    double cost;
    uint64_t min_count, max_count;
} murk_scene_sensor_type;

typedef struct murk_scene_fixed_sensor {
    murk_scene_where where;
    murk_scene_name type_name; /* as given; may be empty */
    size_t type;
    murk_vec3 position;
    double heading_rad, tilt_rad;
    bool is_failed; /* of a timeline, by the time of the scene */
    size_t number;  /* in the list of the scene file, from 0 */
} murk_scene_fixed_sensor;

typedef struct murk_scene_sensors {
    murk_scene_where where; /* of `sensors` */
    bool given;             /* the scene has sensors */
    murk_scene_sensor_type *type;
    size_t types;
    murk_scene_fixed_sensor *fixed;
    size_t n_fixed;
    size_t fixed_listed; /* n_fixed, with those that have failed, which are
                          * fixed[n_fixed] to fixed[fixed_listed - 1] */
    bool one_per_site;
    murk_scene_candidates candidates;
    double spacing_m; /* smallest distance between sensors */
    uint64_t count;   /* without sensors that have failed; 0: not given, or all
                       * have failed */
    bool all_failed;  /* a count was given, and so many sensors have failed */
    double target;    /* coverage 0..1; 0: not given */
    double budget;    /* in the units of the types' costs; 0: not given */
} murk_scene_sensors;

typedef struct murk_scene_interest { /* a region of interest */
    murk_scene_name name;
    murk_scene_where where;
    double weight;
    murk_region_shape shape;
    murk_scene_solid solid;
    int material, medium; /* index; -1: any */
} murk_scene_interest;

/* Targets that plans cover in place of photons. */
typedef struct murk_scene_targets {
    murk_scene_where where;
    bool given; /* false: photons */
    bool has_surfaces;
    murk_scene_where surfaces_where;
    murk_scene_indices materials; /* n 0: all */
    uint64_t surface_points;      /* 0: by the spacing */
    double surface_spacing_m;
    bool has_volume;
    murk_scene_where volume_where;
    murk_region_shape shape; /* EVERYWHERE: all of the domain */
    murk_scene_solid solid;
    int medium;             /* only inside this medium; -1: anywhere */
    uint64_t volume_points; /* 0: by the spacing */
    double volume_spacing_m;
    char *points;   /* path from the working folder; NULL: none listed */
    double band_nm; /* 0: the first band */
} murk_scene_targets;

typedef enum murk_scene_knowledge {
    MURK_SCENE_KNOWN,
    MURK_SCENE_UNKNOWN,
    MURK_SCENE_EXPLORE
} murk_scene_knowledge;

typedef enum murk_scene_objective {
    MURK_SCENE_OBJECTIVE_NONE, /* the scene itself, without conditions */
    MURK_SCENE_OBJECTIVE_MEAN, /* mean over the conditions */
    MURK_SCENE_OBJECTIVE_WORST,
    MURK_SCENE_OBJECTIVE_REGRET
} murk_scene_objective;

typedef enum murk_scene_through {
    MURK_SCENE_THIN, /* sheets attenuate; refracting boundaries block */
    MURK_SCENE_BLOCK,
    MURK_SCENE_REFRACT /* like MURK_SCENE_THIN, and sightlines may cross one
                        * flat refracting boundary */
} murk_scene_through;

typedef struct murk_scene_placement {
    murk_scene_where where;
    murk_place_method method;
    murk_detection detection;
    double threshold;          /* of transmittance, for detection: threshold */
    double power_radius_m;     /* for detection: power; 0: not given */
    uint64_t power_neighbours; /* number of neighbours if no radius is given */
    uint64_t redundancy;       /* the largest number of sensors that count for a
                                * photon */
    uint64_t at_least; /* with a target: a photon counts towards the target only
                        * if at least this number of sensors detect the photon;
                        * 0: not used */
    bool by_normal;    /* visibility: normal; false: ray */
    murk_scene_through through;
    murk_scene_knowledge knowledge;
    bool has_start;
    murk_vec3 start;   /* explore: the first position */
    char *start_plan;  /* file with the plan at which a search begins: path from
                        * the working folder; NULL: none */
    bool limits_moves; /* the next is given */
    uint64_t moves_max;   /* sensors that a plan may move from the start plan
                           */
    double move_cost;     /* coverage that each of these moves costs */
    uint64_t steps_ahead; /* steps of the timeline that a plan is chosen for */
    uint64_t restarts, nodes;
    double time_limit_s; /* of the making of a plan; 0: no limit */
    double memory_mb;    /* MiB of rows in memory */
    bool balanced;       /* weights: balanced; false: the two weights below */
    double weight_surface, weight_volume;
    murk_scene_interest *interest; /* at most 64 */
    size_t n_interests;
    double elsewhere; /* weight of photons in no region of interest */
    murk_scene_targets targets;
    bool hold_out;
    double jitter_m, jitter_rad; /* largest displacement of a sensor from the
                                  * planned position and direction, for the
                                  * robustness of a plan; both 0: not
                                  * evaluated */
    uint64_t jitter_draws;
    murk_scene_objective over;
    bool relative_regret; /* regret: relative */
} murk_scene_placement;

/* How a value between two keyframes, or between two files of a sequence,
 * follows from both. */
typedef enum murk_between {
    MURK_BETWEEN_LINEAR,  /* numbers are interpolated; any other value holds */
    MURK_BETWEEN_NEAREST, /* that of the nearer time; halfway, of the later */
    MURK_BETWEEN_HOLD     /* that of the earlier time */
} murk_between;

typedef enum murk_track_kind {
    MURK_TRACK_GEOMETRY, /* moves an item of the geometry */
    MURK_TRACK_MEDIUM,   /* chooses the files of a sequence of grids */
    MURK_TRACK_KEY,      /* sets any key of the scene */
    MURK_TRACK_SENSOR    /* moves a sensor, or ends it */
} murk_track_kind;

/* More steps than any sequence needs. */
#define MURK_TIMELINE_STEPS_MAX 1000000

/* Something that changes in the course of the timeline. scene/timeline.h puts
 * the values of keyframes in place, before the structs of a scene are filled.
 */
typedef struct murk_scene_track {
    murk_scene_where where;
    murk_track_kind kind;
    murk_between between;
    murk_scene_name item;     /* geometry: name or index, as given */
    murk_scene_numbers light; /* geometry: indices of lights that move along */
    murk_scene_name medium;
    char *frames; /* medium: pattern of files; NULL: that of the medium */
    bool has_first;
    uint64_t first_frame; /* medium: number of the file at from_s */
    double from_s, every_s;
    char *key;
    uint64_t sensor; /* index among the sensors of a plan, fixed ones first */
    bool fails;
    double fails_at_s;
    struct murk_scene_keyframe *keyframe; /* [keyframes] */
    size_t keyframes;
} murk_scene_track;

typedef struct murk_scene_keyframe {
    double t_s;
    murk_vec3 translate_m, rotate_deg; /* geometry */
    murk_vec3 position_m;              /* sensors of `fixed` */
    murk_vec3 offset_m;                /* other sensors: their drift */
    double heading_offset_rad, tilt_offset_rad;
} murk_scene_keyframe;

/* The times of a scene that changes, in seconds after site.time. */
typedef struct murk_scene_timeline {
    murk_scene_where where;
    bool given;
    double from_s, to_s, every_s; /* no meaning if times_s.n > 0 */
    murk_scene_numbers times_s;
    bool has_at;
    double at_s; /* the time at which the scene is read; unless has_at that of
                  * the first step */
    bool from_start_plan; /* search_from: start_plan; false: before */
    murk_scene_track *track;
    size_t tracks;
} murk_scene_timeline;

/* Each condition may have a traced light of its own; 64 bounds memory and time,
 * and is the number of blocks that a search takes (MURK_BLOCKS_MAX in
 * placement/blocks.h). */
#define MURK_SCENE_CONDITIONS_MAX 64

typedef struct murk_scene_desc murk_scene_desc;

typedef struct murk_scene_condition {
    murk_scene_name name; /* letters, digits, - and _; not mean, worst, regret
                           * or scene */
    murk_scene_where where;
    double weight; /* from placement.condition_weights; 1 if none is given */
    murk_scene_desc *scene; /* the scene with the overrides of the condition,
                               without conditions; places in it read
                               "yard.yaml:12:5: conditions.fog.media.a" */
} murk_scene_condition;

/* A key that the user has set and that has no effect. */
typedef struct murk_scene_idle {
    murk_scene_where where;
    const char *text; /* why */
} murk_scene_idle;

struct murk_scene_desc {
    char *path;             /* as given */
    char sha256[65];        /* of the file's bytes */
    murk_scene_where where; /* in the scene of a condition: the place of the
                               condition, for messages about the whole scene;
                               empty in other scenes */
    int bands;
    double band_nm[MURK_BANDS_MAX]; /* lines, or middles of edges */
    double band_edge_nm[MURK_BANDS_MAX + 1];
    bool has_edges;
    uint32_t seed;
    murk_vec3 north; /* horizontal unit vector */
    murk_scene_weather weather;
    murk_scene_site site;
    murk_scene_timeline timeline;
    murk_vec3 origin; /* the local origin, in the coordinates of the file: all
                       * positions in these structs are relative to this origin;
                       * 0 unless the scene is far from 0 (scene/origin.h) */
    bool has_domain;
    murk_domain domain;
    bool continues; /* domain.outside: continued; false: empty */
    murk_scene_where domain_where;
    murk_scene_geometry *geometry;
    size_t geometries;
    murk_scene_material *materials;
    size_t n_materials;
    murk_scene_medium *media;
    size_t n_media;
    murk_scene_region *regions;
    size_t n_regions;
    murk_scene_light *lights;
    size_t n_lights;
    murk_scene_photons photons;
    bool by_delta;       /* flight: delta; false: march */
    murk_quantity units; /* units of results for users */
    murk_scene_tally *tallies;
    size_t n_tallies;
    murk_scene_sensors sensors;
    murk_scene_placement placement;
    murk_scene_camera *cameras;
    size_t n_cameras;
    murk_scene_condition *conditions;
    size_t n_conditions;
    bool
        are_conditions_steps; /* of the timeline: murk_timeline_add_conditions()
                               */
    char *resolved;  /* the resolved scene, with overrides and defaults written
                        out and absolute paths, as YAML that gives the same scene
                        when read from any folder */
    char *light_key; /* the part of the resolved scene that the traced light
                      * depends on, with names of files without folders, and
                      * the properties computed from presets. Two scenes give
                      * the same light if their keys, the checksums of those
                      * files, and the files that their meshes name (buffers of
                      * glTF, mtllib of OBJ) are equal */
    char *rules_key; /* the part of the resolved scene that has neither light
                      * sources, surfaces and media nor what needs no light to
                      * be traced again: if two scenes have equal ones, their
                      * light differs only by the former */
    char *world_key; /* light_key without the keys `lights` and `site`: if two
                      * scenes have the same world_key and equal files, as for
                      * light_key, their light differs only by the light
                      * sources */
    char *whole_key; /* the resolved scene and conditions, with names of files
                      * without folders, and the properties computed from
                      * presets. Two scenes give the same results if their keys
                      * and their files, as for light_key, are equal */
    murk_scene_idle *idle; /* [idles] keys without effect in the scene and in
                            * every condition, and media that no region uses */
    size_t idles;
    char **file; /* [files] absolute paths of the files that the scene names;
                  * for frames the pattern */
    size_t files;
};

/* murk_scene_user() converts a position relative to the local origin to the
 * coordinates of the scene file and of results; murk_scene_local() converts
 * back. */
static inline murk_vec3 murk_scene_user(const murk_scene_desc *scene,
                                        murk_vec3 local)
{
    return murk_add(local, scene->origin);
}

static inline murk_vec3 murk_scene_local(const murk_scene_desc *scene,
                                         murk_vec3 user)
{
    return murk_sub(user, scene->origin);
}

static inline murk_box murk_scene_user_box(const murk_scene_desc *scene,
                                           murk_box local)
{
    return (murk_box){murk_scene_user(scene, local.min),
                      murk_scene_user(scene, local.max)};
}

/* True if an item of the geometry is the ground of a file of elevations. */
bool murk_scene_has_ground(const murk_scene_desc *scene);

/* One --set, or an option that stands for one ("seed=3"). */
typedef struct murk_override {
    const char *text;   /* KEY=VALUE, VALUE in YAML flow */
    const char *option; /* as the user typed it, for messages: "--seed 3"; NULL:
                           "--set " and the text */
} murk_override;

/* Reads a scene. The caller owns *out and releases it with
 * murk_scene_desc_destroy(). Overrides are applied in order before anything is
 * checked; messages about them name the option. If two keys exclude each other
 * (photons.emit, photons.store), the key on the command line replaces that of
 * the scene; both on the command line are an error. Paths in the scene are
 * relative to the folder of the scene file, paths in overrides to the working
 * folder. Files named in the scene are not opened. Fails with MURK_BAD_FILE,
 * MURK_BAD_VALUE or MURK_NO_MEMORY. */
murk_status murk_scene_desc_read(murk_scene_desc **out, const char *path,
                                 const murk_override *overrides,
                                 size_t n_overrides, murk_error *err);
/* Like murk_scene_desc_read(), for the text of a scene: `path` is the name in
 * messages, and paths in the scene are relative to the folder of `path`. */
murk_status murk_scene_desc_parse(murk_scene_desc **out, const char *text,
                                  const char *path,
                                  const murk_override *overrides,
                                  size_t n_overrides, murk_error *err);
void murk_scene_desc_destroy(murk_scene_desc *scene); /* NULL is fine */

/* Reads the value of an override by the row of the key table into the member of
 * *out, for a command without a scene file. The key must be in the table and be
 * stored without memory of its own: a number, a count or a word. Fails with
 * MURK_BAD_VALUE, MURK_BAD_FILE or MURK_NO_MEMORY. */
murk_status murk_scene_override_read(murk_scene_desc *out,
                                     const murk_override *override,
                                     murk_error *err);

/* The index of the band of a wavelength: the band with exactly this line, or
 * the band whose lower edge is at or below and whose upper edge is above the
 * wavelength; -1: none. */
int murk_scene_band_of(const murk_scene_desc *scene, double nm);

/* The word that stands for a value of a key, such as "worst" for
 * "placement.over" and MURK_SCENE_OBJECTIVE_WORST; NULL: no word does. `path`
 * must be that of a key with words. */
const char *murk_scene_word(const char *path, int value);

#endif
