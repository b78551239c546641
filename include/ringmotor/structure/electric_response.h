// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_factors.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace ringmotor
{
  /**
   * The charges (C) of a motion on the lower electrode of the whole ring: for each of the harmonics
   * exp(-i k theta), which must belong to the nodal diameter of the motion, the sum of charge times
   * exp(i k theta). With the potential of the motion in equilibrium these are also the modal
   * forces, in N m, per volt of the potential exp(i k theta), see SolidElement.
   */
  std::vector<std::complex<double>> electrode_charges(const CyclicSector &sector,
                                                      const SectorMotion &motion,
                                                      const std::vector<int> &harmonics);

  /**
   * The response of a piezoelectric ring to potentials on its lower electrode, harmonic by harmonic
   * around the ring: exp(-i k theta) for any whole k, which moves the ring with the nodal diameter
   * n = +-k modulo the number of sectors. The sector is condensed to its cuts and to the electrode
   * once for each frequency; then all nodal diameters are cheap.
   */
  class ElectricResponse
  {
  public:
    /** @p mesh must outlive this object. */
    ElectricResponse(const SectorMesh &mesh, const MaterialTable &materials,
                     const unsigned int degree);

    /** Condenses the sector at the frequency of a shift omega^2 (rad^2/s^2), without damping.
     * @throws ComputationError at a resonance of the sector with its cuts held */
    void condense(const double shift);

    /**
     * Charges per volt (F) at that frequency: entry (l, k) is the sum over the whole ring of the
     * charge due to the potential exp(-i k theta), times exp(i l theta). Hermitian. All @p
     * harmonics are those of one nodal diameter @p n, 0 to half the number of sectors.
     */
    dealii::FullMatrix<std::complex<double>> capacitances(const unsigned int n,
                                                          const std::vector<int> &harmonics) const;

    const CyclicSector &body() const { return sector; }

  private:
    template <typename Type>
    using PerField = SectorFactors::PerField<Type>;

    /** The numbers in a field of the degrees of freedom on the cuts, without electrodes, and of
     * those of the electrode. */
    struct Kept
    {
      std::vector<unsigned int> cut, electrode;
      std::vector<unsigned int> place; ///< in #cut, by position in CyclicSector::RealField::cut
      std::vector<dealii::Point<3>> positions; ///< of the electrode's nodes
    };
    PerField<std::vector<unsigned int>> all_kept() const;
    static Kept kept_in(const CyclicSector &sector, const unsigned int part);

    /** A condensed field: its blocks by columns; rows and columns on the cut (c) or electrode (e).
     */
    struct Field
    {
      std::vector<double> cc, ec, ee;
    };

    /** The potentials of harmonics on the electrode of a field, one after the other. */
    std::vector<double> potentials(const unsigned int part,
                                   const std::vector<int> &harmonics) const;
    /** How the cuts of both fields follow from potentials of nodal diameter @p n on the electrode.
     */
    PerField<std::vector<double>>
    motions_of_cuts(const unsigned int n, const PerField<std::vector<double>> &potentials) const;

    const CyclicSector sector; ///< with a lower electrode that is not grounded
    const PerField<Kept> kept;
    SectorFactors factors;
    PerField<Field> fields;
  };
} // namespace ringmotor
