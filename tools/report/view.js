// The view in space of murk's report: what stands in the scene, stored photons
// by how many sensors see each, sensors with their ranges and views, media. Reads
// the data blocks that src/report/view_data.c writes; draws only when something
// has changed.
import {
  AmbientLight, Color, DirectionalLight, Group, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { element } from "./data.js";
import { fitLabels, frame } from "./frame.js";
import { Medium, cloud, level } from "./media.js";
import * as parts from "./parts.js";
import { Photons } from "./photons.js";
import { sayKey, sayPicked, sayReading } from "./say.js";

const FIELD_DEG = 40, TANGENT = Math.tan(FIELD_DEG * Math.PI / 360);
const GROUND = 0x10141b;
const LOOKS = { corner: [-0.55, -1, 0.7], above: [0, -1e-3, 1], side: [0, -1, 0.02] };

class View {
  constructor(canvas, data) {
    this.data = data;
    this.canvas = canvas;
    this.picked = -1;
    this.reading = -1;
    this.hidden = new Set();
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color(GROUND);
    this.camera = new PerspectiveCamera(FIELD_DEG, 1, data.size_m / 500, data.size_m * 30);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.minDistance = data.size_m / 100;
    this.controls.maxDistance = data.size_m * 12;
    this.controls.addEventListener("change", () => this.draw());
    this.scene.add(new AmbientLight(0xffffff, 1.5));
    const sun = new DirectionalLight(0xffffff, 2);
    sun.position.set(0.4, -0.7, 1);
    this.scene.add(sun);
    this.parts = {
      surfaces: parts.surfaces(data), lamps: parts.lamps(data), path: parts.path(data),
      readings: parts.readings(data), axes: frame(data),
    };
    for (const part of Object.values(this.parts)) this.scene.add(part);
    this.root = 0.5;
    this.choose(0);
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
    this.look("corner");
  }

  put(name, part) {
    const old = this.parts[name];
    if (old) {
      this.scene.remove(old);
      old.traverse((piece) => {
        piece.geometry?.dispose();
        piece.material?.map?.dispose();
        piece.material?.uniforms?.cells.value.dispose();
        piece.material?.dispose();
      });
    }
    this.parts[name] = part;
    if (!part) return;
    part.visible = !this.hidden.has(name);
    this.scene.add(part);
  }

  // A condition, or a row of a study.
  choose(state) {
    const now = this.data.states[state];
    this.state = state;
    this.photons = new Photons(this.data, state, 1 / TANGENT);
    this.put("surface-photons", this.photons.dots[0]);
    this.put("volume-photons", this.photons.dots[1]);
    this.sensors = parts.sensors(this.data, now.sensors);
    const shown = new Group();
    shown.add(this.sensors.marks, this.sensors.labels);
    this.put("sensors", shown);
    this.put("ranges", this.sensors.ranges);
    this.medium = new Medium(this.data, now.media);
    this.put("cloud", cloud(this.medium));
    this.cut();
    this.listSensors(now.sensors);
    this.pick(this.picked < now.sensors.length ? this.picked : -1);
    this.resize();
  }

  listSensors(list) {
    const choice = element("view-sensor");
    if (!choice) return;
    choice.replaceChildren(...[{ type: "none" }, ...list].map((sensor, i) => {
      const option = document.createElement("option");
      option.value = String(i - 1);
      option.textContent = i === 0 ? "none" : `${i}: ${sensor.type}`;
      return option;
    }));
  }

  // The surface on which the extinction is a share of the largest, whose root is
  // set. Made when it is looked at.
  cut() {
    const isWanted = !this.hidden.has("level");
    this.put("level", isWanted ? level(this.medium, this.root) : null);
    const said = element("view-level-said");
    if (said) {
      said.textContent = this.medium.there
        ? `${Number((this.root ** 2 * this.medium.most_per_m).toPrecision(3))} per m`
        : "none here";
    }
  }

  look(name) {
    const way = new Vector3(...LOOKS[name]).normalize(), target = new Vector3();
    const right = new Vector3(-way.y, way.x, 0).normalize(), up = new Vector3().crossVectors(way, right);
    let distance = 0;
    for (let pass = 0; pass < 4; ++pass) { // the middle of what is seen, not of the box
      distance = this.distance(way, right, up, target);
      const range = [right, up].map((axis) => {
        const seen = this.corners().map((c) => c.sub(target)).map((c) => c.dot(axis) / (distance - c.dot(way)));
        return (Math.min(...seen) + Math.max(...seen)) / 2 * distance;
      });
      target.addScaledVector(right, range[0]).addScaledVector(up, range[1]);
    }
    distance = this.distance(way, right, up, target);
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(way, distance);
    this.controls.update();
    this.draw();
  }

  // What is to be in view: the box, its labels, and where distant light comes from.
  corners() {
    const [x, y, z] = this.data.high.map((v, k) => (v - this.data.low[k]) / 2), t = this.data.size_m / 70;
    const box = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z));
    const words = [[x / 3, -y - 7 * t, -z], [-x - 11 * t, y / 3, -z], [-x - 4 * t, y, z + 4 * t], [x + 6 * t, -y - 8 * t, -z],
      [-x, -y - 4 * t, -z], [-x - 4 * t, -y, -z]];
    const arrows = parts.distant(this.data).map((arrow) => arrow.word);
    return [...box, ...words.map((place) => new Vector3(...place)), ...arrows];
  }

  // So far off that the box and its labels are in view.
  distance(way, right, up, target) {
    let most = 0;
    for (const corner of this.corners()) {
      corner.sub(target);
      const across = Math.abs(corner.dot(right)) / (TANGENT * this.camera.aspect), high = Math.abs(corner.dot(up)) / TANGENT;
      most = Math.max(most, 1.06 * Math.max(across, high) + corner.dot(way));
    }
    return Math.max(most, this.data.size_m / 3);
  }

  // Keys turn the view about its middle; + and - go nearer and away.
  turn(around, over, nearer) {
    const way = this.camera.position.clone().sub(this.controls.target);
    const length = way.length() * nearer;
    const turned = Math.atan2(way.y, way.x) + around;
    const height = Math.max(-1.5, Math.min(1.5, Math.asin(way.z / way.length()) + over));
    way.set(Math.cos(height) * Math.cos(turned), Math.cos(height) * Math.sin(turned), Math.sin(height));
    this.camera.position.copy(this.controls.target).addScaledVector(way, length);
    this.controls.update();
    this.draw();
  }

  show(name, isShown) {
    if (isShown) this.hidden.delete(name);
    else this.hidden.add(name);
    if (name === "level") this.cut();
    if (this.parts[name]) this.parts[name].visible = isShown;
    this.say();
    this.draw();
  }

  // picked < 0: none
  pick(picked) {
    this.picked = picked;
    this.reading = -1;
    this.sensors.marks.children.forEach((shape, k) => {
      shape.material.color.set(k === picked ? parts.PICKED : parts.SENSOR);
      const lines = this.sensors.ranges.children[k].material;
      lines.color.set(k === picked ? parts.PICKED : parts.SENSOR);
      lines.opacity = picked < 0 ? 0.4 : k === picked ? 0.95 : 0.1;
    });
    this.photons.paint(picked);
    const choice = element("view-sensor");
    if (choice) choice.value = String(picked);
    this.say();
    this.draw();
  }

  say() {
    const state = this.data.states[this.state];
    sayKey(element("view-key"), this.data, state, this.photons, this.picked, this.medium, this.hidden);
    element("view-picked").textContent = this.reading >= 0
      ? sayReading(this.data, this.data.readings[this.reading])
      : sayPicked(this.data, state, this.photons, this.picked);
  }

  pickAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const spot = new Vector2(2 * (event.clientX - box.left) / box.width - 1,
      1 - 2 * (event.clientY - box.top) / box.height);
    const ray = new Raycaster();
    ray.setFromCamera(spot, this.camera);
    const can = ["sensors", "readings"].filter((name) => !this.hidden.has(name));
    const met = can.flatMap((name) => {
      const part = name === "sensors" ? this.sensors.marks : this.parts.readings;
      return ray.intersectObjects(part.children.filter((piece) => piece.isMesh), false);
    }).sort((a, b) => a.distance - b.distance)[0]?.object.userData ?? {};
    this.pick(met.number ?? -1);
    this.reading = met.reading ?? -1;
    this.say();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    fitLabels(this.scene, height, TANGENT);
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}

function connectControls(view) {
  for (const box of document.querySelectorAll("#view input[type=checkbox]")) {
    const set = () => view.show(box.value, box.checked);
    box.addEventListener("change", set);
    set();
  }
  const press = { nearer: () => view.turn(0, 0, 0.85), farther: () => view.turn(0, 0, 1 / 0.85) };
  for (const button of document.querySelectorAll("#view button")) {
    button.addEventListener("click", press[button.value] ?? (() => view.look(button.value)));
  }
  const choice = element("view-sensor");
  choice?.addEventListener("change", () => view.pick(Number(choice.value)));
  const states = element("view-state");
  states?.addEventListener("change", () => view.choose(Number(states.value)));
  const slider = element("view-level");
  slider?.addEventListener("input", () => {
    view.root = Number(slider.value) / 100;
    const box = document.querySelector("#view input[value=level]");
    box.checked = true; // who moves it wants to see it
    view.show("level", true);
  });
}

function connectCanvas(view) {
  let down = null;
  view.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
  view.canvas.addEventListener("pointerup", (event) => {
    // a click, not a turn
    if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 4) view.pickAt(event);
  });
  const turns = {
    ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, 0.1, 1], ArrowDown: [0, -0.1, 1],
    "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1.1],
  };
  const step = (by) => {
    const n = view.data.states[view.state].sensors.length + 1;
    view.pick((view.picked + 1 + by + n) % n - 1);
  };
  const picks = { n: () => step(1), p: () => step(-1), Escape: () => view.pick(-1) };
  view.canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const pick = picks[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (turns[event.key]) view.turn(...turns[event.key]);
    else if (pick) pick();
    else return;
    event.preventDefault();
  });
}

function fail(section, text) {
  section.dataset.state = "failed";
  element("view-canvas").hidden = true;
  element("view-key").hidden = true;
  element("view-picked").textContent = text;
}

// Fills the view's part of the page, which where.js has made.
export function showView(data) {
  const section = element("view");
  try {
    const view = new View(element("view-canvas"), data);
    connectControls(view);
    connectCanvas(view);
    section.dataset.state = "drawn";
    view.canvas.addEventListener("webglcontextlost", () => fail(section,
      "The browser has taken the view away (its graphics were lost). The drawings below show the same."));
    view.canvas.addEventListener("webglcontextrestored", () => {
      section.dataset.state = "drawn";
      element("view-canvas").hidden = element("view-key").hidden = false;
      view.pick(view.picked);
    });
  } catch (problem) {
    fail(section, "This browser draws nothing in space (no WebGL). The drawings below show the same.");
  }
}
