// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace ringmotor
{
  /** The widest vector instructions for which OpenBLAS has its own kernels. */
  enum class VectorInstructions
  {
    older,
    avx2,  ///< with FMA
    avx512 ///< the subsets F, CD, BW, DQ and VL
  };

  /** What processor and operating system support. */
  VectorInstructions vector_instructions();

  /** The kernel OpenBLAS uses, as it calls it: "Haswell". Empty if the BLAS is another library. */
  std::string blas_kernel();

  /**
   * The kernel that is faster than @p kernel on a processor with these instructions; empty if
   * OpenBLAS has none, or if @p kernel is not one of its fallbacks for unknown processors.
   */
  std::string faster_blas_kernel(const std::string &kernel, const VectorInstructions instructions);

  /**
   * Starts the program once more, with OPENBLAS_CORETYPE in the environment, if OpenBLAS uses a
   * kernel slower than the processor allows: an OpenBLAS older than the processor does. It reads
   * the variable only while it is loaded. A value that is already set is kept, which also prevents
   * a second restart. Must be called before MPI starts and before anything is written.
   *
   * Returns if there is nothing to do, or if the program cannot be started again: it is then
   * slower, not wrong.
   *
   * @param argv of main(), all of it
   */
  void restart_with_faster_blas_kernel(char **argv);

  /**
   * Lets OpenBLAS allocate the buffer that its products of matrices need. It tries for ever if
   * there is no memory for that, so that the buffer has to be there before the program fills the
   * memory.
   *
   * @throws std::bad_alloc if there is not enough memory
   */
  void reserve_blas_memory();
} // namespace ringmotor
