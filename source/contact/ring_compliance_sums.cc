// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/contact/ring_compliance.h>

// Rings made from waves and from other rings.

namespace ringmotor
{
  using namespace dealii;

  RingCompliance::RingCompliance(const unsigned int n_sectors, const FullMatrix<double> &basis,
                                 const std::vector<std::vector<std::complex<double>>> &waves)
      : node_count(basis.m() / 3), near(n_sectors), basis(basis),
        kernel(transposed_sectors_of(waves, n_sectors, basis.n()))
  {
    AssertDimension(waves.size(), n_sectors / 2 + 1);
    prepare();
  }

  RingCompliance RingCompliance::spread(const unsigned int n_places,
                                        const unsigned int stride) const
  {
    RingCompliance result;
    result.node_count = node_count;
    result.basis      = basis;
    result.near.resize(n_places);
    result.kernel.assign(n_places, FullMatrix<double>(basis.n(), basis.n()));
    for (unsigned int distance = 0; distance < n_sectors(); ++distance)
    {
      const unsigned int place = static_cast<std::size_t>(stride) * distance % n_places;
      result.near[place]       = near[distance];
      result.kernel[place]     = kernel[distance];
    }
    result.prepare();
    return result;
  }

  RingCompliance operator+(const RingCompliance &a, const RingCompliance &b)
  {
    AssertDimension(a.n_sectors(), b.n_sectors());
    RingCompliance sum;
    sum.node_count             = a.node_count;
    const unsigned int n_first = a.basis.n(), n_all = n_first + b.basis.n();
    sum.basis.reinit(3 * a.node_count, n_all);
    sum.basis.fill(a.basis);
    sum.basis.fill(b.basis, 0, n_first);
    for (unsigned int distance = 0; distance < a.n_sectors(); ++distance)
    {
      sum.near.push_back(a.near[distance]);
      if (sum.near.back().empty())
        sum.near.back() = b.near[distance];
      else if (!b.near[distance].empty())
        sum.near.back().add(1., b.near[distance]);
      sum.kernel.emplace_back(n_all, n_all);
      sum.kernel.back().fill(a.kernel[distance]);
      sum.kernel.back().fill(b.kernel[distance], n_first, n_first);
    }
    sum.prepare();
    return sum;
  }
} // namespace ringmotor
