// Finds parts and infers their joints away from the page's thread, which stays free to draw.
//   { open: mesh }                                    mesh: { positions, indices, pieces } in the object frame
//   { find: { point, vector }, label, names, pivot }  answers { faces, data, joint, hypotheses, degraded, times } or { error }
import { load, PartIdScope, Picking } from './dragmesh/dragmesh.js';

const ready = start();
let mesh;

async function start() {
    const dragmesh = await load();
    const context = dragmesh.createContext({ picking: Picking.NONE });
    // Without weights joints are guessed by geometry and rules: the object says so, and the page passes it on.
    return { context, model: await context.fetchModel('dragmesh/models').catch(() => undefined) };
}

// Marks the faces that go with the grabbed point. A file of several pieces says what is rigid.
function findFaces(context, point, vector) {
    const { positions, indices, pieces, pieceCount } = mesh;
    const rigid = pieceCount > 1 ? { partIds: pieces, partIdScope: PartIdScope.FACE } : {};
    return context.findPart({ positions, indices, ...rigid }, { point, vector });
}

async function solve({ find, label, names, pivot }) {
    const { context, model } = await ready;
    const began = performance.now();
    const faces = findFaces(context, find.point, find.vector);
    const found = performance.now();
    const object = context.prepare({
        mesh: { positions: mesh.positions, indices: mesh.indices, partIds: faces, partIdScope: PartIdScope.FACE },
        parts: [{ id: 1, label: names, pivot }], model, label, picking: false,
    });
    const prepared = performance.now();
    try {
        return { faces, data: object.save(), joint: object.joint(1), hypotheses: object.hypotheses(1), degraded: object.info.degraded,
            times: { find: found - began, prepare: prepared - found } };
    } finally {
        object.destroy();
    }
}

self.onmessage = async ({ data }) => {
    if (data.open) {
        mesh = data.open;
        return;
    }
    try {
        const answer = await solve(data);
        self.postMessage({ id: data.id, ...answer }, [answer.faces.buffer, answer.data.buffer]);
    } catch (error) {
        self.postMessage({ id: data.id, error: { code: error.code ?? error.name, message: error.message } });
    }
};

ready.then(() => self.postMessage({ ready: true }), error => self.postMessage({ failed: error.message }));
