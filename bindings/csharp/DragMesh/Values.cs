using System;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>A failed call. The message is the library's own: it names the field and the value.</summary>
    public sealed class DragMeshException : Exception
    {
        public Result Code { get; }
        /// <summary>The name in C, such as "DM_ERROR_EMPTY_MASK".</summary>
        public string Name { get; }

        internal DragMeshException(int code, string message)
            : base(string.IsNullOrEmpty(message) ? NameOf(code) : NameOf(code) + ": " + message)
        {
            Code = (Result)code;
            Name = NameOf(code);
        }

        private static unsafe string NameOf(int code) => Text.From(Native.dm_result_string(code));
    }

    public partial struct Vec3
    {
        public Vec3(float x, float y, float z) { X = x; Y = y; Z = z; }
        public override string ToString() => "(" + X + ", " + Y + ", " + Z + ")";
    }

    public partial struct Ray
    {
        public Ray(Vec3 origin, Vec3 direction) { Origin = origin; Direction = direction; }
    }

    public partial struct DragHint
    {
        public DragHint(Vec3 point, Vec3 vector) { Point = point; Vector = vector; }
    }

    public unsafe partial struct Pose
    {
        /// <summary>No motion.</summary>
        public static Pose Identity { get { Pose pose = default(Pose); pose.Real[3] = 1; return pose; } }

        /// <summary>A rotation by the quaternion (qx, qy, qz, qw), then a translation.</summary>
        public static Pose From(float qx, float qy, float qz, float qw, Vec3 translation)
        {
            float* rotation = stackalloc float[4];
            rotation[0] = qx; rotation[1] = qy; rotation[2] = qz; rotation[3] = qw;
            Pose pose;
            Failure.Check(Native.dm_pose_from_rotation(rotation, translation, &pose));
            return pose;
        }

        /// <summary>The motion back.</summary>
        public Pose Inverse
        {
            get
            {
                Pose pose = this;
                Native.dm_pose_inverse(&pose, &pose);
                return pose;
            }
        }

        /// <summary>The translation: what the pose does to the origin.</summary>
        public Vec3 Translation => Apply(default(Vec3));

        /// <summary>a after b.</summary>
        public static Pose operator *(Pose a, Pose b)
        {
            Pose product;
            Native.dm_pose_multiply(&a, &b, &product);
            return product;
        }

        public Vec3 Apply(Vec3 point)
        {
            Pose pose = this;
            Native.dm_pose_apply_points(&pose, &point.X, UIntPtr.Zero, &point.X, UIntPtr.Zero, (UIntPtr)1);
            return point;
        }

        /// <summary>Moves points in place.</summary>
        public void Apply(Span<Vec3> points)
        {
            Pose pose = this;
            fixed (Vec3* p = &MemoryMarshal.GetReference(points))
                Native.dm_pose_apply_points(&pose, &p->X, UIntPtr.Zero, &p->X, UIntPtr.Zero, (UIntPtr)points.Length);
        }

        /// <summary>Writes 16 numbers, column by column (Matrix4x4's order in Unity).</summary>
        public void ToMatrix(Span<float> columns)
        {
            if (columns.Length < 16) throw new ArgumentException("16 numbers are needed");
            Pose pose = this;
            fixed (float* p = &MemoryMarshal.GetReference(columns)) Native.dm_pose_to_matrix(&pose, p);
        }
    }

    public unsafe partial struct Joint
    {
        public JointType Kind => (JointType)Type;
        public JointSource From => (JointSource)Source;

        /// <summary>Evidence as four numbers, to save and to load: what the part's pulls have said. Fewer than four are an
        /// ArgumentException; null is none.</summary>
        public uint[] PullEvidence
        {
            get
            {
                fixed (uint* words = Evidence) return new[] { words[0], words[1], words[2], words[3] };
            }
            set
            {
                if (value != null && value.Length < 4) throw new ArgumentException("four numbers are needed");
                fixed (uint* words = Evidence)
                    for (int i = 0; i < 4; i++) words[i] = value == null ? 0 : value[i];
            }
        }

        /// <summary>With its true size, whatever a caller has written into it.</summary>
        private Joint Sized
        {
            get
            {
                Joint joint = this;
                joint.StructSize = New().StructSize;
                return joint;
            }
        }

        /// <summary>The pose at a joint value.</summary>
        public Pose PoseAt(float value)
        {
            Joint joint = Sized;
            Pose pose;
            Failure.Check(Native.dm_joint_pose(&joint, value, &pose));
            return pose;
        }

        /// <summary>The joint value at a share of the way from rest (0) to the open end (1).</summary>
        public float ValueAt(float share)
        {
            Joint joint = Sized;
            float value;
            Failure.Check(Native.dm_joint_value_at(&joint, share, &value));
            return value;
        }

        /// <summary>The value at which the joint comes nearest to a pose, and how far off the joint that is.</summary>
        public float ValueOf(Pose pose, out float angleError, out float distanceError)
        {
            Joint joint = Sized;
            float value, angle, distance;
            Failure.Check(Native.dm_joint_value(&joint, &pose, &value, &angle, &distance));
            angleError = angle;
            distanceError = distance;
            return value;
        }

        /// <summary>The joint as a constraint of a physics engine.</summary>
        public JointFrame Frame()
        {
            Joint joint = Sized;
            JointFrame frame = JointFrame.New();
            Failure.Check(Native.dm_joint_get_frame(&joint, &frame));
            return frame;
        }

        /// <summary>The joint of an instance scaled along the axes of the object frame.</summary>
        public Joint Scaled(Vec3 scale)
        {
            Joint joint = Sized, scaled = New();
            Failure.Check(Native.dm_joint_scale(&joint, scale, &scaled));
            return scaled;
        }
    }

    public partial struct DragState
    {
        public DragEvents Happened => (DragEvents)Events;
        public DragPhase Doing => (DragPhase)Phase;
        public DragStatus Stands => (DragStatus)Status;
        public JointBasis JointFrom => (JointBasis)JointBasis;
    }

    internal static class Failure
    {
        /// <summary>Of calls without a context, which log nothing.</summary>
        internal static void Check(int result)
        {
            if (result < 0) throw new DragMeshException(result, null);
        }
    }

    /// <summary>Text of C: UTF-8 that ends with a zero.</summary>
    internal static unsafe class Text
    {
        internal static string From(byte* text)
        {
            if (text == null) return null;
            int length = 0;
            while (text[length] != 0) length++;
            return System.Text.Encoding.UTF8.GetString(text, length);
        }

        internal static byte[] Bytes(string text)
        {
            if (text == null) return null;
            if (text.IndexOf('\0') >= 0) throw new ArgumentException("a text has a zero character, which would end it");
            return System.Text.Encoding.UTF8.GetBytes(text + "\0");
        }
    }
}
