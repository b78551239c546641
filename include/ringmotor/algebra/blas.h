// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <complex>

// The functions of BLAS that are called directly, as Fortran names them.
extern "C"
{
  void dgemm_(const char *transpose_a, const char *transpose_b, const int *m, const int *n,
              const int *k, const double *alpha, const double *a, const int *lda, const double *b,
              const int *ldb, const double *beta, double *c, const int *ldc);
  void dgemv_(const char *transpose, const int *m, const int *n, const double *alpha,
              const double *a, const int *lda, const double *x, const int *incx, const double *beta,
              double *y, const int *incy);
  void zgemv_(const char *transpose, const int *m, const int *n, const std::complex<double> *alpha,
              const std::complex<double> *a, const int *lda, const std::complex<double> *x,
              const int *incx, const std::complex<double> *beta, std::complex<double> *y,
              const int *incy);
  void zgemm_(const char *transpose_a, const char *transpose_b, const int *m, const int *n,
              const int *k, const std::complex<double> *alpha, const std::complex<double> *a,
              const int *lda, const std::complex<double> *b, const int *ldb,
              const std::complex<double> *beta, std::complex<double> *c, const int *ldc);
}
