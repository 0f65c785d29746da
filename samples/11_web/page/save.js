// Writes the object as a GLB in which every part is a node with its pivot on its joint, and an animation opens it.
import { AnimationClip, Group, Matrix4, Mesh, Quaternion, QuaternionKeyframeTrack, Vector3, VectorKeyframeTrack } from './three/three.module.min.js';
import { GLTFExporter } from './three/addons/exporters/GLTFExporter.js';
import { JointType } from './dragmesh/dragmesh.js';

const KEYS = 24; // of an animation
const OPENING = 1.2; // s
const CYCLE = 2 * OPENING; // s: opens, and closes again

const ease = t => t * t * (3 - 2 * t);
const typeNames = new Map(Object.entries(JointType).map(([name, value]) => [value, name.toLowerCase()]));

// A node at the joint's origin, so that engines turn the part about its hinge.
function partNode(part, name) {
    const node = new Group(), { joint } = part;
    node.name = name;
    const carried = part.parent ? part.parent.joint.origin : [0, 0, 0];
    node.position.set(...joint.origin).sub(new Vector3(...carried));
    node.userData = { piece: true, dragmesh: { type: typeNames.get(joint.type), axis: joint.axis, origin: joint.origin, lower: joint.lower, upper: joint.upper, pitch: joint.pitch } };
    return node;
}

function clip(part, node, parts) {
    const times = [], places = [], turns = [], { joint } = part, matrix = new Matrix4();
    const inward = new Matrix4().makeTranslation(...joint.origin), place = new Vector3(), turn = new Quaternion(), scale = new Vector3();
    const outward = new Matrix4().makeTranslation(...(part.parent ? part.parent.joint.origin : [0, 0, 0])).invert();
    for (let i = 0; i <= 2 * KEYS; i++) {
        const t = i / KEYS, share = ease(t <= 1 ? t : 2 - t);
        matrix.fromArray(parts.matrixAt(joint, part.openValue * share)).multiply(inward).premultiply(outward).decompose(place, turn, scale);
        times.push(t * OPENING);
        places.push(...place.toArray());
        turns.push(...turn.toArray());
    }
    return [new VectorKeyframeTrack(`${node.name}.position`, times, places), new QuaternionKeyframeTrack(`${node.name}.quaternion`, times, turns)];
}

/** Bytes of the GLB. */
export async function saveAnimated(parts) {
    const root = new Group(), nodes = new Map(), tracks = [];
    root.name = parts.asset.name;
    const body = new Group();
    body.name = 'body';
    body.userData.piece = true;
    root.add(body);
    for (const part of parts.list) nodes.set(part, partNode(part, `part_${part.id}_${part.name.toLowerCase().replace(/[^a-z0-9]+/g, '_')}`));
    for (const [part, node] of nodes) {
        (nodes.get(part.parent) ?? root).add(node);
        if (part.joint.type !== JointType.FIXED) tracks.push(...clip(part, node, parts));
    }
    for (const drawn of parts.figure.root.children) {
        const part = parts.byId(drawn.userData.owner), mesh = new Mesh(compact(drawn.geometry), drawn.userData.material);
        mesh.name = drawn.name;
        if (part) mesh.geometry.translate(...part.joint.origin.map(value => -value));
        (part ? nodes.get(part) : body).add(mesh);
    }
    const clips = tracks.length ? [new AnimationClip('open', CYCLE, tracks)] : [];
    return new GLTFExporter().parseAsync(root, { binary: true, animations: clips, onlyVisible: false });
}

// Only the vertices that the mesh uses: parts of a split mesh share their arrays.
function compact(geometry) {
    const out = geometry.clone(), order = geometry.index.array, used = new Map();
    for (const vertex of order) if (!used.has(vertex)) used.set(vertex, used.size);
    for (const [name, attribute] of Object.entries(geometry.attributes)) {
        const array = new attribute.array.constructor(used.size * attribute.itemSize);
        for (const [from, to] of used) for (let k = 0; k < attribute.itemSize; k++) array[to * attribute.itemSize + k] = attribute.array[from * attribute.itemSize + k];
        out.setAttribute(name, new attribute.constructor(array, attribute.itemSize, attribute.normalized));
    }
    out.setIndex(Array.from(order, vertex => used.get(vertex)));
    return out;
}
