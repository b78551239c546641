// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/algebra/blas.h>
#include <ringmotor/algebra/circulant_product.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <fftw3.h>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    fftw_complex *of_fftw(std::complex<double> *numbers)
    {
      return reinterpret_cast<fftw_complex *>(numbers);
    }
  } // namespace

  /** A plan of FFTW for a number of transforms over the sectors, whose numbers lie side by side.
   */
  class FourierPlan
  {
  public:
    enum class Direction
    {
      to_harmonics,
      to_sectors
    };

    FourierPlan(const int n_sectors, const int n_transforms, const Direction direction)
    {
      // Only an estimate: measuring would make results depend on the load of the machine.
      constexpr unsigned int flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
      std::vector<double> real(static_cast<std::size_t>(n_sectors) * n_transforms);
      std::vector<std::complex<double>> complex(static_cast<std::size_t>(n_sectors / 2 + 1) *
                                                n_transforms);
      const int n = n_transforms;
      plan        = direction == Direction::to_harmonics
                        ? fftw_plan_many_dft_r2c(1, &n_sectors, n, real.data(), nullptr, n, 1,
                                                 of_fftw(complex.data()), nullptr, n, 1, flags)
                        : fftw_plan_many_dft_c2r(1, &n_sectors, n, of_fftw(complex.data()), nullptr, n, 1,
                                                 real.data(), nullptr, n, 1, flags);
      AssertThrow(plan != nullptr, ExcMessage("FFTW made no plan"));
    }
    ~FourierPlan() { fftw_destroy_plan(plan); }
    FourierPlan(const FourierPlan &)            = delete;
    FourierPlan &operator=(const FourierPlan &) = delete;

    fftw_plan plan;
  };
  class CirculantProduct::Transforms
  {
  public:
    Transforms(const int n_sectors, const int width)
        : forward(n_sectors, width, FourierPlan::Direction::to_harmonics),
          backward(n_sectors, width, FourierPlan::Direction::to_sectors)
    {
    }

    void to_harmonics(const double *sectors, std::complex<double> *harmonics) const
    {
      // FFTW leaves the input of such a transform as it is.
      fftw_execute_dft_r2c(forward.plan, const_cast<double *>(sectors), of_fftw(harmonics));
    }
    /** Overwrites @p harmonics. */
    void to_sectors(std::complex<double> *harmonics, double *sectors) const
    {
      fftw_execute_dft_c2r(backward.plan, of_fftw(harmonics), sectors);
    }

  private:
    const FourierPlan forward, backward;
  };

  std::vector<FullMatrix<double>>
  transposed_sectors_of(const std::vector<std::vector<std::complex<double>>> &waves,
                        const unsigned int n_sectors, const unsigned int width)
  {
    const std::size_t block = static_cast<std::size_t>(width) * width;
    std::vector<FullMatrix<double>> sectors(n_sectors, FullMatrix<double>(width, width));
    if (block == 0)
      return sectors;
    std::vector<std::complex<double>> by_wave;
    for (const std::vector<std::complex<double>> &wave : waves)
      by_wave.insert(by_wave.end(), wave.begin(), wave.end());
    std::vector<double> by_sector(n_sectors * block);
    const FourierPlan plan(n_sectors, block, FourierPlan::Direction::to_sectors);
    fftw_execute_dft_c2r(plan.plan, of_fftw(by_wave.data()), by_sector.data());
    for (unsigned int distance = 0; distance < n_sectors; ++distance)
      for (unsigned int i = 0; i < width; ++i)
        for (unsigned int j = 0; j < width; ++j)
          sectors[distance](j, i) = by_sector[distance * block + i * width + j] / n_sectors;
    return sectors;
  }

  CirculantProduct::CirculantProduct(const std::vector<FullMatrix<double>> &kernel)
      : width(kernel.empty() ? 0 : kernel.front().m()), n_sectors(kernel.size())
  {
    if (width == 0)
      return;
    transforms              = std::make_shared<const Transforms>(n_sectors, width);
    const std::size_t block = static_cast<std::size_t>(width) * width;
    std::vector<double> entries;
    for (const FullMatrix<double> &matrix : kernel)
      for (unsigned int i = 0; i < matrix.m(); ++i)
        entries.insert(entries.end(), matrix.begin(i), matrix.end(i));
    harmonics.resize((n_sectors / 2 + 1) * block);
    const FourierPlan plan(n_sectors, block, FourierPlan::Direction::to_harmonics);
    fftw_execute_dft_r2c(plan.plan, entries.data(), of_fftw(harmonics.data()));
    for (std::complex<double> &entry : harmonics) // a transform and its inverse multiply by n
      entry /= n_sectors;
  }

  std::vector<CirculantProduct::Columns>
  CirculantProduct::loaded_columns(const double *forces, const unsigned int n_rings) const
  {
    std::vector<bool> is_loaded(width, false);
    for (std::size_t sector = 0; sector < static_cast<std::size_t>(n_sectors) * n_rings; ++sector)
      for (int i = 0; i < width; ++i)
        if (forces[sector * width + i] != 0.)
          is_loaded[i] = true;
    std::vector<Columns> columns;
    for (int i = 0; i < width; ++i)
      if (is_loaded[i])
      {
        if (i == 0 || !is_loaded[i - 1])
          columns.push_back({i, 0});
        ++columns.back().number;
      }
    return columns;
  }

  void CirculantProduct::add(const double *forces, double *motions,
                             const unsigned int n_rings) const
  {
    if (width == 0)
      return;
    const int n_harmonics = n_sectors / 2 + 1, of_ring = n_harmonics * width, stride = 1;
    const std::complex<double> one(1.);
    const std::vector<Columns> loaded = loaded_columns(forces, n_rings);
    std::vector<std::complex<double>> by_harmonic(static_cast<std::size_t>(of_ring) * n_rings),
        moved(by_harmonic.size());
    const std::size_t ring = static_cast<std::size_t>(n_sectors) * width;
    for (unsigned int r = 0; r < n_rings; ++r)
      transforms->to_harmonics(forces + r * ring, &by_harmonic[r * of_ring]);
    for (int k = 0; k < n_harmonics; ++k)
    {
      const std::complex<double> *matrix = &harmonics[static_cast<std::size_t>(k) * width * width];
      // zgemm would copy the matrix, which pays off with many columns only.
      for (unsigned int r = 0; r < n_rings; ++r)
        for (const auto &[first, n_columns] : loaded)
          zgemv_("N", &width, &n_columns, &one, matrix + first * width, &width,
                 &by_harmonic[r * of_ring + k * width + first], &stride, &one,
                 &moved[r * of_ring + k * width], &stride);
    }
    std::vector<double> of_sectors(ring);
    for (unsigned int r = 0; r < n_rings; ++r)
    {
      transforms->to_sectors(&moved[r * of_ring], of_sectors.data());
      std::transform(of_sectors.begin(), of_sectors.end(), motions + r * ring, motions + r * ring,
                     std::plus<>());
    }
  }
} // namespace ringmotor
