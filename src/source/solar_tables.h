/* Tables of solar spectra and of absorption by gases and water. For
 * use inside src/source only. */
#ifndef MURK_SOURCE_SOLAR_TABLES_H
#define MURK_SOURCE_SOLAR_TABLES_H

/* ASTM G173-03: extraterrestrial means over the cells from from_nm to the next
 * row [W/m2/nm], made from the published spectrum with steps of .5 to 5 nm by
 * the trapezoid rule. The last row ends the table. */
typedef struct murk_g173_cell {
    double from_nm, extraterrestrial;
} murk_g173_cell;

#define MURK_G173_CELLS 131 /* 280..4000 nm */
extern const murk_g173_cell murk_g173[MURK_G173_CELLS + 1];

/* Bird and Riordan, NREL/TR-215-2436 (1984), doi:10.2172/5986936: irradiance
 * outside of the atmosphere at 1 au [W/m2/nm], absorption by water vapour
 * [1/cm], by ozone [1/atm cm] and by uniformly mixed gases. From a secondary
 * source, pvlib-python. */
typedef struct murk_bird_line {
    double nm, outside, vapour, ozone, gases;
} murk_bird_line;

#define MURK_BIRD_LINES 122 /* 300..4000 nm */
extern const murk_bird_line murk_bird[MURK_BIRD_LINES];

/* The absorption index of liquid water: Hale and Querry, Appl. Opt. 12 (1973)
 * 555, doi:10.1364/AO.12.000555, from a secondary source,
 * refractiveindex.info. */
typedef struct murk_water_index {
    double nm, k;
} murk_water_index;

#define MURK_WATER_INDICES 35 /* 300..4000 nm */
extern const murk_water_index murk_water[MURK_WATER_INDICES];

#endif
