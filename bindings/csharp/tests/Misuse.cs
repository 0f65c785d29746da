// What a host may do wrong with the layer of C#: an exception each time, and the context goes on. Misuse OBJECT.dmo
// WEIGHTS_FOLDER
using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using DragMesh;

static class Misuse
{
    private static readonly DragHint up = new DragHint(new Vec3(0.5f, 0.56f, 0.3f), new Vec3(0, 1, 0));
    private static byte[] dmo;
    private static string weights;
    private static int checks;

    private static void Must(bool holds, string what)
    {
        checks++;
        if (holds) return;
        Console.Error.WriteLine("misuse: " + what);
        Environment.Exit(1);
    }

    private static void Fails<T>(string what, Action call) where T : Exception
    {
        try
        {
            call();
        }
        catch (T)
        {
            checks++;
            return;
        }
        catch (Exception other)
        {
            Must(false, what + " threw " + other);
        }
        Must(false, what + " did not throw");
    }

    // Calls that the library itself refuses.
    private static void Refused(string what, Result code, Action call)
    {
        try
        {
            call();
        }
        catch (DragMeshException failure)
        {
            Must(failure.Code == code, what + ": " + failure.Message);
            return;
        }
        Must(false, what + " did not throw");
    }

    // A box with a lid that lies on it.
    private static readonly Vec3[] positions = new Vec3[16];
    private static readonly int[] indices = new int[72], parts = new int[24];

    private static void MakeChest()
    {
        float[,] boxes = { { 0, 0, 0, 1, 0.5f, 0.6f }, { 0, 0.51f, 0, 1, 0.56f, 0.6f } };
        int[] corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                          2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };
        for (int v = 0; v < 16; v++)
            positions[v] = new Vec3(boxes[v / 8, (v & 1) != 0 ? 3 : 0], boxes[v / 8, (v & 2) != 0 ? 4 : 1],
                                    boxes[v / 8, (v & 4) != 0 ? 5 : 2]);
        for (int i = 0; i < 72; i++) indices[i] = i / 36 * 8 + corners[i % 36];
        for (int f = 0; f < 24; f++) parts[f] = f / 12;
    }

    private static Mesh Chest() => new Mesh(positions, indices, parts, true);

    private static PreparedObject Prepare(Context context, Model model = null) =>
        context.Prepare(Chest(), new PrepareOptions { Model = model });

    private static DragDesc Lid()
    {
        DragDesc desc = DragDesc.New();
        desc.PartId = 1;
        desc.Flags = Constants.DM_DRAG_WITHOUT_POINT;
        return desc;
    }

    private static void Works(Context context)
    {
        using (PreparedObject chest = Prepare(context))
        using (Drag drag = chest.Grab(Lid()))
            Must(drag.Step(DragInput.New(), 0.01f).Doing == DragPhase.Held, "a context after misuse");
    }

    private static void Collect()
    {
        GC.Collect();
        GC.WaitForPendingFinalizers();
    }

    private static void Ends()
    {
        Context context = new Context();
        Model model = context.LoadModel(weights);
        PreparedObject chest = Prepare(context, model);
        Drag drag = chest.Grab(Lid());
        MotionDesc desc = MotionDesc.New();
        desc.PartId = 1;
        desc.Drag = up;
        Motion motion = chest.Generate(desc);
        Scene scene = context.NewScene();
        scene.Add(chest);
        model.Dispose();
        Refused("a motion without weights", Result.NoModel, () => chest.Generate(desc));
        Fails<ObjectDisposedException>("ended weights", () => Prepare(context, model));
        chest.Dispose();
        chest.Dispose();
        Fails<ObjectDisposedException>("an ended object in a scene", () => scene.Add(chest));
        Refused("a drag of an ended object", Result.StaleHandle, () => drag.Step(DragInput.New(), 0.01f));
        Refused("a motion of an ended object", Result.StaleHandle, () => { float value; motion.Sample(1, out value); });
        scene.Commit();
        context.Dispose();
        context.Dispose();
        Fails<ObjectDisposedException>("an ended context", () => context.Memory());
        Fails<ObjectDisposedException>("a scene of an ended context", scene.Commit);
        Fails<ObjectDisposedException>("a drag of an ended context", () => drag.Step(DragInput.New(), 0.01f));
        foreach (IDisposable one in new IDisposable[] { model, chest, drag, motion, scene, context }) one.Dispose();
        using (Context a = new Context())
        using (Context b = new Context())
        using (Scene other = b.NewScene())
            Refused("an object of another context", Result.StaleHandle, () => other.Add(Prepare(a)));
    }

    // Ended in any callback: the call comes to its end, and what it used ends then.
    private static void EndsInCallbacks()
    {
        foreach (bool parallel in new[] { false, true })
            for (int which = 0; which < 5; which++)
            {
                Context context = null;
                Action end = () => context.Dispose();
                ContextOptions options = new ContextOptions { Parallel = parallel };
                if (which == 0) options.Log = (level, text) => end();
                if (which == 1) options.Progress = share => { end(); return true; };
                PrepareOptions how = new PrepareOptions();
                if (which == 2) how.Progress = share => { end(); return true; };
                if (which == 3) how.Intent = (id, low, high) => { end(); return JointType.Unknown; };
                if (which == 4) how.Choose = choice => { end(); return -1; };
                context = new Context(options);
                if (which == 0) Refused("a log that ends its context", Result.BadData, () => context.Load(new byte[9]));
                else Must(context.Prepare(Chest(), how).IsEnded, "an object of a context that has ended meanwhile");
                Fails<ObjectDisposedException>("a context that has ended in a callback", () => context.Memory());
            }
        Action hook = null;
        using (Context context = new Context(new ContextOptions { Progress = share => { if (hook != null) hook(); return true; } }))
        {
            Model model = context.LoadModel(weights);
            PreparedObject chest = Prepare(context, model);
            Drag drag = chest.Grab(Lid());
            hook = () => { chest.Dispose(); model.Dispose(); drag.Dispose(); };
            chest.Refine(1, up);
            hook = null;
            Fails<ObjectDisposedException>("an object that has ended in a callback", () => chest.Info());
            Fails<ObjectDisposedException>("a drag that has ended in a callback", () => drag.Step(DragInput.New(), 0.01f));
            Model again = context.LoadModel(weights);
            context.Prepare(Chest(), new PrepareOptions { Model = again, Progress = share => { again.Dispose(); return true; } });
            Works(context);
        }
    }

    private static void CallsInCallbacks()
    {
        using (Context other = new Context())
        using (Context context = new Context())
        {
            PreparedObject kept = Prepare(context);
            foreach (Action call in new Action[] { () => Prepare(context), () => kept.Info(), () => context.Load(dmo),
                                                   () => context.NewScene(), () => kept.Grab(Lid()) })
                for (int which = 0; which < 3; which++)
                {
                    PrepareOptions how = new PrepareOptions();
                    if (which == 0) how.Progress = share => { call(); return true; };
                    if (which == 1) how.Intent = (id, low, high) => { call(); return JointType.Unknown; };
                    if (which == 2) how.Choose = choice => { call(); return -1; };
                    Fails<InvalidOperationException>("a callback that calls its context", () => context.Prepare(Chest(), how));
                }
            foreach (int wrong in new[] { 99, int.MaxValue, int.MinValue, -2 })
                Refused("the choice " + wrong, Result.IndexOutOfRange,
                        () => context.Prepare(Chest(), new PrepareOptions { Choose = choice => wrong }));
            Refused("an unknown type", Result.InvalidArgument,
                    () => context.Prepare(Chest(), new PrepareOptions { Intent = (id, low, high) => (JointType)99 }));
            context.Prepare(Chest(), new PrepareOptions { Progress = share => { Prepare(other).Dispose(); Collect(); return true; } });
            Works(context);
        }
    }

    // In methods of their own, so that nothing refers to what they made when they return.
    private static void Forget(int order)
    {
        Context context = new Context(new ContextOptions { Log = (level, text) => { } });
        PreparedObject door = context.Load(dmo);
        Drag drag = door.Grab(Lid());
        Scene scene = context.NewScene();
        scene.Add(Prepare(context));
        if (order % 3 == 0) context.Dispose();
        if (order % 3 == 1) door.Dispose();
        if (order % 2 == 0) drag.Dispose();
    }

    private static void Garbage()
    {
        for (int i = 0; i < 30; i++)
        {
            Forget(i);
            if (i % 5 == 4) Collect();
        }
        using (Context context = new Context(new ContextOptions { Progress = share => { Collect(); return true; } })) Works(context);
    }

    private static void Arrays()
    {
        using (Context context = new Context())
        {
            foreach (Array wrong in new Array[] { new long[72], new float[72], new int[24, 3], new short[72], new int[24][] })
            {
                Fails<ArgumentException>("indices of " + wrong, () => new Mesh(positions, wrong, parts, true));
                Fails<ArgumentException>("part ids of " + wrong, () => new Mesh(positions, indices, wrong, true));
            }
            Fails<ArgumentNullException>("no indices", () => new Mesh(positions, null));
            foreach (Mesh wrong in new[] { new Mesh(new Vec3[0], indices, parts, true), new Mesh(positions, new int[0], parts, true),
                                           new Mesh(positions, indices, new int[0], true), new Mesh(positions, indices, new byte[23], true),
                                           new Mesh(positions, indices, new byte[25], true), new Mesh(positions, indices, new byte[15]),
                                           new Mesh(positions, new[] { 0, 1 }, parts, true) })
            {
                Fails<DragMeshException>("a wrong mesh", () => context.Prepare(wrong));
                Fails<DragMeshException>("a wrong mesh to find in", () => context.FindPart(wrong, up));
            }
            Refused("no bytes", Result.InvalidArgument, () => context.Load(default(ReadOnlySpan<byte>)));
            Refused("an empty array", Result.BadData, () => context.Load(new byte[0]));
            Refused("no weights", Result.InvalidArgument,
                    () => context.LoadModel(default(ReadOnlySpan<byte>), new byte[0], default(ReadOnlySpan<byte>)));
            PreparedObject chest = Prepare(context);
            chest.SetLinks(default(ReadOnlySpan<Link>));
            Fails<DragMeshException>("too many links", () => chest.SetLinks(new Link[1000]));
            Fails<DragMeshException>("too many values", () => chest.FollowLinks(1, new float[1000], default(Span<byte>)));
            Fails<DragMeshException>("no values", () => chest.FollowLinks(1, default(Span<float>), default(Span<byte>)));
            Fails<ArgumentException>("too few held", () => chest.FollowLinks(1, new float[2], new byte[1]));
            Fails<DragMeshException>("too many snaps", () => chest.Grab(Lid(), null, null, new float[1000]));
            Fails<ArgumentException>("a small matrix", () => Pose.Identity.ToMatrix(new float[15]));
            Pose.Identity.Apply(default(Span<Vec3>));
            using (Drag drag = chest.Grab(Lid()))
            {
                byte[] saved = new byte[Drag.SnapshotSize];
                Refused("a small buffer", Result.BufferTooSmall, () => drag.Save(new byte[9]));
                Refused("no buffer", Result.InvalidArgument, () => drag.Save(default(Span<byte>)));
                drag.Save(saved);
                Fails<DragMeshException>("nothing saved", () => drag.Restore(default(ReadOnlySpan<byte>)));
                Fails<DragMeshException>("a part of it", () => drag.Restore(new ReadOnlySpan<byte>(saved, 0, 100)));
                drag.Restore(saved);
            }
            Works(context);
        }
    }

    private static void Texts()
    {
        using (Context context = new Context())
        {
            Fails<ArgumentException>("a zero in a label", () => context.Prepare(Chest(), new PrepareOptions { Label = "a\0b" }));
            Fails<ArgumentException>("a zero in a part's label", () => context.Prepare(
                Chest(), new PrepareOptions { Parts = new[] { new Part { Id = 1, Label = "\0" } } }));
            Refused("a long label", Result.TooLarge,
                    () => context.Prepare(Chest(), new PrepareOptions { Label = new string('x', 10000000) }));
            foreach (string label in new[] { "", "Tür", "\ud800", "\udc00x", "\U0001f6aa", "\uffff" })
                context.Prepare(Chest(), new PrepareOptions { Label = label }).Dispose();
            Fails<NullReferenceException>("no part", () => context.Prepare(Chest(), new PrepareOptions { Parts = new Part[1] }));
            Works(context);
        }
    }

    private static void Numbers()
    {
        Fails<DragMeshException>("unknown axes", () => new Context(new ContextOptions { Axes = (Axes)99 }));
        Fails<DragMeshException>("unknown picking", () => new Context(new ContextOptions { Picking = (Picking)(-1) }));
        using (Context context = new Context())
        {
            PreparedObject chest = Prepare(context, context.LoadModel(weights));
            Drag drag = chest.Grab(Lid());
            foreach (float wrong in new[] { float.NaN, float.PositiveInfinity, float.NegativeInfinity })
            {
                Vec3 vector = new Vec3(wrong, 0, 0);
                Joint joint = chest.JointOf(1);
                Refused("a joint value", Result.NotFinite, () => joint.PoseAt(wrong));
                joint.Axis = vector;
                Refused("an axis", Result.NotFinite, () => chest.SetJoint(1, joint));
                Refused("a time", Result.NotFinite, () => drag.Step(DragInput.New(), wrong));
                Refused("a ray", Result.NotFinite, () => drag.Update(new Ray(vector, vector), 0.01f));
                Refused("a hint", Result.NotFinite, () => chest.Refine(1, new DragHint(vector, vector)));
                Refused("a place", Result.NotFinite, () => context.FindPart(Chest(), new DragHint(vector, vector)));
                Refused("a pose", Result.NotFinite, () => Pose.From(wrong, 0, 0, 1, default(Vec3)));
                Refused("a unit", Result.InvalidArgument, () => new Context(new ContextOptions { UnitInMetres = wrong }));
            }
            foreach (uint part in new uint[] { 0, 2, uint.MaxValue })
                Refused("part " + part, Result.NotFound, () => chest.JointOf(part));
            MotionDesc path = MotionDesc.New();
            path.PartId = 1;
            path.Drag = up;
            path.PathCount = uint.MaxValue;
            Fails<DragMeshException>("a path that is not there", () => chest.Generate(path));
            Works(context);
        }
    }

    // A size that a caller has written into a struct is not read.
    private static void Sizes()
    {
        using (Context context = new Context())
            foreach (uint size in new uint[] { 0, 1, 4096, uint.MaxValue })
            {
                PreparedObject chest = Prepare(context);
                Joint joint = chest.JointOf(1);
                joint.StructSize = size;
                chest.SetJoint(1, joint);
                joint.PoseAt(0.1f);
                DragDesc desc = Lid();
                DragRules rules = DragRules.New();
                desc.StructSize = rules.StructSize = size;
                Drag drag = chest.Grab(desc, rules);
                DragInput input = DragInput.New();
                input.StructSize = size;
                drag.Step(input, 0.01f);
                ReleaseDesc release = ReleaseDesc.New();
                release.StructSize = size;
                drag.Release(release);
                PartState state = drag.Finish();
                state.StructSize = state.Joint.StructSize = size;
                chest.Grab(Lid(), null, state).Dispose();
                checks++;
            }
    }

    private static void Threads()
    {
        for (int round = 0; round < 10; round++)
        {
            ManualResetEvent begun = new ManualResetEvent(false), go = new ManualResetEvent(false);
            Context context = new Context(new ContextOptions { Parallel = round % 2 == 0 });
            Model model = context.LoadModel(weights);
            Exception failure = null;
            bool ended = false;
            Thread thread = new Thread(() =>
            {
                try
                {
                    ended = context.Prepare(Chest(), new PrepareOptions {
                        Model = model, Progress = share => { begun.Set(); go.WaitOne(); return true; } }).IsEnded;
                }
                catch (Exception e)
                {
                    failure = e;
                }
            });
            thread.Start();
            begun.WaitOne();
            model.Dispose();
            context.Dispose();
            go.Set();
            thread.Join();
            Must(ended && failure == null, "a context that ends on another thread: " + failure);
        }
        using (Context context = new Context())
        {
            PreparedObject chest = Prepare(context);
            Drag drag = chest.Grab(Lid());
            Thread thread = new Thread(() =>
            {
                try
                {
                    while (true) drag.Step(DragInput.New(), 0.001f);
                }
                catch (ObjectDisposedException) { }
                catch (DragMeshException stale) when (stale.Code == Result.StaleHandle) { } // between the two that follow
            });
            thread.Start();
            Thread.Sleep(20);
            chest.Dispose(); // ends after the drag's call
            drag.Dispose();
            thread.Join();
            Works(context);
        }
    }

    public static void Main(string[] arguments)
    {
        dmo = File.ReadAllBytes(arguments[0]);
        weights = arguments[1];
        MakeChest();
        Ends();
        EndsInCallbacks();
        CallsInCallbacks();
        Garbage();
        Arrays();
        Texts();
        Numbers();
        Sizes();
        Threads();
        Console.WriteLine("C#: {0} misuses refused", checks);
    }
}
