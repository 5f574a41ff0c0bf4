// Media: as a cloud that dims what lies behind, and as the surface on which
// the extinction has a value.
//
// The cloud adds up extinction along each line of sight, in equal steps
// (Levoy, IEEE Comput. Graph. Appl. 8 (1988) 29, doi:10.1109/38.511). The
// surface is one of nets: a corner a cell that it crosses, in the middle of
// the crossings, joined over each edge that it crosses (Gibson, MICCAI'98
// (1998) 888, doi:10.1007/BFb0056277).
import {
  BackSide, BoxGeometry, BufferAttribute, BufferGeometry, ClampToEdgeWrapping, Data3DTexture, DoubleSide, GLSL3,
  LinearFilter, Mesh, MeshLambertMaterial, RedFormat, ShaderMaterial, UnsignedByteType, Vector3,
} from "three";
import { bytes } from "./data.js";

// What level lines of sight through the cloud dim, in the mean; clouds that
// would dim more are thinned to it.
const DIMMED = 0.32;
const STEPS = 72;

export class Medium {
  constructor(data, number) {
    Object.assign(this, data.media[number]);
    this.cell = this.there ? bytes(`media-cells-${number}`) : new Uint8Array(0);
    this.middle = data.middle;
  }

  corner() {
    return this.low.map((v, k) => v - this.middle[k]);
  }

  extent() {
    return this.high.map((v, k) => Math.max(v - this.low[k], 1e-9));
  }
}

const VERTEX = `
out vec3 at;
void main() {
  at = position + 0.5;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = `
precision highp float;
precision highp sampler3D;
uniform sampler3D cells;
uniform vec3 eye, extent, tint;
uniform float strength;
in vec3 at;
out vec4 color;
void main() {
  vec3 way = at - eye;
  vec3 a = -eye / way, b = (1.0 - eye) / way;
  vec3 near = min(a, b);
  float begin = clamp(max(max(near.x, near.y), near.z), 0.0, 1.0);
  vec3 leg = way * (1.0 - begin) / ${STEPS}.0;
  float sum = 0.0;
  for (int i = 0; i < ${STEPS}; ++i) {
    float root = texture(cells, eye + way * begin + leg * (float(i) + 0.5)).r;
    sum += root * root;
  }
  float depth = strength * sum * length(leg * extent);
  color = vec4(tint, 1.0 - exp(-depth));
  if (color.a < 0.004) discard;
}`;

// Optical depths of level lines of sight, from side to side.
function depths(medium, extent) {
  const [nx, ny, nz] = medium.size, n = [nx, ny, nz], stride = [1, nx, nx * ny], all = [];
  for (const k of [0, 1]) {
    const u = 1 - k;
    for (let i = 0; i < n[u]; ++i) {
      for (let j = 0; j < nz; ++j) {
        let sum = 0;
        for (let t = 0; t < n[k]; ++t) sum += (medium.cell[i * stride[u] + j * stride[2] + t * stride[k]] / 255) ** 2;
        all.push(sum * medium.most_per_m * extent[k] / n[k]);
      }
    }
  }
  return all;
}

// What the cloud's depth is of the true one, at most 1: by halving.
export function cloudShare(medium) {
  if (medium.share === undefined) {
    const all = depths(medium, medium.extent());
    const dims = (share) => all.reduce((sum, depth) => sum - Math.expm1(-share * depth), 0) / all.length > DIMMED;
    let low = 0, high = 1;
    for (let i = 0; i < 30 && dims(1); ++i) {
      const middle = (low + high) / 2;
      if (dims(middle)) high = middle;
      else low = middle;
    }
    medium.share = high;
  }
  return medium.share;
}

export function cloud(medium) {
  if (!medium.there) return null;
  const texture = new Data3DTexture(medium.cell, ...medium.size);
  texture.format = RedFormat;
  texture.type = UnsignedByteType;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.wrapS = texture.wrapT = texture.wrapR = ClampToEdgeWrapping;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  const extent = medium.extent(), low = medium.corner();
  const shape = new Mesh(new BoxGeometry(1, 1, 1), new ShaderMaterial({
    glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, side: BackSide,
    transparent: true, depthWrite: false, depthTest: false,
    uniforms: {
      cells: { value: texture }, eye: { value: new Vector3() }, extent: { value: new Vector3(...extent) },
      tint: { value: new Vector3(0.80, 0.84, 0.90) },
      strength: { value: medium.most_per_m * cloudShare(medium) },
    },
  }));
  shape.scale.set(...extent);
  shape.position.set(...low.map((v, k) => v + extent[k] / 2));
  shape.renderOrder = 5; // over all that it dims
  shape.onBeforeRender = (renderer, scene, camera) => {
    const eye = shape.material.uniforms.eye.value.copy(camera.position);
    eye.sub(shape.position).divide(shape.scale).addScalar(0.5);
  };
  return shape;
}

const CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]];
const EDGES = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

// Corners and triangles of the surface; what is outside of the box has no
// extinction, so it is closed. root: of the share of the largest extinction.
export function net({ size, cell }, root) {
  const wide = size.map((n) => n + 2), [wx, wy, wz] = wide;
  const value = new Float32Array(wx * wy * wz);
  for (let z = 0, i = 0; z < size[2]; ++z) {
    for (let y = 0; y < size[1]; ++y) {
      for (let x = 0; x < size[0]; ++x, ++i) value[x + 1 + wx * (y + 1 + wy * (z + 1))] = cell[i] / 255;
    }
  }
  const step = CORNERS.map(([x, y, z]) => x + wx * (y + wy * z));
  const number = new Int32Array(value.length).fill(-1), place = [], corner = [];
  for (let z = 0; z + 1 < wz; ++z) {
    for (let y = 0; y + 1 < wy; ++y) {
      for (let x = 0; x + 1 < wx; ++x) {
        const i = x + wx * (y + wy * z);
        let crossed = 0;
        const sum = [0, 0, 0];
        for (const [a, b] of EDGES) {
          const p = value[i + step[a]], q = value[i + step[b]];
          if (p >= root === q >= root) continue;
          const t = (root - p) / (q - p);
          for (let k = 0; k < 3; ++k) sum[k] += CORNERS[a][k] + t * (CORNERS[b][k] - CORNERS[a][k]);
          ++crossed;
        }
        if (!crossed) continue;
        number[i] = place.length / 3;
        // a value lies in the middle of its cell, and the box has one more round it
        [x, y, z].forEach((n, k) => place.push((n + sum[k] / crossed - 0.5) / size[k]));
      }
    }
  }
  // four cells meet at an edge that is crossed
  const along = [1, wx, wx * wy];
  for (let z = 0, i = 0; z < wz; ++z) {
    for (let y = 0; y < wy; ++y) {
      for (let x = 0; x < wx; ++x, ++i) {
        const at = [x, y, z];
        for (let k = 0; k < 3; ++k) {
          const u = (k + 1) % 3, v = (k + 2) % 3;
          if (at[k] + 1 === wide[k] || at[u] === 0 || at[v] === 0) continue;
          const isInside = value[i] >= root;
          if (isInside === value[i + along[k]] >= root) continue;
          const q = [i, i - along[u], i - along[u] - along[v], i - along[v]].map((n) => number[n]);
          if (!isInside) q.reverse();
          corner.push(q[0], q[1], q[2], q[0], q[2], q[3]);
        }
      }
    }
  }
  return { place, corner };
}

export function level(medium, root) {
  if (!medium.there) return null;
  const { place, corner } = net(medium, root), extent = medium.extent(), low = medium.corner();
  for (let i = 0; i < place.length; ++i) {
    const k = i % 3;
    place[i] = low[k] + extent[k] * Math.min(1, Math.max(0, place[i]));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(place), 3));
  geometry.setIndex(corner);
  geometry.computeVertexNormals();
  const shape = new Mesh(geometry, new MeshLambertMaterial({
    color: 0xc9a6ff, transparent: true, opacity: 0.55, side: DoubleSide, depthWrite: false,
  }));
  shape.renderOrder = 4;
  return shape;
}
