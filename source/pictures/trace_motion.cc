// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/contact_surface.h>
#include <ringmotor/pictures/trace_motion.h>

#include <deal.II/base/polynomial.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    using Complex = std::complex<double>;

    class TraceInterpolation
    {
    public:
      explicit TraceInterpolation(SurfaceTrace trace) : trace(std::move(trace))
      {
        const unsigned int order = this->trace.order;
        for (std::size_t face = 0; face < this->trace.n_faces; ++face)
        {
          std::array<Point<2>, 4> corner;
          for (unsigned int v = 0; v < 4; ++v)
          {
            const std::size_t lattice = v / 2 * order * (order + 1) + v % 2 * order;
            const Point<3> &x         = this->trace.points[face * n_lattice() + lattice];
            corner[v]                 = Point<2>(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]));
          }
          corners.push_back(corner);
        }
        std::vector<Point<1>> support;
        for (unsigned int i = 0; i <= order; ++i)
          support.emplace_back(i / static_cast<double>(order));
        basis = Polynomials::generate_complete_Lagrange_basis(support);
      }

      std::array<Complex, 3> operator()(const Point<3> &x) const
      {
        const Point<2> place(std::hypot(x[0], x[1]), std::atan2(x[1], x[0]));
        std::size_t nearest = 0;
        Point<2> unit;
        double distance = std::numeric_limits<double>::infinity();
        for (std::size_t face = 0; face < corners.size(); ++face)
        {
          const Point<2> candidate = unit_point(corners[face], place);
          const double outside =
              std::max({-candidate[0], candidate[0] - 1., -candidate[1], candidate[1] - 1.});
          if (outside < distance)
          {
            distance = outside;
            nearest  = face;
            unit     = candidate;
          }
        }
        std::array<Complex, 3> motion{};
        for (unsigned int j = 0; j <= trace.order; ++j)
          for (unsigned int i = 0; i <= trace.order; ++i)
          {
            const double weight = basis[i].value(unit[0]) * basis[j].value(unit[1]);
            const std::array<Complex, 3> &u =
                trace.displacement[nearest * n_lattice() + j * (trace.order + 1) + i];
            for (unsigned int c = 0; c < 3; ++c)
              motion[c] += weight * u[c];
          }
        return motion;
      }

    private:
      std::size_t n_lattice() const { return (trace.order + 1) * (trace.order + 1); }

      const SurfaceTrace trace;
      std::vector<std::array<Point<2>, 4>> corners;
      std::vector<Polynomials::Polynomial<double>> basis;
    };
  } // namespace

  WaveMotion motion_of(SurfaceTrace trace)
  {
    const auto interpolation = std::make_shared<const TraceInterpolation>(std::move(trace));
    return [interpolation](const Point<3> &x) { return (*interpolation)(x); };
  }
} // namespace ringmotor
