# marrow_same_bits(TARGET): arithmetic that is the same on every processor and by every compiler.
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(__i386__ cstddef MARROW_ON_I386)
function(marrow_same_bits target)
  if(MSVC)
    # cl fuses nothing by /fp:precise unless /fp:contract is given; clang-cl has to be told.
    target_compile_options(${target} PRIVATE /fp:precise $<$<CXX_COMPILER_ID:Clang>:/clang:-ffp-contract=off>)
    return()
  endif()
  # No fused multiply-add.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # The x87, which compilers for i386 take unless told otherwise, rounds when it likes.
  if(MARROW_ON_I386)
    target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
  endif()
endfunction()

# marrow_runtime_flags(TARGET): how the runtime's libraries are compiled.
function(marrow_runtime_flags target)
  marrow_same_bits(${target})
  if(MSVC)
    target_compile_options(${target} PRIVATE /GR-)
  else()
    target_compile_options(${target} PRIVATE -fno-exceptions -fno-rtti -fno-math-errno)
  endif()
endfunction()
