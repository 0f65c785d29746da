/* Gives the compiler back what begin_scalar.h has put aside. */
#pragma pop_macro("__AVX__")
#pragma pop_macro("__SSE2__")
#pragma pop_macro("__SSE__")
