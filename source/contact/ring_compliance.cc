// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
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
    /** The weights of the surface's motions in those of the contact points, from the lower sector,
     * the same one, and the higher one. */
    class Shares
    {
    public:
      explicit Shares(const MortarCoupling &coupling) : coupling(coupling) {}

      bool has(const int sector) const
      {
        for (const MortarCoupling::Node &node : coupling.nodes)
          for (const MortarCoupling::Weight &weight : node.weights)
            if (weight.sector == sector)
              return true;
        return false;
      }

      /** Rows of contact points from rows of the surface's nodes. */
      FullMatrix<double> of(const int sector, const FullMatrix<double> &surface) const
      {
        FullMatrix<double> result(3 * coupling.nodes.size(), surface.n());
        for (unsigned int a = 0; a < coupling.nodes.size(); ++a)
          for (const MortarCoupling::Weight &weight : coupling.nodes[a].weights)
            if (weight.sector == sector)
              for (unsigned int c = 0; c < 3; ++c)
                for (unsigned int j = 0; j < surface.n(); ++j)
                  result(3 * a + c, j) += weight.weight * surface(3 * weight.rotor_node + c, j);
        return result;
      }

    private:
      const MortarCoupling &coupling;
    };

    FullMatrix<double> transposed(const FullMatrix<double> &matrix)
    {
      FullMatrix<double> result(matrix.n(), matrix.m());
      result.copy_transposed(matrix);
      return result;
    }

    /** a b, or a^T b; zero if the inner dimension is zero. */
    FullMatrix<double> product(const FullMatrix<double> &a, const FullMatrix<double> &b,
                               const bool transposed_a = false)
    {
      FullMatrix<double> result(transposed_a ? a.n() : a.m(), b.n());
      if (!a.empty() && !b.empty())
        transposed_a ? a.Tmmult(result, b) : a.mmult(result, b);
      return result;
    }

    /** The motions of all nodes due to unit forces on all nodes of a sector @p distance lower. */
    FullMatrix<double> entries_at(const RingCompliance &ring, const unsigned int distance)
    {
      std::vector<unsigned int> nodes(ring.n_nodes());
      std::iota(nodes.begin(), nodes.end(), 0u);
      FullMatrix<double> entries(3 * nodes.size(), 3 * nodes.size());
      ring.add_entries(distance, nodes, nodes, 1., 0, entries, 0, 0);
      return entries;
    }

    /** The compliance between the shapes of a ring's sectors. */
    class ShapesOfRing
    {
    public:
      ShapesOfRing(const unsigned int n_sectors, const SurfaceCompliance &body,
                   const std::function<FullMatrix<double>(unsigned int)> &through_cut)
          : n_sectors(n_sectors), n(body.shapes.n()), n_real(body.n_real_shapes)
      {
        for (unsigned int k = 0; n > 0 && 2 * k <= n_sectors; ++k)
          waves.push_back(through_cut(k));
      }

      /** A force's own sector and its neighbours. */
      bool is_near(const unsigned int distance) const
      {
        return distance <= 1 || distance + 1 == n_sectors;
      }

      /** Due to forces @p distance sectors away. */
      FullMatrix<double> at(const unsigned int distance) const
      {
        FullMatrix<double> kernel(n, n);
        for (unsigned int k = 0; k < waves.size(); ++k)
        {
          // Waves k and N - k are conjugate to each other.
          const double weight = (k == 0 || 2 * k == n_sectors ? 1. : 2.) / n_sectors;
          const double angle  = 2. * numbers::PI / n_sectors * (k * distance % n_sectors);
          const double c = weight * std::cos(angle), s = weight * std::sin(angle);
          for (unsigned int i = 0; i < n; ++i)
          {
            const double by_real = i < n_real ? c : s, by_imaginary = i < n_real ? -s : c;
            for (unsigned int j = 0; j < n_real; ++j)
              kernel(i, j) += by_real * waves[k](i, j);
            for (unsigned int j = n_real; j < n; ++j)
              kernel(i, j) += by_imaginary * waves[k](i, j);
          }
        }
        return kernel;
      }

      /** The combinations of shapes, by columns, through which sectors that are not near are
       * coupled. The nearest of them are coupled most. */
      FullMatrix<double> far_reaching() const
      {
        constexpr double rounding = 1e-14;
        std::vector<unsigned int> distances;
        for (const unsigned int d : {2u, 3u, 5u, n_sectors / 4, n_sectors / 2})
          for (const unsigned int distance : {d, n_sectors - d})
            if (d < n_sectors && !is_near(distance))
              distances.push_back(distance);
        FullMatrix<double> seen(n, n * distances.size());
        for (unsigned int i = 0; i < distances.size() && n > 0; ++i)
          seen.fill(at(distances[i]), 0, i * n);
        return RankFactors(seen, rounding).columns;
      }

    private:
      const unsigned int n_sectors, n, n_real;
      std::vector<FullMatrix<double>> waves;
    };
  } // namespace

  RingCompliance::RingCompliance(const unsigned int n_sectors, const SurfaceCompliance &body,
                                 const MortarCoupling &coupling,
                                 const std::function<FullMatrix<double>(unsigned int)> &through_cut)
      : node_count(coupling.nodes.size()), near(n_sectors)
  {
    const Shares shares(coupling);
    std::vector<int> seen; // sectors to whose surface the contact points of one sector are coupled
    for (const int sector : {-1, 0, 1})
      if (shares.has(sector))
        seen.push_back(sector);
    const ShapesOfRing shapes(n_sectors, body, through_cut);
    const FullMatrix<double> far = shapes.far_reaching();
    const unsigned int n_far     = far.n();
    basis.reinit(3 * node_count, seen.size() * n_far);
    kernel.assign(n_sectors, FullMatrix<double>(basis.n(), basis.n()));
    for (unsigned int a = 0; a < seen.size() && n_far > 0; ++a)
      basis.fill(product(shares.of(seen[a], body.shapes), far), 0, a * n_far);

    // A point of sector d, coupled to sector d + a, is moved by one of sector 0, coupled to b.
    const bool has_shapes = body.shapes.n() > 0;
    for (unsigned int distance = 0; distance < (has_shapes ? n_sectors : 1); ++distance)
    {
      const FullMatrix<double> of_shapes = shapes.at(distance);
      const FullMatrix<double> of_far    = product(far, product(of_shapes, far), true);
      for (unsigned int a = 0; a < seen.size(); ++a)
        for (unsigned int b = 0; b < seen.size(); ++b)
        {
          const unsigned int d = (distance + n_sectors - seen[a] + seen[b]) % n_sectors;
          if (!shapes.is_near(distance))
          {
            if (n_far > 0)
              kernel[d].fill(transposed(of_far), b * n_far, a * n_far);
            continue;
          }
          FullMatrix<double> by_surface(body.at_rest.m(), 3 * node_count);
          if (has_shapes)
            by_surface = product(body.shapes,
                                 transposed(product(shares.of(seen[a], body.shapes), of_shapes)));
          if (distance == 0)
            by_surface.add(1., transposed(shares.of(seen[a], body.at_rest)));
          if (near[d].empty())
            near[d].reinit(3 * node_count, 3 * node_count);
          near[d].add(1., shares.of(seen[b], by_surface));
        }
    }
  }

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
      product_by_transform.emplace(applies_table() ? transposed_of(table) : kernel);
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
    const FullMatrix<double> of_shapes = product(basis, shapes, true);
    // The matrices of this ring are transposed.
    const auto of = [](const FullMatrix<double> &matrix, const FullMatrix<double> &of_both)
    { return product(product(matrix, of_both), of_both, true); };
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
