use crate::error::{check, Result};
use crate::values::{Hint, Joint, Link, ObjectInfo, PartInfo, Pose, Sized, Vec3};
use crate::{sys, Context, Drag, DragOptions, Error, Model};
use std::sync::Arc;

pub(crate) struct ObjectInner {
    pub(crate) id: sys::dm_object,
    pub(crate) context: Context,
    _model: Option<Model>,
}

impl Drop for ObjectInner {
    fn drop(&mut self) {
        unsafe fn end(context: *mut sys::dm_context, id: u64) {
            sys::dm_object_destroy(context, id);
        }
        self.context.0.end(end, self.id);
    }
}

/// A prepared object: parts and their joints. Drags, motions and scenes of it keep it.
pub struct Object(pub(crate) Arc<ObjectInner>);

impl Object {
    pub(crate) fn new(context: Context, id: sys::dm_object, model: Option<Model>) -> Self {
        Self(Arc::new(ObjectInner { id, context, _model: model }))
    }

    fn pointer(&self) -> Result<*mut sys::dm_context> {
        self.0.context.pointer()
    }

    /// As `Hit::object` has it.
    pub fn id(&self) -> u64 {
        self.0.id
    }

    pub fn info(&self) -> Result<ObjectInfo> {
        let mut info = ObjectInfo::default();
        check(unsafe { sys::dm_object_get_info(self.pointer()?, self.id(), &mut info) })?;
        Ok(info)
    }

    /// All parts, in order of id.
    pub fn parts(&self) -> Result<Vec<PartInfo>> {
        let part = |index| {
            let mut part = PartInfo::default();
            check(unsafe { sys::dm_object_get_part(self.pointer()?, self.id(), index, &mut part) })?;
            Ok(part)
        };
        (0..self.info()?.part_count).map(part).collect()
    }

    /// The joint in force.
    pub fn joint(&self, part: u32) -> Result<Joint> {
        let mut joint = Joint::default();
        check(unsafe { sys::dm_object_get_joint(self.pointer()?, self.id(), part, &mut joint) })?;
        Ok(joint)
    }

    /// All that were found, most probable first; ranked by a drag where one is given.
    pub fn hypotheses(&self, part: u32, drag: Option<&Hint>) -> Result<Vec<Joint>> {
        let mut joints = vec![Joint::default(); sys::DM_MAX_HYPOTHESES as usize];
        let (hint, mut count) = (drag.map_or(std::ptr::null(), |drag| drag), 0);
        let room = joints.len() as u32;
        check(unsafe {
            sys::dm_object_get_hypotheses(self.pointer()?, self.id(), part, hint, joints.as_mut_ptr(), room, &mut count)
        })?;
        joints.truncate(count as usize);
        Ok(joints)
    }

    pub fn set_joint(&mut self, part: u32, joint: &Joint) -> Result<()> {
        check(unsafe { sys::dm_object_set_joint(self.pointer()?, self.id(), part, &joint.sized()) })
    }

    /// Puts the library's own answer back in force.
    pub fn reset_joint(&mut self, part: u32) -> Result<()> {
        check(unsafe { sys::dm_object_reset_joint(self.pointer()?, self.id(), part) })
    }

    /// Infers the joint again, with a player's drag as evidence.
    pub fn refine(&mut self, part: u32, drag: &Hint) -> Result<()> {
        check(unsafe { sys::dm_object_refine(self.pointer()?, self.id(), part, drag) })
    }

    /// Links parts, in place of the links of before.
    pub fn set_links(&mut self, links: &[Link]) -> Result<()> {
        let count = u32::try_from(links.len()).map_err(|_| Error::invalid("too many links"))?;
        check(unsafe { sys::dm_object_set_links(self.pointer()?, self.id(), links.as_ptr(), count) })
    }

    /// Moves what is linked with a part that has moved. values: one a part, in order of id. Returns which parts links
    /// hold where they are.
    pub fn follow_links(&self, part: u32, values: &mut [f32]) -> Result<Vec<bool>> {
        let count = u32::try_from(values.len()).map_err(|_| Error::invalid("too many values"))?;
        let mut held = vec![0; values.len()];
        check(unsafe {
            let (values, held) = (values.as_mut_ptr(), held.as_mut_ptr());
            sys::dm_object_follow_links(self.pointer()?, self.id(), part, values, held, count)
        })?;
        Ok(held.iter().map(|&one| one != 0).collect())
    }

    /// The bytes of a `.dmo`.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        let mut size = 0;
        check(unsafe { sys::dm_object_save(self.pointer()?, self.id(), std::ptr::null_mut(), 0, &mut size) })?;
        let mut data = vec![0; size];
        check(unsafe { sys::dm_object_save(self.pointer()?, self.id(), data.as_mut_ptr().cast(), size, &mut size) })?;
        Ok(data)
    }

    /// Grabs a part.
    pub fn grab(&self, how: &DragOptions) -> Result<Drag> {
        Drag::begin(&self.0, how)
    }

    /// The network's motion for a drag, or for a path that the pointer drew.
    pub fn motion(&self, part: u32, drag: &Hint, path: &[Vec3], seed: u32) -> Result<Motion> {
        let desc = sys::dm_motion_desc {
            part_id: part,
            drag: *drag,
            path: if path.is_empty() { std::ptr::null() } else { path.as_ptr() },
            path_count: u32::try_from(path.len()).map_err(|_| Error::invalid("the path is too long"))?,
            seed,
            ..Default::default()
        };
        let mut id = 0;
        check(unsafe { sys::dm_motion_generate(self.pointer()?, self.id(), &desc, &mut id) })?;
        Ok(Motion { id, of: self.0.clone() })
    }
}

/// A generated motion.
pub struct Motion {
    id: sys::dm_motion,
    of: Arc<ObjectInner>,
}

impl Motion {
    /// The pose and joint value at t, 0 to 1.
    pub fn sample(&mut self, t: f32) -> Result<(Pose, f32)> {
        let (mut pose, mut value) = (Pose::default(), 0.0);
        check(unsafe { sys::dm_motion_sample(self.of.context.pointer()?, self.id, t, &mut pose, &mut value) })?;
        Ok((pose, value))
    }
}

impl Drop for Motion {
    fn drop(&mut self) {
        unsafe fn end(context: *mut sys::dm_context, id: u64) {
            sys::dm_motion_destroy(context, id);
        }
        self.of.context.0.end(end, self.id);
    }
}
