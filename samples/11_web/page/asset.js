// Turns a scene of three.js into what dragmesh reads: one mesh in the object frame, whose pieces are the scene's nodes. The frame
// is the scene's own, so that poses apply to what is drawn as they are.
import { Box3, BufferAttribute, BufferGeometry, Group, Mesh, Object3D, Vector3 } from './three/three.module.min.js';
import { isLeftOut, listNodes, nameOf } from './nodes.js';

/** What a node is called, from the scene down, and its frame: evidence of how it moves. */
function hintsOf(node, scene) {
    const names = [];
    for (let up = node; up && up !== scene; up = up.parent) if (up.name) names.unshift(nameOf(up));
    const m = node.matrixWorld.elements;
    return { names: names.join('/'), pivot: { origin: [m[12], m[13], m[14]], axes: [...m.slice(0, 3), ...m.slice(4, 7), ...m.slice(8, 11)] } };
}

// The node that a mesh belongs to. A node that says so holds one piece, as those do that this page has saved. The loader makes a
// group of a node with several materials: its meshes are one piece.
function nodeOf(mesh, associations) {
    for (let up = mesh; up; up = up.parent) if (up.userData.piece) return up;
    const own = associations?.get(mesh);
    return own && own.nodes === undefined && mesh.parent ? mesh.parent : mesh;
}

// Each instance of a mesh as a node of its own below it, as of EXT_mesh_gpu_instancing; a mesh without instances is of its node.
function copiesOf(mesh, owner) {
    if (!mesh.isInstancedMesh) return [{ place: mesh.matrixWorld, owner }];
    return Array.from({ length: mesh.count }, (_, i) => {
        const node = new Object3D();
        mesh.getMatrixAt(i, node.matrix);
        node.matrix.decompose(node.position, node.quaternion, node.scale);
        node.name = `${nameOf(owner)}.${i}`;
        mesh.add(node);
        node.updateWorldMatrix(false, false);
        return { place: node.matrixWorld, owner: node };
    });
}

// A geometry with the vertices where they are seen: skins and morphs at rest, put where the node or instance is.
function bake(mesh, place) {
    const source = mesh.geometry, count = source.attributes.position.count, point = new Vector3();
    const geometry = new BufferGeometry();
    for (const name of ['uv', 'uv1', 'color']) if (source.attributes[name]) geometry.setAttribute(name, source.attributes[name].clone());
    const positions = new Float32Array(3 * count);
    for (let i = 0; i < count; i++) mesh.getVertexPosition(i, point).applyMatrix4(place).toArray(positions, 3 * i);
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    const order = source.index ? Uint32Array.from(source.index.array) : Uint32Array.from({ length: count }, (_, i) => i);
    geometry.setIndex(new BufferAttribute(place.determinant() < 0 ? mirrored(order) : order, 1));
    if (mesh.isSkinnedMesh || !source.attributes.normal) geometry.computeVertexNormals();
    else geometry.setAttribute('normal', source.attributes.normal.clone().applyNormalMatrix(mesh.normalMatrix.getNormalMatrix(place)));
    return geometry;
}

function mirrored(order) {
    for (let i = 0; i + 2 < order.length; i += 3) [order[i + 1], order[i + 2]] = [order[i + 2], order[i + 1]];
    return order;
}

// Pieces of a mesh: the node; of a skin, one a bone that its faces follow most.
function piecesOf(mesh, node, faceCount) {
    if (!mesh.isSkinnedMesh) return Array(faceCount).fill(node);
    const { skinIndex, skinWeight } = mesh.geometry.attributes, order = mesh.geometry.index;
    return Array.from({ length: faceCount }, (_, face) => {
        const vertex = order ? order.getX(3 * face) : 3 * face;
        let best = 0;
        for (let k = 1; k < 4; k++) if (skinWeight.getComponent(vertex, k) > skinWeight.getComponent(vertex, best)) best = k;
        return mesh.skeleton.bones[skinIndex.getComponent(vertex, best)] ?? node;
    });
}

/** Reads a scene. gltf: what GLTFLoader has loaded, where it has. */
export function readAsset(scene, name, gltf) {
    scene.updateMatrixWorld(true);
    const surfaces = [], nodes = new Map(), pieces = [], ownerOf = mesh => nodeOf(mesh, gltf?.parser.associations);
    scene.traverseVisible(mesh => {
        if (!mesh.isMesh || !mesh.geometry.attributes.position || isLeftOut(ownerOf(mesh))) return;
        for (const { place, owner } of copiesOf(mesh, ownerOf(mesh))) {
            const geometry = bake(mesh, place), faceCount = Math.floor(geometry.index.count / 3), first = pieces.length;
            for (const node of piecesOf(mesh, owner, faceCount)) {
                if (!nodes.has(node)) nodes.set(node, { node, index: nodes.size, ...hintsOf(node, scene) });
                pieces.push(nodes.get(node).index);
            }
            if (faceCount > 0) surfaces.push({ geometry, material: mesh.material, name: mesh.name, first, faceCount });
        }
    });
    if (surfaces.length === 0) throw new Error('There is no mesh in this file.');
    const pieceOf = new Map([...nodes].map(([node, { index }]) => [node, index]));
    return { ...assemble(name, surfaces, [...nodes.values()], pieces), nodes: listNodes(scene, pieceOf, ownerOf, gltf) };
}

function assemble(name, surfaces, pieceList, pieceOfFace) {
    const vertexCount = surfaces.reduce((sum, s) => sum + s.geometry.attributes.position.count, 0);
    const positions = new Float32Array(3 * vertexCount), indices = new Uint32Array(3 * pieceOfFace.length);
    let vertex = 0;
    for (const { geometry, first, faceCount } of surfaces) {
        positions.set(geometry.attributes.position.array, 3 * vertex);
        for (let i = 0; i < 3 * faceCount; i++) indices[3 * first + i] = vertex + geometry.index.array[i];
        vertex += geometry.attributes.position.count;
    }
    const box = new Box3().setFromArray(positions);
    return { name, surfaces, positions, indices, pieces: Uint16Array.from(pieceOfFace), pieceList, pieceCount: pieceList.length, box,
        size: Math.max(...box.getSize(new Vector3()).toArray()) };
}

/** Draws an asset: one mesh for each surface and owner of its faces. owners: a number a face; 0 = the body. */
export class Figure {
    root = new Group();
    #asset;

    constructor(asset) {
        this.#asset = asset;
        this.build(new Uint16Array(asset.pieces.length));
    }

    build(owners) {
        for (const mesh of [...this.root.children]) {
            mesh.geometry.dispose();
            this.root.remove(mesh);
        }
        for (const surface of this.#asset.surfaces) for (const [owner, faces] of byOwner(surface, owners)) this.root.add(this.#mesh(surface, owner, faces));
    }

    #mesh(surface, owner, faces) {
        const geometry = new BufferGeometry();
        for (const [name, attribute] of Object.entries(surface.geometry.attributes)) geometry.setAttribute(name, attribute);
        const order = new Uint32Array(3 * faces.length);
        faces.forEach((face, i) => order.set(surface.geometry.index.array.subarray(3 * (face - surface.first), 3 * (face - surface.first) + 3), 3 * i));
        geometry.setIndex(new BufferAttribute(order, 1));
        const material = owner ? surface.material.clone() : surface.material; // a part is lit up by itself
        const mesh = Object.assign(new Mesh(geometry, material), { name: surface.name, castShadow: true, receiveShadow: true, matrixAutoUpdate: false });
        mesh.userData = { owner, faces, material: surface.material };
        return mesh;
    }

    meshesOf(owner) {
        return this.root.children.filter(mesh => mesh.userData.owner === owner);
    }
}

function byOwner({ first, faceCount }, owners) {
    const groups = new Map();
    for (let face = first; face < first + faceCount; face++) {
        const owner = owners[face];
        if (!groups.has(owner)) groups.set(owner, []);
        groups.get(owner).push(face);
    }
    return groups;
}
