using System;
using System.Collections.Generic;
using UnityEngine;

namespace DragMesh.Unity
{
    /// <summary>Prepares an Openable from the meshes of its nodes. The editor calls it; a game may, for models that its
    /// players bring along, where it has the weights.</summary>
    public static class Baker
    {
        /// <summary>Where the editor finds the weights of the package.</summary>
        public const string EditorWeights = "Packages/com.dragmesh.unity/Models~";

        /// <summary>Makes every node with a mesh a part, but the one with the largest box, which is the body.</summary>
        public static void FindParts(Openable openable)
        {
            MeshFilter[] nodes = openable.GetComponentsInChildren<MeshFilter>();
            MeshFilter body = null;
            float largest = -1;
            foreach (MeshFilter node in nodes)
            {
                Vector3 size = Vector3.Scale(node.sharedMesh.bounds.size, node.transform.lossyScale);
                if (size.sqrMagnitude <= largest) continue;
                largest = size.sqrMagnitude;
                body = node;
            }
            openable.parts.Clear();
            foreach (MeshFilter node in nodes)
                if (node != body)
                    openable.parts.Add(new OpenablePart { node = node.transform, id = (uint)openable.parts.Count + 1 });
            foreach (OpenablePart part in openable.parts)
            {
                OpenablePart carrier = PartOf(openable, part.node.parent);
                part.parent = carrier == null ? 0 : carrier.id;
            }
        }

        /// <summary>The part that a node belongs to: the nearest above it; null: the body.</summary>
        private static OpenablePart PartOf(Openable openable, Transform node)
        {
            for (; node != null && node != openable.transform; node = node.parent)
            {
                OpenablePart part = openable.parts.Find(p => p.node == node);
                if (part != null) return part;
            }
            return null;
        }

        /// <summary>Infers the joints. model: the weights, or null for geometry alone. progress: gets 0 .. 1 and returns
        /// false to cancel. Throws DragMeshException.</summary>
        public static byte[] Bake(Openable openable, Model model, Func<float, bool> progress)
        {
            List<Vec3> positions = new List<Vec3>();
            List<int> indices = new List<int>(), ids = new List<int>();
            MeshFilter[] nodes = openable.GetComponentsInChildren<MeshFilter>();
            foreach (MeshFilter node in nodes)
            {
                OpenablePart part = PartOf(openable, node.transform);
                Append(openable.transform, node, part == null ? 0 : (int)part.id, positions, indices, ids);
            }
            List<Part> parts = new List<Part>();
            bool hasPivots = !PivotsAreLost(nodes);
            foreach (OpenablePart part in openable.parts) parts.Add(Describe(openable.transform, part, hasPivots));
            Mesh mesh = new Mesh(positions.ToArray(), indices.ToArray(), ids.ToArray(), true);
            using (PreparedObject prepared = Host.Context.Prepare(
                       mesh, new PrepareOptions { Model = model, Parts = parts, Label = openable.name, Progress = progress }))
                return prepared.Save();
        }

        /// <summary>Whether all nodes stand at one place, as after an export that has applied their transforms.</summary>
        private static bool PivotsAreLost(MeshFilter[] nodes)
        {
            foreach (MeshFilter node in nodes)
                if (Vector3.Distance(node.transform.position, nodes[0].transform.position) > 0) return false;
            return nodes.Length > 1;
        }

        private static void Append(Transform root, MeshFilter node, int id, List<Vec3> positions, List<int> indices, List<int> ids)
        {
            int first = positions.Count;
            foreach (Vector3 vertex in node.sharedMesh.vertices)
                positions.Add(Host.From(root.InverseTransformPoint(node.transform.TransformPoint(vertex))));
            int[] triangles = node.sharedMesh.triangles;
            foreach (int index in triangles) indices.Add(first + index);
            for (int face = 0; face < triangles.Length / 3; face++) ids.Add(id);
        }

        /// <summary>What the names and pivots of the nodes tell.</summary>
        private static unsafe Part Describe(Transform root, OpenablePart part, bool hasPivot)
        {
            string label = part.node.name;
            for (Transform above = part.node.parent; above != null; above = above == root ? null : above.parent)
                label = above.name + "/" + label;
            Pivot pivot = default(Pivot);
            pivot.Origin = Host.From(root.InverseTransformPoint(part.node.position));
            Vector3[] axes = { part.node.right, part.node.up, part.node.forward };
            for (int i = 0; i < 3; i++)
            {
                Vector3 axis = root.InverseTransformDirection(axes[i]);
                pivot.Axes[3 * i] = axis.x;
                pivot.Axes[3 * i + 1] = axis.y;
                pivot.Axes[3 * i + 2] = axis.z;
            }
            Part described = new Part { Id = part.id, Parent = part.parent, JointType = part.jointType, Label = label };
            if (hasPivot) described.Pivot = pivot;
            return described;
        }
    }
}
