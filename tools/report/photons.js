// Stored photons as dots, coloured by how many sensors see each or, with one
// picked, by whether that one does.
import { BufferAttribute, BufferGeometry, Color, DataTexture, Points, PointsMaterial } from "three";
import { bytes, places } from "./data.js";

// Told apart by lightness, too, and by those who see no red or no green.
export const COLORS = {
  none: new Color(0xff6b3d), one: new Color(0x4a9dff), more: new Color(0xc6f7b2),
  alone: new Color(0xffffff), shared: new Color(0x4fd1c5), other: new Color(0x8894a6), stored: new Color(0xf3e9c0),
};
const DIM = 0.13, BITS = 32;

// A round spot.
function round() {
  const size = 32, pixel = new Uint8Array(4 * size * size);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const edge = Math.max(0, 1 - Math.hypot(x - 15.5, y - 15.5) / 15.5);
      pixel.set([255, 255, 255, 255 * Math.min(1, 4 * edge)], 4 * (y * size + x));
    }
  }
  const texture = new DataTexture(pixel, size, size);
  texture.needsUpdate = true;
  return texture;
}

export class Photons {
  // field: three.js takes a point's size as if the field of view were 90 degrees
  constructor(data, number, field) {
    const state = data.states[number];
    this.n = state.photons;
    this.surface = state.surface_photons;
    this.sensors = state.sensors.length;
    this.seen = bytes(`photon-seen-${number}`);
    this.bits = bytes(`photon-sensors-${number}`);
    this.width = state.bit_bytes;
    const all = places(bytes(`photon-places-${number}`), state, 65535, data.middle);
    // few photons: larger dots
    const dot = data.dot_m * Math.min(2.2, Math.max(0.8, Math.cbrt(30000 / Math.max(this.n, 1))));
    this.dots = [[0, this.surface], [this.surface, this.n]].map(([first, end]) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(all.slice(3 * first, 3 * end), 3));
      geometry.setAttribute("color", new BufferAttribute(new Float32Array(4 * (end - first)), 4));
      return new Points(geometry, new PointsMaterial({
        size: field * dot, map: round(), vertexColors: true, transparent: true, alphaTest: 0.02, depthWrite: false,
      }));
    });
    this.paint(-1);
  }

  // Whether a sensor is one of those of which the page knows what they see.
  knows(sensor) {
    return sensor >= 0 && sensor < BITS;
  }

  isSeen(photon, sensor) {
    return (this.bits[this.width * photon + (sensor >> 3)] >> (sensor & 7) & 1) === 1;
  }

  kind(photon, picked) {
    const by = this.seen[photon];
    if (this.sensors === 0) return "stored";
    if (!this.knows(picked)) return by === 0 ? "none" : by === 1 ? "one" : "more";
    if (!this.isSeen(photon, picked)) return "other";
    return by === 1 ? "alone" : "shared";
  }

  // Returns how many there are of each kind.
  paint(picked) {
    const counts = { none: 0, one: 0, more: 0, alone: 0, shared: 0, other: 0, stored: 0 };
    let photon = 0;
    for (const part of this.dots) {
      const color = part.geometry.getAttribute("color");
      for (let i = 0; i < color.count; ++i, ++photon) {
        const kind = this.kind(photon, picked), c = COLORS[kind];
        ++counts[kind];
        color.setXYZW(i, c.r, c.g, c.b, kind === "other" ? DIM : 1);
      }
      color.needsUpdate = true;
    }
    this.counts = counts;
    return counts;
  }

  dispose() {
    for (const part of this.dots) {
      part.geometry.dispose();
      part.material.map.dispose();
      part.material.dispose();
    }
  }
}
