// Pulls the first part of a prepared object open with a pointer, and lets it swing: node first_door.mjs OBJECT.dmo
import { readFile } from 'node:fs/promises';
import { load, DragPhase, Go } from 'dragmesh';

const dragmesh = await load();
const context = dragmesh.createContext({ onLog: (level, code, text) => console.warn(code, text) });
const object = context.loadObject(await readFile(process.argv[2]));
const [part] = object.parts, [x, y, z] = part.centre;
const drag = object.beginDrag({ partId: part.id, grabPoint: part.centre }); // at a hit's objectPoint
for (let frame = 0; frame < 60; frame++) { // every frame, with the pointer's ray in the object's frame
    drag.update({ origin: [x, y, z + 2], direction: [-0.003 * frame, 0, -2] }, 1 / 60);
}
drag.release({ intent: Go.OPEN });
while (drag.update(null, 1 / 60).phase !== DragPhase.AT_REST);
const kept = drag.end(); // joint, value and pose: what the instance saves
console.log(`part ${part.id} stands open at ${kept.value.toFixed(2)}`);
context.destroy();
