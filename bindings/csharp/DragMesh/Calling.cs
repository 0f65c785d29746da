using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>The memory of a context, which everything made with it checks before it ends itself.</summary>
    internal sealed class ContextHandle : SafeHandle
    {
        /// <summary>Taken to end anything: finalizers run on a thread of their own.</summary>
        internal readonly object Gate = new object();
        /// <summary>Names the context to callbacks. Weak, so that it keeps nothing alive.</summary>
        internal readonly GCHandle Self;
        private readonly Queue<Owned> late = new Queue<Owned>(); // ended in callbacks, where the library is not called

        internal ContextHandle(Context context) : base(IntPtr.Zero, true)
        {
            Self = GCHandle.Alloc(context, GCHandleType.Weak);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;
        internal IntPtr Pointer => handle;
        internal void Set(IntPtr pointer) => SetHandle(pointer);

        /// <summary>Ends something now, or after the call whose callback ends it.</summary>
        internal void End(Owned owned)
        {
            lock (Gate)
            {
                if (handle == IntPtr.Zero) return;
                if (Callbacks.Run(this)) late.Enqueue(owned);
                else owned.End(handle);
            }
        }

        internal void EndLate()
        {
            if (late.Count == 0) return;
            lock (Gate)
                while (late.Count > 0) late.Dequeue().End(handle);
        }

        protected override bool ReleaseHandle()
        {
            lock (Gate)
            {
                Native.dm_context_destroy(handle);
                handle = IntPtr.Zero;
                late.Clear();
            }
            Self.Free();
            return true;
        }
    }

    /// <summary>The contexts whose callbacks run on this thread.</summary>
    internal static class Callbacks
    {
        [ThreadStatic] private static List<ContextHandle> running;

        internal static bool Run(ContextHandle context) => running != null && running.Contains(context);

        internal static void Begin(ContextHandle context)
        {
            if (running == null) running = new List<ContextHandle>();
            running.Add(context);
        }

        internal static void End() => running.RemoveAt(running.Count - 1);
    }

    /// <summary>A call that runs. What it uses ends after it, whoever disposes it meanwhile.</summary>
    internal struct Calling : IDisposable
    {
        private readonly ContextHandle context;
        private readonly Owned used, itsObject, itsModel;

        internal Calling(ContextHandle context, Owned used)
        {
            if (Callbacks.Run(context))
                throw new InvalidOperationException("a callback must not call the context that calls it");
            this.context = context;
            this.used = used;
            itsObject = itsModel = null;
            bool held = false;
            context.DangerousAddRef(ref held);
            if (used == null) return;
            try
            {
                held = false;
                used.DangerousAddRef(ref held);
            }
            catch (ObjectDisposedException)
            {
                context.DangerousRelease();
                throw;
            }
            itsObject = Held(used.Kept);
            if (itsObject != null) itsModel = Held(itsObject.Kept);
        }

        /// <summary>What has ended already is not held: the library says so.</summary>
        private static Owned Held(Owned owned)
        {
            if (owned == null || owned.IsClosed) return null;
            bool held = false;
            try
            {
                owned.DangerousAddRef(ref held);
            }
            catch (ObjectDisposedException) { } // another thread was faster
            return held ? owned : null;
        }

        public void Dispose()
        {
            context.EndLate();
            if (itsModel != null) itsModel.DangerousRelease();
            if (itsObject != null) itsObject.DangerousRelease();
            if (used != null) used.DangerousRelease();
            context.DangerousRelease();
        }
    }
}
