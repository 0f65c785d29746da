using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>What is known of a part. Everything but the id is optional.</summary>
    public sealed class Part
    {
        /// <summary>As in the mesh's part ids; 1 and up.</summary>
        public uint Id;
        /// <summary>Id of the part that carries it; 0 = the body.</summary>
        public uint Parent;
        public JointType JointType;
        public DragHint? Drag;
        /// <summary>Names that the asset has for it, outermost first, joined by '/'.</summary>
        public string Label;
        /// <summary>Where the asset has its node or bone.</summary>
        public Pivot? Pivot;
    }

    /// <summary>A part and its hypotheses, most probable first, for a host that chooses.</summary>
    public sealed class PartChoice
    {
        public PartInfo Part;
        public Joint[] Joints;
        /// <summary>Where each joint takes the part at its lower and its upper limit.</summary>
        public JointEnd[] Lower, Upper;
    }

    /// <summary>How to prepare an object. Everything is optional.</summary>
    public sealed unsafe class PrepareOptions
    {
        /// <summary>Null: every part id above 0 is a part that the body carries.</summary>
        public IList<Part> Parts;
        public Model Model;
        /// <summary>Names of the whole object.</summary>
        public string Label;
        /// <summary>Which way is up; zeros: as the context's axes say.</summary>
        public Vec3 Up;
        public ulong Seed;
        public bool WithoutPicking;
        /// <summary>Gets 0 .. 1, rising; returns false to cancel.</summary>
        public Func<float, bool> Progress;
        /// <summary>Gets a part's id and box; returns JointType.Unknown to leave the question to the library.</summary>
        public Func<uint, Vec3, Vec3, JointType> Intent;
        /// <summary>Returns the index of the right hypothesis; -1 keeps the library's answer.</summary>
        public Func<PartChoice, int> Choose;

        private static readonly ProgressCallback onProgress = OnProgress;
        private static readonly IntentCallback onIntent = OnIntent;
        private static readonly ChoiceCallback onChoose = OnChoose;

        /// <summary>The functions of one call, and the first exception of theirs.</summary>
        private sealed class Call
        {
            internal PrepareOptions Options;
            internal Context Context;
            internal Exception Failure;
        }

        internal ulong Run(Context context, Mesh mesh)
        {
            Call call = new Call { Options = this, Context = context };
            GCHandle user = GCHandle.Alloc(call);
            ulong id = 0;
            using (context.Begin(Model))
            {
                try
                {
                    using (Memory memory = new Memory())
                        mesh.Use((MeshDesc* desc) => { id = Run(context, desc, memory, (void*)GCHandle.ToIntPtr(user)); });
                }
                catch (DragMeshException)
                {
                    if (call.Failure == null) throw;
                }
                finally
                {
                    user.Free();
                }
                if (call.Failure == null) return id;
                if (id != 0) Native.dm_object_destroy(context.Pointer, id);
            }
            throw new InvalidOperationException("a callback of Prepare has failed", call.Failure);
        }

        private ulong Run(Context context, MeshDesc* mesh, Memory memory, void* user)
        {
            ObjectDesc desc = ObjectDesc.New();
            desc.Flags = WithoutPicking ? (uint)Constants.DM_PREPARE_WITHOUT_PICKING : 0;
            desc.Mesh = mesh;
            desc.Label = memory.Text(Label);
            desc.Up = Up;
            desc.Seed = Seed;
            if (Model != null) desc.Model = Model.Id;
            if (Parts != null && Parts.Count > 0)
            {
                PartDesc* rows = (PartDesc*)memory.Allocate(Parts.Count * sizeof(PartDesc));
                for (int i = 0; i < Parts.Count; i++) rows[i] = Describe(Parts[i], memory);
                desc.Parts = rows;
                desc.PartCount = (uint)Parts.Count;
            }
            if (Progress != null) desc.Progress = Marshal.GetFunctionPointerForDelegate(onProgress);
            if (Intent != null) desc.Intent = Marshal.GetFunctionPointerForDelegate(onIntent);
            if (Choose != null) desc.Choose = Marshal.GetFunctionPointerForDelegate(onChoose);
            desc.ProgressUser = desc.IntentUser = desc.ChooseUser = user;
            ulong id;
            context.Check(Native.dm_object_prepare(context.Pointer, &desc, &id));
            return id;
        }

        private static PartDesc Describe(Part part, Memory memory)
        {
            PartDesc row = PartDesc.New();
            row.Id = part.Id;
            row.Parent = part.Parent;
            row.JointType = (int)part.JointType;
            row.Label = memory.Text(part.Label);
            if (part.Drag.HasValue) *(row.Drag = (DragHint*)memory.Allocate(sizeof(DragHint))) = part.Drag.Value;
            if (part.Pivot.HasValue) *(row.Pivot = (Pivot*)memory.Allocate(sizeof(Pivot))) = part.Pivot.Value;
            return row;
        }

        /// <summary>Memory of one call.</summary>
        private sealed class Memory : IDisposable
        {
            private readonly List<IntPtr> blocks = new List<IntPtr>();

            internal void* Allocate(int size)
            {
                blocks.Add(Marshal.AllocHGlobal(size));
                return (void*)blocks[blocks.Count - 1];
            }

            internal byte* Text(string text)
            {
                byte[] bytes = DragMesh.Text.Bytes(text);
                if (bytes == null) return null;
                byte* copy = (byte*)Allocate(bytes.Length);
                Marshal.Copy(bytes, 0, (IntPtr)copy, bytes.Length);
                return copy;
            }

            public void Dispose()
            {
                foreach (IntPtr block in blocks) Marshal.FreeHGlobal(block);
            }
        }

        /// <summary>Asks the host. Nothing may pass through the library: the first exception is kept, and the preparation
        /// cancelled or ended.</summary>
        private static int Ask(void* user, int otherwise, Func<PrepareOptions, int> ask)
        {
            Call call = (Call)GCHandle.FromIntPtr((IntPtr)user).Target;
            if (call.Failure != null) return otherwise;
            Callbacks.Begin(call.Context.Handle);
            try
            {
                return ask(call.Options);
            }
            catch (Exception failure)
            {
                call.Failure = failure;
                return otherwise;
            }
            finally
            {
                Callbacks.End();
            }
        }

        [MonoPInvokeCallback(typeof(ProgressCallback))]
        private static int OnProgress(void* user, float done)
        {
            return Ask(user, 1, options => options.Progress(done) ? 0 : 1);
        }

        [MonoPInvokeCallback(typeof(IntentCallback))]
        private static int OnIntent(void* user, uint part, Vec3 low, Vec3 high)
        {
            return Ask(user, Constants.DM_JOINT_UNKNOWN, options => (int)options.Intent(part, low, high));
        }

        [MonoPInvokeCallback(typeof(ChoiceCallback))]
        private static int OnChoose(void* user, Choice* choice)
        {
            return Ask(user, Constants.DM_CHOICE_KEEP, options => options.Choose(Shown(choice)));
        }

        private static PartChoice Shown(Choice* choice)
        {
            int count = (int)choice->Count;
            PartChoice shown = new PartChoice {
                Part = *choice->Part, Joints = new Joint[count], Lower = new JointEnd[count], Upper = new JointEnd[count]
            };
            for (int i = 0; i < count; i++)
            {
                shown.Joints[i] = *choice->Hypotheses[i]->Joint;
                shown.Lower[i] = choice->Hypotheses[i]->Ends0;
                shown.Upper[i] = choice->Hypotheses[i]->Ends1;
            }
            return shown;
        }
    }
}
