// The module in node against the native library, in one run: tests/web/bench.sh runs it.
//   node tests/web/bench.mjs NATIVE_PROGRAM MESH_FILE
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { load, DragFlag, Picking } from '../../bindings/js/dragmesh.js';

const [, , native, meshFile] = process.argv;
const PREPARES = 7, BATCHES = 30, BATCH = 1000, ROUNDS = 3;
const budgets = { prepare: 4, drag_update_joint_known: 3, drag_update_joint_open: 3 }; // times native: issue of the web

const median = times => times.sort((a, b) => a - b)[times.length >> 1];
const us = start => (performance.now() - start) * 1e3;

function readMesh() {
    const data = readFileSync(meshFile), buffer = data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
    const [vertices, count] = new Uint32Array(buffer, 0, 2);
    const indexAt = 8 + 12 * vertices;
    return { positions: new Float32Array(buffer, 8, 3 * vertices), indices: new Uint32Array(buffer, indexAt, count),
        partIds: new Uint8Array(buffer, indexAt + 4 * count, vertices) };
}

const dragmesh = await load({ wasm: new URL('../../build/web/dragmesh.wasm', import.meta.url) });
const context = dragmesh.createContext({ picking: Picking.NONE });
const file = name => readFileSync(new URL(`../../sdk/models/${name}.safetensors`, import.meta.url));
const model = context.loadModel({ kinematics: file('kpp_net'), motion: file('dq_vae'), ranker: file('ranker') });

function timePrepare(mesh) {
    const times = [];
    let object;
    for (let i = 0; i < PREPARES; i++) {
        object?.destroy();
        const start = performance.now();
        object = context.prepare({ mesh, model, picking: false });
        times.push(us(start));
    }
    return [object, median(times)];
}

// raw: the function of C alone, as native is timed; else Drag.update with its objects.
function timeDrag(object, flags, raw) {
    const drag = object.beginDrag({ partId: 1, grabPoint: [0.55, 0.45, 0.45], flags });
    const { exports } = dragmesh, { live, library } = context, ray = { origin: [0.9, 0.9, 2], direction: [0, -0.45, -1.55] };
    drag.update({ ...ray, direction: [-0.35, -0.45, -1.55] }, 1 / 60);
    const times = [];
    for (let b = 0; b < BATCHES; b++) {
        const numbers = new Float32Array(exports.memory.buffer, library.ray, 6), start = performance.now();
        for (let i = 0; i < BATCH; i++) {
            const x = -0.35 - 0.0005 * i;
            if (raw) {
                numbers[3] = x;
                exports.dm_drag_update(live.address, drag.handle, library.ray, 1 / 60, library.state);
            } else {
                ray.direction[0] = x;
                drag.update(ray, 1 / 60);
            }
        }
        times.push(us(start) / BATCH);
    }
    drag.destroy();
    return median(times);
}

const rows = {};
const note = (name, side, value) => { rows[name] = { ...rows[name], [side]: Math.min(rows[name]?.[side] ?? Infinity, value) }; };
for (let round = 0; round < ROUNDS; round++) {
    const lines = execFileSync(native, [meshFile, new URL('../../sdk/models', import.meta.url).pathname], { encoding: 'utf8' }).trim().split('\n');
    for (const [name, value] of lines.map(line => line.split(' '))) note(name, 'native', Number(value));
    const [object, prepare] = timePrepare(readMesh());
    note('prepare', 'wasm', prepare);
    for (const [name, flags] of [['drag_update_joint_known', DragFlag.KEEP_JOINT], ['drag_update_joint_open', 0]]) {
        note(name, 'wasm', timeDrag(object, flags, true));
        note(name, 'javascript', timeDrag(object, flags, false));
    }
    object.destroy();
}
let missed = false;
console.log('call                      native us    wasm us   ratio  budget   through Drag.update');
for (const [name, row] of Object.entries(rows)) {
    const ratio = row.wasm / row.native, late = ratio > budgets[name];
    missed ||= late;
    console.log(`${name.padEnd(24)}${row.native.toFixed(2).padStart(11)}${row.wasm.toFixed(2).padStart(11)}${ratio.toFixed(2).padStart(8)}` +
        `${String(budgets[name]).padStart(8)}${late ? ' missed' : ' met   '}${row.javascript ? row.javascript.toFixed(2).padStart(12) : ''}`);
}
process.exit(missed ? 1 : 0);
