/* What --export photons writes: every stored photon, surface map first, in the
 * maps' order, as photons.ply (Blender, MeshLab) and photons.vtp (ParaView,
 * whose PLY reader takes place, normal and colour alone).
 *
 *     x y z           float, m
 *     nx ny nz        float: the side of the surface it came from; 0 in volume
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
 * Comments, and field data of the .vtp: where they are from, and what the
 * numbers of bands, materials and media mean. Binary, little endian. */
#ifndef MURK_RESULTS_PHOTONS_H
#define MURK_RESULTS_PHOTONS_H

#include "results/session.h"

/* Streams them from the maps. Files that cannot be had are told in *late. */
void murk_photons_add(murk_session *session, murk_error *late);

#endif
