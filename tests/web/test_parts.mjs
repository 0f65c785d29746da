// What the page keeps of a part whose joint a pull changes, with a drag that does as it is told.
//   SITE=FOLDER node --test tests/web/test_parts.mjs
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';

const site = name => import(pathToFileURL(resolve(process.env.SITE ?? 'build/web/site', name)));
const { Part } = await site('parts.js');
const { JointBasis, JointSource, JointType } = await site('dragmesh/dragmesh.js');
const { Ray, Vector3 } = await site('three/three.module.min.js');

const pose = { real: [0, 0, 0, 1], dual: [0, 0, 0, 0] };
const hinge = { type: JointType.REVOLUTE, axis: [1, 0, 0], origin: [0, 1, -1], lower: 0, upper: 1.5, source: JointSource.FROM_NETWORK, typeConfidence: 0.9, jointConfidence: 0.6, evidence: [0, 0, 0, 0] };
const slide = { ...hinge, type: JointType.PRISMATIC, axis: [0, 1, 0], jointConfidence: 0.5, evidence: [1, 2, 3, 4] };

// A part whose next update says `told`; begun: what its drags began with.
function partOf(told) {
    const begun = [];
    const drag = { partState: { joint: slide }, update: () => told, end: () => ({ value: told.value, pose, joint: told.changes ? slide : hinge }) };
    const object = { parts: [{}], joint: () => hinge, beginDrag: desc => { begun.push(desc); return drag; } };
    const part = new Part({ context: { loadObject: () => object }, pose() {}, changed() {} }, 1, 'lid', { joint: hinge });
    return { part, begun };
}

const pull = part => part.grab(new Vector3(), new Ray(new Vector3(0, 0, 2), new Vector3(0, 0, -1)));

test('a pull that leaves the joint offers no way back', () => {
    const { part } = partOf({ value: 0.4, pose, changes: 0, jointConfidence: 0.7, jointBasis: JointBasis.PREPARED });
    pull(part);
    assert.equal(part.before, null);
    assert.deepEqual([part.confidence, part.basis, part.value], [0.7, JointBasis.PREPARED, 0.4]);
});

test('what a pull has changed is taken back, and kept', () => {
    const { part, begun } = partOf({ value: 0.2, pose, changes: 1, jointConfidence: 0.5, jointBasis: JointBasis.PULL });
    pull(part);
    assert.equal(begun[0].flags ?? 0, 0, 'the page leaves it to the library what a pull changes');
    assert.deepEqual([part.joint.type, part.basis], [JointType.PRISMATIC, JointBasis.PULL]);
    pull(part); // another grab of the changed joint: the way back leads to before the first one
    part.takeBack();
    assert.deepEqual([part.joint.type, part.value, part.basis, part.before], [JointType.REVOLUTE, 0, JointBasis.CHOSEN, null]);
    assert.deepEqual(part.joint.evidence, [0, 0, 0, 0]);
    pull(part);
    assert.equal(begun.at(-1).state.joint.source, JointSource.CHOSEN);
});

test('a chosen joint goes into the next drag as the user\'s', () => {
    const { part, begun } = partOf({ value: 0, pose, changes: 0, jointConfidence: 1, jointBasis: JointBasis.CHOSEN });
    part.choose(slide);
    pull(part);
    assert.deepEqual([begun[0].state.joint.source, part.basis], [JointSource.CHOSEN, JointBasis.CHOSEN]);
    part.reset();
    assert.deepEqual([part.joint, part.basis], [hinge, JointBasis.PREPARED]);
});
