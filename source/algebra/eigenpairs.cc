// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/eigenpairs.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>

// Last, as it includes C's complex.h, which defines the macro I.
#include <arpack.hpp>

namespace ringmotor
{
  std::vector<double> generic_vector(const std::size_t size)
  {
    std::mt19937 random;
    std::vector<double> entries(size);
    for (double &entry : entries)
      entry = std::generate_canonical<double, 53>(random) - 0.5;
    return entries;
  }

  namespace
  {
    using Complex = std::complex<double>;

    /** Relative residual at which ARPACK accepts a pair; the error of the value is its square. */
    constexpr double tolerance = 1e-12;

    template <typename Number>
    constexpr bool is_complex = std::is_same_v<Number, Complex>;

    std::vector<double> to_real(const double *begin, const int size)
    {
      return std::vector<double>(begin, begin + size);
    }

    std::vector<double> to_real(const Complex *begin, const int size)
    {
      std::vector<double> parts(2 * size);
      for (int i = 0; i < size; ++i)
      {
        parts[i]        = begin[i].real();
        parts[size + i] = begin[i].imag();
      }
      return parts;
    }

    void from_real(const std::vector<double> &parts, double *begin)
    {
      std::copy(parts.begin(), parts.end(), begin);
    }

    void from_real(const std::vector<double> &parts, Complex *begin)
    {
      const std::size_t size = parts.size() / 2;
      for (std::size_t i = 0; i < size; ++i)
        begin[i] = Complex(parts[i], parts[size + i]);
    }

    /** ARPACK's work space and its reverse communication, for real and for complex numbers. */
    template <typename Number>
    class Arpack
    {
    public:
      Arpack(const ShiftInvertedPencil &pencil, const EigenvalueChoice choice,
             const unsigned int count, const std::vector<double> &start)
          : pencil(pencil), size(pencil.size / (is_complex<Number> ? 2 : 1)), count(count),
            // ARPACK requires count + 2 <= n_basis <= size. A small basis is tested for convergence
            // early.
            n_basis(std::min(size, static_cast<int>(2 * count + 6))), which(name(choice)),
            residual(size), basis(static_cast<std::size_t>(size) * n_basis), work(3 * size),
            work_small(3 * n_basis * n_basis + 8 * n_basis), work_real(n_basis)
      {
        from_real(start, residual.data());
        parameters[0] = 1;   // exact shifts
        parameters[2] = 300; // maximum number of restarts
        parameters[6] = 3;   // shift and invert
      }

      std::vector<Eigenpair> run()
      {
        int request = 0;
        do
        {
          step(request);
          apply(request);
        } while (request == -1 || request == 1 || request == 2);
        if (info != 0 || parameters[4] < static_cast<int>(count))
          throw ComputationError("the eigensolver (ARPACK) found " + std::to_string(parameters[4]) +
                                 " of " + std::to_string(count) + " eigenvalues in " +
                                 std::to_string(parameters[2]) + " restarts, code " +
                                 std::to_string(info));
        return extract();
      }

    private:
      static const char *name(const EigenvalueChoice choice)
      {
        // Eigenvalues below the shift are negative after the inversion.
        if (choice == EigenvalueChoice::nearest)
          return "LM";
        return is_complex<Number> ? "SR" : "SA";
      }

      void step(int &request)
      {
        if constexpr (is_complex<Number>)
          arpack::internal::znaupd_c(&request, "G", size, which, count, tolerance, as_c(residual),
                                     n_basis, as_c(basis), size, parameters, pointers, as_c(work),
                                     as_c(work_small), static_cast<int>(work_small.size()),
                                     work_real.data(), &info);
        else
          arpack::internal::dsaupd_c(&request, "G", size, which, count, tolerance, residual.data(),
                                     n_basis, basis.data(), size, parameters, pointers, work.data(),
                                     work_small.data(), static_cast<int>(work_small.size()), &info);
      }

      void apply(const int request)
      {
        if (request != -1 && request != 1 && request != 2)
          return;
        Number *const input  = &work[pointers[0] - 1];
        Number *const output = &work[pointers[1] - 1];
        std::vector<double> result(pencil.size);
        if (request == 1) // M times the input is already known
          result = to_real(&work[pointers[2] - 1], size);
        else
          pencil.mass(to_real(input, size), result);
        if (request != 2)
          pencil.solve(result);
        from_real(result, output);
      }

      std::vector<Eigenpair> extract()
      {
        std::vector<Number> values(count + 1),
            vectors(static_cast<std::size_t>(size) * (count + 1));
        std::vector<int> select(n_basis);
        if constexpr (is_complex<Number>)
        {
          std::vector<Number> work_vectors(2 * n_basis);
          Complex shift = pencil.shift;
          arpack::internal::zneupd_c(1, "A", select.data(), as_c(values), as_c(vectors), size,
                                     *reinterpret_cast<_Complex double *>(&shift),
                                     as_c(work_vectors), "G", size, which, count, tolerance,
                                     as_c(residual), n_basis, as_c(basis), size, parameters,
                                     pointers, as_c(work), as_c(work_small),
                                     static_cast<int>(work_small.size()), work_real.data(), &info);
        }
        else
          arpack::internal::dseupd_c(
              1, "A", select.data(), values.data(), vectors.data(), size, pencil.shift, "G", size,
              which, count, tolerance, residual.data(), n_basis, basis.data(), size, parameters,
              pointers, work.data(), work_small.data(), static_cast<int>(work_small.size()), &info);
        if (info != 0)
          throw ComputationError(
              "the eigensolver (ARPACK) could not extract its eigenvectors, code " +
              std::to_string(info));

        std::vector<Eigenpair> pairs;
        for (int i = 0; i < count; ++i)
          pairs.push_back(
              {std::real(values[i]), to_real(&vectors[static_cast<std::size_t>(i) * size], size)});
        std::sort(pairs.begin(), pairs.end(),
                  [](const auto &a, const auto &b) { return a.value < b.value; });
        return pairs;
      }

      static _Complex double *as_c(std::vector<Number> &numbers)
      {
        return reinterpret_cast<_Complex double *>(numbers.data());
      }

      const ShiftInvertedPencil &pencil;
      const int size;
      const int count;
      const int n_basis;
      const char *const which;
      std::vector<Number> residual, basis, work, work_small;
      std::vector<double> work_real;
      int parameters[11] = {};
      int pointers[14]   = {};
      int info           = 1; // the residual holds the start vector
    };

    /** M-normalises the vector, whatever ARPACK's own scaling of complex vectors is. */
    void normalise(const ShiftInvertedPencil &pencil, Eigenpair &pair)
    {
      std::vector<double> mass_times(pencil.size);
      pencil.mass(pair.vector, mass_times);
      const double squared =
          std::inner_product(pair.vector.begin(), pair.vector.end(), mass_times.begin(), 0.);
      for (double &entry : pair.vector)
        entry /= std::sqrt(squared);
    }
  } // namespace

  std::vector<Eigenpair> eigenpairs(const ShiftInvertedPencil &pencil,
                                    const EigenvalueChoice choice, const unsigned int count,
                                    const std::vector<double> &start)
  {
    Assert(start.size() == pencil.size, dealii::ExcDimensionMismatch(start.size(), pencil.size));
    if (count == 0)
      return {};
    std::vector<Eigenpair> pairs = pencil.complex
                                       ? Arpack<Complex>(pencil, choice, count, start).run()
                                       : Arpack<double>(pencil, choice, count, start).run();
    for (Eigenpair &pair : pairs)
      normalise(pencil, pair);
    return pairs;
  }
} // namespace ringmotor
