// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/algebra/rank_factors.h>
#include <ringmotor/contact/ring_compliance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The motions of all nodes due to unit forces on all nodes of a sector @p distance lower. */
    FullMatrix<double> entries_at(const RingCompliance &ring, const unsigned int distance)
    {
      std::vector<unsigned int> nodes(ring.n_nodes());
      std::iota(nodes.begin(), nodes.end(), 0u);
      FullMatrix<double> entries(3 * nodes.size(), 3 * nodes.size());
      ring.add_entries(distance, nodes, nodes, 1., 0, entries, 0, 0);
      return entries;
    }
  } // namespace

  RingCompliance::RingCompliance(const unsigned int n_sectors, const FullMatrix<double> &basis,
                                 const std::vector<std::vector<std::complex<double>>> &waves)
      : node_count(basis.m() / 3), near(n_sectors), basis(basis),
        kernel(transposed_sectors_of(waves, n_sectors, basis.n()))
  {
    AssertDimension(waves.size(), n_sectors / 2 + 1);
  }

  void RingCompliance::add_within_sectors(const FullMatrix<double> &compliance)
  {
    near[0].Tadd(1., compliance);
    Assert(table.empty(), ExcMessage("the table is made last"));
    forget_what_follows();
  }

  std::vector<std::complex<double>> RingCompliance::of_wave(const unsigned int m) const
  {
    const unsigned int width = 3 * node_count;
    FullMatrix<double> real(width, width), imaginary(width, width),
        real_kernel(basis.n(), basis.n()), imaginary_kernel(basis.n(), basis.n());
    for (unsigned int d = 0; d < n_sectors(); ++d)
    {
      const double angle =
          -2. * numbers::PI * (static_cast<std::size_t>(m) * d % n_sectors()) / n_sectors();
      const double c = std::cos(angle), s = std::sin(angle);
      if (!near[d].empty())
      {
        real.add(c, near[d]);
        imaginary.add(s, near[d]);
      }
      if (basis.n() > 0)
      {
        real_kernel.add(c, kernel[d]);
        imaginary_kernel.add(s, kernel[d]);
      }
    }
    if (basis.n() > 0)
    {
      const FullMatrix<double> by_columns = transposed(basis);
      real.add(1., product(basis, product(real_kernel, by_columns)));
      imaginary.add(1., product(basis, product(imaginary_kernel, by_columns)));
    }
    // What is stored is transposed.
    std::vector<std::complex<double>> wave;
    for (unsigned int column = 0; column < width; ++column)
      for (unsigned int row = 0; row < width; ++row)
        wave.emplace_back(real(column, row), imaginary(column, row));
    return wave;
  }

  void RingCompliance::add_motions(const double *forces, double *motions,
                                   const unsigned int n_rings) const
  {
    const int n = n_sectors(), width = 3 * node_count, n_far = basis.n();
    const double one = 1., zero = 0.;
    const std::size_t of_ring = static_cast<std::size_t>(n) * width;
    if (std::all_of(forces, forces + n_rings * of_ring,
                    [](const double force) { return force == 0.; }))
      return;
    if (applies_table())
    {
      ring_product().add(forces, motions, n_rings);
      return;
    }
    for (unsigned int ring = 0; ring < n_rings; ++ring)
      for (int d = 0; d < n; ++d)
        if (!near[d].empty())
          // Sectors 0 .. n - d - 1 move d .. n - 1, and the others 0 .. d - 1.
          for (const auto &[from, to, count] :
               {std::array<int, 3>{{0, d, n - d}}, std::array<int, 3>{{n - d, 0, d}}})
            if (count > 0)
              dgemm_("N", "N", &width, &count, &width, &one, &near[d](0, 0), &width,
                     forces + ring * of_ring + from * width, &width, &one,
                     motions + ring * of_ring + to * width, &width);
    if (n_far == 0)
      return;
    const int columns = n * n_rings;
    std::vector<double> by_far(static_cast<std::size_t>(columns) * n_far), far(by_far.size(), 0.);
    dgemm_("N", "N", &n_far, &columns, &width, &one, &basis(0, 0), &n_far, forces, &width, &zero,
           by_far.data(), &n_far);
    ring_product().add(by_far.data(), far.data(), n_rings);
    dgemm_("T", "N", &width, &columns, &n_far, &one, &basis(0, 0), &n_far, far.data(), &n_far, &one,
           motions, &width);
  }

  void add_selected(const FullMatrix<double> &all, const std::vector<unsigned int> &rows,
                    const std::vector<unsigned int> &columns, const double factor,
                    const unsigned int first, FullMatrix<double> &matrix, const unsigned int row,
                    const unsigned int column)
  {
    for (unsigned int a = 0; a < rows.size(); ++a)
      for (unsigned int c = first; c < 3; ++c)
      {
        double *const of_row         = &matrix(row + 3 * a + c, column); // contiguous
        const double *const by_force = &all(3 * rows[a] + c, 0);
        for (unsigned int b = 0; b < columns.size(); ++b)
          for (unsigned int d = 0; d < 3; ++d)
            of_row[3 * b + d] += factor * by_force[3 * columns[b] + d];
      }
  }

  void RingCompliance::add_entries(const unsigned int distance,
                                   const std::vector<unsigned int> &rows,
                                   const std::vector<unsigned int> &columns, const double factor,
                                   const unsigned int first, FullMatrix<double> &matrix,
                                   const unsigned int row, const unsigned int column) const
  {
    if (!table.empty())
    {
      add_selected(table[distance], rows, columns, factor, first, matrix, row, column);
      return;
    }
    if (const FullMatrix<double> &known = near[distance]; !known.empty())
      for (unsigned int a = 0; a < rows.size(); ++a)
        for (unsigned int c = first; c < 3; ++c)
          for (unsigned int b = 0; b < columns.size(); ++b)
            for (unsigned int d = 0; d < 3; ++d)
              matrix(row + 3 * a + c, column + 3 * b + d) +=
                  factor * known(3 * columns[b] + d, 3 * rows[a] + c);
    if (basis.n() == 0)
      return;
    const auto rows_of_basis = [&](const std::vector<unsigned int> &nodes)
    {
      FullMatrix<double> part(3 * nodes.size(), basis.n());
      for (unsigned int i = 0; i < part.m(); ++i)
        std::copy_n(&basis(3 * nodes[i / 3] + i % 3, 0), basis.n(), &part(i, 0));
      return part;
    };
    const FullMatrix<double> of_rows = rows_of_basis(rows);
    FullMatrix<double> by_columns    = product(rows_of_basis(columns), kernel[distance]);
    FullMatrix<double> entries(of_rows.m(), by_columns.m());
    of_rows.mTmult(entries, by_columns);
    for (unsigned int i = 0; i < entries.m(); ++i)
      if (i % 3 >= first)
        for (unsigned int j = 0; j < entries.n(); ++j)
          matrix(row + i, column + j) += factor * entries(i, j);
  }

  RingCompliance RingCompliance::folded(const unsigned int fold) const
  {
    RingCompliance result    = *this;
    const unsigned int n     = n_sectors() / fold;
    const auto add_to_folded = [&](std::vector<FullMatrix<double>> &matrices)
    {
      for (unsigned int distance = n; distance < matrices.size(); ++distance)
        if (matrices[distance % n].empty())
          matrices[distance % n] = matrices[distance];
        else if (!matrices[distance].empty())
          matrices[distance % n].add(1., matrices[distance]);
      matrices.resize(n);
    };
    add_to_folded(result.near);
    add_to_folded(result.kernel);
    if (!table.empty())
      add_to_folded(result.table);
    result.forget_what_follows();
    return result;
  }

  std::vector<FullMatrix<double>> RingCompliance::all_entries() const
  {
    if (has_table())
      return table;
    std::vector<FullMatrix<double>> all;
    for (unsigned int distance = 0; distance < n_sectors(); ++distance)
      all.push_back(entries_at(*this, distance));
    return all;
  }

  void RingCompliance::tabulate()
  {
    table = all_entries();
    product_by_transform.reset();
  }

  bool RingCompliance::is_small() const
  {
    constexpr std::size_t most_numbers = 1u << 24;
    return static_cast<std::size_t>(n_sectors()) * 9 * node_count * node_count <= most_numbers;
  }

  void RingCompliance::forget_what_follows()
  {
    product_by_transform.reset();
    of_far.reset();
  }

  const RingCompliance::Far &RingCompliance::far() const
  {
    if (!of_far)
    {
      of_far.emplace();
      of_far->shapes = far_shapes({this});
      of_far->kernel = between(of_far->shapes);
    }
    return *of_far;
  }

  const CirculantProduct &RingCompliance::ring_product() const
  {
    if (!product_by_transform)
      product_by_transform.emplace(applies_table() ? transposed(table) : kernel);
    return *product_by_transform;
  }

  FullMatrix<double> RingCompliance::seen_from_afar() const
  {
    const unsigned int n = n_sectors(), width = 3 * node_count;
    const std::vector<unsigned int> distances{1, n - 1, n / 4 + 1, n / 2}; // nothing is farther
    FullMatrix<double> seen(width, width * distances.size());
    for (unsigned int i = 0; i < distances.size(); ++i)
      seen.fill(entries_at(*this, distances[i] % n), 0, i * width);
    return seen;
  }

  FullMatrix<double> RingCompliance::far_shapes(const std::vector<const RingCompliance *> &rings)
  {
    constexpr double little = 1e-2;
    std::vector<FullMatrix<double>> seen;
    unsigned int n_columns = 0;
    for (const RingCompliance *ring : rings)
    {
      seen.push_back(ring->seen_from_afar());
      n_columns += seen.back().n();
    }
    FullMatrix<double> of_all(seen.front().m(), n_columns);
    for (unsigned int i = 0, first = 0; i < seen.size(); first += seen[i++].n())
      of_all.fill(seen[i], 0, first);
    return RankFactors(of_all, little).columns;
  }

  std::vector<FullMatrix<double>> RingCompliance::between(const FullMatrix<double> &shapes) const
  {
    const FullMatrix<double> of_shapes = product(basis, shapes, Transposed::yes);
    // The matrices of this ring are transposed.
    const auto of = [](const FullMatrix<double> &matrix, const FullMatrix<double> &of_both)
    { return product(product(matrix, of_both), of_both, Transposed::yes); };
    std::vector<FullMatrix<double>> motions;
    for (unsigned int d = 0; d < n_sectors(); ++d)
    {
      motions.emplace_back(shapes.n(), shapes.n());
      if (!near[d].empty())
        motions.back().add(1., of(near[d], shapes));
      if (basis.n() > 0)
        motions.back().add(1., of(kernel[d], of_shapes));
    }
    return motions;
  }
} // namespace ringmotor
