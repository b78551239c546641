// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_factors.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * Charges on the lower electrode of a piezoelectric ring and its response to potentials there,
   * harmonic by harmonic around the ring: exp(-i k theta) for any whole k, which moves the ring
   * with the nodal diameter n = +-k modulo the number of sectors.
   */
  class ElectricResponse
  {
  public:
    /** @p sector must outlive this object. */
    explicit ElectricResponse(const CyclicSector &sector);

    /**
     * The charge of a motion of nodal diameter n, of which exp(-i k theta) is one harmonic, on the
     * whole ring: the sum of charge times exp(i k theta), in C. With the potential of the motion in
     * equilibrium it is also the modal force, in N m, per volt of the potential exp(i k theta), see
     * SolidElement.
     */
    std::complex<double> charge(const SectorMotion &motion, const int k) const;

    /**
     * Charges per volt (F): entry (l, k) is charge() l of the response to the potential
     * exp(-i k theta) on the lower electrode, at the frequency of the shift omega^2 (rad^2/s^2)
     * without damping. Hermitian. All @p harmonics are those of one nodal diameter @p n.
     */
    dealii::FullMatrix<std::complex<double>> capacitances(CyclicFactors &factors,
                                                          const unsigned int n, const double shift,
                                                          const std::vector<int> &harmonics) const;

  private:
    /** A piezoelectric cell of this rank. */
    struct Cell
    {
      std::vector<SectorNodes::Dof> displacements, potentials;
      dealii::FullMatrix<double> coupling, dielectric; ///< B and D of SolidElement
    };

    /** Forces B phi and charges D phi - B^T u of a motion, on all ranks. */
    SectorMotion electric_loads(const SectorMotion &motion) const;
    /** charge() of a motion with these loads. */
    std::complex<double> charge_of_loads(const SectorMotion &loads, const int k) const;
    /** The potential exp(-i k theta) on the lower electrode, zero elsewhere. */
    SectorMotion driven(const int k) const;

    const CyclicSector &sector;
    std::vector<Cell> cells;
    std::vector<SectorNodes::Dof> electrode;
  };
} // namespace ringmotor
