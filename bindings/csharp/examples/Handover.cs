// What a host does with a joint beside dragging: a constraint for physics, a saved game, a client. Handover OBJECT.dmo
using System;
using System.Globalization;
using System.IO;
using System.Linq;
using DragMesh;

static class Handover
{
    // Numbers, not the struct as it lies in memory: structs grow. "R" keeps every bit.
    static string Save(PartState door)
    {
        Joint j = door.Joint;
        float[] numbers = { door.Value, j.TypeConfidence, j.JointConfidence, j.Pitch, j.Axis.X, j.Axis.Y, j.Axis.Z,
                            j.Origin.X, j.Origin.Y, j.Origin.Z, j.Lower, j.Upper };
        return j.Type + " " + j.Source + " " + string.Join(" ", j.PullEvidence) + " " + // what pulls have said
               string.Join(" ", numbers.Select(n => n.ToString("R", CultureInfo.InvariantCulture)));
    }

    static PartState Load(string text)
    {
        string[] words = text.Split(' ');
        float[] n = words.Skip(6).Select(word => float.Parse(word, CultureInfo.InvariantCulture)).ToArray();
        PartState door = PartState.New(); // its pose is zeros: that of joint and value
        door.Joint = Joint.New();
        door.Joint.Type = int.Parse(words[0]);
        door.Joint.Source = int.Parse(words[1]);
        door.Joint.PullEvidence = words.Skip(2).Take(4).Select(uint.Parse).ToArray();
        door.Value = n[0];
        door.Joint.TypeConfidence = n[1];
        door.Joint.JointConfidence = n[2];
        door.Joint.Pitch = n[3];
        door.Joint.Axis = new Vec3(n[4], n[5], n[6]);
        door.Joint.Origin = new Vec3(n[7], n[8], n[9]);
        door.Joint.Lower = n[10];
        door.Joint.Upper = n[11];
        return door;
    }

    static void Main(string[] arguments)
    {
        using (Context context = new Context(new ContextOptions()))
        {
            PreparedObject thing = context.Load(File.ReadAllBytes(arguments[0]));
            PartInfo part = thing.Parts()[0];
            PartState door = PartState.New();
            door.Joint = thing.JointOf(part.Id);

            // Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider.
            JointFrame frame = door.Joint.Frame();
            Console.WriteLine("a constraint that opens to {0:0.00}", frame.Upper);

            // … and back: body is the transform that the engine has given the part, from rest.
            Pose body = door.Joint.PoseAt(1.2f);
            float angleOff, distanceOff;
            door.Value = door.Joint.ValueOf(body, out angleOff, out distanceOff);
            door.Pose = body;
            Console.WriteLine("physics leaves it at {0:0.00}", door.Value);

            PartState loaded = Load(Save(door));
            Console.WriteLine("saved and loaded at {0:0.00}", loaded.Value);

            // A client has neither object nor context: the joint once, the value every frame.
            Pose shown = loaded.Joint.PoseAt(loaded.Value);

            // The next grab begins where the part stands.
            DragDesc desc = DragDesc.New();
            desc.PartId = part.Id;
            desc.GrabPoint = shown.Apply(part.Centre);
            PartState again = thing.Grab(desc, null, loaded).Finish();
            Console.WriteLine("grabbed again at {0:0.00}", again.Value);
        }
    }
}
