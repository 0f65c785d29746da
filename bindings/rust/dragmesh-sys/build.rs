//! Tells the linker where libdragmesh is: in DRAGMESH_LIB_DIR, else where the system looks.
fn main() {
    println!("cargo:rerun-if-env-changed=DRAGMESH_LIB_DIR");
    if let Ok(folder) = std::env::var("DRAGMESH_LIB_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
    }
}
