// The C interface of dragmesh. Written by scripts/describe from the public headers: not to be edited.
using System;

namespace DragMesh
{
    /// <summary>Compares the runtime's layout of the structs with that of C.</summary>
    public static unsafe class Layout
    {
        private static int compared;

        private static void Expect(string name, long found, long wide, long narrow)
        {
            compared++;
            long wanted = IntPtr.Size == 8 ? wide : narrow;
            if (found != wanted) throw new InvalidOperationException(name + " is " + found + ", in C " + wanted);
        }

        /// <summary>Returns how many sizes and offsets it has compared; throws at the first that differs.</summary>
        public static int Check()
        {
            compared = 0;
            { Vec3 s; byte* at = (byte*)&s;
              Expect("dm_vec3", sizeof(Vec3), 12, 12);
              Expect("dm_vec3.x", (byte*)&s.X - at, 0, 0);
              Expect("dm_vec3.y", (byte*)&s.Y - at, 4, 4);
              Expect("dm_vec3.z", (byte*)&s.Z - at, 8, 8);
            }
            { Pose s; byte* at = (byte*)&s;
              Expect("dm_pose", sizeof(Pose), 32, 32);
              Expect("dm_pose.real", (byte*)s.Real - at, 0, 0);
              Expect("dm_pose.dual", (byte*)s.Dual - at, 16, 16);
            }
            { Ray s; byte* at = (byte*)&s;
              Expect("dm_ray", sizeof(Ray), 24, 24);
              Expect("dm_ray.origin", (byte*)&s.Origin - at, 0, 0);
              Expect("dm_ray.direction", (byte*)&s.Direction - at, 12, 12);
            }
            { Allocator s; byte* at = (byte*)&s;
              Expect("dm_allocator", sizeof(Allocator), 24, 12);
              Expect("dm_allocator.user", (byte*)&s.User - at, 0, 0);
              Expect("dm_allocator.allocate", (byte*)&s.Allocate - at, 8, 4);
              Expect("dm_allocator.release", (byte*)&s.Release - at, 16, 8);
            }
            { Log s; byte* at = (byte*)&s;
              Expect("dm_log", sizeof(Log), 16, 8);
              Expect("dm_log.user", (byte*)&s.User - at, 0, 0);
              Expect("dm_log.message", (byte*)&s.Message - at, 8, 4);
            }
            { Jobs s; byte* at = (byte*)&s;
              Expect("dm_jobs", sizeof(Jobs), 16, 8);
              Expect("dm_jobs.user", (byte*)&s.User - at, 0, 0);
              Expect("dm_jobs.parallel_for", (byte*)&s.ParallelFor - at, 8, 4);
            }
            { ContextDesc s; byte* at = (byte*)&s;
              Expect("dm_context_desc", sizeof(ContextDesc), 136, 104);
              Expect("dm_context_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_context_desc.axes", (byte*)&s.Axes - at, 4, 4);
              Expect("dm_context_desc.unit_in_metres", (byte*)&s.UnitInMetres - at, 8, 8);
              Expect("dm_context_desc.custom_axes", (byte*)s.CustomAxes - at, 12, 12);
              Expect("dm_context_desc.allocator", (byte*)&s.Allocator - at, 48, 48);
              Expect("dm_context_desc.log", (byte*)&s.Log - at, 72, 60);
              Expect("dm_context_desc.jobs", (byte*)&s.Jobs - at, 88, 68);
              Expect("dm_context_desc.picking", (byte*)&s.Picking - at, 104, 76);
              Expect("dm_context_desc.reserved", (byte*)&s.Reserved - at, 108, 80);
              Expect("dm_context_desc.progress", (byte*)&s.Progress - at, 112, 84);
              Expect("dm_context_desc.progress_user", (byte*)&s.ProgressUser - at, 120, 88);
              Expect("dm_context_desc.kept_bytes", (byte*)&s.KeptBytes - at, 128, 96);
            }
            { MemoryInfo s; byte* at = (byte*)&s;
              Expect("dm_memory_info", sizeof(MemoryInfo), 48, 48);
              Expect("dm_memory_info.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_memory_info.reserved", (byte*)&s.Reserved - at, 4, 4);
              Expect("dm_memory_info.bytes", (byte*)&s.Bytes - at, 8, 8);
              Expect("dm_memory_info.peak_bytes", (byte*)&s.PeakBytes - at, 16, 16);
              Expect("dm_memory_info.allocations", (byte*)&s.Allocations - at, 24, 24);
              Expect("dm_memory_info.pick_bytes", (byte*)&s.PickBytes - at, 32, 32);
              Expect("dm_memory_info.kept_bytes", (byte*)&s.KeptBytes - at, 40, 40);
            }
            { ModelDesc s; byte* at = (byte*)&s;
              Expect("dm_model_desc", sizeof(ModelDesc), 56, 28);
              Expect("dm_model_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_model_desc.kinematics", (byte*)&s.Kinematics - at, 8, 4);
              Expect("dm_model_desc.kinematics_size", (byte*)&s.KinematicsSize - at, 16, 8);
              Expect("dm_model_desc.motion", (byte*)&s.Motion - at, 24, 12);
              Expect("dm_model_desc.motion_size", (byte*)&s.MotionSize - at, 32, 16);
              Expect("dm_model_desc.ranker", (byte*)&s.Ranker - at, 40, 20);
              Expect("dm_model_desc.ranker_size", (byte*)&s.RankerSize - at, 48, 24);
            }
            { MeshDesc s; byte* at = (byte*)&s;
              Expect("dm_mesh_desc", sizeof(MeshDesc), 96, 96);
              Expect("dm_mesh_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_mesh_desc.position_stride", (byte*)&s.PositionStride - at, 4, 4);
              Expect("dm_mesh_desc.positions", (byte*)&s.Positions - at, 8, 8);
              Expect("dm_mesh_desc.vertex_count", (byte*)&s.VertexCount - at, 16, 16);
              Expect("dm_mesh_desc.position_bytes", (byte*)&s.PositionBytes - at, 24, 24);
              Expect("dm_mesh_desc.indices", (byte*)&s.Indices - at, 32, 32);
              Expect("dm_mesh_desc.index_count", (byte*)&s.IndexCount - at, 40, 40);
              Expect("dm_mesh_desc.index_bytes", (byte*)&s.IndexBytes - at, 48, 48);
              Expect("dm_mesh_desc.part_ids", (byte*)&s.PartIds - at, 56, 56);
              Expect("dm_mesh_desc.part_id_bytes", (byte*)&s.PartIdBytes - at, 64, 64);
              Expect("dm_mesh_desc.part_id_stride", (byte*)&s.PartIdStride - at, 72, 72);
              Expect("dm_mesh_desc.position_format", (byte*)&s.PositionFormat - at, 76, 76);
              Expect("dm_mesh_desc.index_format", (byte*)&s.IndexFormat - at, 80, 80);
              Expect("dm_mesh_desc.part_id_format", (byte*)&s.PartIdFormat - at, 84, 84);
              Expect("dm_mesh_desc.part_id_scope", (byte*)&s.PartIdScope - at, 88, 88);
              Expect("dm_mesh_desc.reserved", (byte*)&s.Reserved - at, 92, 92);
            }
            { DragHint s; byte* at = (byte*)&s;
              Expect("dm_drag_hint", sizeof(DragHint), 24, 24);
              Expect("dm_drag_hint.point", (byte*)&s.Point - at, 0, 0);
              Expect("dm_drag_hint.vector", (byte*)&s.Vector - at, 12, 12);
            }
            { Pivot s; byte* at = (byte*)&s;
              Expect("dm_pivot", sizeof(Pivot), 48, 48);
              Expect("dm_pivot.origin", (byte*)&s.Origin - at, 0, 0);
              Expect("dm_pivot.axes", (byte*)s.Axes - at, 12, 12);
            }
            { PartDesc s; byte* at = (byte*)&s;
              Expect("dm_part_desc", sizeof(PartDesc), 48, 36);
              Expect("dm_part_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_part_desc.id", (byte*)&s.Id - at, 4, 4);
              Expect("dm_part_desc.parent", (byte*)&s.Parent - at, 8, 8);
              Expect("dm_part_desc.joint_type", (byte*)&s.JointType - at, 12, 12);
              Expect("dm_part_desc.drag", (byte*)&s.Drag - at, 16, 16);
              Expect("dm_part_desc.label", (byte*)&s.Label - at, 24, 20);
              Expect("dm_part_desc.pivot", (byte*)&s.Pivot - at, 32, 24);
              Expect("dm_part_desc.pivot_kind", (byte*)&s.PivotKind - at, 40, 28);
              Expect("dm_part_desc.reserved", (byte*)&s.Reserved - at, 44, 32);
            }
            { Joint s; byte* at = (byte*)&s;
              Expect("dm_joint", sizeof(Joint), 76, 76);
              Expect("dm_joint.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_joint.type", (byte*)&s.Type - at, 4, 4);
              Expect("dm_joint.type_confidence", (byte*)&s.TypeConfidence - at, 8, 8);
              Expect("dm_joint.joint_confidence", (byte*)&s.JointConfidence - at, 12, 12);
              Expect("dm_joint.pitch", (byte*)&s.Pitch - at, 16, 16);
              Expect("dm_joint.axis", (byte*)&s.Axis - at, 20, 20);
              Expect("dm_joint.origin", (byte*)&s.Origin - at, 32, 32);
              Expect("dm_joint.lower", (byte*)&s.Lower - at, 44, 44);
              Expect("dm_joint.upper", (byte*)&s.Upper - at, 48, 48);
              Expect("dm_joint.source", (byte*)&s.Source - at, 52, 52);
              Expect("dm_joint.evidence", (byte*)s.Evidence - at, 56, 56);
              Expect("dm_joint.closed", (byte*)&s.Closed - at, 72, 72);
            }
            { JointFrame s; byte* at = (byte*)&s;
              Expect("dm_joint_frame", sizeof(JointFrame), 88, 88);
              Expect("dm_joint_frame.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_joint_frame.type", (byte*)&s.Type - at, 4, 4);
              Expect("dm_joint_frame.origin", (byte*)&s.Origin - at, 8, 8);
              Expect("dm_joint_frame.x", (byte*)&s.X - at, 20, 20);
              Expect("dm_joint_frame.y", (byte*)&s.Y - at, 32, 32);
              Expect("dm_joint_frame.z", (byte*)&s.Z - at, 44, 44);
              Expect("dm_joint_frame.rotation", (byte*)s.Rotation - at, 56, 56);
              Expect("dm_joint_frame.lower", (byte*)&s.Lower - at, 72, 72);
              Expect("dm_joint_frame.upper", (byte*)&s.Upper - at, 76, 76);
              Expect("dm_joint_frame.limits", (byte*)&s.Limits - at, 80, 80);
              Expect("dm_joint_frame.pitch", (byte*)&s.Pitch - at, 84, 84);
            }
            { PartState s; byte* at = (byte*)&s;
              Expect("dm_part_state", sizeof(PartState), 124, 124);
              Expect("dm_part_state.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_part_state.value", (byte*)&s.Value - at, 4, 4);
              Expect("dm_part_state.velocity", (byte*)&s.Velocity - at, 8, 8);
              Expect("dm_part_state.status", (byte*)&s.Status - at, 12, 12);
              Expect("dm_part_state.pose", (byte*)&s.Pose - at, 16, 16);
              Expect("dm_part_state.joint", (byte*)&s.Joint - at, 48, 48);
            }
            { PartInfo s; byte* at = (byte*)&s;
              Expect("dm_part_info", sizeof(PartInfo), 56, 56);
              Expect("dm_part_info.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_part_info.id", (byte*)&s.Id - at, 4, 4);
              Expect("dm_part_info.parent", (byte*)&s.Parent - at, 8, 8);
              Expect("dm_part_info.triangle_count", (byte*)&s.TriangleCount - at, 12, 12);
              Expect("dm_part_info.box_min", (byte*)&s.BoxMin - at, 16, 16);
              Expect("dm_part_info.box_max", (byte*)&s.BoxMax - at, 28, 28);
              Expect("dm_part_info.centre", (byte*)&s.Centre - at, 40, 40);
              Expect("dm_part_info.area", (byte*)&s.Area - at, 52, 52);
            }
            { JointEnd s; byte* at = (byte*)&s;
              Expect("dm_joint_end", sizeof(JointEnd), 72, 72);
              Expect("dm_joint_end.value", (byte*)&s.Value - at, 0, 0);
              Expect("dm_joint_end.pose", (byte*)&s.Pose - at, 4, 4);
              Expect("dm_joint_end.box_min", (byte*)&s.BoxMin - at, 36, 36);
              Expect("dm_joint_end.box_max", (byte*)&s.BoxMax - at, 48, 48);
              Expect("dm_joint_end.centre", (byte*)&s.Centre - at, 60, 60);
            }
            { Hypothesis s; byte* at = (byte*)&s;
              Expect("dm_hypothesis", sizeof(Hypothesis), 160, 156);
              Expect("dm_hypothesis.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_hypothesis.reserved", (byte*)&s.Reserved - at, 4, 4);
              Expect("dm_hypothesis.joint", (byte*)&s.Joint - at, 8, 8);
              Expect("dm_hypothesis.ends", (byte*)&s.Ends0 - at, 16, 12);
            }
            { Choice s; byte* at = (byte*)&s;
              Expect("dm_choice", sizeof(Choice), 24, 16);
              Expect("dm_choice.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_choice.count", (byte*)&s.Count - at, 4, 4);
              Expect("dm_choice.part", (byte*)&s.Part - at, 8, 8);
              Expect("dm_choice.hypotheses", (byte*)&s.Hypotheses - at, 16, 12);
            }
            { ObjectDesc s; byte* at = (byte*)&s;
              Expect("dm_object_desc", sizeof(ObjectDesc), 120, 80);
              Expect("dm_object_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_object_desc.flags", (byte*)&s.Flags - at, 4, 4);
              Expect("dm_object_desc.mesh", (byte*)&s.Mesh - at, 8, 8);
              Expect("dm_object_desc.parts", (byte*)&s.Parts - at, 16, 12);
              Expect("dm_object_desc.part_count", (byte*)&s.PartCount - at, 24, 16);
              Expect("dm_object_desc.reserved", (byte*)&s.Reserved - at, 28, 20);
              Expect("dm_object_desc.model", (byte*)&s.Model - at, 32, 24);
              Expect("dm_object_desc.seed", (byte*)&s.Seed - at, 40, 32);
              Expect("dm_object_desc.intent", (byte*)&s.Intent - at, 48, 40);
              Expect("dm_object_desc.intent_user", (byte*)&s.IntentUser - at, 56, 44);
              Expect("dm_object_desc.progress", (byte*)&s.Progress - at, 64, 48);
              Expect("dm_object_desc.progress_user", (byte*)&s.ProgressUser - at, 72, 52);
              Expect("dm_object_desc.label", (byte*)&s.Label - at, 80, 56);
              Expect("dm_object_desc.up", (byte*)&s.Up - at, 88, 60);
              Expect("dm_object_desc.choose", (byte*)&s.Choose - at, 104, 72);
              Expect("dm_object_desc.choose_user", (byte*)&s.ChooseUser - at, 112, 76);
            }
            { ObjectInfo s; byte* at = (byte*)&s;
              Expect("dm_object_info", sizeof(ObjectInfo), 64, 64);
              Expect("dm_object_info.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_object_info.part_count", (byte*)&s.PartCount - at, 4, 4);
              Expect("dm_object_info.vertex_count", (byte*)&s.VertexCount - at, 8, 8);
              Expect("dm_object_info.triangle_count", (byte*)&s.TriangleCount - at, 16, 16);
              Expect("dm_object_info.box_min", (byte*)&s.BoxMin - at, 24, 24);
              Expect("dm_object_info.box_max", (byte*)&s.BoxMax - at, 36, 36);
              Expect("dm_object_info.size", (byte*)&s.Size - at, 48, 48);
              Expect("dm_object_info.pickable", (byte*)&s.Pickable - at, 52, 52);
              Expect("dm_object_info.degraded", (byte*)&s.Degraded - at, 56, 56);
              Expect("dm_object_info.picking", (byte*)&s.Picking - at, 60, 60);
            }
            { AssetClip s; byte* at = (byte*)&s;
              Expect("dm_asset_clip", sizeof(AssetClip), 32, 20);
              Expect("dm_asset_clip.name", (byte*)&s.Name - at, 0, 0);
              Expect("dm_asset_clip.times", (byte*)&s.Times - at, 8, 4);
              Expect("dm_asset_clip.poses", (byte*)&s.Poses - at, 16, 8);
              Expect("dm_asset_clip.key_count", (byte*)&s.KeyCount - at, 24, 12);
              Expect("dm_asset_clip.flags", (byte*)&s.Flags - at, 28, 16);
            }
            { AssetNode s; byte* at = (byte*)&s;
              Expect("dm_asset_node", sizeof(AssetNode), 80, 52);
              Expect("dm_asset_node.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_asset_node.flags", (byte*)&s.Flags - at, 4, 4);
              Expect("dm_asset_node.parent", (byte*)&s.Parent - at, 8, 8);
              Expect("dm_asset_node.follows", (byte*)&s.Follows - at, 12, 12);
              Expect("dm_asset_node.name", (byte*)&s.Name - at, 16, 16);
              Expect("dm_asset_node.mesh_name", (byte*)&s.MeshName - at, 24, 20);
              Expect("dm_asset_node.mesh", (byte*)&s.Mesh - at, 32, 24);
              Expect("dm_asset_node.transform", (byte*)&s.Transform - at, 40, 28);
              Expect("dm_asset_node.pivot", (byte*)&s.Pivot - at, 48, 32);
              Expect("dm_asset_node.clips", (byte*)&s.Clips - at, 56, 36);
              Expect("dm_asset_node.clip_count", (byte*)&s.ClipCount - at, 64, 40);
              Expect("dm_asset_node.reserved", (byte*)&s.Reserved - at, 68, 44);
              Expect("dm_asset_node.joint", (byte*)&s.Joint - at, 72, 48);
            }
            { AssetDesc s; byte* at = (byte*)&s;
              Expect("dm_asset_desc", sizeof(AssetDesc), 80, 64);
              Expect("dm_asset_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_asset_desc.flags", (byte*)&s.Flags - at, 4, 4);
              Expect("dm_asset_desc.nodes", (byte*)&s.Nodes - at, 8, 8);
              Expect("dm_asset_desc.label", (byte*)&s.Label - at, 16, 12);
              Expect("dm_asset_desc.node_count", (byte*)&s.NodeCount - at, 24, 16);
              Expect("dm_asset_desc.min_moves", (byte*)&s.MinMoves - at, 28, 20);
              Expect("dm_asset_desc.model", (byte*)&s.Model - at, 32, 24);
              Expect("dm_asset_desc.seed", (byte*)&s.Seed - at, 40, 32);
              Expect("dm_asset_desc.progress", (byte*)&s.Progress - at, 48, 40);
              Expect("dm_asset_desc.progress_user", (byte*)&s.ProgressUser - at, 56, 44);
              Expect("dm_asset_desc.up", (byte*)&s.Up - at, 64, 48);
              Expect("dm_asset_desc.reserved", (byte*)&s.Reserved - at, 76, 60);
            }
            { AssetInfo s; byte* at = (byte*)&s;
              Expect("dm_asset_info", sizeof(AssetInfo), 32, 32);
              Expect("dm_asset_info.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_asset_info.node_count", (byte*)&s.NodeCount - at, 4, 4);
              Expect("dm_asset_info.part_count", (byte*)&s.PartCount - at, 8, 8);
              Expect("dm_asset_info.moving_count", (byte*)&s.MovingCount - at, 12, 12);
              Expect("dm_asset_info.triangle_count", (byte*)&s.TriangleCount - at, 16, 16);
              Expect("dm_asset_info.degraded", (byte*)&s.Degraded - at, 24, 24);
              Expect("dm_asset_info.warnings", (byte*)&s.Warnings - at, 28, 28);
            }
            { AssetPart s; byte* at = (byte*)&s;
              Expect("dm_asset_part", sizeof(AssetPart), 64, 64);
              Expect("dm_asset_part.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_asset_part.parent", (byte*)&s.Parent - at, 4, 4);
              Expect("dm_asset_part.part_id", (byte*)&s.PartId - at, 8, 8);
              Expect("dm_asset_part.state", (byte*)&s.State - at, 12, 12);
              Expect("dm_asset_part.basis", (byte*)&s.Basis - at, 16, 16);
              Expect("dm_asset_part.moves", (byte*)&s.Moves - at, 20, 20);
              Expect("dm_asset_part.node_count", (byte*)&s.NodeCount - at, 24, 24);
              Expect("dm_asset_part.triangle_count", (byte*)&s.TriangleCount - at, 28, 28);
              Expect("dm_asset_part.duration", (byte*)&s.Duration - at, 32, 32);
              Expect("dm_asset_part.reserved", (byte*)&s.Reserved - at, 36, 36);
              Expect("dm_asset_part.box_min", (byte*)&s.BoxMin - at, 40, 40);
              Expect("dm_asset_part.box_max", (byte*)&s.BoxMax - at, 52, 52);
            }
            { MotionDesc s; byte* at = (byte*)&s;
              Expect("dm_motion_desc", sizeof(MotionDesc), 48, 44);
              Expect("dm_motion_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_motion_desc.part_id", (byte*)&s.PartId - at, 4, 4);
              Expect("dm_motion_desc.drag", (byte*)&s.Drag - at, 8, 8);
              Expect("dm_motion_desc.path", (byte*)&s.Path - at, 32, 32);
              Expect("dm_motion_desc.path_count", (byte*)&s.PathCount - at, 40, 36);
              Expect("dm_motion_desc.seed", (byte*)&s.Seed - at, 44, 40);
            }
            { DragFeel s; byte* at = (byte*)&s;
              Expect("dm_drag_feel", sizeof(DragFeel), 24, 24);
              Expect("dm_drag_feel.smoothing_time", (byte*)&s.SmoothingTime - at, 0, 0);
              Expect("dm_drag_feel.soft_limit", (byte*)&s.SoftLimit - at, 4, 4);
              Expect("dm_drag_feel.coast_time", (byte*)&s.CoastTime - at, 8, 8);
              Expect("dm_drag_feel.detent", (byte*)&s.Detent - at, 12, 12);
              Expect("dm_drag_feel.detent_pull", (byte*)&s.DetentPull - at, 16, 16);
              Expect("dm_drag_feel.return_time", (byte*)&s.ReturnTime - at, 20, 20);
            }
            { DragRules s; byte* at = (byte*)&s;
              Expect("dm_drag_rules", sizeof(DragRules), 88, 84);
              Expect("dm_drag_rules.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_drag_rules.flags", (byte*)&s.Flags - at, 4, 4);
              Expect("dm_drag_rules.snaps", (byte*)&s.Snaps - at, 8, 8);
              Expect("dm_drag_rules.snap_count", (byte*)&s.SnapCount - at, 16, 12);
              Expect("dm_drag_rules.snap_reach", (byte*)&s.SnapReach - at, 20, 16);
              Expect("dm_drag_rules.open_share", (byte*)&s.OpenShare - at, 24, 20);
              Expect("dm_drag_rules.closed_share", (byte*)&s.ClosedShare - at, 28, 24);
              Expect("dm_drag_rules.event_time", (byte*)&s.EventTime - at, 32, 28);
              Expect("dm_drag_rules.max_speed", (byte*)&s.MaxSpeed - at, 36, 32);
              Expect("dm_drag_rules.max_acceleration", (byte*)&s.MaxAcceleration - at, 40, 36);
              Expect("dm_drag_rules.lock_give", (byte*)&s.LockGive - at, 44, 40);
              Expect("dm_drag_rules.latch_turn", (byte*)&s.LatchTurn - at, 48, 44);
              Expect("dm_drag_rules.auto_close_share", (byte*)&s.AutoCloseShare - at, 52, 48);
              Expect("dm_drag_rules.auto_close_time", (byte*)&s.AutoCloseTime - at, 56, 52);
              Expect("dm_drag_rules.close_delay", (byte*)&s.CloseDelay - at, 60, 56);
              Expect("dm_drag_rules.tip_share", (byte*)&s.TipShare - at, 64, 60);
              Expect("dm_drag_rules.fall_time", (byte*)&s.FallTime - at, 68, 64);
              Expect("dm_drag_rules.restitution", (byte*)&s.Restitution - at, 72, 68);
              Expect("dm_drag_rules.break_distance", (byte*)&s.BreakDistance - at, 76, 72);
              Expect("dm_drag_rules.drive_speed", (byte*)&s.DriveSpeed - at, 80, 76);
              Expect("dm_drag_rules.reserved", (byte*)&s.Reserved - at, 84, 80);
            }
            { Link s; byte* at = (byte*)&s;
              Expect("dm_link", sizeof(Link), 28, 28);
              Expect("dm_link.driver", (byte*)&s.Driver - at, 0, 0);
              Expect("dm_link.driven", (byte*)&s.Driven - at, 4, 4);
              Expect("dm_link.kind", (byte*)&s.Kind - at, 8, 8);
              Expect("dm_link.flags", (byte*)&s.Flags - at, 12, 12);
              Expect("dm_link.ratio", (byte*)&s.Ratio - at, 16, 16);
              Expect("dm_link.offset", (byte*)&s.Offset - at, 20, 20);
              Expect("dm_link.from", (byte*)&s.From - at, 24, 24);
            }
            { DragDesc s; byte* at = (byte*)&s;
              Expect("dm_drag_desc", sizeof(DragDesc), 96, 88);
              Expect("dm_drag_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_drag_desc.part_id", (byte*)&s.PartId - at, 4, 4);
              Expect("dm_drag_desc.object", (byte*)&s.Object - at, 8, 8);
              Expect("dm_drag_desc.grab_point", (byte*)&s.GrabPoint - at, 16, 16);
              Expect("dm_drag_desc.start_value", (byte*)&s.StartValue - at, 28, 28);
              Expect("dm_drag_desc.feel", (byte*)&s.Feel - at, 32, 32);
              Expect("dm_drag_desc.flags", (byte*)&s.Flags - at, 56, 56);
              Expect("dm_drag_desc.limit_give", (byte*)&s.LimitGive - at, 60, 60);
              Expect("dm_drag_desc.state", (byte*)&s.State - at, 64, 64);
              Expect("dm_drag_desc.scale", (byte*)&s.Scale - at, 72, 68);
              Expect("dm_drag_desc.reserved", (byte*)&s.Reserved - at, 84, 80);
              Expect("dm_drag_desc.rules", (byte*)&s.Rules - at, 88, 84);
            }
            { Hand s; byte* at = (byte*)&s;
              Expect("dm_hand", sizeof(Hand), 56, 56);
              Expect("dm_hand.kind", (byte*)&s.Kind - at, 0, 0);
              Expect("dm_hand.ray", (byte*)&s.Ray - at, 4, 4);
              Expect("dm_hand.point", (byte*)&s.Point - at, 28, 28);
              Expect("dm_hand.amount", (byte*)&s.Amount - at, 40, 40);
              Expect("dm_hand.grab_point", (byte*)&s.GrabPoint - at, 44, 44);
            }
            { DragInput s; byte* at = (byte*)&s;
              Expect("dm_drag_input", sizeof(DragInput), 136, 136);
              Expect("dm_drag_input.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_drag_input.flags", (byte*)&s.Flags - at, 4, 4);
              Expect("dm_drag_input.hand", (byte*)&s.Hand - at, 8, 8);
              Expect("dm_drag_input.second", (byte*)&s.Second - at, 64, 64);
              Expect("dm_drag_input.handles", (byte*)s.Handles - at, 120, 120);
              Expect("dm_drag_input.lower", (byte*)&s.Lower - at, 128, 128);
              Expect("dm_drag_input.upper", (byte*)&s.Upper - at, 132, 132);
            }
            { DragState s; byte* at = (byte*)&s;
              Expect("dm_drag_state", sizeof(DragState), 100, 100);
              Expect("dm_drag_state.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_drag_state.pose", (byte*)&s.Pose - at, 4, 4);
              Expect("dm_drag_state.grab_point", (byte*)&s.GrabPoint - at, 36, 36);
              Expect("dm_drag_state.value", (byte*)&s.Value - at, 48, 48);
              Expect("dm_drag_state.target", (byte*)&s.Target - at, 52, 52);
              Expect("dm_drag_state.velocity", (byte*)&s.Velocity - at, 56, 56);
              Expect("dm_drag_state.at_limit", (byte*)&s.AtLimit - at, 60, 60);
              Expect("dm_drag_state.phase", (byte*)&s.Phase - at, 64, 64);
              Expect("dm_drag_state.changes", (byte*)&s.Changes - at, 68, 68);
              Expect("dm_drag_state.events", (byte*)&s.Events - at, 72, 72);
              Expect("dm_drag_state.detents", (byte*)&s.Detents - at, 76, 76);
              Expect("dm_drag_state.impact", (byte*)&s.Impact - at, 80, 80);
              Expect("dm_drag_state.status", (byte*)&s.Status - at, 84, 84);
              Expect("dm_drag_state.joint_confidence", (byte*)&s.JointConfidence - at, 88, 88);
              Expect("dm_drag_state.joint_basis", (byte*)&s.JointBasis - at, 92, 92);
              Expect("dm_drag_state.open_share", (byte*)&s.OpenShare - at, 96, 96);
            }
            { ReleaseDesc s; byte* at = (byte*)&s;
              Expect("dm_release_desc", sizeof(ReleaseDesc), 32, 32);
              Expect("dm_release_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_release_desc.intent", (byte*)&s.Intent - at, 4, 4);
              Expect("dm_release_desc.duration", (byte*)&s.Duration - at, 8, 8);
              Expect("dm_release_desc.seed", (byte*)&s.Seed - at, 12, 12);
              Expect("dm_release_desc.flags", (byte*)&s.Flags - at, 16, 16);
              Expect("dm_release_desc.away_from", (byte*)&s.AwayFrom - at, 20, 20);
            }
            { ReleasePlan s; byte* at = (byte*)&s;
              Expect("dm_release_plan", sizeof(ReleasePlan), 24, 24);
              Expect("dm_release_plan.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_release_plan.intent", (byte*)&s.Intent - at, 4, 4);
              Expect("dm_release_plan.start_value", (byte*)&s.StartValue - at, 8, 8);
              Expect("dm_release_plan.end_value", (byte*)&s.EndValue - at, 12, 12);
              Expect("dm_release_plan.duration", (byte*)&s.Duration - at, 16, 16);
              Expect("dm_release_plan.from_network", (byte*)&s.FromNetwork - at, 20, 20);
            }
            { Camera s; byte* at = (byte*)&s;
              Expect("dm_camera", sizeof(Camera), 56, 56);
              Expect("dm_camera.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_camera.fov_y", (byte*)&s.FovY - at, 4, 4);
              Expect("dm_camera.eye", (byte*)&s.Eye - at, 8, 8);
              Expect("dm_camera.forward", (byte*)&s.Forward - at, 20, 20);
              Expect("dm_camera.up", (byte*)&s.Up - at, 32, 32);
              Expect("dm_camera.viewport_width", (byte*)&s.ViewportWidth - at, 44, 44);
              Expect("dm_camera.viewport_height", (byte*)&s.ViewportHeight - at, 48, 48);
              Expect("dm_camera.ortho_height", (byte*)&s.OrthoHeight - at, 52, 52);
            }
            { SceneDesc s; byte* at = (byte*)&s;
              Expect("dm_scene_desc", sizeof(SceneDesc), 8, 8);
              Expect("dm_scene_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_scene_desc.reserved", (byte*)&s.Reserved - at, 4, 4);
            }
            { Hit s; byte* at = (byte*)&s;
              Expect("dm_hit", sizeof(Hit), 72, 72);
              Expect("dm_hit.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_hit.instance", (byte*)&s.Instance - at, 4, 4);
              Expect("dm_hit.object", (byte*)&s.Object - at, 8, 8);
              Expect("dm_hit.part_id", (byte*)&s.PartId - at, 16, 16);
              Expect("dm_hit.triangle", (byte*)&s.Triangle - at, 20, 20);
              Expect("dm_hit.distance", (byte*)&s.Distance - at, 24, 24);
              Expect("dm_hit.u", (byte*)&s.U - at, 28, 28);
              Expect("dm_hit.v", (byte*)&s.V - at, 32, 32);
              Expect("dm_hit.point", (byte*)&s.Point - at, 36, 36);
              Expect("dm_hit.normal", (byte*)&s.Normal - at, 48, 48);
              Expect("dm_hit.object_point", (byte*)&s.ObjectPoint - at, 60, 60);
            }
            { Core1 s; byte* at = (byte*)&s;
              Expect("dm_core_1", sizeof(Core1), 504, 256);
              Expect("dm_core_1.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_core_1.reserved", (byte*)&s.Reserved - at, 4, 4);
              Expect("dm_core_1.result_string", (byte*)&s.ResultString - at, 8, 8);
              Expect("dm_core_1.version", (byte*)&s.Version - at, 16, 12);
              Expect("dm_core_1.context_create", (byte*)&s.ContextCreate - at, 24, 16);
              Expect("dm_core_1.context_destroy", (byte*)&s.ContextDestroy - at, 32, 20);
              Expect("dm_core_1.context_get_memory", (byte*)&s.ContextGetMemory - at, 40, 24);
              Expect("dm_core_1.model_load", (byte*)&s.ModelLoad - at, 48, 28);
              Expect("dm_core_1.model_unload", (byte*)&s.ModelUnload - at, 56, 32);
              Expect("dm_core_1.mesh_find_part", (byte*)&s.MeshFindPart - at, 64, 36);
              Expect("dm_core_1.object_prepare", (byte*)&s.ObjectPrepare - at, 72, 40);
              Expect("dm_core_1.object_save", (byte*)&s.ObjectSave - at, 80, 44);
              Expect("dm_core_1.object_load", (byte*)&s.ObjectLoad - at, 88, 48);
              Expect("dm_core_1.object_destroy", (byte*)&s.ObjectDestroy - at, 96, 52);
              Expect("dm_core_1.object_get_info", (byte*)&s.ObjectGetInfo - at, 104, 56);
              Expect("dm_core_1.object_get_part", (byte*)&s.ObjectGetPart - at, 112, 60);
              Expect("dm_core_1.object_get_joint", (byte*)&s.ObjectGetJoint - at, 120, 64);
              Expect("dm_core_1.object_get_hypotheses", (byte*)&s.ObjectGetHypotheses - at, 128, 68);
              Expect("dm_core_1.object_refine", (byte*)&s.ObjectRefine - at, 136, 72);
              Expect("dm_core_1.object_set_joint", (byte*)&s.ObjectSetJoint - at, 144, 76);
              Expect("dm_core_1.object_reset_joint", (byte*)&s.ObjectResetJoint - at, 152, 80);
              Expect("dm_core_1.joint_pose", (byte*)&s.JointPose - at, 160, 84);
              Expect("dm_core_1.joint_value", (byte*)&s.JointValue - at, 168, 88);
              Expect("dm_core_1.joint_get_frame", (byte*)&s.JointGetFrame - at, 176, 92);
              Expect("dm_core_1.joint_scale", (byte*)&s.JointScale - at, 184, 96);
              Expect("dm_core_1.motion_generate", (byte*)&s.MotionGenerate - at, 192, 100);
              Expect("dm_core_1.motion_sample", (byte*)&s.MotionSample - at, 200, 104);
              Expect("dm_core_1.motion_get_frames", (byte*)&s.MotionGetFrames - at, 208, 108);
              Expect("dm_core_1.motion_destroy", (byte*)&s.MotionDestroy - at, 216, 112);
              Expect("dm_core_1.drag_begin", (byte*)&s.DragBegin - at, 224, 116);
              Expect("dm_core_1.drag_update", (byte*)&s.DragUpdate - at, 232, 120);
              Expect("dm_core_1.drag_release", (byte*)&s.DragRelease - at, 240, 124);
              Expect("dm_core_1.drag_end", (byte*)&s.DragEnd - at, 248, 128);
              Expect("dm_core_1.drag_get_part_state", (byte*)&s.DragGetPartState - at, 256, 132);
              Expect("dm_core_1.drag_snapshot_size", (byte*)&s.DragSnapshotSize - at, 264, 136);
              Expect("dm_core_1.drag_save", (byte*)&s.DragSave - at, 272, 140);
              Expect("dm_core_1.drag_restore", (byte*)&s.DragRestore - at, 280, 144);
              Expect("dm_core_1.pose_multiply", (byte*)&s.PoseMultiply - at, 288, 148);
              Expect("dm_core_1.pose_to_matrix", (byte*)&s.PoseToMatrix - at, 296, 152);
              Expect("dm_core_1.pose_apply_points", (byte*)&s.PoseApplyPoints - at, 304, 156);
              Expect("dm_core_1.camera_ray", (byte*)&s.CameraRay - at, 312, 160);
              Expect("dm_core_1.scene_create", (byte*)&s.SceneCreate - at, 320, 164);
              Expect("dm_core_1.scene_destroy", (byte*)&s.SceneDestroy - at, 328, 168);
              Expect("dm_core_1.scene_add", (byte*)&s.SceneAdd - at, 336, 172);
              Expect("dm_core_1.scene_move", (byte*)&s.SceneMove - at, 344, 176);
              Expect("dm_core_1.scene_remove", (byte*)&s.SceneRemove - at, 352, 180);
              Expect("dm_core_1.scene_commit", (byte*)&s.SceneCommit - at, 360, 184);
              Expect("dm_core_1.scene_pick", (byte*)&s.ScenePick - at, 368, 188);
              Expect("dm_core_1.drag_step", (byte*)&s.DragStep - at, 376, 192);
              Expect("dm_core_1.drag_take", (byte*)&s.DragTake - at, 384, 196);
              Expect("dm_core_1.object_set_links", (byte*)&s.ObjectSetLinks - at, 392, 200);
              Expect("dm_core_1.object_follow_links", (byte*)&s.ObjectFollowLinks - at, 400, 204);
              Expect("dm_core_1.joint_value_at", (byte*)&s.JointValueAt - at, 408, 208);
              Expect("dm_core_1.pose_inverse", (byte*)&s.PoseInverse - at, 416, 212);
              Expect("dm_core_1.pose_from_rotation", (byte*)&s.PoseFromRotation - at, 424, 216);
              Expect("dm_core_1.asset_create", (byte*)&s.AssetCreate - at, 432, 220);
              Expect("dm_core_1.asset_destroy", (byte*)&s.AssetDestroy - at, 440, 224);
              Expect("dm_core_1.asset_get_info", (byte*)&s.AssetGetInfo - at, 448, 228);
              Expect("dm_core_1.asset_get_part", (byte*)&s.AssetGetPart - at, 456, 232);
              Expect("dm_core_1.asset_get_joint", (byte*)&s.AssetGetJoint - at, 464, 236);
              Expect("dm_core_1.asset_get_part_nodes", (byte*)&s.AssetGetPartNodes - at, 472, 240);
              Expect("dm_core_1.asset_get_node_parts", (byte*)&s.AssetGetNodeParts - at, 480, 244);
              Expect("dm_core_1.asset_make_object", (byte*)&s.AssetMakeObject - at, 488, 248);
              Expect("dm_core_1.context_trim", (byte*)&s.ContextTrim - at, 496, 252);
            }
            { GltfFiles s; byte* at = (byte*)&s;
              Expect("dm_gltf_files", sizeof(GltfFiles), 24, 12);
              Expect("dm_gltf_files.user", (byte*)&s.User - at, 0, 0);
              Expect("dm_gltf_files.open", (byte*)&s.Open - at, 8, 4);
              Expect("dm_gltf_files.close", (byte*)&s.Close - at, 16, 8);
            }
            { GltfDesc s; byte* at = (byte*)&s;
              Expect("dm_gltf_desc", sizeof(GltfDesc), 104, 56);
              Expect("dm_gltf_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_gltf_desc.reserved", (byte*)&s.Reserved - at, 4, 4);
              Expect("dm_gltf_desc.data", (byte*)&s.Data - at, 8, 8);
              Expect("dm_gltf_desc.size", (byte*)&s.Size - at, 16, 12);
              Expect("dm_gltf_desc.allocator", (byte*)&s.Allocator - at, 24, 16);
              Expect("dm_gltf_desc.log", (byte*)&s.Log - at, 48, 28);
              Expect("dm_gltf_desc.files", (byte*)&s.Files - at, 64, 36);
              Expect("dm_gltf_desc.progress", (byte*)&s.Progress - at, 88, 48);
              Expect("dm_gltf_desc.progress_user", (byte*)&s.ProgressUser - at, 96, 52);
            }
            { GltfNode s; byte* at = (byte*)&s;
              Expect("dm_gltf_node", sizeof(GltfNode), 64, 64);
              Expect("dm_gltf_node.name", (byte*)&s.Name - at, 0, 0);
              Expect("dm_gltf_node.node", (byte*)&s.Node - at, 8, 4);
              Expect("dm_gltf_node.carrier", (byte*)&s.Carrier - at, 12, 8);
              Expect("dm_gltf_node.first_vertex", (byte*)&s.FirstVertex - at, 16, 16);
              Expect("dm_gltf_node.vertex_count", (byte*)&s.VertexCount - at, 24, 24);
              Expect("dm_gltf_node.first_face", (byte*)&s.FirstFace - at, 32, 32);
              Expect("dm_gltf_node.face_count", (byte*)&s.FaceCount - at, 40, 40);
              Expect("dm_gltf_node.colour", (byte*)s.Colour - at, 48, 48);
            }
            { GltfSurface s; byte* at = (byte*)&s;
              Expect("dm_gltf_surface", sizeof(GltfSurface), 56, 48);
              Expect("dm_gltf_surface.first_face", (byte*)&s.FirstFace - at, 0, 0);
              Expect("dm_gltf_surface.face_count", (byte*)&s.FaceCount - at, 8, 8);
              Expect("dm_gltf_surface.colour", (byte*)s.Colour - at, 16, 16);
              Expect("dm_gltf_surface.image", (byte*)&s.Image - at, 32, 32);
              Expect("dm_gltf_surface.image_size", (byte*)&s.ImageSize - at, 40, 36);
              Expect("dm_gltf_surface.wrap_u", (byte*)&s.WrapU - at, 48, 40);
              Expect("dm_gltf_surface.wrap_v", (byte*)&s.WrapV - at, 52, 44);
            }
            { GltfTrack s; byte* at = (byte*)&s;
              Expect("dm_gltf_track", sizeof(GltfTrack), 48, 32);
              Expect("dm_gltf_track.name", (byte*)&s.Name - at, 0, 0);
              Expect("dm_gltf_track.face_ids", (byte*)&s.FaceIds - at, 8, 4);
              Expect("dm_gltf_track.value", (byte*)&s.Value - at, 16, 8);
              Expect("dm_gltf_track.reserved", (byte*)s.Reserved - at, 17, 9);
              Expect("dm_gltf_track.poses", (byte*)&s.Poses - at, 24, 16);
              Expect("dm_gltf_track.times", (byte*)&s.Times - at, 32, 20);
              Expect("dm_gltf_track.key_count", (byte*)&s.KeyCount - at, 40, 24);
              Expect("dm_gltf_track.reserved2", (byte*)&s.Reserved2 - at, 44, 28);
            }
            { GltfPart s; byte* at = (byte*)&s;
              Expect("dm_gltf_part", sizeof(GltfPart), 56, 48);
              Expect("dm_gltf_part.name", (byte*)&s.Name - at, 0, 0);
              Expect("dm_gltf_part.positions", (byte*)&s.Positions - at, 8, 4);
              Expect("dm_gltf_part.indices", (byte*)&s.Indices - at, 16, 8);
              Expect("dm_gltf_part.vertex_count", (byte*)&s.VertexCount - at, 24, 16);
              Expect("dm_gltf_part.index_count", (byte*)&s.IndexCount - at, 32, 24);
              Expect("dm_gltf_part.colour", (byte*)s.Colour - at, 40, 32);
            }
            { GltfRigDesc s; byte* at = (byte*)&s;
              Expect("dm_gltf_rig_desc", sizeof(GltfRigDesc), 144, 92);
              Expect("dm_gltf_rig_desc.struct_size", (byte*)&s.StructSize - at, 0, 0);
              Expect("dm_gltf_rig_desc.formats", (byte*)&s.Formats - at, 4, 4);
              Expect("dm_gltf_rig_desc.nodes", (byte*)&s.Nodes - at, 8, 8);
              Expect("dm_gltf_rig_desc.parts", (byte*)&s.Parts - at, 16, 12);
              Expect("dm_gltf_rig_desc.joints", (byte*)&s.Joints - at, 24, 16);
              Expect("dm_gltf_rig_desc.node_parts", (byte*)&s.NodeParts - at, 32, 20);
              Expect("dm_gltf_rig_desc.colours", (byte*)&s.Colours - at, 40, 24);
              Expect("dm_gltf_rig_desc.name", (byte*)&s.Name - at, 48, 28);
              Expect("dm_gltf_rig_desc.part_names", (byte*)&s.PartNames - at, 56, 32);
              Expect("dm_gltf_rig_desc.gltf", (byte*)&s.Gltf - at, 64, 36);
              Expect("dm_gltf_rig_desc.node_count", (byte*)&s.NodeCount - at, 72, 40);
              Expect("dm_gltf_rig_desc.part_count", (byte*)&s.PartCount - at, 76, 44);
              Expect("dm_gltf_rig_desc.axes", (byte*)&s.Axes - at, 80, 48);
              Expect("dm_gltf_rig_desc.unit_in_metres", (byte*)&s.UnitInMetres - at, 84, 52);
              Expect("dm_gltf_rig_desc.density", (byte*)&s.Density - at, 88, 56);
              Expect("dm_gltf_rig_desc.thickness", (byte*)&s.Thickness - at, 92, 60);
              Expect("dm_gltf_rig_desc.friction", (byte*)&s.Friction - at, 96, 64);
              Expect("dm_gltf_rig_desc.damping_time", (byte*)&s.DampingTime - at, 100, 68);
              Expect("dm_gltf_rig_desc.allocator", (byte*)&s.Allocator - at, 104, 72);
              Expect("dm_gltf_rig_desc.log", (byte*)&s.Log - at, 128, 84);
            }
            { GltfRigFile s; byte* at = (byte*)&s;
              Expect("dm_gltf_rig_file", sizeof(GltfRigFile), 24, 12);
              Expect("dm_gltf_rig_file.path", (byte*)&s.Path - at, 0, 0);
              Expect("dm_gltf_rig_file.data", (byte*)&s.Data - at, 8, 4);
              Expect("dm_gltf_rig_file.size", (byte*)&s.Size - at, 16, 8);
            }
            return compared;
        }
    }
}
