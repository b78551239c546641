// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/nested_dissection.h>
#include <ringmotor/algebra/sparse_ldlt.h>
#include <ringmotor/parameters/errors.h>

#include <dmumps_c.h>

#include <cmath>
#include <new>
#include <string>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  struct SparseLDLT::Mumps
  {
    DMUMPS_STRUC_C data{};
    /** Of the elements. MUMPS reads them in later phases, too, though not their values. */
    std::vector<int> begin, variables;
    std::vector<int> places; ///< of the variables in the order of elimination, if it is given

    /** Control parameter @p i as numbered in the MUMPS manual. */
    int &control(const int i) { return data.icntl[i - 1]; }
    int information(const int i) const { return data.infog[i - 1]; }
  };

  void SymmetricElements::add(const std::vector<unsigned int> &rows,
                              const std::vector<double> &lower)
  {
    AssertDimension(rows.size() * (rows.size() + 1) / 2, lower.size());
    for (const unsigned int row : rows)
      variables.push_back(1 + static_cast<int>(row));
    begin.push_back(1 + static_cast<int>(variables.size()));
    values.insert(values.end(), lower.begin(), lower.end());
  }

  namespace
  {
    template <typename Number>
    void append_from(std::vector<Number> &all, const std::vector<std::vector<Number>> &by_rank)
    {
      for (const std::vector<Number> &part : by_rank)
        all.insert(all.end(), part.begin(), part.end());
    }

    /** The elements of all ranks on rank 0, none on the others. */
    SymmetricElements gathered(SymmetricElements mine, MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return mine;
      SymmetricElements all;
      std::vector<int> sizes;
      for (std::size_t e = 0; e + 1 < mine.begin.size(); ++e)
        sizes.push_back(mine.begin[e + 1] - mine.begin[e]);
      append_from(all.variables, Utilities::MPI::gather(communicator, mine.variables));
      append_from(all.values, Utilities::MPI::gather(communicator, mine.values));
      for (const std::vector<int> &part : Utilities::MPI::gather(communicator, sizes))
        for (const int size : part)
          all.begin.push_back(all.begin.back() + size);
      return all;
    }
  } // namespace

  SparseLDLT::SparseLDLT(const unsigned int size, MPI_Comm communicator,
                         const std::vector<unsigned int> &kept, const EliminationOrder order)
      : mumps(std::make_unique<Mumps>()), communicator(communicator), order(order)
  {
    for (const unsigned int row : kept)
      kept_rows.push_back(1 + static_cast<int>(row));

    mumps->data.comm_fortran = MPI_Comm_c2f(communicator);
    mumps->data.par          = 1; // rank 0 works too
    mumps->data.sym          = 2; // symmetric, indefinite
    run(-1, "start");
    mumps->data.n = static_cast<int>(size);
    for (const int stream : {1, 2, 3})
      mumps->control(stream) = -1;
    mumps->control(4) = 0;
    // approximate minimum fill: a quarter of PORD's operations on these matrices
    mumps->control(7)  = 2;
    mumps->control(5)  = 1; // elements, all of them on rank 0
    mumps->control(8)  = 0; // scale() does it: MUMPS does not scale elements
    mumps->control(13) = 1; // no parallel root: there MUMPS does not count negative pivots
    if (!kept_rows.empty())
    {
      schur.resize(kept_rows.size() * kept_rows.size());
      mumps->control(19)        = 2; // lower triangle, here in one block on rank 0
      mumps->data.nprow         = 1;
      mumps->data.npcol         = 1;
      mumps->data.mblock        = static_cast<int>(kept_rows.size());
      mumps->data.nblock        = static_cast<int>(kept_rows.size());
      mumps->data.size_schur    = static_cast<int>(kept_rows.size());
      mumps->data.listvar_schur = kept_rows.data();
      mumps->data.schur         = schur.data();
      mumps->data.schur_lld     = static_cast<int>(kept_rows.size());
    }
  }

  SparseLDLT::~SparseLDLT()
  {
    mumps->data.job = -2;
    dmumps_c(&mumps->data);
  }

  void SparseLDLT::scale(SymmetricElements &elements)
  {
    row_scale.assign(mumps->data.n, 0.);
    const auto for_each_entry = [&](const auto &visit)
    {
      std::size_t entry = 0;
      for (std::size_t e = 0; e + 1 < elements.begin.size(); ++e)
        for (int column = elements.begin[e] - 1; column < elements.begin[e + 1] - 1; ++column)
          for (int row = column; row < elements.begin[e + 1] - 1; ++row)
            visit(elements.variables[row] - 1, elements.variables[column] - 1,
                  elements.values[entry++]);
    };
    for_each_entry(
        [&](const int row, const int column, const double value)
        {
          if (row == column)
            row_scale[row] += value;
        });
    for (double &factor : row_scale)
      factor = factor == 0. ? 1. : 1. / std::sqrt(std::abs(factor));
    for (const int row : kept_rows)
      row_scale[row - 1] = 1.;
    broadcast(row_scale); // only rank 0 has the elements
    for_each_entry([&](const int row, const int column, double &value)
                   { value *= row_scale[row] * row_scale[column]; });
  }

  void SparseLDLT::apply_scale(std::vector<double> &sides) const
  {
    const std::size_t size = row_scale.size();
    for (std::size_t i = 0; i < sides.size(); ++i)
      sides[i] *= row_scale[i % size];
  }

  void SparseLDLT::factorise(SymmetricElements elements)
  {
    elements = gathered(std::move(elements), communicator);
    scale(elements);
    if (!analysed && order == EliminationOrder::nested_dissection)
      mumps->control(7) = 1; // on all ranks; the order is that of rank 0
    if (Utilities::MPI::this_mpi_process(communicator) == 0) // MUMPS tells the other ranks
    {
      if (!analysed && order == EliminationOrder::nested_dissection)
      {
        mumps->places       = nested_dissection(elements, mumps->data.n);
        mumps->data.perm_in = mumps->places.data();
      }
      mumps->begin       = std::move(elements.begin);
      mumps->variables   = std::move(elements.variables);
      mumps->data.nelt   = static_cast<int>(mumps->begin.size()) - 1;
      mumps->data.eltptr = mumps->begin.data();
      mumps->data.eltvar = mumps->variables.data();
      mumps->data.a_elt  = elements.values.data();
    }
    if (!analysed)
      run(1, "analysis");
    analysed = true;

    // Delayed pivots may need more memory than the analysis predicted: MUMPS then requests more.
    const int not_enough_room = -9;
    for (mumps->control(14) = 30; mumps->control(14) < 1000; mumps->control(14) *= 3)
    {
      mumps->data.job = 2;
      dmumps_c(&mumps->data);
      if (mumps->information(1) != not_enough_room)
        break;
    }
    if (mumps->information(1) < 0)
      run(2, "factorisation");
    broadcast(schur);
  }

  unsigned int SparseLDLT::n_negative() const
  {
    return static_cast<unsigned int>(mumps->information(12));
  }

  void SparseLDLT::solve(std::vector<double> &sides)
  {
    mumps->data.nrhs = static_cast<int>(sides.size() / mumps->data.n);
    mumps->data.lrhs = mumps->data.n;
    mumps->data.rhs  = sides.data();
    apply_scale(sides);
    run(3, "solution");
    apply_scale(sides);
    broadcast(sides);
  }

  std::vector<double> SparseLDLT::condense(const std::vector<double> &all_right_hand_sides)
  {
    right_hand_sides = all_right_hand_sides;
    apply_scale(right_hand_sides);
    mumps->data.nrhs    = static_cast<int>(right_hand_sides.size() / mumps->data.n);
    mumps->data.lrhs    = mumps->data.n;
    mumps->data.rhs     = right_hand_sides.data();
    mumps->data.lredrhs = static_cast<int>(kept_rows.size());
    std::vector<double> reduced(mumps->data.nrhs * kept_rows.size());
    mumps->data.redrhs = reduced.data();
    mumps->control(26) = 1;
    run(3, "condensation");
    broadcast(reduced);
    return reduced;
  }

  std::vector<double> SparseLDLT::expand(std::vector<double> kept_solutions)
  {
    mumps->data.redrhs = kept_solutions.data();
    mumps->control(26) = 2;
    run(3, "expansion");
    apply_scale(right_hand_sides);
    broadcast(right_hand_sides);
    return right_hand_sides;
  }

  void SparseLDLT::broadcast(std::vector<double> &numbers) const
  {
    MPI_Bcast(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, 0, communicator);
  }

  void SparseLDLT::run(const int job, const char *what)
  {
    mumps->data.job = job;
    dmumps_c(&mumps->data);
    const int code = mumps->information(1);
    if (code == -5 || code == -7 || code == -13) // MUMPS failed to allocate memory
      throw std::bad_alloc();
    if (code < 0)
      throw ComputationError("the sparse direct solver (MUMPS) failed in its " + std::string(what) +
                             " of " + std::to_string(mumps->data.n) + " unknowns, code " +
                             std::to_string(code) + " (" + std::to_string(mumps->information(2)) +
                             ")");
  }
} // namespace ringmotor
