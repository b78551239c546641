// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <memory>
#include <vector>

namespace ringmotor
{
  /** The blocks of a block-circulant matrix, transposed, by distance 0 .. n - 1, from those of its
   * waves exp(2 pi i m j / n), m = 0 .. n / 2, each @p width by @p width entries by rows. Imaginary
   * parts that waves of real numbers cannot have are ignored. */
  std::vector<dealii::FullMatrix<double>>
  transposed_sectors_of(const std::vector<std::vector<std::complex<double>>> &waves,
                        const unsigned int n_sectors, const unsigned int width);

  /**
   * Products with a block-circulant matrix: n sectors in a ring, and a block that depends only on
   * the distance of two sectors. The discrete Fourier transform over the sectors makes it block
   * diagonal, so that a product takes a small matrix for each harmonic instead of one for each pair
   * of sectors.
   */
  class CirculantProduct
  {
  public:
    /** Empty, to be assigned to. */
    CirculantProduct() = default;

    /** @param kernel by distance 0 .. n - 1, transposed: entry (i, j) is the motion j due to a
     * force i that many sectors lower */
    explicit CirculantProduct(const std::vector<dealii::FullMatrix<double>> &kernel);

    /** Adds the product to @p motions. Forces and motions by ring, sector, component; several rings
     * with the same matrix together. */
    void add(const double *forces, double *motions, const unsigned int n_rings) const;

  private:
    class Transforms;
    /** Consecutive ones of the matrices. */
    struct Columns
    {
      int first, number;
    };

    /** Those with a force in any sector: most points of a motor never touch. */
    std::vector<Columns> loaded_columns(const double *forces, const unsigned int n_rings) const;

    int width = 0, n_sectors = 0;
    std::shared_ptr<const Transforms> transforms;
    std::vector<std::complex<double>> harmonics; ///< matrix by harmonic, column by column
  };
} // namespace ringmotor
