using UnityEditor;
using UnityEngine;

namespace DragMesh.Unity.Editor
{
    /// <summary>Bakes models that are marked so by Assets > dragmesh > Make openable: the prefab gets an Openable, and the
    /// bytes of its .dmo lie beside it in the imported asset.</summary>
    public sealed class BakeOnImport : AssetPostprocessor
    {
        private const string Mark = "dragmesh";

        private void OnPostprocessModel(GameObject root)
        {
            if (assetImporter.userData != Mark) return;
            Openable openable = root.AddComponent<Openable>();
            Baker.FindParts(openable);
            try
            {
                openable.prepared = Bake(openable, root.name);
                context.AddObjectToAsset(Mark, openable.prepared);
            }
            catch (DragMeshException failure)
            {
                context.LogImportWarning("dragmesh: " + assetPath + ": " + failure.Message);
            }
        }

        /// <summary>Prepares an Openable under a progress bar. Throws DragMeshException.</summary>
        internal static PreparedAsset Bake(Openable openable, string name)
        {
            try
            {
                using (Model model = Host.Context.LoadModel(Baker.EditorWeights))
                {
                    PreparedAsset asset = ScriptableObject.CreateInstance<PreparedAsset>();
                    asset.name = name;
                    asset.dmo = Baker.Bake(openable, model, done =>
                        !EditorUtility.DisplayCancelableProgressBar("dragmesh", "Finds out how " + name + " moves", done));
                    return asset;
                }
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }
        }

        [MenuItem("Assets/dragmesh/Make openable")]
        private static void MakeOpenable()
        {
            foreach (Object asset in Selection.objects)
            {
                AssetImporter importer = AssetImporter.GetAtPath(AssetDatabase.GetAssetPath(asset));
                if (!(importer is ModelImporter)) continue;
                importer.userData = Mark;
                importer.SaveAndReimport();
            }
        }
    }
}
