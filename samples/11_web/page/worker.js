// Finds parts and infers their joints away from the page's thread, which stays free to draw.
//   { open: mesh }                mesh: { positions, indices, pieces, pieceCount, nodes } in the object frame
//   { rig, label }                answers { parts, data } of the whole asset; tells { progress } meanwhile
//   { find: { point, vector } }   answers { faces, data, joint, … } of the part at a point of a mesh of one piece
//   { pieces, names, pivot }      the same of a part that is told: those pieces
// Each may answer { error } instead.
import { load, AssetBasis, AssetState, PartIdScope, Picking } from './dragmesh/dragmesh.js';

const ready = start();
let mesh;

async function start() {
    const dragmesh = await load();
    const context = dragmesh.createContext({ picking: Picking.NONE });
    // Without weights joints are guessed by geometry and rules: the object says so, and the page passes it on.
    return { context, model: await context.fetchModel('dragmesh/models').catch(() => undefined) };
}

// ---- a whole asset ----

// The vertices and triangles of each piece.
function splitPieces() {
    const { positions, indices, pieces, pieceCount } = mesh, split = Array.from({ length: pieceCount }, () => ({ points: [], indices: [], known: new Map() }));
    pieces.forEach((piece, face) => {
        const own = split[piece];
        for (let corner = 3 * face; corner < 3 * face + 3; corner++) {
            const vertex = indices[corner];
            if (!own.known.has(vertex)) {
                own.known.set(vertex, own.known.size);
                own.points.push(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
            }
            own.indices.push(own.known.get(vertex));
        }
    });
    return split.map(own => ({ positions: Float32Array.from(own.points), indices: Uint32Array.from(own.indices) }));
}

// What the file states is not among what the library has found.
function hypothesesOf(object, { partId, basis, joint }) {
    const found = object.hypotheses(partId);
    return basis === AssetBasis.INFERRED ? found : [joint, ...found];
}

async function rig({ id, label }) {
    const { context, model } = await ready, split = splitPieces(), began = performance.now();
    const nodes = mesh.nodes.map(({ piece, ...node }) => (piece === null ? node : { ...node, ...split[piece] }));
    const asset = context.rig({ nodes, model, label, picking: false, progress: progress => { self.postMessage({ id, progress }); } });
    try {
        const parts = asset.parts.map((part, i) => ({ ...part, nodes: asset.partNodes(i), joint: asset.joint(i) }));
        const moving = parts.filter(part => part.state !== AssetState.STAYS);
        const object = moving.length ? asset.makeObject() : null, prepare = (performance.now() - began) / Math.max(1, moving.length);
        for (const part of moving) Object.assign(part, { hypotheses: hypothesesOf(object, part), degraded: object.info.degraded, times: { find: 0, prepare } });
        return { parts, data: object?.save() ?? null };
    } finally {
        asset.destroy();
    }
}

// ---- one part ----

async function solve({ find, pieces, label, names, pivot }) {
    const { context, model } = await ready, { positions, indices } = mesh;
    const began = performance.now();
    const faces = pieces ? Uint8Array.from(mesh.pieces, piece => Number(pieces.includes(piece))) : context.findPart({ positions, indices }, find);
    const found = performance.now();
    const object = context.prepare({ mesh: { positions, indices, partIds: faces, partIdScope: PartIdScope.FACE }, parts: [{ id: 1, label: names, pivot }], model, label, picking: false });
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
        const answer = await (data.rig ? rig(data) : solve(data));
        self.postMessage({ id: data.id, ...answer }, [answer.faces, answer.data].filter(Boolean).map(array => array.buffer));
    } catch (error) {
        self.postMessage({ id: data.id, error: { code: error.code ?? error.name, message: error.message } });
    }
};

ready.then(() => self.postMessage({ ready: true }), error => self.postMessage({ failed: error.message }));
