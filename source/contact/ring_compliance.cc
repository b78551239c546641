// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/ring_compliance.h>

#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    /** The sign with which a component of a point vector is mirrored: -theta turns round. */
    double mirror_sign(const unsigned int component)
    {
      return component == 1 ? -1. : 1.;
    }
  } // namespace

  ComplexMatrix sector_compliance(const FullMatrix<double> &condensed,
                                  const std::vector<MirroredNode> &origin, const SectorForm form)
  {
    const unsigned int n_forms = condensed.m() / 2;
    ComplexMatrix compliance(3 * origin.size());
    for (unsigned int a = 0; a < origin.size(); ++a)
      for (unsigned int b = 0; b < origin.size(); ++b)
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int i = 3 * origin[a].node + c, j = 3 * origin[b].node + d;
            const double real = condensed(i, j), imaginary = condensed(n_forms + i, j);
            if (form == SectorForm::whole)
            {
              compliance(3 * a + c, 3 * b + d) = {real, imaginary};
              continue;
            }
            // A force F at one of two mirrored nodes is F_1 + i F_2, both parts with the symmetry
            // U(-theta) = S conj(U(theta)) of the half sector's real and imaginary fields.
            const double other     = condensed(n_forms + i, n_forms + j);
            const double crosswise = condensed(i, n_forms + j);
            const bool same_side   = origin[a].mirrored == origin[b].mirrored;
            const double sign      = (origin[a].mirrored ? mirror_sign(c) : 1.) *
                                (origin[b].mirrored ? mirror_sign(d) : 1.);
            const double phase_sign = origin[b].mirrored ? -1. : 1.;
            compliance(3 * a + c, 3 * b + d) =
                same_side
                    ? sign * std::complex<double>(0.5 * (real + other),
                                                  phase_sign * 0.5 * (imaginary - crosswise))
                    : sign * std::complex<double>(0.5 * (real - other),
                                                  -phase_sign * 0.5 * (imaginary + crosswise));
          }
    return compliance;
  }

  std::vector<std::array<std::complex<double>, 3>>
  sector_motion(const std::vector<double> &half, const std::vector<MirroredNode> &origin)
  {
    std::vector<std::array<std::complex<double>, 3>> motions;
    for (const MirroredNode &node : origin)
    {
      std::array<std::complex<double>, 3> motion;
      for (unsigned int c = 0; c < 3; ++c)
      {
        const std::complex<double> u(half[3 * node.node + c],
                                     half[half.size() / 2 + 3 * node.node + c]);
        motion[c] = node.mirrored ? mirror_sign(c) * std::conj(u) : u;
      }
      motions.push_back(motion);
    }
    return motions;
  }

  ComplexMatrix coupled_compliance(const ComplexMatrix &rotor, const MortarCoupling &coupling,
                                   const unsigned int k, const double pitch)
  {
    const unsigned int n = coupling.nodes.size(), width = rotor.size;
    const auto phase = [&](const int sector)
    { return std::polar(1., -static_cast<double>(k) * sector * pitch); };
    // rotor * P^H, then P times that
    std::vector<std::complex<double>> half(static_cast<std::size_t>(width) * 3 * n, 0.);
    for (unsigned int b = 0; b < n; ++b)
      for (const MortarCoupling::Weight &weight : coupling.nodes[b].weights)
      {
        const std::complex<double> factor = weight.weight * std::conj(phase(weight.sector));
        for (unsigned int i = 0; i < width; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            half[(static_cast<std::size_t>(i) * n + b) * 3 + d] +=
                rotor(i, 3 * weight.rotor_node + d) * factor;
      }
    ComplexMatrix compliance(3 * n);
    for (unsigned int a = 0; a < n; ++a)
      for (const MortarCoupling::Weight &weight : coupling.nodes[a].weights)
      {
        const std::complex<double> factor = weight.weight * phase(weight.sector);
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int j = 0; j < 3 * n; ++j)
            compliance(3 * a + c, j) +=
                factor * half[static_cast<std::size_t>(3 * weight.rotor_node + c) * 3 * n + j];
      }
    return compliance;
  }

  RingCompliance::RingCompliance(const unsigned int n_sectors, const unsigned int n_nodes,
                                 const std::function<ComplexMatrix(unsigned int)> &of_wave)
      : sector_count(n_sectors), node_count(n_nodes),
        entries(static_cast<std::size_t>(n_sectors) * 9 * n_nodes * n_nodes, 0.)
  {
    const double pitch     = 2. * numbers::PI / n_sectors;
    const std::size_t size = static_cast<std::size_t>(9) * n_nodes * n_nodes;
    for (unsigned int k = 0; 2 * k <= n_sectors; ++k)
    {
      const ComplexMatrix wave = of_wave(k);
      // Waves k and N - k are conjugate to each other.
      const double weight = (k == 0 || 2 * k == n_sectors ? 1. : 2.) / n_sectors;
      for (unsigned int distance = 0; distance < n_sectors; ++distance)
      {
        const std::complex<double> factor =
            weight * std::polar(1., -pitch * static_cast<double>(k * distance % n_sectors));
        // Hermitian: its columns are its conjugate rows.
        double *block = entries.data() + distance * size;
        for (std::size_t entry = 0; entry < size; ++entry)
          block[entry] += factor.real() * wave.entries[entry].real() +
                          factor.imag() * wave.entries[entry].imag();
      }
    }
  }

  void RingCompliance::add_within_sectors(const FullMatrix<double> &compliance)
  {
    const unsigned int width = 3 * node_count;
    for (unsigned int i = 0; i < width; ++i)
      for (unsigned int j = 0; j < width; ++j)
        entries[static_cast<std::size_t>(j) * width + i] += compliance(i, j);
  }

  RingCompliance RingCompliance::folded(const unsigned int fold) const
  {
    RingCompliance result;
    result.sector_count    = sector_count / fold;
    result.node_count      = node_count;
    const std::size_t size = static_cast<std::size_t>(9) * node_count * node_count;
    result.entries.assign(result.sector_count * size, 0.);
    for (unsigned int distance = 0; distance < sector_count; ++distance)
      for (std::size_t entry = 0; entry < size; ++entry)
        result.entries[distance % result.sector_count * size + entry] +=
            entries[distance * size + entry];
    return result;
  }
} // namespace ringmotor
