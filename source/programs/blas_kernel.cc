// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/programs/blas_kernel.h>

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <set>
#include <system_error>
#include <vector>

extern "C" void dgemm_(const char *, const char *, const int *, const int *, const int *,
                       const double *, const double *, const int *, const double *, const int *,
                       const double *, double *, const int *);

namespace ringmotor
{
  namespace
  {
    constexpr const char *variable = "OPENBLAS_CORETYPE";
  }

  VectorInstructions vector_instructions()
  {
#ifdef __x86_64__
    // The compiler's test includes the operating system, which must save the registers.
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      return VectorInstructions::avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
      return VectorInstructions::avx2;
#endif
    return VectorInstructions::older;
  }

  std::string blas_kernel()
  {
    // Any BLAS may be linked, so the function is looked for when the program runs.
    const auto name = reinterpret_cast<char *(*)()>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
    return name == nullptr ? "" : name();
  }

  std::string faster_blas_kernel(const std::string &kernel, const VectorInstructions instructions)
  {
    // What OpenBLAS uses for unknown processors, and only these: all other kernels are for
    // processors that it recognised. doc/accuracy_and_cost.md has the measured rates.
    const std::set<std::string> without_avx2 = {"Prescott", "Core2", "Nehalem", "Barcelona",
                                                "Sandybridge"};
    const std::set<std::string> with_avx2    = {"Haswell", "Zen"};
    const bool is_older                      = without_avx2.count(kernel) == 1;
    if (instructions == VectorInstructions::avx512 && (is_older || with_avx2.count(kernel) == 1))
      return "SkylakeX";
    if (instructions == VectorInstructions::avx2 && is_older)
      return "Haswell";
    return "";
  }

  void restart_with_faster_blas_kernel(char **argv)
  {
    if (std::getenv(variable) != nullptr)
      return;
    const std::string kernel = faster_blas_kernel(blas_kernel(), vector_instructions());
    if (kernel.empty())
      return;
    // By its own name: started as /proc/self/exe, it would be listed as "exe".
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error)
      return;
    setenv(variable, kernel.c_str(), /*overwrite =*/0);
    execv(program.c_str(), argv);
    unsetenv(variable); // only reached if it failed
  }

  void reserve_blas_memory()
  {
    constexpr std::size_t buffer = 160u << 20; // of OpenBLAS, which takes 128 MB on most machines
    char *const trial            = static_cast<char *>(::operator new(buffer));
    ::operator delete(trial);
    constexpr int n  = 64; // large enough that the product takes the buffer
    const double one = 1., zero = 0.;
    const std::vector<double> a(n * n, 1.);
    std::vector<double> product(n * n);
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, product.data(), &n);
  }
} // namespace ringmotor
