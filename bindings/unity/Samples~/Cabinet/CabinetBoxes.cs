/// <summary>The boxes of the sample's cabinet, without Unity: the package's build step prepares them too.</summary>
public static class CabinetBoxes
{
    // From x, y, z to x, y, z; metres, y up, the front faces -z.
    public static readonly float[][] Body = {
        new[] { 0f, 0, 0, 0.6f, 0.02f, -0.4f },      new[] { 0f, 0.98f, 0, 0.6f, 1, -0.42f },
        new[] { 0f, 0.02f, 0, 0.02f, 0.98f, -0.4f }, new[] { 0.58f, 0.02f, 0, 0.6f, 0.98f, -0.4f },
        new[] { 0.02f, 0.02f, 0, 0.58f, 0.98f, -0.02f } };
    public static readonly float[][] Door = {
        new[] { 0f, 0, -0.402f, 0.6f, 0.79f, -0.42f }, new[] { 0.54f, 0.35f, -0.42f, 0.56f, 0.55f, -0.45f } };
    public static readonly float[][] Drawer = {
        new[] { 0f, 0.8f, -0.402f, 0.6f, 0.97f, -0.42f },        new[] { 0.25f, 0.87f, -0.42f, 0.35f, 0.89f, -0.45f },
        new[] { 0.04f, 0.82f, -0.03f, 0.56f, 0.83f, -0.402f },   new[] { 0.04f, 0.83f, -0.03f, 0.05f, 0.95f, -0.402f },
        new[] { 0.55f, 0.83f, -0.03f, 0.56f, 0.95f, -0.402f },   new[] { 0.05f, 0.83f, -0.03f, 0.55f, 0.95f, -0.04f } };
    private static readonly int[] corners = { 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6 };

    /// <summary>Corners of all triangles of a box.</summary>
    public static int CornerCount => corners.Length;

    /// <summary>x, y or z (axis 0, 1, 2) of a corner.</summary>
    public static float At(float[] box, int corner, int axis) => box[(corners[corner] >> axis & 1) != 0 ? axis + 3 : axis];
}
