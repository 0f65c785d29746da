//! What the safe layer adds: owners in any order, errors, callbacks, threads.
use dragmesh::{prelude::*, *};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::Arc;

const DMO: &[u8] = include_bytes!("../../../../tests/replay/hands/object.dmo");

/// A box and a lid that lies on it; part 7, by face.
struct Chest(Vec<[f64; 3]>, Vec<u32>, Vec<i32>);

impl Chest {
    fn new() -> Self {
        let boxes = [[0.0, 0.0, 0.0, 1.0, 0.5, 0.6], [0.0, 0.51, 0.0, 1.0, 0.56, 0.6]];
        let corners = [
            0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
        ];
        let corner = |v: usize| [0, 1, 2].map(|k| boxes[v / 8][if v >> k & 1 == 1 { k + 3 } else { k }]);
        Self(
            (0..16).map(corner).collect(),
            (0..72).map(|i| i / 36 * 8 + corners[(i % 36) as usize]).collect(),
            (0..24).map(|face| if face < 12 { -1 } else { 7 }).collect(),
        )
    }

    fn mesh(&self) -> Mesh {
        Mesh::per_face(Positions::F64(&self.0), Indices::U32(&self.1), PartIds::I32(&self.2))
    }
}

fn context() -> Context {
    Context::new(ContextOptions::default()).unwrap()
}

#[test]
fn errors_have_code_name_and_the_librarys_words() {
    let mut broken = DMO.to_vec();
    broken[DMO.len() / 2] ^= 1;
    let error = context().load(&broken, None).err().unwrap();
    assert_eq!((error.kind(), error.name()), (ErrorKind::BadData, "DM_ERROR_BAD_DATA"));
    assert!(!error.message().is_empty() && error.to_string().ends_with(error.message()));
    let error = context().load(DMO, None).unwrap().joint(99).err().unwrap();
    assert_eq!(error.kind(), ErrorKind::NotFound);
}

#[test]
fn owners_end_in_any_order() {
    let object = context().load(DMO, None).unwrap(); // its context's last owner but the object
    let part = object.parts().unwrap()[0];
    let mut drag = object.grab(&DragOptions::at(part.id, part.centre)).unwrap();
    let mut scene = context().scene().unwrap();
    assert_eq!(scene.add(&object, None).err().unwrap().kind(), ErrorKind::InvalidArgument); // of another context
    drop(object);
    let ray = Ray { origin: Vec3::new(0.0, 0.0, 5.0), direction: Vec3::new(0.0, 0.0, -1.0) };
    drag.update(&ray, 0.016).unwrap();
    std::thread::spawn(move || drag.finish().unwrap()).join().unwrap();
}

#[test]
fn picks_an_object_that_only_the_scene_keeps() {
    let context = context();
    let chest = Chest::new();
    let mut scene = context.scene().unwrap();
    let object = context.prepare(&chest.mesh(), Prepare::default()).unwrap();
    let instance = scene.add(&object, None).unwrap();
    drop(object);
    scene.commit().unwrap();
    let ray = Ray { origin: Vec3::new(0.3, 2.0, 0.3), direction: Vec3::new(0.0, -1.0, 0.0) };
    assert_eq!(scene.pick(&ray).unwrap().unwrap().part_id, 7);
    scene.remove(instance).unwrap();
    scene.commit().unwrap();
    assert!(scene.pick(&ray).unwrap().is_none());
}

#[test]
fn threads_change_no_bit() {
    let prepare = |threads| {
        let context = Context::new(ContextOptions { threads, ..Default::default() }).unwrap();
        context.prepare(&Chest::new().mesh(), Prepare::default()).unwrap().save().unwrap()
    };
    assert_eq!(prepare(0), prepare(3));
}

#[test]
fn callbacks_are_asked_and_may_cancel() {
    let (context, chest) = (context(), Chest::new());
    let mut done = 0.0;
    let choose = |choice: &Choice| {
        assert_eq!((choice.part.id, choice.ends.len()), (7, choice.joints.len()));
        Some(choice.joints.len() - 1)
    };
    let progress = |share| {
        assert!(share >= done);
        done = share;
        true
    };
    let how = Prepare { progress: Some(Box::new(progress)), choose: Some(Box::new(choose)), ..Default::default() };
    let object = context.prepare(&chest.mesh(), how).unwrap();
    assert_eq!(object.joint(7).unwrap().source, sys::DM_JOINT_CHOSEN);
    assert!(done > 0.0);
    let how = Prepare { progress: Some(Box::new(|_| false)), ..Default::default() };
    assert_eq!(context.prepare(&chest.mesh(), how).err().unwrap().kind(), ErrorKind::Cancelled);
    let how = Prepare { intent: Some(Box::new(|_, _, _| JointKind::Prismatic)), ..Default::default() };
    assert_eq!(context.prepare(&chest.mesh(), how).unwrap().joint(7).unwrap().kind(), JointKind::Prismatic);
    let how = Prepare { choose: Some(Box::new(|_| Some(usize::MAX))), ..Default::default() };
    assert_eq!(context.prepare(&chest.mesh(), how).err().unwrap().kind(), ErrorKind::IndexOutOfRange);
}

#[test]
fn the_progress_of_a_context_may_cancel() {
    let progress = |goes_on: bool| ContextOptions { progress: Some(Box::new(move |_| goes_on)), ..Default::default() };
    let saved = Context::new(progress(true)).unwrap().prepare(&Chest::new().mesh(), Prepare::default()).unwrap().save();
    let stopping = Context::new(progress(false)).unwrap();
    assert_eq!(stopping.load(&saved.unwrap(), None).err().unwrap().kind(), ErrorKind::Cancelled);
    let panics = ContextOptions { progress: Some(Box::new(|_| panic!("no"))), ..Default::default() };
    let how = Context::new(panics).unwrap().prepare(&Chest::new().mesh(), Prepare::default());
    assert_eq!(how.err().unwrap().kind(), ErrorKind::Cancelled);
}

#[test]
fn a_panic_of_a_callback_comes_back_and_leaves_nothing() {
    let (context, chest) = (context(), Chest::new());
    let choose = |_: &Choice| -> Option<usize> { panic!("on purpose") };
    let how = Prepare { choose: Some(Box::new(choose)), ..Default::default() };
    let in_use = || context.memory().map(|held| held.bytes - held.kept_bytes).unwrap();
    let before = in_use();
    let panic = catch_unwind(AssertUnwindSafe(|| context.prepare(&chest.mesh(), how))).err().unwrap();
    assert_eq!(panic.downcast_ref::<&str>(), Some(&"on purpose"));
    context.prepare(&chest.mesh(), Prepare::default()).unwrap();
    let after = in_use();
    assert!(after <= before + (1 << 20), "{before} {after}"); // the arenas of a preparation are kept
}

#[test]
fn logs_end_with_their_context() {
    let heard = Arc::new(AtomicU32::new(0));
    let count = heard.clone();
    let log = move |_: Level, _: &str| {
        count.fetch_add(1, Ordering::Relaxed);
        panic!("on purpose");
    };
    let context = Context::new(ContextOptions { log: Some(Box::new(log)), ..Default::default() }).unwrap();
    assert!(context.load(b"none", None).is_err());
    assert_eq!(heard.load(Ordering::Relaxed), 1);
    assert_eq!(Arc::strong_count(&heard), 2);
    drop(context);
    assert_eq!(Arc::strong_count(&heard), 1);
}

#[test]
fn poses_are_made_of_rotation_and_translation() {
    let turn = Pose::from_rotation([0.0, 2.0, 0.0, 2.0], Vec3::new(1.0, 2.0, 3.0)).unwrap(); // a quarter about y
    let moved = turn.apply(Vec3::new(1.0, 0.0, 0.0));
    assert!((moved.x - 1.0).abs() + (moved.y - 2.0).abs() + (moved.z - 2.0).abs() < 1e-5);
    assert!((turn.inverse().apply(moved).x - 1.0).abs() < 1e-5);
    assert_eq!(Pose::from_rotation([0.0; 4], moved).err().unwrap().kind(), ErrorKind::InvalidArgument);
}

#[test]
fn a_wrong_struct_size_does_no_harm() {
    let context = context();
    let mut object = context.load(DMO, None).unwrap();
    let part = object.parts().unwrap()[0].id;
    let mut joint = object.joint(part).unwrap();
    joint.struct_size = u32::MAX;
    object.set_joint(part, &joint).unwrap();
    let pose = joint.pose_at(0.1).unwrap();
    assert!((joint.value_of(&pose).unwrap().0 - 0.1).abs() < 1e-4);
    assert!(pose.inverse().after(&pose).matrix()[12].abs() < 1e-6);
}
