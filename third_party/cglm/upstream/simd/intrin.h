/* Empty in place of cglm's file, which includes vector code and defines the macros that ask for it. See begin_scalar.h. */
