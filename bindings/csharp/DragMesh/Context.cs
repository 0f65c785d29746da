using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using System.Threading.Tasks;

namespace DragMesh
{
    /// <summary>Marks static functions that the library calls, for ahead-of-time compilers (IL2CPP) that look for an
    /// attribute of this name.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type) { }
    }

    /// <summary>How to make a context. Zeros are the defaults.</summary>
    public sealed class ContextOptions
    {
        public Axes Axes;
        /// <summary>Length of one host unit; 0 = 1.</summary>
        public float UnitInMetres;
        public Picking Picking;
        /// <summary>Gets the messages. It must not call this context.</summary>
        public Action<LogLevel, string> Log;
        /// <summary>Of calls that take long for a large mesh, preparations with a callback of their own aside: gets 0 .. 1,
        /// rising; returns false to cancel. An exception cancels too.</summary>
        public Func<float, bool> Progress;
        /// <summary>Prepares parts side by side on the thread pool. Answers keep their bits.</summary>
        public bool Parallel;
    }

    /// <summary>A context of the library. Dispose ends it and everything made with it; what is left then throws
    /// ObjectDisposedException.</summary>
    public sealed unsafe class Context : IDisposable
    {
        // Kept for ever: the library holds pointers to them.
        private static readonly LogMessage onMessage = OnMessage;
        private static readonly ProgressCallback onProgress = OnProgress;
        private static readonly JobsParallelFor onJobs = OnJobs;

        [ThreadStatic] private static string lastError;

        internal readonly ContextHandle Handle;
        private readonly Action<LogLevel, string> log;
        private readonly Func<float, bool> progress;

        public Context() : this(new ContextOptions()) { }

        public Context(ContextOptions options)
        {
            log = options.Log;
            progress = options.Progress;
            Handle = new ContextHandle(this);
            ContextDesc desc = ContextDesc.New();
            desc.Axes = (int)options.Axes;
            desc.UnitInMetres = options.UnitInMetres;
            desc.Picking = (int)options.Picking;
            desc.Log.User = (void*)GCHandle.ToIntPtr(Handle.Self);
            desc.Log.Message = Marshal.GetFunctionPointerForDelegate(onMessage);
            if (progress != null)
            {
                desc.Progress = Marshal.GetFunctionPointerForDelegate(onProgress);
                desc.ProgressUser = (void*)GCHandle.ToIntPtr(Handle.Self);
            }
            if (options.Parallel) desc.Jobs.ParallelFor = Marshal.GetFunctionPointerForDelegate(onJobs);
            IntPtr pointer;
            int result = Native.dm_context_create(&desc, &pointer);
            if (result < 0) Handle.Self.Free();
            Check(result);
            Handle.Set(pointer);
        }

        ~Context()
        {
            Dispose();
        }

        /// <summary>Ends it, and everything made with it, after the calls that run now.</summary>
        public void Dispose()
        {
            if (Handle != null) Handle.Dispose();
            GC.SuppressFinalize(this);
        }

        /// <summary>Version of the library in use: major, minor, patch. An odd patch is a version in development.</summary>
        public static Version LibraryVersion
        {
            get
            {
                uint v = Native.dm_version();
                return new Version((int)(v >> 22), (int)(v >> 12 & 0x3ff), (int)(v & 0xfff));
            }
        }

        internal IntPtr Pointer => Handle.Pointer;

        internal Calling Begin(Owned used = null) => new Calling(Handle, used);

        public MemoryInfo Memory()
        {
            MemoryInfo info = MemoryInfo.New();
            using (Begin()) Check(Native.dm_context_get_memory(Pointer, &info));
            return info;
        }

        /// <summary>Reads weights, each the bytes of a safetensors file; each may be absent.</summary>
        public Model LoadModel(ReadOnlySpan<byte> kinematics, ReadOnlySpan<byte> motion, ReadOnlySpan<byte> ranker)
        {
            ModelDesc desc = ModelDesc.New();
            ulong id;
            fixed (byte* k = &MemoryMarshal.GetReference(kinematics))
            fixed (byte* m = &MemoryMarshal.GetReference(motion))
            fixed (byte* r = &MemoryMarshal.GetReference(ranker))
            using (Begin())
            {
                desc.Kinematics = k;
                desc.KinematicsSize = (UIntPtr)kinematics.Length;
                desc.Motion = m;
                desc.MotionSize = (UIntPtr)motion.Length;
                desc.Ranker = r;
                desc.RankerSize = (UIntPtr)ranker.Length;
                Check(Native.dm_model_load(Pointer, &desc, &id));
            }
            return new Model(this, id);
        }

        /// <summary>Reads the shipped weights in a folder.</summary>
        public Model LoadModel(string folder)
        {
            return LoadModel(File.ReadAllBytes(Path.Combine(folder, "kpp_net.safetensors")),
                             File.ReadAllBytes(Path.Combine(folder, "dq_vae.safetensors")),
                             File.ReadAllBytes(Path.Combine(folder, "ranker.safetensors")));
        }

        /// <summary>Finds out how each part moves.</summary>
        public PreparedObject Prepare(Mesh mesh, PrepareOptions options = null)
        {
            if (options == null) options = new PrepareOptions();
            return new PreparedObject(this, options.Run(this, mesh), options.Model);
        }

        /// <summary>Reads a .dmo. model: for its motions.</summary>
        public PreparedObject Load(ReadOnlySpan<byte> dmo, Model model = null)
        {
            ulong id;
            fixed (byte* data = &MemoryMarshal.GetReference(dmo))
            using (Begin(model))
                Check(Native.dm_object_load(Pointer, data, (UIntPtr)dmo.Length, model == null ? 0 : model.Id, &id));
            return new PreparedObject(this, id, model);
        }

        /// <summary>Finds the part that a point of a mesh belongs to: 1 for each face that moves with it.</summary>
        public byte[] FindPart(Mesh mesh, DragHint drag)
        {
            byte[] faces = new byte[mesh.FaceCount];
            mesh.Use((MeshDesc* desc) =>
            {
                DragHint hint = drag;
                fixed (byte* f = faces)
                using (Begin())
                    Check(Native.dm_mesh_find_part(Pointer, desc, &hint, f, (ulong)faces.Length));
            });
            return faces;
        }

        public Scene NewScene()
        {
            SceneDesc desc = SceneDesc.New();
            ulong id;
            using (Begin()) Check(Native.dm_scene_create(Pointer, &desc, &id));
            return new Scene(this, id);
        }

        /// <summary>The ray through a pixel, (0, 0) the top left corner.</summary>
        public Ray CameraRay(Camera camera, float x, float y)
        {
            Ray ray;
            camera.StructSize = Camera.New().StructSize;
            using (Begin()) Check(Native.dm_camera_ray(Pointer, &camera, x, y, &ray));
            return ray;
        }

        /// <summary>Throws for a failed call, with what the library has said of it on this thread.</summary>
        internal void Check(int result)
        {
            if (result < 0)
            {
                string message = lastError;
                lastError = null;
                throw new DragMeshException(result, message);
            }
            GC.KeepAlive(this);
        }

        [MonoPInvokeCallback(typeof(LogMessage))]
        private static void OnMessage(void* user, int level, int code, byte* text)
        {
            try
            {
                string message = Text.From(text);
                if (level == (int)LogLevel.Error) lastError = message;
                Context context = (Context)GCHandle.FromIntPtr((IntPtr)user).Target;
                if (context == null || context.log == null) return;
                Callbacks.Begin(context.Handle);
                try
                {
                    context.log((LogLevel)level, message);
                }
                finally
                {
                    Callbacks.End();
                }
            }
            catch (Exception)
            {
                // Nothing may pass through the library; a log that fails is no reason to fail the call.
            }
        }

        [MonoPInvokeCallback(typeof(ProgressCallback))]
        private static int OnProgress(void* user, float done)
        {
            try
            {
                Context context = (Context)GCHandle.FromIntPtr((IntPtr)user).Target;
                if (context == null) return 0;
                Callbacks.Begin(context.Handle);
                try
                {
                    return context.progress(done) ? 0 : 1;
                }
                finally
                {
                    Callbacks.End();
                }
            }
            catch (Exception)
            {
                return 1; // nothing may pass through the library
            }
        }

        [MonoPInvokeCallback(typeof(JobsParallelFor))]
        private static int OnJobs(void* user, uint count, IntPtr task, void* data)
        {
            int next = -1;
            Action<int> work;
            try
            {
                DragMesh.Task run = Marshal.GetDelegateForFunctionPointer<DragMesh.Task>(task);
                work = worker => { for (int i; (i = Interlocked.Increment(ref next)) < count;) run(data, (uint)i); };
            }
            catch (Exception)
            {
                return 0; // the library runs them itself
            }
            try
            {
                Parallel.For(0, (int)Math.Min(count, (uint)Environment.ProcessorCount), work);
            }
            catch (Exception)
            {
                // Nothing may pass through the library: this thread does what the pool has left.
            }
            work(0);
            return 1;
        }
    }
}
