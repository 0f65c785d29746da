use crate::sys;
use std::cell::RefCell;
use std::ffi::CStr;
use std::fmt;

/// What kind of failure it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ErrorKind {
    InvalidArgument,
    StaleHandle,
    OutOfMemory,
    NotFinite,
    IndexOutOfRange,
    EmptyMask,
    FullMask,
    DegenerateMesh,
    ZeroDrag,
    DragOffPart,
    BadData,
    WrongModel,
    Version,
    Cancelled,
    NoModel,
    TooLarge,
    BufferTooSmall,
    NotFound,
    Unsupported,
    Other,
}

/// A failed call, with the library's own words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    code: sys::dm_result,
    message: String,
}

pub type Result<T> = std::result::Result<T, Error>;

thread_local! {
    static LAST: RefCell<String> = RefCell::new(String::new());
}

/// Keeps what the library has logged on this thread for the error that follows.
pub(crate) fn remember(message: &str) {
    // try_with: a thread that ends may still log.
    let _ = LAST.try_with(|last| last.replace(message.to_owned()));
}

/// Turns the result of a call into an error.
pub(crate) fn check(code: sys::dm_result) -> Result<()> {
    if code >= 0 {
        return Ok(());
    }
    let message = LAST.try_with(|last| last.take()).unwrap_or_default();
    Err(Error { code, message })
}

impl Error {
    pub(crate) fn invalid(message: &str) -> Self {
        Self { code: sys::DM_ERROR_INVALID_ARGUMENT, message: message.to_owned() }
    }

    pub fn kind(&self) -> ErrorKind {
        match self.code {
            sys::DM_ERROR_INVALID_ARGUMENT => ErrorKind::InvalidArgument,
            sys::DM_ERROR_STALE_HANDLE => ErrorKind::StaleHandle,
            sys::DM_ERROR_OUT_OF_MEMORY => ErrorKind::OutOfMemory,
            sys::DM_ERROR_NOT_FINITE => ErrorKind::NotFinite,
            sys::DM_ERROR_INDEX_OUT_OF_RANGE => ErrorKind::IndexOutOfRange,
            sys::DM_ERROR_EMPTY_MASK => ErrorKind::EmptyMask,
            sys::DM_ERROR_FULL_MASK => ErrorKind::FullMask,
            sys::DM_ERROR_DEGENERATE_MESH => ErrorKind::DegenerateMesh,
            sys::DM_ERROR_ZERO_DRAG => ErrorKind::ZeroDrag,
            sys::DM_ERROR_DRAG_OFF_PART => ErrorKind::DragOffPart,
            sys::DM_ERROR_BAD_DATA => ErrorKind::BadData,
            sys::DM_ERROR_WRONG_MODEL => ErrorKind::WrongModel,
            sys::DM_ERROR_VERSION => ErrorKind::Version,
            sys::DM_ERROR_CANCELLED => ErrorKind::Cancelled,
            sys::DM_ERROR_NO_MODEL => ErrorKind::NoModel,
            sys::DM_ERROR_TOO_LARGE => ErrorKind::TooLarge,
            sys::DM_ERROR_BUFFER_TOO_SMALL => ErrorKind::BufferTooSmall,
            sys::DM_ERROR_NOT_FOUND => ErrorKind::NotFound,
            sys::DM_ERROR_UNSUPPORTED => ErrorKind::Unsupported,
            _ => ErrorKind::Other,
        }
    }

    /// The number in C.
    pub fn code(&self) -> i32 {
        self.code
    }

    /// The name in C, such as `DM_ERROR_EMPTY_MASK`.
    pub fn name(&self) -> &'static str {
        let name = unsafe { CStr::from_ptr(sys::dm_result_string(self.code)) };
        name.to_str().unwrap_or("DM_ERROR_UNKNOWN")
    }

    /// What the library says of it; it names the field and the value.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.message.as_str() {
            "" => f.write_str(self.name()),
            message => write!(f, "{}: {}", self.name(), message),
        }
    }
}

impl std::error::Error for Error {}
