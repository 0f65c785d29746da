using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace DragMesh.Unity
{
    /// <summary>Makes an object openable. Its object frame is that of its transform, whose scale should be uniform. It
    /// moves the transforms of its parts.</summary>
    [DisallowMultipleComponent]
    public sealed class Openable : MonoBehaviour
    {
        [Serializable] public sealed class PartEvent : UnityEvent<uint> { }

        public PreparedAsset prepared;
        public List<OpenablePart> parts = new List<OpenablePart>();
        public PartEvent opened = new PartEvent(), closed = new PartEvent();
        /// <summary>Gets everything that happens to a part, in the frame in which it does.</summary>
        public event Action<OpenablePart, DragEvents> Happened;

        private PreparedObject loaded;
        private Scene scene;
        private uint instance;

        /// <summary>All that are enabled now.</summary>
        public static readonly List<Openable> Enabled = new List<Openable>();

        /// <summary>Parts and their joints; null while there is no prepared asset or the component is disabled.</summary>
        public PreparedObject Object => loaded;

        private void OnEnable()
        {
            foreach (OpenablePart part in parts) KeepRest(part);
            Enabled.Add(this);
            if (prepared != null) Load();
        }

        private void OnDisable()
        {
            Enabled.Remove(this);
            foreach (OpenablePart part in parts) Let(part);
            if (scene != null) scene.Dispose();
            if (loaded != null) loaded.Dispose();
            scene = null;
            loaded = null;
        }

        private void Load()
        {
            loaded = Host.Context.Load(prepared.dmo);
            scene = Host.Context.NewScene();
            instance = scene.Add(loaded);
            scene.Commit();
        }

        private void KeepRest(OpenablePart part)
        {
            part.restPosition = transform.InverseTransformPoint(part.node.position);
            part.restRotation = Quaternion.Inverse(transform.rotation) * part.node.rotation;
            part.moved = false;
        }

        public OpenablePart Find(uint id) => parts.Find(part => part.id == id);

        private OpenablePart Known(uint id)
        {
            OpenablePart part = Find(id);
            if (part == null || loaded == null) throw new ArgumentException("no part " + id + " that is prepared and enabled");
            return part;
        }

        /// <summary>The nearest part or the body along a ray of the world. distance: in the world.</summary>
        public bool Raycast(UnityEngine.Ray ray, out Hit hit, out float distance)
        {
            distance = 0;
            hit = Hit.New();
            if (scene == null || !scene.Pick(ToObject(ray), out hit)) return false;
            distance = Vector3.Distance(ray.origin, transform.TransformPoint(Host.To(hit.ObjectPoint)));
            return true;
        }

        /// <summary>Grabs the part of a hit; false: it is the body, or is held already.</summary>
        public bool Grab(Hit hit)
        {
            OpenablePart part = Find(hit.PartId);
            if (part == null || part.held || loaded == null) return false;
            Let(part);
            DragDesc desc = DragDesc.New();
            desc.PartId = part.id;
            desc.GrabPoint = Carrier(part).Inverse.Apply(hit.ObjectPoint);
            part.drag = loaded.Grab(desc, DragRules.New(), part.moved ? part.state : (PartState?)null);
            part.held = true;
            return true;
        }

        /// <summary>The grabbed point follows a ray of the world.</summary>
        public void Pull(uint id, UnityEngine.Ray ray, float seconds)
        {
            OpenablePart part = Find(id);
            if (part == null || !part.held) return;
            Ray local = ToObject(ray);
            Pose back = Carrier(part).Inverse;
            Vec3 tip = back.Apply(new Vec3(local.Origin.X + local.Direction.X, local.Origin.Y + local.Direction.Y,
                                           local.Origin.Z + local.Direction.Z));
            Vec3 origin = back.Apply(local.Origin);
            Ray pulled = new Ray(origin, new Vec3(tip.X - origin.X, tip.Y - origin.Y, tip.Z - origin.Z));
            Take(part, part.drag.Update(pulled, seconds));
        }

        /// <summary>Lets go. The part then moves on by itself.</summary>
        public void Release(uint id, Go what = Go.Auto)
        {
            OpenablePart part = Find(id);
            if (part == null || !part.held) return;
            ReleaseDesc desc = ReleaseDesc.New();
            desc.Intent = (int)what;
            desc.Flags = Constants.DM_RELEASE_BY_RULE; // the same on every machine, without weights
            part.drag.Release(desc);
            part.held = false;
        }

        public void Release(uint id, Intent what) => Release(id, (Go)what);

        /// <summary>Opens or closes a part by itself, as a player's release does.</summary>
        public void Move(uint id, Go what)
        {
            OpenablePart part = Find(id);
            if (part == null || part.held || loaded == null) return;
            Let(part);
            DragDesc desc = DragDesc.New();
            desc.PartId = part.id;
            desc.Flags = Constants.DM_DRAG_WITHOUT_POINT;
            part.drag = loaded.Grab(desc, DragRules.New(), part.moved ? part.state : (PartState?)null);
            part.held = true;
            Release(id, what);
        }

        public void Move(uint id, Intent what) => Move(id, (Go)what);

        /// <summary>What to save of a part, and what Restore takes back.</summary>
        public PartState State(uint id)
        {
            OpenablePart part = Known(id);
            if (part.drag != null) return part.drag.PartState();
            if (part.moved) return part.state;
            PartState rest = PartState.New();
            rest.Joint = loaded.JointOf(id);
            rest.Pose = Pose.Identity;
            return rest;
        }

        public void Restore(uint id, PartState state)
        {
            OpenablePart part = Known(id);
            Let(part);
            part.state = state;
            part.state.Pose = state.Joint.PoseAt(state.Value);
            part.moved = true;
            Show();
        }

        private void Update()
        {
            foreach (OpenablePart part in parts)
            {
                if (part.drag == null || part.held) continue;
                DragState state = part.drag.Update(Time.deltaTime);
                Take(part, state);
                if (state.Doing == DragPhase.AtRest) Let(part);
            }
        }

        /// <summary>Ends a drag and keeps what the instance keeps.</summary>
        private void Let(OpenablePart part)
        {
            if (part.drag == null) return;
            if (!part.drag.IsEnded && !loaded.IsEnded) part.state = part.drag.Finish();
            part.drag = null;
            part.held = false;
        }

        private void Take(OpenablePart part, DragState state)
        {
            part.state.Pose = state.Pose;
            part.moved = true;
            Show();
            DragEvents events = state.Happened;
            if (events == DragEvents.None) return;
            if ((events & DragEvents.Opened) != 0) opened.Invoke(part.id);
            if ((events & DragEvents.Closed) != 0) closed.Invoke(part.id);
            if (Happened != null) Happened(part, events);
        }

        /// <summary>The pose of what carries a part. Carriers that carry each other, which the inspector allows, are gone
        /// through once.</summary>
        private Pose Carrier(OpenablePart part)
        {
            Pose pose = Pose.Identity;
            OpenablePart carrier = Find(part.parent);
            for (int above = 0; carrier != null && above < parts.Count; above++, carrier = Find(carrier.parent))
                pose = carrier.Own * pose;
            return pose;
        }

        private void Show()
        {
            foreach (OpenablePart part in parts)
            {
                Pose pose = Carrier(part) * part.Own;
                Vector3 position = Host.To(pose.Apply(Host.From(part.restPosition)));
                part.node.SetPositionAndRotation(transform.TransformPoint(position),
                                                 transform.rotation * Host.Rotation(pose) * part.restRotation);
                if (scene != null) scene.Move(instance, part.id, pose);
            }
            if (scene != null) scene.Commit();
        }

        private Ray ToObject(UnityEngine.Ray ray) => new Ray(Host.From(transform.InverseTransformPoint(ray.origin)),
                                                              Host.From(transform.InverseTransformVector(ray.direction)));
    }
}
