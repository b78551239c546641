// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Prints the kernel of OpenBLAS and its rates, in GFlop/s, for products of matrices with 500 and
// 900 rows. Each is the best of a few repetitions, by processor time, as the machine may be shared.

#include <ringmotor/programs/blas_kernel.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <limits>
#include <vector>

extern "C" void dgemm_(const char *, const char *, const int *, const int *, const int *,
                       const double *, const double *, const int *, const double *, const int *,
                       const double *, double *, const int *);

namespace
{
  double processor_seconds()
  {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double rate(const int n, const unsigned int n_repetitions)
  {
    const std::vector<double> a(n * n, 0.5), b(n * n, 0.25);
    std::vector<double> c(n * n);
    const double one = 1., zero = 0.;
    double shortest = std::numeric_limits<double>::infinity();
    for (unsigned int repetition = 0; repetition < n_repetitions; ++repetition)
    {
      const double begin = processor_seconds();
      dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
      shortest = std::min(shortest, processor_seconds() - begin);
    }
    return 2e-9 * n * n * n / shortest;
  }
} // namespace

int main(int, char **argv)
{
  ringmotor::restart_with_faster_blas_kernel(argv);
  const double small = rate(500, 8), large = rate(900, 3);
  std::cout << ringmotor::blas_kernel() << ' ' << small << ' ' << large << std::endl;
}
