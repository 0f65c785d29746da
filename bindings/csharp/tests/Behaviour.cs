// What the layer of C# adds to the library: layout, exceptions, callbacks, owners. Behaviour OBJECT.dmo WEIGHTS_FOLDER
using System;
using System.Collections.Generic;
using System.IO;
using DragMesh;

static class Behaviour
{
    private static int checks;

    private static void Must(bool holds, string what)
    {
        checks++;
        if (holds) return;
        Console.Error.WriteLine("behaviour: " + what);
        Environment.Exit(1);
    }

    private static T Fails<T>(Action call, string what) where T : Exception
    {
        try
        {
            call();
        }
        catch (T failure)
        {
            checks++;
            return failure;
        }
        Must(false, what + " did not throw");
        return null;
    }

    // A box with a lid that lies on it.
    private static Mesh Chest()
    {
        float[,] boxes = { { 0, 0, 0, 1, 0.5f, 0.6f }, { 0, 0.51f, 0, 1, 0.56f, 0.6f } };
        int[] corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                          2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };
        Vec3[] positions = new Vec3[16];
        int[] indices = new int[72], parts = new int[24];
        for (int v = 0; v < 16; v++)
            positions[v] = new Vec3(boxes[v / 8, (v & 1) != 0 ? 3 : 0], boxes[v / 8, (v & 2) != 0 ? 4 : 1],
                                    boxes[v / 8, (v & 4) != 0 ? 5 : 2]);
        for (int i = 0; i < 72; i++) indices[i] = i / 36 * 8 + corners[i % 36];
        for (int f = 0; f < 24; f++) parts[f] = f < 12 ? -1 : 7; // a negative id is the body
        return new Mesh(positions, indices, parts, true);
    }

    private static void Layouts()
    {
        Must(Layout.Check() > 250, "the layout has too few fields");
        Must(Context.LibraryVersion.Minor >= 1, "version");
    }

    private static void Exceptions(byte[] dmo)
    {
        List<string> messages = new List<string>();
        using (Context context = new Context(new ContextOptions { Log = (level, text) => messages.Add(text) }))
        {
            dmo[dmo.Length / 2] ^= 1;
            DragMeshException bad = Fails<DragMeshException>(() => context.Load(dmo), "a broken .dmo");
            dmo[dmo.Length / 2] ^= 1;
            Must(bad.Code == Result.BadData && bad.Name == "DM_ERROR_BAD_DATA", "code of a broken .dmo");
            Must(messages.Count == 1 && bad.Message.EndsWith(messages[0]), "message of a broken .dmo");
            PreparedObject door = context.Load(dmo);
            Must(Fails<DragMeshException>(() => door.JointOf(99), "part 99").Code == Result.NotFound, "code of part 99");
            Fails<ArgumentException>(() => new Mesh(new Vec3[3], new long[3]), "indices of 64 bits");
            Must(Fails<DragMeshException>(() => context.Prepare(new Mesh(new Vec3[3], new[] { 0, 1, -1 }, new[] { 0, 1, 1 })),
                                          "an index of -1").Code == Result.IndexOutOfRange, "code of an index of -1");
        }
        using (Context mute = new Context(new ContextOptions { Log = (level, text) => { throw new Exception("no"); } }))
            Fails<DragMeshException>(() => mute.Load(new byte[5]), "a log that throws");
    }

    private static void ContextProgress()
    {
        foreach (Func<float, bool> progress in new Func<float, bool>[] {
                     share => false, share => { throw new DivideByZeroException(); } })
            using (Context context = new Context(new ContextOptions { Progress = progress }))
                Must(Fails<DragMeshException>(() => context.Prepare(Chest(), new PrepareOptions()), "a call that is stopped")
                         .Code == Result.Cancelled, "cancelled by the context");
    }

    private static void Callbacks()
    {
        foreach (bool parallel in new[] { false, true })
            using (Context context = new Context(new ContextOptions { Parallel = parallel }))
            {
                float done = 0;
                int shown = 0;
                PreparedObject chest = context.Prepare(Chest(), new PrepareOptions {
                    Label = "chest",
                    Progress = share => { Must(share >= done, "progress falls"); done = share; return true; },
                    Choose = choice => { shown = choice.Joints.Length; return shown - 1; } });
                Must(done > 0 && shown > 0, "callbacks were not called");
                Must(chest.Parts()[0].Id == 7 && chest.JointOf(7).From == JointSource.Chosen, "the chosen joint");
                Must(Fails<DragMeshException>(() => context.Prepare(Chest(), new PrepareOptions { Progress = share => false }),
                                              "a cancelled preparation").Code == Result.Cancelled, "cancelled");
                InvalidOperationException inner = Fails<InvalidOperationException>(
                    () => context.Prepare(Chest(), new PrepareOptions {
                        Choose = choice => { throw new DivideByZeroException(); } }), "a callback that throws");
                Must(inner.InnerException is DivideByZeroException, "the exception of a callback");
                chest.Dispose();
                Must(context.Prepare(Chest(), new PrepareOptions { Intent = (id, low, high) => JointType.Prismatic })
                         .JointOf(7).Kind == JointType.Prismatic, "the intent's type");
            }
    }

    private static void Owners(byte[] dmo)
    {
        Context context = new Context();
        PreparedObject door = context.Load(dmo);
        uint part = door.Parts()[0].Id;
        DragDesc desc = DragDesc.New();
        desc.PartId = part;
        desc.Flags = Constants.DM_DRAG_WITHOUT_POINT;
        Drag drag = door.Grab(desc);
        door.Dispose();
        Must(Fails<DragMeshException>(() => drag.Update(0.01f), "a drag of an ended object").Code == Result.StaleHandle,
             "a drag of an ended object");
        Fails<ObjectDisposedException>(() => door.Info(), "an ended object");
        drag.Dispose();
        drag.Dispose();
        PreparedObject left = context.Load(dmo);
        context.Dispose();
        Fails<ObjectDisposedException>(() => left.Info(), "an object of an ended context");
        left.Dispose();
        context.Dispose();
    }

    // In a method of its own, so that nothing refers to the weights when it returns.
    private static PreparedObject WithWeights(Context context, string folder)
    {
        return context.Prepare(Chest(), new PrepareOptions { Model = context.LoadModel(folder) });
    }

    private static void Weights(string folder)
    {
        using (Context context = new Context())
        {
            PreparedObject chest = WithWeights(context, folder);
            for (int i = 0; i < 3; i++)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
            MotionDesc desc = MotionDesc.New();
            desc.PartId = 7;
            desc.Drag = new DragHint(new Vec3(0.5f, 0.56f, 0.6f), new Vec3(0, 0.2f, 0));
            float value;
            chest.Generate(desc).Sample(1, out value);
            Must(Math.Abs(value) > 0.01f, "a motion by weights that nothing else keeps");
        }
    }

    private static void Poses()
    {
        Pose turn = Pose.From(0, 0.70710678f, 0, 0.70710678f, new Vec3(1, 2, 3)); // a quarter turn about y
        Vec3 moved = (turn * Pose.Identity).Apply(new Vec3(1, 0, 0));
        Must(Math.Abs(moved.X - 1) < 1e-6 && Math.Abs(moved.Y - 2) < 1e-6 && Math.Abs(moved.Z - 2) < 1e-6, "a pose");
        Vec3 back = turn.Inverse.Apply(moved);
        Must(Math.Abs(back.X - 1) < 1e-6 && Math.Abs(back.Y) < 1e-6 && Math.Abs(back.Z) < 1e-6, "an inverse");
        Span<float> matrix = stackalloc float[16];
        turn.ToMatrix(matrix);
        Must(Math.Abs(matrix[13] - 2) < 1e-6 && Math.Abs(turn.Translation.Z - 3) < 1e-6, "a matrix");
    }

    private static void Garbage(byte[] dmo)
    {
        using (Context context = new Context())
        {
            PreparedObject door = context.Load(dmo);
            DragDesc desc = DragDesc.New();
            PartInfo part = door.Parts()[0];
            desc.PartId = part.Id;
            desc.GrabPoint = part.Centre;
            Drag drag = door.Grab(desc, DragRules.New());
            Ray ray = new Ray(new Vec3(0, 0, 5), new Vec3(0, 0, -1));
            drag.Update(ray, 0.016f);
            int before = GC.CollectionCount(0);
            for (int i = 0; i < 300000; i++) drag.Update(ray, 0.016f);
            Must(GC.CollectionCount(0) == before, "updates make garbage");
        }
    }

    public static void Main(string[] arguments)
    {
        byte[] dmo = File.ReadAllBytes(arguments[0]);
        Layouts();
        Exceptions(dmo);
        Callbacks();
        ContextProgress();
        Owners(dmo);
        Weights(arguments[1]);
        Poses();
        Garbage(dmo);
        Console.WriteLine("C#: {0} checks passed", checks);
    }
}
