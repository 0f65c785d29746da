//! Callbacks of the host: nothing passes through the library, and none calls the context that calls it.
use std::any::Any;
use std::cell::RefCell;
use std::panic::{catch_unwind, AssertUnwindSafe};

thread_local! {
    /// Names of the contexts whose callbacks run on this thread.
    static RUNNING: RefCell<Vec<usize>> = RefCell::new(Vec::new());
}

struct Running;

impl Running {
    fn begin(context: usize) -> Self {
        let _ = RUNNING.try_with(|running| running.borrow_mut().push(context));
        Self
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = RUNNING.try_with(|running| running.borrow_mut().pop());
    }
}

/// Runs a callback of a context, and keeps a panic in.
pub(crate) fn guarded<T>(context: usize, run: impl FnOnce() -> T) -> Result<T, Box<dyn Any + Send>> {
    let _running = Running::begin(context);
    catch_unwind(AssertUnwindSafe(run))
}

/// Whether a callback of this context runs on this thread.
pub(crate) fn is_running(context: usize) -> bool {
    RUNNING.try_with(|running| running.borrow().contains(&context)).unwrap_or(false)
}
