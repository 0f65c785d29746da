//! Reads a file, makes its nodes parts, and prepares them with what the file says of them.
#![cfg(feature = "gltf")]
use dragmesh::{prelude::*, *};

#[test]
fn prepares_the_nodes_of_a_file() {
    let gltf = Gltf::open("../../../tests/replay/drawer/object.glb").unwrap();
    let nodes = gltf.nodes().unwrap();
    assert!(nodes.len() >= 2 && nodes.iter().all(|node| node.carrier.map_or(true, |at| at < nodes.len())));
    let drawer = nodes.iter().position(|node| node.name.contains("drawer") || node.name.contains("moving")).unwrap();
    let mut ids = vec![0u8; nodes.iter().map(|node| node.faces.end).max().unwrap()];
    ids[nodes[drawer].faces.clone()].fill(1);
    let (label, pivot) = gltf.hints(&nodes[drawer].name).unwrap();
    assert!(label.ends_with(&nodes[drawer].name));
    let mesh = gltf.mesh(PartIds::U8(&ids)).unwrap();
    assert_eq!(mesh.face_count(), ids.len());
    let parts = [Part { id: 1, label: Some(&label), pivot: Some(pivot), ..Default::default() }];
    let context = Context::new(ContextOptions::default()).unwrap();
    let model = context.load_model_from("../../../sdk/models").unwrap();
    let how = Prepare { parts: &parts, model: Some(&model), ..Default::default() };
    let object = context.prepare(&mesh, how).unwrap();
    assert_eq!(object.joint(1).unwrap().kind(), JointKind::Prismatic);
    let hint = Hint { point: object.parts().unwrap()[0].centre, vector: Vec3::new(0.0, 0.0, 1.0) };
    let mut motion = object.motion(1, &hint, &[], 0).unwrap();
    drop((object, model)); // the motion keeps both
    assert!(motion.sample(1.0).unwrap().1.abs() > 0.05);
    let face = context.find_part(&mesh, &hint).unwrap();
    assert!(face.len() == ids.len() && face.contains(&1));
}

#[test]
fn names_a_missing_file() {
    assert_eq!(Gltf::open("nothing.glb").err().unwrap().kind(), ErrorKind::NotFound);
}
