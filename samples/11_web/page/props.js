// The objects that come with the page, drawn by code. Metres, +Y up, the front towards +Z. What moves is a node of its own, as in most
// files; nothing here says how it moves. The toolbox is one mesh: its lid is found from its shape.
import { BufferAttribute, BufferGeometry, CatmullRomCurve3, CircleGeometry, Color, CylinderGeometry, ExtrudeGeometry, Group, LatheGeometry,
    Mesh, MeshPhysicalMaterial, MeshStandardMaterial, PlaneGeometry, Shape, SphereGeometry, TorusGeometry, TubeGeometry, Vector2, Vector3 } from './three/three.module.min.js';
import { RoundedBoxGeometry } from './three/addons/geometries/RoundedBoxGeometry.js';
import { wallpaper, wood } from './textures.js';

const WOOD_SIZE = 0.55; // m that the picture of wood is wide

// Maps a picture onto a geometry from the six sides, its u along `grain` (0, 1, 2: x, y, z) where that side has it.
function mapBox(geometry, grain = 0, offset = 0) {
    const { position, normal } = geometry.attributes, uv = new Float32Array(2 * position.count);
    for (let i = 0; i < position.count; i++) {
        const n = [normal.getX(i), normal.getY(i), normal.getZ(i)].map(Math.abs), p = [position.getX(i), position.getY(i), position.getZ(i)];
        const across = [0, 1, 2].filter(k => k !== n.indexOf(Math.max(...n)));
        const u = across.includes(grain) ? grain : across[0], v = across.find(k => k !== u);
        uv[2 * i] = p[u] / WOOD_SIZE + offset;
        uv[2 * i + 1] = p[v] / WOOD_SIZE + offset * 1.7;
    }
    geometry.setAttribute('uv', new BufferAttribute(uv, 2));
    return geometry;
}

let pieces = 0; // so that no two boards show the same grain
function board(parent, material, [w, h, d], [x, y, z], { grain = 0, radius = 0.004, name = '' } = {}) {
    const geometry = mapBox(new RoundedBoxGeometry(w, h, d, 3, Math.min(radius, w / 2.01, h / 2.01, d / 2.01)), grain, 0.37 * pieces++);
    return add(parent, geometry, material, [x, y, z], name);
}

function add(parent, geometry, material, [x, y, z], name = '') {
    const mesh = new Mesh(geometry, material);
    mesh.position.set(x, y, z);
    mesh.name = name;
    parent.add(mesh);
    return mesh;
}

// A node, which is one piece, with its own origin where an artist would put it. What is added to it is given in the object's frame.
function node(parent, name, [x, y, z] = [0, 0, 0]) {
    const group = new Group(), inner = new Group();
    group.name = name;
    group.userData.piece = true;
    group.position.set(x, y, z);
    inner.position.set(-x, -y, -z);
    group.add(inner);
    parent.add(group);
    return inner;
}

const metal = (color, roughness = 0.3) => new MeshStandardMaterial({ color, metalness: 1, roughness });
const matt = (color, roughness = 0.7) => new MeshStandardMaterial({ color, roughness });
const brass = () => metal(0xc9a35c, 0.26);

function knob(parent, material, [x, y, z], size = 0.015) {
    const outline = [[0, 0], [0.42, 0], [0.42, 0.1], [0.26, 0.2], [0.24, 0.9], [0.5, 1.25], [0.86, 1.5], [1, 1.8], [0.92, 2.12], [0.55, 2.34], [0, 2.4]];
    const mesh = add(parent, new LatheGeometry(outline.map(([r, h]) => new Vector2(r * size, h * size)), 40), material, [x, y, z], 'knob');
    mesh.rotation.x = Math.PI / 2;
    return mesh;
}

// ---- a sideboard of walnut -----------------------------------------------------------------------------------------------------

function sideboard() {
    const root = new Group(), walnut = new MeshStandardMaterial({ map: wood([62, 36, 22], [128, 82, 52], 2), roughness: 0.5 });
    const inside = new MeshStandardMaterial({ map: wood([150, 112, 74], [196, 158, 114], 5), roughness: 0.62 }), gold = brass();
    const W = 1.5, H = 0.5, D = 0.42, T = 0.022, base = 0.19, front = D / 2;
    const body = node(root, 'sideboard');
    board(body, walnut, [W, T, D], [0, base + T / 2, 0]);
    board(body, walnut, [W, T, D], [0, base + H - T / 2, 0], { radius: 0.006 });
    for (const side of [-1, 1]) board(body, walnut, [T, H - 2 * T, D], [side * (W - T) / 2, base + H / 2, 0], { grain: 1 });
    for (const side of [-1, 1]) board(body, inside, [T * 0.8, H - 2 * T, D - 0.03], [side * W * 0.167, base + H / 2, -0.015], { grain: 1 });
    board(body, inside, [W - 2 * T, H - 2 * T, 0.008], [0, base + H / 2, -D / 2 + 0.01]);
    for (const side of [-1, 1]) board(body, inside, [W * 0.333 - 2.2 * T, 0.012, D - 0.05], [side * W * 0.333, base + H * 0.5, -0.02]);
    for (const [sx, sz] of [[-1, -1], [1, -1], [-1, 1], [1, 1]]) {
        const leg = new Group();
        leg.position.set(sx * (W / 2 - 0.13), base / 2, sz * (D / 2 - 0.075));
        leg.rotation.set(-sz * 0.12, 0, sx * 0.14);
        body.add(leg);
        add(leg, new CylinderGeometry(0.021, 0.0125, base * 0.86, 28), walnut, [0, base * 0.09, 0], 'leg');
        add(leg, new CylinderGeometry(0.0127, 0.0105, base * 0.17, 28), gold, [0, -base * 0.425, 0], 'foot');
    }
    add(body, vase(), new MeshPhysicalMaterial({ color: 0xe9e2d4, roughness: 0.35, clearcoat: 0.4 }), [-0.5, base + H, 0.02], 'vase');
    const books = [[0x7c8f86, 0.2], [0xb9664a, 0.24], [0xe3d6bd, 0.22]];
    books.forEach(([color, depth], i) => board(body, matt(color, 0.8), [0.3 - i * 0.03, 0.026, depth - 0.03], [0.48 + 0.012 * i, base + H + 0.013 + 0.026 * i, 0.01 * i], { radius: 0.003 }));
    const inner = (H - 2 * T) - 0.006, wide = W * 0.333 - T - 0.008;
    for (const side of [-1, 1]) {
        const door = node(root, side < 0 ? 'door_left' : 'door_right', [side * (W * 0.329 + wide / 2), base + H / 2, front]);
        board(door, walnut, [wide, inner, 0.02], [side * W * 0.329, base + H / 2, front - 0.006], { name: 'panel' });
        knob(door, gold, [side * (W * 0.329 - wide / 2 + 0.045), base + H / 2 + 0.05, front + 0.004]);
    }
    const tall = (inner - 0.012) / 3;
    for (let i = 0; i < 3; i++) {
        const drawer = node(root, `drawer_${['bottom', 'middle', 'top'][i]}`), y = base + T + 0.003 + tall / 2 + i * (tall + 0.006), deep = D - 0.07, w = wide - 0.012;
        board(drawer, walnut, [wide, tall, 0.02], [0, y, front - 0.006], { name: 'front' });
        board(drawer, inside, [w, 0.008, deep], [0, y - tall / 2 + 0.014, front - 0.016 - deep / 2]);
        for (const side of [-1, 1]) board(drawer, inside, [0.01, tall * 0.72, deep], [side * (w / 2 - 0.005), y - tall * 0.08, front - 0.016 - deep / 2], { grain: 2 });
        board(drawer, inside, [w, tall * 0.72, 0.01], [0, y - tall * 0.08, front - 0.02 - deep]);
        knob(drawer, gold, [0, y, front + 0.004], 0.013);
    }
    return root;
}

function vase() {
    const outline = new CatmullRomCurve3([[0.001, 0], [0.05, 0.002], [0.075, 0.06], [0.068, 0.13], [0.03, 0.19], [0.022, 0.24], [0.032, 0.27]].map(([r, h]) => new Vector3(r, h, 0)));
    return new LatheGeometry(outline.getPoints(60).map(p => new Vector2(Math.max(p.x, 0), p.y)), 64);
}

// ---- a chest of oak with iron bands --------------------------------------------------------------------------------------------

function chest() {
    const root = new Group(), oak = new MeshStandardMaterial({ map: wood([98, 62, 34], [168, 118, 72], 9), roughness: 0.66 });
    const dark = new MeshStandardMaterial({ map: wood([60, 38, 22], [106, 72, 44], 4), roughness: 0.75 }), iron = metal(0x3b3d42, 0.5), gold = metal(0xb98e42, 0.34);
    const W = 0.78, D = 0.46, H = 0.34, T = 0.024, planks = 3;
    const body = node(root, 'chest');
    for (let i = 0; i < planks; i++) {
        const h = H / planks, y = h * (i + 0.5) + 0.02;
        for (const side of [-1, 1]) {
            board(body, oak, [W, h - 0.002, T], [0, y, side * (D - T) / 2], { radius: 0.005 });
            board(body, oak, [T, h - 0.002, D - 2 * T], [side * (W - T) / 2, y, 0], { grain: 2, radius: 0.005 });
        }
    }
    board(body, dark, [W, 0.02, D], [0, 0.012, 0]);
    for (const x of [-0.25, 0.25]) {
        board(body, iron, [0.042, H + 0.004, 0.007], [x, H / 2 + 0.02, D / 2 + 0.002], { radius: 0.002 });
        board(body, iron, [0.042, H + 0.004, 0.007], [x, H / 2 + 0.02, -D / 2 - 0.002], { radius: 0.002 });
        for (const y of [0.07, 0.19, 0.31]) rivet(body, iron, [x, y, D / 2 + 0.005]);
    }
    for (const side of [-1, 1]) for (const z of [-1, 1]) board(body, iron, [0.03, H + 0.004, 0.03], [side * (W / 2 - 0.006), H / 2 + 0.02, z * (D / 2 - 0.006)], { radius: 0.003 });
    for (const side of [-1, 1]) {
        const ring = add(body, new TorusGeometry(0.05, 0.008, 16, 48, Math.PI), iron, [side * (W / 2 + 0.012), 0.24, 0], 'handle');
        ring.rotation.set(Math.PI, Math.PI / 2, 0);
    }
    board(body, gold, [0.09, 0.085, 0.008], [0, H - 0.03, D / 2 + 0.004], { radius: 0.004, name: 'lock' });
    add(body, new CylinderGeometry(0.009, 0.009, 0.006, 24), matt(0x15120c), [0, H - 0.028, D / 2 + 0.007]).rotation.x = Math.PI / 2;
    const y = H + 0.024, lid = node(root, 'lid', [0, y, -D / 2]);
    add(lid, mapBox(barrel(W, D / 2, T), 0, 0.3), oak, [0, y, 0], 'lid_shell');
    for (const x of [-0.25, 0.25]) {
        add(lid, barrel(0.042, D / 2 + 0.005, 0.006), iron, [x, y, 0], 'band');
        for (const a of [0.25, 0.75, 1.25, 1.9, 2.5]) rivet(lid, iron, [x, y + Math.sin(a) * (D / 2 + 0.006) * 0.72, Math.cos(a) * (D / 2 + 0.006)], Math.PI / 2 - a);
    }
    board(lid, gold, [0.05, 0.07, 0.01], [0, y + 0.022, D / 2 + 0.006], { radius: 0.004, name: 'hasp' });
    return root;
}

function rivet(parent, material, place, tilt = 0) {
    const mesh = add(parent, new SphereGeometry(0.007, 16, 10, 0, 2 * Math.PI, 0, Math.PI / 2), material, place, 'rivet');
    mesh.rotation.x = Math.PI / 2 - tilt;
}

// Half a flattened barrel, hollow, with its ends: along x, round above the plane y = 0.
function barrel(width, radius, thick) {
    const flat = 0.72, outer = new Shape(), steps = 48;
    const at = (r, i) => [Math.cos(Math.PI * i / steps) * r, Math.sin(Math.PI * i / steps) * r * flat];
    outer.moveTo(...at(radius, 0));
    for (let i = 1; i <= steps; i++) outer.lineTo(...at(radius, i));
    for (let i = steps; i >= 0; i--) outer.lineTo(...at(radius - thick, i));
    const shell = new ExtrudeGeometry(outer, { depth: width, bevelEnabled: false, curveSegments: 48 });
    if (thick < 0.01) return shell.translate(0, 0, -width / 2).rotateY(Math.PI / 2);
    const end = new Shape();
    end.moveTo(...at(radius - thick * 0.5, 0));
    for (let i = 1; i <= steps; i++) end.lineTo(...at(radius - thick * 0.5, i));
    const plate = new ExtrudeGeometry(end, { depth: thick, bevelEnabled: false });
    return merge([shell, plate.clone(), plate.clone().translate(0, 0, width - thick)]).translate(0, 0, -width / 2).rotateY(Math.PI / 2);
}

// ---- a laptop ------------------------------------------------------------------------------------------------------------------

function laptop() {
    const root = new Group(), shell = metal(0xb9bcc2, 0.42), keys = matt(0x24262b, 0.6), glass = new MeshPhysicalMaterial({ color: 0x050507, roughness: 0.12, clearcoat: 1 });
    const W = 0.32, D = 0.22, T = 0.012;
    const body = node(root, 'base');
    board(body, shell, [W, T, D], [0, T / 2 + 0.002, 0], { radius: 0.006 });
    for (const [x, z] of [[-1, -1], [1, -1], [-1, 1], [1, 1]]) add(body, new CylinderGeometry(0.008, 0.008, 0.003, 20), keys, [x * 0.14, 0.0015, z * 0.09], 'foot');
    board(body, matt(0x8b8e94, 0.5), [W * 0.88, 0.0012, D * 0.5], [0, T + 0.0022, -D * 0.17], { radius: 0.0005 });
    const rows = [[14, 0.5], [14, 1], [13, 1], [12, 1], [11, 1]], pitch = W * 0.86 / 14;
    rows.forEach(([count, tall], r) => {
        const w = W * 0.86 / count;
        for (let i = 0; i < count; i++) board(body, keys, [w - 0.0022, 0.0022, pitch * 0.86 * tall], [-W * 0.43 + w * (i + 0.5), T + 0.0036, -D * 0.385 + pitch * 0.86 * (r + (r ? 0.12 : 0.2))], { radius: 0.001 });
    });
    [1.4, 1.4, 1.4, 5, 1.4, 1.4, 1.4].reduce((x, w) => {
        board(body, keys, [w * pitch - 0.0022, 0.0022, pitch * 0.82], [x + w * pitch / 2, T + 0.0036, -D * 0.385 + pitch * 0.86 * 5.12], { radius: 0.001 });
        return x + w * pitch;
    }, -W * 0.43);
    board(body, metal(0xa6a9af, 0.36), [0.105, 0.0012, 0.062], [0, T + 0.0022, D * 0.3], { radius: 0.0005, name: 'touchpad' });
    const axle = [0, T + 0.006, -D / 2 + 0.006], hinge = new Group();
    node(root, 'screen', axle).add(hinge);
    hinge.position.set(...axle);
    hinge.rotation.x = -0.32; // open already: a little more than upright
    board(hinge, shell, [W, D, 0.006], [0, D / 2, 0], { radius: 0.0029 });
    board(hinge, glass, [W - 0.008, D - 0.008, 0.001], [0, D / 2, 0.0031], { radius: 0.0004 });
    const picture = new MeshStandardMaterial({ color: 0x000000, emissive: 0xffffff, emissiveMap: wallpaper(), emissiveIntensity: 0.9, roughness: 0.3 });
    add(hinge, new PlaneGeometry(W - 0.024, D - 0.03), picture, [0, D / 2 + 0.002, 0.0039], 'picture');
    add(hinge, new CylinderGeometry(0.0045, 0.0045, W * 0.7, 24), matt(0x2b2d31), [0, 0, 0], 'barrel').rotation.z = Math.PI / 2;
    return root;
}

// ---- a washing machine ---------------------------------------------------------------------------------------------------------

function washer() {
    const root = new Group(), enamel = new MeshPhysicalMaterial({ color: 0xf3f3f0, roughness: 0.34, clearcoat: 0.5, clearcoatRoughness: 0.3 });
    const chrome = metal(0xd6d8dc, 0.16), dark = matt(0x1d1f23, 0.45), steel = metal(0x9b9ea4, 0.38), grey = matt(0xd7d8d6, 0.5);
    const W = 0.6, H = 0.85, D = 0.56, T = 0.02, front = D / 2, cy = 0.4, hole = 0.185;
    const body = node(root, 'washer');
    for (const side of [-1, 1]) board(body, enamel, [T, H - 0.03, D], [side * (W - T) / 2, H / 2 + 0.005, 0], { radius: 0.008 });
    board(body, enamel, [W, 0.03, D + 0.006], [0, H + 0.003, 0.003], { radius: 0.01 });
    board(body, enamel, [W, T, D], [0, 0.03, 0], { radius: 0.006 });
    board(body, enamel, [W - 2 * T, H - 0.06, T], [0, H / 2, -D / 2 + T / 2]);
    const plate = new Shape(), half = W / 2 - 0.002;
    plate.moveTo(-half, 0.022).lineTo(half, 0.022).lineTo(half, 0.706).lineTo(-half, 0.706);
    plate.holes.push(circle(0, cy, hole));
    add(body, new ExtrudeGeometry(plate, { depth: T, bevelEnabled: true, bevelSize: 0.002, bevelThickness: 0.002, curveSegments: 64 }), enamel, [0, 0, front - T], 'front');
    const drum = add(body, new CylinderGeometry(hole + 0.03, hole + 0.03, 0.3, 64, 1, true), steel, [0, cy, front - 0.19], 'drum');
    drum.rotation.x = Math.PI / 2;
    drum.material.side = 2;
    add(body, new CircleGeometry(hole + 0.03, 64), steel, [0, cy, front - 0.34], 'drum_end');
    add(body, new TorusGeometry(hole + 0.004, 0.013, 24, 80), grey, [0, cy, front - 0.006], 'seal');
    board(body, enamel, [W * 0.63, 0.118, T], [W * 0.18, 0.768, front - T / 2], { radius: 0.005, name: 'panel' });
    board(body, dark, [0.15, 0.056, 0.004], [0.165, 0.77, front + 0.001], { radius: 0.0015, name: 'display' });
    const lit = new MeshStandardMaterial({ color: 0x000000, emissive: new Color(0x8fd6e8), emissiveIntensity: 0.9 });
    for (let i = 0; i < 4; i++) board(body, lit, [i === 1 ? 0.004 : 0.018, 0.022, 0.001], [0.118 + 0.026 * i, 0.772, front + 0.0035], { radius: 0.0004 });
    for (const [x, z] of [[-1, -1], [1, -1], [-1, 1], [1, 1]]) add(body, new CylinderGeometry(0.022, 0.026, 0.022, 24), dark, [x * 0.25, 0.011, z * 0.22], 'foot');
    const tray = node(root, 'detergent_drawer');
    board(tray, enamel, [W * 0.36, 0.116, T], [-W * 0.318, 0.768, front - T / 2 + 0.001], { radius: 0.005, name: 'front' });
    board(tray, grey, [W * 0.26, 0.014, 0.014], [-W * 0.318, 0.742, front + 0.006], { radius: 0.006, name: 'grip' });
    board(tray, grey, [W * 0.31, 0.01, 0.24], [-W * 0.318, 0.726, front - 0.14]);
    for (const side of [-1, 1]) board(tray, grey, [0.008, 0.066, 0.24], [-W * 0.318 + side * W * 0.15, 0.755, front - 0.14]);
    board(tray, grey, [W * 0.31, 0.066, 0.008], [-W * 0.318, 0.755, front - 0.256]);
    const dial = node(root, 'dial');
    const turned = add(dial, new LatheGeometry([[0, 0], [0.036, 0], [0.036, 0.006], [0.03, 0.009], [0.029, 0.03], [0.026, 0.034], [0, 0.035]].map(([r, h]) => new Vector2(r, h)), 64), chrome, [0.035, 0.77, front + 0.0005], 'dial_body');
    turned.rotation.x = Math.PI / 2;
    board(dial, dark, [0.004, 0.022, 0.003], [0.035, 0.786, front + 0.0355], { radius: 0.001, name: 'mark' });
    const door = node(root, 'door', [-hole - 0.056, cy, front + 0.014]);
    add(door, new TorusGeometry(hole + 0.018, 0.026, 32, 96), chrome, [0, cy, front + 0.018], 'ring').scale.z = 0.7;
    const bowl = [[0, -0.09], [0.07, -0.084], [0.12, -0.06], [0.15, -0.02], [0.168, 0.012], [0.14, 0.026], [0.08, 0.034], [0, 0.037]];
    const glass = new MeshPhysicalMaterial({ color: 0x36424c, roughness: 0.06, metalness: 0.1, clearcoat: 1, transparent: true, opacity: 0.62 });
    add(door, new LatheGeometry(bowl.map(([r, h]) => new Vector2(r, h)), 80), glass, [0, cy, front + 0.016], 'glass').rotation.x = Math.PI / 2;
    board(door, chrome, [0.024, 0.09, 0.018], [hole + 0.036, cy, front + 0.036], { radius: 0.008, name: 'handle' });
    // A plate that the ring is fixed to, with two knuckles; the third one is the body's.
    board(door, chrome, [0.05, 0.15, 0.01], [-hole - 0.026, cy, front + 0.014], { radius: 0.004, name: 'plate' });
    for (const side of [-1, 1]) add(door, new CylinderGeometry(0.011, 0.011, 0.048, 32), steel, [-hole - 0.056, cy + side * 0.05, front + 0.014], 'knuckle');
    add(body, new CylinderGeometry(0.0105, 0.0105, 0.048, 32), steel, [-hole - 0.056, cy, front + 0.014], 'knuckle');
    board(body, steel, [0.02, 0.16, 0.006], [-hole - 0.068, cy, front + 0.003], { radius: 0.002, name: 'hinge' });
    return root;
}

function circle(x, y, radius) {
    const shape = new Shape();
    shape.absarc(x, y, radius, 0, 2 * Math.PI, true);
    return shape;
}

// ---- a toolbox: one mesh with colours at its vertices --------------------------------------------------------------------------

function toolbox() {
    const W = 0.46, D = 0.22, H = 0.16, T = 0.008, red = 0xb23a2e, black = 0x222326, steel = 0x9da1a6, shapes = [];
    const box = (size, place, color, radius = 0.003) => shapes.push([new RoundedBoxGeometry(...size, 3, Math.min(radius, Math.min(...size) / 2.01)).translate(...place), color]);
    box([W, T, D], [0, T / 2 + 0.006, 0], red);
    for (const side of [-1, 1]) {
        box([W, H, T], [0, H / 2 + 0.006, side * (D - T) / 2], red);
        box([T, H, D], [side * (W - T) / 2, H / 2 + 0.006, 0], red);
        box([0.05, 0.012, D + 0.004], [side * 0.18, 0.006, 0], black);
        box([0.04, 0.05, 0.008], [side * 0.13, H - 0.028, D / 2 + 0.003], steel, 0.003);
    }
    const y = H + 0.009, tall = 0.055;
    box([W + 0.004, T, D + 0.004], [0, y + tall, 0], red, 0.004);
    for (const side of [-1, 1]) {
        box([W + 0.004, tall, T], [0, y + tall / 2, side * (D - T + 0.004) / 2], red);
        box([T, tall, D + 0.004], [side * (W - T + 0.004) / 2, y + tall / 2, 0], red);
        box([0.03, 0.026, 0.02], [side * 0.1, y + tall + 0.014, 0], black, 0.006);
    }
    const grip = new CatmullRomCurve3([[-0.1, 0.02], [-0.095, 0.052], [-0.06, 0.064], [0, 0.067], [0.06, 0.064], [0.095, 0.052], [0.1, 0.02]].map(([x, h]) => new Vector3(x, y + tall + h, 0)));
    shapes.push([new TubeGeometry(grip, 64, 0.009, 20), black]);
    for (const side of [-1, 1]) box([0.034, 0.03, 0.007], [side * 0.13, y + 0.013, D / 2 + 0.005], steel, 0.003);
    const root = new Group();
    root.add(new Mesh(merge(shapes.map(([geometry, color]) => coloured(geometry, color))), new MeshStandardMaterial({ vertexColors: true, roughness: 0.42, metalness: 0.15 })));
    return root;
}

function coloured(geometry, value) {
    const color = new Color(value), { count } = geometry.attributes.position;
    geometry.setAttribute('color', new BufferAttribute(Float32Array.from({ length: 3 * count }, (_, i) => color.toArray()[i % 3]), 3));
    return geometry;
}

// One geometry of several: positions, normals, uv and colours where the first one has them.
function merge(list) {
    const names = ['position', 'normal', 'uv', 'color'].filter(name => list[0].attributes[name]), out = new BufferGeometry(), order = [];
    for (const name of names) {
        const { itemSize } = list[0].attributes[name];
        out.setAttribute(name, new BufferAttribute(Float32Array.from(list.flatMap(geometry => [...geometry.attributes[name].array])), itemSize));
    }
    let first = 0;
    for (const geometry of list) {
        const { count } = geometry.attributes.position;
        for (let i = 0; i < (geometry.index?.count ?? count); i++) order.push(first + (geometry.index ? geometry.index.getX(i) : i));
        first += count;
    }
    out.setIndex(order);
    return out;
}

/** What the page offers, first what it begins with. turn, tilt: where the camera stands, rad. */
export const props = [
    { id: 'sideboard', title: 'Sideboard', make: sideboard, view: { turn: 0.5, tilt: 0.26 } },
    { id: 'chest', title: 'Chest', make: chest, view: { turn: 0.55, tilt: 0.3 } },
    { id: 'washer', title: 'Washing machine', make: washer, view: { turn: 0.5, tilt: 0.22 } },
    { id: 'laptop', title: 'Laptop', make: laptop, view: { turn: 0.6, tilt: 0.38 } },
    { id: 'toolbox', title: 'Toolbox, one mesh', make: toolbox, view: { turn: 0.6, tilt: 0.36 } },
];
