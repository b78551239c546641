// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/mortar.h>

#include <boost/serialization/vector.hpp>

#include <complex>
#include <functional>
#include <vector>

namespace ringmotor
{
  /** A complex square matrix by rows. */
  struct ComplexMatrix
  {
    explicit ComplexMatrix(const unsigned int size = 0)
        : size(size), entries(static_cast<std::size_t>(size) * size)
    {
    }
    std::complex<double> &operator()(const unsigned int i, const unsigned int j)
    {
      return entries[static_cast<std::size_t>(i) * size + j];
    }
    const std::complex<double> &operator()(const unsigned int i, const unsigned int j) const
    {
      return entries[static_cast<std::size_t>(i) * size + j];
    }
    unsigned int size;
    std::vector<std::complex<double>> entries;
  };

  /**
   * The compliance of a body at the nodes of its surface over a whole sector (m/N, Hermitian, three
   * components for each node) from that of the meshed part, see Condensation::compliance(). For a
   * wave with nodal diameter k, motions and forces of sector j are exp(-i k j alpha) times those of
   * sector 0, in cylindrical components.
   */
  ComplexMatrix sector_compliance(const dealii::FullMatrix<double> &condensed,
                                  const std::vector<MirroredNode> &origin, const SectorForm form);

  /** The motion of a half sector's surface (real field, then imaginary one) over the whole sector.
   */
  std::vector<std::array<std::complex<double>, 3>>
  sector_motion(const std::vector<double> &half, const std::vector<MirroredNode> &origin);

  /** The compliance at the nodes of a coupling of a rotor with this compliance of its own nodes. */
  ComplexMatrix coupled_compliance(const ComplexMatrix &rotor, const MortarCoupling &coupling,
                                   const unsigned int k, const double pitch);

  /**
   * How all contact points of a ring of equal sectors move under forces on them: a matrix that only
   * depends on the distance of two sectors.
   */
  class RingCompliance
  {
  public:
    /** No sectors: to be assigned to. */
    RingCompliance() = default;

    /**
     * @param of_wave the compliance for a nodal diameter 0 .. @p n_sectors / 2
     */
    RingCompliance(const unsigned int n_sectors, const unsigned int n_nodes,
                   const std::function<ComplexMatrix(unsigned int)> &of_wave);

    /** Adds a compliance within each sector, by rows, three components for each node. */
    void add_within_sectors(const dealii::FullMatrix<double> &compliance);

    unsigned int n_sectors() const { return sector_count; }
    unsigned int n_nodes() const { return node_count; }

    /** How all 3 n_nodes() motions (m) of a sector change by a unit force (N) in @p direction on @p
     * node of a sector that lies @p distance sectors lower in theta, 0 .. n_sectors() - 1. */
    const double *motion_by(const unsigned int distance, const unsigned int node,
                            const unsigned int direction) const
    {
      const std::size_t width = 3 * node_count;
      return entries.data() + (distance * width + 3 * node + direction) * width;
    }

    /** The same ring seen as one of n_sectors / @p fold sectors, for forces and motions that repeat
     * themselves. */
    RingCompliance folded(const unsigned int fold) const;

    template <class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &sector_count &node_count &entries;
    }

  private:
    unsigned int sector_count = 0, node_count = 0;
    std::vector<double> entries; ///< by distance, then by columns
  };
} // namespace ringmotor
