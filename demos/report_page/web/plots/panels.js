// The panels and the lid in three dimensions, coloured by a field; drawn when something changes.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, LineBasicMaterial, LineSegments, Mesh,
  MeshBasicMaterial, PerspectiveCamera, Scene, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { choice, h, missing, tick } from "./dom.js";
import { gradient, rangeOf, viridis } from "./colourmap.js";
import { show, unitText } from "./format.js";
import { colour } from "./theme.js";

// What can be shown as colour: [{name, unit, values}].
function fieldsOf({ quality, fields }) {
  return [...(fields ?? []), ...(quality
    ? [{ name: "quality: aspect ratio, 1 is best", unit: "", values: quality }] : [])];
}

const cornersOf = ({ faces }, panel) => faces.subarray(4 * panel, 4 * panel + 4);

// Panels `first` to before `end` as triangles of their own, so that each has one colour.
function surface(panels, first, end) {
  const positions = new Float32Array((end - first) * 18), { points } = panels;
  for (let panel = first, at = 0; panel < end; ++panel) {
    const [a, b, c, d] = cornersOf(panels, panel);
    for (const corner of [a, b, c, a, c, d]) {
      positions.set(points.subarray(3 * corner, 3 * corner + 3), at);
      at += 3;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(positions.length), 3));
  return geometry;
}

function edges(panels, first, end) {
  const positions = [];
  for (let panel = first; panel < end; ++panel) {
    const corners = cornersOf(panels, panel);
    corners.forEach((corner, i) => {
      for (const at of [corner, corners[(i + 1) % 4]]) {
        positions.push(...panels.points.subarray(3 * at, 3 * at + 3));
      }
    });
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  return geometry;
}

// Colours of a field, or one plain colour without; light from above shades the plain one.
function paint(geometry, values, first, range) {
  const colours = geometry.getAttribute("color"), tone = new Color();
  for (let i = 0; i < colours.count / 6; ++i) {
    if (values) {
      const [r, g, b] = viridis((values[first + i] - range.least) / (range.most - range.least));
      tone.setRGB(r / 255, g / 255, b / 255, "srgb");
    } else {
      tone.set(colour("--hull")).multiplyScalar(shade(geometry, i));
    }
    for (let corner = 0; corner < 6; ++corner) {
      colours.setXYZ(6 * i + corner, tone.r, tone.g, tone.b);
    }
  }
  colours.needsUpdate = true;
}

function shade(geometry, panel) {
  const p = geometry.getAttribute("position").array, at = 18 * panel;
  const [ux, uy, uz] = [0, 1, 2].map((k) => p[at + 6 + k] - p[at + k]);
  const [vx, vy, vz] = [0, 1, 2].map((k) => p[at + 15 + k] - p[at + 3 + k]);
  const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const size = Math.hypot(...n) || 1;
  return 0.62 + 0.38 * Math.abs(n[0] * 0.35 - n[1] * 0.7 + n[2] * 0.4) / size;
}

class PanelView {
  constructor(place, panels) {
    this.panels = panels;
    this.count = panels.faces.length / 4;
    this.hullEnd = this.count - (panels.lid ?? 0);
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    place.append(this.renderer.domElement);
    this.place = place;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(28, 2, 0.1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.enableZoom = false;
    this.controls.addEventListener("change", () => this.draw());
    this.addMeshes();
    this.look();
    new ResizeObserver(() => this.fit()).observe(place);
    addEventListener("themechange", () => this.show(this.shown));
  }

  addMeshes() {
    const material = new MeshBasicMaterial({ vertexColors: true, side: DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.lines = new LineBasicMaterial({ transparent: true, opacity: 0.45 });
    const part = (first, end) => {
      const geometry = surface(this.panels, first, end);
      const net = new LineSegments(edges(this.panels, first, end), this.lines);
      const mesh = new Mesh(geometry, material);
      mesh.add(net);
      this.scene.add(mesh);
      return { geometry, mesh, net, first };
    };
    this.parts = [part(0, this.hullEnd)];
    if (this.hullEnd < this.count) this.parts.push(part(this.hullEnd, this.count));
  }

  // From below, off the port bow, as near as the ship's length fits.
  look() {
    const { geometry } = this.parts[0];
    geometry.computeBoundingBox();
    geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere;
    const half = Math.tan(this.camera.fov * Math.PI / 360);
    const away = Math.max(0.95 * radius / (half * 2.4), 0.55 * radius / half);
    this.controls.target.copy(center);
    this.camera.position.set(0.5, 0.8, -0.35).normalize().multiplyScalar(away).add(center);
    this.camera.near = radius / 100;
    this.camera.far = radius * 20;
    this.controls.update();
  }

  show({ field, lid, net }) {
    this.shown = { field, lid, net };
    const range = field && rangeOf(field.values);
    this.lines.color.set(colour("--ink"));
    this.parts.forEach((part, i) => {
      const known = field && field.values.length >= (i ? this.count : this.hullEnd);
      paint(part.geometry, known ? field.values : null, part.first, range);
      part.net.visible = net;
      part.mesh.visible = i === 0 || lid;
    });
    this.draw();
    return range;
  }

  turn(dx, dy, by) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, -0.12 * dx);
    const flat = Math.hypot(offset.x, offset.y);
    const steep = Math.atan2(offset.z, flat) + 0.1 * dy, size = offset.length() * by;
    const kept = Math.min(1.5, Math.max(-1.5, steep));
    offset.set(offset.x / flat * Math.cos(kept), offset.y / flat * Math.cos(kept), Math.sin(kept));
    this.camera.position.copy(this.controls.target).addScaledVector(offset, size);
    this.controls.update();
    this.draw();
  }

  fit() {
    const { clientWidth, clientHeight } = this.place;
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.render(this.scene, this.camera);
  }
}

function colourBar(bar, field, range) {
  bar.hidden = !field;
  if (!field) return;
  const scale = h("div.scale");
  scale.style.background = gradient();
  const unit = unitText(field.unit);
  bar.replaceChildren(h("span", {}, field.name, unit ? ` [${unit}]` : ""), scale,
    h("div.ends", {}, ...[0, 0.5, 1].map((share) =>
      h("span", {}, show(range.least + share * (range.most - range.least), 3)))));
}

const KEYS = { ArrowLeft: [-1, 0, 1], ArrowRight: [1, 0, 1], ArrowUp: [0, 1, 1],
  ArrowDown: [0, -1, 1], "+": [0, 0, 0.85], "=": [0, 0, 0.85], "-": [0, 0, 1 / 0.85] };

/** Into `section`; without WebGL it throws, and the caller says so. */
export function panelView(section, panels) {
  const fields = fieldsOf(panels), state = { field: fields[0] ?? null, lid: false, net: true };
  const bar = h("div.colourbar");
  const place = h("div.view", { tabindex: 0, role: "group",
    "aria-label": "Panels in three dimensions. Arrow keys turn the ship, plus and minus zoom." });
  const view = new PanelView(place, panels);
  const update = () => colourBar(bar, state.field, view.show(state));
  place.addEventListener("keydown", (event) => {
    const move = KEYS[event.key];
    if (!move || event.ctrlKey || event.metaKey) return;
    view.turn(...move);
    event.preventDefault();
  });
  const zoom = (by) => () => view.turn(0, 0, by);
  section.append(h("div.controls", {},
    fields.length ? choice("Colour", [["", "none"], ...fields.map(({ name }, i) => [i, name])],
      0, (value) => {
        state.field = value === "" ? null : fields[value];
        update();
      }) : null,
    panels.lid ? tick(`lid (${panels.lid} panels)`, state.lid, (on) => {
      state.lid = on;
      update();
    }) : null,
    tick("edges", state.net, (on) => {
      state.net = on;
      update();
    }),
    h("button.quiet", { type: "button", onclick: zoom(0.8), "aria-label": "Nearer" }, "+"),
    h("button.quiet", { type: "button", onclick: zoom(1.25), "aria-label": "Farther" }, "−")),
  place, bar, h("p.note", {}, `${view.hullEnd} panels on the hull as solved`,
    panels.lid ? `, ${panels.lid} on the lid` : ", no lid", "."),
  h("p.note.hint", {}, "Drag to turn."));
  if (!fields.length) section.append(missing("The data has no field to show as colour."));
  view.fit();
  update();
}
