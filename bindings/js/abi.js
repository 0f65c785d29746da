// Written by bindings/js/describe.mjs from bindings/dragmesh_api.json: not to be edited.

// Hash of the description: b13a076611240442

export const VERSION = '0.4.0-dev';
export const VERSION_NUMBER = 16383;
export const MOTION_FRAMES = 16;
export const MAX_HYPOTHESES = 8;
export const MAX_PARTS = 4096;
export const MAX_ASSET_NODES = 65536;
export const MAX_LABEL = 4096;
export const MAX_ELEMENTS = 268435456;
export const MAX_LINKS = 256;
export const MAX_SNAPS = 16;
export const DRAG_SNAPSHOT_MAX = 65536;
export const ASSET_NO_NODE = 4294967295;
export const ASSET_NO_PART = 4294967295;

export const Result = Object.freeze({
    OK: 0,
    ERROR_INVALID_ARGUMENT: -1,
    ERROR_STRUCT_SIZE: -2,
    ERROR_STALE_HANDLE: -3,
    ERROR_OUT_OF_MEMORY: -4,
    ERROR_NOT_FINITE: -5,
    ERROR_INDEX_OUT_OF_RANGE: -6,
    ERROR_EMPTY_MASK: -7,
    ERROR_FULL_MASK: -8,
    ERROR_DEGENERATE_MESH: -9,
    ERROR_ZERO_DRAG: -10,
    ERROR_DRAG_OFF_PART: -11,
    ERROR_BAD_DATA: -12,
    ERROR_WRONG_MODEL: -13,
    ERROR_VERSION: -14,
    ERROR_CANCELLED: -15,
    ERROR_NO_MODEL: -16,
    ERROR_TOO_LARGE: -17,
    ERROR_BUFFER_TOO_SMALL: -18,
    ERROR_NOT_FOUND: -19,
    ERROR_UNSUPPORTED: -20,
    ERROR_INTERNAL: -21,
});

export const LogLevel = Object.freeze({
    ERROR: 0,
    WARNING: 1,
    INFO: 2,
});

export const Axes = Object.freeze({
    GLTF: 0,
    UNITY: 1,
    UNREAL: 2,
    BLENDER: 3,
    CUSTOM: 4,
});

export const Picking = Object.freeze({
    AUTO: 0,
    EMBREE: 1,
    PORTABLE: 2,
    NONE: 3,
});

export const JointType = Object.freeze({
    UNKNOWN: 0,
    REVOLUTE: 1,
    PRISMATIC: 2,
    SCREW: 3,
    CONTINUOUS: 4,
    FIXED: 5,
});

export const FloatFormat = Object.freeze({
    FLOAT32: 0,
    FLOAT64: 1,
});

export const IntegerFormat = Object.freeze({
    UINT32: 0,
    UINT16: 1,
    UINT8: 2,
    INT32: 3,
});

export const PartIdScope = Object.freeze({
    VERTEX: 0,
    FACE: 1,
});

export const PivotKind = Object.freeze({
    UNKNOWN: 0,
    DEFAULT: 1,
    SET: 2,
});

export const JointSource = Object.freeze({
    FROM_NETWORK: 0,
    FROM_GEOMETRY: 1,
    FROM_HOST: 2,
    CHOSEN: 3,
});

export const Limit = Object.freeze({
    LOWER: 1,
    UPPER: 2,
});

export const Choice = Object.freeze({
    KEEP: -1,
});

export const PrepareFlag = Object.freeze({
    WITHOUT_PICKING: 1,
    NETWORK_ALONE: 2,
    MESH_INCOMPLETE: 4,
});

export const Degraded = Object.freeze({
    NO_KINEMATICS: 1,
    NO_RANKER: 2,
    NO_MOTION: 4,
    NO_BODY: 8,
    HINT: 16,
    MESH: 32,
});

export const AssetNodeFlag = Object.freeze({
    FOLLOWS: 1,
    NO_PIVOT: 2,
});

export const ClipFlag = Object.freeze({
    NOT_RIGID: 1,
});

export const AssetFlag = Object.freeze({
    WITHOUT_CLIPS: 256,
    WITHOUT_NAMES: 512,
});

export const AssetWarning = Object.freeze({
    CLIP_LEFT_OUT: 1,
});

export const AssetState = Object.freeze({
    STAYS: 0,
    MOVES: 1,
    FREE: 2,
});

export const AssetBasis = Object.freeze({
    INFERRED: 0,
    FROM_FILE: 1,
    FROM_CLIP: 2,
});

export const DragFlag = Object.freeze({
    KEEP_JOINT: 1,
    WITHOUT_POINT: 2,
});

export const RuleFlag = Object.freeze({
    LOCKED: 1,
    LATCH: 2,
});

export const LinkKind = Object.freeze({
    MOVES: 0,
    FREES: 1,
    HOLDS: 2,
});

export const LinkFlag = Object.freeze({
    BOTH_WAYS: 1,
});

export const HandKind = Object.freeze({
    NONE: 0,
    RAY: 1,
    POINT: 2,
    RATE: 3,
    STEP: 4,
    VALUE: 5,
});

export const InputFlag = Object.freeze({
    LOCKED: 1,
    ASK: 2,
    BOUNDS: 4,
});

export const DragPhase = Object.freeze({
    HELD: 0,
    RELEASED: 1,
    AT_REST: 2,
});

export const DragEvent = Object.freeze({
    LIMIT_LOWER: 1,
    LIMIT_UPPER: 2,
    LEFT_REST: 4,
    REACHED_REST: 8,
    OPENED: 16,
    CLOSED: 32,
    DETENT: 64,
    JOINT: 128,
    BLOCKED: 256,
    FREED: 512,
    LATCHED: 1024,
    UNLATCHED: 2048,
    LOCKED: 4096,
    LET_GO: 8192,
});

export const DragStatus = Object.freeze({
    LATCHED: 1,
    LOCKED: 2,
    BLOCKED: 4,
    OPEN: 8,
});

export const JointBasis = Object.freeze({
    PREPARED: 0,
    PULL: 1,
    HOST: 2,
    CHOSEN: 3,
});

export const Go = Object.freeze({
    AUTO: 0,
    STAY: 1,
    OPEN: 2,
    CLOSE: 3,
    REPLAY: 4,
    FREEZE: 5,
    TOGGLE: 6,
});

export const Intent = Object.freeze({
    AUTO: 0,
    STAY: 1,
    OPEN: 2,
    CLOSE: 3,
    REPLAY: 4,
    FREEZE: 5,
    TOGGLE: 6,
});

export const ReleaseFlag = Object.freeze({
    BY_RULE: 1,
    AWAY_FROM: 2,
});

// Offset, kind and, of arrays, count of each field; sizes in bytes.
export const structs = {
    dm_vec3: { size: 12, fields: {
        x: [0, 'f32'],
        y: [4, 'f32'],
        z: [8, 'f32'],
    } },
    dm_pose: { size: 32, fields: {
        real: [0, 'f32', 4],
        dual: [16, 'f32', 4],
    } },
    dm_ray: { size: 24, fields: {
        origin: [0, 'dm_vec3'],
        direction: [12, 'dm_vec3'],
    } },
    dm_allocator: { size: 12, fields: {
        user: [0, 'u32'],
        allocate: [4, 'u32'],
        release: [8, 'u32'],
    } },
    dm_log: { size: 8, fields: {
        user: [0, 'u32'],
        message: [4, 'u32'],
    } },
    dm_jobs: { size: 8, fields: {
        user: [0, 'u32'],
        parallelFor: [4, 'u32'],
    } },
    dm_context_desc: { size: 104, fields: {
        structSize: [0, 'u32'],
        axes: [4, 'i32'],
        unitInMetres: [8, 'f32'],
        customAxes: [12, 'f32', 9],
        allocator: [48, 'dm_allocator'],
        log: [60, 'dm_log'],
        jobs: [68, 'dm_jobs'],
        picking: [76, 'i32'],
        reserved: [80, 'u32'],
        progress: [84, 'u32'],
        progressUser: [88, 'u32'],
        keptBytes: [96, 'u64'],
    } },
    dm_memory_info: { size: 48, fields: {
        structSize: [0, 'u32'],
        reserved: [4, 'u32'],
        bytes: [8, 'u64'],
        peakBytes: [16, 'u64'],
        allocations: [24, 'u64'],
        pickBytes: [32, 'u64'],
        keptBytes: [40, 'u64'],
    } },
    dm_model_desc: { size: 28, fields: {
        structSize: [0, 'u32'],
        kinematics: [4, 'u32'],
        kinematicsSize: [8, 'u32'],
        motion: [12, 'u32'],
        motionSize: [16, 'u32'],
        ranker: [20, 'u32'],
        rankerSize: [24, 'u32'],
    } },
    dm_mesh_desc: { size: 96, fields: {
        structSize: [0, 'u32'],
        positionStride: [4, 'u32'],
        positions: [8, 'u32'],
        vertexCount: [16, 'u64'],
        positionBytes: [24, 'u64'],
        indices: [32, 'u32'],
        indexCount: [40, 'u64'],
        indexBytes: [48, 'u64'],
        partIds: [56, 'u32'],
        partIdBytes: [64, 'u64'],
        partIdStride: [72, 'u32'],
        positionFormat: [76, 'i32'],
        indexFormat: [80, 'i32'],
        partIdFormat: [84, 'i32'],
        partIdScope: [88, 'i32'],
        reserved: [92, 'u32'],
    } },
    dm_drag_hint: { size: 24, fields: {
        point: [0, 'dm_vec3'],
        vector: [12, 'dm_vec3'],
    } },
    dm_pivot: { size: 48, fields: {
        origin: [0, 'dm_vec3'],
        axes: [12, 'f32', 9],
    } },
    dm_part_desc: { size: 36, fields: {
        structSize: [0, 'u32'],
        id: [4, 'u32'],
        parent: [8, 'u32'],
        jointType: [12, 'i32'],
        drag: [16, 'u32'],
        label: [20, 'u32'],
        pivot: [24, 'u32'],
        pivotKind: [28, 'i32'],
        reserved: [32, 'u32'],
    } },
    dm_joint: { size: 76, fields: {
        structSize: [0, 'u32'],
        type: [4, 'i32'],
        typeConfidence: [8, 'f32'],
        jointConfidence: [12, 'f32'],
        pitch: [16, 'f32'],
        axis: [20, 'dm_vec3'],
        origin: [32, 'dm_vec3'],
        lower: [44, 'f32'],
        upper: [48, 'f32'],
        source: [52, 'i32'],
        evidence: [56, 'u32', 4],
        closed: [72, 'f32'],
    } },
    dm_joint_frame: { size: 88, fields: {
        structSize: [0, 'u32'],
        type: [4, 'i32'],
        origin: [8, 'dm_vec3'],
        x: [20, 'dm_vec3'],
        y: [32, 'dm_vec3'],
        z: [44, 'dm_vec3'],
        rotation: [56, 'f32', 4],
        lower: [72, 'f32'],
        upper: [76, 'f32'],
        limits: [80, 'u32'],
        pitch: [84, 'f32'],
    } },
    dm_part_state: { size: 124, fields: {
        structSize: [0, 'u32'],
        value: [4, 'f32'],
        velocity: [8, 'f32'],
        status: [12, 'u32'],
        pose: [16, 'dm_pose'],
        joint: [48, 'dm_joint'],
    } },
    dm_part_info: { size: 56, fields: {
        structSize: [0, 'u32'],
        id: [4, 'u32'],
        parent: [8, 'u32'],
        triangleCount: [12, 'u32'],
        boxMin: [16, 'dm_vec3'],
        boxMax: [28, 'dm_vec3'],
        centre: [40, 'dm_vec3'],
        area: [52, 'f32'],
    } },
    dm_joint_end: { size: 72, fields: {
        value: [0, 'f32'],
        pose: [4, 'dm_pose'],
        boxMin: [36, 'dm_vec3'],
        boxMax: [48, 'dm_vec3'],
        centre: [60, 'dm_vec3'],
    } },
    dm_hypothesis: { size: 156, fields: {
        structSize: [0, 'u32'],
        reserved: [4, 'u32'],
        joint: [8, 'u32'],
        ends: [12, 'dm_joint_end', 2],
    } },
    dm_choice: { size: 16, fields: {
        structSize: [0, 'u32'],
        count: [4, 'u32'],
        part: [8, 'u32'],
        hypotheses: [12, 'u32'],
    } },
    dm_object_desc: { size: 80, fields: {
        structSize: [0, 'u32'],
        flags: [4, 'u32'],
        mesh: [8, 'u32'],
        parts: [12, 'u32'],
        partCount: [16, 'u32'],
        reserved: [20, 'u32'],
        model: [24, 'u64'],
        seed: [32, 'u64'],
        intent: [40, 'u32'],
        intentUser: [44, 'u32'],
        progress: [48, 'u32'],
        progressUser: [52, 'u32'],
        label: [56, 'u32'],
        up: [60, 'dm_vec3'],
        choose: [72, 'u32'],
        chooseUser: [76, 'u32'],
    } },
    dm_object_info: { size: 64, fields: {
        structSize: [0, 'u32'],
        partCount: [4, 'u32'],
        vertexCount: [8, 'u64'],
        triangleCount: [16, 'u64'],
        boxMin: [24, 'dm_vec3'],
        boxMax: [36, 'dm_vec3'],
        size: [48, 'f32'],
        pickable: [52, 'u32'],
        degraded: [56, 'u32'],
        picking: [60, 'i32'],
    } },
    dm_asset_clip: { size: 20, fields: {
        name: [0, 'u32'],
        times: [4, 'u32'],
        poses: [8, 'u32'],
        keyCount: [12, 'u32'],
        flags: [16, 'u32'],
    } },
    dm_asset_node: { size: 52, fields: {
        structSize: [0, 'u32'],
        flags: [4, 'u32'],
        parent: [8, 'u32'],
        follows: [12, 'u32'],
        name: [16, 'u32'],
        meshName: [20, 'u32'],
        mesh: [24, 'u32'],
        transform: [28, 'u32'],
        pivot: [32, 'u32'],
        clips: [36, 'u32'],
        clipCount: [40, 'u32'],
        reserved: [44, 'u32'],
        joint: [48, 'u32'],
    } },
    dm_asset_desc: { size: 64, fields: {
        structSize: [0, 'u32'],
        flags: [4, 'u32'],
        nodes: [8, 'u32'],
        label: [12, 'u32'],
        nodeCount: [16, 'u32'],
        minMoves: [20, 'f32'],
        model: [24, 'u64'],
        seed: [32, 'u64'],
        progress: [40, 'u32'],
        progressUser: [44, 'u32'],
        up: [48, 'dm_vec3'],
        reserved: [60, 'u32'],
    } },
    dm_asset_info: { size: 32, fields: {
        structSize: [0, 'u32'],
        nodeCount: [4, 'u32'],
        partCount: [8, 'u32'],
        movingCount: [12, 'u32'],
        triangleCount: [16, 'u64'],
        degraded: [24, 'u32'],
        warnings: [28, 'u32'],
    } },
    dm_asset_part: { size: 64, fields: {
        structSize: [0, 'u32'],
        parent: [4, 'u32'],
        partId: [8, 'u32'],
        state: [12, 'i32'],
        basis: [16, 'i32'],
        moves: [20, 'f32'],
        nodeCount: [24, 'u32'],
        triangleCount: [28, 'u32'],
        duration: [32, 'f32'],
        reserved: [36, 'u32'],
        boxMin: [40, 'dm_vec3'],
        boxMax: [52, 'dm_vec3'],
    } },
    dm_motion_desc: { size: 44, fields: {
        structSize: [0, 'u32'],
        partId: [4, 'u32'],
        drag: [8, 'dm_drag_hint'],
        path: [32, 'u32'],
        pathCount: [36, 'u32'],
        seed: [40, 'u32'],
    } },
    dm_drag_feel: { size: 24, fields: {
        smoothingTime: [0, 'f32'],
        softLimit: [4, 'f32'],
        coastTime: [8, 'f32'],
        detent: [12, 'f32'],
        detentPull: [16, 'f32'],
        returnTime: [20, 'f32'],
    } },
    dm_drag_rules: { size: 84, fields: {
        structSize: [0, 'u32'],
        flags: [4, 'u32'],
        snaps: [8, 'u32'],
        snapCount: [12, 'u32'],
        snapReach: [16, 'f32'],
        openShare: [20, 'f32'],
        closedShare: [24, 'f32'],
        eventTime: [28, 'f32'],
        maxSpeed: [32, 'f32'],
        maxAcceleration: [36, 'f32'],
        lockGive: [40, 'f32'],
        latchTurn: [44, 'f32'],
        autoCloseShare: [48, 'f32'],
        autoCloseTime: [52, 'f32'],
        closeDelay: [56, 'f32'],
        tipShare: [60, 'f32'],
        fallTime: [64, 'f32'],
        restitution: [68, 'f32'],
        breakDistance: [72, 'f32'],
        driveSpeed: [76, 'f32'],
        reserved: [80, 'u32'],
    } },
    dm_link: { size: 28, fields: {
        driver: [0, 'u32'],
        driven: [4, 'u32'],
        kind: [8, 'i32'],
        flags: [12, 'u32'],
        ratio: [16, 'f32'],
        offset: [20, 'f32'],
        from: [24, 'f32'],
    } },
    dm_drag_desc: { size: 88, fields: {
        structSize: [0, 'u32'],
        partId: [4, 'u32'],
        object: [8, 'u64'],
        grabPoint: [16, 'dm_vec3'],
        startValue: [28, 'f32'],
        feel: [32, 'dm_drag_feel'],
        flags: [56, 'u32'],
        limitGive: [60, 'f32'],
        state: [64, 'u32'],
        scale: [68, 'dm_vec3'],
        reserved: [80, 'u32'],
        rules: [84, 'u32'],
    } },
    dm_hand: { size: 56, fields: {
        kind: [0, 'i32'],
        ray: [4, 'dm_ray'],
        point: [28, 'dm_vec3'],
        amount: [40, 'f32'],
        grabPoint: [44, 'dm_vec3'],
    } },
    dm_drag_input: { size: 136, fields: {
        structSize: [0, 'u32'],
        flags: [4, 'u32'],
        hand: [8, 'dm_hand'],
        second: [64, 'dm_hand'],
        handles: [120, 'f32', 2],
        lower: [128, 'f32'],
        upper: [132, 'f32'],
    } },
    dm_drag_state: { size: 100, fields: {
        structSize: [0, 'u32'],
        pose: [4, 'dm_pose'],
        grabPoint: [36, 'dm_vec3'],
        value: [48, 'f32'],
        target: [52, 'f32'],
        velocity: [56, 'f32'],
        atLimit: [60, 'i32'],
        phase: [64, 'i32'],
        changes: [68, 'u32'],
        events: [72, 'u32'],
        detents: [76, 'u32'],
        impact: [80, 'f32'],
        status: [84, 'u32'],
        jointConfidence: [88, 'f32'],
        jointBasis: [92, 'i32'],
        openShare: [96, 'f32'],
    } },
    dm_release_desc: { size: 32, fields: {
        structSize: [0, 'u32'],
        intent: [4, 'i32'],
        duration: [8, 'f32'],
        seed: [12, 'u32'],
        flags: [16, 'u32'],
        awayFrom: [20, 'dm_vec3'],
    } },
    dm_release_plan: { size: 24, fields: {
        structSize: [0, 'u32'],
        intent: [4, 'i32'],
        startValue: [8, 'f32'],
        endValue: [12, 'f32'],
        duration: [16, 'f32'],
        fromNetwork: [20, 'u32'],
    } },
    dm_camera: { size: 56, fields: {
        structSize: [0, 'u32'],
        fovY: [4, 'f32'],
        eye: [8, 'dm_vec3'],
        forward: [20, 'dm_vec3'],
        up: [32, 'dm_vec3'],
        viewportWidth: [44, 'f32'],
        viewportHeight: [48, 'f32'],
        orthoHeight: [52, 'f32'],
    } },
    dm_scene_desc: { size: 8, fields: {
        structSize: [0, 'u32'],
        reserved: [4, 'u32'],
    } },
    dm_hit: { size: 72, fields: {
        structSize: [0, 'u32'],
        instance: [4, 'u32'],
        object: [8, 'u64'],
        partId: [16, 'u32'],
        triangle: [20, 'u32'],
        distance: [24, 'f32'],
        u: [28, 'f32'],
        v: [32, 'f32'],
        point: [36, 'dm_vec3'],
        normal: [48, 'dm_vec3'],
        objectPoint: [60, 'dm_vec3'],
    } },
};

// Parameters and result of each function.
export const functions = {
    dm_result_string: 'i32 -> u32',
    dm_version: ' -> u32',
    dm_get_interface: 'u32 -> u32',
    dm_context_create: 'u32 u32 -> i32',
    dm_context_destroy: 'u32 -> void',
    dm_context_get_memory: 'u32 u32 -> i32',
    dm_context_trim: 'u32 -> i32',
    dm_model_load: 'u32 u32 u32 -> i32',
    dm_model_unload: 'u32 u64 -> i32',
    dm_mesh_find_part: 'u32 u32 u32 u32 u64 -> i32',
    dm_object_prepare: 'u32 u32 u32 -> i32',
    dm_object_save: 'u32 u64 u32 u32 u32 -> i32',
    dm_object_load: 'u32 u32 u32 u64 u32 -> i32',
    dm_object_destroy: 'u32 u64 -> i32',
    dm_object_get_info: 'u32 u64 u32 -> i32',
    dm_object_get_part: 'u32 u64 u32 u32 -> i32',
    dm_object_get_joint: 'u32 u64 u32 u32 -> i32',
    dm_object_get_hypotheses: 'u32 u64 u32 u32 u32 u32 u32 -> i32',
    dm_object_refine: 'u32 u64 u32 u32 -> i32',
    dm_object_set_joint: 'u32 u64 u32 u32 -> i32',
    dm_object_reset_joint: 'u32 u64 u32 -> i32',
    dm_object_set_links: 'u32 u64 u32 u32 -> i32',
    dm_object_follow_links: 'u32 u64 u32 u32 u32 u32 -> i32',
    dm_asset_create: 'u32 u32 u32 -> i32',
    dm_asset_destroy: 'u32 u64 -> i32',
    dm_asset_get_info: 'u32 u64 u32 -> i32',
    dm_asset_get_part: 'u32 u64 u32 u32 -> i32',
    dm_asset_get_joint: 'u32 u64 u32 u32 -> i32',
    dm_asset_get_part_nodes: 'u32 u64 u32 u32 u32 -> i32',
    dm_asset_get_node_parts: 'u32 u64 u32 u32 -> i32',
    dm_asset_make_object: 'u32 u64 u32 -> i32',
    dm_joint_pose: 'u32 f32 u32 -> i32',
    dm_joint_value: 'u32 u32 u32 u32 u32 -> i32',
    dm_joint_value_at: 'u32 f32 u32 -> i32',
    dm_joint_get_frame: 'u32 u32 -> i32',
    dm_joint_scale: 'u32 dm_vec3 u32 -> i32',
    dm_motion_generate: 'u32 u64 u32 u32 -> i32',
    dm_motion_sample: 'u32 u64 f32 u32 u32 -> i32',
    dm_motion_get_frames: 'u32 u64 u32 u32 -> i32',
    dm_motion_destroy: 'u32 u64 -> i32',
    dm_drag_begin: 'u32 u32 u32 -> i32',
    dm_drag_update: 'u32 u64 u32 f32 u32 -> i32',
    dm_drag_step: 'u32 u64 u32 f32 u32 -> i32',
    dm_drag_take: 'u32 u64 f32 u32 -> i32',
    dm_drag_release: 'u32 u64 u32 u32 -> i32',
    dm_drag_end: 'u32 u64 u32 -> i32',
    dm_drag_get_part_state: 'u32 u64 u32 -> i32',
    dm_drag_snapshot_size: ' -> u32',
    dm_drag_save: 'u32 u64 u32 u32 -> i32',
    dm_drag_restore: 'u32 u64 u32 u32 -> i32',
    dm_pose_multiply: 'u32 u32 u32 -> void',
    dm_pose_inverse: 'u32 u32 -> void',
    dm_pose_from_rotation: 'f32 dm_vec3 u32 -> i32',
    dm_pose_to_matrix: 'u32 f32 -> void',
    dm_pose_apply_points: 'u32 u32 u32 u32 u32 u32 -> void',
    dm_camera_ray: 'u32 u32 f32 f32 u32 -> i32',
    dm_scene_create: 'u32 u32 u32 -> i32',
    dm_scene_destroy: 'u32 u64 -> i32',
    dm_scene_add: 'u32 u64 u64 u32 u32 -> i32',
    dm_scene_move: 'u32 u64 u32 u32 u32 -> i32',
    dm_scene_remove: 'u32 u64 u32 -> i32',
    dm_scene_commit: 'u32 u64 -> i32',
    dm_scene_pick: 'u32 u64 u32 u32 -> i32',
};
