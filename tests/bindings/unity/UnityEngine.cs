// A stub of the part of Unity's API that the package calls: enough to compile it, and to run what moves transforms.
using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 up => new Vector3(0, 1, 0);
        public static Vector3 right => new Vector3(1, 0, 0);
        public static Vector3 one => new Vector3(1, 1, 1);
        public static Vector3 zero => default(Vector3);
        public float sqrMagnitude => x * x + y * y + z * z;
        public Vector3 normalized => this * (1 / (float)Math.Sqrt(sqrMagnitude));
        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator *(Vector3 a, float s) => new Vector3(a.x * s, a.y * s, a.z * s);
        public static Vector3 operator *(float s, Vector3 a) => a * s;
        public static Vector3 Scale(Vector3 a, Vector3 b) => new Vector3(a.x * b.x, a.y * b.y, a.z * b.z);
        public static float Distance(Vector3 a, Vector3 b) => (float)Math.Sqrt((a - b).sqrMagnitude);
        public static Vector3 Cross(Vector3 a, Vector3 b) =>
            new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }

    public struct Quaternion
    {
        public float x, y, z, w;
        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public static Quaternion identity => new Quaternion(0, 0, 0, 1);
        public static Quaternion Inverse(Quaternion q) => new Quaternion(-q.x, -q.y, -q.z, q.w);
        public static Quaternion AngleAxis(float degrees, Vector3 axis)
        {
            double half = degrees * Math.PI / 360;
            Vector3 v = axis.normalized * (float)Math.Sin(half);
            return new Quaternion(v.x, v.y, v.z, (float)Math.Cos(half));
        }
        public static Quaternion operator *(Quaternion a, Quaternion b) =>
            new Quaternion(a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
                           a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            Vector3 u = new Vector3(q.x, q.y, q.z), t = 2 * Vector3.Cross(u, v);
            return v + q.w * t + Vector3.Cross(u, t);
        }
    }

    public struct Matrix4x4 { }
    public struct Color
    {
        public static Color yellow, gray, green;
        public static Color Lerp(Color a, Color b, float t) => a;
    }
    public struct Bounds { public Vector3 size; }
    public struct Ray
    {
        public Vector3 origin, direction;
        public Ray(Vector3 origin, Vector3 direction) { this.origin = origin; this.direction = direction; }
    }

    public static class Mathf
    {
        public const float Rad2Deg = 57.29578f;
        public static float Abs(float x) => Math.Abs(x);
    }

    public class Object { public string name { get; set; } = ""; }
    public class TextAsset : Object { public byte[] bytes { get; set; } }
    public class ScriptableObject : Object
    {
        public static T CreateInstance<T>() where T : ScriptableObject, new() => new T();
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }
        public Transform transform => gameObject.transform;
        public T GetComponent<T>() where T : Component => gameObject.GetComponent<T>();
        public T[] GetComponentsInChildren<T>() where T : Component
        {
            List<T> found = new List<T>();
            transform.Collect(found);
            return found.ToArray();
        }
        public new string name { get => gameObject.name; set => gameObject.name = value; }
    }

    public class Behaviour : Component { }
    public class MonoBehaviour : Behaviour { }

    public class GameObject : Object
    {
        internal readonly List<Component> components = new List<Component>();
        public Transform transform { get; }
        public bool active = true;

        public GameObject(string name = "")
        {
            this.name = name;
            transform = AddComponent<Transform>();
        }
        public T AddComponent<T>() where T : Component, new()
        {
            T component = new T { gameObject = this };
            components.Add(component);
            if (active) Call(component, "OnEnable");
            return component;
        }
        public T GetComponent<T>() where T : Component => (T)components.Find(c => c is T);
        public void SetActive(bool value)
        {
            if (active == value) return;
            active = value;
            foreach (Component component in components) Call(component, value ? "OnEnable" : "OnDisable");
        }
        /// <summary>Calls a message of Unity's, as Unity does: by its name.</summary>
        public static void Call(Component component, string message)
        {
            var method = component.GetType().GetMethod(message, System.Reflection.BindingFlags.Instance |
                                                                    System.Reflection.BindingFlags.NonPublic);
            if (method == null) return;
            try
            {
                method.Invoke(component, null);
            }
            catch (System.Reflection.TargetInvocationException failure)
            {
                System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(failure.InnerException).Throw();
            }
        }
    }

    public class Transform : Component
    {
        private readonly List<Transform> children = new List<Transform>();
        public Vector3 localPosition, localScale = Vector3.one;
        public Quaternion localRotation = Quaternion.identity;
        public Transform parent { get; private set; }

        public void SetParent(Transform to, bool worldPositionStays)
        {
            parent = to;
            to.children.Add(this);
        }
        public Vector3 lossyScale => parent == null ? localScale : Vector3.Scale(parent.lossyScale, localScale);
        public Quaternion rotation => parent == null ? localRotation : parent.rotation * localRotation;
        public Vector3 position => parent == null ? localPosition : parent.TransformPoint(localPosition);
        public Vector3 right => rotation * new Vector3(1, 0, 0);
        public Vector3 up => rotation * new Vector3(0, 1, 0);
        public Vector3 forward => rotation * new Vector3(0, 0, 1);
        public Matrix4x4 localToWorldMatrix => default(Matrix4x4);
        public Vector3 TransformPoint(Vector3 p)
        {
            Vector3 here = localPosition + localRotation * Vector3.Scale(localScale, p);
            return parent == null ? here : parent.TransformPoint(here);
        }
        private Vector3 Unscale(Vector3 v) => new Vector3(v.x / localScale.x, v.y / localScale.y, v.z / localScale.z);
        public Vector3 InverseTransformPoint(Vector3 p)
        {
            Vector3 there = parent == null ? p : parent.InverseTransformPoint(p);
            return Unscale(Quaternion.Inverse(localRotation) * (there - localPosition));
        }
        public Vector3 InverseTransformVector(Vector3 v) => InverseTransformPoint(v + TransformPoint(Vector3.zero));
        public Vector3 InverseTransformDirection(Vector3 v) => Quaternion.Inverse(rotation) * v;
        public void SetPositionAndRotation(Vector3 p, Quaternion q)
        {
            localPosition = parent == null ? p : parent.InverseTransformPoint(p);
            localRotation = parent == null ? q : Quaternion.Inverse(parent.rotation) * q;
        }
        internal void Collect<T>(List<T> found) where T : Component
        {
            foreach (Component component in gameObject.components)
                if (component is T) found.Add((T)component);
            foreach (Transform child in children) child.Collect(found);
        }
    }

    public class Material : Object { }
    public class Mesh : Object
    {
        public Vector3[] vertices { get; set; }
        public int[] triangles { get; set; }
        public Bounds bounds { get; private set; }
        public void RecalculateNormals() { }
        public void RecalculateBounds()
        {
            Vector3 low = vertices[0], high = vertices[0];
            foreach (Vector3 v in vertices)
            {
                low = new Vector3(Math.Min(low.x, v.x), Math.Min(low.y, v.y), Math.Min(low.z, v.z));
                high = new Vector3(Math.Max(high.x, v.x), Math.Max(high.y, v.y), Math.Max(high.z, v.z));
            }
            bounds = new Bounds { size = high - low };
        }
    }
    public class MeshFilter : Component { public Mesh sharedMesh; }
    public class MeshRenderer : Component { public Material sharedMaterial; }
    public class Camera : Behaviour
    {
        public static Ray next;
        public Ray ScreenPointToRay(Vector3 pixel) => next;
    }

    public static class Input
    {
        public static bool down, held;
        public static Vector3 mousePosition => Vector3.zero;
        public static bool GetMouseButtonDown(int button) => down;
        public static bool GetMouseButton(int button) => held;
    }
    public static class Time { public static float deltaTime => 1f / 60; }
    public static class Debug { public static void LogWarning(object message) => Console.Error.WriteLine(message); }
    public static class Application
    {
        public static event Action quitting;
        public static void Quit() { if (quitting != null) quitting(); }
    }
    public static class GUILayout { public static bool Button(string text) => false; }

    public sealed class SerializeField : Attribute { }
    public sealed class HideInInspector : Attribute { }
    public sealed class DisallowMultipleComponent : Attribute { }
    public sealed class TooltipAttribute : Attribute { public TooltipAttribute(string text) { } }
    public sealed class RequireComponent : Attribute { public RequireComponent(Type type) { } }
}

namespace UnityEngine.Events
{
    public class UnityEvent<T>
    {
        private Action<T> calls;
        public void AddListener(Action<T> call) => calls += call;
        public void Invoke(T value) { if (calls != null) calls(value); }
    }
}
