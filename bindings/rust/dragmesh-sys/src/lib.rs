//! The C interface of dragmesh: structs, constants and functions under the names of its header, `dragmesh.h`.
//!
//! `Default` gives zeros, with `struct_size` set where a struct has it. A word that is reserved in Rust has an
//! underscore behind it: `dm_joint.type_`. The crate `dragmesh` is the safe layer above.
#![allow(non_camel_case_types)]

include!("generated.rs");
