// The common scenario through DragMesh: prints what bindings/scenario/scenario.c prints. Scenario WEIGHTS_FOLDER
using System;
using System.Text;
using DragMesh;

static class Scenario
{
    private const int Frames = 60, ShownEvery = 10, SavedAt = 30, ReleasedFrames = 120, HandleTurnsAt = 25;
    private const float FrameTime = 1.0f / 60;
    private const float HandleTurn = 1, Widest = 0.45f; // rad
    private const uint Door = 1, Drawer = 2;

    // From x, y, z to x, y, z, and the part: samples/common/cabinet.h.
    private static readonly float[,] boxes = {
        { 0.00f, 0.00f, 0.000f, 0.60f, 0.02f, 0.40f, 0 },     { 0.00f, 0.98f, 0.000f, 0.60f, 1.00f, 0.42f, 0 },
        { 0.00f, 0.02f, 0.000f, 0.02f, 0.98f, 0.40f, 0 },     { 0.58f, 0.02f, 0.000f, 0.60f, 0.98f, 0.40f, 0 },
        { 0.02f, 0.02f, 0.000f, 0.58f, 0.98f, 0.02f, 0 },     { 0.00f, 0.00f, 0.402f, 0.60f, 0.79f, 0.42f, Door },
        { 0.54f, 0.35f, 0.420f, 0.56f, 0.55f, 0.45f, Door },  { 0.00f, 0.80f, 0.402f, 0.60f, 0.97f, 0.42f, Drawer },
        { 0.25f, 0.87f, 0.420f, 0.35f, 0.89f, 0.45f, Drawer }, { 0.04f, 0.82f, 0.030f, 0.56f, 0.83f, 0.402f, Drawer },
        { 0.04f, 0.83f, 0.030f, 0.05f, 0.95f, 0.402f, Drawer }, { 0.55f, 0.83f, 0.030f, 0.56f, 0.95f, 0.402f, Drawer },
        { 0.05f, 0.83f, 0.030f, 0.55f, 0.95f, 0.040f, Drawer },
    };
    private static readonly ushort[] corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                                 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };

    private static Mesh MakeCabinet(int boxCount)
    {
        Vec3[] positions = new Vec3[boxes.GetLength(0) * 8];
        byte[] parts = new byte[positions.Length];
        ushort[] indices = new ushort[boxCount * 36];
        for (int v = 0; v < positions.Length; v++)
        {
            int b = v / 8;
            positions[v] = new Vec3(boxes[b, (v & 1) != 0 ? 3 : 0], boxes[b, (v & 2) != 0 ? 4 : 1],
                                    boxes[b, (v & 4) != 0 ? 5 : 2]);
            parts[v] = (byte)boxes[b, 6];
        }
        for (int i = 0; i < indices.Length; i++) indices[i] = (ushort)(i / 36 * 8 + corners[i % 36]);
        return new Mesh(positions, indices, parts);
    }

    private static Ray RayAt(int frame)
    {
        Ray ray = new Ray(new Vec3(0.9f, 0.9f, 2.0f), new Vec3(-0.35f, -0.45f, -1.55f));
        ray.Direction.X = (float)(ray.Direction.X - (float)(0.01f * frame));
        ray.Direction.Z = (float)(ray.Direction.Z + (float)(0.005f * frame));
        return ray;
    }

    private static unsafe void Print(string name, params float[] values)
    {
        StringBuilder line = new StringBuilder(name);
        foreach (float value in values)
        {
            float one = value;
            line.Append(' ').Append((*(uint*)&one).ToString("x8"));
        }
        Console.WriteLine(line);
    }

    private static void Print(Joint j)
    {
        Console.WriteLine("joint {0} source {1}", j.Type, j.Source);
        Print(" ", j.Axis.X, j.Axis.Y, j.Axis.Z, j.Origin.X, j.Origin.Y, j.Origin.Z, j.Lower, j.Upper, j.TypeConfidence,
              j.JointConfidence);
    }

    private static unsafe void Print(Pose pose)
    {
        Print(" ", pose.Real[0], pose.Real[1], pose.Real[2], pose.Real[3]);
        Print(" ", pose.Dual[0], pose.Dual[1], pose.Dual[2], pose.Dual[3]);
    }

    private static void Print(string name, DragState state)
    {
        Console.WriteLine("{0} phase {1} events {2} changes {3} basis {4}", name, state.Phase, state.Events, state.Changes,
            state.JointBasis);
        Print(" ", state.Value, state.JointConfidence);
        Print(state.Pose);
    }

    private static void PrintHypotheses(PreparedObject cabinet, uint part)
    {
        Joint[] all = cabinet.Hypotheses(part);
        Console.WriteLine("part {0} hypotheses {1}", part, all.Length);
        Print(cabinet.JointOf(part));
        foreach (Joint joint in all) Print(joint);
    }

    private static Hit Pick(Context context, PreparedObject cabinet)
    {
        using (Scene scene = context.NewScene())
        {
            Hit hit;
            scene.Add(cabinet);
            scene.Commit();
            scene.Pick(RayAt(0), out hit);
            Console.WriteLine("picked part {0} triangle {1}", hit.PartId, hit.Triangle);
            Print(" ", hit.ObjectPoint.X, hit.ObjectPoint.Y, hit.ObjectPoint.Z);
            return hit;
        }
    }

    private static void DragAndRelease(PreparedObject cabinet, Hit hit)
    {
        DragDesc desc = DragDesc.New();
        DragState state = DragState.New();
        byte[] saved = new byte[Drag.SnapshotSize];
        PartState kept;
        desc.PartId = hit.PartId;
        desc.GrabPoint = hit.ObjectPoint;
        using (Drag drag = cabinet.Grab(desc, DragRules.New()))
        {
            uint events = 0;
            for (int frame = 0; frame < Frames; frame++)
            {
                state = drag.Update(RayAt(frame), FrameTime);
                events |= state.Events;
                if (frame % ShownEvery == 0) Print("frame", state);
                if (frame == SavedAt) drag.Save(saved);
            }
            drag.Restore(saved);
            Print("restored", drag.Update(RayAt(Frames), FrameTime));
            ReleaseDesc release = ReleaseDesc.New();
            release.Intent = (int)Go.Open;
            release.Flags = Constants.DM_RELEASE_BY_RULE;
            Print("plan", drag.Release(release).EndValue);
            for (int frame = 0; frame < ReleasedFrames; frame++)
            {
                state = drag.Update(FrameTime);
                events |= state.Events;
            }
            state.Events = events;
            Print("released", state);
            kept = drag.Finish();
        }
        desc.GrabPoint = state.GrabPoint;
        PartState again = cabinet.Grab(desc, DragRules.New(), kept).Finish();
        Print("again", again.Value);
        Print(again.Pose);
        Console.WriteLine("evidence " + string.Join(" ", again.Joint.PullEvidence));
    }

    private static unsafe void DragBehindLatch(PreparedObject cabinet, Hit hit)
    {
        DragRules rules = DragRules.New();
        DragDesc desc = DragDesc.New();
        DragInput input = DragInput.New();
        DragState state = DragState.New();
        uint events = 0, detents = 0;
        rules.Flags = Constants.DM_RULE_LATCH;
        desc.PartId = hit.PartId;
        desc.GrabPoint = hit.ObjectPoint;
        input.Flags = Constants.DM_INPUT_ASK;
        input.Hand.Kind = (int)HandKind.Ray;
        using (Drag drag = cabinet.Grab(desc, rules, null, new[] { 0.2f, 0.4f }))
        {
            for (int frame = 0; frame < Frames; frame++)
            {
                input.Hand.Ray = RayAt(frame);
                input.Handles[0] = frame < HandleTurnsAt ? 0 : HandleTurn;
                state = drag.UpdateInput(input, FrameTime);
                if (state.Value > Widest) state = drag.Override(Widest);
                events |= state.Events;
                detents += state.Detents;
                if (frame % ShownEvery == 0) Print("latch", state);
            }
        }
        state.Events = events;
        Print("latched", state);
        Console.WriteLine("detents {0}", detents);
    }

    private static void FollowLinks(PreparedObject cabinet)
    {
        float[] values = { -0.9f, 0 };
        byte[] held = new byte[2];
        cabinet.SetLinks(new[] { new Link { Driver = Door, Driven = Drawer, Ratio = 0.25f, From = 0.1f },
                                 new Link { Driver = Drawer, Driven = Door, Kind = Constants.DM_LINK_HOLDS, From = 0.05f } });
        for (int i = 0; i < 2; i++)
        {
            cabinet.FollowLinks(Door, values, held);
            Print("linked", values);
            Console.WriteLine("held {0} {1}", held[0], held[1]);
            values[0] = 0.9f;
        }
    }

    private static void SaveAndLoad(Context context, PreparedObject cabinet)
    {
        byte[] data = cabinet.Save();
        uint hash = 2166136261; // FNV-1a
        foreach (byte b in data) hash = unchecked((hash ^ b) * 16777619);
        Console.WriteLine("saved {0} bytes {1:x8}", data.Length, hash);
        Print(context.Load(data).JointOf(Door));
    }

    public static void Main(string[] arguments)
    {
        Layout.Check();
        using (Context context = new Context())
        {
            Model model = context.LoadModel(arguments[0]);
            PreparedObject cabinet = context.Prepare(MakeCabinet(boxes.GetLength(0)), new PrepareOptions {
                Model = model,
                Parts = new[] { new Part { Id = Door, Label = "kitchen/cabinet/door" },
                                new Part { Id = Drawer, Label = "kitchen/cabinet/drawer" } } });
            PrintHypotheses(cabinet, Door);
            PrintHypotheses(cabinet, Drawer);
            Hit hit = Pick(context, cabinet);
            DragAndRelease(cabinet, hit);
            DragBehindLatch(cabinet, hit);
            FollowLinks(cabinet);
            SaveAndLoad(context, cabinet);
            try
            {
                context.Prepare(MakeCabinet(1)); // one box, without any part
            }
            catch (DragMeshException error)
            {
                Console.WriteLine("error " + error.Name);
            }
        }
    }
}
