// A stub of the part of the Unity editor's API that the package calls: to compile it. Nothing of it runs.
using System;
using UnityEngine;

namespace UnityEditor
{
    public class Editor : UnityEngine.Object
    {
        public UnityEngine.Object target { get; set; }
        public virtual void OnInspectorGUI() { }
        public bool DrawDefaultInspector() => false;
    }
    public sealed class CustomEditor : Attribute { public CustomEditor(Type type) { } }
    public sealed class MenuItem : Attribute { public MenuItem(string path) { } }

    public static class Handles
    {
        public delegate void CapFunction(int id, Vector3 position, Quaternion rotation, float size, EventType type);
        public static Matrix4x4 matrix { get; set; }
        public static Color color { get; set; }
        public static void DrawLine(Vector3 from, Vector3 to) { }
        public static void DrawWireArc(Vector3 centre, Vector3 normal, Vector3 from, float angle, float radius) { }
        public static bool Button(Vector3 at, Quaternion turn, float size, float pickSize, CapFunction cap) => false;
        public static void SphereHandleCap(int id, Vector3 position, Quaternion rotation, float size, EventType type) { }
    }
    public enum EventType { }

    public class AssetImporter : UnityEngine.Object
    {
        public string userData { get; set; }
        public static AssetImporter GetAtPath(string path) => null;
        public void SaveAndReimport() { }
    }
    public class ModelImporter : AssetImporter { }
    public class AssetPostprocessor
    {
        public string assetPath { get; set; }
        public AssetImporter assetImporter => null;
        public AssetImporters.AssetImportContext context => null;
    }

    public static class AssetDatabase
    {
        public static string GetAssetPath(UnityEngine.Object asset) => null;
        public static void CreateAsset(UnityEngine.Object asset, string path) { }
        public static string GenerateUniqueAssetPath(string path) => path;
    }
    public static class EditorUtility
    {
        public static bool DisplayCancelableProgressBar(string title, string text, float done) => false;
        public static void ClearProgressBar() { }
        public static bool DisplayDialog(string title, string message, string ok) => true;
        public static void SetDirty(UnityEngine.Object target) { }
    }
    public static class EditorGUILayout { public static void LabelField(string label, string text) { } }
    public static class Selection { public static UnityEngine.Object[] objects => new UnityEngine.Object[0]; }
    public static class Undo { public static void RecordObject(UnityEngine.Object target, string name) { } }
}

namespace UnityEditor.AssetImporters
{
    public class AssetImportContext
    {
        public void AddObjectToAsset(string id, UnityEngine.Object asset) { }
        public void LogImportWarning(string text) { }
    }
}
