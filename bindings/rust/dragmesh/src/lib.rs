//! Makes any 3D object openable: finds out how its parts move, and turns drags into poses.
//!
//! Frames and units are the host's, as [`ContextOptions`] says them; angles are radians. What can fail returns an
//! [`Error`] with the library's own words. Owners end by themselves, in any order: a drag keeps its object, an object
//! its context.
//!
//! Functions that the C header tags as exclusive take `&mut self`. All owners may go to other threads. A callback that
//! calls the context that calls it gets an [`Error`]; what it drops ends after the call.
//!
//! ```no_run
//! use dragmesh::{prelude::*, Context, ContextOptions, DragOptions, Go, Ray, Vec3};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let context = Context::new(ContextOptions::default())?;
//! let object = context.load(&std::fs::read("cabinet.dmo")?, None)?;
//! let part = object.parts()?[0];
//! let mut drag = object.grab(&DragOptions::at(part.id, part.centre))?;
//! let ray = Ray { origin: Vec3::new(0.0, 0.5, 2.0), direction: Vec3::new(0.0, 0.0, -1.0) };
//! let state = drag.update(&ray, 1.0 / 60.0)?; // every frame
//! let moved = state.pose.apply(part.centre);
//! drag.release(Go::Open)?;
//! # let _ = moved; Ok(())
//! # }
//! ```
mod callback;
mod context;
mod drag;
mod error;
#[cfg(feature = "gltf")]
mod gltf;
mod mesh;
mod object;
mod prepare;
mod scene;
mod values;

pub use context::{Axes, Context, ContextOptions, Level, Model, Picking};
pub use drag::{Drag, DragOptions, Go, Input, Intent, ReleaseOptions, Rules};
pub use error::{Error, ErrorKind, Result};
#[cfg(feature = "gltf")]
pub use gltf::{Gltf, Node};
pub use mesh::{Indices, Mesh, PartIds, Positions};
pub use object::{Motion, Object};
pub use prepare::{Choice, Part, Prepare};
pub use scene::Scene;
pub use values::*;

/// The declarations of C, for constants such as `sys::DM_EVENT_OPENED`.
pub use dragmesh_sys as sys;

/// Methods of joints, poses and vectors.
pub mod prelude {
    pub use crate::values::{JointExt, PoseExt, Vec3Ext};
}

/// The version of the library in use: major, minor, patch. An odd patch is a version in development.
pub fn version() -> (u32, u32, u32) {
    let v = unsafe { sys::dm_version() };
    (v >> 22, v >> 12 & 0x3ff, v & 0xfff)
}
