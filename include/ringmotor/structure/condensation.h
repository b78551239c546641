// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/cyclic_sector.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** The sum of coefficient * value over some degrees of freedom, in the axes of their nodes. */
  using LinearForm = std::vector<std::pair<SectorNodes::Dof, double>>;

  /**
   * A load that stands against a motion which nothing, or hardly anything, else holds. Its mean
   * displacement, the sum over @p load, is kept at zero, so that the load becomes the reaction; in
   * the end the reaction is the load that the body really carries, and that displacement comes back
   * as an unknown, see SupportMotion.
   */
  struct CondensationSupport
  {
    unsigned int part; ///< 0: a load on the real field, 1: on the imaginary one
    LinearForm load;   ///< N, for the meshed part of the sector
  };

  /** What a body does when the displacement of a support is 1, that of the others 0. */
  struct SupportMotion
  {
    std::vector<double> interface; ///< displacements of the interface, real field, then imaginary
    double stiffness;              ///< load of the support that it takes; 0 for a rigid motion
  };

  /** What acts on a body; empty: nothing. */
  struct CondensationLoad
  {
    std::vector<double> forces; ///< N, on the interface, real field, then imaginary
    std::vector<double> driven; ///< m, of the driven degrees of freedom, real field, then imaginary
    std::vector<double> supports; ///< m, of each support that is held
  };

  class SparseLDLT;

  /**
   * Static condensation of a cyclic sector: an elastic body (vibrating at one frequency) as seen
   * from its interface, see InterfaceCompliance. The two real fields of the sector are condensed to
   * their interface and their cut once; each nodal diameter then only ties the cut and eliminates
   * it.
   *
   * Exact linear algebra: what comes out is what a solution with all unknowns gives.
   */
  class Condensation
  {
  public:
    /**
     * @param interface displacements at which forces act; with a force goes the load that does work
     * on the displacement. Their degrees of freedom must be independent.
     * @param driven degrees of freedom with a given motion, none of them on a cut
     * @param shift omega^2 in rad^2/s^2; 0: static
     * @param with_interior keeps what interior() needs: the factors of both fields
     * @throws ComputationError if a body without its interface is singular
     */
    Condensation(const CyclicSector &sector, const std::vector<LinearForm> &interface,
                 const std::vector<SectorNodes::Dof> &driven,
                 const std::vector<CondensationSupport> &supports, const double shift,
                 const bool with_interior = false);
    ~Condensation();

    /** The motion of one of the supports @p held. */
    SupportMotion support_motion(const unsigned int k, const std::vector<unsigned int> &held,
                                 const unsigned int support) const;

    /**
     * Interface displacements, real field, then imaginary one, without interface forces when the
     * driven degrees of freedom move by @p motion (in the same order; axes of the nodes).
     */
    std::vector<double> prescribed_response(const unsigned int k,
                                            const std::vector<double> &motion) const;

    /** The motion of the whole body, inside too, under each of these loads; only if the factors
     * have been kept. */
    std::vector<SectorMotion> interior(const unsigned int k, const std::vector<unsigned int> &held,
                                       const std::vector<CondensationLoad> &loads) const;

  private:
    friend class InterfaceCompliance;

    /** One real field, condensed to its cut, its interface and its supports. */
    struct Field
    {
      std::vector<unsigned int> kept;       ///< numbers in the field, those of the cut first
      std::vector<unsigned int> row_of_dof; ///< in the matrix, of kept degrees of freedom
      std::vector<unsigned int> unknown;    ///< by row, of those not on the cut
      std::vector<double> matrix;           ///< by columns
      std::unique_ptr<SparseLDLT> factors;  ///< if they are kept
    };
    struct Reduced;

    void condense(const unsigned int part, const double shift, const bool with_interior);
    /** Which unknowns stay when the cut is eliminated, and how kept rows depend on unknowns. */
    Reduced layout(const unsigned int k, const std::vector<unsigned int> &held) const;
    /** The fields tied to each other at the cut: by columns, cut first. */
    std::vector<double> tied(const Reduced &reduced) const;
    /** The condensed body with the condition on its cut, the rest of the cut eliminated. */
    Reduced reduce(const unsigned int k, const std::vector<unsigned int> &held) const;
    /** The interface displacements that belong to the unknowns which stay. */
    std::vector<double> interface_motion(const Reduced &reduced,
                                         const std::vector<double> &unknowns) const;
    /** Where the driven degrees of freedom are in it. */
    std::vector<unsigned int> driven_places(const Reduced &reduced) const;
    /** The unknowns that stay, under each load one after the other. */
    std::vector<double> solutions(const Reduced &reduced, const std::vector<unsigned int> &held,
                                  const std::vector<CondensationLoad> &loads) const;
    /** All unknowns of a field under each load, from those that stay. */
    std::vector<double> field_solutions(const Reduced &reduced, const unsigned int part,
                                        const std::vector<double> &unknowns) const;

    const CyclicSector &sector;
    const std::vector<LinearForm> interface;
    const std::vector<SectorNodes::Dof> driven;
    const std::vector<CondensationSupport> supports;
    std::vector<bool> at_interface; ///< by degree of freedom: on the interface or driven
    std::array<Field, 2> fields;
  };
} // namespace ringmotor
