// Pulls the first part of a prepared object open with a pointer, and lets it swing: FirstDoor OBJECT.dmo
using System;
using System.IO;
using DragMesh;

static class FirstDoor
{
    static void Main(string[] arguments)
    {
        using (Context context = new Context(new ContextOptions { Axes = Axes.Gltf, Log = (level, text) => Console.Error.WriteLine(text) }))
        {
            PreparedObject thing = context.Load(File.ReadAllBytes(arguments[0]));
            PartInfo part = thing.Parts()[0];
            DragDesc desc = DragDesc.New();
            desc.PartId = part.Id;
            desc.GrabPoint = part.Centre; // of a hit: Scene.Pick
            Vec3 eye = new Vec3(part.Centre.X, part.Centre.Y, part.Centre.Z + 2);
            DragState state = DragState.New();
            using (Drag drag = thing.Grab(desc, DragRules.New()))
            {
                for (int frame = 0; frame < 60; frame++) // every frame: the pointer's ray in the object's frame
                    state = drag.Update(new Ray(eye, new Vec3(-0.003f * frame, 0, -2)), 1f / 60);
                drag.Release(Go.Open);
                while (state.Doing != DragPhase.AtRest) state = drag.Update(1f / 60);
                PartState kept = drag.Finish(); // joint, value and pose: what the instance saves
                Console.WriteLine("part {0} stands open at {1:0.00}", part.Id, kept.Value);
            }
        }
    }
}
