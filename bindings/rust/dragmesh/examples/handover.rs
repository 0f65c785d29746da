//! What a host does with a joint beside dragging: a constraint for physics, a saved game, a client. handover OBJECT.dmo
use dragmesh::{prelude::*, Context, ContextOptions, DragOptions, Joint, PartState, Vec3};

/// Numbers, not the struct as it lies in memory: structs grow. Display keeps every bit of a float.
fn save(door: &PartState) -> String {
    let j = &door.joint;
    let numbers = [door.value, j.type_confidence, j.joint_confidence, j.pitch, j.lower, j.upper];
    let vectors = [j.axis.x, j.axis.y, j.axis.z, j.origin.x, j.origin.y, j.origin.z];
    let words: Vec<String> = numbers.iter().chain(&vectors).map(f32::to_string).collect();
    let [a, b, c, d] = j.evidence; // what pulls have said
    format!("{} {} {a} {b} {c} {d} {}", j.type_, j.source, words.join(" "))
}

fn load(text: &str) -> Result<PartState, Box<dyn std::error::Error>> {
    let words: Vec<&str> = text.split(' ').collect();
    let n = words[6..].iter().map(|word| word.parse()).collect::<Result<Vec<f32>, _>>()?;
    let joint = Joint {
        type_: words[0].parse()?,
        source: words[1].parse()?,
        type_confidence: n[1],
        joint_confidence: n[2],
        pitch: n[3],
        lower: n[4],
        upper: n[5],
        axis: Vec3::new(n[6], n[7], n[8]),
        origin: Vec3::new(n[9], n[10], n[11]),
        evidence: [words[2].parse()?, words[3].parse()?, words[4].parse()?, words[5].parse()?],
        ..Default::default()
    };
    Ok(PartState { value: n[0], joint, pose: joint.pose_at(n[0])?, ..Default::default() })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("handover OBJECT.dmo")?;
    let context = Context::new(ContextOptions::default())?;
    let object = context.load(&std::fs::read(path)?, None)?;
    let part = object.parts()?[0];
    let mut door = PartState { joint: object.joint(part.id)?, ..Default::default() };

    // Physics: origin, rotation (x is the axis) and limits are those of the engine's hinge or slider.
    let frame = door.joint.frame()?;
    println!("a constraint that opens to {:.2}", frame.upper);

    // … and back: body is the transform that the engine has given the part, from rest.
    let body = door.joint.pose_at(1.2)?;
    let (value, _angle_off, _distance_off) = door.joint.value_of(&body)?;
    (door.value, door.pose) = (value, body);
    println!("physics leaves it at {:.2}", door.value);

    let loaded = load(&save(&door))?;
    println!("saved and loaded at {:.2}", loaded.value);

    // A client has neither object nor context: the joint once, the value every frame.
    let shown = loaded.joint.pose_at(loaded.value)?;

    // The next grab begins where the part stands.
    let grab = DragOptions { state: Some(loaded), ..DragOptions::at(part.id, shown.apply(part.centre)) };
    println!("grabbed again at {:.2}", object.grab(&grab)?.finish()?.value);
    Ok(())
}
