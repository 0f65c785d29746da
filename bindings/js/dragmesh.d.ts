// Types of dragmesh.js. Units are the host's, angles radians; README.md explains the rest.
export * from './abi.js';

/** [x, y, z], or an object with x, y and z: a THREE.Vector3. */
export type VectorLike = ArrayLike<number> | { x: number; y: number; z: number };
export type Vector = [number, number, number];

/** A rigid pose as a unit dual quaternion, x, y, z, w: a point x goes to R x + t. */
export interface Pose {
    real: [number, number, number, number];
    dual: [number, number, number, number];
}
/** A THREE.Ray is one. */
export interface Ray {
    origin: VectorLike;
    direction: VectorLike;
}
export interface Hint {
    /** On or near the part, object frame. */
    point: VectorLike;
    /** How it was pulled. */
    vector: VectorLike;
}
export interface Mesh {
    /** Three numbers a vertex. */
    positions: Float32Array | Float64Array;
    /** Bytes between vertices; 0 or absent = packed. */
    positionStride?: number;
    /** Three a triangle; absent = vertices in order. */
    indices?: Uint32Array | Uint16Array | Uint8Array;
    /** 0 = the body that stays, 1 … = parts. */
    partIds?: Uint32Array | Uint16Array | Uint8Array | Int32Array;
    /** PartIdScope.VERTEX (default) or PartIdScope.FACE. */
    partIdScope?: number;
}
export interface Part {
    /** As in partIds. */
    id: number;
    /** Part that carries it; 0 = the body. */
    parent?: number;
    /** JointType; absent = to be found out. */
    jointType?: number;
    drag?: Hint;
    /** Names of the asset, outermost first: 'kitchen/cabinet/door'. */
    label?: string;
    /** Where the asset has the node that moves the part. */
    pivot?: { origin: VectorLike; axes?: ArrayLike<number> };
}
/** A node of an asset as a scene has it. */
export interface AssetNode {
    name?: string;
    meshName?: string;
    /** Index of the node above it; null or absent: none. */
    parent?: number | null;
    /** Its mesh, as of Mesh; absent: a group. */
    positions?: Mesh['positions'];
    positionStride?: number;
    indices?: Mesh['indices'];
    /** 16 numbers, column-major: node to asset. */
    transform?: ArrayLike<number>;
    /** Asset frame; absent: origin and axes of transform. */
    pivot?: { origin: VectorLike; axes?: ArrayLike<number> };
    /** Where its origin lies says nothing. */
    noPivot?: boolean;
    /** A joint that the file states, asset frame. */
    joint?: JointLike;
    /** How animations move it, from the pose that its mesh has, asset frame. */
    clips?: { name?: string; times: ArrayLike<number>; poses: Pose[] }[];
    /** Neither part nor body, such as a collider: index of the node with which it goes; null: the one above it. */
    follows?: number | null;
}
export interface RigOptions {
    nodes: AssetNode[];
    model?: Model;
    /** Names of the whole asset. */
    label?: string;
    seed?: number;
    /** AssetFlag, PrepareFlag */
    flags?: number;
    /** Which way is up; absent: that of the context's axes. */
    up?: VectorLike;
    /** Probability from which on a part moves; absent: 0.5. */
    minMoves?: number;
    /** Whether names, and clips, count; true. */
    names?: boolean;
    clips?: boolean;
    picking?: boolean;
    /** Share done, rising; true cancels. */
    progress?: (share: number) => boolean | void;
}
/** Nodes that move as one, or might. */
export interface AssetPart {
    /** Index of the part that carries it; null: the body. */
    parent: number | null;
    /** In the object: its index + 1; 0 while it stays. */
    partId: number;
    /** AssetState */
    state: number;
    /** AssetBasis */
    basis: number;
    /** Probability that it moves. */
    moves: number;
    nodeCount: number;
    triangleCount: number;
    duration: number;
    boxMin: Vector;
    boxMax: Vector;
}
/** How a part moves. */
export interface Joint {
    /** JointType */
    type: number;
    typeConfidence: number;
    jointConfidence: number;
    pitch: number;
    axis: Vector;
    origin: Vector;
    lower: number;
    upper: number;
    /** JointSource */
    source: number;
    /** In a part state: four numbers, what the part's pulls have said. Keep them as they are. */
    evidence: number[];
}
/** A joint that the host knows: what is absent is 0. */
export type JointLike = { type: number; axis: VectorLike; origin?: VectorLike } & Partial<Omit<Joint, 'axis' | 'origin' | 'type'>>;
export interface JointFrame {
    type: number;
    origin: Vector;
    x: Vector;
    y: Vector;
    z: Vector;
    rotation: [number, number, number, number];
    lower: number;
    upper: number;
    limits: number;
    pitch: number;
}
export interface PartInfo {
    id: number;
    parent: number;
    triangleCount: number;
    boxMin: Vector;
    boxMax: Vector;
    centre: Vector;
    area: number;
}
export interface ObjectInfo {
    partCount: number;
    vertexCount: number;
    triangleCount: number;
    boxMin: Vector;
    boxMax: Vector;
    size: number;
    pickable: number;
    /** Bits of Degraded. */
    degraded: number;
}
export interface Choice {
    part: PartInfo;
    hypotheses: { joint: Joint; ends: { value: number; pose: Pose; boxMin: Vector; boxMax: Vector; centre: Vector }[] }[];
}
export interface ContextOptions {
    /** Axes; default Axes.GLTF. */
    axes?: number;
    unitInMetres?: number;
    customAxes?: ArrayLike<number>;
    /** Picking; Picking.NONE for hosts that cast their own rays. */
    picking?: number;
    /** level: LogLevel; code: name of the result. */
    onLog?(level: number, code: string, text: string): void;
}
export interface PrepareOptions {
    mesh: Mesh;
    /** Absent: every id above 0 is a part. */
    parts?: Part[];
    model?: Model;
    label?: string;
    seed?: number | bigint;
    /** PrepareFlag */
    flags?: number;
    /** false: keep no triangles; the object is small then and can't be in a Scene. */
    picking?: boolean;
    up?: VectorLike;
    intent?(partId: number, boxMin: Vector, boxMax: Vector): number;
    /** 0 to 1; a true answer cancels. */
    progress?(done: number): boolean | void;
    /** Index of the right hypothesis, or Choice.KEEP. */
    choose?(choice: Choice): number;
}
export interface Feel {
    smoothingTime?: number;
    softLimit?: number;
    coastTime?: number;
    detent?: number;
    detentPull?: number;
    returnTime?: number;
}
export interface Rules {
    /** RuleFlag */
    flags?: number;
    snaps?: ArrayLike<number>;
    snapReach?: number;
    openShare?: number;
    closedShare?: number;
    eventTime?: number;
    maxSpeed?: number;
    maxAcceleration?: number;
    lockGive?: number;
    latchTurn?: number;
    autoCloseShare?: number;
    autoCloseTime?: number;
    closeDelay?: number;
    tipShare?: number;
    fallTime?: number;
    restitution?: number;
    breakDistance?: number;
    driveSpeed?: number;
}
export interface PartState {
    value: number;
    /** Told, not read. */
    velocity?: number;
    /** DragStatus bits; told, not read. */
    status?: number;
    pose: Pose;
    joint: Joint;
}
export interface DragOptions {
    partId: number;
    /** On the part as it is now; not needed with DragFlag.WITHOUT_POINT. */
    grabPoint?: VectorLike;
    startValue?: number;
    feel?: Feel;
    /** With rules (even {}), states have events. */
    rules?: Rules;
    /** DragFlag */
    flags?: number;
    limitGive?: number;
    /** What the last drag of this instance has ended with. */
    state?: PartState;
    scale?: VectorLike;
}
export interface Hand {
    /** HandKind */
    kind: number;
    ray?: Ray;
    point?: VectorLike;
    amount?: number;
    grabPoint?: VectorLike;
}
export interface DragInput {
    /** InputFlag */
    flags?: number;
    hand?: Hand;
    second?: Hand;
    handles?: ArrayLike<number>;
    lower?: number;
    upper?: number;
}
export interface DragState {
    /** Of the part from rest, object frame. */
    pose: Pose;
    grabPoint: Vector;
    value: number;
    target: number;
    velocity: number;
    atLimit: number;
    /** DragPhase */
    phase: number;
    changes: number;
    /** DragEvent bits; 0 without rules. */
    events: number;
    detents: number;
    impact: number;
    /** DragStatus bits; 0 without rules. */
    status: number;
    /** Probability that the joint in force is right, 0 to 1: the one number to show. */
    jointConfidence: number;
    /** JointBasis: where the joint in force comes from. */
    jointBasis: number;
}
export interface ReleaseOptions {
    /** Go */
    intent?: number;
    duration?: number;
    seed?: number;
    /** ReleaseFlag */
    flags?: number;
    awayFrom?: VectorLike;
}
export interface ReleasePlan {
    intent: number;
    startValue: number;
    endValue: number;
    duration: number;
    fromNetwork: number;
}
export interface Link {
    driver: number;
    driven: number;
    /** LinkKind */
    kind?: number;
    /** LinkFlag */
    flags?: number;
    ratio?: number;
    offset?: number;
    from?: number;
}
export interface Camera {
    fovY?: number;
    eye: VectorLike;
    forward: VectorLike;
    up: VectorLike;
    viewportWidth: number;
    viewportHeight: number;
    orthoHeight?: number;
}
export interface Hit {
    instance: number;
    object: PreparedObject;
    partId: number;
    triangle: number;
    distance: number;
    u: number;
    v: number;
    point: Vector;
    normal: Vector;
    /** DragOptions.grabPoint */
    objectPoint: Vector;
}

/** What a call answers that fails. */
export class DragmeshError extends Error {
    /** Such as 'DM_ERROR_EMPTY_MASK'. */
    readonly code: string;
    /** Result */
    readonly result: number;
}

/** Loads the module. wasm: its URL, bytes, Response or WebAssembly.Module; by default dragmesh.wasm beside dragmesh.js. */
export function load(options?: { wasm?: string | URL | ArrayBuffer | ArrayBufferView | Response | WebAssembly.Module }): Promise<Dragmesh>;

export interface Dragmesh {
    /** The module's exports, for hosts that call C themselves. */
    readonly exports: WebAssembly.Exports;
    createContext(options?: ContextOptions): Context;
    jointPose(joint: JointLike, value: number): Pose;
    jointValue(joint: JointLike, pose: Pose): { value: number; angleError: number; distanceError: number };
    jointValueAt(joint: JointLike, share: number): number;
    jointFrame(joint: JointLike): JointFrame;
    scaleJoint(joint: JointLike, scale: VectorLike): Joint;
    /** a after b. */
    multiplyPoses(a: Pose, b: Pose): Pose;
    /** 4 x 4, column-major: THREE.Matrix4.fromArray takes it. */
    poseToMatrix<T extends { [index: number]: number } = Float32Array>(pose: Pose, out?: T): T;
}

/** What is freed by destroy(), by `using`, or at last by the garbage collector. */
interface Destroyable {
    destroy(): void;
}

/** Owns everything that is made with it. */
export interface Context extends Destroyable {
    readonly memory: { bytes: number; peakBytes: number; allocations: number; pickBytes: number };
    loadModel(files: { kinematics?: ArrayBuffer | ArrayBufferView; motion?: ArrayBuffer | ArrayBufferView; ranker?: ArrayBuffer | ArrayBufferView }): Model;
    /** Fetches the three files of weights from a folder's URL. */
    fetchModel(folder: string | URL): Promise<Model>;
    /** 1 for each face that moves with the point, else 0. */
    findPart(mesh: Mesh, drag: { point: VectorLike; vector?: VectorLike }): Uint8Array;
    prepare(options: PrepareOptions): PreparedObject;
    /** Finds out which nodes of a whole asset move, which of them as one, and how. */
    rig(options: RigOptions): Asset;
    /** Reads what PreparedObject.save has made. */
    loadObject(data: Uint8Array | ArrayBuffer, model?: Model): PreparedObject;
    createScene(): Scene;
    cameraRay(camera: Camera, x: number, y: number): { origin: Vector; direction: Vector };
}
export interface Model extends Destroyable {}
/** A whole asset: which of its nodes move, how, and what carries them. */
export interface Asset extends Destroyable {
    readonly info: { nodeCount: number; partCount: number; movingCount: number; triangleCount: number; degraded: number; warnings: number };
    /** Those that stay included. */
    readonly parts: AssetPart[];
    /** How a part moves; of one that stays, how it would. */
    joint(index: number): Joint;
    /** The nodes of a part, rising. */
    partNodes(index: number): number[];
    /** The index of each node's part; null: the body. */
    readonly nodeParts: (number | null)[];
    /** A prepared object of the parts that move or are free: their ids are their indices + 1. */
    makeObject(): PreparedObject;
}
export interface PreparedObject extends Destroyable {
    readonly info: ObjectInfo;
    readonly parts: PartInfo[];
    /** The joint in force. */
    joint(partId: number): Joint;
    /** Best first; a drag ranks them anew. */
    hypotheses(partId: number, drag?: Hint): Joint[];
    refine(partId: number, drag: Hint): void;
    setJoint(partId: number, joint: JointLike): void;
    resetJoint(partId: number): void;
    setLinks(links: Link[]): void;
    /** Changes values; returns which parts are held. */
    followLinks(partId: number, values: number[] | Float32Array): boolean[];
    /** Bytes of a .dmo file. */
    save(): Uint8Array;
    beginDrag(options: DragOptions): Drag;
    generateMotion(options: { partId: number; drag: Hint; path?: VectorLike[]; seed?: number }): Motion;
}
export interface Drag extends Destroyable {
    readonly object: PreparedObject;
    /** What the last update has answered: the same object for the whole drag. */
    readonly state: DragState;
    /** What the drag would end with. */
    readonly partState: PartState;
    update(ray: Ray | null, dt: number): DragState;
    updateInput(input: DragInput, dt: number): DragState;
    override(value: number): DragState;
    /** updateInput, by its name in 0.2. */
    step(input: DragInput, dt: number): DragState;
    /** override, by its name in 0.2. */
    take(value: number): DragState;
    release(options?: ReleaseOptions): ReleasePlan;
    end(): PartState;
    save(): Uint8Array;
    restore(data: Uint8Array): void;
}
export interface Motion extends Destroyable {
    readonly frames: { pose: Pose; value: number }[];
    sample(t: number): { pose: Pose; value: number };
}
export interface Scene extends Destroyable {
    /** Number of the instance. */
    add(object: PreparedObject, placement?: Pose): number;
    move(instance: number, partId: number, pose: Pose): void;
    remove(instance: number): void;
    commit(): void;
    pick(ray: Ray): Hit | null;
}
