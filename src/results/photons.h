/* The files that --export photons writes: photons.ply (for Blender and MeshLab)
 * and photons.vtp (for ParaView, whose PLY reader takes only position, normal
 * and colour). Both have every stored photon, those of the surface map first,
 * in the order of the maps.
 *
 *     x y z           float, m
 *     nx ny nz        float: normal on the side it came from; 0 in volume
 *     dx dy dz        float: direction of travel before the event
 *     power_w         float, W: what leaves the event
 *     emitted         uint: number of the emitted photon
 *     band, light     uchar: numbers, from 0
 *     material        uchar: number of the material, or of the medium
 *     kind            uchar: 0 surface, 1 volume
 *     event           uchar: 0 first, 1 only mirrors and glass before, 2 later
 *     red green blue  uchar: of several bands the band's own colour, of one by
 *                     kind (warm: surface, cold: volume) and event
 *
 * Comments of the .ply and field data of the .vtp state the origin of the file,
 * and the meaning of the numbers of bands, materials and media. Binary, little
 * endian. */
#ifndef MURK_RESULTS_PHOTONS_H
#define MURK_RESULTS_PHOTONS_H

#include "results/session.h"

/* Adds both files to the results. If one cannot be made, or on an interrupt,
 * *late has the first reason. */
void murk_photons_add(murk_session *session, murk_error *late);

#endif
