// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/quadrature_lib.h>

namespace ringmotor
{
  /** (n + 1)^dim equidistant points of the unit cell, corners included, first index fastest. */
  template <int dim>
  dealii::Quadrature<dim> lattice(const unsigned int n)
  {
    return dealii::QIterated<dim>(dealii::QTrapezoid<1>(), n);
  }
} // namespace ringmotor
