using System;
using K = DragMesh.Constants;

namespace DragMesh
{
    /// <summary>Why a call failed: DragMeshException.Code.</summary>
    public enum Result
    {
        Ok = K.DM_OK,
        InvalidArgument = K.DM_ERROR_INVALID_ARGUMENT,
        StructSize = K.DM_ERROR_STRUCT_SIZE,
        StaleHandle = K.DM_ERROR_STALE_HANDLE,
        OutOfMemory = K.DM_ERROR_OUT_OF_MEMORY,
        NotFinite = K.DM_ERROR_NOT_FINITE,
        IndexOutOfRange = K.DM_ERROR_INDEX_OUT_OF_RANGE,
        EmptyMask = K.DM_ERROR_EMPTY_MASK,
        FullMask = K.DM_ERROR_FULL_MASK,
        DegenerateMesh = K.DM_ERROR_DEGENERATE_MESH,
        ZeroDrag = K.DM_ERROR_ZERO_DRAG,
        DragOffPart = K.DM_ERROR_DRAG_OFF_PART,
        BadData = K.DM_ERROR_BAD_DATA,
        WrongModel = K.DM_ERROR_WRONG_MODEL,
        Version = K.DM_ERROR_VERSION,
        Cancelled = K.DM_ERROR_CANCELLED,
        NoModel = K.DM_ERROR_NO_MODEL,
        TooLarge = K.DM_ERROR_TOO_LARGE,
        BufferTooSmall = K.DM_ERROR_BUFFER_TOO_SMALL,
        NotFound = K.DM_ERROR_NOT_FOUND,
        Unsupported = K.DM_ERROR_UNSUPPORTED,
        Internal = K.DM_ERROR_INTERNAL
    }

    /// <summary>The host's axes.</summary>
    public enum Axes
    {
        Gltf = K.DM_AXES_GLTF,
        Unity = K.DM_AXES_UNITY,
        Unreal = K.DM_AXES_UNREAL,
        Blender = K.DM_AXES_BLENDER
    }

    /// <summary>What picks rays.</summary>
    public enum Picking
    {
        Auto = K.DM_PICK_AUTO,
        Embree = K.DM_PICK_EMBREE,
        Portable = K.DM_PICK_PORTABLE,
        None = K.DM_PICK_NONE
    }

    public enum LogLevel
    {
        Error = K.DM_LOG_ERROR,
        Warning = K.DM_LOG_WARNING,
        Info = K.DM_LOG_INFO
    }

    /// <summary>How a part moves: Joint.Type.</summary>
    public enum JointType
    {
        Unknown = K.DM_JOINT_UNKNOWN,
        Revolute = K.DM_JOINT_REVOLUTE,
        Prismatic = K.DM_JOINT_PRISMATIC,
        Screw = K.DM_JOINT_SCREW,
        Continuous = K.DM_JOINT_CONTINUOUS,
        Fixed = K.DM_JOINT_FIXED
    }

    /// <summary>Who says so: Joint.Source.</summary>
    public enum JointSource
    {
        Network = K.DM_JOINT_FROM_NETWORK,
        Geometry = K.DM_JOINT_FROM_GEOMETRY,
        Host = K.DM_JOINT_FROM_HOST,
        Chosen = K.DM_JOINT_CHOSEN
    }

    /// <summary>What a drag does: DragState.Phase.</summary>
    public enum DragPhase
    {
        Held = K.DM_DRAG_HELD,
        Released = K.DM_DRAG_RELEASED,
        AtRest = K.DM_DRAG_AT_REST
    }

    /// <summary>What has happened in an update: DragState.Events.</summary>
    [Flags]
    public enum DragEvents : uint
    {
        None = 0,
        LimitLower = K.DM_EVENT_LIMIT_LOWER,
        LimitUpper = K.DM_EVENT_LIMIT_UPPER,
        LeftRest = K.DM_EVENT_LEFT_REST,
        ReachedRest = K.DM_EVENT_REACHED_REST,
        Opened = K.DM_EVENT_OPENED,
        Closed = K.DM_EVENT_CLOSED,
        Detent = K.DM_EVENT_DETENT,
        Joint = K.DM_EVENT_JOINT,
        Blocked = K.DM_EVENT_BLOCKED,
        Freed = K.DM_EVENT_FREED,
        Latched = K.DM_EVENT_LATCHED,
        Unlatched = K.DM_EVENT_UNLATCHED,
        Locked = K.DM_EVENT_LOCKED,
        LetGo = K.DM_EVENT_LET_GO
    }

    /// <summary>What holds a part, and how it stands: DragState.Status.</summary>
    [Flags]
    public enum DragStatus : uint
    {
        None = 0,
        Latched = K.DM_STATUS_LATCHED,
        Locked = K.DM_STATUS_LOCKED,
        Blocked = K.DM_STATUS_BLOCKED,
        Open = K.DM_STATUS_OPEN
    }

    /// <summary>Where the joint that a drag follows comes from: DragState.JointBasis.</summary>
    public enum JointBasis
    {
        Prepared = K.DM_BASIS_PREPARED,
        Pull = K.DM_BASIS_PULL,
        Host = K.DM_BASIS_HOST,
        Chosen = K.DM_BASIS_CHOSEN
    }

    /// <summary>What a released part does next.</summary>
    public enum Go
    {
        Auto = K.DM_GO_AUTO,
        Stay = K.DM_GO_STAY,
        Open = K.DM_GO_OPEN,
        Close = K.DM_GO_CLOSE,
        Replay = K.DM_GO_REPLAY,
        Freeze = K.DM_GO_FREEZE,
        Toggle = K.DM_GO_TOGGLE
    }

    /// <summary>Go, by its name in 0.2.</summary>
    public enum Intent
    {
        Auto = K.DM_INTENT_AUTO,
        Stay = K.DM_INTENT_STAY,
        Open = K.DM_INTENT_OPEN,
        Close = K.DM_INTENT_CLOSE,
        Replay = K.DM_INTENT_REPLAY,
        Freeze = K.DM_INTENT_FREEZE,
        Toggle = K.DM_INTENT_TOGGLE
    }

    /// <summary>How a hand holds a part: Hand.Kind.</summary>
    public enum HandKind
    {
        None = K.DM_HAND_NONE,
        Ray = K.DM_HAND_RAY,
        Point = K.DM_HAND_POINT,
        Rate = K.DM_HAND_RATE,
        Step = K.DM_HAND_STEP,
        Value = K.DM_HAND_VALUE
    }
}
