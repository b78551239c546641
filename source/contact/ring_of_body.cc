// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/dense_product.h>
#include <ringmotor/algebra/rank_factors.h>
#include <ringmotor/contact/ring_compliance.h>

#include <cmath>

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
      const FullMatrix<double> of_far    = product(far, product(of_shapes, far), Transposed::yes);
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
} // namespace ringmotor
