/* What the examples share: the end of a program whose call failed, and the text
 * of a small room: walls, a lamp, fog, a tally, sensors and a camera. */
#ifndef EXAMPLE_H
#define EXAMPLE_H

#include <murk.h>

#include <stdio.h>
#include <stdlib.h>

/* Ends the program with the message of an error. */
static inline void must(murk_status status, const murk_error *error)
{
    if (status) {
        fprintf(stderr, "%s: %s: %s\n", murk_status_text(status), error->where,
                error->text);
        exit(1);
    }
}

static const char room[] =
    "murk: 1\n"
    "bands_nm: [532]\n"
    "domain: {min_m: [0, 0, 0], max_m: [8, 6, 3]}\n"
    "geometry: [{box: {min_m: [0, 0, 0], max_m: [8, 6, 3]}}]\n"
    "materials: {default: {diffuse: 0.5}}\n"
    "media: {fog: {extinction_per_m: 0.1, albedo: 0.9, phase: {hg: 0.8}}}\n"
    "regions: [{medium: fog}]\n"
    "lights: [{type: sphere, center_m: [4, 3, 2.8], radius_m: 0.05,\n"
    "          power_w: 20}]\n"
    "photons: {emit: 20000}\n"
    "tallies: [{name: box, type: grid, min_m: [0, 0, 0], max_m: [8, 6, 3],\n"
    "           size: [4, 3, 2]}]\n"
    "sensors:\n"
    "  types: [{name: node, range_m: 6}]\n"
    "  candidates: {grid: {min_m: [1, 1, 1], max_m: [7, 5, 2],\n"
    "                      size: [4, 3, 2]}}\n"
    "  count: 2\n"
    "cameras: [{name: door, from_m: [0.5, 0.5, 1.5], to_m: [4, 3, 1],\n"
    "           up: [0, 0, 1], vfov_deg: 60, pixels: [32, 24], samples: 4}]\n";

#endif
