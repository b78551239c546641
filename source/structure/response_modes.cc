// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/parameters/errors.h>
#include <ringmotor/structure/response_modes.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Matrix = LAPACKFullMatrix<double>;

    /** Vectors as the columns of a matrix, which stores them one after the other. */
    Matrix as_columns(const std::vector<double> &vectors, const std::size_t n_rows)
    {
      Matrix columns(n_rows, vectors.size() / n_rows);
      std::copy(vectors.begin(), vectors.end(), &columns(0, 0));
      return columns;
    }

    struct SymmetricEigenpairs
    {
      Vector<double> values;
      FullMatrix<double> vectors;

      explicit SymmetricEigenpairs(const FullMatrix<double> &matrix)
      {
        Matrix copy(matrix.m(), matrix.n());
        for (unsigned int i = 0; i < matrix.m(); ++i)
          for (unsigned int j = 0; j < matrix.n(); ++j)
            copy(i, j) = 0.5 * (matrix(i, j) + matrix(j, i));
        constexpr double all = std::numeric_limits<double>::max();
        copy.compute_eigenvalues_symmetric(-all, all, 0., values, vectors);
      }
    };

    /** Combinations of vectors with the given products that are orthonormal, without those that
     * rounding has blurred. */
    FullMatrix<double> orthonormal(const FullMatrix<double> &products)
    {
      const unsigned int n = products.m();
      FullMatrix<double> scaled(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          scaled(i, j) = products(i, j) / std::sqrt(products(i, i) * products(j, j));
      const SymmetricEigenpairs pairs(scaled);
      constexpr double rounding = 1e-13;
      unsigned int first        = 0;
      while (pairs.values[first] < rounding * pairs.values[n - 1])
        ++first;
      FullMatrix<double> combinations(n, n - first);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = first; j < n; ++j)
          combinations(i, j - first) =
              pairs.vectors(i, j) / std::sqrt(products(i, i) * pairs.values[j]);
      return combinations;
    }

    /** Combinations of vectors whose stiffness and mass are given that are orthogonal with respect
     * to both and have unit mass, with their stiffness. What rounding takes from the vectors is
     * small in strain energy, so that the compliance, which is of second order in it, is exact. */
    struct RitzWeights
    {
      std::vector<double> values; ///< ascending
      FullMatrix<double> weights; ///< of each vector, in each combination

      RitzWeights(const FullMatrix<double> &stiffness, const FullMatrix<double> &mass)
      {
        const FullMatrix<double> basis = orthonormal(stiffness);
        FullMatrix<double> times_basis(mass.m(), basis.n()), reduced(basis.n(), basis.n());
        mass.mmult(times_basis, basis);
        basis.Tmmult(reduced, times_basis);
        const SymmetricEigenpairs pairs(reduced); // of the mass for unit stiffness
        constexpr double rounding = 1e-14;
        const unsigned int n      = basis.n();
        FullMatrix<double> of_basis(n, n);
        for (unsigned int r = 0; r < n; ++r)
          if (const double square = pairs.values[n - 1 - r];
              square > rounding * pairs.values[n - 1])
          {
            for (unsigned int i = 0; i < n; ++i)
              of_basis(i, r) = pairs.vectors(i, n - 1 - r) / std::sqrt(square);
            values.push_back(1. / square);
          }
        weights.reinit(basis.m(), n);
        basis.mmult(weights, of_basis);
      }
    };

    FullMatrix<double> product_of_transposed(const Matrix &a, const Matrix &b)
    {
      FullMatrix<double> product(a.n(), b.n());
      a.Tmmult(product, b);
      return product;
    }

    struct Response
    {
      double frequency;            ///< rad/s
      std::vector<double> motions; ///< one after the other
    };

    Response response(const SymmetricMotions &body, const std::vector<double> &loads,
                      const double frequency)
    {
      Response response{frequency, loads};
      body.solve(frequency * frequency, response.motions);
      return response;
    }

    /** At a frequency, or next to it if that is a resonance. */
    Response beside_resonance(const SymmetricMotions &body, const std::vector<double> &loads,
                              const double frequency, const Response &rest)
    {
      // Next to a resonance all responses are nearly the same mode, and rounding hides how they
      // differ. Farther away that mode is found as well.
      constexpr double too_strong = 1e4, elsewhere = 1.003;
      constexpr unsigned int n_attempts = 10;
      const auto work                   = [&](const Response &response) {
        return std::abs(
                              std::inner_product(loads.begin(), loads.end(), response.motions.begin(), 0.));
      };
      double beside = frequency;
      for (unsigned int attempt = 0; attempt < n_attempts; ++attempt, beside *= elsewhere)
      {
        Response found = response(body, loads, beside);
        if (work(found) < too_strong * work(rest))
          return found;
      }
      throw ComputationError(body.name + ": the response is resonant from " +
                             std::to_string(frequency / (2. * numbers::PI)) + " to " +
                             std::to_string(beside / (2. * numbers::PI)) + " Hz");
    }
  } // namespace

  RitzVectors response_vectors(const SymmetricMotions &body,
                               const std::vector<std::vector<double>> &loads,
                               const std::vector<double> &frequencies)
  {
    std::vector<double> all_loads;
    for (const std::vector<double> &load : loads)
      all_loads.insert(all_loads.end(), load.begin(), load.end());
    std::vector<Response> responses{response(body, all_loads, 0.)};
    for (const double frequency : frequencies)
      responses.push_back(beside_resonance(body, all_loads, frequency, responses.front()));

    std::vector<double> motions, inertia, squares;
    for (const Response &response : responses)
    {
      motions.insert(motions.end(), response.motions.begin(), response.motions.end());
      squares.insert(squares.end(), loads.size(), response.frequency * response.frequency);
    }
    body.multiply_mass(motions, inertia);

    // The stiffness times a response is the load and the inertia of that response.
    const Matrix columns          = as_columns(motions, body.size);
    const FullMatrix<double> mass = product_of_transposed(columns, as_columns(inertia, body.size)),
                             work =
                                 product_of_transposed(columns, as_columns(all_loads, body.size));
    FullMatrix<double> stiffness(squares.size(), squares.size());
    for (unsigned int i = 0; i < squares.size(); ++i)
      for (unsigned int j = 0; j < squares.size(); ++j)
        stiffness(i, j) = work(i, j % loads.size()) + mass(i, j) * squares[j];

    const RitzWeights ritz(stiffness, mass);
    Matrix weights(ritz.weights.m(), ritz.weights.n()), combined(body.size, ritz.weights.n());
    weights = ritz.weights;
    columns.mmult(combined, weights);
    const double *const begin = &combined(0, 0);
    return {ritz.values, {begin, begin + body.size * ritz.values.size()}};
  }

  ResponseModes::ResponseModes(const CyclicSector &sector)
      : sector(sector), at_rest(sector), at_frequency(sector)
  {
    // Complex unknowns would need all loads a second time, times i.
    Assert(!sector.is_complex(), ExcMessage("not on a whole sector"));
  }

  std::vector<Mode> ResponseModes::at(const unsigned int k,
                                      const std::vector<std::vector<double>> &loads,
                                      const std::vector<double> &frequencies)
  {
    const std::size_t n = sector.n_unknowns();
    const RitzVectors ritz =
        response_vectors({n, "nodal diameter " + std::to_string(k),
                          [&](const double shift, std::vector<double> &motions)
                          {
                            CyclicFactors &factors = shift == 0. ? at_rest : at_frequency;
                            factors.factorise(k, shift);
                            factors.solve(motions);
                          },
                          [&](const std::vector<double> &motions, std::vector<double> &inertia)
                          { sector.multiply_mass(k, motions, inertia); }},
                         loads, frequencies);
    std::vector<Mode> modes;
    for (std::size_t r = 0; r < ritz.values.size(); ++r)
    {
      const auto begin = ritz.vectors.begin() + r * n;
      modes.push_back(
          {k, ritz.values[r], /*rigid =*/false, sector.expand(k, {begin, begin + n}), 0.});
    }
    return modes;
  }

  bool is_fast(const double eigenvalue, const double frequency)
  {
    constexpr double far = 3.;
    return eigenvalue > std::pow(far * frequency, 2);
  }

  std::vector<Mode> without_fast_vectors(std::vector<Mode> modes, const double frequency)
  {
    modes.erase(std::remove_if(modes.begin(), modes.end(),
                               [&](const Mode &mode)
                               { return is_fast(mode.eigenvalue, frequency); }),
                modes.end());
    return modes;
  }
} // namespace ringmotor
