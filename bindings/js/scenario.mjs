// The common scenario through dragmesh.js: prints what bindings/scenario/scenario.c prints.
//   node bindings/js/scenario.mjs [MODULE.wasm [FOLDER_OF_WEIGHTS]]
import { readFileSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { load, Go, HandKind, InputFlag, LinkKind, ReleaseFlag, RuleFlag } from './dragmesh.js';

const FRAMES = 60, SHOWN_EVERY = 10, SAVED_AT = 30, RELEASED_FRAMES = 120, HANDLE_TURNS_AT = 25;
const DOOR = 1, DRAWER = 2;
const HANDLE_TURN = 1, WIDEST = 0.45, SNAPS = [0.2, 0.4]; // rad
const f32 = Math.fround; // C computes in single precision
const FRAME_TIME = f32(1 / 60);

// From x, y, z to x, y, z, and the part: samples/common/cabinet.h.
const BOXES = [
    [0.00, 0.00, 0.000, 0.60, 0.02, 0.40, 0], [0.00, 0.98, 0.000, 0.60, 1.00, 0.42, 0],
    [0.00, 0.02, 0.000, 0.02, 0.98, 0.40, 0], [0.58, 0.02, 0.000, 0.60, 0.98, 0.40, 0],
    [0.02, 0.02, 0.000, 0.58, 0.98, 0.02, 0], [0.00, 0.00, 0.402, 0.60, 0.79, 0.42, DOOR],
    [0.54, 0.35, 0.420, 0.56, 0.55, 0.45, DOOR], [0.00, 0.80, 0.402, 0.60, 0.97, 0.42, DRAWER],
    [0.25, 0.87, 0.420, 0.35, 0.89, 0.45, DRAWER], [0.04, 0.82, 0.030, 0.56, 0.83, 0.402, DRAWER],
    [0.04, 0.83, 0.030, 0.05, 0.95, 0.402, DRAWER], [0.55, 0.83, 0.030, 0.56, 0.95, 0.402, DRAWER],
    [0.05, 0.83, 0.030, 0.55, 0.95, 0.040, DRAWER],
];
const CORNERS = [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];

export function cabinet() {
    const corner = (box, v) => [0, 1, 2].map(k => box[v >> k & 1 ? k + 3 : k]);
    return {
        positions: new Float32Array(BOXES.flatMap(box => [0, 1, 2, 3, 4, 5, 6, 7].flatMap(v => corner(box, v)))),
        indices: new Uint16Array(BOXES.flatMap((_, b) => CORNERS.map(v => b * 8 + v))),
        partIds: new Uint8Array(BOXES.flatMap(box => Array(8).fill(box[6]))),
    };
}

const scratch = new DataView(new ArrayBuffer(4));
function bits(value) {
    scratch.setFloat32(0, value);
    return scratch.getUint32(0).toString(16).padStart(8, '0');
}
const print = text => console.log(text);
const printFloats = (name, values) => print([name, ...values.map(bits)].join(' '));

function printJoint(j) {
    print(`joint ${j.type} source ${j.source}`);
    printFloats(' ', [...j.axis, ...j.origin, j.lower, j.upper, j.typeConfidence, j.jointConfidence]);
}

function printState(name, s, events = s.events) {
    print(`${name} phase ${s.phase} events ${events} changes ${s.changes} basis ${s.jointBasis}`);
    printFloats(' ', [s.value, s.jointConfidence]);
    printFloats(' ', s.pose.real);
    printFloats(' ', s.pose.dual);
}

// The pointer's ray in a frame: it goes to the left and towards the camera.
function rayAt(frame) {
    const x = f32(f32(-0.35) - f32(f32(0.01) * frame)), z = f32(f32(-1.55) + f32(f32(0.005) * frame));
    return { origin: [0.9, 0.9, 2.0], direction: [x, -0.45, z] };
}

function printHypotheses(object, part) {
    const all = object.hypotheses(part);
    print(`part ${part} hypotheses ${all.length}`);
    printJoint(object.joint(part));
    all.forEach(printJoint);
}

function pick(context, object) {
    const scene = context.createScene();
    scene.add(object);
    scene.commit();
    const hit = scene.pick(rayAt(0));
    scene.destroy();
    print(`picked part ${hit.partId} triangle ${hit.triangle}`);
    printFloats(' ', hit.objectPoint);
    return hit;
}

function dragAndRelease(object, hit) {
    const desc = { partId: hit.partId, grabPoint: hit.objectPoint, rules: {} };
    const drag = object.beginDrag(desc);
    let events = 0, saved;
    for (let frame = 0; frame < FRAMES; frame++) {
        const state = drag.update(rayAt(frame), FRAME_TIME);
        events |= state.events;
        if (frame % SHOWN_EVERY === 0) printState('frame', state);
        if (frame === SAVED_AT) saved = drag.save();
    }
    drag.restore(saved);
    printState('restored', drag.update(rayAt(FRAMES), FRAME_TIME));
    const plan = drag.release({ intent: Go.OPEN, flags: ReleaseFlag.BY_RULE });
    printFloats('plan', [plan.endValue]);
    for (let frame = 0; frame < RELEASED_FRAMES; frame++) events |= drag.update(null, FRAME_TIME).events;
    printState('released', drag.state, events);
    const state = drag.end();
    const end = object.beginDrag({ ...desc, grabPoint: drag.state.grabPoint, state }).end();
    printFloats('again', [end.value]);
    printFloats(' ', end.pose.real);
    printFloats(' ', end.pose.dual);
    print(`evidence ${end.joint.evidence.join(' ')}`);
}

// The door is held by a latch until its handle turns, and opens no wider than the host takes.
function dragBehindLatch(object, hit) {
    const drag = object.beginDrag({ partId: hit.partId, grabPoint: hit.objectPoint, rules: { flags: RuleFlag.LATCH, snaps: SNAPS } });
    let events = 0, detents = 0;
    for (let frame = 0; frame < FRAMES; frame++) {
        const hand = { kind: HandKind.RAY, ray: rayAt(frame) };
        const handles = [frame < HANDLE_TURNS_AT ? 0 : HANDLE_TURN, 0];
        let state = drag.updateInput({ flags: InputFlag.ASK, hand, handles }, FRAME_TIME);
        if (state.value > f32(WIDEST)) state = drag.override(WIDEST);
        events |= state.events;
        detents += state.detents;
        if (frame % SHOWN_EVERY === 0) printState('latch', state);
    }
    printState('latched', drag.state, events);
    print(`detents ${detents}`);
    drag.destroy();
}

// The drawer comes along with the door, and holds it again once it is far out.
function followLinks(object) {
    object.setLinks([{ driver: DOOR, driven: DRAWER, ratio: 0.25, from: 0.1 }, { driver: DRAWER, driven: DOOR, kind: LinkKind.HOLDS, from: 0.05 }]);
    const values = [-0.9, 0];
    for (let i = 0; i < 2; i++) {
        const held = object.followLinks(DOOR, values);
        printFloats('linked', values);
        print(`held ${Number(held[0])} ${Number(held[1])}`);
        values[0] = 0.9;
    }
}

function saveAndLoad(context, object) {
    const data = object.save();
    const hash = data.reduce((h, byte) => Math.imul(h ^ byte, 16777619) >>> 0, 2166136261); // FNV-1a
    print(`saved ${data.length} bytes ${hash.toString(16).padStart(8, '0')}`);
    printJoint(context.loadObject(data).joint(DOOR));
}

async function main() {
    const [, , wasm, weights = 'sdk/models'] = process.argv;
    const dragmesh = await load({ wasm: wasm && pathToFileURL(wasm) });
    const context = dragmesh.createContext();
    const file = name => readFileSync(`${weights}/${name}.safetensors`);
    const model = context.loadModel({ kinematics: file('kpp_net'), motion: file('dq_vae'), ranker: file('ranker') });
    const mesh = cabinet();
    const object = context.prepare({ mesh, model, parts: [{ id: DOOR, label: 'kitchen/cabinet/door' }, { id: DRAWER, label: 'kitchen/cabinet/drawer' }] });
    printHypotheses(object, DOOR);
    printHypotheses(object, DRAWER);
    const hit = pick(context, object);
    dragAndRelease(object, hit);
    dragBehindLatch(object, hit);
    followLinks(object);
    saveAndLoad(context, object);
    try {
        context.prepare({ mesh: { ...mesh, indices: mesh.indices.subarray(0, 3 * 12) } }); // one box, without any part
    } catch (error) {
        print(`error ${error.code}`);
    }
    context.destroy();
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main();
