// dragmesh for JavaScript: makes any 3D object openable. README.md explains it, dragmesh.d.ts declares it.
import { ASSET_NO_NODE, ASSET_NO_PART, AssetFlag, AssetNodeFlag, FloatFormat, IntegerFormat, MAX_HYPOTHESES, MOTION_FRAMES, PartIdScope,
    PrepareFlag, Result, VERSION_NUMBER, structs } from './abi.js';
import { Memory, bytesOf, formatOf, integer } from './memory.js';

export * from './abi.js';

const resultNames = new Map(Object.entries(Result).map(([name, value]) => [value, `DM_${name}`]));
const indexFormats = ['UINT32', 'UINT16', 'UINT8'];
const dispose = Symbol.dispose ?? Symbol.for('Symbol.dispose');

/** What a call answers that fails. `code` is a name such as 'DM_ERROR_EMPTY_MASK', `result` its number. */
export class DragmeshError extends Error {
    constructor(result, message) {
        const code = resultNames.get(result) ?? 'DM_ERROR_UNKNOWN';
        super(message ? `${code}: ${message}` : code);
        this.name = 'DragmeshError';
        this.code = code;
        this.result = result;
    }
}

// Frees what the host has forgotten: a net, not a way to work. The argument holds no object of the host.
const forgotten = new FinalizationRegistry(release => release());

async function readModule(source) {
    if (source instanceof WebAssembly.Module) return source;
    if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
    if (typeof Response !== 'undefined' && source instanceof Response) return compileResponse(source);
    const url = new URL(source ?? './dragmesh.wasm', import.meta.url);
    if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
        const { readFile } = await import('node:fs/promises');
        return WebAssembly.compile(await readFile(url));
    }
    return compileResponse(await fetch(url));
}

// A server that calls the file anything but application/wasm costs the streaming, nothing else.
async function compileResponse(response) {
    if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
    const wasm = response.headers.get('Content-Type')?.split(';')[0].trim() === 'application/wasm';
    return wasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** Loads the module. wasm: its URL, bytes, Response or WebAssembly.Module; by default dragmesh.wasm beside this file. */
export async function load({ wasm } = {}) {
    const module = await readModule(wasm);
    const library = new Library();
    const instance = await WebAssembly.instantiate(module, library.imports());
    library.start(instance.exports);
    return new Dragmesh(library);
}

/** The module, and what its hooks call. */
class Library {
    contexts = new Map();

    imports() {
        // C code is never unwound: the call rethrows what a hook has thrown. No hook is called after that.
        const hook = (fallback, body) => (user, ...args) => {
            const live = this.contexts.get(user);
            if (!live || live.thrown) return fallback;
            live.inside = true;
            try {
                return body(live, ...args);
            } catch (error) {
                live.thrown = { error };
                return fallback;
            } finally {
                live.inside = false;
            }
        };
        const answer = (value, otherwise, what) => integer(value ?? otherwise, what, 'i32');
        return {
            host: {
                log: hook(undefined, (live, level, code, text) => {
                    live.message = this.memory.text(text);
                    if (!live.quiet) live.onLog?.(level, resultNames.get(code) ?? String(code), live.message);
                }),
                intent: hook(0, ({ hooks }, partId, low, high) => answer(hooks.intent(partId, this.memory.read('dm_vec3', low), this.memory.read('dm_vec3', high)), 0, 'what intent answers')),
                progress: hook(1, ({ hooks }, done) => (hooks.progress(done) ? 1 : 0)),
                choose: hook(-1, ({ hooks }, choice) => answer(hooks.choose(this.#choice(choice)), -1, 'what choose answers')),
            },
            env: { emscripten_notify_memory_growth() {} },
        };
    }

    start(exports) {
        this.exports = exports;
        this.memory = new Memory(exports);
        exports._initialize?.();
        if (exports.dm_version() !== VERSION_NUMBER) throw new DragmeshError(Result.ERROR_VERSION, 'dragmesh.wasm is of another version than dragmesh.js');
        const bytes = name => exports.malloc(structs[name].size);
        // Where the calls of a frame have their arguments: they allocate nothing.
        this.ray = bytes('dm_ray');
        this.input = bytes('dm_drag_input');
        this.state = bytes('dm_drag_state');
        this.pose = bytes('dm_pose');
        this.hit = bytes('dm_hit');
    }

    #choice(address) {
        const choice = this.memory.read('dm_choice', address);
        const hypotheses = Array.from({ length: choice.count }, (_, i) => {
            const at = this.memory.view.getUint32(choice.hypotheses + 4 * i, true);
            const hypothesis = this.memory.read('dm_hypothesis', at);
            return { joint: this.memory.read('dm_joint', hypothesis.joint), ends: hypothesis.ends };
        });
        return { part: this.memory.read('dm_part_info', choice.part), hypotheses };
    }

    scope(body) {
        return this.memory.scope(body);
    }
}

/** The library. Functions of joints and poses need no context. */
export class Dragmesh {
    #library;

    constructor(library) {
        this.#library = library;
    }

    /** The module's exports and memory, for hosts that call C themselves: dragmesh.h and abi.js say how. */
    get exports() {
        return this.#library.exports;
    }

    createContext(options = {}) {
        return new Context(this.#library, options);
    }

    /** Pose of a joint at a value. */
    jointPose(joint, value) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_pose');
            this.#call('dm_joint_pose', scope.struct('dm_joint', joint), value, out);
            return this.#library.memory.read('dm_pose', out);
        });
    }

    /** The value at which a joint comes nearest to a pose, and how far off it the pose is. */
    jointValue(joint, pose) {
        return this.#library.scope(scope => {
            const out = scope.allocate(12), { memory } = this.#library;
            this.#call('dm_joint_value', scope.struct('dm_joint', joint), scope.struct('dm_pose', pose), out, out + 4, out + 8);
            const number = i => memory.view.getFloat32(out + 4 * i, true);
            return { value: number(0), angleError: number(1), distanceError: number(2) };
        });
    }

    /** The value at a share of the way from rest (0) to open (1). */
    jointValueAt(joint, share) {
        return this.#library.scope(scope => {
            const out = scope.allocate(4);
            this.#call('dm_joint_value_at', scope.struct('dm_joint', joint), share, out);
            return this.#library.memory.view.getFloat32(out, true);
        });
    }

    /** The joint as a physics engine's constraint wants it. */
    jointFrame(joint) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_joint_frame');
            this.#call('dm_joint_get_frame', scope.struct('dm_joint', joint), out);
            return this.#library.memory.read('dm_joint_frame', out);
        });
    }

    /** The joint in the frame of an instance that is scaled along the axes of the object frame. */
    scaleJoint(joint, scale) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_joint', joint);
            this.#call('dm_joint_scale', out, scope.struct('dm_vec3', scale), out);
            return this.#library.memory.read('dm_joint', out);
        });
    }

    /** a after b. */
    multiplyPoses(a, b) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_pose', b);
            this.#library.exports.dm_pose_multiply(scope.struct('dm_pose', a), out, out);
            return this.#library.memory.read('dm_pose', out);
        });
    }

    /** 4 x 4, column-major: THREE.Matrix4.fromArray takes it. `out` may be any array of 16. */
    poseToMatrix(pose, out = new Float32Array(16)) {
        return this.#library.scope(scope => {
            const matrix = scope.allocate(64), { memory } = this.#library;
            this.#library.exports.dm_pose_to_matrix(scope.struct('dm_pose', pose), matrix);
            for (let i = 0; i < 16; i++) out[i] = memory.view.getFloat32(matrix + 4 * i, true);
            return out;
        });
    }

    #call(name, ...args) {
        const result = this.#library.exports[name](...args);
        if (result !== Result.OK) throw new DragmeshError(result, name);
    }
}

/** Throws what a hook has thrown, or the error of a result. */
function check(live, result) {
    const { thrown } = live;
    live.thrown = null;
    if (thrown) throw thrown.error;
    if (result !== Result.OK) throw new DragmeshError(result, live.message);
}

function refuseInside(live) {
    if (live.inside) throw new DragmeshError(Result.ERROR_INVALID_ARGUMENT, 'a hook must not call the context that calls it');
}

function destroyContext(library, live) {
    live.quiet = true;
    if (live.address !== 0) library.exports.dm_context_destroy(live.address);
    live.address = 0;
    library.contexts.delete(live.slot);
    library.exports.free(live.slot); // free(0) does nothing
    live.slot = 0;
}

// It may have ended with what it belongs to, which is no error here.
function endQuietly(library, live, destroyer, ...args) {
    live.quiet = true;
    library.exports[destroyer](live.address, ...args);
    live.quiet = false;
}

/** Base of what lives in a context. */
class Owned {
    #release;

    // `destroyer` is the function of C that destroys it. A handle that has ended already is no error.
    constructor(context, handle, destroyer, ...rest) {
        this.context = context;
        this.handle = handle;
        const { live, library } = context;
        this.#release = () => {
            if (live.address !== 0) endQuietly(library, live, destroyer, handle, ...rest);
        };
        forgotten.register(this, this.#release, this);
    }

    /** Frees it. Twice does nothing more; calls on it throw DM_ERROR_STALE_HANDLE from then on. */
    destroy() {
        refuseInside(this.context.live);
        forgotten.unregister(this);
        this.#release();
    }

    [dispose]() {
        this.destroy();
    }
}

/** Owns everything that is made with it. */
export class Context {
    #library;

    constructor(library, { onLog, axes, unitInMetres, customAxes, picking, ...unknown }) {
        this.#library = library;
        for (const key of Object.keys(unknown)) throw new TypeError(`a context has no option "${key}"`);
        const slot = library.exports.malloc(1); // its address names this context to the hooks
        if (slot === 0) throw new RangeError('no memory for a context');
        const live = { address: 0, slot, onLog, hooks: null, message: '', quiet: false, inside: false, thrown: null };
        this.live = live;
        library.contexts.set(slot, live);
        try {
            library.scope(scope => {
                const options = scope.struct('dm_context_desc', { axes, unitInMetres, customAxes, picking }), out = scope.allocate(4);
                const log = options + structs.dm_context_desc.fields.log[0];
                library.exports.dmjs_log(log);
                library.memory.view.setUint32(log + structs.dm_log.fields.user[0], slot, true);
                check(live, library.exports.dm_context_create(options, out));
                live.address = library.memory.view.getUint32(out, true);
            });
        } catch (error) {
            destroyContext(library, live);
            throw error;
        }
        forgotten.register(this, () => destroyContext(library, live), this);
    }

    /** Destroys it and everything made with it. */
    destroy() {
        refuseInside(this.live);
        forgotten.unregister(this);
        destroyContext(this.#library, this.live);
    }

    [dispose]() {
        this.destroy();
    }

    /** Calls a function of C with this context before its arguments; throws what it answers. */
    call(name, ...args) {
        if (this.live.address === 0) throw new DragmeshError(Result.ERROR_STALE_HANDLE, 'the context is destroyed');
        refuseInside(this.live);
        this.live.message = '';
        check(this.live, this.#library.exports[name](this.live.address, ...args));
    }

    get library() {
        return this.#library;
    }

    /** Runs body with hooks that the library may call meanwhile. */
    #hooked(hooks, body) {
        this.live.hooks = hooks;
        try {
            return body();
        } finally {
            this.live.hooks = null;
        }
    }

    /** Calls a function that makes something, and returns its handle. What a hook throws leaves nothing made. */
    make(scope, destroyer, name, ...args) {
        const out = scope.allocate(8), handle = () => this.#library.memory.view.getBigUint64(out, true);
        this.#library.memory.view.setBigUint64(out, 0n, true);
        try {
            this.call(name, ...args, out);
        } catch (error) {
            if (handle() !== 0n) endQuietly(this.#library, this.live, destroyer, handle(), 0);
            throw error;
        }
        return handle();
    }

    /** Bytes held now, most ever held, and how many allocations there were. */
    get memory() {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_memory_info');
            this.call('dm_context_get_memory', out);
            return this.#library.memory.read('dm_memory_info', out);
        });
    }

    /** Loads weights from the bytes of the files of sdk/models; each may be absent. */
    loadModel({ kinematics, motion, ranker }) {
        return this.#library.scope(scope => {
            const desc = {};
            for (const [name, data] of Object.entries({ kinematics, motion, ranker })) {
                if (data === undefined || data === null) continue;
                const bytes = bytesOf(data, name);
                desc[name] = scope.copy(bytes);
                desc[`${name}Size`] = bytes.length;
            }
            return new Model(this, this.make(scope, 'dm_model_unload', 'dm_model_load', scope.struct('dm_model_desc', desc)));
        });
    }

    /** Fetches the three files of weights from a folder's URL, and loads them. One that is not there (404) is left out,
     * which PreparedObject.info.degraded tells; where none is, that is an error. */
    async fetchModel(folder) {
        const files = { kinematics: 'kpp_net', motion: 'dq_vae', ranker: 'ranker' };
        const data = await Promise.all(Object.values(files).map(async name => {
            const response = await fetch(`${String(folder).replace(/\/$/, '')}/${name}.safetensors`);
            if (response.status === 404) return null;
            if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
            return response.arrayBuffer();
        }));
        if (data.every(bytes => bytes === null)) throw new Error(`${folder}: there are no weights`);
        return this.loadModel(Object.fromEntries(Object.keys(files).map((key, i) => [key, data[i]])));
    }

    /** Marks the faces that move with the point that was grabbed: 1, else 0. */
    findPart(mesh, { point, vector = [0, 0, 0] }) {
        return this.#library.scope(scope => {
            const faces = faceCount(mesh), out = scope.allocate(faces);
            this.call('dm_mesh_find_part', writeMesh(scope, mesh), scope.struct('dm_drag_hint', { point, vector }), out, BigInt(faces));
            return this.#library.memory.bytes(out, faces).slice();
        });
    }

    /** Finds out how each part of a mesh moves. */
    prepare({ mesh, parts, model, label, seed = 0, flags = 0, up, picking = true, intent, progress, choose }) {
        return this.#library.scope(scope => {
            const { exports } = this.#library, user = this.live.slot;
            const desc = { mesh: writeMesh(scope, mesh), model: model?.handle, seed, up };
            desc.flags = flags | (picking ? 0 : PrepareFlag.WITHOUT_PICKING);
            if (parts) desc.parts = scope.structs('dm_part_desc', Array.from(parts, part => writePart(scope, part))), desc.partCount = parts.length;
            if (label) desc.label = scope.text(label, 'label');
            if (intent) desc.intent = exports.dmjs_intent(), desc.intentUser = user;
            if (progress) desc.progress = exports.dmjs_progress(), desc.progressUser = user;
            if (choose) desc.choose = exports.dmjs_choose(), desc.chooseUser = user;
            const address = scope.struct('dm_object_desc', desc);
            return new PreparedObject(this, this.#hooked({ intent, progress, choose }, () => this.make(scope, 'dm_object_destroy', 'dm_object_prepare', address)));
        });
    }

    /** Finds out which nodes of a whole asset move, which of them as one, and how. names, clips: whether they count. */
    rig({ nodes, model, label, seed = 0, flags = 0, up, minMoves, names = true, clips = true, picking = true, progress }) {
        return this.#library.scope(scope => {
            const rows = Array.from(nodes, node => writeNode(scope, node));
            const desc = { nodes: scope.structs('dm_asset_node', rows), nodeCount: rows.length, model: model?.handle, seed, up, minMoves };
            desc.flags = flags | (picking ? 0 : PrepareFlag.WITHOUT_PICKING) | (names ? 0 : AssetFlag.WITHOUT_NAMES) | (clips ? 0 : AssetFlag.WITHOUT_CLIPS);
            if (label) desc.label = scope.text(label, 'label');
            if (progress) desc.progress = this.#library.exports.dmjs_progress(), desc.progressUser = this.live.slot;
            const address = scope.struct('dm_asset_desc', desc);
            return new Asset(this, this.#hooked({ progress }, () => this.make(scope, 'dm_asset_destroy', 'dm_asset_create', address)));
        });
    }

    /** Reads the bytes that PreparedObject.save has made. */
    loadObject(data, model) {
        return this.#library.scope(scope => {
            const bytes = bytesOf(data, 'data');
            const handle = this.make(scope, 'dm_object_destroy', 'dm_object_load', scope.copy(bytes), bytes.length, model?.handle ?? 0n);
            return new PreparedObject(this, handle);
        });
    }

    createScene() {
        return this.#library.scope(scope => new Scene(this, this.make(scope, 'dm_scene_destroy', 'dm_scene_create', scope.struct('dm_scene_desc'))));
    }

    /** Ray through a pixel of a camera; (0, 0) is the top left corner. */
    cameraRay(camera, x, y) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_ray');
            this.call('dm_camera_ray', scope.struct('dm_camera', camera), x, y, out);
            return this.#library.memory.read('dm_ray', out);
        });
    }
}

function faceCount({ positions, positionStride = 0, indices }) {
    if (indices) return Math.floor(indices.length / 3);
    return Math.floor(vertexCount(positions, positionStride) / 3);
}

// Vertices of a buffer; the last one may end without the rest of its stride.
function vertexCount(positions, stride) {
    const packed = 3 * positions.BYTES_PER_ELEMENT, step = stride || packed;
    return positions.byteLength < packed ? 0 : Math.floor((positions.byteLength - packed) / step) + 1;
}

function writeMesh(scope, { positions, positionStride = 0, indices, partIds, partIdScope = PartIdScope.VERTEX }) {
    const desc = { positionStride, partIdScope };
    desc.positionFormat = FloatFormat[formatOf(positions, ['FLOAT32', 'FLOAT64'], 'positions')];
    desc.positions = scope.copy(positions);
    desc.vertexCount = vertexCount(positions, positionStride);
    desc.positionBytes = positions.byteLength;
    if (indices) {
        desc.indexFormat = IntegerFormat[formatOf(indices, indexFormats, 'indices')];
        desc.indices = scope.copy(indices);
        desc.indexBytes = indices.byteLength;
    }
    desc.indexCount = indices ? indices.length : desc.vertexCount;
    if (partIds) {
        desc.partIdFormat = IntegerFormat[formatOf(partIds, [...indexFormats, 'INT32'], 'partIds')];
        desc.partIds = scope.copy(partIds);
        desc.partIdBytes = partIds.byteLength;
    }
    return scope.struct('dm_mesh_desc', desc);
}

function writePart(scope, { label, pivot, drag, ...rest }) {
    return { ...rest, label: label && scope.text(label, 'label'), pivot: pivot && scope.struct('dm_pivot', pivot), drag: drag && scope.struct('dm_drag_hint', drag) };
}

// Sixteen numbers, column by column.
function writeMatrix(scope, values) {
    if (values.length !== 16) throw new RangeError(`a transform has 16 numbers, not ${values.length}`);
    return scope.copy(Float32Array.from(values));
}

function writeClip(scope, { name, times, poses }) {
    if (times.length !== poses.length) throw new RangeError(`${times.length} times for ${poses.length} poses`);
    return { name: name && scope.text(name, 'name'), times: scope.copy(Float32Array.from(times)), poses: scope.structs('dm_pose', poses), keyCount: poses.length };
}

function writeNode(scope, { name, meshName, parent, positions, indices, positionStride, transform, pivot, joint, clips, follows, noPivot, ...unknown }) {
    for (const key of Object.keys(unknown)) throw new TypeError(`a node has no "${key}"`);
    return {
        flags: (follows !== undefined ? AssetNodeFlag.FOLLOWS : 0) | (noPivot ? AssetNodeFlag.NO_PIVOT : 0),
        parent: parent ?? ASSET_NO_NODE, follows: follows ?? ASSET_NO_NODE,
        name: name && scope.text(name, 'name'), meshName: meshName && scope.text(meshName, 'meshName'),
        mesh: positions && writeMesh(scope, { positions, indices, positionStride }),
        transform: transform && writeMatrix(scope, transform), pivot: pivot && scope.struct('dm_pivot', pivot),
        joint: joint && scope.struct('dm_joint', joint),
        clips: clips && scope.structs('dm_asset_clip', Array.from(clips, clip => writeClip(scope, clip))), clipCount: clips?.length,
    };
}

/** A whole asset: which of its nodes move, how, and what carries them. */
export class Asset extends Owned {
    constructor(context, handle) {
        super(context, handle, 'dm_asset_destroy');
    }

    #read(struct, name, ...args) {
        const { library } = this.context;
        return library.scope(scope => {
            const out = scope.struct(struct);
            this.context.call(name, this.handle, ...args, out);
            return library.memory.read(struct, out);
        });
    }

    #indices(count, name, ...args) {
        const { library } = this.context;
        return library.scope(scope => {
            const out = scope.allocate(4 * count);
            this.context.call(name, this.handle, ...args, out, count);
            return Array.from({ length: count }, (_, i) => library.memory.view.getUint32(out + 4 * i, true));
        });
    }

    get info() {
        return this.#read('dm_asset_info', 'dm_asset_get_info');
    }

    /** All parts, those that stay included. parent: index of the part that carries it; null: the body. */
    get parts() {
        return Array.from({ length: this.info.partCount }, (_, i) => {
            const part = this.#read('dm_asset_part', 'dm_asset_get_part', i);
            return { ...part, parent: part.parent === ASSET_NO_PART ? null : part.parent };
        });
    }

    /** How a part moves; of one that stays, how it would. */
    joint(index) {
        return this.#read('dm_joint', 'dm_asset_get_joint', integer(index, 'index'));
    }

    /** The nodes of a part, rising. */
    partNodes(index) {
        const { nodeCount } = this.#read('dm_asset_part', 'dm_asset_get_part', integer(index, 'index'));
        return this.#indices(nodeCount, 'dm_asset_get_part_nodes', index);
    }

    /** The index of each node's part; null: the body. */
    get nodeParts() {
        return this.#indices(this.info.nodeCount, 'dm_asset_get_node_parts').map(part => (part === ASSET_NO_PART ? null : part));
    }

    /** A prepared object of the parts that move or are free: their ids are their indices + 1. */
    makeObject() {
        const { context } = this;
        return context.library.scope(scope => new PreparedObject(context, context.make(scope, 'dm_object_destroy', 'dm_asset_make_object', this.handle)));
    }
}

/** Loaded weights. */
export class Model extends Owned {
    constructor(context, handle) {
        super(context, handle, 'dm_model_unload');
    }
}

/** A mesh whose parts have joints. */
export class PreparedObject extends Owned {
    constructor(context, handle) {
        super(context, handle, 'dm_object_destroy');
    }

    #call(name, ...args) {
        this.context.call(name, this.handle, ...args);
    }

    #read(struct, name, ...args) {
        const { library } = this.context;
        return library.scope(scope => {
            const out = scope.struct(struct);
            this.#call(name, ...args, out);
            return library.memory.read(struct, out);
        });
    }

    get info() {
        return this.#read('dm_object_info', 'dm_object_get_info');
    }

    /** The parts, in order of id. */
    get parts() {
        return Array.from({ length: this.info.partCount }, (_, i) => this.#read('dm_part_info', 'dm_object_get_part', i));
    }

    /** The joint in force. */
    joint(partId) {
        return this.#read('dm_joint', 'dm_object_get_joint', integer(partId, 'partId'));
    }

    /** Ranked hypotheses, best first; `drag` ranks them anew. */
    hypotheses(partId, drag) {
        const { library } = this.context;
        return library.scope(scope => {
            const list = scope.structs('dm_joint', Array.from({ length: MAX_HYPOTHESES }, () => ({}))), count = scope.allocate(4);
            this.#call('dm_object_get_hypotheses', integer(partId, 'partId'), drag ? scope.struct('dm_drag_hint', drag) : 0, list, MAX_HYPOTHESES, count);
            return Array.from({ length: library.memory.view.getUint32(count, true) }, (_, i) => library.memory.read('dm_joint', list + i * structs.dm_joint.size));
        });
    }

    /** Infers the joint of a part again, with a drag as evidence. */
    refine(partId, drag) {
        this.context.library.scope(scope => this.#call('dm_object_refine', integer(partId, 'partId'), scope.struct('dm_drag_hint', drag)));
    }

    /** Puts a joint of the host's in force. */
    setJoint(partId, joint) {
        this.context.library.scope(scope => this.#call('dm_object_set_joint', integer(partId, 'partId'), scope.struct('dm_joint', joint)));
    }

    /** Puts the library's own answer back in force. */
    resetJoint(partId) {
        this.#call('dm_object_reset_joint', integer(partId, 'partId'));
    }

    /** Links parts, in place of the links of before. */
    setLinks(links) {
        const rows = Array.from(links);
        this.context.library.scope(scope => this.#call('dm_object_set_links', scope.structs('dm_link', rows), rows.length));
    }

    /** Moves what is linked with a part: changes `values`, one a part in order of id; returns which parts are held. */
    followLinks(partId, values) {
        const { library } = this.context;
        return library.scope(scope => {
            const given = Float32Array.from(values), { length } = given, numbers = scope.copy(given), held = scope.allocate(length);
            this.#call('dm_object_follow_links', integer(partId, 'partId'), numbers, held, length);
            for (let i = 0; i < length; i++) values[i] = library.memory.view.getFloat32(numbers + 4 * i, true);
            return Array.from(library.memory.bytes(held, length), Boolean);
        });
    }

    /** The prepared object as bytes of a .dmo file. */
    save() {
        const { library } = this.context;
        return library.scope(scope => {
            const size = scope.allocate(4), read = () => library.memory.view.getUint32(size, true);
            this.#call('dm_object_save', 0, 0, size);
            const data = scope.allocate(read());
            this.#call('dm_object_save', data, read(), size);
            return library.memory.bytes(data, read()).slice();
        });
    }

    /** The player grabs a part. */
    beginDrag({ rules, state, ...desc }) {
        const { library } = this.context;
        return library.scope(scope => {
            const address = scope.struct('dm_drag_desc', {
                ...desc, object: this.handle, state: state && scope.struct('dm_part_state', state), rules: rules && writeRules(scope, rules) });
            return new Drag(this, this.context.make(scope, 'dm_drag_end', 'dm_drag_begin', address));
        });
    }

    /** A motion of the part for a drag: 16 poses from rest. */
    generateMotion({ path, ...desc }) {
        const { library } = this.context;
        return library.scope(scope => {
            const rows = path && Array.from(path), points = rows && scope.structs('dm_vec3', rows);
            const address = scope.struct('dm_motion_desc', { ...desc, path: points, pathCount: rows?.length });
            return new Motion(this, this.context.make(scope, 'dm_motion_destroy', 'dm_motion_generate', this.handle, address));
        });
    }
}

function writeRules(scope, { snaps, ...rules }) {
    const values = snaps && Float32Array.from(snaps);
    return scope.struct('dm_drag_rules', { ...rules, snaps: values && scope.copy(values), snapCount: values?.length });
}

/** One player dragging one part. */
export class Drag extends Owned {
    /** What the last update has answered: the same object for the whole drag. */
    state = {};
    #library;

    constructor(object, handle) {
        super(object.context, handle, 'dm_drag_end', 0);
        this.object = object; // lives as long as its drags
        this.#library = object.context.library;
    }

    // Reads the state that a call of a frame has written.
    #frame(name, ...args) {
        const { memory, state } = this.#library;
        memory.view.setUint32(state, structs.dm_drag_state.size, true);
        this.context.call(name, this.handle, ...args, state);
        return memory.read('dm_drag_state', state, this.state);
    }

    /** The grabbed point follows the ray; dt in seconds. ray null: the part moves by itself. */
    update(ray, dt) {
        if (ray) {
            this.#library.memory.writeVector(this.#library.ray, ray.origin);
            this.#library.memory.writeVector(this.#library.ray + 12, ray.direction);
        }
        return this.#frame('dm_drag_update', ray ? this.#library.ray : 0, dt);
    }

    /** update for all that can be told a drag: hands, handles, bounds. */
    updateInput(input, dt) {
        this.#library.memory.write('dm_drag_input', this.#library.input, input);
        return this.#frame('dm_drag_step', this.#library.input, dt);
    }

    /** After an updateInput with InputFlag.ASK: takes another value. */
    override(value) {
        return this.#frame('dm_drag_take', value);
    }

    /** updateInput, by its name in 0.2. */
    step(input, dt) {
        return this.updateInput(input, dt);
    }

    /** override, by its name in 0.2. */
    take(value) {
        return this.override(value);
    }

    /** The player lets go; update moves the part on. */
    release(desc = {}) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_release_plan');
            this.context.call('dm_drag_release', this.handle, scope.struct('dm_release_desc', desc), out);
            return this.#library.memory.read('dm_release_plan', out);
        });
    }

    /** Ends the drag; returns joint, value and pose of the part: `state` of the next beginDrag. */
    end() {
        const state = this.#partState('dm_drag_end');
        this.destroy();
        return state;
    }

    get partState() {
        return this.#partState('dm_drag_get_part_state');
    }

    #partState(name) {
        return this.#library.scope(scope => {
            const out = scope.struct('dm_part_state');
            this.context.call(name, this.handle, out);
            return this.#library.memory.read('dm_part_state', out);
        });
    }

    /** The whole state of the drag, for rollback within this version of the library. */
    save() {
        return this.#library.scope(scope => {
            const size = this.#library.exports.dm_drag_snapshot_size(), data = scope.allocate(size);
            this.context.call('dm_drag_save', this.handle, data, size);
            return this.#library.memory.bytes(data, size).slice();
        });
    }

    restore(data) {
        const bytes = bytesOf(data, 'data');
        this.#library.scope(scope => this.context.call('dm_drag_restore', this.handle, scope.copy(bytes), bytes.length));
    }
}

/** A generated motion of one part. */
export class Motion extends Owned {
    constructor(object, handle) {
        super(object.context, handle, 'dm_motion_destroy');
        this.object = object;
    }

    /** Pose and joint value at t, 0 to 1. */
    sample(t) {
        const { library } = this.context;
        return library.scope(scope => {
            const value = scope.allocate(4);
            this.context.call('dm_motion_sample', this.handle, t, library.pose, value);
            return { pose: library.memory.read('dm_pose', library.pose), value: library.memory.view.getFloat32(value, true) };
        });
    }

    /** The 16 key poses, with their joint values. */
    get frames() {
        const { library } = this.context;
        return library.scope(scope => {
            const poses = scope.allocate(MOTION_FRAMES * structs.dm_pose.size), values = scope.allocate(4 * MOTION_FRAMES);
            this.context.call('dm_motion_get_frames', this.handle, poses, values);
            return Array.from({ length: MOTION_FRAMES }, (_, i) => ({
                pose: library.memory.read('dm_pose', poses + i * structs.dm_pose.size),
                value: library.memory.view.getFloat32(values + 4 * i, true),
            }));
        });
    }
}

/** Placed objects that rays can pick. */
export class Scene extends Owned {
    #objects = new Map(); // instance -> object, which lives as long as it is placed

    constructor(context, handle) {
        super(context, handle, 'dm_scene_destroy');
    }

    /** Places an object; returns the number of the instance. */
    add(object, placement) {
        const { library } = this.context;
        return library.scope(scope => {
            const out = scope.allocate(4);
            this.context.call('dm_scene_add', this.handle, object.handle, placement ? scope.struct('dm_pose', placement) : 0, out);
            const instance = library.memory.view.getUint32(out, true);
            this.#objects.set(instance, object);
            return instance;
        });
    }

    /** Moves a part of an instance, or with part 0 the whole instance. */
    move(instance, partId, pose) {
        const { library } = this.context;
        library.memory.write('dm_pose', library.pose, pose);
        this.context.call('dm_scene_move', this.handle, integer(instance, 'instance'), integer(partId, 'partId'), library.pose);
    }

    remove(instance) {
        this.context.call('dm_scene_remove', this.handle, integer(instance, 'instance'));
        this.#objects.delete(instance);
    }

    /** Makes the moves visible to picks. */
    commit() {
        this.context.call('dm_scene_commit', this.handle);
    }

    /** Nearest hit of a ray; null when nothing is hit. */
    pick(ray) {
        const { library } = this.context, { memory } = library;
        memory.write('dm_ray', library.ray, { origin: ray.origin, direction: ray.direction });
        memory.view.setUint32(library.hit, structs.dm_hit.size, true);
        this.context.call('dm_scene_pick', this.handle, library.ray, library.hit);
        const { object, ...hit } = memory.read('dm_hit', library.hit);
        return object === 0 ? null : { ...hit, object: this.#objects.get(hit.instance) };
    }
}
