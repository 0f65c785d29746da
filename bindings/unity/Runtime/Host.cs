using System;
using UnityEngine;

namespace DragMesh.Unity
{
    /// <summary>The one context of the game or editor. Ends with it, and before the editor reloads its scripts.</summary>
    public static class Host
    {
        private static Context context;

        public static Context Context
        {
            get
            {
                if (context == null) Begin();
                return context;
            }
        }

        private static void Begin()
        {
            context = new Context(new ContextOptions { Axes = Axes.Unity, Log = Show, Parallel = true });
            Application.quitting += End;
            AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => End();
        }

        /// <summary>Ends the context and all that was made with it. The next use makes a new one.</summary>
        public static void End()
        {
            if (context == null) return;
            Application.quitting -= End;
            context.Dispose();
            context = null;
        }

        private static void Show(LogLevel level, string text)
        {
            if (level == LogLevel.Error) Debug.LogWarning("dragmesh: " + text); // what fails throws, too
            else if (level == LogLevel.Warning) Debug.LogWarning("dragmesh: " + text);
        }

        public static Vec3 From(Vector3 v) => new Vec3(v.x, v.y, v.z);
        public static Vector3 To(Vec3 v) => new Vector3(v.X, v.Y, v.Z);

        public static unsafe Quaternion Rotation(Pose pose) =>
            new Quaternion(pose.Real[0], pose.Real[1], pose.Real[2], pose.Real[3]);
    }
}
