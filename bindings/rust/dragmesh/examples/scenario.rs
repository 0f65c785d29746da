//! The common scenario: prints what bindings/scenario/scenario.c prints. scenario WEIGHTS_FOLDER
use dragmesh::{prelude::*, sys, *};

const FRAMES: u32 = 60;
const SHOWN_EVERY: u32 = 10;
const SAVED_AT: u32 = 30;
const RELEASED_FRAMES: u32 = 120;
const HANDLE_TURNS_AT: u32 = 25;
const FRAME_TIME: f32 = 1.0 / 60.0;
const HANDLE_TURN: f32 = 1.0; // rad
const WIDEST: f32 = 0.45; // rad
const DOOR: u32 = 1;
const DRAWER: u32 = 2;

type Outcome<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// From x, y, z to x, y, z, and the part: samples/common/cabinet.h.
const BOXES: [([f32; 6], u8); 13] = [
    ([0.00, 0.00, 0.000, 0.60, 0.02, 0.40], 0),
    ([0.00, 0.98, 0.000, 0.60, 1.00, 0.42], 0),
    ([0.00, 0.02, 0.000, 0.02, 0.98, 0.40], 0),
    ([0.58, 0.02, 0.000, 0.60, 0.98, 0.40], 0),
    ([0.02, 0.02, 0.000, 0.58, 0.98, 0.02], 0),
    ([0.00, 0.00, 0.402, 0.60, 0.79, 0.42], 1),
    ([0.54, 0.35, 0.420, 0.56, 0.55, 0.45], 1),
    ([0.00, 0.80, 0.402, 0.60, 0.97, 0.42], 2),
    ([0.25, 0.87, 0.420, 0.35, 0.89, 0.45], 2),
    ([0.04, 0.82, 0.030, 0.56, 0.83, 0.402], 2),
    ([0.04, 0.83, 0.030, 0.05, 0.95, 0.402], 2),
    ([0.55, 0.83, 0.030, 0.56, 0.95, 0.402], 2),
    ([0.05, 0.83, 0.030, 0.55, 0.95, 0.040], 2),
];
const CORNERS: [u16; 36] =
    [0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6];

struct Cabinet {
    positions: Vec<[f32; 3]>,
    indices: Vec<u16>,
    parts: Vec<u8>,
}

impl Cabinet {
    fn new() -> Self {
        let corner = |v: usize| {
            let (sides, _) = BOXES[v / 8];
            [0, 1, 2].map(|k| sides[if v >> k & 1 == 1 { k + 3 } else { k }])
        };
        Self {
            positions: (0..8 * BOXES.len()).map(corner).collect(),
            indices: (0..36 * BOXES.len()).map(|i| (i / 36 * 8) as u16 + CORNERS[i % 36]).collect(),
            parts: (0..8 * BOXES.len()).map(|v| BOXES[v / 8].1).collect(),
        }
    }

    /// The first so many boxes.
    fn mesh(&self, boxes: usize) -> Mesh {
        let indices = Indices::U16(&self.indices[..36 * boxes]);
        Mesh::new(Positions::F32(&self.positions), indices, PartIds::U8(&self.parts))
    }
}

/// The pointer's ray in a frame.
fn ray_at(frame: u32) -> Ray {
    let mut ray = Ray { origin: Vec3::new(0.9, 0.9, 2.0), direction: Vec3::new(-0.35, -0.45, -1.55) };
    ray.direction.x -= 0.01 * frame as f32;
    ray.direction.z += 0.005 * frame as f32;
    ray
}

fn print(name: &str, values: &[f32]) {
    let bits: String = values.iter().map(|value| format!(" {:08x}", value.to_bits())).collect();
    println!("{name}{bits}");
}

fn print_joint(j: &Joint) {
    println!("joint {} source {}", j.type_, j.source);
    let (a, o) = (j.axis, j.origin);
    print(" ", &[a.x, a.y, a.z, o.x, o.y, o.z, j.lower, j.upper, j.type_confidence, j.joint_confidence]);
}

fn print_pose(pose: &Pose) {
    print(" ", &pose.real);
    print(" ", &pose.dual);
}

fn print_state(name: &str, s: &DragState) {
    println!("{name} phase {} events {} changes {} basis {}", s.phase, s.events, s.changes, s.joint_basis);
    print(" ", &[s.value, s.joint_confidence]);
    print_pose(&s.pose);
}

fn print_hypotheses(object: &Object, part: u32) -> Result<()> {
    let all = object.hypotheses(part, None)?;
    println!("part {part} hypotheses {}", all.len());
    print_joint(&object.joint(part)?);
    all.iter().for_each(print_joint);
    Ok(())
}

fn pick(context: &Context, object: &Object) -> Outcome<Hit> {
    let mut scene = context.scene()?;
    scene.add(object, None)?;
    scene.commit()?;
    let hit = scene.pick(&ray_at(0))?.ok_or("nothing was hit")?;
    println!("picked part {} triangle {}", hit.part_id, hit.triangle);
    print(" ", &[hit.object_point.x, hit.object_point.y, hit.object_point.z]);
    Ok(hit)
}

fn drag_and_release(object: &Object, hit: &Hit) -> Result<()> {
    let mut options = DragOptions::at(hit.part_id, hit.object_point);
    let mut drag = object.grab(&options)?;
    let (mut events, mut saved) = (0, Vec::new());
    for frame in 0..FRAMES {
        let state = drag.update(&ray_at(frame), FRAME_TIME)?;
        events |= state.events;
        if frame % SHOWN_EVERY == 0 {
            print_state("frame", &state);
        }
        if frame == SAVED_AT {
            saved = drag.save()?;
        }
    }
    drag.restore(&saved)?;
    let mut state = drag.update(&ray_at(FRAMES), FRAME_TIME)?;
    print_state("restored", &state);
    let plan = drag.release(ReleaseOptions { intent: Go::Open, by_rule: true, ..Default::default() })?;
    print("plan", &[plan.end_value]);
    for _ in 0..RELEASED_FRAMES {
        state = drag.advance(FRAME_TIME)?;
        events |= state.events;
    }
    state.events = events;
    print_state("released", &state);
    options.state = Some(drag.finish()?);
    options.grab_point = Some(state.grab_point);
    let again = object.grab(&options)?.finish()?;
    print("again", &[again.value]);
    print_pose(&again.pose);
    let [a, b, c, d] = again.joint.evidence;
    println!("evidence {a} {b} {c} {d}");
    Ok(())
}

fn drag_behind_latch(object: &Object, hit: &Hit) -> Result<()> {
    let mut rules = Rules { snaps: vec![0.2, 0.4], ..Default::default() };
    rules.numbers.flags = sys::DM_RULE_LATCH as u32;
    let options = DragOptions { rules: Some(rules), ..DragOptions::at(hit.part_id, hit.object_point) };
    let mut drag = object.grab(&options)?;
    let mut input = Input { flags: sys::DM_INPUT_ASK as u32, ..Default::default() };
    input.hand.kind = sys::DM_HAND_RAY;
    let (mut state, mut events, mut detents) = (DragState::default(), 0, 0);
    for frame in 0..FRAMES {
        input.hand.ray = ray_at(frame);
        input.handles[0] = if frame < HANDLE_TURNS_AT { 0.0 } else { HANDLE_TURN };
        state = drag.update_input(&input, FRAME_TIME)?;
        if state.value > WIDEST {
            state = drag.override_value(WIDEST)?;
        }
        events |= state.events;
        detents += state.detents;
        if frame % SHOWN_EVERY == 0 {
            print_state("latch", &state);
        }
    }
    state.events = events;
    print_state("latched", &state);
    println!("detents {detents}");
    Ok(())
}

fn follow_links(object: &mut Object) -> Result<()> {
    object.set_links(&[
        Link { driver: DOOR, driven: DRAWER, ratio: 0.25, from: 0.1, ..Default::default() },
        Link { driver: DRAWER, driven: DOOR, kind: sys::DM_LINK_HOLDS, from: 0.05, ..Default::default() },
    ])?;
    let mut values = [-0.9, 0.0];
    for _ in 0..2 {
        let held = object.follow_links(DOOR, &mut values)?;
        print("linked", &values);
        println!("held {} {}", u8::from(held[0]), u8::from(held[1]));
        values[0] = 0.9;
    }
    Ok(())
}

fn save_and_load(context: &Context, object: &mut Object) -> Result<()> {
    let data = object.save()?;
    let hash = data.iter().fold(2166136261, |hash: u32, &byte| (hash ^ u32::from(byte)).wrapping_mul(16777619)); // FNV-1a
    println!("saved {} bytes {hash:08x}", data.len());
    print_joint(&context.load(&data, None)?.joint(DOOR)?);
    Ok(())
}

fn main() -> Outcome<()> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "sdk/models".into());
    let context = Context::new(ContextOptions::default())?;
    let model = context.load_model_from(folder)?;
    let cabinet = Cabinet::new();
    let parts = [
        Part { id: DOOR, label: Some("kitchen/cabinet/door"), ..Default::default() },
        Part { id: DRAWER, label: Some("kitchen/cabinet/drawer"), ..Default::default() },
    ];
    let how = Prepare { parts: &parts, model: Some(&model), ..Default::default() };
    let mut object = context.prepare(&cabinet.mesh(BOXES.len()), how)?;
    print_hypotheses(&object, DOOR)?;
    print_hypotheses(&object, DRAWER)?;
    let hit = pick(&context, &object)?;
    drag_and_release(&object, &hit)?;
    drag_behind_latch(&object, &hit)?;
    follow_links(&mut object)?;
    save_and_load(&context, &mut object)?;
    // One box, without any part.
    if let Err(error) = context.prepare(&cabinet.mesh(1), Prepare::default()) {
        println!("error {}", error.name());
    }
    Ok(())
}
