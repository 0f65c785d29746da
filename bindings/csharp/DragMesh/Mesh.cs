using System;
using System.Runtime.InteropServices;

namespace DragMesh
{
    /// <summary>A triangle mesh and which part each vertex or face belongs to (0 = the body that stays). The arrays are
    /// read in place.</summary>
    public sealed unsafe class Mesh
    {
        internal delegate void User(MeshDesc* desc);

        private readonly Vec3[] positions;
        private readonly Array indices, partIds;
        private readonly bool perFace;

        /// <summary>indices: int[], uint[], ushort[] or byte[], three a triangle. partIds: int[] (negative = body),
        /// uint[], ushort[] or byte[]; null: none.</summary>
        public Mesh(Vec3[] positions, Array indices, Array partIds = null, bool perFace = false)
        {
            if (positions == null || indices == null) throw new ArgumentNullException("positions and indices are needed");
            this.positions = positions;
            this.indices = indices;
            this.partIds = partIds;
            this.perFace = perFace;
            IndexFormat(indices);
            if (partIds != null) PartFormat(partIds);
        }

        public int FaceCount => indices.Length / 3;

        // Compares types exactly: for the runtime, a uint[] "is" an int[].
        private static int IndexFormat(Array array)
        {
            Type type = array.GetType();
            // An int that is negative is an index beyond any mesh, which the library refuses.
            if (type == typeof(uint[]) || type == typeof(int[])) return Constants.DM_UINT32;
            if (type == typeof(ushort[])) return Constants.DM_UINT16;
            if (type == typeof(byte[])) return Constants.DM_UINT8;
            throw new ArgumentException(type + " holds no indices: int[], uint[], ushort[] or byte[]");
        }

        private static int PartFormat(Array array)
        {
            return array.GetType() == typeof(int[]) ? Constants.DM_INT32 : IndexFormat(array);
        }

        /// <summary>Calls with the arrays pinned.</summary>
        internal void Use(User user)
        {
            GCHandle i = GCHandle.Alloc(indices, GCHandleType.Pinned);
            GCHandle p = partIds == null ? default(GCHandle) : GCHandle.Alloc(partIds, GCHandleType.Pinned);
            try
            {
                fixed (Vec3* vertices = positions)
                {
                    MeshDesc desc = MeshDesc.New();
                    desc.Positions = vertices;
                    desc.VertexCount = (ulong)positions.Length;
                    desc.PositionBytes = (ulong)positions.Length * (ulong)sizeof(Vec3);
                    desc.Indices = (void*)i.AddrOfPinnedObject();
                    desc.IndexCount = (ulong)indices.Length;
                    desc.IndexBytes = (ulong)Buffer.ByteLength(indices);
                    desc.IndexFormat = IndexFormat(indices);
                    if (partIds != null)
                    {
                        desc.PartIds = (void*)p.AddrOfPinnedObject();
                        desc.PartIdBytes = (ulong)Buffer.ByteLength(partIds);
                        desc.PartIdFormat = PartFormat(partIds);
                        desc.PartIdScope = perFace ? Constants.DM_PER_FACE : Constants.DM_PER_VERTEX;
                    }
                    user(&desc);
                }
            }
            finally
            {
                i.Free();
                if (p.IsAllocated) p.Free();
            }
        }
    }
}
