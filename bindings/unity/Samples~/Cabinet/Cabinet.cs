using System.Collections.Generic;
using DragMesh.Unity;
using UnityEngine;

/// <summary>Builds a cabinet of boxes, with a door and a drawer as nodes of their own, and makes it openable.</summary>
public sealed class Cabinet : MonoBehaviour
{
    // From x, y, z to x, y, z; metres, y up, the front faces -z.
    private static readonly float[][] body = {
        new[] { 0f, 0, 0, 0.6f, 0.02f, -0.4f },      new[] { 0f, 0.98f, 0, 0.6f, 1, -0.42f },
        new[] { 0f, 0.02f, 0, 0.02f, 0.98f, -0.4f }, new[] { 0.58f, 0.02f, 0, 0.6f, 0.98f, -0.4f },
        new[] { 0.02f, 0.02f, 0, 0.58f, 0.98f, -0.02f } };
    private static readonly float[][] door = {
        new[] { 0f, 0, -0.402f, 0.6f, 0.79f, -0.42f }, new[] { 0.54f, 0.35f, -0.42f, 0.56f, 0.55f, -0.45f } };
    private static readonly float[][] drawer = {
        new[] { 0f, 0.8f, -0.402f, 0.6f, 0.97f, -0.42f },        new[] { 0.25f, 0.87f, -0.42f, 0.35f, 0.89f, -0.45f },
        new[] { 0.04f, 0.82f, -0.03f, 0.56f, 0.83f, -0.402f },   new[] { 0.04f, 0.83f, -0.03f, 0.05f, 0.95f, -0.402f },
        new[] { 0.55f, 0.83f, -0.03f, 0.56f, 0.95f, -0.402f },   new[] { 0.05f, 0.83f, -0.03f, 0.55f, 0.95f, -0.04f } };
    private static readonly int[] corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };

    public Material material;

    private void Awake()
    {
        Build(gameObject, Baker.EditorWeights);
    }

    /// <summary>Adds the nodes and a prepared Openable to an object. weights: their folder, which a built game has not:
    /// it comes with prepared assets.</summary>
    public static Openable Build(GameObject root, string weights)
    {
        root.SetActive(false);
        Add(root, "body", body);
        Add(root, "door", door);
        Add(root, "drawer", drawer);
        Openable openable = root.AddComponent<Openable>();
        Baker.FindParts(openable);
        openable.prepared = ScriptableObject.CreateInstance<PreparedAsset>();
        using (DragMesh.Model model = Host.Context.LoadModel(weights)) openable.prepared.dmo = Baker.Bake(openable, model, null);
        root.SetActive(true);
        return openable;
    }

    private static void Add(GameObject root, string name, float[][] boxes)
    {
        List<Vector3> vertices = new List<Vector3>();
        List<int> triangles = new List<int>();
        foreach (float[] box in boxes)
        {
            foreach (int corner in corners) // vertices of their own, so that normals are flat
            {
                triangles.Add(vertices.Count);
                vertices.Add(new Vector3(box[(corner & 1) != 0 ? 3 : 0], box[(corner & 2) != 0 ? 4 : 1], box[(corner & 4) != 0 ? 5 : 2]));
            }
        }
        GameObject node = new GameObject(name);
        node.transform.SetParent(root.transform, false);
        Mesh mesh = new Mesh { vertices = vertices.ToArray(), triangles = triangles.ToArray() };
        mesh.RecalculateNormals();
        mesh.RecalculateBounds();
        node.AddComponent<MeshFilter>().sharedMesh = mesh;
        Cabinet owner = root.GetComponent<Cabinet>();
        if (owner != null) node.AddComponent<MeshRenderer>().sharedMaterial = owner.material;
    }
}
