/* Measured spectra that the laws of water use, at equal steps of wavelength,
 * interpolated linearly. For use inside src/preset only. */
#ifndef MURK_PRESET_WATER_TABLES_H
#define MURK_PRESET_WATER_TABLES_H

#include <stddef.h>

typedef struct murk_water_table {
    double min_nm, step_nm;
    size_t n;
    const double *value; /* [n] */
} murk_water_table;

/* Absorption of pure water [1/m], 380 to 727.5 nm: Pope & Fry 1997. */
extern const murk_water_table murk_water_pope_fry;

/* Absorption by living and dead particles with chlorophyll C [mg/m3] is factor
 * C^exponent [1/m], 400 to 700 nm: Bricaud, Morel, Babin, Allali & Claustre, J.
 * Geophys. Res. 103 (1998) 31033, doi:10.1029/98JC02712, as tabulated with the
 * ocean colour programs of NASA. */
extern const murk_water_table murk_water_bricaud_factor;
extern const murk_water_table murk_water_bricaud_exponent;

/* The value at a wavelength within the table. */
double murk_water_column(const murk_water_table *table, double wavelength_nm);

#endif
