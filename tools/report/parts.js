// What stands in the scene: surfaces, lamps, sensors with what they may see,
// a path, readings.
import {
  BufferAttribute, BufferGeometry, Color, ConeGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments,
  Mesh, MeshBasicMaterial, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3,
} from "three";
import { bytes, from, places } from "./data.js";
import { label, lines } from "./frame.js";

export const SENSOR = 0xffd400, PICKED = 0xffffff;
const WALL = 0x9fb0c4, LAMP = 0xfff3c4, PATH = 0xff8ad8;
const RING_SIDES = 64, ARC_SIDES = 12, NUMBERED = 99;

export function surfaces(data) {
  const group = new Group();
  const mesh = data.mesh;
  if (mesh) {
    const corners = bytes("mesh-corners-0").buffer;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places(bytes("mesh-places-0"), mesh, mesh.steps, data.middle), 3));
    geometry.setIndex(new BufferAttribute(mesh.wide ? new Uint32Array(corners) : new Uint16Array(corners), 1));
    group.add(new Mesh(geometry, new MeshLambertMaterial({
      color: WALL, transparent: true, opacity: 0.1, side: DoubleSide, depthWrite: false, flatShading: true,
    })));
    group.add(new LineSegments(new EdgesGeometry(geometry, 20), new LineBasicMaterial({
      color: WALL, transparent: true, opacity: 0.4, depthWrite: false,
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

// Arrows that meet the box, the way the light of sun and moon travels.
export function distant(data) {
  const half = data.high.map((v, k) => Math.max(v - data.low[k], 0) / 2), t = data.size_m / 70;
  // beside the sun the moon is nothing
  const isDay = data.lamps.some((lamp) => lamp.type === "sun");
  return data.lamps.filter((lamp) => lamp.distant && !(isDay && lamp.type === "moon")).map((lamp) => {
    const way = new Vector3(...lamp.direction).normalize();
    const out = Math.min(...way.toArray().map((v, k) => Math.abs(v) > 0 ? half[k] / Math.abs(v) : Infinity));
    const at = (far) => way.clone().multiplyScalar(-out - far * t), tip = at(1);
    const side = way.x || way.y ? new Vector3(-way.y, way.x, 0).normalize() : new Vector3(1, 0, 0);
    const barbs = [-1, 1].map((s) => at(2.5).addScaledVector(side, s * t));
    return { lamp, tip, tail: at(7), barbs, word: at(8.5) };
  });
}

// Lamps as what they are: a ball, a sheet, a ray's beginning.
export function lamps(data) {
  const group = new Group(), out = [], size = data.size_m / 140;
  const to = (a, b) => out.push(a.x, a.y, a.z, b.x, b.y, b.z);
  const ball = new SphereGeometry(size, 12, 8);
  for (const { tail, tip, barbs, word, lamp } of distant(data)) {
    to(tail, tip);
    for (const barb of barbs) to(tip, barb);
    group.add(label(lamp.type, word, "#fff3c4"));
  }
  for (const lamp of data.lamps) {
    if (lamp.distant) continue;
    const place = from(data, lamp.place);
    if (lamp.type === "rect") {
      const u = new Vector3(...lamp.edge1), v = new Vector3(...lamp.edge2);
      const a = place.clone().add(u), b = a.clone().add(v), c = place.clone().add(v);
      [[place, a], [a, b], [b, c], [c, place], [place, b], [a, c]].forEach(([p, q]) => to(p, q));
      continue;
    }
    const shape = new Mesh(ball, new MeshBasicMaterial({ color: LAMP }));
    shape.position.copy(place);
    group.add(shape);
    for (let k = 0; k < 8 && lamp.type !== "beam"; ++k) { // its rays
      const way = new Vector3(Math.cos(Math.PI * k / 4), Math.sin(Math.PI * k / 4), 0);
      to(place.clone().addScaledVector(way, 1.5 * size), place.clone().addScaledVector(way, 2.4 * size));
    }
    if (lamp.type === "beam") to(place, place.clone().addScaledVector(new Vector3(...lamp.direction).normalize(), data.size_m / 6));
  }
  group.add(lines(out, LAMP, 0.9));
  return group;
}

// ---- sensors ----

function ring(center, u, v, radius, out) {
  for (let i = 0; i < RING_SIDES; ++i) {
    for (const k of [i, i + 1]) {
      const angle = 2 * Math.PI * k / RING_SIDES;
      const point = center.clone().addScaledVector(u, radius * Math.cos(angle)).addScaledVector(v, radius * Math.sin(angle));
      out.push(point.x, point.y, point.z);
    }
  }
}

// Ways along the border of what is in view, in turn: those of a frustum's
// picture, edge by edge, or of a cone's rim.
function border(sensor) {
  const axis = new Vector3(...sensor.axis), right = new Vector3(...sensor.right), up = new Vector3(...sensor.up);
  const ways = [];
  if (sensor.view === "cone") {
    const half = sensor.angles_rad[0] / 2;
    for (let i = 0; i < RING_SIDES; ++i) {
      const angle = 2 * Math.PI * i / RING_SIDES;
      ways.push(axis.clone().multiplyScalar(Math.cos(half)).addScaledVector(right, Math.sin(half) * Math.cos(angle))
        .addScaledVector(up, Math.sin(half) * Math.sin(angle)));
    }
    return ways;
  }
  const across = Math.tan(sensor.angles_rad[0] / 2), high = Math.tan(sensor.angles_rad[1] / 2);
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  corners.forEach(([a, b], k) => {
    const [c, d] = corners[(k + 1) % 4];
    for (let i = 0; i < ARC_SIDES; ++i) {
      const t = i / ARC_SIDES;
      ways.push(axis.clone().addScaledVector(right, (a + t * (c - a)) * across)
        .addScaledVector(up, (b + t * (d - b)) * high).normalize());
    }
  });
  return ways;
}

// Lines about what a sensor may see, true in shape: its border lies on the
// sphere of its range, and on that of its least range.
function reachLines(data, sensor, reach) {
  const place = from(data, sensor.place), out = [];
  const axis = new Vector3(...sensor.axis), right = new Vector3(...sensor.right), up = new Vector3(...sensor.up);
  const shells = sensor.least_range_m > 0 ? [sensor.least_range_m, reach] : [reach];
  const line = (a, b) => out.push(a.x, a.y, a.z, b.x, b.y, b.z);
  if (sensor.view === "sphere") {
    for (const radius of shells) {
      ring(place, right, up, radius, out);
      ring(place, right, axis, radius, out);
      ring(place, up, axis, radius, out);
    }
    return out;
  }
  const ways = border(sensor), at = (way, radius) => place.clone().addScaledVector(way, radius);
  for (const radius of shells) {
    ways.forEach((way, i) => line(at(way, radius), at(ways[(i + 1) % ways.length], radius)));
  }
  const spokes = sensor.view === "cone" ? RING_SIDES / 8 : ARC_SIDES;
  for (let i = 0; i < ways.length; i += spokes) line(shells.length > 1 ? at(ways[i], shells[0]) : place, at(ways[i], reach));
  return out;
}

const isAllRound = (sensor) => sensor.view === "sphere";

function marker(data, sensor) {
  const size = data.size_m / 95, material = new MeshBasicMaterial({ color: SENSOR });
  if (isAllRound(sensor)) return new Mesh(new SphereGeometry(size, 20, 12), material);
  // a horn that opens to where it looks
  const shape = new Mesh(new ConeGeometry(size, 2.4 * size, sensor.view === "cone" ? 20 : 4), material);
  shape.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, -1, 0), new Vector3(...sensor.axis)));
  return shape;
}

// Groups of markers, labels, and lines of ranges, by the sensors' numbers.
export function sensors(data, list) {
  const marks = new Group(), labels = new Group(), ranges = new Group();
  list.forEach((sensor, number) => {
    const shape = marker(data, sensor), place = from(data, sensor.place);
    shape.position.copy(place);
    shape.userData.number = number;
    marks.add(shape);
    // without a limit: as far as tells where it looks
    const reach = Math.min(sensor.range_m ?? data.size_m / 8, data.size_m);
    ranges.add(lines(reachLines(data, sensor, reach), SENSOR, 0.4));
  });
  // one label for those that stand together
  const groups = new Map();
  if (list.length <= NUMBERED) {
    list.forEach((sensor, number) => {
      const key = sensor.place.map((v) => Math.round(60 * v / data.size_m)).join();
      groups.set(key, [...(groups.get(key) ?? []), number]);
    });
  }
  for (const numbers of groups.values()) {
    const above = from(data, list[numbers[0]].place).add(new Vector3(0, 0, data.size_m / 38));
    labels.add(label(numbers.map((n) => n + 1).join(" · "), above, "#10141b", "#ffd400", 1.15));
  }
  return { marks, labels, ranges };
}

// ---- paths and readings ----

export function path(data) {
  const group = new Group(), out = [];
  const stops = data.path.map((place) => from(data, place));
  for (let i = 0; i + 1 < stops.length; ++i) out.push(...stops[i].toArray(), ...stops[i + 1].toArray());
  group.add(lines(out, PATH));
  if (stops.length > 0) {
    group.add(label("start", stops[0].clone().add(new Vector3(0, 0, -data.size_m / 38)), "#1c2430", "#ff8ad8"));
  }
  return group;
}

// Orange where more was measured than the model says, blue where less, white
// where they agree; full at three standard errors.
export function residualColor(residual) {
  if (residual === null) return new Color(0x999999);
  const t = Math.max(-1, Math.min(1, residual / 3));
  return new Color(0xf2f2f2).lerp(new Color(t > 0 ? 0xff8c1a : 0x2f8cff), Math.sqrt(Math.abs(t)));
}

export function readings(data) {
  const group = new Group(), ball = new SphereGeometry(data.size_m / 110, 16, 10);
  data.readings.forEach((reading, number) => {
    const color = residualColor(reading.residual), place = from(data, reading.place), to = from(data, reading.to);
    const shape = new Mesh(ball, new MeshBasicMaterial({ color }));
    shape.position.copy(place);
    shape.userData.reading = number;
    group.add(shape);
    if (place.distanceTo(to) > 0) {
      group.add(lines([...place.toArray(), ...to.toArray()], color));
      const end = new Mesh(ball, new MeshBasicMaterial({ color }));
      end.scale.setScalar(0.6);
      end.position.copy(to);
      end.userData.reading = number;
      group.add(end);
    }
  });
  return group;
}
