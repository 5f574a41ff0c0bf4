/* Reads weather years (EPW): lines of the header, of which LOCATION and DATA
 * PERIODS count, then rows of cells between commas. All rows have as many cells
 * as the first, and every cell that is used is checked. */
#include "weather/year.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/csv.h"
#include "base/file.h"
#include "base/number.h"
#include "base/words.h"

#define CELLS_MAX 35 /* of a row, by the data dictionary */
#define CELLS_MIN                                                 \
    29 /* of older files, which end behind the precipitable water \
        */
#define HEADER_MAX   64 /* lines; the dictionary has 8 */
#define HOUR_MIN     60
#define UNLIMITED_KM 777.7 /* an unlimited visibility */
#define OFFSET_W_PER_M2                                                       \
    (-7.0) /* reading of a pyranometer of class A by the thermal radiation of \
            * the night sky (ISO 9060:2018, zero offset a) */
#define DAY_MIN  (24 * HOUR_MIN)
#define MINUTE_S 60.0
#define DAY_S    86400.0

/* Columns of a row, from 0. */
enum {
    YEAR,
    MONTH,
    DAY,
    HOUR,
    MINUTE,
    TEMPERATURE = 6,
    DEW_POINT,
    HUMIDITY,
    PRESSURE,
    GLOBAL = 13,
    DIRECT,
    DIFFUSE,
    SKY_COVER = 22,
    VISIBILITY = 24,
    OBSERVED = 26,
    CODES,
    RAIN = 33,
    RAIN_HOURS
};

typedef struct epw {
    const char *path;
    murk_csv csv;
    size_t line; /* of the row that is read */
    murk_error *err;
    murk_weather_year *out;
    size_t reserved;
    size_t cells; /* of each row; 0: no row was read yet */
    int periods;  /* stretches of rows, by DATA PERIODS */
    int first_month, first_day, last_month,
        last_day; /* of the first and the last stretch; 0: not stated */
    char *cell[CELLS_MAX];
} epw;

static murk_status fail(const epw *f, size_t line, const char *text)
{
    char where[4096];
    snprintf(where, sizeof where, "%s:%zu", f->path, line);
    return murk_fail(f->err, MURK_BAD_FILE, where, "%s", text);
}

/* Fails with "NAME TEXT, must be ALLOWED". */
static murk_status fail_cell(const epw *f, const char *name, const char *text,
                             const char *allowed)
{
    char shown[40], message[256];
    murk_words_show(shown, sizeof shown, text);
    snprintf(message, sizeof message, "%s is '%s', must be %s", name, shown,
             allowed);
    return fail(f, f->line, message);
}

/* ---- cells ---- */

/* Reads the cells of the next line; the cells behind the last are "". */
static murk_status read_cells(epw *f, size_t *n)
{
    static char empty[] = "";
    bool is_last = false;
    f->line = f->csv.line;
    for (*n = 0; !is_last; ++*n) {
        char *cell;
        const char *fault = murk_csv_read_cell(&f->csv, &cell, &is_last);
        if (fault) {
            return fail(f, f->csv.line, fault);
        }
        if (*n < CELLS_MAX) {
            f->cell[*n] = cell;
        }
    }
    for (size_t k = *n; k < CELLS_MAX; ++k) {
        f->cell[k] = empty;
    }
    return MURK_OK;
}

/* A column with its name, the range of its values, and the value that stands
 * for a missing one. */
typedef struct column {
    const char *name;
    int cell;
    double min, max, missing;
} column;

/* True for the number of a missing value, or a larger one of nines alone: other
 * programs write 99999.9 where the dictionary has 9999. */
static bool is_missing(const column *c, const char *text, double value)
{
    const size_t nines = strspn(text, "9");
    const char *rest = text + nines;
    return value == c->missing ||
           (value > c->missing && nines > 0 &&
            (*rest == '\0' ||
             (*rest == '.' && strspn(rest + 1, "09") == strlen(rest + 1))));
}

/* Reads a number; NAN if the cell is empty or says that it is missing. */
static murk_status read_number(const epw *f, const column *c, double *out)
{
    const char *text = f->cell[c->cell];
    double value = NAN;
    char allowed[80];
    *out = NAN;
    if (text[0] == '\0' ||
        (murk_number_parse(text, &value) && is_missing(c, text, value))) {
        return MURK_OK;
    }
    if (value >= c->min && value <= c->max) {
        *out = value;
        return MURK_OK;
    }
    snprintf(allowed, sizeof allowed, "a number, %g..%g, or %g where missing",
             c->min, c->max, c->missing);
    return fail_cell(f, c->name, text, allowed);
}

static murk_status read_whole(const epw *f, const char *name, int cell, int min,
                              int max, int *out)
{
    double value;
    char allowed[64];
    if (murk_number_parse(f->cell[cell], &value) && value == floor(value) &&
        value >= min && value <= max) {
        *out = (int)value;
        return MURK_OK;
    }
    snprintf(allowed, sizeof allowed, "a whole number, %d..%d", min, max);
    return fail_cell(f, name, f->cell[cell], allowed);
}

/* ---- the header ---- */

static murk_status read_location(epw *f)
{
    static const column latitude = {"the latitude", 6, -90, 90, INFINITY},
                        longitude = {"the longitude", 7, -180, 180, INFINITY},
                        zone = {"the time zone", 8, -18, 18, INFINITY},
                        altitude = {"the elevation", 9, -1000, 9999.9,
                                    INFINITY};
    murk_weather_year *out = f->out;
    double zone_h = NAN;
    size_t n;
    murk_status status = read_cells(f, &n);
    if (!status && (n < 10 || strcmp(f->cell[0], "LOCATION") != 0)) {
        return fail(f, f->line,
                    "must begin with LOCATION and have 10 cells (an EPW file)");
    }
    /* The four numbers, none of which may miss. */
    if (!status) {
        status = read_number(f, &latitude, &out->latitude_deg);
    }
    if (!status) {
        status = read_number(f, &longitude, &out->longitude_deg);
    }
    if (!status) {
        status = read_number(f, &zone, &zone_h);
    }
    if (!status) {
        status = read_number(f, &altitude, &out->altitude_m);
    }
    if (!status && isnan(out->latitude_deg + out->longitude_deg + zone_h +
                         out->altitude_m)) {
        return fail(f, f->line,
                    "LOCATION lacks a number, must have latitude, longitude, "
                    "time zone and elevation");
    }
    out->zone_min = status ? 0 : (int)lround(zone_h * HOUR_MIN);
    return status;
}

/* Reads month and day, with a year behind them in some files. Other forms are
 * passed over, and leave 0. */
static void take_date(const char *text, int *month, int *day)
{
    int m, d;
    if (sscanf(text, "%2d/%2d", &m, &d) == 2) {
        *month = m;
        *day = d;
    }
}

/* Takes the begin of the first period and the end of the last from the cells of
 * DATA PERIODS: for each a name, the day of the week, begin and end. */
static void take_ends(epw *f)
{
    const int begin = 5, per_period = 4; /* cells */
    const int end = begin + 1 + per_period * (f->periods - 1);
    take_date(f->cell[begin], &f->first_month, &f->first_day);
    if (end < CELLS_MAX) {
        take_date(f->cell[end], &f->last_month, &f->last_day);
    }
}

/* Reads the lines between LOCATION and the rows; DATA PERIODS is the last of
 * them and says how many rows an hour has. */
static murk_status read_header(epw *f)
{
    static const char last[] = "DATA PERIODS";
    murk_status status = read_location(f);
    for (int i = 0; !status && i < HEADER_MAX; ++i) {
        int per_hour = 0;
        size_t n;
        /* Pass over other lines. */
        if (f->csv.next >= f->csv.end) {
            break;
        }
        if (strncmp(f->csv.next, last, sizeof last - 1) != 0) {
            f->csv.next += strcspn(f->csv.next, "\n");
            f->csv.next += f->csv.next < f->csv.end;
            ++f->csv.line;
            continue;
        }
        status = read_cells(f, &n);
        if (!status) {
            status = read_whole(f, "the number of data periods", 1, 1, DAY_MIN,
                                &f->periods);
        }
        if (!status) {
            status = read_whole(f, "the number of rows of an hour", 2, 1,
                                HOUR_MIN, &per_hour);
        }
        if (!status && HOUR_MIN % per_hour != 0) {
            status = fail(f, f->line,
                          "the number of rows of an hour must divide 60");
        }
        f->out->interval_min = status ? 0 : HOUR_MIN / per_hour;
        if (!status) {
            take_ends(f);
        }
        return status;
    }
    return status ? status
                  : fail(f, f->csv.line,
                         "the header ends without a line DATA PERIODS");
}

/* ---- the weather codes ---- */

/* The nine digits of the weather codes by the dictionary and the TMY2 User's
 * Manual (Marion and Urban 1995, appendix B): thunderstorm; rain; drizzle,
 * which 0 to 2 are rain squalls of; snow; snow showers; sleet; fog; haze; ice
 * pellets. A digit is 9 where there is nothing. */
enum { RAIN_DIGIT = 1, DRIZZLE_DIGIT = 2, CODE_DIGITS = 9 };

/* What the digits at a place say, as METAR groups of the same meaning. Hail (4
 * of sleet), glaze (6 of fog) and spray (5 of haze) are no medium. */
static const struct {
    size_t place;
    const char *digits;
    murk_weather_kind kind;
} CODE_KINDS[] = {
    {3, "012345678", MURK_WEATHER_SNOW}, /* also pellets and ice crystals */
    {4, "01234567", MURK_WEATHER_SNOW},  /* also squalls and grains */
    {5, "012", MURK_WEATHER_SNOW},       /* ice pellet showers */
    {6, "012578", MURK_WEATHER_FOG},     /* also ice fog and ground fog */
    {6, "34", MURK_WEATHER_HAZE},        /* blowing dust, blowing sand */
    {7, "012367", MURK_WEATHER_HAZE},    /* smoke, haze, dust, ash */
    {7, "4", MURK_WEATHER_SNOW},         /* blowing snow */
    {8, "012", MURK_WEATHER_SNOW},       /* ice pellets */
};

/* The rate of rain by a digit of the codes: 0, 1, 2 are light, moderate and
 * heavy, 3 to 5 and 6 to 8 the same of other kinds, 9 is none. */
static double rain_of_digit(char digit, bool is_drizzle)
{
    return digit == '9' ? 0 : murk_rain_of_class(is_drizzle, (digit - '0') % 3);
}

/* Takes the codes. They count if the column before them is 0, and are missing
 * if they are not nine digits. */
static void take_codes(const epw *f, murk_observation *seen, double observed)
{
    const char *code = f->cell[CODES];
    if (!(observed == 0) || strlen(code) != CODE_DIGITS ||
        strspn(code, "0123456789") != CODE_DIGITS) {
        return;
    }
    for (size_t i = 0; i < sizeof CODE_KINDS / sizeof *CODE_KINDS; ++i) {
        if (strchr(CODE_KINDS[i].digits, code[CODE_KINDS[i].place]) &&
            CODE_KINDS[i].kind > seen->kind) {
            seen->kind = CODE_KINDS[i].kind;
        }
    }
    snprintf(seen->weather, sizeof seen->weather, "%s", code);
    /* The class of rain counts where no amount is stated. */
    if (!(seen->rain_mm_per_h > 0)) {
        const char rain = code[RAIN_DIGIT], drizzle = code[DRIZZLE_DIGIT];
        seen->rain_mm_per_h = fmax(rain_of_digit(rain, false),
                                   rain_of_digit(drizzle, drizzle > '2'));
        seen->rain_is_by_word = seen->rain_mm_per_h > 0;
    }
}

/* ---- rows ---- */

/* Sets the visibility from kilometres. Stations of the United States report 10
 * miles, 16.1 km, where they see farther; 777.7 is an unlimited visibility,
 * which TMY2 reports up to 160.9 km. */
static void set_visibility(murk_observation *seen, double km)
{
    const double us_limit = 16.1, farthest = 160.9;
    const bool is_unlimited = km >= UNLIMITED_KM;
    const bool is_limit = is_unlimited || fabs(km - us_limit) < .05;
    seen->visibility_m = 1000 * (is_unlimited ? farthest : km);
    seen->visibility_limit =
        is_limit ? MURK_VISIBILITY_AT_LEAST : MURK_VISIBILITY_EXACT;
    if (km == 0) { /* rounded down from less than 50 m */
        seen->visibility_m = 50;
        seen->visibility_limit = MURK_VISIBILITY_LESS_THAN;
    }
}

static murk_status read_values(const epw *f, murk_observation *seen)
{
    double pressure_pa, cover_tenths, km, observed, rain_mm, rain_hours;
    const struct {
        column column;
        double *out;
    } all[] = {
        {{"the temperature", TEMPERATURE, MURK_COLDEST_C, MURK_HOTTEST_C, 99.9},
         &seen->temperature_c},
        {{"the dew point", DEW_POINT, MURK_COLDEST_C, MURK_HOTTEST_C, 99.9},
         &seen->dew_point_c},
        {{"the pressure", PRESSURE, 31000, 120000, 999999}, &pressure_pa},
        {{"the global irradiance", GLOBAL, OFFSET_W_PER_M2, 2000, 9999},
         &seen->global_w_per_m2},
        {{"the direct irradiance", DIRECT, OFFSET_W_PER_M2, 2000, 9999},
         &seen->direct_w_per_m2},
        {{"the diffuse irradiance", DIFFUSE, OFFSET_W_PER_M2, 2000, 9999},
         &seen->diffuse_w_per_m2},
        {{"the sky cover", SKY_COVER, 0, 10, 99}, &cover_tenths},
        {{"the visibility", VISIBILITY, 0, UNLIMITED_KM, 9999}, &km},
        {{"the observation indicator", OBSERVED, 0, 9, 9}, &observed},
        {{"the precipitation", RAIN, 0, 500, 999}, &rain_mm},
        {{"the hours of precipitation", RAIN_HOURS, 0, 24, 99}, &rain_hours},
    };
    double *const light[] = {&seen->global_w_per_m2, &seen->direct_w_per_m2,
                             &seen->diffuse_w_per_m2};
    *seen = murk_observation_empty();
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        const murk_status status = read_number(f, &all[i].column, all[i].out);
        if (status) {
            return status;
        }
    }
    /* Convert to the units of an observation. A missing rain is no rain, as in
     * files that leave the column empty in dry hours. */
    seen->pressure_hpa = pressure_pa / 100;
    seen->sky_cover = cover_tenths / 10;
    if (!isnan(km)) {
        set_visibility(seen, km);
    }
    for (size_t i = 0; i < sizeof light / sizeof *light; ++i) {
        *light[i] = *light[i] < 0 ? 0 : *light[i]; /* not NAN */
    }
    if (rain_mm > 0) {
        seen->rain_mm_per_h = rain_mm / (rain_hours > 0 ? rain_hours : 1);
    }
    if (seen->rain_mm_per_h > MURK_RAIN_MM_PER_H_MAX) {
        return fail_cell(f, "the hours of precipitation", f->cell[RAIN_HOURS],
                         "longer for so much rain");
    }
    take_codes(f, seen, observed);
    return MURK_OK;
}

static murk_status read_time(const epw *f, murk_weather_row *row)
{
    /* Days of the months of a leap year. */
    static const int days[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const int interval = f->out->interval_min;
    int hour = 0, minute = 0;
    murk_status status = read_whole(f, "the year", YEAR, 1, 9999, &row->year);
    if (!status) {
        status = read_whole(f, "the month", MONTH, 1, 12, &row->month);
    }
    if (!status) {
        status =
            read_whole(f, "the day", DAY, 1, days[row->month - 1], &row->day);
    }
    /* February 29 of a year that has none. */
    const murk_date date = {row->year, row->month, row->day};
    if (!status && murk_date_of_days(murk_date_days(date)).day != row->day) {
        return fail_cell(f, "the day", f->cell[DAY], "a day of that year");
    }
    if (!status) {
        status = read_whole(f, "the hour", HOUR, 1, 24, &hour);
    }
    if (!status) {
        status = read_whole(f, "the minute", MINUTE, 0, HOUR_MIN, &minute);
    }
    /* Hourly rows have the minute 0 or 60, or an indifferent one, and end with
     * their hour; of other rows the minute is the end. */
    const bool is_hourly = interval == HOUR_MIN;
    row->ends_min = hour * HOUR_MIN + (is_hourly ? 0 : minute - HOUR_MIN);
    row->line = (int)f->line;
    if (!status && !is_hourly && (minute == 0 || minute % interval != 0)) {
        char allowed[80];
        snprintf(allowed, sizeof allowed,
                 "the end of a row's part of the hour, %d..%d in steps of %d",
                 interval, HOUR_MIN, interval);
        return fail_cell(f, "the minute", f->cell[MINUTE], allowed);
    }
    return status;
}

/* The next row, with space in the array. */
static murk_weather_row *add_row(epw *f)
{
    if (f->out->n == f->reserved) {
        const size_t more = 2 * f->reserved;
        murk_weather_year *grown =
            realloc(f->out, sizeof *grown + more * sizeof *grown->row);
        if (!grown) {
            return NULL;
        }
        f->out = grown;
        f->reserved = more;
    }
    return &f->out->row[f->out->n++];
}

/* The number of the interval in a leap year. */
static int number_of(const murk_weather_row *row, int interval_min)
{
    const double day = murk_date_days((murk_date){2000, row->month, row->day}) -
                       murk_date_days((murk_date){2000, 1, 1});
    return (int)day * (DAY_MIN / interval_min) + row->ends_min / interval_min;
}

/* True if a row is the interval after the one before it: also the first of
 * March 1 after the last of February 28, and of January 1 after that of the
 * year. Rows of one day are of one year. */
static bool follows(const murk_weather_row *before, const murk_weather_row *row,
                    int interval_min)
{
    enum { DAYS = 366 };
    const int per_day = DAY_MIN / interval_min;
    const int step =
        number_of(row, interval_min) - number_of(before, interval_min);
    const bool is_day = before->month == row->month && before->day == row->day;
    const bool is_march = before->month == 2 && before->day == 28 &&
                          before->ends_min == DAY_MIN && row->month == 3;
    return (step == 1 && (!is_day || before->year == row->year)) ||
           step == 1 - DAYS * per_day || (is_march && step == 1 + per_day);
}

/* Checks the first and the last row against DATA PERIODS. */
static murk_status check_ends(const epw *f)
{
    const murk_weather_row *first = &f->out->row[0],
                           *last = &f->out->row[f->out->n - 1];
    char text[120];
    /* The first row, then the last. */
    if (f->first_month > 0 &&
        (first->month != f->first_month || first->day != f->first_day ||
         first->ends_min != f->out->interval_min)) {
        snprintf(
            text, sizeof text,
            "begins with minute %d of %02d-%02d, must begin with the first "
            "of %02d-%02d, as DATA PERIODS says",
            first->ends_min, first->month, first->day, f->first_month,
            f->first_day);
        return fail(f, (size_t)first->line, text);
    }
    if (f->last_month == 0 ||
        (last->month == f->last_month && last->day == f->last_day &&
         last->ends_min == DAY_MIN)) {
        return MURK_OK;
    }
    snprintf(text, sizeof text,
             "ends with minute %d of %02d-%02d, must end with the last of "
             "%02d-%02d, as DATA PERIODS says",
             last->ends_min, last->month, last->day, f->last_month,
             f->last_day);
    return fail(f, (size_t)last->line, text);
}

/* Reads the cells of a row that the first row has as many of. */
static murk_status read_row_cells(epw *f)
{
    char text[80];
    size_t n;
    const murk_status status = read_cells(f, &n);
    f->cells = f->cells ? f->cells : n;
    if (status || (n == f->cells && n <= CELLS_MAX && n >= (size_t)CELLS_MIN)) {
        return status;
    }
    snprintf(text, sizeof text,
             "%zu cells, must be %d..%d, in each row the same", n, CELLS_MIN,
             CELLS_MAX);
    return fail(f, f->line, text);
}

static murk_status read_rows(epw *f)
{
    murk_status status = MURK_OK;
    int periods = 1;
    while (!status && murk_csv_find_line(&f->csv)) {
        murk_weather_row *row = add_row(f);
        if (!row) {
            return murk_no_memory(f->err, f->path, "for a weather year");
        }
        status = read_row_cells(f);
        if (!status) {
            status = read_time(f, row);
        }
        if (!status) {
            status = read_values(f, &row->seen);
        }
        /* A row that does not follow the one before begins a period. */
        periods += !status && f->out->n > 1 &&
                   !follows(row - 1, row, f->out->interval_min);
        if (periods > f->periods) {
            return fail(f, f->line,
                        "does not follow the row before: a row is missing or "
                        "doubled, or out of order");
        }
    }
    if (!status && f->out->n == 0) {
        return fail(f, f->csv.line, "has no rows behind DATA PERIODS");
    }
    return status ? status : check_ends(f);
}

/* ---- files ---- */

murk_status murk_weather_year_parse(murk_weather_year **out, const char *path,
                                    char *text, size_t size, murk_error *err)
{
    epw f = {.path = path,
             .csv = {.next = text, .end = text + size, .line = 1},
             .err = err,
             .reserved = 8784};
    static const char mark[] = "\xef\xbb\xbf"; /* of UTF-8 */
    f.csv.is_one_line = true;
    if (strncmp(text, mark, sizeof mark - 1) == 0) {
        f.csv.next += sizeof mark - 1;
    }
    if (strlen(text) != size) {
        return fail(&f, 1, "has a byte 0, must be text");
    }
    /* The header, then the rows; the array grows with longer files. */
    f.out = calloc(1, sizeof *f.out + f.reserved * sizeof *f.out->row);
    if (!f.out) {
        return murk_no_memory(err, path, "for a weather year");
    }
    murk_status status = read_header(&f);
    if (!status) {
        status = read_rows(&f);
    }
    if (status) {
        free(f.out);
        return status;
    }
    f.out->owners = 1;
    *out = f.out;
    return MURK_OK;
}

/* Files that were read last, and their years: a choice; a study has the weather
 * of one place or of a few. */
#define RECENT 4

/* The years that are shared; any number of threads may use them. */
static struct {
    atomic_flag is_taken;
    size_t n, oldest;
    murk_file_identity file[RECENT];
    murk_weather_year *year[RECENT];
} recent = {.is_taken = ATOMIC_FLAG_INIT};

static void enter(void)
{
    while (atomic_flag_test_and_set_explicit(&recent.is_taken,
                                             memory_order_acquire)) {
    }
}

static void leave(void)
{
    atomic_flag_clear_explicit(&recent.is_taken, memory_order_release);
}

/* Gives up one owner; returns the memory that is to be freed. */
static murk_weather_year *without_owner(murk_weather_year *year)
{
    return year && --year->owners == 0 ? year : NULL;
}

/* The year of a file as a further owner; NULL if it is not there. */
static murk_weather_year *find_recent(const murk_file_identity *file)
{
    murk_weather_year *found = NULL;
    enter();
    for (size_t i = 0; i < recent.n && !found; ++i) {
        if (memcmp(&recent.file[i], file, sizeof *file) == 0) {
            found = recent.year[i];
            ++found->owners;
        }
    }
    leave();
    return found;
}

/* Becomes a further owner, in place of the oldest year. */
static void put_recent(const murk_file_identity *file, murk_weather_year *year)
{
    enter();
    const size_t i = recent.n < RECENT ? recent.n++ : recent.oldest;
    recent.oldest = (i + 1) % RECENT;
    murk_weather_year *old = without_owner(recent.year[i]);
    recent.file[i] = *file;
    recent.year[i] = year;
    ++year->owners;
    leave();
    free(old);
}

murk_status murk_weather_year_read(murk_weather_year **out, const char *path,
                                   murk_error *err)
{
    murk_file_identity file;
    murk_status status = murk_file_identify(&file, path, err);
    murk_weather_year *found = status ? NULL : find_recent(&file);
    if (status || found) {
        *out = found;
        return status;
    }
    char *text = NULL;
    size_t size = 0;
    status = murk_file_read(&text, &size, path, MURK_WEATHER_BYTES_MAX, err);
    if (!status) {
        status = murk_weather_year_parse(out, path, text, size, err);
    }
    if (!status) {
        put_recent(&file, *out);
    }
    free(text);
    return status;
}

void murk_weather_year_release(murk_weather_year *year)
{
    enter();
    murk_weather_year *old = without_owner(year);
    leave();
    free(old);
}

/* ---- times ---- */

const murk_weather_row *murk_weather_year_at(const murk_weather_year *weather,
                                             double unix_s)
{
    const double local_s = unix_s + MINUTE_S * weather->zone_min;
    const murk_date date = murk_date_of_days(local_s / DAY_S);
    const double minute = (local_s - DAY_S * murk_date_days(date)) / MINUTE_S;
    const murk_weather_row *found = NULL;
    for (size_t i = 0; i < weather->n; ++i) {
        const murk_weather_row *row = &weather->row[i];
        if (row->month == date.month && row->day == date.day &&
            minute < row->ends_min &&
            minute >= row->ends_min - weather->interval_min &&
            (!found || (found->year != date.year && row->year == date.year))) {
            found = row;
        }
    }
    return found;
}

double murk_weather_row_middle(const murk_weather_year *weather,
                               const murk_weather_row *row)
{
    const murk_date date = {row->year, row->month, row->day};
    const double middle_min =
        row->ends_min - .5 * weather->interval_min - weather->zone_min;
    return DAY_S * murk_date_days(date) + MINUTE_S * middle_min;
}
