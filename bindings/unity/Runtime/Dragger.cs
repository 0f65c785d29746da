using UnityEngine;

namespace DragMesh.Unity
{
    /// <summary>Lets the mouse drag the parts of every Openable: on the camera.</summary>
    [RequireComponent(typeof(UnityEngine.Camera))]
    public sealed class Dragger : MonoBehaviour
    {
        private Openable held;
        private uint part;

        private void Update()
        {
            UnityEngine.Ray ray = GetComponent<UnityEngine.Camera>().ScreenPointToRay(Input.mousePosition);
            if (Input.GetMouseButtonDown(0)) Grab(ray);
            if (held == null) return;
            if (Input.GetMouseButton(0))
            {
                held.Pull(part, ray, Time.deltaTime);
                return;
            }
            held.Release(part);
            held = null;
        }

        private void Grab(UnityEngine.Ray ray)
        {
            float nearest = float.PositiveInfinity, distance;
            Hit hit, best = Hit.New();
            Openable found = null;
            foreach (Openable openable in Openable.Enabled)
            {
                if (!openable.Raycast(ray, out hit, out distance) || distance >= nearest) continue;
                nearest = distance;
                best = hit;
                found = openable;
            }
            if (found == null || !found.Grab(best)) return;
            held = found;
            part = best.PartId;
        }
    }
}
