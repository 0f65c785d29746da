use crate::error::{check, Error, Result};
use crate::object::ObjectInner;
use crate::sys;
use crate::values::{DragState, Feel, PartState, Ray, ReleasePlan, Sized, Vec3};
use std::sync::Arc;

/// What a part does besides following the hand. `numbers` are the fields of `dm_drag_rules`; its pointer to snap values
/// is not read.
#[derive(Clone, Debug, Default)]
pub struct Rules {
    pub numbers: sys::dm_drag_rules,
    /// Joint values where the part catches, rising.
    pub snaps: Vec<f32>,
}

/// How to grab a part. Zeros and `None` are the defaults.
#[derive(Clone, Debug, Default)]
pub struct DragOptions {
    pub part: u32,
    /// Where, on the part as it is now; `None`: at no point, to be moved by a scalar or a release.
    pub grab_point: Option<Vec3>,
    /// Joint value that the part has now. Not with `state`.
    pub start_value: f32,
    pub feel: Feel,
    /// Follow the joint in force, whatever the pull says.
    pub keep_joint: bool,
    pub limit_give: f32,
    /// What an earlier drag of this instance has ended with.
    pub state: Option<PartState>,
    /// Of the instance.
    pub scale: Vec3,
    /// `None`: no rules and no events.
    pub rules: Option<Rules>,
}

impl DragOptions {
    /// With events.
    pub fn at(part: u32, point: Vec3) -> Self {
        Self { part, grab_point: Some(point), rules: Some(Rules::default()), ..Default::default() }
    }
}

/// What a released part does next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Go {
    #[default]
    Auto,
    Stay,
    Open,
    Close,
    Replay,
    Freeze,
    Toggle,
}

/// `Go`, by its name in 0.2.
pub type Intent = Go;

/// How to let go.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReleaseOptions {
    pub intent: Go,
    /// Seconds to the end; 0 = as far and fast as it goes asks for.
    pub duration: f32,
    pub seed: u32,
    /// Paced by a rule, not by the network: the same bits on every processor.
    pub by_rule: bool,
    /// A part that opens to both sides opens away from here.
    pub away_from: Option<Vec3>,
}

impl From<Go> for ReleaseOptions {
    fn from(intent: Go) -> Self {
        Self { intent, ..Default::default() }
    }
}

/// All that can be told a drag in one update: `dm_drag_input`.
pub type Input = sys::dm_drag_input;

/// One player dragging one part.
pub struct Drag {
    id: sys::dm_drag,
    of: Arc<ObjectInner>,
}

impl Drag {
    pub(crate) fn begin(of: &Arc<ObjectInner>, how: &DragOptions) -> Result<Self> {
        let state = how.state.map(|state| state.sized());
        let rules = how.rules.as_ref().map(|rules| {
            let mut numbers = rules.numbers.sized();
            numbers.snaps = rules.snaps.as_ptr();
            numbers.snap_count = u32::try_from(rules.snaps.len()).unwrap_or(u32::MAX); // refused by the library
            numbers
        });
        let mut desc = sys::dm_drag_desc {
            part_id: how.part,
            object: of.id,
            start_value: how.start_value,
            feel: how.feel,
            limit_give: how.limit_give,
            scale: how.scale,
            state: state.as_ref().map_or(std::ptr::null(), |state| state),
            rules: rules.as_ref().map_or(std::ptr::null(), |rules| rules),
            ..Default::default()
        };
        match how.grab_point {
            Some(point) => desc.grab_point = point,
            None => desc.flags |= sys::DM_DRAG_WITHOUT_POINT as u32,
        }
        if how.keep_joint {
            desc.flags |= sys::DM_DRAG_KEEP_JOINT as u32;
        }
        let mut id = 0;
        check(unsafe { sys::dm_drag_begin(of.context.pointer()?, &desc, &mut id) })?;
        Ok(Self { id, of: of.clone() })
    }

    fn pointer(&self) -> Result<*mut sys::dm_context> {
        self.of.context.pointer()
    }

    fn state(&mut self, ray: *const Ray, seconds: f32) -> Result<DragState> {
        let mut state = DragState::default();
        check(unsafe { sys::dm_drag_update(self.pointer()?, self.id, ray, seconds, &mut state) })?;
        Ok(state)
    }

    /// The grabbed point follows a ray of the object frame. seconds: since the last update.
    pub fn update(&mut self, ray: &Ray, seconds: f32) -> Result<DragState> {
        self.state(ray, seconds)
    }

    /// A released part goes on.
    pub fn advance(&mut self, seconds: f32) -> Result<DragState> {
        self.state(std::ptr::null(), seconds)
    }

    /// `update` for all that an `Input` holds.
    pub fn update_input(&mut self, input: &Input, seconds: f32) -> Result<DragState> {
        let mut state = DragState::default();
        check(unsafe { sys::dm_drag_update_input(self.pointer()?, self.id, &input.sized(), seconds, &mut state) })?;
        Ok(state)
    }

    /// Takes another value than the one that an `update_input` with `DM_INPUT_ASK` is about to take.
    pub fn override_value(&mut self, value: f32) -> Result<DragState> {
        let mut state = DragState::default();
        check(unsafe { sys::dm_drag_override(self.pointer()?, self.id, value, &mut state) })?;
        Ok(state)
    }

    /// `update_input`, by its name in 0.2.
    pub fn step(&mut self, input: &Input, seconds: f32) -> Result<DragState> {
        self.update_input(input, seconds)
    }

    /// `override_value`, by its name in 0.2.
    pub fn take(&mut self, value: f32) -> Result<DragState> {
        self.override_value(value)
    }

    /// Lets go; the part moves on by `advance`.
    pub fn release(&mut self, how: impl Into<ReleaseOptions>) -> Result<ReleasePlan> {
        let how = how.into();
        let by_rule = if how.by_rule { sys::DM_RELEASE_BY_RULE as u32 } else { 0 };
        let away = if how.away_from.is_some() { sys::DM_RELEASE_AWAY_FROM as u32 } else { 0 };
        let desc = sys::dm_release_desc {
            intent: match how.intent {
                Go::Auto => sys::DM_GO_AUTO,
                Go::Stay => sys::DM_GO_STAY,
                Go::Open => sys::DM_GO_OPEN,
                Go::Close => sys::DM_GO_CLOSE,
                Go::Replay => sys::DM_GO_REPLAY,
                Go::Freeze => sys::DM_GO_FREEZE,
                Go::Toggle => sys::DM_GO_TOGGLE,
            },
            duration: how.duration,
            seed: how.seed,
            flags: by_rule | away,
            away_from: how.away_from.unwrap_or_default(),
            ..Default::default()
        };
        let mut plan = ReleasePlan::default();
        check(unsafe { sys::dm_drag_release(self.pointer()?, self.id, &desc, &mut plan) })?;
        Ok(plan)
    }

    /// What the instance keeps: joint, value and pose.
    pub fn part_state(&mut self) -> Result<PartState> {
        let mut state = PartState::default();
        check(unsafe { sys::dm_drag_get_part_state(self.pointer()?, self.id, &mut state) })?;
        Ok(state)
    }

    /// Ends it and returns what the instance keeps.
    pub fn finish(mut self) -> Result<PartState> {
        self.part_state()
    }

    /// The whole state, for rollback.
    pub fn save(&mut self) -> Result<Vec<u8>> {
        let mut data = vec![0; unsafe { sys::dm_drag_snapshot_size() }];
        check(unsafe { sys::dm_drag_save(self.pointer()?, self.id, data.as_mut_ptr().cast(), data.len()) })?;
        Ok(data)
    }

    /// Goes back to what `save` gave, of this or another drag of the same part.
    pub fn restore(&mut self, saved: &[u8]) -> Result<()> {
        if saved.is_empty() {
            return Err(Error::invalid("nothing was saved"));
        }
        check(unsafe { sys::dm_drag_restore(self.pointer()?, self.id, saved.as_ptr().cast(), saved.len()) })
    }
}

impl Drop for Drag {
    fn drop(&mut self) {
        unsafe fn end(context: *mut sys::dm_context, id: u64) {
            sys::dm_drag_end(context, id, std::ptr::null_mut());
        }
        self.of.context.0.end(end, self.id);
    }
}
