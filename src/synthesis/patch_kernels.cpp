#include "synthesis/patch_kernels.h"

namespace fluidymation {

const PatchKernels& bestKernels() {
  static const PatchKernels& best = avx2Kernels() != nullptr ? *avx2Kernels() : portableKernels();
  return best;
}

}  // namespace fluidymation
