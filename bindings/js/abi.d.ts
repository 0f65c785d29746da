// Written by bindings/js/describe.mjs from bindings/dragmesh_api.json: not to be edited.

export const VERSION: string;
export const VERSION_NUMBER: number;
/** Number of key poses of a generated motion (paper: T). */
export const MOTION_FRAMES: 16;
/** Most hypotheses kept for one part. */
export const MAX_HYPOTHESES: 8;
/** Most parts of one object, without the body. */
export const MAX_PARTS: 4096;
/** Most nodes of one asset. At most DM_MAX_PARTS of them may have a mesh and not the flag DM_ASSET_NODE_FOLLOWS. */
export const MAX_ASSET_NODES: 65536;
/** Most bytes of a label, without the terminating zero. */
export const MAX_LABEL: 4096;
/** Most vertices or triangles of one object. */
export const MAX_ELEMENTS: 268435456;
/** Most links of one object. */
export const MAX_LINKS: 256;
/** Most snap values of one drag. */
export const MAX_SNAPS: 16;
/** Most bytes of a dm_drag_save in any library of the interface dm.core/1. dm_drag_snapshot_size returns how many this one writes. */
export const DRAG_SNAPSHOT_MAX: 65536;
/** no node: the scene itself */
export const ASSET_NO_NODE: 4294967295;
/** no part: the body that stays */
export const ASSET_NO_PART: 4294967295;

export const Result: {
    readonly OK: 0;
    /** a null pointer, an unknown enum value, a count that makes no sense */
    readonly ERROR_INVALID_ARGUMENT: -1;
    /** struct_size is too small, or a field is set that this library does not know */
    readonly ERROR_STRUCT_SIZE: -2;
    /** null, destroyed, or of another kind or context */
    readonly ERROR_STALE_HANDLE: -3;
    /** the host's allocator returned NULL */
    readonly ERROR_OUT_OF_MEMORY: -4;
    /** a NaN or infinite number in the input */
    readonly ERROR_NOT_FINITE: -5;
    /** an index names a vertex or a hypothesis that does not exist */
    readonly ERROR_INDEX_OUT_OF_RANGE: -6;
    /** no triangle belongs to the part */
    readonly ERROR_EMPTY_MASK: -7;
    /** the mask, or the part found, is the whole mesh, so nothing stays */
    readonly ERROR_FULL_MASK: -8;
    /** no triangle with an area, or all vertices in one point */
    readonly ERROR_DEGENERATE_MESH: -9;
    /** the drag vector has no length */
    readonly ERROR_ZERO_DRAG: -10;
    /** the drag point is farther from the part than half the object's size */
    readonly ERROR_DRAG_OFF_PART: -11;
    /** truncated, corrupt or hostile bytes */
    readonly ERROR_BAD_DATA: -12;
    /** readable weights, but not of the architecture asked for */
    readonly ERROR_WRONG_MODEL: -13;
    /** made by a newer version than this library can read */
    readonly ERROR_VERSION: -14;
    /** the progress callback asked to stop */
    readonly ERROR_CANCELLED: -15;
    /** the call needs weights and none were given */
    readonly ERROR_NO_MODEL: -16;
    /** more than DM_MAX_ELEMENTS or DM_MAX_PARTS */
    readonly ERROR_TOO_LARGE: -17;
    /** the output buffer cannot hold the answer; the size needed is set */
    readonly ERROR_BUFFER_TOO_SMALL: -18;
    /** no such part, node or instance */
    readonly ERROR_NOT_FOUND: -19;
    /** valid, but this build or this kind of file cannot do it */
    readonly ERROR_UNSUPPORTED: -20;
    /** a bug of ours; please report it */
    readonly ERROR_INTERNAL: -21;
};

export const LogLevel: {
    readonly ERROR: 0;
    readonly WARNING: 1;
    readonly INFO: 2;
};

/** The host's axes. The library's own frame is glTF's: right-handed, +Y up, metres. */
export const Axes: {
    /** right-handed, +Y up (glTF, Godot, OpenGL) */
    readonly GLTF: 0;
    /** left-handed, +Y up, +Z forward */
    readonly UNITY: 1;
    /** left-handed, +Z up, +X forward */
    readonly UNREAL: 2;
    /** right-handed, +Z up (Blender, ROS, most CAD) */
    readonly BLENDER: 3;
    /** those of dm_context_desc.custom_axes */
    readonly CUSTOM: 4;
};

/** What picks rays. All choices give the same hits, except within float rounding of an edge or of another surface. */
export const Picking: {
    /** Embree 3.13 or 4 where its shared library is found, else the library's own code */
    readonly AUTO: 0;
    /** Embree; the context is refused where it is missing */
    readonly EMBREE: 1;
    /** the library's own code, which runs everywhere, in the host's memory */
    readonly PORTABLE: 2;
    /** nothing, for hosts that cast their own rays: objects keep no trees, and there are no scenes */
    readonly NONE: 3;
};

export const JointType: {
    readonly UNKNOWN: 0;
    /** turns about a line between two limits, rad */
    readonly REVOLUTE: 1;
    /** slides along a direction, host units */
    readonly PRISMATIC: 2;
    /** turns and advances `pitch` host units a radian */
    readonly SCREW: 3;
    /** turns without limits */
    readonly CONTINUOUS: 4;
    readonly FIXED: 5;
};

/** formats of positions, three numbers each */
export const FloatFormat: {
    /** formats of positions, three numbers each */
    readonly FLOAT32: 0;
    /** formats of positions, three numbers each */
    readonly FLOAT64: 1;
};

/** formats of indices and part ids */
export const IntegerFormat: {
    /** formats of indices and part ids */
    readonly UINT32: 0;
    /** formats of indices and part ids */
    readonly UINT16: 1;
    /** formats of indices and part ids */
    readonly UINT8: 2;
    /** formats of indices and part ids */
    readonly INT32: 3;
};

export const PartIdScope: {
    readonly VERTEX: 0;
    readonly FACE: 1;
};

/** How a pivot came to lie where it is. dm_gltf_get_pivot_kind returns it for a glTF file. */
export const PivotKind: {
    /** not known: the library compares it with those of the other parts */
    readonly UNKNOWN: 0;
    /** a program puts all of them there, so it says nothing */
    readonly DEFAULT: 1;
    /** The other nodes' pivots follow a rule and this one does not, so somebody has set it. It counts for more. */
    readonly SET: 2;
};

export const JointSource: {
    readonly FROM_NETWORK: 0;
    readonly FROM_GEOMETRY: 1;
    /** the host's own: certain, limits too, and no pull changes it */
    readonly FROM_HOST: 2;
    /** The host has chosen it with dm_object_desc.choose. No pull replaces it, or moves its range to the other side of rest. Its limits are estimates, and give. */
    readonly CHOSEN: 3;
};

export const Limit: {
    readonly LOWER: 1;
    readonly UPPER: 2;
};

export const Choice: {
    readonly KEEP: -1;
};

export const PrepareFlag: {
    /** The object keeps no triangles. It is small, and cannot be added to a scene. */
    readonly WITHOUT_PICKING: 1;
    /** KPP-Net alone infers the joints, without geometric candidates and ranker, for comparisons. The call answers NO_MODEL when `model` has no kinematics weights. */
    readonly NETWORK_ALONE: 2;
    /** The reader of the mesh has left out something of its file (dm_gltf_left_out). The object keeps it as DM_DEGRADED_MESH. */
    readonly MESH_INCOMPLETE: 4;
};

/** Why the answers about an object are worse than they could be, as bits of dm_object_info.degraded. The call that makes the object says the same in one warning. A saved object keeps the bits, except DM_DEGRADED_NO_MOTION, which depends on the model that it is loaded with. */
export const Degraded: {
    /** no weights of KPP-Net: geometry alone finds the joints */
    readonly NO_KINEMATICS: 1;
    /** no weights of the ranker: rules choose the joints, and set limits */
    readonly NO_RANKER: 2;
    /** no weights of the DQ-VAE: a rule paces releases, and motions answer NO_MODEL */
    readonly NO_MOTION: 4;
    /** the mesh has no body, whose contacts would show the joints */
    readonly NO_BODY: 8;
    /** a pivot was ignored, because it is 1,000 object sizes away or more */
    readonly HINT: 16;
    /** DM_PREPARE_MESH_INCOMPLETE */
    readonly MESH: 32;
};

export const AssetNodeFlag: {
    /** The node is neither part nor body: a level of detail, a collider, something hidden. It goes where `follows` goes, and its mesh is not read. */
    readonly FOLLOWS: 1;
    /** the place of its origin says nothing */
    readonly NO_PIVOT: 2;
};

/** the animation also scales or bends the node */
export const ClipFlag: {
    /** the animation also scales or bends the node */
    readonly NOT_RIGID: 1;
};

export const AssetFlag: {
    /** clips are ignored */
    readonly WITHOUT_CLIPS: 256;
    /** names and labels are ignored */
    readonly WITHOUT_NAMES: 512;
};

/** What was ignored, as bits of dm_asset_info.warnings. */
export const AssetWarning: {
    /** a clip is not rigid, or no joint moves a node as it does */
    readonly CLIP_LEFT_OUT: 1;
};

/** Whether a part moves. */
export const AssetState: {
    /** It may move, but probably does not: `moves` is below dm_asset_desc.min_moves. A body that almost certainly stays is not listed as a part. */
    readonly STAYS: 0;
    /** it moves by its joint */
    readonly MOVES: 1;
    /** Only its weight holds it, as the lid of a teapot, so a player can take it away. Its joint is the slide by which it comes off, with a low confidence. */
    readonly FREE: 2;
};

/** Where a part's joint comes from. */
export const AssetBasis: {
    /** inferred from shape, contacts and names */
    readonly INFERRED: 0;
    /** stated in dm_asset_node.joint */
    readonly FROM_FILE: 1;
    /** read from dm_asset_node.clips */
    readonly FROM_CLIP: 2;
};

export const DragFlag: {
    /** The drag follows the joint in force with its limits, whatever the pull says, as it follows a host's joint. */
    readonly KEEP_JOINT: 1;
    /** No point is grabbed, for hands of DM_HAND_RATE, STEP and VALUE, and for releases. grab_point is ignored, and the middle of the part's box takes its place. */
    readonly WITHOUT_POINT: 2;
};

export const RuleFlag: {
    /** The part stays where it is, gives a little, and reports a try as DM_EVENT_LOCKED. */
    readonly LOCKED: 1;
    /** A latch holds the part at rest until a handle has turned (dm_drag_input.handles), and catches it again when it comes to rest with the handle let go. */
    readonly LATCH: 2;
};

/** What a link does to its driven part. */
export const LinkKind: {
    /** The driven part's value is offset + ratio * (the driver's value beyond `from`), inside its limits. */
    readonly MOVES: 0;
    /** the driven part is held until the driver has reached `from`: a handle */
    readonly FREES: 1;
    /** the driven part is held once the driver has reached `from`: one drawer at a time */
    readonly HOLDS: 2;
};

/** the driven part of a DM_LINK_MOVES also moves the driver */
export const LinkFlag: {
    /** the driven part of a DM_LINK_MOVES also moves the driver */
    readonly BOTH_WAYS: 1;
};

/** How a hand holds the part. */
export const HandKind: {
    /** no input in this update: the part moves on to its last target */
    readonly NONE: 0;
    /** a pointer, with `ray` */
    readonly RAY: 1;
    /** A hand in space, with `point`. The vector from it to the grabbed point stays as it was in its first update. */
    readonly POINT: 2;
    /** a stick or a key held down, with `amount` from -1 to 1 times dm_drag_rules.drive_speed */
    readonly RATE: 3;
    /** a wheel, which moves the part by `amount`, a share of the range */
    readonly STEP: 4;
    /** a slider of the host, which moves the part to the joint value `amount` */
    readonly VALUE: 5;
};

export const InputFlag: {
    /** the part is locked in this update, as by DM_RULE_LOCKED */
    readonly LOCKED: 1;
    /** dm_drag_override may change the value after this update */
    readonly ASK: 2;
    /** lower and upper hold even when they are equal */
    readonly BOUNDS: 4;
};

export const DragPhase: {
    /** the part follows the pointer */
    readonly HELD: 0;
    /** the part moves by itself after dm_drag_release */
    readonly RELEASED: 1;
    /** the part has come to where it goes */
    readonly AT_REST: 2;
};

/** What has happened to the part since the update before, as bits of dm_drag_state.events. */
export const DragEvent: {
    /** It has met its lower limit (within 0.5 % of the range), with the speed dm_drag_state.impact. The event comes again after the part was 2 % away. An estimated limit that has given does not count. */
    readonly LIMIT_LOWER: 1;
    /** the same for the upper limit */
    readonly LIMIT_UPPER: 2;
    /** it is more than 2 % of the range away from rest */
    readonly LEFT_REST: 4;
    /** it is within 0.5 % of the range of rest, having left it */
    readonly REACHED_REST: 8;
    /** it has opened beyond dm_drag_rules.open_share */
    readonly OPENED: 16;
    /** it has closed to within dm_drag_rules.closed_share */
    readonly CLOSED: 32;
    /** it has passed to another detent or snap value, see dm_drag_state.detents */
    readonly DETENT: 64;
    /** the pull has changed the joint, see dm_drag_state.changes */
    readonly JOINT: 128;
    /** the bounds of dm_drag_input hold it */
    readonly BLOCKED: 256;
    /** these bounds no longer hold it */
    readonly FREED: 512;
    /** the latch has caught it */
    readonly LATCHED: 1024;
    /** the handle has opened the latch */
    readonly UNLATCHED: 2048;
    /** it was tried while locked or latched; the event comes again after the hand has let up */
    readonly LOCKED: 4096;
    /** it was let go of at dm_drag_rules.break_distance */
    readonly LET_GO: 8192;
};

/** What holds a part with dm_drag_rules, and whether it counts as open, after an update or when its drag begins, as bits of dm_drag_state.status. */
export const DragStatus: {
    /** the latch holds it */
    readonly LATCHED: 1;
    /** DM_RULE_LOCKED or DM_INPUT_LOCKED holds it */
    readonly LOCKED: 2;
    /** the bounds of dm_drag_input hold it, from DM_EVENT_BLOCKED to DM_EVENT_FREED */
    readonly BLOCKED: 4;
    /** it counts as open, from DM_EVENT_OPENED to DM_EVENT_CLOSED */
    readonly OPEN: 8;
};

/** Where the joint that a drag follows comes from. */
export const JointBasis: {
    /** dm_object_prepare found it, and no pull has changed it */
    readonly PREPARED: 0;
    /** a pull of this drag, or of an earlier one of the same dm_part_state, has changed it */
    readonly PULL: 1;
    /** it is the host's own */
    readonly HOST: 2;
    /** the host has chosen it among the hypotheses */
    readonly CHOSEN: 3;
};

/** What a released part does next. */
export const Go: {
    /** the library decides what the player meant, by where the part is and how fast it goes */
    readonly AUTO: 0;
    /** it glides to a stop; this also stops a part that moves by itself */
    readonly STAY: 1;
    /** it goes to the end of the joint that lies the way it was pulled */
    readonly OPEN: 2;
    /** it goes to where it is closed (dm_joint.closed), which is rest unless it rests open */
    readonly CLOSE: 3;
    /** it repeats what it did after the last release */
    readonly REPLAY: 4;
    /** it stops at once */
    readonly FREEZE: 5;
    /** it opens when it is nearer to where it is closed than to its open end, else it closes */
    readonly TOGGLE: 6;
};

/** The same values, by their names of version 0.2. */
export const Intent: {
    readonly AUTO: 0;
    readonly STAY: 1;
    readonly OPEN: 2;
    readonly CLOSE: 3;
    readonly REPLAY: 4;
    readonly FREEZE: 5;
    readonly TOGGLE: 6;
};

export const ReleaseFlag: {
    /** A rule paces the release instead of the DQ-VAE, whose last bits differ between instruction sets. */
    readonly BY_RULE: 1;
    /** a part that opens to both sides of rest opens away from `away_from` */
    readonly AWAY_FROM: 2;
};
