use crate::callback::guarded;
use crate::error::{check, Error, Result};
use crate::values::{Hint, Joint, JointEnd, JointKind, PartInfo, Pivot, Vec3};
use crate::{sys, Context, Mesh, Model};
use std::any::Any;
use std::ffi::CString;
use std::os::raw::c_void;
use std::panic::resume_unwind;

/// What is known of a part. Everything but the id is optional.
#[derive(Clone, Debug, Default)]
pub struct Part<'a> {
    /// As in the mesh's part ids; 1 and up.
    pub id: u32,
    /// Id of the part that carries it; 0 = the body.
    pub parent: u32,
    pub joint: JointKind,
    /// Names that the asset has for it, outermost first, joined by `/`.
    pub label: Option<&'a str>,
    pub drag: Option<Hint>,
    /// Where the asset has its node or bone.
    pub pivot: Option<Pivot>,
}

/// A part and its hypotheses, most probable first, for a host that chooses.
#[derive(Clone, Debug)]
pub struct Choice {
    pub part: PartInfo,
    pub joints: Vec<Joint>,
    /// Where each joint takes the part at its lower and its upper limit.
    pub ends: Vec<[JointEnd; 2]>,
}

type Progress<'a> = Box<dyn FnMut(f32) -> bool + 'a>;
type Intent<'a> = Box<dyn FnMut(u32, Vec3, Vec3) -> JointKind + 'a>;
type Choose<'a> = Box<dyn FnMut(&Choice) -> Option<usize> + 'a>;

/// How to prepare an object. Everything is optional.
#[derive(Default)]
pub struct Prepare<'a> {
    /// Empty: every part id above 0 is a part that the body carries.
    pub parts: &'a [Part<'a>],
    pub model: Option<&'a Model>,
    /// Names of the whole object.
    pub label: Option<&'a str>,
    /// Which way is up; zeros: as the context's axes say.
    pub up: Vec3,
    pub seed: u64,
    pub without_picking: bool,
    /// Gets 0 .. 1, rising; returns false to cancel.
    pub progress: Option<Progress<'a>>,
    /// Gets a part's id and box; answers `JointKind::Unknown` to leave the question to the library.
    pub intent: Option<Intent<'a>>,
    /// Returns the index of the right hypothesis; `None` keeps the library's answer.
    pub choose: Option<Choose<'a>>,
}

/// The callbacks of one call, and the first panic of theirs.
struct Call<'a> {
    progress: Option<Progress<'a>>,
    intent: Option<Intent<'a>>,
    choose: Option<Choose<'a>>,
    context: usize,
    panic: Option<Box<dyn Any + Send>>,
}

impl Call<'_> {
    /// Nothing may pass through the library: keeps a panic, and answers for it and for all that comes after.
    fn guard<T>(&mut self, otherwise: T, run: impl FnOnce(&mut Self) -> T) -> T {
        if self.panic.is_some() {
            return otherwise;
        }
        match guarded(self.context, || run(self)) {
            Ok(answer) => answer,
            Err(panic) => {
                self.panic = Some(panic);
                otherwise
            }
        }
    }
}

unsafe extern "C" fn on_progress(user: *mut c_void, done: f32) -> i32 {
    (*user.cast::<Call>()).guard(1, |call| match &mut call.progress {
        Some(progress) => i32::from(!progress(done)),
        None => 0,
    })
}

unsafe extern "C" fn on_intent(user: *mut c_void, part: u32, low: Vec3, high: Vec3) -> i32 {
    (*user.cast::<Call>()).guard(sys::DM_JOINT_UNKNOWN, |call| match &mut call.intent {
        Some(intent) => intent(part, low, high).to_c(),
        None => sys::DM_JOINT_UNKNOWN,
    })
}

unsafe extern "C" fn on_choose(user: *mut c_void, choice: *const sys::dm_choice) -> i32 {
    (*user.cast::<Call>()).guard(sys::DM_CHOICE_KEEP, |call| {
        let choice = &*choice;
        let shown = std::slice::from_raw_parts(choice.hypotheses, choice.count as usize);
        let shown = Choice {
            part: *choice.part,
            joints: shown.iter().map(|one| *(**one).joint).collect(),
            ends: shown.iter().map(|one| (**one).ends).collect(),
        };
        let index = call.choose.as_mut().and_then(|choose| choose(&shown));
        // An index that does not fit is one that does not exist.
        index.map_or(sys::DM_CHOICE_KEEP, |index| i32::try_from(index).unwrap_or(i32::MAX))
    })
}

fn text(label: Option<&str>) -> Result<Option<CString>> {
    label.map(CString::new).transpose().map_err(|_| Error::invalid("a label has a zero in it"))
}

fn start<T>(value: &Option<T>) -> *const T {
    value.as_ref().map_or(std::ptr::null(), |value| value)
}

impl<'a> Prepare<'a> {
    pub(crate) fn run(self, context: &Context, mesh: &Mesh) -> Result<sys::dm_object> {
        let labels = self.parts.iter().map(|part| text(part.label)).collect::<Result<Vec<_>>>()?;
        let rows: Vec<_> = self.parts.iter().zip(&labels).map(|(part, label)| describe(part, label)).collect();
        let label = text(self.label)?;
        let mesh = mesh.describe();
        let mut call = Call {
            progress: self.progress,
            intent: self.intent,
            choose: self.choose,
            context: context.name(),
            panic: None,
        };
        let user: *mut c_void = (&mut call as *mut Call).cast();
        let desc = sys::dm_object_desc {
            flags: if self.without_picking { sys::DM_PREPARE_WITHOUT_PICKING as u32 } else { 0 },
            mesh: &mesh,
            parts: if rows.is_empty() { std::ptr::null() } else { rows.as_ptr() },
            part_count: rows.len() as u32,
            model: self.model.map_or(0, |model| model.0.id),
            seed: self.seed,
            label: label.as_ref().map_or(std::ptr::null(), |label| label.as_ptr()),
            up: self.up,
            progress: if call.progress.is_some() { Some(on_progress) } else { None }, // else the context's
            progress_user: user,
            intent: Some(on_intent),
            intent_user: user,
            choose: if call.choose.is_some() { Some(on_choose) } else { None },
            choose_user: user,
            ..Default::default()
        };
        let mut id = 0;
        let pointer = context.pointer()?;
        let result = check(unsafe { sys::dm_object_prepare(pointer, &desc, &mut id) });
        if let Some(panic) = call.panic {
            if id != 0 {
                unsafe { sys::dm_object_destroy(pointer, id) };
            }
            resume_unwind(panic);
        }
        result.map(|()| id)
    }
}

/// Points into both.
fn describe(part: &Part, label: &Option<CString>) -> sys::dm_part_desc {
    sys::dm_part_desc {
        id: part.id,
        parent: part.parent,
        joint_type: part.joint.to_c(),
        drag: start(&part.drag),
        label: label.as_ref().map_or(std::ptr::null(), |label| label.as_ptr()),
        pivot: start(&part.pivot),
        ..Default::default()
    }
}
