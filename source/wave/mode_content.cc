// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/wave/mode_content.h>
#include <ringmotor/wave/motion_samples.h>

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

  namespace
  {
    using Complex = std::complex<double>;

    constexpr unsigned int n_motions = 6;

    /**
     * Rigid motions of the cross-section in (r, theta, z): axial shift and its tilt; radial and
     * tangential shift and the rotation about the axis; torsion. They are orthonormalised in this
     * order.
     */
    class CrossSectionMotions
    {
    public:
      explicit CrossSectionMotions(const std::vector<MotionSample> &samples);

      /** Their amplitudes, times the root of the mass, in a motion. */
      std::array<Complex, n_motions> amplitudes(const std::vector<MotionSample> &samples) const;

      /** Twice the kinetic energy at unit frequency. */
      double energy() const { return all; }

    private:
      std::array<std::array<double, 3>, n_motions> at(const MotionSample &sample) const
      {
        const double r = sample.r - center_r, z = sample.z - center_z;
        return {{{{0, 0, 1}}, {{0, z, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, r, 0}}, {{z, 0, -r}}}};
      }

      double center_r = 0., center_z = 0., all = 0.;
      FullMatrix<double> lower; ///< Cholesky factor of their products
    };

    CrossSectionMotions::CrossSectionMotions(const std::vector<MotionSample> &samples)
        : lower(n_motions, n_motions)
    {
      double mass = 0.;
      for (const MotionSample &s : samples)
      {
        mass += s.mass;
        center_r += s.mass * s.r;
        center_z += s.mass * s.z;
        all += s.mass * (std::norm(s.motion[0]) + std::norm(s.motion[1]) + std::norm(s.motion[2]));
      }
      center_r /= mass;
      center_z /= mass;
      FullMatrix<double> gram(n_motions, n_motions);
      for (const MotionSample &s : samples)
      {
        const auto motions = at(s);
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int j = 0; j < n_motions; ++j)
            for (unsigned int d = 0; d < 3; ++d)
              gram(i, j) += s.mass * motions[i][d] * motions[j][d];
      }
      lower.cholesky(gram);
    }

    std::array<Complex, n_motions>
    CrossSectionMotions::amplitudes(const std::vector<MotionSample> &samples) const
    {
      std::array<Complex, n_motions> overlap{};
      for (const MotionSample &s : samples)
      {
        const auto motions = at(s);
        for (unsigned int i = 0; i < n_motions; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            overlap[i] += s.mass * motions[i][d] * s.motion[d];
      }
      for (unsigned int i = 0; i < n_motions; ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
          overlap[i] -= lower(i, j) * overlap[j];
        overlap[i] /= lower(i, i);
      }
      return overlap;
    }

    /** @param energy of which @p amplitudes are parts */
    ModeContent content_of(const std::array<Complex, n_motions> &amplitudes, const double energy)
    {
      const auto fraction = [&](const unsigned int i) { return std::norm(amplitudes[i]) / energy; };
      ModeContent content;
      content.axial         = fraction(0) + fraction(1);
      content.in_plane      = fraction(2) + fraction(3) + fraction(4);
      content.torsion       = fraction(5);
      content.cross_section = std::max(0., 1. - content.axial - content.in_plane - content.torsion);
      return content;
    }
  } // namespace

  ModeContent mode_content(const CyclicSector &sector, const Mode &mode)
  {
    const std::vector<MotionSample> samples = motion_samples(sector, mode);
    const CrossSectionMotions motions(samples);
    ModeContent content   = content_of(motions.amplitudes(samples), motions.energy());
    content.nodal_circles = count_nodal_circles(samples);
    return content;
  }
} // namespace ringmotor
