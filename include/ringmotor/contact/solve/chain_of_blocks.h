// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/contact/solve/contact_rows.h>

#include <vector>

namespace ringmotor
{
  /**
   * A preconditioner: the inverse of contact rows in which blocks are coupled through their far
   * shapes only (see ContactProblem). The slips of a block are measured from the motions of the
   * previous block, which are mainly caused by the forces of that block; so blocks form chains.
   * With a the far motions of the blocks, z the values handed on where a chain is cut, and q the
   * rigid motions, the forces along a chain are
   *
   *   f_b = D_b^-1 (r_b + E_b f_before + S_b (a, z, q)),
   *
   * a and z are linear functions of them, as are the balances, which yields a small dense system.
   * Where slips are measured from given positions, each chain is a single block.
   */
  class ChainOfBlocks
  {
  public:
    /** What an object for some rows takes, estimated before it is made. */
    struct Cost
    {
      bool has_chains;      ///< whether slips in a block are measured from another one
      unsigned int n_small; ///< unknowns of the small system
      double n_operations;  ///< of all factors
    };
    static Cost cost_of(const ContactRows &rows);

    /** Computes all factors. */
    explicit ChainOfBlocks(const ContactRows &rows);

    /** Whether it serves these rows as well, if they are similar: the same unknowns. */
    bool fit(const ContactRows &rows) const;

    /** Whether no block and no small system is singular. */
    bool is_regular() const { return regular; }
    /** Where GMRES starts: at zero. */
    dealii::Vector<double> start(const dealii::Vector<double> &right_hand_side) const;
    /** Entries of both vectors as in ContactRows. */
    void vmult(dealii::Vector<double> &result, const dealii::Vector<double> &vector) const;

  private:
    static constexpr unsigned int none = BlockStructure::no_part;

    /** Unknowns of the touching nodes of a block. */
    struct Block
    {
      unsigned int number;       ///< in the problem
      unsigned int before;       ///< in the problem, or none
      unsigned int place_before; ///< of the block before among those that touch, or none
      std::vector<unsigned int> unknowns;
      std::vector<unsigned int> slips;         ///< rows that depend on slips
      dealii::LAPACKFullMatrix<double> shapes; ///< far shapes, a row for each unknown
      /** Derivatives of the rows by far motions; the part of them due to slips. */
      dealii::LAPACKFullMatrix<double> by_motion, by_slip;
      dealii::LAPACKFullMatrix<double> own;       ///< factors of D_b
      dealii::LAPACKFullMatrix<double> by_before; ///< E_b, only the rows of slips
      bool is_cut            = false;             ///< the chain begins here
      unsigned int first_cut = 0;                 ///< the first z
      std::vector<unsigned int> shared;           ///< columns of the small system
      dealii::LAPACKFullMatrix<double> by_shared; ///< S_b, only these columns

      bool continues_chain() const { return place_before != none && !is_cut && !slips.empty(); }
    };

    void find_blocks(const ContactRows &rows);
    void choose_shapes(const ContactRows &rows);
    void make_kernel(const BlockStructure &structure);
    void cut_chains(const ContactRows &rows);
    /** Derivatives of the rows of a block by the forces of another one, without the coupling
     * through far shapes. */
    dealii::LAPACKFullMatrix<double> near_matrix(const ContactRows &rows, const Block &block,
                                                 const Block &loaded) const;
    void share_columns(const ContactRows &rows, Block &block) const;
    void make_small_system(const ContactRows &rows);
    /** Adds what the forces of the blocks of one chain, in its order, contribute to it. */
    void add_chain(const std::vector<unsigned int> &chain);
    /** f_b by columns of the small system, each at its place; those handed on from the previous
     * block, if the chain continues, come first. */
    dealii::LAPACKFullMatrix<double>
    forces_by_shared(const Block &block, const dealii::LAPACKFullMatrix<double> &before,
                     const std::vector<unsigned int> &place_of, const unsigned int n_columns) const;
    /** Subtracts what forces of a block, by columns, hand on where chains are cut, and adds their
     * contribution to the balances. */
    void add_handed_on(const unsigned int place, const dealii::LAPACKFullMatrix<double> &forces,
                       const std::vector<unsigned int> &columns,
                       dealii::LAPACKFullMatrix<double> &matrix) const;
    /** f_b of all blocks from right-hand sides and, if given, (a, z, q). */
    std::vector<dealii::Vector<double>> forces(const dealii::Vector<double> &vector,
                                               const dealii::Vector<double> *shared) const;
    dealii::Vector<double> solve_small_system(const std::vector<dealii::Vector<double>> &forces,
                                              const dealii::Vector<double> &vector) const;

    const RowUnknowns made_for;
    const unsigned int n_rigid;
    dealii::FullMatrix<double> balances; ///< of rigid motions, by all forces of touching points
    std::vector<Block> blocks;
    std::vector<unsigned int> order; ///< along the chains
    std::vector<unsigned int> cuts;  ///< first blocks of the chains
    std::vector<unsigned int> felt;  ///< blocks of the problem whose far motions matter
    unsigned int n_shapes = 0, n_far = 0, n_cuts = 0, n_small = 0;
    dealii::LAPACKFullMatrix<double> kernel; ///< far motions by far forces
    dealii::LAPACKFullMatrix<double> small;
    bool regular = false;
  };
} // namespace ringmotor
