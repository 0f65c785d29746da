// Prepares the sample's cabinet when the package is made: Bake WEIGHTS_FOLDER OUT.dmo.bytes
using System.Collections.Generic;
using System.IO;
using DragMesh;

static class Bake
{
    // Parts are numbered as Baker.FindParts numbers the sample's nodes.
    private const int body = 0, door = 1, drawer = 2;

    static void Main(string[] arguments)
    {
        List<Vec3> positions = new List<Vec3>();
        List<int> ids = new List<int>();
        Add(CabinetBoxes.Body, body, positions, ids);
        Add(CabinetBoxes.Door, door, positions, ids);
        Add(CabinetBoxes.Drawer, drawer, positions, ids);
        int[] indices = new int[positions.Count];
        for (int i = 0; i < indices.Length; i++) indices[i] = i;
        Part[] parts = { new Part { Id = door, Label = "cabinet/door" }, new Part { Id = drawer, Label = "cabinet/drawer" } };
        using (Context context = new Context(new ContextOptions { Axes = Axes.Unity }))
        using (Model model = context.LoadModel(arguments[0]))
        using (PreparedObject cabinet = context.Prepare(new Mesh(positions.ToArray(), indices, ids.ToArray(), true),
                                                        new PrepareOptions { Model = model, Parts = parts, Label = "cabinet" }))
            WriteWhole(arguments[1], cabinet.Save());
    }

    // Beside its place, then renamed: whatever fails, the file that was there stays.
    private static void WriteWhole(string path, byte[] data)
    {
        string part = path + ".part";
        try
        {
            File.WriteAllBytes(part, data);
            if (File.Exists(path)) File.Replace(part, path, null); else File.Move(part, path);
        }
        finally
        {
            File.Delete(part);
        }
    }

    private static void Add(float[][] boxes, int id, List<Vec3> positions, List<int> ids)
    {
        foreach (float[] box in boxes)
        {
            for (int i = 0; i < CabinetBoxes.CornerCount; i++)
                positions.Add(new Vec3(CabinetBoxes.At(box, i, 0), CabinetBoxes.At(box, i, 1), CabinetBoxes.At(box, i, 2)));
            for (int face = 0; face < CabinetBoxes.CornerCount / 3; face++) ids.Add(id);
        }
    }
}
