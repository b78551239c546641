// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/surface_compliance.h>
#include <ringmotor/structure/mirror.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  SurfaceCompliance sector_compliance(const InterfaceCompliance &meshed,
                                      const std::vector<MirroredNode> &origin)
  {
    // A force F at one of two mirrored nodes is F_1 + i F_2, both parts with the symmetry
    // U(-theta) = S conj(U(theta)) of the half sector's real and imaginary fields. (On a whole
    // sector nothing is mirrored and both fields are alike.)
    const auto sign = [&](const unsigned int row, const unsigned int part)
    { return origin[row / 3].mirrored ? mirror_sign(row % 3) * (part == 0 ? 1. : -1.) : 1.; };
    const auto form = [&](const unsigned int row) { return 3 * origin[row / 3].node + row % 3; };
    const unsigned int n = 3 * origin.size();
    SurfaceCompliance body;
    body.n_real_shapes = meshed.shapes(0).n();
    body.at_rest.reinit(n, n);
    body.shapes.reinit(n, meshed.shapes(0).n() + meshed.shapes(1).n());
    for (const unsigned int part : {0u, 1u})
      for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < n; ++j)
          body.at_rest(i, j) +=
              0.5 * sign(i, part) * sign(j, part) * meshed.at_rest(part)(form(i), form(j));
        for (unsigned int shape = 0; shape < meshed.shapes(part).n(); ++shape)
          body.shapes(i, part * body.n_real_shapes + shape) =
              std::sqrt(0.5) * sign(i, part) * meshed.shapes(part)(form(i), shape);
      }
    return body;
  }

  std::vector<std::array<std::complex<double>, 3>>
  sector_motion(const std::vector<double> &half, const std::vector<MirroredNode> &origin)
  {
    std::vector<std::array<std::complex<double>, 3>> motions;
    for (const MirroredNode &node : origin)
    {
      std::array<std::complex<double>, 3> motion;
      for (unsigned int c = 0; c < 3; ++c)
        motion[c] = {half[3 * node.node + c], half[half.size() / 2 + 3 * node.node + c]};
      motions.push_back(node.mirrored ? mirrored(motion) : motion);
    }
    return motions;
  }
} // namespace ringmotor
