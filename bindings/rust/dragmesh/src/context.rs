use crate::callback::{guarded, is_running};
use crate::error::{check, remember, Error, Result};
use crate::values::{Camera, Hint, MemoryInfo, Ray, Sized};
use crate::{sys, Mesh, Object, Prepare, Scene};
use std::ffi::CStr;
use std::os::raw::{c_char, c_void};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex};

/// The host's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axes {
    /// Right-handed, y up: glTF, Bevy, Godot, OpenGL.
    #[default]
    Gltf,
    Unity,
    Unreal,
    /// Right-handed, z up.
    Blender,
}

/// What picks rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Picking {
    #[default]
    Auto,
    Embree,
    Portable,
    None,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Error,
    Warning,
    Info,
}

type Log = Box<dyn Fn(Level, &str) + Send + Sync>;
type Progress = Box<dyn Fn(f32) -> bool + Send + Sync>;

/// How to make a context.
#[derive(Default)]
pub struct ContextOptions {
    pub axes: Axes,
    /// Length of one host unit; 0 = 1.
    pub unit_in_metres: f32,
    pub picking: Picking,
    /// Gets the messages. It must not call this context.
    pub log: Option<Log>,
    /// Of calls that take long for a large mesh, preparations with a callback of their own aside: gets 0 .. 1, rising;
    /// returns false to cancel. A panic cancels too.
    pub progress: Option<Progress>,
    /// How many threads prepare parts side by side; 0 and 1: the caller's alone. Answers keep their bits.
    pub threads: u32,
}

/// What the callbacks of a context read.
struct Hooks {
    log: Option<Log>,
    progress: Option<Progress>,
    threads: u32,
}

/// Ends what a handle names.
pub(crate) type End = unsafe fn(*mut sys::dm_context, u64);

pub(crate) struct ContextInner {
    pointer: *mut sys::dm_context,
    hooks: Box<Hooks>, // the library holds a pointer to it, which names the context to callbacks
    late: Mutex<Vec<(End, u64)>>, // dropped in callbacks, where the library is not called
    has_late: AtomicBool,
}

impl ContextInner {
    fn name(&self) -> usize {
        &*self.hooks as *const Hooks as usize
    }

    /// Ends what is dropped: now, or in a callback after the call that has called it.
    pub(crate) fn end(&self, end: End, handle: u64) {
        if !is_running(self.name()) {
            unsafe { end(self.pointer, handle) }
        } else if let Ok(mut late) = self.late.lock() {
            late.push((end, handle));
            self.has_late.store(true, Ordering::Release);
        }
    }

    fn end_late(&self) {
        if !self.has_late.swap(false, Ordering::AcqRel) {
            return;
        }
        let late = self.late.lock().map(|mut late| std::mem::take(&mut *late)).unwrap_or_default();
        for (end, handle) in late {
            unsafe { end(self.pointer, handle) }
        }
    }
}

// The library is callable from any thread; what is not, takes &mut self in the layer above.
unsafe impl Send for ContextInner {}
unsafe impl Sync for ContextInner {}

impl Drop for ContextInner {
    fn drop(&mut self) {
        unsafe { sys::dm_context_destroy(self.pointer) }
    }
}

/// A context of the library. It lives until all that was made with it is gone.
#[derive(Clone)]
pub struct Context(pub(crate) Arc<ContextInner>);

unsafe extern "C" fn on_message(user: *mut c_void, level: i32, _code: sys::dm_result, text: *const c_char) {
    // A log that panics is no reason to fail the call.
    let _ = guarded(user as usize, || {
        let text = CStr::from_ptr(text).to_string_lossy();
        let level = match level {
            sys::DM_LOG_ERROR => Level::Error,
            sys::DM_LOG_WARNING => Level::Warning,
            _ => Level::Info,
        };
        if level == Level::Error {
            remember(&text);
        }
        if let Some(log) = &(*user.cast::<Hooks>()).log {
            log(level, &text);
        }
    })
    .map_err(std::mem::forget); // what a panic carries may panic when it is dropped
}

unsafe extern "C" fn on_progress(user: *mut c_void, done: f32) -> i32 {
    let goes_on = |hooks: &Hooks| hooks.progress.as_ref().map_or(true, |progress| progress(done));
    match guarded(user as usize, || goes_on(&*user.cast::<Hooks>())) {
        Ok(goes_on) => i32::from(!goes_on),
        Err(panic) => {
            std::mem::forget(panic);
            1
        }
    }
}

struct Task {
    run: unsafe extern "C" fn(*mut c_void, u32),
    data: *mut c_void,
}

// The library hands it over to be run on any thread.
unsafe impl Sync for Task {}

impl Task {
    fn run_from(&self, next: &AtomicU32, count: u32) {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return;
            }
            unsafe { (self.run)(self.data, index) }
        }
    }
}

unsafe extern "C" fn on_jobs(user: *mut c_void, count: u32, task: sys::dm_task, data: *mut c_void) -> i32 {
    let (hooks, run) = match task {
        Some(run) => (&*user.cast::<Hooks>(), run),
        None => return 0,
    };
    let (task, next) = (Task { run, data }, AtomicU32::new(0));
    std::thread::scope(|scope| {
        for _ in 1..hooks.threads.min(count) {
            // Where no thread is to be had, the others do its share.
            let _ = std::thread::Builder::new().spawn_scoped(scope, || task.run_from(&next, count));
        }
        task.run_from(&next, count);
    });
    1
}

impl Context {
    /// ```
    /// use dragmesh::{Context, ContextOptions};
    /// let context = Context::new(ContextOptions::default())?;
    /// assert!(context.memory()?.bytes > 0);
    /// # Ok::<(), dragmesh::Error>(())
    /// ```
    pub fn new(options: ContextOptions) -> Result<Self> {
        let hooks = Box::new(Hooks { log: options.log, progress: options.progress, threads: options.threads });
        let user = &*hooks as *const Hooks as *mut c_void;
        let mut desc = sys::dm_context_desc {
            axes: match options.axes {
                Axes::Gltf => sys::DM_AXES_GLTF,
                Axes::Unity => sys::DM_AXES_UNITY,
                Axes::Unreal => sys::DM_AXES_UNREAL,
                Axes::Blender => sys::DM_AXES_BLENDER,
            },
            picking: match options.picking {
                Picking::Auto => sys::DM_PICK_AUTO,
                Picking::Embree => sys::DM_PICK_EMBREE,
                Picking::Portable => sys::DM_PICK_PORTABLE,
                Picking::None => sys::DM_PICK_NONE,
            },
            unit_in_metres: options.unit_in_metres,
            ..Default::default()
        };
        desc.log.user = user;
        desc.log.message = Some(on_message);
        if hooks.progress.is_some() {
            desc.progress = Some(on_progress);
            desc.progress_user = user;
        }
        if options.threads > 1 {
            desc.jobs.user = user;
            desc.jobs.parallel_for = Some(on_jobs);
        }
        let mut pointer = std::ptr::null_mut();
        check(unsafe { sys::dm_context_create(&desc, &mut pointer) })?;
        let (late, has_late) = (Mutex::default(), AtomicBool::default());
        Ok(Self(Arc::new(ContextInner { pointer, hooks, late, has_late })))
    }

    /// For a call; an error in a callback of this context.
    pub(crate) fn pointer(&self) -> Result<*mut sys::dm_context> {
        if is_running(self.name()) {
            return Err(Error::invalid("a callback must not call the context that calls it"));
        }
        self.0.end_late();
        Ok(self.0.pointer)
    }

    /// As callbacks know it.
    pub(crate) fn name(&self) -> usize {
        self.0.name()
    }

    pub fn memory(&self) -> Result<MemoryInfo> {
        let mut info = MemoryInfo::default();
        check(unsafe { sys::dm_context_get_memory(self.pointer()?, &mut info) })?;
        Ok(info)
    }

    /// Reads weights, each the bytes of a safetensors file; an empty one is absent.
    pub fn load_model(&self, kinematics: &[u8], motion: &[u8], ranker: &[u8]) -> Result<Model> {
        let start = |bytes: &[u8]| match bytes.len() {
            0 => std::ptr::null(),
            _ => bytes.as_ptr().cast::<c_void>(),
        };
        let desc = sys::dm_model_desc {
            kinematics: start(kinematics),
            kinematics_size: kinematics.len(),
            motion: start(motion),
            motion_size: motion.len(),
            ranker: start(ranker),
            ranker_size: ranker.len(),
            ..Default::default()
        };
        let mut id = 0;
        check(unsafe { sys::dm_model_load(self.pointer()?, &desc, &mut id) })?;
        Ok(Model(Arc::new(ModelInner { id, context: self.clone() })))
    }

    /// Reads the shipped weights in a folder.
    pub fn load_model_from(&self, folder: impl AsRef<Path>) -> std::result::Result<Model, Box<dyn std::error::Error>> {
        let read = |name: &str| std::fs::read(folder.as_ref().join(name));
        let (kinematics, motion) = (read("kpp_net.safetensors")?, read("dq_vae.safetensors")?);
        Ok(self.load_model(&kinematics, &motion, &read("ranker.safetensors")?)?)
    }

    /// Finds out how each part of a mesh moves.
    pub fn prepare(&self, mesh: &Mesh, how: Prepare) -> Result<Object> {
        let model = how.model.cloned();
        let id = how.run(self, mesh)?;
        Ok(Object::new(self.clone(), id, model))
    }

    /// Reads a `.dmo`. model: for its motions.
    pub fn load(&self, dmo: &[u8], model: Option<&Model>) -> Result<Object> {
        let mut id = 0;
        let weights = model.map_or(0, |model| model.0.id);
        check(unsafe { sys::dm_object_load(self.pointer()?, dmo.as_ptr().cast(), dmo.len(), weights, &mut id) })?;
        Ok(Object::new(self.clone(), id, model.cloned()))
    }

    /// Finds the part that a point of a mesh belongs to: 1 for each face that moves with it.
    pub fn find_part(&self, mesh: &Mesh, drag: &Hint) -> Result<Vec<u8>> {
        let mut faces = vec![0; mesh.face_count()];
        let count = faces.len() as u64;
        check(unsafe { sys::dm_mesh_find_part(self.pointer()?, &mesh.describe(), drag, faces.as_mut_ptr(), count) })?;
        Ok(faces)
    }

    /// An empty scene.
    pub fn scene(&self) -> Result<Scene> {
        let (desc, mut id) = (sys::dm_scene_desc::default(), 0);
        check(unsafe { sys::dm_scene_create(self.pointer()?, &desc, &mut id) })?;
        Ok(Scene::new(self.clone(), id))
    }

    /// The ray through a pixel, (0, 0) the top left corner.
    pub fn camera_ray(&self, camera: &Camera, x: f32, y: f32) -> Result<Ray> {
        let mut ray = Ray::default();
        check(unsafe { sys::dm_camera_ray(self.pointer()?, &camera.sized(), x, y, &mut ray) })?;
        Ok(ray)
    }
}

pub(crate) struct ModelInner {
    pub(crate) id: sys::dm_model,
    context: Context,
}

impl Drop for ModelInner {
    fn drop(&mut self) {
        unsafe fn end(context: *mut sys::dm_context, id: u64) {
            sys::dm_model_unload(context, id);
        }
        self.context.0.end(end, self.id);
    }
}

/// Loaded weights. Objects that were prepared with them keep them.
#[derive(Clone)]
pub struct Model(pub(crate) Arc<ModelInner>);
