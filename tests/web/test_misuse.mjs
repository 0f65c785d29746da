// What a host may do wrong with the binding: an exception each time, and the context goes on.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import * as api from '../../bindings/js/dragmesh.js';
import { cabinet } from '../../bindings/js/scenario.mjs';

const wasm = readFileSync(new URL('../../build/web/dragmesh.wasm', import.meta.url));
const dmo = readFileSync(new URL('../replay/hands/object.dmo', import.meta.url));
const dragmesh = await api.load({ wasm });
const refused = code => problem => problem instanceof api.DragmeshError && problem.code === code;
const stale = refused('DM_ERROR_STALE_HANDLE'), reentered = /must not call the context/;
const mesh = cabinet(), parts = [{ id: 1, label: 'door' }, { id: 2, label: 'drawer' }];
const weights = {}, names = { kinematics: 'kpp_net', motion: 'dq_vae', ranker: 'ranker' };
for (const [key, name] of Object.entries(names)) weights[key] = readFileSync(new URL(`../../sdk/models/${name}.safetensors`, import.meta.url));
const hint = { point: [0.54, 0.45, 0.45], vector: [0, 0, 1] };

// Runs body with a context that must work afterwards.
function misuse(name, body, options = {}) {
    test(name, async () => {
        const context = dragmesh.createContext(options);
        await body(context);
        const drag = context.prepare({ mesh, parts }).beginDrag({ partId: 1, rules: {}, flags: api.DragFlag.WITHOUT_POINT });
        assert.equal(drag.step({ hand: { kind: api.HandKind.VALUE, amount: 0.1 } }, 0.01).phase, api.DragPhase.HELD);
        context.destroy();
    });
}

misuse('what has ended is refused', context => {
    const model = context.loadModel(weights), object = context.prepare({ mesh, parts, model });
    const drag = object.beginDrag({ partId: 1, grabPoint: hint.point }), scene = context.createScene();
    const motion = object.generateMotion({ partId: 1, drag: hint });
    scene.add(object);
    model.destroy();
    assert.throws(() => object.generateMotion({ partId: 1, drag: hint }), refused('DM_ERROR_NO_MODEL'));
    assert.throws(() => context.prepare({ mesh, parts, model }), stale);
    object.destroy();
    for (const call of [() => object.info, () => drag.update(null, 0.1), () => motion.sample(1), () => motion.frames, () => scene.add(object), () => object.save(), () => drag.end()]) {
        assert.throws(call, stale);
    }
    scene.commit();
    const other = dragmesh.createContext(), left = other.prepare({ mesh, parts }), held = left.beginDrag({ partId: 1, grabPoint: hint.point });
    assert.throws(() => scene.add(left), stale);
    other.destroy();
    other.destroy();
    for (const call of [() => other.memory, () => left.info, () => held.update(null, 0.1), () => other.createScene(), () => other.loadObject(dmo)]) assert.throws(call, stale);
    for (const one of [left, held, other, drag, motion, object, model, scene]) one.destroy();
});

misuse('the collector ends what is forgotten', async context => {
    setFlagsFromString('--expose-gc');
    const inUse = () => context.memory.bytes - context.memory.keptBytes;
    const collect = runInNewContext('gc'), before = inUse();
    const forget = () => {
        for (let i = 0; i < 5; i++) context.loadObject(dmo).beginDrag({ partId: 1, grabPoint: [0, 0, 0] });
        dragmesh.createContext().prepare({ mesh, parts });
    };
    forget();
    for (let i = 0; i < 5; i++) {
        collect();
        await new Promise(resolve => setTimeout(resolve, 1));
    }
    assert.ok(inUse() < before + 65536);
});

test('hooks that call or end the context that calls them', () => {
    let hook = () => {};
    const context = dragmesh.createContext({ onLog: () => hook() }), object = context.prepare({ mesh, parts }), other = dragmesh.createContext();
    const drag = object.beginDrag({ partId: 1, grabPoint: hint.point });
    const calls = [() => context.destroy(), () => object.destroy(), () => drag.destroy(), () => context.prepare({ mesh, parts }), () => object.info,
        () => context.loadObject(dmo), () => context.createScene(), () => drag.update(null, 0.01), () => context.memory];
    for (const call of calls) {
        assert.throws(() => context.prepare({ mesh, parts, progress: call }), reentered);
        hook = call;
        assert.throws(() => context.loadObject(new Uint8Array(9)), reentered);
        hook = () => {};
    }
    for (const name of ['intent', 'choose']) assert.throws(() => context.prepare({ mesh, parts, [name]: () => context.destroy() }), reentered);
    context.prepare({ mesh, parts, progress: () => { other.loadObject(dmo).destroy(); } });
    assert.equal(drag.update({ origin: [0.54, 0.45, 2], direction: [0, 0, -1] }, 0.01).phase, api.DragPhase.HELD);
    other.destroy();
    context.destroy();
});

misuse('what a hook throws or answers leaves nothing made', context => {
    context.prepare({ mesh, parts }).destroy();
    const before = context.memory.bytes, fail = () => { throw new Error('mine'); };
    for (const name of ['progress', 'intent', 'choose']) assert.throws(() => context.prepare({ mesh, parts, [name]: fail }), /mine/);
    for (const wrong of [1.5, NaN, 2 ** 40, 'first', 1n, {}, Symbol('x'), { valueOf: fail }]) {
        assert.throws(() => context.prepare({ mesh, parts, intent: () => wrong }), /intent answers/);
    }
    assert.throws(() => context.prepare({ mesh, parts, choose: () => 1.5 }), /choose answers/);
    assert.throws(() => context.prepare({ mesh, parts, choose: () => 99 }), refused('DM_ERROR_INDEX_OUT_OF_RANGE'));
    assert.throws(() => context.prepare({ mesh, parts, intent: () => 99 }), refused('DM_ERROR_INVALID_ARGUMENT'));
    assert.throws(() => context.prepare({ mesh, parts, progress: true }), TypeError);
    assert.equal(context.memory.bytes, before);
});

misuse('a log that throws', context => {
    let calls = 0;
    const loud = dragmesh.createContext({ onLog: () => { calls++; throw new Error('loud'); } });
    assert.throws(() => loud.loadObject(new Uint8Array(9)), /loud/);
    assert.throws(() => loud.prepare({ mesh, parts }), /loud/); // it warns that there are no weights
    assert.equal(calls, 2);
    loud.destroy();
    assert.ok(context.memory.bytes > 0);
});

misuse('buffers of every kind', context => {
    const detached = new Float32Array(mesh.positions), inside = new Uint8Array(dragmesh.exports.memory.buffer, 0, 16);
    structuredClone(detached.buffer, { transfer: [detached.buffer] });
    const meshes = [{ positions: detached }, { positions: new Float32Array(0) }, { positions: new Float64Array(2) }, { positions: inside }, { positions: null },
        { indices: new Uint16Array(0) }, { indices: new Uint16Array(4) }, { indices: mesh.indices.subarray(1) }, { indices: new BigUint64Array(3) },
        { partIds: new Uint8Array(0) }, { partIds: mesh.partIds.subarray(1) }, { partIds: new Uint8Array(9999) }, { partIdScope: 7 }, { partIdScope: 1 },
        { positionStride: -4 }, { positionStride: 1 }, { positionStride: 2 ** 32 }, { positionStride: 0.5 }, { positionStride: NaN }, { positionStride: '12' }];
    for (const change of meshes) {
        assert.throws(() => context.prepare({ mesh: { ...mesh, ...change } }));
        assert.throws(() => context.findPart({ ...mesh, ...change }, { point: [NaN, 0, 0] }));
    }
    const drag = context.prepare({ mesh, parts }).beginDrag({ partId: 1, grabPoint: hint.point }), saved = drag.save();
    for (const wrong of ['bytes', 5, null, undefined, [1, 2], { byteLength: 2 ** 30 }, {}]) {
        for (const call of [() => context.loadObject(wrong), () => drag.restore(wrong)]) assert.throws(call, TypeError);
        if (wrong) assert.throws(() => context.loadModel({ ranker: wrong }), TypeError);
    }
    for (const wrong of [saved.subarray(1), new Uint8Array(0), detached]) assert.throws(() => drag.restore(wrong));
    drag.restore(saved.buffer);
    drag.restore(new DataView(saved.buffer));
    assert.deepEqual(context.loadObject(new Uint8Array(dmo).buffer).save(), context.loadObject(dmo).save());
});

misuse('lists with holes, and of lengths that lie', context => {
    const object = context.prepare({ mesh, parts }), hole = new Array(2);
    assert.throws(() => context.prepare({ mesh, parts: hole }), TypeError);
    for (const values of [hole, [], new Array(1000), new Set([0, 0, 0]), { length: 2, [Symbol.iterator]: () => [][Symbol.iterator]() }]) {
        assert.throws(() => object.followLinks(1, values), api.DragmeshError);
    }
    for (const links of [hole, new Array(1000).fill({ driver: 1, driven: 2 }), [{ driver: -1 }], [{ diver: 1 }]]) assert.throws(() => object.setLinks(links));
    assert.throws(() => object.beginDrag({ partId: 1, grabPoint: hint.point, rules: { snaps: new Array(1000).fill(0) } }), refused('DM_ERROR_INVALID_ARGUMENT'));
    assert.throws(() => object.beginDrag({ partId: 1, grabPoint: [1] }), refused('DM_ERROR_NOT_FINITE'));
    assert.throws(() => object.beginDrag({ partId: 1, grabPoint: {} }), refused('DM_ERROR_NOT_FINITE'));
});

misuse('numbers that C would cut, and sizes and addresses that are not the host\'s', context => {
    const object = context.prepare({ mesh, parts, model: context.loadModel(weights) }), joint = object.joint(1), scene = context.createScene();
    const drag = object.beginDrag({ partId: 1, rules: {}, flags: api.DragFlag.WITHOUT_POINT });
    for (const wrong of [1.5, -1, 2 ** 32, 2 ** 53, NaN, Infinity, '1', 1n, null, undefined, {}]) {
        for (const call of [() => object.joint(wrong), () => object.hypotheses(wrong), () => object.refine(wrong, hint), () => object.setJoint(wrong, joint),
            () => object.resetJoint(wrong), () => object.followLinks(wrong, [0, 0]), () => scene.move(wrong, 0, dragmesh.jointPose(joint, 0)), () => scene.remove(wrong)]) {
            assert.throws(call, problem => problem instanceof TypeError || problem instanceof RangeError);
        }
    }
    for (const seed of [-1, 1.5, 2n ** 64n, -1n, NaN, 'x']) assert.throws(() => context.prepare({ mesh, parts, seed }));
    context.prepare({ mesh, parts, seed: 2n ** 64n - 1n });
    for (const wrong of [NaN, Infinity, -Infinity, 1e300]) {
        for (const call of [() => drag.step({ hand: { kind: api.HandKind.VALUE, amount: wrong } }, 0.01), () => drag.update({ origin: [wrong, 0, 0], direction: [0, 0, 1] }, 0.01),
            () => drag.step({}, wrong), () => object.setJoint(1, { ...joint, axis: [wrong, 0, 0] }), () => object.refine(1, { point: [wrong, 0, 0], vector: [0, 0, 1] }),
            () => context.prepare({ mesh, parts, up: [wrong, 0, 0] }), () => dragmesh.jointPose(joint, wrong), () => dragmesh.createContext({ unitInMetres: wrong })]) {
            assert.throws(call, api.DragmeshError);
        }
    }
    assert.throws(() => object.setJoint(1, { ...joint, structSize: 4096 }), /no field/);
    for (const options of [{ progress: 7 }, { jobs: { parallelFor: 1 } }, { allocator: { allocate: 1 } }, { log: {} }, { structSize: 4096 }]) {
        assert.throws(() => dragmesh.createContext(options), /no option/);
    }
    for (const axes of [99, -1, 1.5]) assert.throws(() => dragmesh.createContext({ axes }));
});

misuse('texts', context => {
    for (const label of ['a\0b', 5, {}, ['x']]) {
        assert.throws(() => context.prepare({ mesh, parts, label }), TypeError);
        assert.throws(() => context.prepare({ mesh, parts: [{ id: 1, label }] }), TypeError);
    }
    for (const label of ['Tür', '\ud800', '']) context.prepare({ mesh, parts, label }).destroy();
    assert.throws(() => context.prepare({ mesh, parts, label: 'x'.repeat(1e7) }), refused('DM_ERROR_TOO_LARGE'));
});

misuse('memory that grows in the middle of a call', context => {
    const size = () => dragmesh.exports.memory.buffer.byteLength, blocks = [];
    const grow = () => {
        const before = size();
        while (size() === before) blocks.push(dragmesh.exports.malloc(1 << 20));
    };
    const object = context.prepare({ mesh, parts, intent: grow, choose: choice => { grow(); return choice.hypotheses.length - 1; } });
    const point = { get origin() { grow(); return [0.54, 0.45, 2]; }, direction: [0, 0, -1] };
    const drag = object.beginDrag({ partId: 1, grabPoint: hint.point });
    assert.ok(Number.isFinite(drag.update(point, 0.01).value) && object.joint(1).source === api.JointSource.CHOSEN);
    const view = new Uint8Array(dragmesh.exports.memory.buffer, 0, 1 << 16); // of the module's own memory, gone when that grows
    grow();
    assert.throws(() => context.loadObject(view));
    for (const block of blocks) dragmesh.exports.free(block);
});
