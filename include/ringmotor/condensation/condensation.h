// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_factors.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** Response of a body to a unit displacement of one support, the others being fixed. */
  struct SupportMotion
  {
    std::vector<double> interface; ///< displacements of the interface, real field, then imaginary
    double stiffness;              ///< load of the support that causes it; 0 for a rigid motion
  };

  /** Loads and prescribed motions of a body; empty: none. */
  struct CondensationLoad
  {
    std::vector<double> forces; ///< N, on the interface, real field, then imaginary
    std::vector<double> driven; ///< m, of the driven degrees of freedom, real field, then imaginary
    std::vector<double> supports; ///< m, of each constrained support
  };

  /**
   * Static condensation of a cyclic sector: an elastic body (vibrating at one frequency) as seen
   * from its interface, see InterfaceCompliance. The two real fields of the sector are condensed to
   * their interface and their cut once; each nodal diameter then only ties the cut.
   *
   * The condensation is exact: the results are those of a solution with all unknowns.
   */
  class Condensation
  {
  public:
    /**
     * @param interface displacements on which forces act; each force is work-conjugate to its
     * displacement. Their degrees of freedom must be independent.
     * @param driven degrees of freedom with a given motion, none of them on a cut
     * @param shift omega^2 in rad^2/s^2; 0: static
     * @param with_interior keeps what interior() needs: the factors
     * @throws ComputationError if a body without its interface is singular
     */
    Condensation(const CyclicSector &sector, const std::vector<LinearForm> &interface,
                 const std::vector<SectorNodes::Dof> &driven,
                 const std::vector<CondensationSupport> &supports, const double shift,
                 const bool with_interior = false);
    ~Condensation();

    /** The motion due to @p support, one of the constrained supports @p held. */
    SupportMotion support_motion(const unsigned int k, const std::vector<unsigned int> &held,
                                 const unsigned int support) const;

    /**
     * Interface displacements, real field, then imaginary one, without interface forces, when the
     * driven degrees of freedom move by @p motion (in the same order; axes of the nodes).
     */
    std::vector<double> prescribed_response(const unsigned int k,
                                            const std::vector<double> &motion) const;

    /** The motion of the whole body, including its interior, under each of these loads; requires
     * that the factors were kept. */
    std::vector<SectorMotion> interior(const unsigned int k, const std::vector<unsigned int> &held,
                                       const std::vector<CondensationLoad> &loads) const;

  private:
    friend class InterfaceCompliance;

    /** One real field, condensed to its cut, its interface and its supports. */
    struct Field
    {
      std::vector<unsigned int> kept;       ///< numbers in the field, those of the cut first
      std::vector<unsigned int> row_of_dof; ///< in the matrix, of retained degrees of freedom
      std::vector<unsigned int> unknown;    ///< by row, of those not on the cut
      std::vector<double> matrix;           ///< by columns
    };
    struct Tied;

    /** Which rows the matrix of a field has. */
    void choose_kept(const unsigned int part);
    /** The unknowns with the condition on the cut for a nodal diameter. */
    Tied tie(const unsigned int k, const std::vector<unsigned int> &held) const;
    /** The stiffness of the fields tied to each other: symmetric, by columns. */
    std::vector<double> matrix(const Tied &tied) const;
    /** The interface displacements for given unknowns. */
    std::vector<double> interface_motion(const Tied &tied,
                                         const std::vector<double> &unknowns) const;
    /** The unknowns under each load, one after the other. */
    std::vector<double> solutions(const Tied &tied, const std::vector<unsigned int> &held,
                                  const std::vector<CondensationLoad> &loads) const;
    /** All entries of each field under each load, from the unknowns. */
    SectorFactors::PerField<std::vector<double>>
    field_solutions(const Tied &tied, const std::vector<double> &unknowns) const;

    const CyclicSector &sector;
    const std::vector<LinearForm> interface;
    const std::vector<SectorNodes::Dof> driven;
    const std::vector<CondensationSupport> supports;
    std::vector<bool> at_interface; ///< by degree of freedom: on the interface or driven
    std::array<Field, 2> fields;
    std::unique_ptr<SectorFactors> factors; ///< if they are kept
  };
} // namespace ringmotor
