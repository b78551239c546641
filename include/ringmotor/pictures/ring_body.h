// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/pictures/place_key.h>
#include <ringmotor/structure/sector_elements.h>

#include <array>
#include <complex>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * A body over the whole ring as hexahedra with straight edges and the points that they share:
   * what is needed to plot its motion. Shells have their thickness, as in sample_sector(). Requires
   * a half sector.
   */
  class RingBody
  {
  public:
    using Displacement = std::vector<dealii::Tensor<1, 3>>;                ///< m, by point
    using Amplitude    = std::vector<std::array<std::complex<double>, 3>>; ///< m, of a sector

    /** Displacement at a point: values of degrees of freedom times these vectors. */
    struct Sample
    {
      bool of_shell;
      std::vector<std::pair<SectorElements::Dof, dealii::Tensor<1, 3>>> terms;
    };
    using Samples = std::vector<Sample>; ///< of the points of a half sector

    /** @param n_subdivisions of a cell per direction
     *  @param height (m) and @param turn (rad) by which the sectors are moved into place */
    RingBody(const SectorElements &sector, const unsigned int n_subdivisions,
             const double height = 0., const double turn = 0.);

    const std::vector<dealii::Point<3>> &points() const { return ring_points; }
    /** Points of each cell, the first direction fastest. */
    const std::vector<std::array<unsigned int, 8>> &cells() const { return ring_cells; }
    /** The point at a position, if there is one. */
    std::optional<unsigned int> point_at(const dealii::Point<3> &place) const;

    Displacement at_rest() const { return Displacement(ring_points.size()); }

    /** The motion @p one + i @p two of sector 0. Both parts have the symmetry
     * U(-theta) = S conj(U(theta)), which their sum does not have. */
    Amplitude amplitude(const SectorMotion &one, const SectorMotion &two) const
    {
      return amplitude(one, two, samples);
    }
    /** The same for motions of another mesh of this body. @param at samples_in() that mesh */
    Amplitude amplitude(const SectorMotion &one, const SectorMotion &two, const Samples &at) const;

    /** The points of this body in another mesh of the same sector, its solids and shells in the
     * same places; a shell moves points off its reference surface by its rotation. */
    Samples samples_in(const SectorElements &sector) const;

    /** The motion of sector 0 straight up by a height (m) at each angle (rad) from its middle. */
    Amplitude lift(const std::function<std::complex<double>(const double theta)> &height_at) const;

    /** Adds the real part of @p factor times a motion, rotated into place, in sector @p sector. */
    void add(const unsigned int sector, const std::complex<double> factor,
             const Amplitude &amplitude, Displacement &displacement) const;

  private:
    void sample_solids(const SectorElements &sector, const unsigned int n_subdivisions);
    void sample_shells(const SectorElements &sector, const unsigned int n_subdivisions);
    /** Takes a lattice of points of a cell and divides it into hexahedra. */
    void add_lattice(const std::vector<dealii::Point<3>> &lattice, const Samples &at_points,
                     const unsigned int n_subdivisions);
    void number_ring(const double height, const double turn);
    std::array<std::complex<double>, 3> value(const Sample &sample,
                                              const SectorMotion &motion) const;

    const unsigned int n_sectors;
    // Of the meshed half sector, theta >= 0
    std::vector<dealii::Point<3>> half_points;
    Samples samples;
    std::vector<std::array<unsigned int, 8>> half_cells;

    std::vector<dealii::Point<3>> ring_points;
    std::vector<std::array<unsigned int, 8>> ring_cells;
    std::vector<std::array<double, 2>> turns; ///< cosine and sine of each sector's angle
    /** Points of a sector, those of its half first, then their mirror images: numbers in the ring
     * or, where an earlier one has the same position, invalid_unsigned_int. */
    std::vector<unsigned int> owned;
    std::map<PlaceKey, unsigned int> known; ///< first in the half sector, later in the ring
  };
} // namespace ringmotor
