// The view in space of murk's report: what stands in the scene, stored photons
// by how many sensors see each, sensors with their ranges and views, media.
// Built into src/app/web/view.js by tools/report/build. Reads the data blocks
// that src/app/report_view.c writes; draws only when something has changed.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DataTexture,
  DirectionalLight, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments,
  Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, Points, PointsMaterial,
  Raycaster, Scene, SphereGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

const SEEN = [new Color(0xff5a4d), new Color(0x5aa0ff), new Color(0x4fd07a)];
const SENSOR = 0xffc800, PICKED = 0xffffff, WALL = 0x9fb0c4;
const RING_SIDES = 64, FIELD_DEG = 45;
// three.js takes a point's size as if the field of view were 90 degrees
const POINT = 1 / Math.tan(FIELD_DEG * Math.PI / 360);

const element = (id) => document.getElementById(id);

function bytes(id) {
  const block = element(id);
  if (!block) return new Uint8Array(0);
  const text = atob(block.textContent.trim());
  const out = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) out[i] = text.charCodeAt(i);
  return out;
}

// Whole numbers 0..steps between the corners of a box, as metres from its middle.
function places(raw, box, steps, middle) {
  const whole = new Uint16Array(raw.buffer), out = new Float32Array(whole.length);
  for (let i = 0; i < whole.length; ++i) {
    const k = i % 3;
    out[i] = box.low[k] - middle[k] + (box.high[k] - box.low[k]) * whole[i] / steps;
  }
  return out;
}

// Of a place in the world: numbers stay small, however far off the scene lies.
const from = (data, place) => new Vector3(...place.map((v, k) => v - data.middle[k]));

function surfaces(data) {
  const group = new Group();
  const mesh = data.mesh;
  if (mesh) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places(bytes("mesh-places"), mesh, mesh.steps, data.middle), 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(bytes("mesh-corners").buffer), 1));
    group.add(new Mesh(geometry, new MeshLambertMaterial({
      color: WALL, transparent: true, opacity: 0.13, side: DoubleSide, depthWrite: false, flatShading: true,
    })));
    group.add(new LineSegments(new EdgesGeometry(geometry, 20), new LineBasicMaterial({
      color: WALL, transparent: true, opacity: 0.5,
    })));
  }
  for (const ball of data.balls) {
    const shape = new Mesh(new SphereGeometry(ball.radius, 32, 16), new MeshLambertMaterial({
      color: WALL, transparent: true, opacity: 0.3, depthWrite: false,
    }));
    shape.position.copy(from(data, ball.center));
    group.add(shape);
  }
  return group;
}

// A round spot: opacity by the distance from its edge, 0..1.
function round(opacity) {
  const size = 32, pixel = new Uint8Array(4 * size * size);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const r = Math.hypot(x - 15.5, y - 15.5) / 15.5;
      pixel.set([255, 255, 255, 255 * opacity(Math.max(0, 1 - r))], 4 * (y * size + x));
    }
  }
  const texture = new DataTexture(pixel, size, size);
  texture.needsUpdate = true;
  return texture;
}

function photons(data, all, seen, first, end) {
  const color = new Float32Array(3 * (end - first));
  for (let i = first; i < end; ++i) SEEN[Math.min(seen[i], 2)].toArray(color, 3 * (i - first));
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(all.slice(3 * first, 3 * end), 3));
  geometry.setAttribute("color", new BufferAttribute(color, 3));
  return new Points(geometry, new PointsMaterial({
    size: POINT * data.dot_m, map: round((t) => Math.min(1, 4 * t)), vertexColors: true, transparent: true, alphaTest: 0.3, depthWrite: false,
  }));
}

function media(data) {
  const m = data.media;
  if (!m) return null;
  const raw = bytes("media-cells"), place = [], color = [];
  const [nx, ny, nz] = m.size;
  const step = m.size.map((n, k) => (m.high[k] - m.low[k]) / n);
  const widest = Math.max(...step);
  // a few full cells one behind the other are opaque already; by
  // the root, so that thin smoke is seen beside thick
  const full = 1 - Math.exp(-7 / Math.cbrt(nx * ny * nz));
  for (let i = 0; i < raw.length; ++i) {
    if (!raw[i]) continue;
    const at = [i % nx, Math.floor(i / nx) % ny, Math.floor(i / (nx * ny))];
    place.push(...at.map((n, k) => m.low[k] - data.middle[k] + (n + 0.5) * step[k]));
    color.push(0.75, 0.82, 0.9, full * Math.sqrt(raw[i] / 255));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(place), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(color), 4));
  return new Points(geometry, new PointsMaterial({
    size: 3 * POINT * widest, map: round((t) => t * t), vertexColors: true, transparent: true, depthWrite: false,
  }));
}

function ring(center, u, v, radius, out) {
  for (let i = 0; i < RING_SIDES; ++i) {
    for (const k of [i, i + 1]) {
      const angle = 2 * Math.PI * k / RING_SIDES;
      const point = center.clone().addScaledVector(u, radius * Math.cos(angle)).addScaledVector(v, radius * Math.sin(angle));
      out.push(point.x, point.y, point.z);
    }
  }
}

// Lines about what a sensor sees: a ball by three rings, else its cone or
// pyramid as far as its range.
function range(data, sensor, reach) {
  const place = from(data, sensor.place), axis = new Vector3(...sensor.axis);
  const right = new Vector3(...sensor.right), up = new Vector3(...sensor.up);
  const out = [];
  const line = (a, b) => out.push(a.x, a.y, a.z, b.x, b.y, b.z);
  if (sensor.view === "sphere") {
    ring(place, right, up, reach, out);
    ring(place, right, axis, reach, out);
    ring(place, up, axis, reach, out);
  } else if (sensor.view === "cone") {
    const half = sensor.angles_rad[0] / 2;
    const rim = place.clone().addScaledVector(axis, reach * Math.cos(half));
    ring(rim, right, up, reach * Math.sin(half), out);
    for (let k = 0; k < 8; ++k) {
      const angle = Math.PI * k / 4;
      line(place, rim.clone().addScaledVector(right, reach * Math.sin(half) * Math.cos(angle))
        .addScaledVector(up, reach * Math.sin(half) * Math.sin(angle)));
    }
  } else {
    const across = Math.tan(sensor.angles_rad[0] / 2), high = Math.tan(sensor.angles_rad[1] / 2);
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => {
      const way = axis.clone().addScaledVector(right, a * across).addScaledVector(up, b * high);
      return place.clone().addScaledVector(way.normalize(), reach);
    });
    corners.forEach((corner, k) => { line(place, corner); line(corner, corners[(k + 1) % 4]); });
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(out), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: SENSOR, transparent: true, opacity: 0.35 }));
}

const percent = (share) => share === null ? "an unknown share" : (100 * share).toFixed(2) + " %";

function describe(sensor, number) {
  const reach = sensor.range_m === null ? "" : ` Its range is ${sensor.range_m} m.`;
  return `Sensor ${number + 1} (${sensor.type}) at ${sensor.place.map((v) => v.toFixed(2)).join(", ")} m sees ` +
    `${percent(sensor.covers)} of the light; ${percent(sensor.only)} is seen by no other.${reach}`;
}

class View {
  constructor(canvas, data) {
    this.data = data;
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color(0x10141b);
    this.camera = new PerspectiveCamera(FIELD_DEG, 1, data.size_m / 1000, data.size_m * 20);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.scene.add(new AmbientLight(0xffffff, 1.5));
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(0.4, -0.7, 1);
    this.scene.add(sun);
    this.fill();
    this.look(-0.6, -1, 0.75);
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  fill() {
    const data = this.data, n = data.photons;
    const all = places(bytes("photon-places"), data.photon_box, 65535, data.middle), seen = bytes("photon-seen");
    this.parts = {
      surfaces: surfaces(data),
      "surface-photons": photons(data, all, seen, 0, data.surface_photons),
      "volume-photons": photons(data, all, seen, data.surface_photons, n),
      sensors: new Group(), ranges: new Group(), media: media(data),
    };
    const ball = new SphereGeometry(data.size_m / 90, 20, 12);
    data.sensors.forEach((sensor, number) => {
      const shape = new Mesh(ball, new MeshBasicMaterial({ color: SENSOR }));
      shape.position.copy(from(data, sensor.place));
      shape.userData.number = number;
      this.parts.sensors.add(shape);
      const reach = Math.min(sensor.range_m ?? data.size_m / 8, data.size_m);
      this.parts.ranges.add(range(data, sensor, reach));
    });
    for (const part of Object.values(this.parts)) if (part) this.scene.add(part);
  }

  look(x, y, z) {
    const away = new Vector3(x, y, z).normalize().multiplyScalar(1.15 * this.data.size_m);
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(away);
    this.controls.update();
    this.draw();
  }

  // Keys turn the view about its middle; + and - go nearer and away.
  turn(around, over, nearer) {
    const way = this.camera.position.clone().sub(this.controls.target);
    const length = way.length() * nearer;
    const level = Math.atan2(way.y, way.x) + around;
    const height = Math.max(-1.5, Math.min(1.5, Math.asin(way.z / way.length()) + over));
    way.set(Math.cos(height) * Math.cos(level), Math.cos(height) * Math.sin(level), Math.sin(height));
    this.camera.position.copy(this.controls.target).addScaledVector(way, length);
    this.controls.update();
    this.draw();
  }

  show(name, is_shown) {
    if (this.parts[name]) this.parts[name].visible = is_shown;
    this.draw();
  }

  // number < 0: none
  pick(number) {
    this.parts.sensors.children.forEach((shape, k) => {
      shape.material.color.set(k === number ? PICKED : SENSOR);
      const lines = this.parts.ranges.children[k].material;
      lines.color.set(k === number ? PICKED : SENSOR);
      lines.opacity = number < 0 ? 0.35 : k === number ? 0.9 : 0.12;
    });
    element("view-sensor").value = String(number);
    element("view-picked").textContent = number < 0
      ? "Pick a sensor, in the view or in the list, to see its share."
      : describe(this.data.sensors[number], number);
    this.draw();
  }

  pickAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const spot = new Vector2(2 * (event.clientX - box.left) / box.width - 1,
      1 - 2 * (event.clientY - box.top) / box.height);
    const ray = new Raycaster();
    ray.setFromCamera(spot, this.camera);
    const met = ray.intersectObjects(this.parts.sensors.children, false);
    this.pick(met.length > 0 ? met[0].object.userData.number : -1);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}

function connect(view) {
  for (const box of document.querySelectorAll("#view input[type=checkbox]")) {
    const set = () => view.show(box.value, box.checked);
    box.addEventListener("change", set);
    set();
  }
  const looks = { above: [0, -1e-3, 1], side: [0, -1, 0.02], corner: [-0.6, -1, 0.75] };
  for (const button of document.querySelectorAll("#view button")) {
    button.addEventListener("click", () => view.look(...looks[button.value]));
  }
  const list = element("view-sensor");
  list.addEventListener("change", () => view.pick(Number(list.value)));
  let down = null;
  view.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
  view.canvas.addEventListener("pointerup", (event) => {
    // a click, not a turn
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) view.pickAt(event);
  });
  const keys = {
    ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, 0.1, 1], ArrowDown: [0, -0.1, 1],
    "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1.1],
  };
  view.canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    view.turn(...keys[event.key]);
    event.preventDefault();
  });
  view.pick(-1);
}

const section = element("view");
if (section) {
  section.hidden = false;
  try {
    connect(new View(element("view-canvas"), JSON.parse(element("view-data").textContent)));
    section.dataset.state = "drawn";
  } catch (problem) {
    section.dataset.state = "failed";
    element("view-canvas").hidden = true;
    element("view-picked").textContent =
      "This browser draws nothing in space (no WebGL). The drawings below show the same.";
  }
}
