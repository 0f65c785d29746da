// The parts of the asset: their faces, joints and poses, and the drag that moves one of them.
import { Matrix4, Ray, Vector3 } from './three/three.module.min.js';
import { DragFlag, DragPhase, Go, HandKind, JointBasis, JointSource, JointType } from './dragmesh/dragmesh.js';

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

    constructor(parts, id, name, answer) {
        Object.assign(this, { parts, id, name, faces: answer.faces, hypotheses: answer.hypotheses, degraded: answer.degraded, times: answer.times });
        this.object = parts.context.loadObject(answer.data);
        this.#stand({ value: 0, pose: rest, joint: answer.joint }, JointBasis.PREPARED);
        this.info = this.object.parts[0];
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
        this.drag = this.object.beginDrag({ partId: 1, state: this.state, limitGive: LIMIT_GIVE, rules: { driveSpeed: KEY_SPEED }, ...options });
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
        this.#put({ value: 0, pose: rest, joint: this.object.joint(1) }, JointBasis.PREPARED);
    }

    /** The end of the range that is farther from rest; a quarter turn, or half the part's size, where there is none. */
    get openValue() {
        const { type, lower, upper } = this.joint;
        if (type === JointType.CONTINUOUS || lower === upper) return type === JointType.PRISMATIC ? this.parts.asset.size / 2 : Math.PI / 2;
        return Math.abs(lower) > Math.abs(upper) ? lower : upper;
    }

    destroy() {
        this.object.destroy(); // its drags end with it
    }
}

/** The parts found so far, and the figure that shows them. */
export class Parts {
    list = [];
    #next = 1;

    constructor(dragmesh, context, solver, asset, figure, changed) {
        Object.assign(this, { dragmesh, context, solver, asset, figure, changed });
        this.owners = new Uint16Array(asset.pieces.length);
        this.asked = new Map(); // what has been asked of each piece: a promise of a part, or of null for the body
        solver.open(asset);
    }

    byId(id) {
        return this.list.find(part => part.id === id) ?? null;
    }

    /** Whether a face can't belong to a part: the largest of several pieces is the body. */
    isBody(face) {
        return this.asset.pieceCount > 1 && this.asset.pieces[face] === this.#bodyPiece;
    }

    get #bodyPiece() {
        return this.asset.pieces[this.asset.pieceList[this.asset.body].firstFace];
    }

    /** A point inside a face, at rest. */
    middleOf(face) {
        const { positions, indices } = this.asset, middle = new Vector3();
        for (let k = 0; k < 3; k++) middle.add(new Vector3().fromArray(positions, 3 * indices[3 * face + k]));
        return middle.divideScalar(3);
    }

    /** The part at a face, found out once; null where nothing moves. point: of the scene, on the part at rest. */
    find(face, point) {
        const owner = this.byId(this.owners[face]);
        if (owner) return Promise.resolve(owner);
        if (this.isBody(face)) return Promise.resolve(null);
        const several = this.asset.pieceCount > 1, key = several ? this.asset.pieces[face] : face;
        if (!this.asked.has(key)) this.asked.set(key, this.#ask(face, point, several));
        return this.asked.get(key);
    }

    async #ask(face, point, several) {
        const piece = this.asset.pieceList[this.asset.pieces[face] - 1];
        const hints = several ? { names: piece.names, pivot: piece.pivot } : {};
        let answer;
        try {
            answer = await this.solver.solve({ find: { point: point.toArray(), vector: [0, 0, 0] }, label: this.asset.name, ...hints });
        } catch (error) {
            if (['DM_ERROR_FULL_MASK', 'DM_ERROR_EMPTY_MASK', 'DM_ERROR_DRAG_OFF_PART'].includes(error.code)) return null;
            throw error;
        }
        const share = answer.faces.reduce((sum, mark) => sum + mark, 0) / answer.faces.length;
        if (!several && share > BODY_SHARE) return null;
        return this.#add(answer, several ? piece.node.name || piece.names : '');
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
        for (const [key, promise] of this.asked) promise.then(found => { if (found === part) this.asked.set(key, Promise.resolve(null)); });
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
        this.list.forEach(part => part.destroy());
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
