using UnityEngine;

namespace DragMesh.Unity
{
    /// <summary>The bytes of a .dmo: an object whose joints are known. Instances share it.</summary>
    public sealed class PreparedAsset : ScriptableObject
    {
        [HideInInspector] public byte[] dmo;
    }
}
