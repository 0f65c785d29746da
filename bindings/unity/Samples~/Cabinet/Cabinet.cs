using System.Collections.Generic;
using DragMesh.Unity;
using UnityEngine;

/// <summary>Builds a cabinet of boxes, with a door and a drawer as nodes of their own, and makes it openable.</summary>
public sealed class Cabinet : MonoBehaviour
{
    public Material material;
    /// <summary>The prepared cabinet, which the package's build step has baked with the weights.</summary>
    public TextAsset dmo;

    private void Awake()
    {
        Build(gameObject, dmo.bytes);
    }

    /// <summary>Adds the nodes and a prepared Openable to an object.</summary>
    public static Openable Build(GameObject root, byte[] dmo)
    {
        root.SetActive(false);
        Add(root, "body", CabinetBoxes.Body);
        Add(root, "door", CabinetBoxes.Door);
        Add(root, "drawer", CabinetBoxes.Drawer);
        Openable openable = root.AddComponent<Openable>();
        Baker.FindParts(openable);
        openable.prepared = ScriptableObject.CreateInstance<PreparedAsset>();
        openable.prepared.dmo = dmo;
        root.SetActive(true);
        return openable;
    }

    private static void Add(GameObject root, string name, float[][] boxes)
    {
        List<Vector3> vertices = new List<Vector3>();
        List<int> triangles = new List<int>();
        foreach (float[] box in boxes)
        {
            for (int i = 0; i < CabinetBoxes.CornerCount; i++) // vertices of their own, so that normals are flat
            {
                triangles.Add(vertices.Count);
                vertices.Add(new Vector3(CabinetBoxes.At(box, i, 0), CabinetBoxes.At(box, i, 1), CabinetBoxes.At(box, i, 2)));
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
