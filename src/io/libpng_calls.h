#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstring>

// How faults come out of libpng. It is C: it wants an error handler that does not return. Throwing
// through its frames only works where it happens to be compiled with unwind tables, so the handler
// jumps. A jump must not skip destructors; hence one rule for reading and writing: whatever runs
// inside `attempt` (our callbacks too) holds no object with a destructor while it calls libpng.
// Buffers and handles live in the caller, and the jump is turned into an exception only after
// `attempt`.

namespace fluidymation::libpng {

/// Room for what libpng says about a fault.
using Message = std::array<char, 160>;

[[noreturn]] inline void onError(png_structp png, png_const_charp text) {
  auto& message = *static_cast<Message*>(png_get_error_ptr(png));
  std::strncpy(message.data(), text, message.size() - 1);
  png_longjmp(png, 1);
}

/// Warnings are about chunks we do not use; what matters is an error.
inline void onWarning(png_structp /*png*/, png_const_charp /*text*/) {}

/// Runs `body`, which calls libpng; false when libpng found an error. Not inlined, so that no
/// variable of the caller can live in a register that the jump restores.
template <typename Body>
[[gnu::noinline]] bool attempt(png_structp png, const Body& body) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

}  // namespace fluidymation::libpng
