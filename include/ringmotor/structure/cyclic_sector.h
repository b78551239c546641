// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  class SectorMass;

  /**
   * The finite-element model of one sector of a cyclic body, of solids, shells, bars and
   * foundations in one numbering. Its matrices have no condition on the cuts; a nodal diameter k
   * only changes how the unknowns of the two real fields (real and imaginary part of U) are tied to
   * each other:
   *
   * - half sector: the mirror plane theta = 0 fixes u_theta of the real and u_r, u_z of the
   * imaginary part, and of a shell's rotations the other components; on the cut theta = alpha/2,
   * with c = cos(k alpha/2) and s = sin(k alpha/2), the pair (real, imaginary) is (c, -s) a for the
   * r and z components and (s, c) a for the theta component: one unknown a instead of two, from
   * U(-theta) = S conj(U(theta)) and the cyclic condition;
   * - whole sector: u(high cut) = exp(-i k alpha) u(low cut) in cylindrical components;
   * - whole ring: its motion is real, there is no imaginary field, and k does not matter.
   *
   * Unknowns of nodes on the cuts are cylindrical components at the node, all others Cartesian. A
   * sector without cuts is the same for all k.
   */
  class CyclicSector : public SectorElements
  {
  public:
    /**
     * Numbers and assembles @p mesh with FE_Q(@p degree) for each component of displacement and
     * rotation. The mesh must outlive this object.
     * @throws UserError if the cuts do not match or the mirror and cut faces are not where they
     * belong.
     */
    CyclicSector(const SectorMesh &mesh, const MaterialTable &materials, const unsigned int degree,
                 const LowerElectrode lower_electrode = LowerElectrode::grounded);
    ~CyclicSector();

    /** Number of unknowns of one nodal diameter (real numbers; twice the complex unknowns on a
     * whole sector). */
    unsigned int n_unknowns() const { return unknown_count; }

    /** Those of them that are potentials. Their part of K - shift M is negative definite, whatever
     * the shift. */
    unsigned int n_potential_unknowns() const { return potential_unknown_count; }

    /** True if the unknowns are the real parts, then the imaginary parts, of n_unknowns()/2 complex
     * numbers. */
    bool is_complex() const { return sector_mesh().form == SectorForm::whole; }

    /** Two, the real field and the imaginary one, or one, if it is a whole ring. */
    unsigned int n_fields() const { return sector_mesh().form == SectorForm::ring ? 1 : 2; }

    /** The degrees of freedom of one real field that are free before the condition on the cuts ties
     * some of them, across the cut and to the other field. */
    struct RealField
    {
      std::vector<unsigned int> number; ///< by degree of freedom, invalid_unsigned_int if not free
      std::vector<unsigned int> cut;    ///< numbers of those that are tied
      std::vector<std::pair<unsigned int, unsigned int>>
          inner; ///< number and unknown of the others
      unsigned int size = 0;
    };

    /** A free degree of freedom on the cut is the sum of factor * unknown over its ties. */
    struct Tie
    {
      unsigned int position; ///< in RealField::cut
      unsigned int unknown;
      double factor;
    };

    /** The real field (0) and the imaginary one (1). On a whole sector both are the same. */
    const RealField &field(const unsigned int part) const { return fields[part]; }

    /** The functions of k of which each factor is one, or minus one: 1, c and s. */
    using WaveFunctions = std::array<double, 3>;
    WaveFunctions wave_functions(const unsigned int k) const;

    /** The ties of a field's cut for nodal diameter @p k. */
    std::vector<Tie> ties(const unsigned int part, const unsigned int k) const
    {
      return ties(part, wave_functions(k));
    }
    /** Those for given values of the functions. */
    std::vector<Tie> ties(const unsigned int part, const WaveFunctions &values) const;

    /** The product of the mass matrix of nodal diameter @p k and vectors of unknowns, one or
     * several one after the other (all ranks get it). */
    void multiply_mass(const unsigned int k, const std::vector<double> &unknowns,
                       std::vector<double> &product) const;

    /** Both fields, in the axes of the nodes, given by the unknowns of nodal diameter @p k;
     * dependent degrees of freedom are zero. */
    std::array<dealii::Vector<double>, 2> fields_of(const unsigned int k,
                                                    const std::vector<double> &unknowns) const;

    /** The motion given by the unknowns of nodal diameter @p k. */
    SectorMotion expand(const unsigned int k, const std::vector<double> &unknowns) const;

    /** The transpose of expand(): the loads on the unknowns from forces on all degrees of freedom
     * (N, and N m on rotations), Cartesian, complete on every rank. */
    std::vector<double> loads_of(const unsigned int k, const SectorMotion &forces) const;
    /** Those from forces on the degrees of freedom of each field in the axes of the nodes. */
    std::vector<double> loads_of(const unsigned int k,
                                 const std::array<dealii::Vector<double>, 2> &forces) const
    {
      return to_unknowns(k, forces);
    }

    /** The unknowns of nodal diameter @p k that interpolate a @p motion given as a function of
     * position. */
    std::vector<double>
    unknowns_of(const unsigned int k,
                const std::function<NodeMotion(const dealii::Point<3> &)> &motion) const;

  private:
    /** How one real field's degree of freedom follows from an unknown: coefficient(k) * unknown. */
    struct Term
    {
      enum class Factor
      {
        one,
        cosine,
        sine,
        minus_sine
      };
      unsigned int unknown;
      Factor factor;
    };
    /** At most two terms; no term where the degree of freedom is fixed or depends on others
     * (hanging, tied). */
    struct Terms
    {
      std::array<Term, 2> term;
      unsigned int size = 0;
      void add(const unsigned int unknown, const Term::Factor factor)
      {
        term[size++] = {unknown, factor};
      }
    };

    void number_half_sector();
    void number_whole_sector();
    void number_ring();
    void number_fields();
    /** Values of the factors one, cosine, sine, minus sine. */
    static std::array<double, 4> factors(const WaveFunctions &values)
    {
      return {{values[0], values[1], values[2], -values[2]}};
    }
    /** The transpose of fields_of(). */
    std::vector<double> to_unknowns(const unsigned int k,
                                    const std::array<dealii::Vector<double>, 2> &dof_loads) const;

    std::array<std::vector<Terms>, 2>
        terms; ///< for the real and the imaginary field, by degree of freedom
    unsigned int unknown_count = 0, potential_unknown_count = 0;
    std::array<RealField, 2> fields;
    mutable std::unique_ptr<SectorMass> mass; ///< made when it is asked for: statics need none
  };
} // namespace ringmotor
