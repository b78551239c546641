// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/wave/mode_content.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace ringmotor
{
  using namespace dealii;

  std::string to_string(const Family family)
  {
    switch (family)
    {
    case Family::out_of_plane:
      return "out-of-plane";
    case Family::in_plane:
      return "in-plane";
    case Family::torsion:
      return "torsion";
    case Family::cross_section:
      return "cross-section";
    }
    Assert(false, ExcInternalError());
    return "";
  }

  Family ModeContent::family() const
  {
    const std::array<double, 4> fractions{{axial, in_plane, torsion, cross_section}};
    return static_cast<Family>(std::max_element(fractions.begin(), fractions.end()) -
                               fractions.begin());
  }

  ModeContent content_of(const std::array<double, CrossSections::n_motions> &shares)
  {
    ModeContent content;
    content.axial         = shares[0] + shares[1];
    content.in_plane      = shares[2] + shares[3] + shares[4];
    content.torsion       = shares[5];
    content.cross_section = std::max(0., 1. - content.axial - content.in_plane - content.torsion);
    return content;
  }

  ModeContent mode_content(const CyclicSector &sector, const Mode &mode)
  {
    constexpr unsigned int n_motions        = CrossSections::n_motions;
    const std::vector<MotionSample> samples = motion_samples(sector, mode);
    const CrossSections sections(samples);
    FullMatrix<double> gram(n_motions, n_motions), lower(n_motions, n_motions);
    std::array<std::complex<double>, n_motions> overlap{};
    for (const MotionSample &s : samples)
    {
      const auto motions = sections.at(s);
      for (unsigned int i = 0; i < n_motions; ++i)
        for (unsigned int d = 0; d < 3; ++d)
        {
          overlap[i] += s.mass * motions[i][d] * s.motion[d];
          for (unsigned int j = 0; j < n_motions; ++j)
            gram(i, j) += s.mass * motions[i][d] * motions[j][d];
        }
    }
    lower.cholesky(gram); // orthonormalises them in their order
    const double energy = energy_of(samples);
    std::array<double, n_motions> shares;
    for (unsigned int i = 0; i < n_motions; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
        overlap[i] -= lower(i, j) * overlap[j];
      overlap[i] /= lower(i, i);
      shares[i] = std::norm(overlap[i]) / energy;
    }
    ModeContent content   = content_of(shares);
    content.nodal_circles = count_nodal_circles(samples);
    return content;
  }
} // namespace ringmotor
