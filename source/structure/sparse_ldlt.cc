// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/sparse_ldlt.h>

#include <dmumps_c.h>

#include <new>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  struct SparseLDLT::Mumps
  {
    DMUMPS_STRUC_C data{};

    /** Control parameter @p i as numbered in the MUMPS manual. */
    int &control(const int i) { return data.icntl[i - 1]; }
    int information(const int i) const { return data.infog[i - 1]; }
  };

  SparseLDLT::SparseLDLT(const unsigned int size, MPI_Comm communicator,
                         const std::vector<unsigned int> &kept)
      : mumps(std::make_unique<Mumps>()), communicator(communicator)
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
    mumps->control(8)  = 1; // scaling by the diagonal: enough for one kind of unknown, and cheap
    mumps->control(13) = 1; // no parallel root: there MUMPS does not count negative pivots
    // Every rank provides its own entries; a single rank avoids redistributing them.
    mumps->control(18) = Utilities::MPI::n_mpi_processes(communicator) > 1 ? 3 : 0;
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

  void SparseLDLT::factorise(SymmetricTriplets &triplets)
  {
    // MUMPS reads one set or the other, depending on ICNTL(18).
    mumps->data.nnz = mumps->data.nnz_loc = static_cast<MUMPS_INT8>(triplets.rows.size());
    mumps->data.irn = mumps->data.irn_loc = triplets.rows.data();
    mumps->data.jcn = mumps->data.jcn_loc = triplets.columns.data();
    mumps->data.a = mumps->data.a_loc = triplets.values.data();
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
    run(3, "solution");
    broadcast(sides);
  }

  std::vector<double> SparseLDLT::condense(const std::vector<double> &all_right_hand_sides)
  {
    right_hand_sides    = all_right_hand_sides;
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
