// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>

#include <functional>
#include <vector>

namespace ringmotor
{
  /**
   * A symmetric pencil K - lambda M in shift-inverted form. Vectors are real and hold `size`
   * numbers. Where `complex` is true they are the real parts followed by the imaginary parts of
   * size/2 complex numbers and the pencil stands for a complex Hermitian one.
   */
  struct ShiftInvertedPencil
  {
    unsigned int size = 0;
    bool complex      = false;
    double shift      = 0.;
    std::function<void(std::vector<double> &)> solve; ///< x <- (K - shift M)^-1 x
    std::function<void(const std::vector<double> &, std::vector<double> &)>
        mass; ///< second argument = M first
  };

  struct Eigenpair
  {
    double value;
    std::vector<double> vector; ///< M-normalised
  };

  /** Numbers to which no eigenvector is orthogonal, the same in every run. */
  std::vector<double> generic_vector(const std::size_t size);

  enum class EigenvalueChoice
  {
    nearest, ///< those nearest to the shift
    below    ///< those below the shift, nearest first
  };

  /**
   * @p count eigenpairs of @p pencil by ARPACK's implicitly restarted Lanczos (Arnoldi where
   * complex) method to machine precision, sorted by value. @p start (size of the pencil) speeds
   * convergence up where the eigenvectors are roughly known; pass a generic vector otherwise.
   * Deterministic, and the same on all ranks if the operators are.
   * @throws ComputationError if ARPACK does not converge.
   */
  std::vector<Eigenpair> eigenpairs(const ShiftInvertedPencil &pencil,
                                    const EigenvalueChoice choice, const unsigned int count,
                                    const std::vector<double> &start);

  /**
   * The same for a real pencil with multiple eigenvalues, of which a single sequence of vectors
   * would find one vector each: by the block Krylov-Schur method of Trilinos (Anasazi). Vectors are
   * distributed over the ranks of @p communicator meanwhile; the operators of @p pencil get whole
   * ones, several one after the other, on all ranks.
   * @param multiplicity the largest one
   * @param residual relative, at which a pair is accepted; the error of the value is its square
   * @throws ComputationError if Anasazi does not converge.
   */
  std::vector<Eigenpair> multiple_eigenpairs(const ShiftInvertedPencil &pencil,
                                             const EigenvalueChoice choice,
                                             const unsigned int count,
                                             const unsigned int multiplicity, const double residual,
                                             MPI_Comm communicator);
} // namespace ringmotor
