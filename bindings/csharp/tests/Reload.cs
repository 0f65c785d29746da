// What an editor's reload does: loads, drags, unloads and destroys in any order, 1,000 times. No callback may come after
// the end of a context, and memory must not grow. Reload WEIGHTS_FOLDER OBJECT.dmo
using System;
using System.Collections.Generic;
using System.IO;
using DragMesh;

static class Reload
{
    private const int Rounds = 1000, Settled = 200;
    private const long AllowedGrowth = 8 << 20; // bytes of the process between round 200 and the last, by hand

    private static long ResidentBytes()
    {
        foreach (string line in File.ReadAllLines("/proc/self/status"))
            if (line.StartsWith("VmRSS:")) return long.Parse(line.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries)[1]) << 10;
        return 0;
    }

    private static void Must(bool holds, string what)
    {
        if (holds) return;
        Console.Error.WriteLine("reload: " + what);
        Environment.Exit(1);
    }

    private static void Round(Random random, byte[] dmo, byte[] ranker, ref int late, bool[] ended)
    {
        int number = 0;
        Context context = new Context(new ContextOptions { Log = (level, text) => { if (ended[0]) number++; } });
        List<IDisposable> made = new List<IDisposable> { context };
        Model model = context.LoadModel(default(ReadOnlySpan<byte>), default(ReadOnlySpan<byte>), ranker);
        PreparedObject door = context.Load(dmo, model);
        DragDesc desc = DragDesc.New();
        PartInfo part = door.Parts()[0];
        desc.PartId = part.Id;
        desc.GrabPoint = part.Centre;
        Drag drag = door.Grab(desc, DragRules.New());
        Scene scene = context.NewScene();
        scene.Add(door);
        made.AddRange(new IDisposable[] { model, door, drag, scene });
        drag.Update(new Ray(new Vec3(0, 0, 5), new Vec3(0, 0, -1)), 0.016f);
        try { context.Load(new byte[3]); } catch (DragMeshException) { } // logs
        for (int left = made.Count; left > 0; left--)
        {
            int i = random.Next(left);
            IDisposable one = made[i];
            made[i] = made[left - 1];
            if (random.Next(4) == 0 && one != context) continue; // left to the finalizer
            one.Dispose();
            if (one == context) ended[0] = true;
            try { drag.Update(0.016f); } catch (DragMeshException) { } catch (ObjectDisposedException) { }
        }
        late += number;
    }

    public static void Main(string[] arguments)
    {
        byte[] ranker = File.ReadAllBytes(Path.Combine(arguments[0], "ranker.safetensors"));
        byte[] dmo = File.ReadAllBytes(arguments[1]);
        Random random = new Random(1);
        int late = 0;
        long settled = 0;
        for (int round = 0; round < Rounds; round++)
        {
            Round(random, dmo, ranker, ref late, new bool[1]);
            if (round % 50 == 49)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
            if (round == Settled - 1) settled = ResidentBytes();
        }
        long growth = ResidentBytes() - settled;
        Must(late == 0, late + " messages came after the end of their context");
        Must(growth < AllowedGrowth, "memory has grown by " + growth + " bytes");
        Console.WriteLine("C#: {0} reloads, {1} KiB grown since the {2}th", Rounds, growth >> 10, Settled);
    }
}
