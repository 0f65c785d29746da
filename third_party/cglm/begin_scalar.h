/* What follows, up to end_scalar.h, is compiled without vector instructions: cglm's vector code adds and fuses in an order of its
 * own on each machine, and takes aligned addresses alone. cglm has no switch against it. It asks for macros of the compiler, which
 * are put aside here, and for macros of its own that simd/intrin.h defines, which is empty in upstream. There is no include guard:
 * each header that needs the file includes it. */
#pragma push_macro("__SSE__")
#pragma push_macro("__SSE2__")
#pragma push_macro("__AVX__")
#undef __SSE__
#undef __SSE2__
#undef __AVX__
