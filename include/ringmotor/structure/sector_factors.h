// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/algebra/sparse_ldlt.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_stiffness.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace ringmotor
{
  /** The sum of coefficient * value over some degrees of freedom, in the axes of their nodes. */
  using LinearForm = std::vector<std::pair<SectorNodes::Dof, double>>;

  /**
   * A load that acts against a rigid or near-rigid motion, which nothing or almost nothing else
   * constrains. Its mean displacement, the sum over @p load, is constrained to zero, and the load
   * becomes the reaction. Finally the reaction must equal the load that the body actually carries,
   * and that displacement becomes an unknown again, see SupportMotion.
   */
  struct CondensationSupport
  {
    unsigned int part; ///< 0: a load on the real field, 1: on the imaginary one
    LinearForm load;   ///< N, for the meshed part of the sector
  };

  /**
   * The factorised K - shift M of a sector, down to some unknowns that are kept: at least those on
   * its cuts, where nodal diameters differ. The two real fields only differ on the mirror plane: if
   * that is small, they share one sparse factorisation that keeps its degrees of freedom, and small
   * dense matrices do the rest for each field. A thin sector has a factorisation for each field.
   *
   * Unknowns are numbered as in CyclicSector::RealField, followed by the loads of the supports of
   * that field.
   */
  class SectorFactors
  {
  public:
    /** Something for the real field and for the imaginary one. */
    template <typename Type>
    using PerField = std::array<Type, 2>;

    /** @param kept unknowns to be kept, all of the cut and of the supports among them
     *
     * @p sector must outlive this object. */
    SectorFactors(const CyclicSector &sector, const PerField<std::vector<unsigned int>> &kept,
                  const std::vector<CondensationSupport> &supports = {});

    /** Factorises for a shift (rad^2/s^2). @throws ComputationError if a field without what is kept
     * is singular */
    void factorise(const double shift);

    /** Number of negative eigenvalues of the unknowns that are not kept, of both fields. */
    unsigned int n_negative() const;

    /** What remains of a field: the matrix of its kept unknowns, in their order, by columns; both
     * triangles. */
    const std::vector<double> &matrix(const unsigned int part) const { return fields[part].matrix; }

    /** First half of a solution: the loads on the kept unknowns that are left when the others are
     * eliminated from @p loads, one or several vectors one after the other, as many for each
     * field. */
    PerField<std::vector<double>> condense(const PerField<std::vector<double>> &loads);

    /** Second half, to follow condense(): all unknowns from the kept ones. */
    PerField<std::vector<double>> expand(const PerField<std::vector<double>> &kept_solutions);

  private:
    /** A sparse factorisation of one field or of both. */
    struct Sparse
    {
      std::vector<unsigned int> parts;
      std::vector<unsigned int> row_of_dof; ///< none if inside a cell or fixed
      std::vector<unsigned int> kept;       ///< rows
      unsigned int n_rows = 0;
      std::unique_ptr<SparseLDLT> factors;
    };

    /** What is kept by the sparse factorisation, as a field sees it. */
    struct Field
    {
      std::vector<unsigned int> dof; ///< by number, without those of supports
      std::vector<unsigned int> row; ///< of the sparse matrix, by number; none if inside a cell
      /** Places of what is kept, and of what else this field has on the mirror plane, among the
       * rows that the sparse factorisation keeps. */
      std::vector<unsigned int> kept, plane;
      std::vector<double> matrix;
      DenseLDLT plane_factors;
      std::vector<double> plane_response; ///< to the kept ones, minus; by columns
      std::vector<double> plane_loads;    ///< of the last condense()
      std::size_t width() const { return row.size(); }
    };

    /** Whether a degree of freedom belongs to one field only. */
    bool is_on_mirror(const unsigned int dof) const;
    void number_rows(Sparse &sparse);
    void choose_kept_rows(Sparse &sparse, const PerField<std::vector<unsigned int>> &kept);
    SymmetricElements elements(const Sparse &sparse) const;
    void add_supports(const Sparse &sparse, SymmetricElements &elements) const;
    /** Eliminates the mirror plane of a field. */
    void reduce(const Sparse &sparse, Field &field);
    std::vector<double> loads_on_rows(const Sparse &sparse,
                                      const PerField<std::vector<double>> &loads) const;

    const CyclicSector &sector;
    const std::vector<CondensationSupport> supports;
    SectorStiffness stiffness;
    std::vector<Sparse> sparse; ///< for both fields, or one for each
    PerField<Field> fields;
    std::vector<double> loads_on_dofs; ///< of the last condense(); one field after the other
  };
} // namespace ringmotor
