// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which OpenBLAS kernel must replace which. Rates and restarts: blas_kernel.py.

#include <ringmotor/programs/blas_kernel.h>

#include <strings.h>

#include <cstdlib>
#include <gtest/gtest.h>

using namespace ringmotor;

TEST(BlasKernel, FollowsTheInstructionsWhereTheProcessorWasUnknown)
{
  const auto avx2 = VectorInstructions::avx2, avx512 = VectorInstructions::avx512;
  EXPECT_EQ(faster_blas_kernel("Prescott", avx512), "SkylakeX");
  EXPECT_EQ(faster_blas_kernel("Haswell", avx512), "SkylakeX");
  EXPECT_EQ(faster_blas_kernel("Zen", avx512), "SkylakeX");
  EXPECT_EQ(faster_blas_kernel("Prescott", avx2), "Haswell");
  EXPECT_EQ(faster_blas_kernel("Sandybridge", avx2), "Haswell");
}

TEST(BlasKernel, StaysWhereItSuitsTheProcessor)
{
  const auto older = VectorInstructions::older, avx2 = VectorInstructions::avx2,
             avx512 = VectorInstructions::avx512;
  for (const char *kernel : {"SkylakeX", "Cooperlake", "SapphireRapids", "of the future", ""})
    EXPECT_EQ(faster_blas_kernel(kernel, avx512), "") << kernel;
  for (const char *kernel : {"Haswell", "Zen", "Excavator", ""})
    EXPECT_EQ(faster_blas_kernel(kernel, avx2), "") << kernel;
  for (const char *kernel : {"Prescott", "Sandybridge", "Haswell"})
    EXPECT_EQ(faster_blas_kernel(kernel, older), "") << kernel;
}

TEST(BlasKernel, OfThisProcessIsTheOneChosenOrNoFasterOneIsThere)
{
  const std::string kernel = blas_kernel();
  const char *chosen       = std::getenv("OPENBLAS_CORETYPE"); // by the user or by a restart
  if (kernel.empty())
    GTEST_SKIP() << "the BLAS is not OpenBLAS";
  if (chosen == nullptr)
    EXPECT_EQ(faster_blas_kernel(kernel, vector_instructions()), "") << "instead of " << kernel;
  else
    EXPECT_EQ(strcasecmp(kernel.c_str(), chosen), 0) << kernel << " is not " << chosen;
}
