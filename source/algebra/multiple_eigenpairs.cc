// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/eigenpairs.h>
#include <ringmotor/parameters/errors.h>

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziEpetraAdapter.hpp>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Operator.h>

#include <algorithm>
#include <string>

namespace ringmotor
{
  namespace
  {
    using MultiVector  = Epetra_MultiVector;
    using Operator     = Epetra_Operator;
    using Problem      = Anasazi::BasicEigenproblem<double, MultiVector, Operator>;
    using SolverOfPair = Anasazi::BlockKrylovSchurSolMgr<double, MultiVector, Operator>;

    /** Whole vectors, one after the other, on all ranks. */
    std::vector<double> whole(const MultiVector &distributed, const MPI_Comm communicator)
    {
      const int n_local = distributed.MyLength(), n_ranks = distributed.Comm().NumProc();
      std::vector<int> sizes(n_ranks), begins(n_ranks, 0);
      MPI_Allgather(&n_local, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
      for (int rank = 1; rank < n_ranks; ++rank)
        begins[rank] = begins[rank - 1] + sizes[rank - 1];
      const std::size_t size = distributed.GlobalLength();
      std::vector<double> vectors(size * distributed.NumVectors());
      for (int i = 0; i < distributed.NumVectors(); ++i)
        MPI_Allgatherv(distributed[i], n_local, MPI_DOUBLE, vectors.data() + i * size, sizes.data(),
                       begins.data(), MPI_DOUBLE, communicator);
      return vectors;
    }

    /** The part of whole vectors that this rank owns. */
    void take_own(const std::vector<double> &vectors, MultiVector &distributed)
    {
      const std::size_t size = distributed.GlobalLength(), begin = distributed.Map().MinMyGID();
      for (int i = 0; i < distributed.NumVectors(); ++i)
        std::copy_n(vectors.begin() + i * size + begin, distributed.MyLength(), distributed[i]);
    }

    /** A function of whole vectors as an operator of Trilinos. */
    class FunctionOperator : public Operator
    {
    public:
      using Function = std::function<std::vector<double>(std::vector<double>)>;

      FunctionOperator(const Epetra_Map &map, const MPI_Comm communicator, Function function)
          : map(map), communicator(communicator), function(std::move(function))
      {
      }

      int Apply(const MultiVector &x, MultiVector &y) const override
      {
        take_own(function(whole(x, communicator)), y);
        return 0;
      }

      int SetUseTranspose(bool) override { return -1; }
      int ApplyInverse(const MultiVector &, MultiVector &) const override { return -1; }
      double NormInf() const override { return 0.; }
      const char *Label() const override { return "function"; }
      bool UseTranspose() const override { return false; }
      bool HasNormInf() const override { return false; }
      const Epetra_Comm &Comm() const override { return map.Comm(); }
      const Epetra_Map &OperatorDomainMap() const override { return map; }
      const Epetra_Map &OperatorRangeMap() const override { return map; }

    private:
      const Epetra_Map &map;
      const MPI_Comm communicator;
      const Function function;
    };
  } // namespace

  std::vector<Eigenpair> multiple_eigenpairs(const ShiftInvertedPencil &pencil,
                                             const EigenvalueChoice choice,
                                             const unsigned int count,
                                             const unsigned int multiplicity, const double residual,
                                             const MPI_Comm communicator)
  {
    Assert(!pencil.complex, dealii::ExcNotImplemented());
    if (count == 0)
      return {};
    const Epetra_MpiComm comm(communicator);
    const Epetra_Map map(static_cast<int>(pencil.size), 0, comm);
    const auto mass = [&](std::vector<double> x)
    {
      std::vector<double> product;
      pencil.mass(x, product);
      return product;
    };
    const auto shift_invert = [&](std::vector<double> x)
    {
      std::vector<double> solution = mass(std::move(x));
      pencil.solve(solution);
      return solution;
    };
    const auto start = Teuchos::rcp(new MultiVector(map, static_cast<int>(multiplicity)));
    take_own(generic_vector(static_cast<std::size_t>(pencil.size) * multiplicity), *start);
    const auto problem = Teuchos::rcp(
        new Problem(Teuchos::rcp(new FunctionOperator(map, communicator, shift_invert)), start));
    problem->setM(Teuchos::rcp(new FunctionOperator(map, communicator, mass)));
    problem->setHermitian(true);
    problem->setNEV(static_cast<int>(count));
    problem->setProblem();

    const int n_blocks = 3 + (2 * static_cast<int>(count) + 10) / static_cast<int>(multiplicity);
    Teuchos::ParameterList settings;
    settings.set("Which", choice == EigenvalueChoice::below ? "SR" : "LM");
    settings.set("Block Size", static_cast<int>(multiplicity));
    settings.set("Num Blocks", n_blocks);
    settings.set("Maximum Restarts", 50);
    settings.set("Convergence Tolerance", residual);
    settings.set("Orthogonalization", "ICGS");
    settings.set("Verbosity", static_cast<int>(Anasazi::Errors));
    SolverOfPair solver(problem, settings);
    if (solver.solve() != Anasazi::Converged)
      throw ComputationError("the eigensolver (Anasazi) did not find " + std::to_string(count) +
                             " eigenpairs of " + std::to_string(pencil.size) + " unknowns");

    const auto &solution          = problem->getSolution();
    const std::vector<double> all = whole(*solution.Evecs, communicator);
    std::vector<Eigenpair> pairs;
    for (int i = 0; i < solution.numVecs; ++i)
      pairs.push_back({pencil.shift + 1. / solution.Evals[i].realpart,
                       {all.begin() + static_cast<std::ptrdiff_t>(i) * pencil.size,
                        all.begin() + static_cast<std::ptrdiff_t>(i + 1) * pencil.size}});
    std::sort(pairs.begin(), pairs.end(),
              [](const Eigenpair &a, const Eigenpair &b) { return a.value < b.value; });
    return pairs;
  }
} // namespace ringmotor
