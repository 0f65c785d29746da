// The twenty lines of README.md: opens the door of a cabinet.
//   node bindings/js/example.mjs       scripts/build web comes first
import { readFile } from 'node:fs/promises';
import { load } from './dragmesh.js';
import { cabinet } from './scenario.mjs';

const mesh = cabinet(); // { positions, indices, partIds }: typed arrays, as a GLB has them
const read = name => readFile(new URL(`../../sdk/models/${name}.safetensors`, import.meta.url));

const dragmesh = await load({ wasm: new URL('../../build/web/dragmesh.wasm', import.meta.url) });
const context = dragmesh.createContext({ onLog: (level, code, text) => console.warn(code, text) });
const model = context.loadModel({ kinematics: await read('kpp_net'), motion: await read('dq_vae'), ranker: await read('ranker') });

// Once for an object: how does each part move?
const object = context.prepare({ mesh, model, parts: [{ id: 1, label: 'door' }, { id: 2, label: 'drawer' }] });
const joint = object.joint(1);
console.log(`type ${joint.type}, ${Math.round(100 * joint.jointConfidence)} % sure, opens to ${joint.upper.toFixed(2)}`);

// Every frame of a drag: a ray of the pointer goes in, the pose of the part comes out.
const drag = object.beginDrag({ partId: 1, grabPoint: [0.55, 0.45, 0.45] });
for (let frame = 0; frame <= 60; frame++) {
    const angle = frame / 60, x = 0.55 * Math.cos(angle), z = 0.43 + 0.55 * Math.sin(angle); // of the pointer
    const ray = { origin: [0.9, 0.9, 2], direction: [x - 0.9, -0.45, z - 2] };
    const { pose, value } = drag.update(ray, 1 / 60);
    if (frame % 20 === 0) console.log(`value ${value.toFixed(3)}, matrix ${[...dragmesh.poseToMatrix(pose)].slice(0, 3).map(x => x.toFixed(2))} …`);
}
const state = drag.end(); // joint, value and pose: what the next beginDrag takes as `state`
console.log(`left open at ${state.value.toFixed(3)}`);
context.destroy();
