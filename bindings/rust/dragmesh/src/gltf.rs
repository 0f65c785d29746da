use crate::error::{check, Error, Result};
use crate::values::Pivot;
use crate::{sys, Indices, Mesh, PartIds, Positions};
use std::ffi::{CStr, CString};
use std::os::raw::c_char;
use std::path::Path;

/// What moves as one in a file: a node with a mesh, or a bone.
#[derive(Clone, Debug)]
pub struct Node {
    pub name: String,
    /// Index in the file's nodes array.
    pub node: u32,
    /// The node here that carries it.
    pub carrier: Option<usize>,
    pub faces: std::ops::Range<usize>,
}

/// A glTF file, as one merged mesh in the scene's frame.
pub struct Gltf(*mut sys::dm_gltf);

// One thread at a time.
unsafe impl Send for Gltf {}

impl Gltf {
    /// Opens a `.glb` or `.gltf` with the files beside it.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref().to_str().and_then(|path| CString::new(path).ok());
        let path = path.ok_or_else(|| Error::invalid("the path is no UTF-8"))?;
        let (desc, mut gltf) = (sys::dm_gltf_desc::default(), std::ptr::null_mut());
        check(unsafe { sys::dm_gltf_open_file(path.as_ptr(), &desc, &mut gltf) })?;
        Ok(Self(gltf))
    }

    pub fn nodes(&self) -> Result<Vec<Node>> {
        let node = |index| {
            let mut node = sys::dm_gltf_node::default();
            check(unsafe { sys::dm_gltf_get_node(self.0, index, &mut node) })?;
            let name = unsafe { CStr::from_ptr(node.name) }.to_string_lossy().into_owned();
            let first = node.first_face as usize;
            Ok(Node {
                name,
                node: node.node,
                carrier: Some(node.carrier as usize).filter(|_| node.carrier != sys::DM_GLTF_NO_CARRIER),
                faces: first..first + node.face_count as usize,
            })
        };
        (0..unsafe { sys::dm_gltf_node_count(self.0) }).map(node).collect()
    }

    /// The merged mesh, with one part id a face.
    pub fn mesh<'a>(&'a self, part_ids: PartIds<'a>) -> Result<Mesh<'a>> {
        let mut mesh = sys::dm_mesh_desc::default();
        check(unsafe { sys::dm_gltf_get_mesh(self.0, &mut mesh) })?;
        let (vertices, corners) = (mesh.vertex_count as usize, mesh.index_count as usize);
        if vertices == 0 || corners == 0 {
            return Ok(Mesh::per_face(Positions::F32(&[]), Indices::U32(&[]), part_ids));
        }
        // float32 and uint32, as the header promises; they live as long as the file.
        let positions = unsafe { std::slice::from_raw_parts(mesh.positions.cast(), vertices) };
        let indices = unsafe { std::slice::from_raw_parts(mesh.indices.cast(), corners) };
        Ok(Mesh::per_face(Positions::F32(positions), Indices::U32(indices), part_ids))
    }

    /// Names and pivot of a node, as [`crate::Part`] takes them. node: a name, or `#12` for node 12 of the file.
    pub fn hints(&self, node: &str) -> Result<(String, Pivot)> {
        let name = CString::new(node).map_err(|_| Error::invalid("the name has a zero in it"))?;
        let mut label = vec![0 as c_char; sys::DM_MAX_LABEL as usize + 1];
        let mut pivot = Pivot::default();
        check(unsafe { sys::dm_gltf_get_hints(self.0, name.as_ptr(), label.as_mut_ptr(), label.len(), &mut pivot) })?;
        let label = unsafe { CStr::from_ptr(label.as_ptr()) }.to_string_lossy().into_owned();
        Ok((label, pivot))
    }

    /// Whether pivots tell nothing: the origins of all nodes, of which there are several, are one point.
    pub fn pivots_are_lost(&self) -> bool {
        unsafe { sys::dm_gltf_pivots_are_lost(self.0) != 0 }
    }
}

impl Drop for Gltf {
    fn drop(&mut self) {
        unsafe { sys::dm_gltf_close(self.0) }
    }
}
