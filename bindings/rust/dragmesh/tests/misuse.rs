//! What a host may do wrong with the safe layer: an error each time, and the context goes on.
use dragmesh::{prelude::*, *};
use std::panic::{catch_unwind, panic_any, AssertUnwindSafe};
use std::sync::{Arc, Mutex};

const DMO: &[u8] = include_bytes!("../../../../tests/replay/hands/object.dmo");
const NOT_FINITE: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

/// What a panic may carry.
struct Bomb;

impl Drop for Bomb {
    fn drop(&mut self) {
        panic!("a bomb went off");
    }
}

const BOXES: [[f32; 6]; 2] = [[0.0, 0.0, 0.0, 1.0, 0.5, 0.6], [0.0, 0.51, 0.0, 1.0, 0.56, 0.6]];
const CORNERS: [u16; 36] =
    [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];

/// A box and a lid that lies on it; part 1, by vertex.
struct Chest(Vec<[f32; 3]>, Vec<u16>, Vec<u8>);

impl Chest {
    fn new() -> Self {
        let corner = |v: usize| [0, 1, 2].map(|k| BOXES[v / 8][if v >> k & 1 == 1 { k + 3 } else { k }]);
        let index = |i: usize| (i / 36 * 8) as u16 + CORNERS[i % 36];
        Self((0..16).map(corner).collect(), (0..72).map(index).collect(), (0..16).map(|v| v / 8).collect())
    }

    fn mesh(&self) -> Mesh {
        Mesh::new(Positions::F32(&self.0), Indices::U16(&self.1), PartIds::U8(&self.2))
    }

    fn prepare(&self, context: &Context) -> Result<Object> {
        context.prepare(&self.mesh(), Prepare::default())
    }
}

fn context() -> Context {
    Context::new(ContextOptions::default()).unwrap()
}

fn lid() -> DragOptions {
    DragOptions { part: 1, rules: Some(Rules::default()), ..Default::default() }
}

/// The context goes on.
fn works(context: &Context) {
    let mut drag = Chest::new().prepare(context).unwrap().grab(&lid()).unwrap();
    drag.step(&Input::default(), 0.01).unwrap();
}

fn kind<T>(result: Result<T>) -> ErrorKind {
    result.err().unwrap().kind()
}

/// What the header tags as exclusive takes `&mut self`, so that owners may be shared.
#[test]
fn owners_may_go_to_other_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<Context>();
    shared::<Model>();
    shared::<Object>();
    shared::<Drag>();
    shared::<Motion>();
    shared::<Scene>();
    shared::<Error>();
}

#[test]
fn callbacks_that_call_their_context_get_an_error() {
    let (context, other, chest) = (context(), context(), Chest::new());
    let (object, mut scene) = (chest.prepare(&context).unwrap(), context.scene().unwrap());
    let mut drag = object.grab(&lid()).unwrap();
    let mut calls = 0;
    let mut try_all = || {
        calls += 1;
        let kinds = [
            kind(chest.prepare(&context)),
            kind(context.load(DMO, None)),
            kind(context.scene()),
            kind(context.memory()),
            kind(object.info()),
            kind(object.grab(&lid())),
            kind(scene.add(&object, None)),
            kind(drag.step(&Input::default(), 0.01)),
            kind(context.find_part(&chest.mesh(), &Hint::default())),
        ];
        assert!(kinds.iter().all(|&kind| kind == ErrorKind::InvalidArgument));
        chest.prepare(&other).unwrap();
        true
    };
    context.prepare(&chest.mesh(), Prepare { progress: Some(Box::new(|_| try_all())), ..Default::default() }).unwrap();
    let intent = Prepare {
        intent: Some(Box::new(|_, _, _| if try_all() { JointKind::Unknown } else { JointKind::Fixed })),
        ..Default::default()
    };
    context.prepare(&chest.mesh(), intent).unwrap();
    assert!(calls > 2);
    works(&context);
}

#[test]
fn a_log_that_holds_its_context() {
    let held: Arc<Mutex<Option<Context>>> = Arc::default();
    let (inside, answers) = (held.clone(), Arc::new(Mutex::new(Vec::new())));
    let seen = answers.clone();
    let log = move |_: Level, _: &str| {
        if let Some(context) = &*inside.lock().unwrap() {
            seen.lock().unwrap().push(kind(context.memory()));
        }
    };
    let context = Context::new(ContextOptions { log: Some(Box::new(log)), ..Default::default() }).unwrap();
    *held.lock().unwrap() = Some(context.clone());
    assert_eq!(kind(context.load(b"none", None)), ErrorKind::BadData);
    assert_eq!(*answers.lock().unwrap(), [ErrorKind::InvalidArgument]);
    works(&context);
    *held.lock().unwrap() = None; // else they would hold each other for ever
}

#[test]
fn what_a_callback_drops_ends_after_the_call() {
    let (context, chest) = (context(), Chest::new());
    let object = chest.prepare(&context).unwrap();
    let (drag, scene, model) = (
        object.grab(&lid()).unwrap(),
        context.scene().unwrap(),
        context.load_model_from("../../../sdk/models").unwrap(),
    );
    let mut owned = Some((object, drag, scene, model));
    let before = context.memory().unwrap().bytes;
    let progress = move |_| {
        drop(owned.take());
        true
    };
    drop(context.prepare(&chest.mesh(), Prepare { progress: Some(Box::new(progress)), ..Default::default() }).unwrap());
    assert!(context.memory().unwrap().bytes < before);
    works(&context);
}

#[test]
fn panics_of_any_kind_stay_inside() {
    std::panic::set_hook(Box::new(|_| ())); // they are meant
    let chest = Chest::new();
    let log = |_: Level, _: &str| panic_any(Bomb);
    let progress = |_| -> bool { panic_any(Bomb) };
    let loud = Context::new(ContextOptions { log: Some(Box::new(log)), ..Default::default() }).unwrap();
    assert_eq!(kind(loud.load(b"none", None)), ErrorKind::BadData);
    works(&loud);
    let stopping = Context::new(ContextOptions { progress: Some(Box::new(progress)), ..Default::default() }).unwrap();
    assert_eq!(kind(chest.prepare(&stopping)), ErrorKind::Cancelled);
    let context = Context::new(ContextOptions { threads: 3, ..Default::default() }).unwrap();
    for which in 0..3 {
        let how = Prepare {
            progress: (which == 0).then(|| Box::new(|_| -> bool { panic_any(Bomb) }) as Box<dyn FnMut(f32) -> bool>),
            intent: (which == 1).then(|| {
                Box::new(|_, _, _| -> JointKind { panic_any(Bomb) }) as Box<dyn FnMut(u32, Vec3, Vec3) -> JointKind>
            }),
            choose: (which == 2).then(|| {
                Box::new(|_: &Choice| -> Option<usize> { panic_any(Bomb) }) as Box<dyn FnMut(&Choice) -> Option<usize>>
            }),
            ..Default::default()
        };
        let panic = catch_unwind(AssertUnwindSafe(|| context.prepare(&chest.mesh(), how))).err().unwrap();
        assert!(panic.is::<Bomb>());
        std::mem::forget(panic);
    }
    works(&context);
    let _ = std::panic::take_hook();
}

#[test]
fn slices_of_wrong_length() {
    let (context, chest) = (context(), Chest::new());
    let [positions, none] = [Positions::F32(&chest.0), Positions::F64(&[])];
    let (indices, few) = (Indices::U16(&chest.1), Indices::U8(&[0, 1]));
    let (ids, few_ids, no_ids) = (PartIds::U8(&chest.2), PartIds::I32(&[1]), PartIds::U32(&[]));
    for mesh in [
        Mesh::new(none, indices, ids),
        Mesh::new(positions, few, ids),
        Mesh::new(positions, Indices::U32(&[]), ids),
        Mesh::new(positions, Indices::None, ids),
        Mesh::new(positions, Indices::U32(&[0, 1, u32::MAX]), ids),
        Mesh::new(positions, indices, few_ids),
        Mesh::new(positions, indices, no_ids),
        Mesh::per_face(positions, indices, ids),
    ] {
        assert!(context.prepare(&mesh, Prepare::default()).is_err());
        assert!(context
            .find_part(&mesh, &Hint { point: Vec3::new(f32::NAN, 0.0, 0.0), ..Default::default() })
            .is_err());
    }
    assert!(context.load(&[], None).is_err() && context.load(&DMO[..999], None).is_err());
    assert!(context.load_model(&[1], &[], &[]).is_err() && context.load_model(&[], &[], &[]).is_err());
    let mut object = chest.prepare(&context).unwrap();
    assert!(object.follow_links(1, &mut []).is_err() && object.follow_links(1, &mut [0.0; 999]).is_err());
    assert!(object.set_links(&[Link::default(); 999]).is_err());
    let snaps = Rules { snaps: vec![0.0; 999], ..Default::default() };
    assert!(object.grab(&DragOptions { rules: Some(snaps), ..lid() }).is_err());
    let mut drag = object.grab(&lid()).unwrap();
    let saved = drag.save().unwrap();
    for wrong in [&saved[1..], &saved[..9], &[], DMO] {
        assert!(drag.restore(wrong).is_err());
    }
    drag.restore(&saved).unwrap();
    works(&context);
}

#[test]
fn texts() {
    let (context, chest) = (context(), Chest::new());
    let prepare = |label: &str| context.prepare(&chest.mesh(), Prepare { label: Some(label), ..Default::default() });
    assert_eq!(kind(prepare("a\0b")), ErrorKind::InvalidArgument);
    assert_eq!(kind(prepare(&"x".repeat(10_000_000))), ErrorKind::TooLarge);
    for label in ["", "T\u{fc}r", "\u{1f6aa}", "\u{ffff}"] {
        prepare(label).unwrap();
    }
    let parts = [Part { id: 1, label: Some("\0"), ..Default::default() }];
    let how = Prepare { parts: &parts, ..Default::default() };
    assert_eq!(kind(context.prepare(&chest.mesh(), how)), ErrorKind::InvalidArgument);
    works(&context);
}

#[test]
fn numbers_that_are_none() {
    let (context, chest) = (context(), Chest::new());
    let mut object = chest.prepare(&context).unwrap();
    let mut drag = object.grab(&lid()).unwrap();
    let joint = object.joint(1).unwrap();
    for wrong in NOT_FINITE {
        let vector = Vec3::new(wrong, 0.0, 0.0);
        let ray = Ray { origin: vector, direction: vector };
        let mut input = Input::default();
        input.hand.kind = sys::DM_HAND_VALUE;
        input.hand.amount = wrong;
        for result in [
            drag.update(&ray, 0.01).err(),
            drag.step(&input, 0.01).err(),
            drag.step(&Input::default(), wrong).err(),
            object.set_joint(1, &Joint { axis: vector, ..joint }).err(),
            object.grab(&DragOptions::at(1, vector)).err(),
            context.find_part(&chest.mesh(), &Hint { point: vector, vector }).err(),
            joint.pose_at(wrong).err(),
            joint.scaled(vector).err(),
            Pose::from_rotation([wrong; 4], vector).err(),
            Context::new(ContextOptions { unit_in_metres: wrong, ..Default::default() }).err(),
        ] {
            assert!(matches!(result.unwrap().kind(), ErrorKind::NotFinite | ErrorKind::InvalidArgument));
        }
    }
    for part in [0, 2, u32::MAX] {
        assert_eq!(kind(object.joint(part)), ErrorKind::NotFound);
    }
    works(&context);
}

#[test]
fn sizes_and_pointers_of_the_host_are_not_read() {
    let context = context();
    let mut object = Chest::new().prepare(&context).unwrap();
    for size in [0, 1, 4096, u32::MAX] {
        let joint = Joint { struct_size: size, ..object.joint(1).unwrap() };
        object.set_joint(1, &joint).unwrap();
        joint.frame().unwrap();
        let numbers =
            sys::dm_drag_rules { struct_size: size, snaps: 8 as *const f32, snap_count: size, ..Default::default() };
        let how = DragOptions { rules: Some(Rules { numbers, snaps: vec![0.1] }), ..lid() };
        let mut drag = object.grab(&how).unwrap();
        drag.step(&Input { struct_size: size, ..Default::default() }, 0.01).unwrap();
        let state = PartState { struct_size: size, joint, ..drag.finish().unwrap() };
        object.grab(&DragOptions { state: Some(state), ..lid() }).unwrap();
    }
}
