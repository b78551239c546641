// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/condensation/condensation.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace ringmotor
{
  /**
   * Interface displacements of a condensed sector under interface forces, with driven degrees of
   * freedom at rest, m/N on the meshed part of the sector. With the cut fixed, the two real fields
   * depend neither on each other nor on the nodal diameter; the neighbouring sectors act through
   * the cut, by few shapes:
   *
   *   C_k = diag(A_0, A_1) + diag(E_0, E_1) B_k diag(E_0, E_1)^T
   *
   * for the real field (0) and the imaginary one (1). The shapes are orthonormal and span the
   * motions that come through the cut, up to rounding.
   */
  class InterfaceCompliance
  {
  public:
    /**
     * @p condensation must outlive this object.
     * @throws ComputationError if the body is singular with its cut fixed
     */
    explicit InterfaceCompliance(const Condensation &condensation);

    /** A of one real field: one row and column for each interface displacement, symmetric. */
    const dealii::FullMatrix<double> &at_rest(const unsigned int part) const
    {
      return fields[part].at_rest;
    }
    /** E of one real field: one column for each shape. */
    const dealii::FullMatrix<double> &shapes(const unsigned int part) const
    {
      return fields[part].shapes;
    }
    /** What moves the unknowns of a cut that is tied for one nodal diameter, and how they move: a
     * row for each shape, the shapes of the real field first. */
    struct CutSolutions
    {
      dealii::FullMatrix<double> loads, motions;
      /** B_k, symmetric. */
      dealii::FullMatrix<double> response() const;
    };
    /** Supports in @p held are constrained, as they must be where a rigid motion is free; their
     * multipliers are unknowns too. */
    CutSolutions solve_cut(const unsigned int k, const std::vector<unsigned int> &held) const;

    /** B_k. CutResponses has those of all nodal diameters at less cost. */
    dealii::FullMatrix<double> through_cut(const unsigned int k,
                                           const std::vector<unsigned int> &held) const
    {
      return solve_cut(k, held).response();
    }

    /** C_k as one matrix, all entries of the real field first. */
    dealii::FullMatrix<double> compliance(const unsigned int k,
                                          const std::vector<unsigned int> &held) const;

  private:
    friend class CutResponses;

    /** One real field. The rows of its cut are followed by those of its supports. */
    struct Field
    {
      dealii::FullMatrix<double> at_rest, shapes;
      dealii::FullMatrix<double> cut;   ///< stiffness of the cut with a free interface
      dealii::FullMatrix<double> loads; ///< on the cut, by the forces of shapes; by rows
    };

    /** Which rows of a condensed field belong to its cut and supports, and which do not; driven
     * rows are in neither list. */
    struct Rows
    {
      std::vector<unsigned int> cut, inner;
      /** Interface displacements, by places of inner rows. */
      std::vector<std::vector<std::pair<unsigned int, double>>> forms;
      dealii::FullMatrix<double> by_cut; ///< the same by rows of the cut
    };

    /** The places of unknowns in the system of the cut: the same for all nodal diameters, those of
     * supports last. */
    std::map<unsigned int, unsigned int> places() const;

    const CyclicSector &sector() const;

    static Rows rows_of(const Condensation &condensation, const unsigned int part);
    static Field split(const Condensation &condensation, const unsigned int part);
    /** Shapes and loads of a field from the motion of its interface with its cut. */
    static void find_shapes(dealii::FullMatrix<double> by_cut, Field &field);

    const Condensation &condensation;
    std::array<Field, 2> fields;
  };
} // namespace ringmotor
