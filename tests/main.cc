// SPDX-License-Identifier: LGPL-2.1-or-later

// The main function of every test program: GoogleTest on one or more ranks. Each rank runs the same
// tests; rank 0 prints, and a failure on any rank is a failure of all.

#include <ringmotor/programs/blas_kernel.h>
#include <ringmotor/programs/launcher.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

namespace
{
  /** Other ranks report failures only, with their number. */
  class FailurePrinter : public testing::EmptyTestEventListener
  {
    void OnTestPartResult(const testing::TestPartResult &result) override
    {
      if (result.failed())
        std::cerr << "rank " << dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) << ": "
                  << result.file_name() << ":" << result.line_number() << ": " << result.summary()
                  << std::endl;
    }
  };
} // namespace

int main(int argc, char **argv)
{
  std::vector<char *> arguments(argv, argv + argc + 1); // before GoogleTest removes its own
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests)) // ctest requests the names: MPI would only take time
    return RUN_ALL_TESTS();

  ringmotor::restart_with_faster_blas_kernel(arguments.data());
  ringmotor::spare_the_network_search();
  int n_words = 1; // as in run_program
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_words, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
  {
    testing::TestEventListeners &listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new FailurePrinter);
  }
  return dealii::Utilities::MPI::max(RUN_ALL_TESTS(), MPI_COMM_WORLD);
}
