// The nodes of a scene as the asset call takes them: names, hierarchy, pivots, the clips of a file and the joints that it states.
import { Euler, Matrix4, Quaternion, Vector3 } from './three/three.module.min.js';
import { JointType } from './dragmesh/dragmesh.js';

const MOST_KEYS = 200; // of a clip: longer ones are thinned out
const SAME_SCALE = 1e-4; // share by which a rigid clip may change the scale

// Names of coarser levels of detail and of shapes for collisions alone, as exporters give them.
const LEFT_OUT = /(_LOD[1-9]\d*$)|(^(UCX|UBX|USP|UCP)_)|((_collider|-colonly|-convcolonly)[\d._ ]*$)/i;

/** The name that the file has: three.js takes signs out of it. */
export const nameOf = node => node.userData.name ?? node.name;

/** Whether a node is neither shown nor looked at. */
export const isLeftOut = node => LEFT_OUT.test(nameOf(node));

/** The joint that a file states in `extras`, in the scene's frame as this page and `dragmesh rig` write it; null: none. */
function statedJoint({ userData: { dragmesh } }) {
    const type = JointType[dragmesh?.type?.toUpperCase?.()];
    if (type === undefined || !Array.isArray(dragmesh.axis) || !Array.isArray(dragmesh.origin)) return null;
    const { axis, origin, lower, upper, pitch } = dragmesh;
    return { type, axis, origin, lower: lower ?? 0, upper: upper ?? 0, pitch: pitch ?? 0 };
}

/** A rigid motion as the library's pose. */
export function poseOf(matrix) {
    const place = new Vector3(), turn = new Quaternion(), scale = new Vector3();
    matrix.decompose(place, turn, scale);
    const { x, y, z, w } = turn, t = place;
    return { real: [x, y, z, w], dual: [0.5 * (t.x * w + t.y * z - t.z * y), 0.5 * (t.y * w + t.z * x - t.x * z),
        0.5 * (t.z * w + t.x * y - t.y * x), -0.5 * (t.x * x + t.y * y + t.z * z)] };
}

// ---- clips ----------------------------------------------------------------------------------------------------------------------

const channels = { position: Vector3, quaternion: Quaternion, scale: Vector3, rotation: Euler };

// Which node and which of its channels a track moves: 'NODE.position', NODE a name or a uuid.
function targetOf(track, byName) {
    const at = track.name.lastIndexOf('.'), node = byName.get(track.name.slice(0, at)), channel = track.name.slice(at + 1);
    return node && channels[channel] ? { node, channel, track } : null;
}

function timesOf(tracks) {
    const all = [...new Set(tracks.flatMap(({ track }) => [...track.times]))].sort((a, b) => a - b);
    const step = Math.ceil(all.length / MOST_KEYS);
    return all.filter((_, i) => i % step === 0 || i === all.length - 1);
}

// How one animation moves one node from its rest, in the frame of the scene, as if all nodes above it stood still. null: not rigidly.
function sample(node, name, tracks) {
    const above = node.parent.matrixWorld, back = node.matrixWorld.clone().invert(), times = timesOf(tracks), poses = [];
    const interpolants = tracks.map(({ channel, track }) => ({ channel, at: track.createInterpolant() }));
    for (const time of times) {
        const local = { position: node.position.clone(), quaternion: node.quaternion.clone(), scale: node.scale.clone() };
        for (const { channel, at } of interpolants) local[channel]?.fromArray(at.evaluate(time));
        if (local.scale.distanceTo(node.scale) > SAME_SCALE * node.scale.length()) return null;
        poses.push(poseOf(new Matrix4().compose(local.position, local.quaternion, local.scale).premultiply(above).multiply(back)));
    }
    return { name, times, poses };
}

function clipsOf(scene, animations) {
    const byName = new Map(), clips = new Map();
    scene.traverse(node => { byName.set(node.uuid, node); if (node.name) byName.set(node.name, node); });
    for (const { name, tracks } of animations) {
        const moved = new Map();
        for (const target of tracks.map(track => targetOf(track, byName))) {
            if (target) moved.set(target.node, [...moved.get(target.node) ?? [], target]);
        }
        for (const [node, own] of moved) {
            const clip = node === scene ? null : sample(node, name, own);
            if (clip) clips.set(node, [...clips.get(node) ?? [], clip]);
        }
    }
    return clips;
}

// ---- nodes ----------------------------------------------------------------------------------------------------------------------

/** Lists the nodes of a scene, parents first. pieceOf: node -> number of its piece. ownerOf: the node of a mesh. gltf: of GLTFLoader. */
export function listNodes(scene, pieceOf, ownerOf, gltf) {
    const list = [], places = new Map(), clips = clipsOf(scene, gltf?.animations ?? []);
    scene.traverse(node => {
        if (node === scene || !holdsPiece(node, pieceOf) || (node.isMesh && ownerOf(node) !== node)) return;
        const m = node.matrixWorld.elements, mesh = gltf?.parser.associations.get(node)?.meshes;
        places.set(node, list.length);
        list.push({
            name: nameOf(node), meshName: gltf?.parser.json.meshes?.[mesh]?.name, parent: places.get(node.parent) ?? null,
            piece: pieceOf.get(node) ?? null, clips: clips.get(node), joint: statedJoint(node),
            pivot: { origin: [m[12], m[13], m[14]], axes: [...m.slice(0, 3), ...m.slice(4, 7), ...m.slice(8, 11)] },
        });
    });
    return list;
}

function holdsPiece(node, pieceOf) {
    let found = false;
    node.traverse(below => { found ||= pieceOf.has(below); });
    return found;
}
