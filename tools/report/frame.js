// Where things are: the box's edges with metres, an arrow to the north, labels
// that keep their size on the screen.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, Group, LineBasicMaterial, LineSegments, SRGBColorSpace,
  Sprite, SpriteMaterial, Vector3,
} from "three";

const LINE = 0x8fa3bd, INK = "#dfe7f2";
const LABEL_PX = 15;

// Text as a sprite, `size` times as tall as others.
export function label(text, place, color = INK, ground = null, size = 1) {
  const canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
  const font = "700 40px system-ui, sans-serif";
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + 24;
  canvas.height = 56;
  if (ground) {
    pen.fillStyle = ground;
    pen.beginPath();
    pen.roundRect(0, 0, canvas.width, canvas.height, 28);
    pen.fill();
  }
  pen.font = font;
  pen.fillStyle = color;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(text, canvas.width / 2, canvas.height / 2 + 2);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({
    map: texture, sizeAttenuation: false, depthTest: false, transparent: true,
  }));
  sprite.position.copy(place);
  sprite.renderOrder = 10;
  sprite.userData = { aspect: canvas.width / canvas.height, size };
  return sprite;
}

// All labels under an object, as tall as text on a screen of so many pixels.
export function fitLabels(root, height, fieldTangent) {
  root.traverse((part) => {
    if (!part.isSprite) return;
    const tall = 2 * fieldTangent * LABEL_PX * 1.4 * part.userData.size / height;
    part.scale.set(tall * part.userData.aspect, tall, 1);
  });
}

export function lines(points, color, opacity = 1) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color, transparent: true, opacity }));
}

// 1, 2 or 5 times a power of ten, about a fifth of a length.
export function stepOf(length) {
  const rough = length / 5, ten = 10 ** Math.floor(Math.log10(rough)), share = rough / ten;
  return ten * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

const AXIS = ["x", "y", "z"];

// The floor's edges, one upright, and ticks where whole steps lie.
export function frame(data) {
  const group = new Group(), half = data.high.map((v, k) => Math.max(v - data.low[k], 0) / 2);
  const [x, y, z] = half, out = [];
  const edge = (a, b) => out.push(...a, ...b);
  edge([-x, -y, -z], [x, -y, -z]);
  edge([x, -y, -z], [x, y, -z]);
  edge([x, y, -z], [-x, y, -z]);
  edge([-x, y, -z], [-x, -y, -z]);
  edge([-x, y, -z], [-x, y, z]);
  const longest = stepOf(2 * Math.max(...half) || 1), tick = data.size_m / 70;
  // where each axis's edge begins, and outward from it
  const begins = [[-x, -y, -z], [-x, -y, -z], [-x, y, -z]], away = [[0, -1, 0], [-1, 0, 0], [-0.8, 0.6, 0]];
  for (let k = 0; k < 3; ++k) {
    // short sides have finer ones
    const step = Math.min(longest, stepOf(5 * Math.max(half[k], data.size_m / 25)));
    const user = (v) => (v + data.origin[k]) / step; // steps are whole in the user's coordinates
    const last = Math.floor(user(data.high[k]) + 1e-9);
    const put = (at, far) => new Vector3(...at.map((v, j) => v + far * tick * away[k][j]));
    let n = 0;
    for (let i = Math.ceil(user(data.low[k]) - 1e-9); i <= last; ++i, ++n) {
      const at = [...begins[k]];
      at[k] = i * step - data.origin[k] - data.middle[k];
      edge(at, put(at, 1).toArray());
      // at its foot the upright would write over the floor's
      if (k === 2 && at[2] + z < 2 * tick) continue;
      group.add(label(String(Number((i * step).toPrecision(12))), put(at, 2.6)));
    }
    const name = [...begins[k]];
    name[k] = k === 2 ? z + 3 * tick : half[k] / Math.max(n, 2);
    group.add(label(`${AXIS[k]} in m`, put(name, [6, 8, 0][k]), "#a9bad0"));
  }
  group.add(lines(out, LINE, 0.8));
  group.add(north(data, half, tick));
  return group;
}

// Before the floor's corner on the right.
function north(data, [x, y, z], tick) {
  const group = new Group(), way = new Vector3(...data.north), side = new Vector3(way.y, -way.x, 0);
  const length = 6 * tick;
  const foot = new Vector3(x + 5 * tick, -y - 5 * tick, -z).addScaledVector(way, -length / 2);
  const tip = foot.clone().addScaledVector(way, length), out = [];
  const to = (a, b) => out.push(a.x, a.y, a.z, b.x, b.y, b.z);
  to(foot, tip);
  for (const s of [-1, 1]) {
    to(tip, tip.clone().addScaledVector(way, -1.6 * tick).addScaledVector(side, s * 0.9 * tick));
  }
  group.add(lines(out, 0xffffff));
  group.add(label("N", tip.clone().addScaledVector(way, 1.8 * tick), "#ffffff"));
  return group;
}
