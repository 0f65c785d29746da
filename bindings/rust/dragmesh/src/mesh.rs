use crate::sys;
use std::os::raw::c_void;

/// Three coordinates a vertex.
#[derive(Clone, Copy, Debug)]
pub enum Positions<'a> {
    F32(&'a [[f32; 3]]),
    F64(&'a [[f64; 3]]),
}

/// Three indices a triangle.
#[derive(Clone, Copy, Debug)]
pub enum Indices<'a> {
    /// Vertices in order.
    None,
    U32(&'a [u32]),
    U16(&'a [u16]),
    U8(&'a [u8]),
}

/// Which part a vertex or face belongs to; 0 is the body that stays.
#[derive(Clone, Copy, Debug)]
pub enum PartIds<'a> {
    None,
    U32(&'a [u32]),
    U16(&'a [u16]),
    U8(&'a [u8]),
    /// Negative ids are the body's.
    I32(&'a [i32]),
}

/// A triangle mesh, read in place.
///
/// ```
/// use dragmesh::{Indices, Mesh, PartIds, Positions};
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let mesh = Mesh::new(Positions::F32(&corners), Indices::U16(&[0, 1, 2]), PartIds::None);
/// assert_eq!(mesh.face_count(), 1);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a> {
    positions: Positions<'a>,
    indices: Indices<'a>,
    part_ids: PartIds<'a>,
    per_face: bool,
}

/// Start, elements and bytes of a slice.
fn parts<T>(slice: &[T]) -> (*const c_void, u64, u64) {
    (slice.as_ptr().cast(), slice.len() as u64, std::mem::size_of_val(slice) as u64)
}

const NOTHING: (*const c_void, u64, u64) = (std::ptr::null(), 0, 0);

impl<'a> Mesh<'a> {
    /// One part id a vertex.
    pub fn new(positions: Positions<'a>, indices: Indices<'a>, part_ids: PartIds<'a>) -> Self {
        Self { positions, indices, part_ids, per_face: false }
    }

    /// One part id a face.
    pub fn per_face(positions: Positions<'a>, indices: Indices<'a>, part_ids: PartIds<'a>) -> Self {
        Self { positions, indices, part_ids, per_face: true }
    }

    pub fn face_count(&self) -> usize {
        let corners = match self.indices {
            Indices::None => match self.positions {
                Positions::F32(p) => p.len(),
                Positions::F64(p) => p.len(),
            },
            Indices::U32(i) => i.len(),
            Indices::U16(i) => i.len(),
            Indices::U8(i) => i.len(),
        };
        corners / 3
    }

    /// Points into the slices.
    pub(crate) fn describe(&self) -> sys::dm_mesh_desc {
        let (positions, position_format) = match self.positions {
            Positions::F32(p) => (parts(p), sys::DM_FLOAT32),
            Positions::F64(p) => (parts(p), sys::DM_FLOAT64),
        };
        let (indices, index_format) = match self.indices {
            Indices::None => (NOTHING, sys::DM_UINT32),
            Indices::U32(i) => (parts(i), sys::DM_UINT32),
            Indices::U16(i) => (parts(i), sys::DM_UINT16),
            Indices::U8(i) => (parts(i), sys::DM_UINT8),
        };
        let (part_ids, part_id_format) = match self.part_ids {
            PartIds::None => (NOTHING, sys::DM_UINT32),
            PartIds::U32(i) => (parts(i), sys::DM_UINT32),
            PartIds::U16(i) => (parts(i), sys::DM_UINT16),
            PartIds::U8(i) => (parts(i), sys::DM_UINT8),
            PartIds::I32(i) => (parts(i), sys::DM_INT32),
        };
        sys::dm_mesh_desc {
            positions: positions.0,
            vertex_count: positions.1,
            position_bytes: positions.2,
            indices: indices.0,
            index_count: indices.1,
            index_bytes: indices.2,
            part_ids: part_ids.0,
            part_id_bytes: part_ids.2,
            position_format,
            index_format,
            part_id_format,
            part_id_scope: if self.per_face { sys::DM_PER_FACE } else { sys::DM_PER_VERTEX },
            ..Default::default()
        }
    }
}
