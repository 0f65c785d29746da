use crate::error::{check, Result};
use crate::sys;

pub use sys::dm_camera as Camera;
pub use sys::dm_drag_feel as Feel;
pub use sys::dm_drag_hint as Hint;
pub use sys::dm_drag_state as DragState;
pub use sys::dm_hit as Hit;
pub use sys::dm_joint as Joint;
pub use sys::dm_joint_end as JointEnd;
pub use sys::dm_joint_frame as JointFrame;
pub use sys::dm_link as Link;
pub use sys::dm_memory_info as MemoryInfo;
pub use sys::dm_object_info as ObjectInfo;
pub use sys::dm_part_info as PartInfo;
pub use sys::dm_part_state as PartState;
pub use sys::dm_pivot as Pivot;
pub use sys::dm_pose as Pose;
pub use sys::dm_ray as Ray;
pub use sys::dm_release_plan as ReleasePlan;
pub use sys::dm_vec3 as Vec3;

/// How a part moves: [`JointExt::kind`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum JointKind {
    #[default]
    Unknown,
    Revolute,
    Prismatic,
    Screw,
    Continuous,
    Fixed,
}

impl JointKind {
    pub(crate) fn from_c(number: i32) -> Self {
        match number {
            sys::DM_JOINT_REVOLUTE => Self::Revolute,
            sys::DM_JOINT_PRISMATIC => Self::Prismatic,
            sys::DM_JOINT_SCREW => Self::Screw,
            sys::DM_JOINT_CONTINUOUS => Self::Continuous,
            sys::DM_JOINT_FIXED => Self::Fixed,
            _ => Self::Unknown,
        }
    }

    pub(crate) fn to_c(self) -> i32 {
        match self {
            Self::Unknown => sys::DM_JOINT_UNKNOWN,
            Self::Revolute => sys::DM_JOINT_REVOLUTE,
            Self::Prismatic => sys::DM_JOINT_PRISMATIC,
            Self::Screw => sys::DM_JOINT_SCREW,
            Self::Continuous => sys::DM_JOINT_CONTINUOUS,
            Self::Fixed => sys::DM_JOINT_FIXED,
        }
    }
}

/// A struct that goes to C with its true size, whatever a caller has written into it.
pub(crate) trait Sized: Copy {
    fn sized(&self) -> Self;
}

macro_rules! sized {
    ($($name:ty),*) => {
        $(impl Sized for $name {
            fn sized(&self) -> Self {
                let mut copy = *self;
                copy.struct_size = std::mem::size_of::<Self>() as u32;
                copy
            }
        })*
    };
}
sized!(Joint, Camera, sys::dm_drag_input, sys::dm_drag_rules);

impl Sized for PartState {
    fn sized(&self) -> Self {
        let mut copy = *self;
        copy.struct_size = std::mem::size_of::<Self>() as u32;
        copy.joint = copy.joint.sized();
        copy
    }
}

pub trait Vec3Ext {
    fn new(x: f32, y: f32, z: f32) -> Self;
}

impl Vec3Ext for Vec3 {
    fn new(x: f32, y: f32, z: f32) -> Self {
        Vec3 { x, y, z }
    }
}

pub trait PoseExt: core::marker::Sized {
    /// No motion.
    fn identity() -> Self;
    /// A rotation by a quaternion x, y, z, w of any length, then a translation.
    fn from_rotation(rotation: [f32; 4], translation: Vec3) -> Result<Pose>;
    /// `self` after `first`.
    fn after(&self, first: &Pose) -> Pose;
    /// The motion back.
    fn inverse(&self) -> Pose;
    /// A point moved by it.
    fn apply(&self, point: Vec3) -> Vec3;
    /// Moves points in place.
    fn apply_all(&self, points: &mut [[f32; 3]]);
    /// 16 numbers, column by column.
    fn matrix(&self) -> [f32; 16];
}

impl PoseExt for Pose {
    /// ```
    /// use dragmesh::{prelude::*, Pose, Vec3};
    /// let point = Pose::identity().apply(Vec3::new(1.0, 2.0, 3.0));
    /// assert_eq!([point.x, point.y, point.z], [1.0, 2.0, 3.0]);
    /// ```
    fn identity() -> Self {
        Pose { real: [0.0, 0.0, 0.0, 1.0], dual: [0.0; 4] }
    }

    fn from_rotation(rotation: [f32; 4], translation: Vec3) -> Result<Pose> {
        let mut pose = Pose::default();
        check(unsafe { sys::dm_pose_from_rotation(rotation.as_ptr(), translation, &mut pose) })?;
        Ok(pose)
    }

    fn after(&self, first: &Pose) -> Pose {
        let mut product = Pose::default();
        unsafe { sys::dm_pose_multiply(self, first, &mut product) };
        product
    }

    fn inverse(&self) -> Pose {
        let mut back = Pose::default();
        unsafe { sys::dm_pose_inverse(self, &mut back) };
        back
    }

    fn apply(&self, point: Vec3) -> Vec3 {
        let mut moved = [[point.x, point.y, point.z]];
        self.apply_all(&mut moved);
        Vec3::new(moved[0][0], moved[0][1], moved[0][2])
    }

    fn apply_all(&self, points: &mut [[f32; 3]]) {
        let data = points.as_mut_ptr().cast::<f32>();
        unsafe { sys::dm_pose_apply_points(self, data, 0, data, 0, points.len()) };
    }

    fn matrix(&self) -> [f32; 16] {
        let mut columns = [0.0; 16];
        unsafe { sys::dm_pose_to_matrix(self, columns.as_mut_ptr()) };
        columns
    }
}

pub trait JointExt: core::marker::Sized {
    fn kind(&self) -> JointKind;
    /// The pose at a joint value.
    fn pose_at(&self, value: f32) -> Result<Pose>;
    /// The joint value at a share of the way from rest (0) to the open end (1).
    fn value_at(&self, share: f32) -> Result<f32>;
    /// The value at which the joint comes nearest to a pose, and how far off it the pose is: angle, distance.
    fn value_of(&self, pose: &Pose) -> Result<(f32, f32, f32)>;
    /// The joint as a constraint of a physics engine.
    fn frame(&self) -> Result<JointFrame>;
    /// The joint of an instance scaled along the axes of the object frame.
    fn scaled(&self, scale: Vec3) -> Result<Joint>;
}

impl JointExt for Joint {
    fn kind(&self) -> JointKind {
        JointKind::from_c(self.type_)
    }

    fn pose_at(&self, value: f32) -> Result<Pose> {
        let mut pose = Pose::default();
        check(unsafe { sys::dm_joint_pose(&self.sized(), value, &mut pose) })?;
        Ok(pose)
    }

    fn value_at(&self, share: f32) -> Result<f32> {
        let mut value = 0.0;
        check(unsafe { sys::dm_joint_value_at(&self.sized(), share, &mut value) })?;
        Ok(value)
    }

    fn value_of(&self, pose: &Pose) -> Result<(f32, f32, f32)> {
        let (mut value, mut angle, mut distance) = (0.0, 0.0, 0.0);
        check(unsafe { sys::dm_joint_value(&self.sized(), pose, &mut value, &mut angle, &mut distance) })?;
        Ok((value, angle, distance))
    }

    fn frame(&self) -> Result<JointFrame> {
        let mut frame = JointFrame::default();
        check(unsafe { sys::dm_joint_get_frame(&self.sized(), &mut frame) })?;
        Ok(frame)
    }

    fn scaled(&self, scale: Vec3) -> Result<Joint> {
        let mut joint = Joint::default();
        check(unsafe { sys::dm_joint_scale(&self.sized(), scale, &mut joint) })?;
        Ok(joint)
    }
}
