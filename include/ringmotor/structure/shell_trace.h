// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/structure/sector_elements.h>

#include <deal.II/fe/fe_values.h>

#include <array>
#include <complex>
#include <vector>

namespace ringmotor
{
  /** Positions and motion across the thickness of a shell, over chosen points of its cells. */
  class ShellTrace
  {
  public:
    /** @p points of the unit cell; their weights enter area(). @p elements must outlive this
     * object. */
    ShellTrace(const SectorElements &elements, const dealii::Quadrature<2> &points);

    /** Reinitialises for a cell, where the shell moves by @p motion. */
    void reinit(const SectorElements::ShellCell &cell, const ComplexField &motion);

    unsigned int size() const { return real.size(); }

    /** The position (m) at a height (m) over point @p q of the reference surface, along its normal;
     * see ShellSection for the heights of faces and mid-surface. */
    dealii::Point<3> position(const unsigned int q, const double height) const;

    /** Cartesian complex displacement (m) there: u + height theta x n. */
    std::array<std::complex<double>, 3> displacement(const unsigned int q,
                                                     const double height) const;

    /** Weight times area element of the reference surface, m^2. */
    double area(const unsigned int q) const { return values.JxW(q); }

  private:
    dealii::FEValues<2, 3> values;
    std::vector<dealii::Vector<double>> real, imaginary; ///< six components by point
  };
} // namespace ringmotor
