use crate::error::{check, Result};
use crate::object::ObjectInner;
use crate::values::{Hit, Pose, Ray};
use crate::{sys, Context, Error, Object};
use std::collections::HashMap;
use std::sync::Arc;

/// Placed objects that rays can pick.
pub struct Scene {
    id: sys::dm_scene,
    context: Context,
    placed: HashMap<u32, Arc<ObjectInner>>, // an object that ends leaves its scenes
}

impl Scene {
    pub(crate) fn new(context: Context, id: sys::dm_scene) -> Self {
        Self { id, context, placed: HashMap::new() }
    }

    /// Places an object of the same context and returns its instance. placement: from object to world.
    pub fn add(&mut self, object: &Object, placement: Option<&Pose>) -> Result<u32> {
        if !Arc::ptr_eq(&self.context.0, &object.0.context.0) {
            return Err(Error::invalid("the object is of another context"));
        }
        let (pose, mut instance) = (placement.map_or(std::ptr::null(), |pose| pose), 0);
        check(unsafe { sys::dm_scene_add(self.context.pointer()?, self.id, object.0.id, pose, &mut instance) })?;
        self.placed.insert(instance, object.0.clone());
        Ok(instance)
    }

    /// Moves a part, or with part 0 the instance.
    pub fn place(&mut self, instance: u32, part: u32, pose: &Pose) -> Result<()> {
        check(unsafe { sys::dm_scene_move(self.context.pointer()?, self.id, instance, part, pose) })
    }

    pub fn remove(&mut self, instance: u32) -> Result<()> {
        check(unsafe { sys::dm_scene_remove(self.context.pointer()?, self.id, instance) })?;
        self.placed.remove(&instance);
        Ok(())
    }

    /// Makes moves visible to picks: once a frame.
    pub fn commit(&mut self) -> Result<()> {
        check(unsafe { sys::dm_scene_commit(self.context.pointer()?, self.id) })
    }

    /// The nearest hit of a ray.
    pub fn pick(&self, ray: &Ray) -> Result<Option<Hit>> {
        let mut hit = Hit::default();
        check(unsafe { sys::dm_scene_pick(self.context.pointer()?, self.id, ray, &mut hit) })?;
        Ok(Some(hit).filter(|hit| hit.object != 0))
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        unsafe fn end(context: *mut sys::dm_context, id: u64) {
            sys::dm_scene_destroy(context, id);
        }
        self.context.0.end(end, self.id);
    }
}
