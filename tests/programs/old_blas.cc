// SPDX-License-Identifier: LGPL-2.1-or-later
//
// To be loaded before a program (LD_PRELOAD): makes an OpenBLAS that knows the processor behave as
// one that does not, and uses the kernel OLD_BLAS_KERNEL unless one is chosen. If OPENBLAS_CORETYPE
// is not set, the library's initialisation functions are called again with it set.

#include <dlfcn.h>

#include <cstdlib>

namespace
{
  // The library is linked with a BLAS, so this runs after the initialisation of OpenBLAS.
  __attribute__((constructor)) void take_old_kernel()
  {
    const char *variable = "OPENBLAS_CORETYPE", *kernel = std::getenv("OLD_BLAS_KERNEL");
    const auto stop  = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "gotoblas_dynamic_quit"));
    const auto start = reinterpret_cast<void (*)()>(dlsym(RTLD_DEFAULT, "gotoblas_dynamic_init"));
    if (kernel == nullptr || stop == nullptr || start == nullptr ||
        std::getenv(variable) != nullptr)
      return;
    setenv(variable, kernel, /*overwrite =*/0);
    stop();
    start();
    unsetenv(variable);
  }
} // namespace
