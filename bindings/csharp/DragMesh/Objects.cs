using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>Something that a context has made. Dispose ends it now, else a finalizer does; where the context has
    /// ended first, there is nothing left to end.</summary>
    public abstract class Owned : SafeHandle
    {
        internal readonly Context Context;
        internal readonly Owned Kept; // what this needs: not to be collected before
        private readonly ContextHandle owner;
        private readonly ulong id;

        internal Owned(Context context, ulong id, Owned kept = null) : base(IntPtr.Zero, true)
        {
            Context = context;
            Kept = kept;
            owner = context.Handle;
            this.id = id;
            SetHandle((IntPtr)1); // an id has 64 bits on every machine, a pointer has not
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        /// <summary>Whether it has ended, by itself or with its context.</summary>
        public bool IsEnded => IsClosed || owner.IsClosed;

        internal ulong Id
        {
            get
            {
                if (IsClosed) throw new ObjectDisposedException(GetType().FullName);
                return id;
            }
        }

        internal IntPtr Pointer => owner.Pointer;

        internal Calling Begin() => new Calling(owner, this);

        internal void Check(int result)
        {
            Context.Check(result);
            GC.KeepAlive(this);
        }

        internal abstract int End(IntPtr context, ulong ended);
        internal void End(IntPtr context) => End(context, id);

        protected override bool ReleaseHandle()
        {
            owner.End(this);
            return true;
        }
    }

    /// <summary>Loaded weights.</summary>
    public sealed class Model : Owned
    {
        internal Model(Context context, ulong id) : base(context, id) { }
        internal override int End(IntPtr context, ulong ended) => Native.dm_model_unload(context, ended);
    }

    /// <summary>Parts and their joints.</summary>
    public sealed unsafe class PreparedObject : Owned
    {
        internal PreparedObject(Context context, ulong id, Model model) : base(context, id, model) { }
        internal override int End(IntPtr context, ulong ended) => Native.dm_object_destroy(context, ended);

        /// <summary>As dm_hit.object has it.</summary>
        public ulong Number => Id;

        public ObjectInfo Info()
        {
            ObjectInfo info = ObjectInfo.New();
            using (Begin()) Check(Native.dm_object_get_info(Pointer, Id, &info));
            return info;
        }

        /// <summary>All parts, in order of id.</summary>
        public PartInfo[] Parts()
        {
            PartInfo[] parts = new PartInfo[Info().PartCount];
            for (int i = 0; i < parts.Length; i++)
            {
                PartInfo part = PartInfo.New();
                using (Begin()) Check(Native.dm_object_get_part(Pointer, Id, (uint)i, &part));
                parts[i] = part;
            }
            return parts;
        }

        /// <summary>The joint in force.</summary>
        public Joint JointOf(uint part)
        {
            Joint joint = Joint.New();
            using (Begin()) Check(Native.dm_object_get_joint(Pointer, Id, part, &joint));
            return joint;
        }

        /// <summary>All that were found, most probable first; ranked by a drag where one is given.</summary>
        public Joint[] Hypotheses(uint part, DragHint? drag = null)
        {
            Joint[] joints = new Joint[Constants.DM_MAX_HYPOTHESES];
            joints[0] = Joint.New();
            DragHint hint = drag.GetValueOrDefault();
            uint count;
            fixed (Joint* out_joints = joints)
            using (Begin())
                Check(Native.dm_object_get_hypotheses(Pointer, Id, part, drag.HasValue ? &hint : null, out_joints,
                                                      (uint)joints.Length, &count));
            Array.Resize(ref joints, (int)count);
            return joints;
        }

        public void SetJoint(uint part, Joint joint)
        {
            joint.StructSize = Joint.New().StructSize;
            using (Begin()) Check(Native.dm_object_set_joint(Pointer, Id, part, &joint));
        }

        /// <summary>Puts the library's own answer back in force.</summary>
        public void ResetJoint(uint part)
        {
            using (Begin()) Check(Native.dm_object_reset_joint(Pointer, Id, part));
        }

        /// <summary>Infers the joint again, with a player's drag as evidence.</summary>
        public void Refine(uint part, DragHint drag)
        {
            using (Begin()) Check(Native.dm_object_refine(Pointer, Id, part, &drag));
        }

        public void SetLinks(ReadOnlySpan<Link> links)
        {
            fixed (Link* l = &MemoryMarshal.GetReference(links))
            using (Begin())
                Check(Native.dm_object_set_links(Pointer, Id, l, (uint)links.Length));
        }

        /// <summary>Moves what is linked with a part that has moved. values: one a part, in order of id. held: 1 for
        /// parts that links hold; empty: not asked for.</summary>
        public void FollowLinks(uint part, Span<float> values, Span<byte> held)
        {
            if (held.Length != 0 && held.Length != values.Length) throw new ArgumentException("one of held a value");
            fixed (float* v = &MemoryMarshal.GetReference(values))
            fixed (byte* h = &MemoryMarshal.GetReference(held))
            using (Begin())
                Check(Native.dm_object_follow_links(Pointer, Id, part, v, h, (uint)values.Length));
        }

        /// <summary>The bytes of a .dmo.</summary>
        public byte[] Save()
        {
            UIntPtr size;
            using (Begin()) Check(Native.dm_object_save(Pointer, Id, null, UIntPtr.Zero, &size));
            byte[] data = new byte[(long)size];
            fixed (byte* d = data)
            using (Begin())
                Check(Native.dm_object_save(Pointer, Id, d, size, &size));
            return data;
        }

        /// <summary>The network's motion for a drag. desc: MotionDesc.New() and what is known.</summary>
        public Motion Generate(MotionDesc desc)
        {
            ulong id;
            desc.StructSize = MotionDesc.New().StructSize;
            using (Begin()) Check(Native.dm_motion_generate(Pointer, Id, &desc, &id));
            return new Motion(this, id);
        }

        /// <summary>Grabs a part. desc: DragDesc.New() with part and grab point. rules: DragRules.New() for events,
        /// latches, locks. snaps: joint values where the part catches. state: as an earlier drag ended.</summary>
        public Drag Grab(DragDesc desc, DragRules? rules = null, PartState? state = null,
                         ReadOnlySpan<float> snaps = default(ReadOnlySpan<float>))
        {
            DragRules r = rules.GetValueOrDefault(DragRules.New());
            PartState s = state.GetValueOrDefault();
            ulong id;
            r.StructSize = DragRules.New().StructSize;
            s.StructSize = DragMesh.PartState.New().StructSize;
            s.Joint.StructSize = Joint.New().StructSize;
            desc.StructSize = DragDesc.New().StructSize;
            fixed (float* values = &MemoryMarshal.GetReference(snaps))
            {
                r.Snaps = values;
                r.SnapCount = (uint)snaps.Length;
                desc.Object = Id;
                desc.Rules = rules.HasValue || snaps.Length > 0 ? &r : null;
                desc.State = state.HasValue ? &s : null;
                using (Begin()) Check(Native.dm_drag_begin(Pointer, &desc, &id));
            }
            return new Drag(this, id);
        }
    }

    /// <summary>A generated motion.</summary>
    public sealed unsafe class Motion : Owned
    {
        internal Motion(PreparedObject of, ulong id) : base(of.Context, id, of) { }
        internal override int End(IntPtr context, ulong ended) => Native.dm_motion_destroy(context, ended);

        /// <summary>The pose at t, 0 to 1, and the joint value.</summary>
        public Pose Sample(float t, out float value)
        {
            Pose pose;
            float v;
            using (Begin()) Check(Native.dm_motion_sample(Pointer, Id, t, &pose, &v));
            value = v;
            return pose;
        }
    }

    /// <summary>One player dragging one part. Its calls of every frame make no garbage.</summary>
    public sealed unsafe class Drag : Owned
    {
        internal Drag(PreparedObject of, ulong id) : base(of.Context, id, of) { }
        internal override int End(IntPtr context, ulong ended) => Native.dm_drag_end(context, ended, null);

        /// <summary>The grabbed point follows a ray of the object frame. seconds: since the last update.</summary>
        public DragState Update(Ray ray, float seconds)
        {
            DragState state = DragState.New();
            using (Begin()) Check(Native.dm_drag_update(Pointer, Id, &ray, seconds, &state));
            return state;
        }

        /// <summary>A released part goes on.</summary>
        public DragState Update(float seconds)
        {
            DragState state = DragState.New();
            using (Begin()) Check(Native.dm_drag_update(Pointer, Id, null, seconds, &state));
            return state;
        }

        /// <summary>Update for all that a DragInput holds.</summary>
        public DragState UpdateInput(DragInput input, float seconds)
        {
            DragState state = DragState.New();
            input.StructSize = DragInput.New().StructSize;
            using (Begin()) Check(Native.dm_drag_update_input(Pointer, Id, &input, seconds, &state));
            return state;
        }

        /// <summary>Takes another value than the one that an update with DM_INPUT_ASK is about to take.</summary>
        public DragState Override(float value)
        {
            DragState state = DragState.New();
            using (Begin()) Check(Native.dm_drag_override(Pointer, Id, value, &state));
            return state;
        }

        /// <summary>UpdateInput, by its name in 0.2.</summary>
        public DragState Step(DragInput input, float seconds) => UpdateInput(input, seconds);

        /// <summary>Override, by its name in 0.2.</summary>
        public DragState Take(float value) => Override(value);

        /// <summary>Lets go. desc: ReleaseDesc.New() and what is wanted.</summary>
        public ReleasePlan Release(ReleaseDesc desc)
        {
            ReleasePlan plan = ReleasePlan.New();
            desc.StructSize = ReleaseDesc.New().StructSize;
            using (Begin()) Check(Native.dm_drag_release(Pointer, Id, &desc, &plan));
            return plan;
        }

        public ReleasePlan Release(Go what = Go.Auto)
        {
            ReleaseDesc desc = ReleaseDesc.New();
            desc.Intent = (int)what;
            return Release(desc);
        }

        public ReleasePlan Release(Intent what) => Release((Go)what);

        /// <summary>What the instance keeps: joint, value and pose.</summary>
        public PartState PartState()
        {
            PartState state = DragMesh.PartState.New();
            using (Begin()) Check(Native.dm_drag_get_part_state(Pointer, Id, &state));
            return state;
        }

        /// <summary>Ends it and returns what the instance keeps.</summary>
        public PartState Finish()
        {
            PartState state = PartState();
            Dispose();
            return state;
        }

        /// <summary>The whole state, for rollback, into a buffer of SnapshotSize bytes.</summary>
        public void Save(Span<byte> buffer)
        {
            fixed (byte* b = &MemoryMarshal.GetReference(buffer))
            using (Begin())
                Check(Native.dm_drag_save(Pointer, Id, b, (UIntPtr)buffer.Length));
        }

        public void Restore(ReadOnlySpan<byte> saved)
        {
            fixed (byte* s = &MemoryMarshal.GetReference(saved))
            using (Begin())
                Check(Native.dm_drag_restore(Pointer, Id, s, (UIntPtr)saved.Length));
        }

        public static int SnapshotSize => (int)Native.dm_drag_snapshot_size();
    }

    /// <summary>Placed objects that rays can pick.</summary>
    public sealed unsafe class Scene : Owned
    {
        private readonly List<PreparedObject> objects = new List<PreparedObject>(); // kept: one that ends leaves

        internal Scene(Context context, ulong id) : base(context, id) { }
        internal override int End(IntPtr context, ulong ended) => Native.dm_scene_destroy(context, ended);

        /// <summary>Places an object and returns its instance.</summary>
        public uint Add(PreparedObject prepared, Pose? placement = null)
        {
            Pose pose = placement.GetValueOrDefault();
            uint instance;
            using (Begin())
            using (prepared.Begin())
                Check(Native.dm_scene_add(Pointer, Id, prepared.Id, placement.HasValue ? &pose : null, &instance));
            if (!objects.Contains(prepared)) objects.Add(prepared);
            return instance;
        }

        /// <summary>Moves a part, or with part 0 the instance.</summary>
        public void Move(uint instance, uint part, Pose pose)
        {
            using (Begin()) Check(Native.dm_scene_move(Pointer, Id, instance, part, &pose));
        }

        public void Remove(uint instance)
        {
            using (Begin()) Check(Native.dm_scene_remove(Pointer, Id, instance));
        }

        /// <summary>Makes moves visible to picks: once a frame.</summary>
        public void Commit()
        {
            using (Begin()) Check(Native.dm_scene_commit(Pointer, Id));
        }

        /// <summary>The nearest hit of a ray; false when there is none.</summary>
        public bool Pick(Ray ray, out Hit hit)
        {
            Hit found = Hit.New();
            using (Begin()) Check(Native.dm_scene_pick(Pointer, Id, &ray, &found));
            hit = found;
            return found.Object != 0;
        }
    }
}
