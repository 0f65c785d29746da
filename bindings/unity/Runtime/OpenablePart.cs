using System;
using UnityEngine;

namespace DragMesh.Unity
{
    /// <summary>A part of an Openable: a node that moves, with all that it carries.</summary>
    [Serializable]
    public sealed class OpenablePart
    {
        public Transform node;
        /// <summary>Position in Openable.parts + 1.</summary>
        public uint id;
        /// <summary>Id of the part that carries it; 0 = the body.</summary>
        public uint parent;
        [Tooltip("Unknown: to be found out.")] public JointType jointType;

        // At rest, in the object frame.
        internal Vector3 restPosition;
        internal Quaternion restRotation;
        // As it stands now.
        internal PartState state;
        internal bool moved;
        internal Drag drag;
        internal bool held;

        /// <summary>The pose from rest, without that of the parts that carry it.</summary>
        internal Pose Own => moved ? state.Pose : Pose.Identity;
    }
}
