// The Unity package on the stub of its API: the sample's cabinet, a scaled and turned one, is dragged with the mouse.
using System;
using System.IO;
using DragMesh;
using DragMesh.Unity;
using UnityEngine;

static class Test
{
    private static void Must(bool holds, string what)
    {
        if (holds) return;
        Console.Error.WriteLine("unity: " + what);
        Environment.Exit(1);
    }

    private static bool Near(Vector3 a, Vector3 b) => Vector3.Distance(a, b) < 1e-3f;

    private static void Frame(Dragger dragger, Openable openable)
    {
        GameObject.Call(dragger, "Update");
        GameObject.Call(openable, "Update");
    }

    // Drags a point of the cabinet, given in its frame, to where the pointer sees another.
    private static void Pull(Dragger dragger, Openable openable, Vector3 from, Vector3 to)
    {
        Vector3 eye = openable.transform.TransformPoint(new Vector3(0.9f, 1.4f, -2.5f));
        for (int frame = 0; frame < 120; frame++)
        {
            Vector3 at = openable.transform.TransformPoint(from + (to - from) * Math.Min(frame / 60f, 1));
            UnityEngine.Camera.next = new UnityEngine.Ray(eye, at - eye);
            Input.down = frame == 0;
            Input.held = true;
            Frame(dragger, openable);
        }
    }

    // What the editor bakes from the nodes is what the package's build step has baked from the boxes.
    private static void Bakes(Openable openable, string weights)
    {
        using (Model model = Host.Context.LoadModel(weights))
        using (PreparedObject baked = Host.Context.Load(Baker.Bake(openable, model, null)))
        {
            foreach (OpenablePart part in openable.parts)
            {
                DragMesh.Joint here = baked.JointOf(part.id), there = openable.Object.JointOf(part.id);
                Must(here.Kind == there.Kind && there.JointConfidence > 0.5f, "the baked " + part.node.name);
                Must(Near(Host.To(here.Axis), Host.To(there.Axis)), "the baked axis of the " + part.node.name);
                Must(Math.Abs(here.Upper - there.Upper) < 0.05f, "the baked limit of the " + part.node.name);
            }
        }
    }

    // What an inspector or a script may do wrong is an exception, or does nothing.
    private static void Misuse(Openable openable)
    {
        PartState state = openable.State(1);
        foreach (Action call in new Action[] { () => openable.State(99), () => openable.Restore(99, state) })
        {
            bool thrown = false;
            try { call(); } catch (ArgumentException) { thrown = true; }
            Must(thrown, "a part that is not there");
        }
        openable.Pull(99, new UnityEngine.Ray(Vector3.up, Vector3.up), 0.01f);
        openable.Release(99);
        openable.Move(99, Intent.Open);
        Hit nothing = Hit.New();
        nothing.PartId = 99;
        Must(!openable.Grab(nothing), "a hit of nothing");
        foreach (OpenablePart part in openable.parts) part.parent = 3 - part.id; // they carry each other
        openable.Restore(1, state);
        openable.parts[0].parent = 1; // itself
        openable.Restore(1, state);
        foreach (OpenablePart part in openable.parts) part.parent = 0;
        openable.opened.AddListener(part => openable.gameObject.SetActive(false)); // in the middle of its own update
        openable.Move(2, Intent.Open);
        for (int frame = 0; frame < 200; frame++) GameObject.Call(openable, "Update");
        Must(openable.Object == null && !openable.Grab(nothing), "disabled by its own event");
    }

    static void Main(string[] arguments)
    {
        GameObject root = new GameObject("cabinet");
        root.transform.localPosition = new Vector3(3, -1, 2);
        root.transform.localRotation = Quaternion.AngleAxis(30, Vector3.up);
        root.transform.localScale = new Vector3(2, 2, 2);
        Openable openable = Cabinet.Build(root, File.ReadAllBytes(arguments[1]));
        Must(openable.parts.Count == 2 && openable.parts[0].node.name == "door", "parts");
        Must(openable.Object.JointOf(1).Kind == JointType.Revolute, "the door turns");
        Must(openable.Object.JointOf(2).Kind == JointType.Prismatic, "the drawer slides");
        Bakes(openable, arguments[0]);
        int events = 0;
        uint opened = 0, closed = 0;
        openable.Happened += (part, what) => events++;
        openable.opened.AddListener(part => opened = part);
        openable.closed.AddListener(part => closed = part);
        Dragger dragger = new GameObject("camera").AddComponent<Dragger>();
        dragger.gameObject.AddComponent<UnityEngine.Camera>();

        Transform drawer = openable.parts[1].node;
        Vector3 rest = drawer.position;
        Vector3 front = new Vector3(0.3f, 0.94f, -0.42f);
        Pull(dragger, openable, front, front + new Vector3(0, 0, -0.25f));
        Must(Near(drawer.position, rest + root.transform.rotation * new Vector3(0, 0, -0.5f)), "the drawer follows the pointer");
        Must(opened == 2 && events > 0, "the drawer's events");
        PartState kept = openable.State(2);
        uint[] learnt = kept.Joint.PullEvidence;
        Must(learnt[0] != 0, "the pull has said something");
        Input.held = Input.down = false;
        Frame(dragger, openable);
        openable.Move(2, Intent.Close);
        for (int frame = 0; frame < 200; frame++) Frame(dragger, openable);
        Must(Near(drawer.position, rest) && closed == 2, "the drawer closes");
        openable.Restore(2, kept);
        Must(Near(drawer.position, rest + root.transform.rotation * new Vector3(0, 0, -0.5f)), "the drawer is restored");
        Must(string.Join(" ", openable.State(2).Joint.PullEvidence) == string.Join(" ", learnt), "what pulls have said is restored");

        Transform door = openable.parts[0].node;
        Vector3 knob = door.TransformPoint(new Vector3(0.55f, 0.45f, -0.45f));
        openable.Move(1, Intent.Open);
        for (int frame = 0; frame < 300; frame++) Frame(dragger, openable);
        Vector3 hinge = root.transform.TransformPoint(new Vector3(0, 0.45f, -0.41f));
        Vector3 now = door.TransformPoint(new Vector3(0.55f, 0.45f, -0.45f));
        Must(Vector3.Distance(now, knob) > 0.5f, "the door opens");
        Must(Math.Abs(Vector3.Distance(now, hinge) - Vector3.Distance(knob, hinge)) < 0.1f, "the door turns about its hinge");

        for (int play = 0; play < 3; play++)
        {
            root.SetActive(false); // play, stop, reload
            Must(openable.Object == null && Openable.Enabled.Count == 0, "disabled");
            Host.End();
            root.SetActive(true);
            Must(openable.Object.JointOf(1).Kind == JointType.Revolute, "enabled again");
        }
        Application.Quit();
        Must(openable.Object.IsEnded, "the context outlives the game");
        root.SetActive(false);
        GameObject other = new GameObject("misused");
        Misuse(Cabinet.Build(other, File.ReadAllBytes(arguments[1])));
        Console.WriteLine("Unity: the package runs on the stub");
    }
}
