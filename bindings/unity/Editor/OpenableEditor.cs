using UnityEditor;
using UnityEngine;

namespace DragMesh.Unity.Editor
{
    /// <summary>Shows the hypotheses of each part in the scene view. A click on one puts its joint in force.</summary>
    [CustomEditor(typeof(Openable))]
    public sealed class OpenableEditor : UnityEditor.Editor
    {
        private const float DotSize = 0.03f, AxisLength = 0.5f, ArcRadius = 0.3f; // of the object's size

        private PreparedObject shown;
        private PreparedAsset shownAsset;

        private void OnDisable()
        {
            if (shown != null) shown.Dispose();
            shown = null;
            shownAsset = null;
        }

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            Openable openable = (Openable)target;
            if (GUILayout.Button("Find parts"))
            {
                Undo.RecordObject(openable, "Find parts");
                Baker.FindParts(openable);
            }
            if (GUILayout.Button("Prepare")) Prepare(openable);
            if (Load(openable))
                foreach (OpenablePart part in openable.parts) DescribeJoint(part);
        }

        private void Prepare(Openable openable)
        {
            try
            {
                PreparedAsset asset = BakeOnImport.Bake(openable, openable.name);
                AssetDatabase.CreateAsset(asset, AssetDatabase.GenerateUniqueAssetPath("Assets/" + openable.name + " dmo.asset"));
                Undo.RecordObject(openable, "Prepare");
                openable.prepared = asset;
            }
            catch (DragMeshException failure)
            {
                EditorUtility.DisplayDialog("dragmesh", failure.Message, "OK");
            }
        }

        private void DescribeJoint(OpenablePart part)
        {
            Joint joint = shown.JointOf(part.id);
            EditorGUILayout.LabelField(part.node.name, string.Format("{0} {1:0.00} .. {2:0.00}, {3:0} % sure", joint.Kind,
                                                                     joint.Lower, joint.Upper, 100 * joint.JointConfidence));
        }

        /// <summary>Reads the asset anew where it is another one.</summary>
        private bool Load(Openable openable)
        {
            if (shown != null && shownAsset == openable.prepared) return true;
            OnDisable();
            if (openable.prepared == null || openable.prepared.dmo == null) return false;
            shown = Host.Context.Load(openable.prepared.dmo);
            shownAsset = openable.prepared;
            return true;
        }

        private void OnSceneGUI()
        {
            Openable openable = (Openable)target;
            if (!Load(openable)) return;
            float size = shown.Info().Size;
            Handles.matrix = openable.transform.localToWorldMatrix;
            foreach (OpenablePart part in openable.parts)
            {
                Joint force = shown.JointOf(part.id);
                Joint[] all = shown.Hypotheses(part.id);
                for (int i = all.Length - 1; i >= 0; i--) // the best on top
                    if (Draw(all[i], Color.Lerp(Color.yellow, Color.gray, i / (float)all.Length), size)) Choose(openable, part, all[i]);
                Draw(force, Color.green, size);
            }
        }

        /// <summary>Draws a joint; true: it was clicked.</summary>
        private static bool Draw(Joint joint, Color colour, float size)
        {
            Vector3 origin = Host.To(joint.Origin), axis = Host.To(joint.Axis);
            Handles.color = colour;
            if (joint.Kind == JointType.Prismatic)
            {
                Handles.DrawLine(origin + joint.Lower * axis, origin + joint.Upper * axis);
            }
            else
            {
                Vector3 from = Vector3.Cross(axis, Mathf.Abs(axis.y) < 0.9f ? Vector3.up : Vector3.right).normalized;
                Handles.DrawLine(origin - AxisLength * size * axis, origin + AxisLength * size * axis);
                Quaternion start = Quaternion.AngleAxis(joint.Lower * Mathf.Rad2Deg, axis);
                Handles.DrawWireArc(origin, axis, start * from, (joint.Upper - joint.Lower) * Mathf.Rad2Deg, ArcRadius * size);
            }
            return Handles.Button(origin, Quaternion.identity, DotSize * size, DotSize * size, Handles.SphereHandleCap);
        }

        private void Choose(Openable openable, OpenablePart part, Joint joint)
        {
            Undo.RecordObject(openable.prepared, "Choose joint");
            shown.SetJoint(part.id, joint);
            openable.prepared.dmo = shown.Save();
            EditorUtility.SetDirty(openable.prepared);
        }
    }
}
