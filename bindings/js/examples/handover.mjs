// What a host does with a joint beside dragging: a constraint for physics, a saved game, a client.
//   node handover.mjs OBJECT.dmo
import { readFile } from 'node:fs/promises';
import { load } from 'dragmesh';

const dragmesh = await load();
const context = dragmesh.createContext();
const object = context.loadObject(await readFile(process.argv[2]));
const [part] = object.parts, joint = object.joint(part.id);

// Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider.
const frame = dragmesh.jointFrame(joint);
console.log(`a constraint that opens to ${frame.upper.toFixed(2)}`);

// … and back: body is the transform that the engine has given the part, from rest.
const body = dragmesh.jointPose(joint, 1.2);
const { value, angleError, distanceError } = dragmesh.jointValue(joint, body);
const door = { joint, value, pose: body };
console.log(`physics leaves it at ${value.toFixed(2)}`);

const loaded = JSON.parse(JSON.stringify(door)); // a saved game, or a packet
console.log(`saved and loaded at ${loaded.value.toFixed(2)}`);

// A client has neither object nor context: the joint once, the value every frame.
const m = dragmesh.poseToMatrix(dragmesh.jointPose(loaded.joint, loaded.value)); // column by column
const [x, y, z] = part.centre, shown = [0, 1, 2].map(i => m[i] * x + m[i + 4] * y + m[i + 8] * z + m[i + 12]);

// The next grab begins where the part stands.
const again = object.beginDrag({ partId: part.id, grabPoint: shown, state: loaded }).end();
console.log(`grabbed again at ${again.value.toFixed(2)}`);
context.destroy();
