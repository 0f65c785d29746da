// The binding in node: errors by name, hooks, memory, lifetimes. The common scenario is in bindings/js/scenario.mjs.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import * as api from '../../bindings/js/dragmesh.js';
import { cabinet } from '../../bindings/js/scenario.mjs';

const wasm = readFileSync(new URL('../../build/web/dragmesh.wasm', import.meta.url));
const dragmesh = await api.load({ wasm });
const error = code => problem => problem instanceof api.DragmeshError && problem.code === code && problem.message.startsWith(code);
const parts = [{ id: 1, label: 'door' }, { id: 2, label: 'drawer' }];

test('an error has a name, and says which field', () => {
    const context = dragmesh.createContext();
    const { positions, indices, partIds } = cabinet();
    assert.throws(() => context.prepare({ mesh: { positions, indices, partIds: new Uint8Array(partIds.length) } }), error('DM_ERROR_EMPTY_MASK'));
    assert.throws(() => context.prepare({ mesh: { positions, indices, partIds: partIds.subarray(1) } }), /part_id_bytes/);
    assert.throws(() => context.loadModel({ ranker: new Uint8Array(9) }), error('DM_ERROR_BAD_DATA'));
    context.destroy();
});

test('what JavaScript would narrow in silence is refused', () => {
    const context = dragmesh.createContext(), mesh = cabinet();
    const prepare = change => () => context.prepare({ mesh: { ...mesh, ...change } });
    assert.throws(prepare({ positions: [...mesh.positions] }), TypeError);
    assert.throws(prepare({ indices: Int32Array.from(mesh.indices) }), TypeError);
    assert.throws(prepare({ partIds: Float32Array.from(mesh.partIds) }), TypeError);
    const object = context.prepare({ mesh, parts });
    assert.throws(() => object.beginDrag({ part_id: 1 }), /no field "part_id"/);
    assert.throws(() => object.beginDrag({ partId: 1.5 }), RangeError);
    assert.throws(() => object.beginDrag({ partId: '1' }), TypeError);
    context.destroy();
});

test('hooks are called, and what they throw comes out of the call', () => {
    const seen = [], context = dragmesh.createContext({ onLog: (level, code) => seen.push(code) }), mesh = cabinet();
    const done = [], choices = [];
    const object = context.prepare({ mesh, parts, progress: share => { done.push(share); }, choose: choice => { choices.push(choice); return 1; } });
    assert.ok(done.length > 1 && done.every((share, i) => i === 0 || share >= done[i - 1]) && done.at(-1) <= 1);
    assert.deepEqual(choices.map(choice => choice.part.id), [1, 2]);
    assert.equal(object.joint(1).source, api.JointSource.CHOSEN);
    assert.deepEqual(object.joint(1).axis, choices[0].hypotheses[1].joint.axis);
    assert.throws(() => context.prepare({ mesh, parts, progress: () => true }), error('DM_ERROR_CANCELLED'));
    assert.throws(() => context.prepare({ mesh, parts, progress: () => { throw new Error('mine'); } }), /mine/);
    const slides = context.prepare({ mesh, parts, intent: (id, low, high) => (high[1] > low[1] ? api.JointType.PRISMATIC : 0) });
    assert.equal(slides.joint(1).type, api.JointType.PRISMATIC);
    assert.throws(() => context.prepare({ mesh: { ...mesh, indices: mesh.indices.subarray(0, 36) } }));
    assert.ok(seen.includes('DM_ERROR_EMPTY_MASK'));
    context.destroy();
});

// A box as a node, its corners from `low` to `high`.
function box(name, low, high, more = {}) {
    const positions = new Float32Array(24);
    for (let i = 0; i < 8; i++) for (let k = 0; k < 3; k++) positions[3 * i + k] = (i >> k) & 1 ? high[k] : low[k];
    const indices = Uint16Array.of(0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6);
    return { name, positions, indices, ...more };
}

test('a whole asset answers which nodes are one part', () => {
    const context = dragmesh.createContext(), done = [];
    const nodes = [box('side', [-0.4, 0, -0.25], [-0.38, 0.8, 0.23]), box('side2', [0.38, 0, -0.25], [0.4, 0.8, 0.23]),
        box('floor', [-0.38, 0, -0.25], [0.38, 0.02, 0.23]), box('roof', [-0.38, 0.78, -0.25], [0.38, 0.8, 0.23]),
        box('back', [-0.38, 0.02, -0.25], [0.38, 0.78, -0.23]), { name: 'front', parent: null },
        box('door', [0, 0, 0], [0.8, 0.8, 0.018], { parent: 5, transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -0.4, 0, 0.232, 1] }),
        box('knob', [0.32, 0.36, 0.25], [0.35, 0.44, 0.28], { parent: 5 }), box('collider', [-1, 0, -1], [1, 1, 1], { follows: 6 })];
    const asset = context.rig({ nodes, label: 'cupboard', progress: share => { done.push(share); } });
    assert.deepEqual(asset.info.movingCount, 1);
    assert.deepEqual(asset.nodeParts, [null, null, null, null, null, 0, 0, 0, 0]);
    assert.deepEqual(asset.partNodes(0), [5, 6, 7, 8]);
    const [door] = asset.parts;
    assert.deepEqual([door.partId, door.parent, door.state, door.basis], [1, null, api.AssetState.MOVES, api.AssetBasis.INFERRED]);
    assert.ok(door.moves > 0.5 && done.length > 1);
    const object = asset.makeObject();
    assert.deepEqual(object.parts.map(part => part.id), [1]);
    assert.deepEqual(object.joint(1), asset.joint(0));
    asset.destroy();
    assert.throws(() => asset.info, error('DM_ERROR_STALE_HANDLE'));
    assert.equal(object.parts.length, 1, 'the object stays');
    const hinge = { type: api.JointType.REVOLUTE, axis: [0, 1, 0], origin: [0.4, 0.4, 0.24], lower: 0, upper: 1 };
    const withDoor = said => nodes.map((node, i) => i === 6 ? { ...node, ...said } : node);
    assert.equal(context.rig({ nodes: withDoor({ joint: hinge }) }).parts[0].basis, api.AssetBasis.FROM_FILE);
    const poses = Array.from({ length: 9 }, (_, i) => dragmesh.jointPose(hinge, i / 8)), times = poses.map((_, i) => i / 4);
    const clipped = withDoor({ clips: [{ name: 'open', times, poses }] });
    assert.equal(context.rig({ nodes: clipped }).parts[0].basis, api.AssetBasis.FROM_CLIP);
    assert.equal(context.rig({ nodes: clipped, clips: false }).parts[0].basis, api.AssetBasis.INFERRED);
    assert.throws(() => context.rig({ nodes: [{ name: 'a', mesh: 1 }] }), /no "mesh"/);
    assert.throws(() => context.rig({ nodes: [box('a', [0, 0, 0], [1, 1, 1], { transform: [1] })] }), /16 numbers/);
    assert.throws(() => context.rig({ nodes, progress: () => true }), error('DM_ERROR_CANCELLED'));
    assert.throws(() => context.rig({ nodes, minMoves: 1 }).makeObject(), error('DM_ERROR_EMPTY_MASK'));
    context.destroy();
});

test('what is destroyed is gone, twice is no error, and memory comes back', () => {
    const context = dragmesh.createContext();
    let before = 0; // after the first round, which makes the context's tables
    for (let i = 0; i < 10; i++) {
        const object = context.prepare({ mesh: cabinet(), parts });
        const drag = object.beginDrag({ partId: 1, grabPoint: [0.5, 0.4, 0.42] });
        object.destroy();
        object.destroy();
        assert.throws(() => object.info, error('DM_ERROR_STALE_HANDLE'));
        assert.throws(() => drag.update(null, 0.1), error('DM_ERROR_STALE_HANDLE'));
        before ||= context.memory.bytes;
        assert.equal(context.memory.bytes, before);
    }
    const other = dragmesh.createContext(), size = dragmesh.exports.memory.buffer.byteLength;
    for (let i = 0; i < 200; i++) dragmesh.createContext().destroy();
    assert.equal(dragmesh.exports.memory.buffer.byteLength, size);
    other.destroy();
    context.destroy();
    context.destroy();
    assert.throws(() => context.memory, error('DM_ERROR_STALE_HANDLE'));
});

test('a saved object moves as the prepared one does', () => {
    const context = dragmesh.createContext({ picking: api.Picking.NONE });
    const object = context.prepare({ mesh: cabinet(), parts, picking: false }), again = context.loadObject(object.save());
    const ray = i => ({ origin: { x: 0.9, y: 0.9, z: 2 }, direction: [-0.35 - 0.01 * i, -0.45, -1.55] });
    const drags = [object, again].map(each => each.beginDrag({ partId: 1, grabPoint: [0.54, 0.45, 0.45] }));
    for (let i = 0; i < 30; i++) {
        const [a, b] = drags.map(drag => drag.update(ray(i), 1 / 60));
        assert.deepEqual(a, b);
    }
    assert.ok(Math.abs(drags[0].state.value) > 0.1);
    const { jointConfidence, jointBasis } = drags[0].state;
    assert.ok(jointConfidence > 0 && jointConfidence <= 1 && Object.values(api.JointBasis).includes(jointBasis));
    assert.throws(() => context.createScene(), error('DM_ERROR_UNSUPPORTED'));
    context.destroy();
});

test('what pulls have said stays with a saved state', () => {
    const context = dragmesh.createContext({ picking: api.Picking.NONE });
    const object = context.prepare({ mesh: cabinet(), parts, picking: false });
    const drag = object.beginDrag({ partId: 1, grabPoint: [0.54, 0.45, 0.45] });
    for (let i = 0; i < 30; i++) drag.update({ origin: [0.9, 0.9, 2], direction: [-0.35 - 0.01 * i, -0.45, -1.55] }, 1 / 60);
    const state = JSON.parse(JSON.stringify(drag.end()));
    assert.notEqual(state.joint.evidence[0], 0);
    const again = object.beginDrag({ partId: 1, state, flags: api.DragFlag.WITHOUT_POINT }).end();
    assert.deepEqual(again.joint.evidence, state.joint.evidence);
    context.destroy();
});

test('joints and poses as values', () => {
    const joint = { type: api.JointType.REVOLUTE, axis: [0, 1, 0], origin: [1, 0, 0], lower: 0, upper: 2 };
    const pose = dragmesh.jointPose(joint, 1);
    assert.ok(Math.abs(dragmesh.jointValue(joint, pose).value - 1) < 1e-6);
    assert.equal(dragmesh.jointValueAt(joint, 0.5), 1);
    const matrix = dragmesh.poseToMatrix(pose);
    assert.ok(Math.abs(matrix[0] - Math.cos(1)) < 1e-6 && Math.abs(matrix[12] - (1 - Math.cos(1))) < 1e-6);
    assert.deepEqual(dragmesh.jointFrame(joint).x, [0, 1, 0]);
    assert.deepEqual(dragmesh.scaleJoint(joint, [2, 1, 1]).origin, [2, 0, 0]);
    const there = dragmesh.multiplyPoses(pose, dragmesh.jointPose(joint, -1));
    assert.ok(Math.abs(there.real[3] - 1) < 1e-6 && there.dual.every(value => Math.abs(value) < 1e-6));
    assert.throws(() => dragmesh.jointPose({ ...joint, axis: [NaN, 0, 0] }, 1), error('DM_ERROR_NOT_FINITE'));
});

test('modules come as bytes and as responses of any type', async () => {
    const bytes = Uint8Array.from(wasm);
    await assert.rejects(api.load({ wasm: bytes.subarray(0, 100) }), WebAssembly.CompileError);
    await assert.rejects(api.load({ wasm: new Response(wasm, { status: 404 }) }), /404/);
    const plain = await api.load({ wasm: new Response(wasm, { headers: { 'Content-Type': 'text/plain' } }) });
    assert.equal(plain.exports.dm_version(), api.VERSION_NUMBER);
});
