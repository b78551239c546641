// SPDX-License-Identifier: LGPL-2.1-or-later
//
// To be loaded before a program (LD_PRELOAD): makes an OpenBLAS that knows the processor behave as
// one that does not, and takes the kernel OLD_BLAS_KERNEL where nobody chooses. Without a variable
// OPENBLAS_CORETYPE, what the library itself calls at its start is called again with one.

#include <dlfcn.h>

#include <cstdlib>

namespace
{
  // The library is linked with a BLAS, so that this comes after the start of OpenBLAS.
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
