// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/structure/shell_trace.h>

namespace ringmotor
{
  using namespace dealii;

  ShellTrace::ShellTrace(const SectorElements &elements, const Quadrature<2> &points)
      : values(elements.shell_geometry(), elements.shell_dofs().get_fe(), points,
               update_values | update_quadrature_points | update_normal_vectors |
                   update_JxW_values),
        real(points.size(), Vector<double>(6)), imaginary(real)
  {
  }

  void ShellTrace::reinit(const SectorElements::ShellCell &cell, const ComplexField &motion)
  {
    values.reinit(cell);
    values.get_function_values(motion.real, real);
    values.get_function_values(motion.imaginary, imaginary);
  }

  Point<3> ShellTrace::position(const unsigned int q, const double height) const
  {
    return values.quadrature_point(q) + height * values.normal_vector(q);
  }

  std::array<std::complex<double>, 3> ShellTrace::displacement(const unsigned int q,
                                                               const double height) const
  {
    const Tensor<1, 3> normal = values.normal_vector(q);
    std::array<std::complex<double>, 3> displacement;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const unsigned int e = (d + 1) % 3, f = (d + 2) % 3; // theta x n
      const auto part = [&](const Vector<double> &u)
      { return u[d] + height * (u[3 + e] * normal[f] - u[3 + f] * normal[e]); };
      displacement[d] = {part(real[q]), part(imaginary[q])};
    }
    return displacement;
  }
} // namespace ringmotor
