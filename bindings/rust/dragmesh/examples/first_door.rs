//! Pulls the first part of a prepared object open with a pointer, and lets it swing: first_door OBJECT.dmo
use dragmesh::{prelude::*, sys, Context, ContextOptions, DragOptions, Go, Ray, Vec3};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("first_door OBJECT.dmo")?;
    let context = Context::new(ContextOptions::default())?;
    let object = context.load(&std::fs::read(path)?, None)?;
    let part = object.parts()?[0];
    let mut drag = object.grab(&DragOptions::at(part.id, part.centre))?; // at a hit's object_point
    let origin = Vec3::new(part.centre.x, part.centre.y, part.centre.z + 2.0);
    let mut state = Default::default();
    for frame in 0..60 {
        let ray = Ray { origin, direction: Vec3::new(-0.003 * frame as f32, 0.0, -2.0) }; // in the object's frame
        state = drag.update(&ray, 1.0 / 60.0)?;
    }
    drag.release(Go::Open)?;
    while state.phase != sys::DM_DRAG_AT_REST {
        state = drag.advance(1.0 / 60.0)?;
    }
    let kept = drag.finish()?; // joint, value and pose: what the instance saves
    println!("part {} stands open at {:.2}", part.id, kept.value);
    Ok(())
}
