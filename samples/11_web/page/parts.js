// The parts of the asset: their faces, joints and poses, and the drag that moves one of them.
import { Matrix4, Ray, Vector3 } from './three/three.module.min.js';
import { nameOf } from './nodes.js';
import { AssetBasis, AssetState, DragFlag, DragPhase, Go, HandKind, JointBasis, JointSource, JointType } from './dragmesh/dragmesh.js';

// A found part of more faces than this share of a mesh without pieces is the body. By hand.
const BODY_SHARE = 0.75;
const KEY_SPEED = 0.6; // share of the range a second, while a key is down
const LIMIT_GIVE = 0.15; // share of the range that an estimated limit gives: a drawer stays in its case
const rest = { real: [0, 0, 0, 1], dual: [0, 0, 0, 0] };

/** One part: `own` is its motion from rest, `world` that of the parts that carry it included. */
export class Part {
    #changes = 0; // of the joint, by the drag so far
    own = new Matrix4();
    world = new Matrix4();
    parent = null;
    drag = null;
    before = null; // the state from before the pulls that have put another joint in force; null: none has
    #taken = null; // the state in which the hand took the part

    // answer.object: that of the whole asset, of which this is part answer.partId; without it answer.data is one of this part alone.
    constructor(parts, id, name, answer) {
        const { faces, hypotheses, degraded, times, object, partId = 1, state, basis } = answer;
        Object.assign(this, { parts, id, name, faces, hypotheses, degraded, times, partId });
        this.isFree = state === AssetState.FREE;
        this.isStated = basis === AssetBasis.FROM_FILE || basis === AssetBasis.FROM_CLIP; // by the file
        this.isShared = Boolean(object);
        this.object = object ?? parts.context.loadObject(answer.data);
        this.#stand({ value: 0, pose: rest, joint: answer.joint }, JointBasis.PREPARED);
        this.info = this.object.parts.find(part => part.id === partId) ?? this.object.parts[0];
    }

    get joint() {
        return this.state.joint;
    }

    get value() {
        return this.state.value;
    }

    /** A ray of the scene in the frame in which the part's joint is: that of what carries it. */
    localRay(ray) {
        const carried = this.parent ? this.parent.world.clone().invert() : new Matrix4();
        return new Ray().copy(ray).applyMatrix4(carried);
    }

    localPoint(point) {
        return this.parent ? point.clone().applyMatrix4(this.parent.world.clone().invert()) : point.clone();
    }

    /** The player takes hold at a point of the scene. */
    grab(point, ray) {
        this.letGo();
        this.#begin({ grabPoint: this.localPoint(point) });
        return this.follow(ray, 1 / 60);
    }

    /** A hand without a place: keys, buttons and the slider. */
    hold() {
        if (this.drag) return;
        this.#begin({ flags: DragFlag.WITHOUT_POINT });
    }

    #begin(options) {
        this.#changes = 0;
        this.#taken = structuredClone(this.state);
        this.drag = this.object.beginDrag({ partId: this.partId, state: this.state, limitGive: LIMIT_GIVE, rules: { driveSpeed: KEY_SPEED }, ...options });
    }

    follow(ray, dt) {
        return this.#moved(this.drag.update(ray ? this.localRay(ray) : null, dt));
    }

    /** amount: -1 to 1, opening. */
    drive(amount, dt) {
        this.hold();
        return this.#moved(this.drag.updateInput({ hand: { kind: HandKind.RATE, amount } }, dt));
    }

    setValue(value, dt) {
        this.hold();
        return this.#moved(this.drag.updateInput({ hand: { kind: HandKind.VALUE, amount: value } }, dt));
    }

    release(intent = Go.AUTO) {
        this.hold();
        return this.drag.release({ intent });
    }

    /** Moves a released part on; false when it has come to rest. */
    coast(dt) {
        if (!this.drag) return false;
        const state = this.follow(null, dt);
        if (state.phase !== DragPhase.AT_REST) return true;
        this.letGo();
        return false;
    }

    letGo() {
        if (!this.drag) return;
        this.#keep(this.drag.end());
        this.drag = null;
        this.parts.changed(this);
    }

    #moved(state) {
        const changed = state.changes !== this.#changes;
        this.#changes = state.changes;
        this.state = { value: state.value, pose: state.pose, joint: changed ? this.drag.partState.joint : this.state.joint };
        if (changed) this.before ??= this.#taken;
        this.confidence = state.jointConfidence;
        this.basis = state.jointBasis;
        this.parts.pose(this, state.pose);
        if (changed) this.parts.changed(this);
        return state;
    }

    #keep(state) {
        this.state = state;
        this.parts.pose(this, state.pose);
    }

    // Where the part stands, by a joint of its own, and where that comes from (JointBasis).
    #stand(state, basis) {
        Object.assign(this, { state, basis, confidence: state.joint.jointConfidence, before: null });
    }

    #put(state, basis) {
        this.letGo();
        this.#stand(state, basis);
        this.parts.pose(this, state.pose);
        this.parts.changed(this);
    }

    /** Puts a hypothesis in force, and the part at rest. No pull changes it. */
    choose(joint) {
        this.#put({ value: 0, pose: rest, joint: chosen(joint) }, JointBasis.CHOSEN);
    }

    /** Takes back the pulls that have changed the joint, with what they taught. Later pulls keep the joint from before. */
    takeBack() {
        this.#put({ ...this.before, joint: chosen(this.before.joint) }, JointBasis.CHOSEN);
    }

    reset() {
        this.#put({ value: 0, pose: rest, joint: this.object.joint(this.partId) }, JointBasis.PREPARED);
    }

    /** The end of the range that is farther from rest; a quarter turn, or half the part's size, where there is none. */
    get openValue() {
        const { type, lower, upper } = this.joint;
        if (type === JointType.CONTINUOUS || lower === upper) return type === JointType.PRISMATIC ? this.parts.asset.size / 2 : Math.PI / 2;
        return Math.abs(lower) > Math.abs(upper) ? lower : upper;
    }

    destroy() {
        this.letGo();
        if (!this.isShared) this.object.destroy();
    }
}

/** The parts found so far, and the figure that shows them. */
export class Parts {
    list = [];
    #next = 1;

    constructor(dragmesh, context, solver, asset, figure, changed) {
        Object.assign(this, { dragmesh, context, solver, asset, figure, changed });
        this.owners = new Uint16Array(asset.pieces.length);
        this.asked = new Map(); // what has been asked of each face, or told of each piece: a promise of a part, or of null
        this.staying = []; // lists of pieces that might move as one, but probably do not
        this.isKnown = asset.pieceCount === 1; // whether the asset has told its parts
        this.object = null; // of all parts that the asset has told
        this.isGone = false;
        solver.open(asset);
    }

    /** Asks which of the pieces move, which of them as one, and how. A file of one piece is asked where it is touched. */
    rig(progress) {
        this.rigged ??= this.asset.pieceCount > 1 ? this.#rig(progress).finally(() => { this.isKnown = true; }) : Promise.resolve();
        return this.rigged;
    }

    async #rig(progress) {
        const { parts, data } = await this.solver.solve({ rig: true, label: this.asset.name }, progress);
        if (this.isGone) return;
        this.object = data && this.context.loadObject(data);
        this.staying = parts.filter(part => part.state === AssetState.STAYS).map(part => this.#piecesOf(part));
        const made = new Map(); // index in the asset -> part
        parts.forEach((answer, index) => {
            if (answer.state === AssetState.STAYS) return;
            const pieces = new Set(this.#piecesOf(answer)), faces = Uint8Array.from(this.asset.pieces, piece => Number(pieces.has(piece)));
            const part = new Part(this, this.#next++, niceName(this.#nameOf(answer)) || `Part ${this.#next - 1}`, { ...answer, faces, object: this.object });
            faces.forEach((mark, face) => { if (mark) this.owners[face] = part.id; });
            made.set(index, part);
            this.list.push(part);
        });
        for (const [index, part] of made) part.parent = made.get(parts[index].parent) ?? null;
        this.figure.build(this.owners);
        this.list.forEach(part => { this.pose(part, part.state.pose); this.changed(part); });
    }

    #piecesOf(part) {
        return part.nodes.map(node => this.asset.nodes[node].piece).filter(piece => piece !== null);
    }

    // A part is called as the highest of its nodes that is above the one with the most faces.
    #nameOf({ nodes }) {
        const list = this.asset.nodes, count = new Uint32Array(this.asset.pieceCount);
        for (const piece of this.asset.pieces) count[piece]++;
        const faces = node => (list[node].piece === null ? 0 : count[list[node].piece]);
        let top = nodes.reduce((best, node) => (faces(node) > faces(best) ? node : best));
        while (nodes.includes(list[top].parent)) top = list[top].parent;
        return list[top].name ?? '';
    }

    byId(id) {
        return this.list.find(part => part.id === id) ?? null;
    }

    /** Whether a face is known to belong to no part. */
    isFixed(face) {
        return this.isKnown && this.asset.pieceCount > 1 && this.owners[face] === 0;
    }

    /** What a face that stays is called. */
    pieceName(face) {
        return niceName(nameOf(this.asset.pieceList[this.asset.pieces[face]].node)) || 'This piece';
    }

    /** The part at a face, found out once; null where nothing moves. point: of the scene, on the part at rest. */
    async find(face, point) {
        await this.rig().catch(() => null); // who asked first says why
        const owner = this.byId(this.owners[face]);
        if (owner || this.asset.pieceCount > 1) return owner;
        if (!this.asked.has(face)) this.asked.set(face, this.#ask({ find: { point: point.toArray(), vector: [0, 0, 0] } }, ''));
        return this.asked.get(face);
    }

    /** Makes a part of what stays at a face: those pieces that would move with it. */
    tell(face) {
        const piece = this.asset.pieces[face], { node, names, pivot } = this.asset.pieceList[piece];
        const free = each => !this.asset.pieces.some((other, at) => other === each && this.owners[at] !== 0);
        const pieces = (this.staying.find(each => each.includes(piece)) ?? [piece]).filter(free);
        if (!this.asked.has(piece)) this.asked.set(piece, this.#ask({ pieces, names, pivot }, nameOf(node) || names));
        return this.asked.get(piece);
    }

    async #ask(question, name) {
        let answer;
        try {
            answer = await this.solver.solve({ ...question, label: this.asset.name });
        } catch (error) {
            if (['DM_ERROR_FULL_MASK', 'DM_ERROR_EMPTY_MASK', 'DM_ERROR_DRAG_OFF_PART'].includes(error.code)) return null;
            throw error;
        }
        const share = answer.faces.reduce((sum, mark) => sum + mark, 0) / answer.faces.length;
        if (this.isGone || (!question.pieces && share > BODY_SHARE)) return null;
        return this.#add(answer, name);
    }

    // Faces inside another part make a part carried by it; a part around others carries them.
    #add(answer, name) {
        const part = new Part(this, this.#next++, niceName(name) || `Part ${this.#next - 1}`, answer);
        for (const other of this.list) {
            if (contains(other.faces, part.faces) && (!part.parent || contains(part.parent.faces, other.faces))) part.parent = other;
            else if (contains(part.faces, other.faces) && !other.parent) other.parent = part;
        }
        this.list.push(part);
        part.faces.forEach((mark, face) => {
            const owner = this.byId(this.owners[face]);
            if (mark && (!owner || owner === part.parent)) this.owners[face] = part.id;
        });
        this.figure.build(this.owners);
        this.list.forEach(each => this.pose(each, each.state.pose));
        this.changed(part);
        return part;
    }

    /** Gives the faces of a part back to what carries it, at rest, for good. */
    forget(part) {
        part.reset();
        this.list = this.list.filter(each => each !== part);
        for (const each of this.list) if (each.parent === part) each.parent = part.parent;
        this.owners.forEach((owner, face) => { if (owner === part.id) this.owners[face] = part.parent?.id ?? 0; });
        for (const [key, promise] of this.asked) {
            promise.then(found => {
                if (found !== part) return;
                if (this.asset.pieceCount > 1) this.asked.delete(key); // it may be told again
                else this.asked.set(key, Promise.resolve(null));
            });
        }
        part.destroy();
        this.figure.build(this.owners);
        this.list.forEach(each => this.pose(each, each.state.pose));
    }

    /** Shows a part at a pose, with what it carries. */
    pose(part, pose) {
        this.dragmesh.poseToMatrix(pose, part.own.elements);
        this.#place(part);
    }

    #place(part) {
        part.world.copy(part.own);
        if (part.parent) part.world.premultiply(part.parent.world);
        for (const mesh of this.figure.meshesOf(part.id)) {
            mesh.matrix.copy(part.world);
            mesh.matrixWorldNeedsUpdate = true;
        }
        for (const other of this.list) if (other.parent === part) this.#place(other);
    }

    /** Pose of a joint at a value as a matrix. */
    matrixAt(joint, value) {
        return this.dragmesh.poseToMatrix(this.dragmesh.jointPose(joint, value), new Matrix4().elements);
    }

    destroy() {
        this.isGone = true;
        this.list.forEach(part => part.destroy());
        this.object?.destroy();
    }
}

// A joint as the user's choice; its limits go on being estimates.
const chosen = joint => ({ ...joint, source: JointSource.CHOSEN, typeConfidence: 1, jointConfidence: 1 });

const contains = (outer, inner) => inner.every((mark, face) => !mark || outer[face]);

// 'Door_Left.001' reads 'Door left'.
function niceName(name) {
    const words = name.split('/').at(-1).replace(/\.\d+$/, '').replace(/([a-z])([A-Z])/g, '$1 $2').replace(/[_\-.]+/g, ' ').trim().toLowerCase();
    return words.slice(0, 28).replace(/^./, letter => letter.toUpperCase());
}
